"""Does a semicircular arch of flat-faced voussoirs stand? compas_cra (coupled rigid-block analysis, Kao et al. 2022) says.

    python bench/arches/peer.py VOUSSOIRS THICKNESS_OVER_RADIUS FRICTION

Radius of the middle line 1 m, depth 0.5 m, on two fixed blocks. Prints the verdict, and the processor time of finding the joints and of the solver.
"""

import contextlib
import io
import math
import sys
import time

from compas_assembly.datastructures import Block
from compas_cra.algorithms import assembly_interfaces_numpy
from compas_cra.datastructures import CRA_Assembly
from compas_cra.equilibrium import cra_solve

DEPTH, FOOT = 0.5, 0.2
FACES = [[0, 1, 2, 3], [7, 6, 5, 4], [0, 4, 5, 1], [1, 5, 6, 2], [2, 6, 7, 3], [3, 7, 4, 0]]


def block(outline):
    sides = [[[x, y, z] for x, z in outline] for y in (-0.5 * DEPTH, 0.5 * DEPTH)]
    return Block.from_vertices_and_faces(sides[0] + sides[1], FACES)


def arch(voussoirs, thickness):
    inner, outer = 1 - 0.5 * thickness, 1 + 0.5 * thickness
    joint = [(math.cos(math.pi * i / voussoirs), math.sin(math.pi * i / voussoirs)) for i in range(voussoirs + 1)]
    point = lambda radius, i: (radius * joint[i][0], radius * joint[i][1])
    made = CRA_Assembly()
    for i in range(voussoirs):
        made.add_block(block([point(inner, i), point(outer, i), point(outer, i + 1), point(inner, i + 1)]), node=i)
    made.add_block(block([(inner, -FOOT), (outer, -FOOT), (outer, 0), (inner, 0)]), node=voussoirs)
    made.add_block(block([(-outer, -FOOT), (-inner, -FOOT), (-inner, 0), (-outer, 0)]), node=voussoirs + 1)
    made.set_boundary_conditions([voussoirs, voussoirs + 1])
    return made


def main():
    voussoirs, thickness, friction = int(sys.argv[1]), float(sys.argv[2]), float(sys.argv[3])
    made = arch(voussoirs, thickness)
    start = time.process_time()
    with contextlib.redirect_stdout(io.StringIO()):
        assembly_interfaces_numpy(made, nmax=10, amin=1e-4, tmax=1e-6)
        found = time.process_time()
        try:
            cra_solve(made, mu=friction)
            verdict = "stands"
        except ValueError as why:
            verdict = "falls" if "infeasible" in str(why).lower() else f"undecided: {why}"
    solved = time.process_time()
    joints = len(list(made.edges()))
    print(f"{joints}\t{verdict}\t{found - start:.6f}\t{solved - found:.6f}")


main()
