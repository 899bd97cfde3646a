"""Dolmen and pyOMA2 find the same poles of the same record with the same settings; CPU time and memory of both.

Run by scripts/bench. Each process gets one thread. CPU time is user + system of the whole process; the peer's is also
given less what its imports took. Poles are matched order by order and the largest and the median difference of those
below 2 % damping are printed: record, windows and settings are the same.
"""

import argparse
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
BINARY = ROOT / "target" / "release" / "examples" / "ssi_bench"
ONE_THREAD = {f"{name}_NUM_THREADS": "1" for name in ("OMP", "OPENBLAS", "MKL", "NUMEXPR")}
CASES = {
    # name: (record, sampling rate Hz, channels, samples, block rows, order)
    "a": ("pairs", 100, 8, 60_000, 50, 60),
    "b": ("twisting", 200, 12, 720_000, 84, 60),
    "c": ("tower", 200, 32, 720_000, 100, 60),  # Dolmen alone: the peer needs 74 GB
}
PEERS = {"cov": "cov", "dat": "dat", "cov-sd": "cov", "fdd": "fdd"}
LINES = 1024  # of FDD; the peer takes segments of twice as many samples


def measured(command):
    with tempfile.TemporaryFile() as out:
        process = subprocess.Popen(command, stdout=out, stderr=subprocess.DEVNULL, env={**os.environ, **ONE_THREAD})
        _, status, used = os.wait4(process.pid, 0)
        if status:
            sys.exit(f"{command[0]} ended with status {status}")
        out.seek(0)
        lines = out.read().decode().splitlines()
    return lines, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024


def poles(lines):
    found = {}
    for line in lines:
        order, f, z = (float(word) for word in line.split()[:3])
        if 0 < z < 0.02:
            found.setdefault(order, []).append((f, z))
    return found


def difference(ours, theirs):
    """Median relative difference of frequency, poles of the peer with a partner within 1 %, and all its poles."""
    apart, total = [], 0
    for order, peers in theirs.items():
        for f, z in peers:
            total += 1
            near = min(ours.get(order, []), key=lambda p: abs(p[0] - f) + abs(p[1] - z) * f, default=None)
            if near and abs(near[0] / f - 1) < 0.01:
                apart.append(abs(near[0] / f - 1))
    return statistics.median(apart), max(apart), len(apart), total


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--peer", default=str(ROOT / "bench" / ".venv" / "bin" / "python"))
    parser.add_argument("--cases", default="a", help="letters of a, b (the peer needs 13 GB), c (Dolmen alone)")
    parser.add_argument("--methods", default="cov,dat,fdd", help="of cov, dat, cov-sd (with the deviation of every pole), fdd")
    parser.add_argument("--repeat", type=int, default=3)
    options = parser.parse_args()
    for case in options.cases:
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "record.npy"
            subprocess.run([BINARY, "make", CASES[case][0], "1", file], check=True)
            for method in options.methods.split(","):
                compare(case, method, file, options)


def compare(case, method, file, options):
    _, rate, channels, samples, block_rows, order = CASES[case]
    what = f"{block_rows} block rows, orders 2 to {order}"
    settings = [str(file), str(rate), str(block_rows), str(order)]
    if method == "fdd":
        what, settings[2:] = f"{LINES} lines", [str(LINES), "-"]
    ours = min((measured([BINARY, method, *settings]) for _ in range(options.repeat)), key=lambda r: r[1])
    allowed = 2.5 * channels * samples * 8 / 2**20 + 50
    print(f"case {case}, {method}: {channels} channels x {samples} samples, {what}")
    print(f"  Dolmen    {ours[1]:8.2f} s CPU   {ours[2]:8.0f} MiB (allowed {allowed:.0f})", flush=True)
    if case == "c":
        return
    os.environ["PEER_METHOD"] = PEERS[method]
    os.environ["PEER_DEVIATIONS"] = str(int(method.endswith("-sd")))
    repeat = options.repeat if case == "a" and not method.endswith("-sd") else 1
    peer = [options.peer, str(HERE / "peer.py"), *settings]
    theirs = min((measured(peer) for _ in range(repeat)), key=lambda r: r[1])
    imported = float(theirs[0][0].split()[1])
    print(f"  pyOMA2    {theirs[1]:8.2f} s CPU   {theirs[2]:8.0f} MiB, imports {imported:.2f} s")
    print(f"  ratio     {theirs[1] / ours[1]:8.1f} whole process, {(theirs[1] - imported) / ours[1]:.1f} without imports")
    if method == "fdd":
        return
    median, most, met, total = difference(poles(ours[0]), poles(theirs[0][1:]))
    print(f"  poles     {met} of {total} below 2 % damping meet: {median:.1e} apart in the middle, {most:.1e} at most")


if __name__ == "__main__":
    main()
