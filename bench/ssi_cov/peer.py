"""SSI or FDD of one record by pyOMA2 as its manual shows it: FILE SAMPLING_RATE_HZ BLOCK_ROWS ORDER_MOST; of FDD FILE RATE LINES -."""

import os
import resource
import sys

import numpy as np
from pyoma2.algorithms.fdd import FDD
from pyoma2.algorithms.ssi import SSI
from pyoma2.setup.single import SingleSetup


def cpu_s():
    used = resource.getrusage(resource.RUSAGE_SELF)
    return used.ru_utime + used.ru_stime


imported_s = cpu_s()
path, rate, size = sys.argv[1], float(sys.argv[2]), int(sys.argv[3])
record = np.load(path)
setup = SingleSetup(record - record.mean(axis=0), fs=rate)
method = os.environ.get("PEER_METHOD", "cov")
print(f"imported_cpu_s {imported_s:.3f}")
if method == "fdd":
    setup.add_algorithms(FDD(name="fdd", nxseg=2 * size))
    setup.run_by_name("fdd")
    sys.exit()
deviations = os.environ.get("PEER_DEVIATIONS") == "1"
more = {"calc_unc": True, "nb": 30} if deviations else {}
setup.add_algorithms(SSI(name="ssi", method=method, br=size, ordmax=int(sys.argv[4]), step=2, **more))
setup.run_by_name("ssi")
result = setup["ssi"].result
for column in range(result.Fn_poles.shape[1]):
    for f, z in zip(result.Fn_poles[:, column], result.Xi_poles[:, column]):
        if np.isfinite(f):
            print(f"{2 * column} {f:.12f} {z:.12f}")
