"""N4SID of nfoursid on a record: frequencies and damping ratios of the poles, at the order and the block rows that are asked for."""

import sys

import numpy as np
import pandas as pd
from nfoursid.nfoursid import NFourSID


def main():
    file, order, rows = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    data = pd.read_csv(file)
    step = data["time_s"][1] - data["time_s"][0]
    found = NFourSID(data, output_columns=["F1", "F2", "F3"], input_columns=["G"], num_block_rows=rows)
    found.subspace_identification()
    space, _ = found.system_identification(rank=order)
    for pole in np.log(np.linalg.eigvals(space.a).astype(complex)) / step:
        if pole.imag > 0:
            print(abs(pole) / (2 * np.pi), -pole.real / abs(pole))


main()
