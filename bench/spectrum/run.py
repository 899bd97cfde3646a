"""Response spectra: Dolmen beside eqsig on the same work, CPU time of both, ratio printed.

El Centro 1940 NS (1560 samples every 0.02 s), 200 periods from 0.02 to 4 s, damping 5 %. eqsig takes peaks at the samples alone;
Dolmen the true peaks between them too, and both must agree at the samples. Two ways of counting:

* the loop: the spectrum alone, in a process that has everything loaded, median of the rounds;
* the whole process: start, read the file, spectrum, end (user + system time of the child).
"""

import csv
import os
import resource
import statistics
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
RECORD = ROOT / "data/el_centro_1940_ns/el_centro_1940_ns.csv"
BINARY = ROOT / "target/release/examples/spectrum_bench"
ROUNDS = 7


def peer(loops):
    import eqsig
    import numpy as np

    with open(RECORD) as file:
        a = 9.80665 * np.array([float(row["acceleration_g"]) for row in csv.DictReader(file)])
    periods = 0.02 * 200 ** (np.arange(200) / 199)
    spent = []
    for _ in range(loops):
        start = time.process_time()
        sd, _, _ = eqsig.sdof.pseudo_response_spectra(a, 0.02, periods, xi=0.05)
        spent.append(time.process_time() - start)
    print(statistics.median(spent), *sd)


def child(command):
    """CPU time of a process and what it printed."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, capture_output=True, text=True, check=True, env={**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"})
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return cpu, [float(word) for word in done.stdout.split()]


def main():
    peer_command = lambda loops: [sys.executable, __file__, "peer", str(loops)]
    own_command = lambda loops: [str(BINARY), str(RECORD), str(loops)]
    _, theirs = child(peer_command(9))
    _, ours = child(own_command(201))
    worst = max(abs(a / b - 1) for a, b in zip(ours[1:], theirs[1:]))
    assert worst < 1e-4, f"the spectra at the samples differ by {worst:.1e}"
    print(f"200 periods of {RECORD.stem}: at the samples both agree to {worst:.1e}")
    print(f"loop            Dolmen {1e3 * ours[0]:8.3f} ms   eqsig {1e3 * theirs[0]:8.3f} ms   ratio {theirs[0] / ours[0]:7.1f}   (Dolmen: true peaks too)")
    rounds = [(child(own_command(1))[0], child(peer_command(1))[0]) for _ in range(ROUNDS)]
    own, other = (statistics.median(column) for column in zip(*rounds))
    print(f"whole process   Dolmen {1e3 * own:8.3f} ms   eqsig {1e3 * other:8.3f} ms   ratio {other / own:7.1f}   (median of {ROUNDS})")


if __name__ == "__main__":
    peer(int(sys.argv[2])) if len(sys.argv) > 1 else main()
