"""Three links whose static moments are above the kinetic ones, on a ground that shakes in straight lines: SciPy's DOP853 from event
to event.

    python3 -m venv .venv && .venv/bin/pip install scipy==1.17.1 && .venv/bin/python chain_friction_three_links.py

Written on its own: equations in the rotations across the joints, for any number of links; which state follows an event is found by
letting go, or holding, the joint that is furthest from Coulomb's law in parts of its limit, until all agree with it.
Prints the rotations at 1, 2 … 6 s and the number of events.
"""

import numpy as np
from scipy.integrate import DOP853

G = 9.81
MASS, LENGTH, CENTROID, INERTIA = map(np.array, ([3.0, 2.0, 1.0], [1.5, 1.0, 0.8], [0.7, 0.5, 0.4], [0.6, 0.25, 0.06]))
STIFFNESS, DAMPING = np.array([160.0, 50.0, 10.0]), np.array([0.5, 0.2, 0.05])
STATIC, KINETIC = np.array([5.0, 2.5, 0.6]), np.array([3.0, 1.5, 0.4])
STEP, WAVE = 0.25, [0.0, 6.0, 0.0, -6.0]
N = len(MASS)
SUM = np.tril(np.ones((N, N)))  # rotations of links from those across joints
ABOVE = np.array([MASS[i + 1:].sum() for i in range(N)])
INFLUENCE = MASS * CENTROID + LENGTH * ABOVE
MATRIX = np.diag(MASS * CENTROID**2 + LENGTH**2 * ABOVE + INERTIA)
for i in range(N):
    for j in range(i + 1, N):
        MATRIX[i, j] = MATRIX[j, i] = LENGTH[i] * (MASS[j] * CENTROID[j] + LENGTH[j] * ABOVE[j])


def ground(t, piece):
    a, b = WAVE[piece % 4], WAVE[(piece + 1) % 4]
    return a + (b - a) * (t - piece * STEP) / STEP


def solved(theta, omega, a, mode):
    """Rates of φ' and moments of friction; mode 0 sticks, ±1 turns."""
    apart = theta[:, None] - theta[None, :]
    force = INFLUENCE * (G * np.sin(theta) - a * np.cos(theta)) - (MATRIX * np.sin(apart)) @ omega**2
    inertia = SUM.T @ (MATRIX * np.cos(apart)) @ SUM
    right = SUM.T @ force - STIFFNESS * np.diff(theta, prepend=0) - DAMPING * np.diff(omega, prepend=0)
    mode = np.array(mode)
    free, friction, rate = mode != 0, mode * KINETIC, np.zeros(N)
    if free.any():
        rate[free] = np.linalg.solve(inertia[np.ix_(free, free)], (right - friction)[free])
    return rate, np.where(free, friction, right - inertia @ rate)


def settled(theta, omega, a, mode, resting, gone):
    mode = list(mode)
    for _ in range(50):
        rate, held = solved(theta, omega, a, mode)
        off = []
        for i in (i for i in resting if i not in gone):
            if mode[i] == 0 and abs(held[i]) > STATIC[i] * (1 + 1e-9):
                off.append((abs(held[i]) / STATIC[i] - 1, i, int(np.sign(held[i]))))
            elif mode[i] * rate[i] < -1e-9:
                off.append((-mode[i] * rate[i] * MATRIX[i, i] / STATIC[i], i, 0))
        if not off:
            return mode
        _, joint, to = max(off)
        mode[joint] = to
    raise RuntimeError("no state")


def run(until=6.0):
    theta, omega, t, events = np.zeros(N), np.zeros(N), 0.0, 0
    mode = settled(theta, omega, 0.0, [0] * N, range(N), [])
    for piece in range(int(until / STEP)):
        end = (piece + 1) * STEP
        while t < end - 1e-13:
            now = tuple(mode)

            def left(x, y):
                """Above zero while nothing changes."""
                _, held = solved(y[:N], y[N:], ground(x, piece), now)
                across = np.diff(y[N:], prepend=0)
                return np.where(np.array(now) == 0, 1 - np.abs(held) / STATIC, now * across)

            def rates(x, y):
                return np.concatenate([y[N:], SUM @ solved(y[:N], y[N:], ground(x, piece), now)[0]])

            start = np.concatenate([theta, omega])
            fresh, began = left(t, start) < 1e-9, t
            steps, hit = DOP853(rates, t, start, end, rtol=1e-13, atol=1e-15, max_step=0.05), None
            while steps.status == "running" and hit is None:
                steps.step()
                place, low = steps.dense_output(), steps.t_old
                for x in np.linspace(steps.t_old, steps.t, 13)[1:]:
                    value = left(x, place(x))
                    rounding = fresh & (value > -1e-9) & (x - began < 1e-6)
                    bad = (value < -1e-12) & ~rounding
                    if bad.any():
                        high = x
                        while high - low > 1e-14 and low < 0.5 * (low + high) < high:
                            middle = 0.5 * (low + high)
                            if (left(middle, place(middle))[bad] < -1e-12).any():
                                high = middle
                            else:
                                low = middle
                        y = place(high)
                        hit = high, y, [i for i in np.flatnonzero(bad) if left(high, y)[i] < -1e-13]
                        break
                    low = x
            if hit is None:
                t, theta, omega = end, steps.y[:N].copy(), steps.y[N:].copy()
                continue
            t, theta, omega = hit[0], hit[1][:N].copy(), hit[1][N:].copy()
            _, held = solved(theta, omega, ground(t, piece), now)
            gone = [i for i in hit[2] if now[i] == 0]
            for i in hit[2]:
                mode[i] = int(np.sign(held[i])) if i in gone else 0
            resting = [i for i in range(N) if now[i] == 0 or i in hit[2]]
            across = np.diff(omega, prepend=0)
            across[resting] = 0.0
            omega = SUM @ across
            mode = settled(theta, omega, ground(t, piece), mode, resting, gone)
            events += 1
        if round(t / STEP) % round(1 / STEP) == 0:
            print(", ".join(f"{x:.15e}" for x in theta))
    print(events)


run()
