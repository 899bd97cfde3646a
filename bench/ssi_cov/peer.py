"""SSI-cov of one record by pyOMA2, its own functions with nothing around them: FILE RATE BLOCK_ROWS ORDER_MOST."""

import os
import resource
import sys


def cpu_s():
    used = resource.getrusage(resource.RUSAGE_SELF)
    return used.ru_utime + used.ru_stime


import numpy as np  # noqa: E402
from pyoma2.functions import ssi  # noqa: E402

imported_s = cpu_s()
path, rate, block_rows, order = sys.argv[1], float(sys.argv[2]), int(sys.argv[3]), int(sys.argv[4])
y = np.load(path).T
hankel, _ = ssi.build_hank(y, y, block_rows, method=os.environ.get("PEER_METHOD", "cov"))
observability, a, c, _ = ssi.SSI_fast(hankel, block_rows, order, step=2)
frequency, damping = ssi.SSI_poles(observability, a, c, order, 1 / rate, step=2)[:2]
print(f"imported_cpu_s {imported_s:.3f}")
for column in range(frequency.shape[1]):
    for f, z in zip(frequency[:, column], damping[:, column]):
        if np.isfinite(f):
            print(f"{2 * column} {f:.12f} {z:.12f}")
