"""Semicircular arches of 9 to 27 voussoirs: the verdicts of Dolmen and of compas_cra, and the CPU time of both, in one run.

Run by scripts/bench --arches. See README.md beside this file.
"""

import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
ONE_THREAD = {f"{name}_NUM_THREADS": "1" for name in ("OMP", "OPENBLAS", "MKL", "RAYON")}
# least t/R, from a linear programme of the tests (docs/arches.md)
LEAST = {9: 0.101525, 10: 0.107011, 13: 0.102527, 16: 0.107076, 17: 0.105463, 21: 0.106695, 24: 0.107096, 27: 0.106721}
# times the least t/R, and friction; the last slides
CASES = [(0.9, 0.7), (0.97, 0.7), (1.03, 0.7), (1.1, 0.7), (1.5, 0.7), (1.5, 0.25)]
PROJECT = """schema = 1
kind = "stack"
name = "arch"
density = 2400
evidence = "assumed"
joint = {{ friction = {friction}, normal_stiffness = "1e11 Pa/m", shear_stiffness = "4e10 Pa/m", damping_ratio = 0.3 }}
arch = {{ span = {span}, thickness = {thickness}, depth = 0.5, voussoirs = {voussoirs} }}
"""


def measured(command):
    """What a program prints, and the CPU time of its whole process, s."""
    with tempfile.TemporaryFile() as out:
        process = subprocess.Popen(command, cwd=ROOT, stdout=out, stderr=subprocess.DEVNULL, env={**os.environ, **ONE_THREAD})
        _, status, used = os.wait4(process.pid, 0)
        if os.waitstatus_to_exitcode(status) not in (0, 1):
            sys.exit(f"{' '.join(map(str, command))} ended with status {os.waitstatus_to_exitcode(status)}")
        out.seek(0)
        return out.read().decode(), used.ru_utime + used.ru_stime


def main():
    dolmen = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "target/release/dolmen")
    same = undecided = unknown = 0
    apart, whole, alone = [], [], []
    print("voussoirs   t/R      friction   Dolmen               compas_cra            CPU, ms: Dolmen   joints   solver   whole process")
    with tempfile.TemporaryDirectory() as folder:
        project = pathlib.Path(folder, "project.toml")
        for voussoirs, least in LEAST.items():
            for times, friction in CASES:
                thickness = times * least
                project.write_text(PROJECT.format(friction=friction, span=2 - thickness, thickness=thickness, voussoirs=voussoirs))
                text, own = measured([dolmen, "check", folder, "--json"])
                word = json.loads(text)["judgement"]["versions"][0]["weight"]["word"]
                text, process = measured([sys.executable, HERE / "peer.py", str(voussoirs), str(thickness), str(friction)])
                joints, verdict, finding, solving = text.split("\t")
                if int(joints) != voussoirs + 1:
                    sys.exit(f"compas_cra found {joints} joints of {voussoirs + 1}")
                finding, solving = float(finding), float(solving)
                if verdict.startswith("undecided"):
                    undecided += 1
                elif word == "unknown":
                    unknown += 1
                elif (verdict == "falls") == (word == "unstable"):
                    same += 1
                else:
                    apart.append((voussoirs, times, friction, word, verdict))
                whole.append(process / own)
                alone.append(solving / own)
                ms = [1e3 * time for time in (own, finding, solving, process)]
                print(f"{voussoirs:9d}{thickness:9.5f}{friction:9.2f}      {word:20s} {verdict[:20]:20s}{ms[0]:18.1f}{ms[1]:9.0f}{ms[2]:9.0f}{ms[3]:12.0f}", flush=True)
    print(f"\nthe same verdict in {same}, another in {len(apart)}, undecided by compas_cra {undecided}, by Dolmen {unknown}")
    for case in apart:
        print("differ:", *case)
    print(f"CPU time over that of Dolmen's whole process, median (least): solver alone {statistics.median(alone):.0f} ({min(alone):.1f}), "
          f"whole process {statistics.median(whole):.0f} ({min(whole):.0f})")


main()
