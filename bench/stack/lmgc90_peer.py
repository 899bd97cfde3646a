"""P10 by LMGC90 (non-smooth contact dynamics), through the extension module of the wheel compas-lmgc90: MOTION.

The wheel fixes gravity (9.81), the detection (STO, explicit) and the solver (NLGS, stored Delassus, QM/16 1.666e-4,
relaxation .1, at most 500 x 50 sweeps); it leaves the step, theta and the contact law. Its ground is a driven block held
still; the inertia forces -m a are driven forces at the blocks' centres, a row a step, known to it before the loop begins.
"""

import sys
import time

import case
from compas_lmgc90 import _lmgc90

THETA = 0.5  # midpoint, the wheel's own default
ALERT_M = 1e-3  # contacts are looked for up to this gap: the wheel's own default
FACES = [(4, 3, 2), (4, 2, 1), (5, 6, 7), (5, 7, 8), (1, 2, 6), (1, 6, 5), (2, 3, 7), (2, 7, 6), (3, 4, 8), (3, 8, 7), (4, 1, 5), (4, 5, 8)]


def corners(side, height):
    a, h = side / 2, height / 2
    flat = [(-a, -a), (a, -a), (a, a), (-a, a)]
    return [c for z in (-h, h) for x, y in flat for c in (x, y, z)]


def main():
    motion = case.read(sys.argv[1])
    settle, shake, quiet = (round(s / case.STEP_S) for s in (case.SETTLE_S, case.DURATION_S, case.QUIET_S))
    blocks = list(case.blocks())
    solver = _lmgc90.LMGC90Solver()
    solver.initialize(case.STEP_S, THETA, False)
    solver.add_one_tact_behav("iqsc0", "IQS_CLB", [case.FRICTION])
    solver.set_materials([case.DENSITY])
    solver.set_see_tables(ALERT_M)
    solver.set_nb_bodies(1 + len(blocks))
    faces = [i for face in FACES for i in face]
    solver.set_one_polyr("s0001", [0.0, 0.0, -0.5], faces, corners(20.0, 1.0), 6, 0)
    for dof in range(1, 7):
        solver.set_drvdof(1, dof, [0.0] * 6, True, False)
    end = case.SETTLE_S + case.DURATION_S
    times = [0.0] + [case.SETTLE_S + k * case.STEP_S for k in range(shake + 1)] + [end + case.QUIET_S + 1.0]
    for body, (side, height, z, mass) in enumerate(blocks, start=2):
        solver.set_one_polyr("s0001", [0.0, 0.0, z], faces, corners(side, height), 0, 2)
        for dof in (1, 2):
            forces = [0.0] + [-mass * row[dof - 1] for row in motion[: shake + 1]] + [0.0]
            solver.set_drvdof(body, dof, times + forces, False, True)
    solver.close_before_computing()

    def stepped(count):
        tops = []
        for _ in range(count):
            state = solver.compute_one_step()
            tops.append(state.bodies[-1])
        return tops, [tuple(b) for b in state.bodies[1:]]

    _, settled = stepped(settle)
    began = time.process_time()
    tops, shaken = stepped(shake)
    loop_s = time.process_time() - began
    _, still = stepped(quiet)
    apart = lambda a, b: tuple(p - q for p, q in zip(a, b))
    case.say(
        "lmgc90",
        loop_cpu_s=loop_s,
        **case.moved(
            [apart(t, settled[-1]) for t in tops],
            [apart(a, b) for a, b in zip(shaken, settled)],
            [apart(a, b) for a, b in zip(still, settled)],
        ),
    )


if __name__ == "__main__":
    main()
