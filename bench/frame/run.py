"""Two and twenty storeys on dry friction through El Centro: CPU time and error of Dolmen and of OpenSees, in turn, in one run.

Run by scripts/bench --frame. See README.md beside this file.
"""

import argparse
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
G_RATIO = "1.0003416049313476"  # 9.81 / 9.80665: the peer's g
DOLMEN = [ROOT / "target" / "release" / "dolmen", "simulate", "bench/frame", "--motion", "el-centro-1940-ns"]
DOLMEN += ["--scale", G_RATIO, "--duration", "40", "--quiet"]
BOUND_MS = 8.0  # wanted of Dolmen's whole process
WANTED = 20.0  # peer / Dolmen, wanted
# Roof of the two storeys, mm, by an independent integration that is exact between its events.
EXACT = {"peak_mm": (131.8980, 5e-5), "residual_mm": (-1.12483637, 5e-8)}
PEERS = {
    # name: settings of peer.py. All of these are timed in every round.
    "5 ms, 100": ["two_storeys", "--ratio", "100", "--algorithm", "Newton"],
    "5 ms, 1000": ["two_storeys", "--ratio", "1000"],
}
TOWERS = {
    "twenty_storeys": ["twenty_storeys", "--ratio", "1000"],
    "twenty_damped": ["twenty_damped", "--ratio", "100"],
}
FINER = {
    # Once: what the peer says on the way to the exact answer, and where it stops.
    "5 ms, 1000, Newton": ["--ratio", "1000", "--algorithm", "Newton"],
    "5 ms, 1e4": ["--ratio", "1e4"],
    "5 ms, 1e5": ["--ratio", "1e5"],
    "2.5 ms, 1000": ["--ratio", "1000", "--step", "0.0025"],
    "1 ms, 1000": ["--ratio", "1000", "--step", "0.001"],
    "1 ms, 1e4": ["--ratio", "1e4", "--step", "0.001"],
    "1 ms, 1e5": ["--ratio", "1e5", "--step", "0.001"],
    ".2 ms, 1e5": ["--ratio", "1e5", "--step", "0.0002"],
    ".1 ms, 1e5": ["--ratio", "1e5", "--step", "0.0001"],
    ".1 ms, 1e6": ["--ratio", "1e6", "--step", "0.0001"],
    "5 ms, CoulombDamper .01": ["--material", "CoulombDamper", "--ratio", ".01", "--algorithm", "Newton"],
    ".5 ms, CoulombDamper .01": ["--material", "CoulombDamper", "--ratio", ".01", "--algorithm", "Newton", "--step", "0.0005"],
    ".5 ms, CoulombDamper 1": ["--material", "CoulombDamper", "--ratio", "1", "--algorithm", "Newton", "--step", "0.0005"],
}


def measured(command):
    """What a program prints, and the CPU time of its whole process, s."""
    with tempfile.TemporaryFile() as out:
        process = subprocess.Popen(
            command, cwd=ROOT, stdout=out, stderr=subprocess.DEVNULL, env={**os.environ, **ONE_THREAD}
        )
        _, status, used = os.wait4(process.pid, 0)
        if status:
            sys.exit(f"{' '.join(map(str, command))} ended with status {os.waitstatus_to_exitcode(status)}")
        out.seek(0)
        return out.read().decode(), used.ru_utime + used.ru_stime


def figures(text):
    """Rows {case: figures} of lines NAME key=value ..."""
    rows = {}
    for line in text.splitlines():
        name, *words = line.split()
        rows[name] = {key: float(value) for key, _, value in (word.partition("=") for word in words)}
    return rows


def exact_or_stop():
    """Dolmen's own roof, held against the independent answer: a fast wrong number is no result."""
    text, _ = measured([*DOLMEN, "--json"])
    roof = json.loads(text)["simulations"][0]["storeys"][-1]
    ours = {"peak_mm": 1e3 * abs(roof["peak_displacement_m"]), "residual_mm": 1e3 * roof["residual_displacement_m"]}
    for key, (value, within) in EXACT.items():
        if not abs(ours[key] - value) <= within:
            sys.exit(f"Dolmen's {key} is {ours[key]:.8f}, not {value}: nothing is timed")
    return ours


def spread(values):
    return f"{min(values):9.2f}{statistics.median(values):9.2f}"


