"""Modes on a fixed base from a measured footing: Dolmen beside N4SID of nfoursid, on records whose truth is known."""

import argparse
import json
import os
import resource
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

import case

ROOT = Path(__file__).resolve().parents[2]
BINARY = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "release/dolmen"
PROJECT = """schema = 1
kind = "survey"
name = "Frame on soft ground"
[survey.2026-01-01.records]
file = "record.csv"
unit = "m/s2"
channels = [
  { column = "G", position = [0, 0, 0], direction = "x" },
  { column = "F1", position = [0, 0, 3], direction = "x" },
  { column = "F2", position = [0, 0, 6], direction = "x" },
  { column = "F3", position = [0, 0, 9], direction = "x" },
]
[survey.2026-01-01.records.modal]
inputs = ["G"]
"""
# settings of the peer: the best of them on all records is the one compared
ORDERS, ROWS = (6, 8, 12), (15, 30)


def child(command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    one = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "RAYON_NUM_THREADS": "1"}
    done = subprocess.run(command, capture_output=True, text=True, env={**os.environ, **one})
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, done


def nearest(found, truth):
    """The mode found nearest to each true one."""
    return [min(found, key=lambda mode: abs(mode["hz"] / hz - 1), default=None) for hz in truth]


def own(folder):
    cpu, done = child([str(BINARY), "identify", str(folder), "--json"])
    modes = json.loads(done.stdout)["surveys"][0]["records"]["modes"]["modes"]
    named = [{"hz": m["frequency_hz"], "sd": m["frequency_sd_hz"], "zeta": m["damping_ratio"], "zeta_sd": m["damping_ratio_sd"]} for m in modes]
    return cpu, named


def peer(folder, order, rows):
    cpu, done = child([sys.executable, str(Path(__file__).with_name("peer.py")), str(folder / "record.csv"), str(order), str(rows)])
    pairs = [map(float, line.split()) for line in done.stdout.splitlines()]
    return cpu, [{"hz": hz, "zeta": zeta} for hz, zeta in pairs if 0 < zeta < 0.2]


def rms(values):
    return (sum(v * v for v in values) / len(values)) ** 0.5


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--records", type=int, default=10)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    truth = case.fixed_base_hz()
    print("fixed base:", " ".join(f"{hz:.4f}" for hz in truth), f"Hz, damping {100 * case.DAMPING} %")
    own_off, own_zeta, inside, inside_zeta, extra, own_cpu = [], [], 0, 0, 0, []
    theirs = {(order, rows): [] for order in ORDERS for rows in ROWS}
    with tempfile.TemporaryDirectory() as place:
        for seed in range(options.seed, options.seed + options.records):
            folder = Path(place) / str(seed)
            folder.mkdir()
            times, values = case.record(seed)
            lines = [f"{t:.2f}," + ",".join(f"{v:.6f}" for v in row) for t, row in zip(times, values)]
            (folder / "record.csv").write_text("time_s,G,F1,F2,F3\n" + "\n".join(lines) + "\n")
            (folder / "project.toml").write_text(PROJECT)
            cpu, found = own(folder)
            own_cpu.append(cpu)
            extra += len(found) - len(truth)
            for mode, hz in zip(nearest(found, truth), truth):
                own_off.append(mode["hz"] / hz - 1)
                own_zeta.append(mode["zeta"] / case.DAMPING - 1)
                inside += abs(mode["hz"] - hz) <= 1.96 * mode["sd"]
                inside_zeta += abs(mode["zeta"] - case.DAMPING) <= 1.96 * mode["zeta_sd"]
            for setting, of in theirs.items():
                cpu, found = peer(folder, *setting)
                modes = nearest(found, truth) if found else []
                of.append((cpu, [m["hz"] / hz - 1 for m, hz in zip(modes, truth)], [m["zeta"] / case.DAMPING - 1 for m in modes], len(found) - len(truth)))
    count = len(own_off)
    print(f"Dolmen    rms of frequency {100 * rms(own_off):.3f} %, of damping {100 * rms(own_zeta):.1f} %; modes too many {extra}; inside 95 %: {inside} and {inside_zeta} of {count}; CPU {statistics.median(own_cpu):.3f} s")
    for (order, rows), of in sorted(theirs.items(), key=lambda item: rms([v for one in item[1] for v in one[1]] or [9.0])):
        off, zeta = [v for one in of for v in one[1]], [v for one in of for v in one[2]]
        cpu = statistics.median(one[0] for one in of)
        print(
            f"nfoursid  order {order:2d}, {rows:2d} block rows: rms of frequency {100 * rms(off):.3f} %, of damping {100 * rms(zeta):.1f} %; poles too many {sum(one[3] for one in of)};"
            f" CPU {cpu:.3f} s, ratio {cpu / statistics.median(own_cpu):.1f}"
        )


if __name__ == "__main__":
    main()
