"""Twenty storeys that twist, with a tuned mass, through El Centro: CPU time of Dolmen and of OpenSees, in turn, in one run.

Run by scripts/bench --building. See README.md beside this file.
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
DOLMEN = [ROOT / "target/release/dolmen", "--json", "simulate", "bench/building", "--motion", "el-centro-1940-ns", "--turn", "90"]
DOLMEN += ["--step", "0.005", "--duration", "40"]
LOOP = [ROOT / "target/release/examples/building_bench"]
PEER = [sys.executable, HERE / "peer.py"]
ROUNDS = 7
BOUND_MS = 12.0  # wanted of Dolmen's whole process
WANTED = 20.0  # peer / Dolmen, wanted
APART = 2e-3  # of each peak: Newmark's average acceleration at 5 ms against the exact solution


def measured(command):
    """What a program prints, and the CPU time of its whole process, s."""
    with tempfile.TemporaryFile() as out:
        process = subprocess.Popen(command, cwd=ROOT, stdout=out, stderr=subprocess.DEVNULL, env={**os.environ, **ONE_THREAD})
        _, status, used = os.wait4(process.pid, 0)
        if status:
            sys.exit(f"{' '.join(map(str, command))} ended with status {os.waitstatus_to_exitcode(status)}")
        out.seek(0)
        return out.read().decode(), used.ru_utime + used.ru_stime


def figures(text, name):
    line = next(line for line in text.splitlines() if line.startswith(name))
    return {key: float(value.split("Process")[0]) for key, _, value in (word.partition("=") for word in line.split()[1:]) if value}


def ours(text):
    peaks = json.loads(text)["peaks"]
    top = peaks["floors"][-1]
    value = lambda peak: 1e3 * abs(peak["value"])
    return {
        "x_mm": value(top["displacement_x_m"]),
        "y_mm": value(top["displacement_y_m"]),
        "turn_mrad": value(top["rotation_rad"]),
        "stroke_mm": value(peaks["strokes_m"][0]),
    }


def main():
    mine = ours(measured(DOLMEN)[0])
    theirs = figures(measured(PEER)[0], "peer")
    finer = figures(measured([*PEER, "--step", "0.0005"])[0], "peer")
    print("peak              Dolmen, exact   OpenSees, 5 ms   OpenSees, .5 ms")
    for key, value in mine.items():
        print(f"{key:12s}{value:18.5f}{theirs[key]:17.5f}{finer[key]:18.5f}")
        if abs(theirs[key] / value - 1) > 10 * APART or abs(finer[key] / value - 1) > APART:
            sys.exit(f"{key} differs: nothing is timed")
    rows = {"whole process": ([], []), "loop alone": ([], [])}
    for _ in range(ROUNDS):
        text, spent = measured(PEER)
        rows["whole process"][1].append(1e3 * spent)
        rows["loop alone"][1].append(1e3 * figures(text, "peer")["loop_s"])
        runs = [measured(DOLMEN)[1] for _ in range(10)]
        rows["whole process"][0].append(1e3 * statistics.mean(runs))
        rows["loop alone"][0].append(1e3 * figures(measured(LOOP)[0], "dolmen")["loop_s"])
    print(f"\nCPU time, ms, least and median of {ROUNDS} rounds   Dolmen             OpenSees              ratio")
    for name, (own, other) in rows.items():
        each = statistics.median(b / a for a, b in zip(own, other))
        print(f"{name:40s}{min(own):9.2f}{statistics.median(own):9.2f}{min(other):10.0f}{statistics.median(other):9.0f}{each:14.0f}")
    least = min(rows["whole process"][0])
    ratios = [statistics.median(b / a for a, b in zip(own, other)) for own, other in rows.values()]
    print(f"wanted: at most {BOUND_MS} ms, {'met' if least <= BOUND_MS else 'MISSED'}; {WANTED:.0f} times, {'met' if min(ratios) >= WANTED else 'MISSED'}")


main()