def ratio(theirs, ours):
    """Median over the rounds of peer / Dolmen of the same round; of the least of all rounds."""
    return f"{statistics.median(t / o for t, o in zip(theirs, ours)):9.1f}{min(theirs) / min(ours):9.1f}"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--peer", default=str(HERE / ".venv" / "bin" / "python"), help="python that has openseespy")
    parser.add_argument("--repeat", type=int, default=7, help="rounds")
    parser.add_argument("--no-finer", action="store_true", help="without the peer's way to the exact answer (half a minute)")
    options = parser.parse_args()
    peer = [options.peer, HERE / "peer.py"]
    exact = exact_or_stop()
    loops, wholes, said = {}, {}, {}

    def add(name, loop_s, whole_s=None):
        loops.setdefault(name, []).append(1e3 * loop_s)
        if whole_s is not None:
            wholes.setdefault(name, []).append(1e3 * whole_s)

    for _ in range(options.repeat):
        wholes.setdefault("Dolmen", []).append(1e3 * statistics.median(measured(DOLMEN)[1] for _ in range(5)))
        for name, settings in PEERS.items():
            text, whole = measured([*peer, *settings])
            row = said[name] = figures(text)["two_storeys"]
            wholes.setdefault(f"{name}, less imports", []).append(1e3 * (whole - row["import_cpu_s"]))
            row = figures(measured([*peer, *settings, "--loops", "5"])[0])["two_storeys"]
            add(name, row["loop_cpu_s"], whole)
        for name, row in figures(measured([ROOT / "target" / "release" / "examples" / "frame_bench"])[0]).items():
            add(f"Dolmen, {name}", row["loop_cpu_s"])
            said[f"Dolmen, {name}"] = row
        for name, settings in TOWERS.items():
            said[name] = figures(measured([*peer, *settings])[0])[name]
            add(name, said[name]["loop_cpu_s"])

    print(f"{'whole process, CPU, ms':36}{'least':>9}{'median':>9}   {'x: median, of the least':>18}")
    for name, times in wholes.items():
        print(f"{name:36}{spread(times)}", "" if name == "Dolmen" else ratio(times, wholes["Dolmen"]))
    print(f"{'analysis loop alone, CPU, ms':36}{'least':>9}{'median':>9}   {'x: median, of the least':>18}")
    for name, times in loops.items():
        ours = loops.get(f"Dolmen, {name}", loops["Dolmen, two_storeys"])
        print(f"{name:36}{spread(times)}", "" if name.startswith("Dolmen") else ratio(times, ours))

    print(f"\n{'roof, mm':36}{'peak':>12}{'error':>10}{'residual':>12}{'error':>10}{'swing':>10}{'creep':>10}{'until, s':>10}{'loop, s':>9}{'x':>7}")
    if not options.no_finer:
        for name, settings in FINER.items():
            said[name] = figures(measured([*peer, "two_storeys", *settings])[0])["two_storeys"]
    for name, row in said.items():
        of = said.get(f"Dolmen, {name}", exact)
        shown = "".join(f"{row[k]:12.4f}{row[k] - of[k]:10.4f}" for k in ("peak_mm", "residual_mm"))
        if not name.startswith("Dolmen"):
            ours = statistics.median(loops.get(f"Dolmen, {name}", loops["Dolmen, two_storeys"]))
            shown += f"{row['swing_mm']:10.1e}{row['creep_mm']:10.1e}{row['until_s']:10.2f}{row['loop_cpu_s']:9.3f}"
            shown += f"{1e3 * row['loop_cpu_s'] / ours:7.0f}"
        elif "twenty" in name:
            shown = f"{row['peak_mm']:12.4f}{'':10}{row['residual_mm']:12.4f}"
        print(f"{name:36}{shown}")

    short = [f"Dolmen's whole process takes {min(wholes['Dolmen']):.2f} ms, more than {BOUND_MS:.0f}"]
    short = short if min(wholes["Dolmen"]) > BOUND_MS else []
    for what, times, ours in (("process", wholes, "Dolmen"), ("loop", loops, "Dolmen, two_storeys")):
        for name in PEERS:  # with their imports: the whole of it
            found = statistics.median(t / o for t, o in zip(times[name], times[ours]))
            if found < WANTED:
                short.append(f"{what}: {found:.1f} x of \"{name}\", less than {WANTED:.0f}")
    print("\nFALLS SHORT: " + "; ".join(short) if short else "\nall that was wanted is met")


if __name__ == "__main__":
    main()
