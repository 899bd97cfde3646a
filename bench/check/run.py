"""`dolmen check` as a whole process, beside the floor: the same program asked only for its version.

Run by scripts/bench. Wall and CPU time of one process each, the median and the slowest of many runs in turn. Fails if the
median of the flagpole is above the bound.
"""

import argparse
import os
import pathlib
import statistics
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
BOUND_MS = 20.0  # whole process, flagpole
COMMANDS = {
    "floor: --version": ["--version"],
    "flagpole": ["check", "examples/naju_flagpole"],
    "gate": ["check", "examples/heunginjimun_gate"],
    "flagpole, 1000 samples": ["check", "examples/naju_flagpole", "--samples", "1000"],
}


def measured(command):
    began = time.perf_counter()
    process = subprocess.Popen(command, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, used = os.wait4(process.pid, 0)
    wall = time.perf_counter() - began
    code = os.waitstatus_to_exitcode(status)
    if code not in (0, 1):  # 1: a verdict is "unstable"
        sys.exit(f"{' '.join(command)} ended with status {code}")
    return 1e3 * wall, 1e3 * (used.ru_utime + used.ru_stime), used.ru_maxrss / 1024


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--dolmen", default=str(ROOT / "target" / "release" / "dolmen"))
    parser.add_argument("--runs", type=int, default=50)
    options = parser.parse_args()
    times = {name: [] for name in COMMANDS}
    for _ in range(options.runs):
        for name, arguments in COMMANDS.items():
            times[name].append(measured([options.dolmen, *arguments]))
    print(f"{'':24}{'wall, ms':>10}{'slowest':>10}{'CPU, ms':>10}{'MiB':>8}")
    for name, runs in times.items():
        wall, cpu, memory = zip(*runs)
        print(f"{name:24}{statistics.median(wall):10.2f}{max(wall):10.2f}{statistics.median(cpu):10.2f}{max(memory):8.1f}")
    flagpole = statistics.median(run[0] for run in times["flagpole"])
    if flagpole > BOUND_MS:
        sys.exit(f"dolmen check of the flagpole takes {flagpole:.1f} ms, more than {BOUND_MS:.0f}")


if __name__ == "__main__":
    main()
