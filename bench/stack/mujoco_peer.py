"""P10 by MuJoCo: MOTION and one of SETTINGS.

The ground does not move; the inertia forces -m a act at the blocks' centres. The loop is MuJoCo's own (mujoco.rollout, in
C, one thread), which also keeps the state of every step: 15 % less CPU than calling mj_step from Python.
"""

import sys
import time

import case
import mujoco
import numpy as np
from mujoco import rollout

SETTINGS = {
    # every value MuJoCo's own but the step
    "mujoco_default": ("", ""),
    # stiffest contact that MuJoCo allows (time constant two steps), friction 100 times stiffer, round cone; the tolerance of
    # its solver 100 times its own: a tenth less CPU, the same motion
    "mujoco_tuned": ('cone="elliptic" impratio="100" tolerance="1e-6"', 'solref="0.002 1" solimp="0.99 0.999 0.001"'),
}


def model(options, contact):
    bodies = "".join(
        f'<body pos="0 0 {z!r}"><freejoint/><geom type="box" size="{side / 2!r} {side / 2!r} {height / 2!r}" mass="{mass!r}"/></body>'
        for side, height, z, mass in case.blocks()
    )
    return mujoco.MjModel.from_xml_string(
        f'<mujoco><option timestep="{case.STEP_S}" gravity="0 0 {-case.GRAVITY}" {options}/>'
        f'<default><geom condim="3" friction="{case.FRICTION} 0 0" {contact}/></default>'
        f'<worldbody><geom type="plane" size="10 10 1"/>{bodies}</worldbody></mujoco>'
    )


def main():
    motion, name = np.array(case.read(sys.argv[1])), sys.argv[2]
    settle, shake, quiet = (round(s / case.STEP_S) for s in (case.SETTLE_S, case.DURATION_S, case.QUIET_S))
    m = model(*SETTINGS[name])
    d = mujoco.MjData(m)

    def places():
        return d.qpos.reshape(-1, 7)[:, :3].copy()

    mujoco.mj_step(m, d, settle)
    settled = places()
    forces = np.zeros((1, shake, m.nbody, 6))
    forces[0, :, :, :2] = -m.body_mass[None, :, None] * motion[:shake, None, :]
    start = np.zeros((1, mujoco.mj_stateSize(m, mujoco.mjtState.mjSTATE_FULLPHYSICS)))
    mujoco.mj_getState(m, d, start[0], mujoco.mjtState.mjSTATE_FULLPHYSICS)
    states = np.zeros((1, shake, start.shape[1]))
    arguments = dict(
        control=forces.reshape(1, shake, -1),
        control_spec=int(mujoco.mjtState.mjSTATE_XFRC_APPLIED),
        initial_warmstart=d.qacc_warmstart[None].copy(),
        state=states,
    )
    began = time.process_time()
    rollout.rollout(m, [d], start, **arguments)
    loop_s = time.process_time() - began
    shaken = places()
    d.xfrc_applied[:] = 0
    mujoco.mj_step(m, d, quiet)
    tops = states[0, :, 1 + 7 * (len(case.P10) - 1) :][:, :3]  # a state is time, positions, velocities
    case.say(name, loop_cpu_s=loop_s, **case.moved(tops - settled[-1], shaken - settled, places() - settled))


if __name__ == "__main__":
    main()
