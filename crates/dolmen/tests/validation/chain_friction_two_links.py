"""Two links with dry friction in both joints, on a shaking ground: SciPy's DOP853 from event to event.

    python3 -m venv .venv && .venv/bin/pip install scipy==1.17.1 && .venv/bin/python chain_friction_two_links.py

Written on its own: Lagrange's equations of two links with absolute angles, four states of sticking and turning, each with its own
equations; events by SciPy's dense output. Which state follows an event is found by trying all that agree with Coulomb's law.
Prints the rotations at 1, 2 … 6 s and the number of events.
"""

import itertools

import numpy as np
from scipy.integrate import solve_ivp

G = 9.81
M, L, C, J = (3.0, 2.0), (1.5, 1.0), (0.7, 0.5), (0.6, 0.25)
K, D = (120.0, 25.0), (0.4, 0.2)
STATIC, KINETIC = (4.0, 1.2), (4.0, 1.2)
AMPLITUDE, HZ = 3.0, 0.8


def ground(t):
    return AMPLITUDE * np.sin(2 * np.pi * HZ * t)


def equations(t, y, sign):
    """Mass matrix and right-hand side without the moments of stuck joints."""
    a, b, va, vb = y
    inertia = np.array([[M[0] * C[0] ** 2 + M[1] * L[0] ** 2 + J[0], M[1] * L[0] * C[1] * np.cos(a - b)],
                        [M[1] * L[0] * C[1] * np.cos(a - b), M[1] * C[1] ** 2 + J[1]]])
    first, second = M[0] * C[0] + M[1] * L[0], M[1] * C[1]
    low = K[0] * a + D[0] * va + KINETIC[0] * sign[0]
    top = K[1] * (b - a) + D[1] * (vb - va) + KINETIC[1] * sign[1]
    coupling = M[1] * L[0] * C[1] * np.sin(a - b)
    right = np.array([first * (G * np.sin(a) - ground(t) * np.cos(a)) - coupling * vb**2 - low + top,
                      second * (G * np.sin(b) - ground(t) * np.cos(b)) + coupling * va**2 - top])
    return inertia, right


def motion(t, y, stuck, sign):
    """Accelerations and the moments of stuck joints. Joint 1 stuck: a'' = 0; joint 2: b'' = a''."""
    inertia, right = equations(t, y, sign)
    rows = [[*inertia[0], 1.0, -1.0], [*inertia[1], 0.0, 1.0]]
    rhs = list(right)
    rows.append([1, 0, 0, 0] if stuck[0] else [0, 0, 1, 0])
    rows.append([-1, 1, 0, 0] if stuck[1] else [0, 0, 0, 1])
    solved = np.linalg.solve(np.array(rows, float), np.array([*rhs, 0.0, 0.0]))
    return solved[:2], solved[2:]


def speeds(y):
    return y[2], y[3] - y[2]


def next_state(t, y, resting, sign):
    """All states of the joints at rest; the one that agrees with the law just after t."""
    for choice in itertools.product((0, 1, -1), repeat=sum(resting)):
        it = iter(choice)
        s = [next(it) if rest else sign[i] for i, rest in enumerate(resting)]
        stuck = [rest and s[i] == 0 for i, rest in enumerate(resting)]
        acceleration, held = motion(t, y, stuck, s)
        across = (acceleration[0], acceleration[1] - acceleration[0])
        if all(
            (abs(held[i]) <= STATIC[i]) if stuck[i] else (s[i] * across[i] > 0 if resting[i] else True)
            for i in range(2)
        ):
            return stuck, s
    raise RuntimeError("no state")


def main():
    y, t = np.zeros(4), 0.0
    stuck, sign = [True, True], [0, 0]
    wanted, events = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0], 0
    while t < wanted[-1] - 1e-13:
        def rates(t, y, stuck=stuck, sign=sign):
            return [y[2], y[3], *motion(t, y, stuck, sign)[0]]

        watched = []
        for i in range(2):
            if stuck[i]:
                watched.append((i, lambda t, y, i=i: STATIC[i] - abs(motion(t, y, stuck, sign)[1][i])))
            else:
                watched.append((i, lambda t, y, i=i: sign[i] * speeds(y)[i]))
        for _, event in watched:
            event.terminal, event.direction = True, -1
        end = next(w for w in wanted if w > t + 1e-13)
        run = solve_ivp(rates, (t, end), y, method="DOP853", rtol=3e-14, atol=1e-16, events=[e for _, e in watched],
                        max_step=0.01)
        t, y = run.t[-1], run.y[:, -1].copy()
        hit = [watched[k][0] for k, times in enumerate(run.t_events) if len(times)]
        if not hit:
            print(f"    [{y[0]:.15e}, {y[1]:.15e}], // {t} s")
            continue
        events += 1
        resting = list(stuck)
        for i in hit:
            if stuck[i]:
                held = motion(t, y, stuck, sign)[1][i]
                stuck[i], sign[i], resting[i] = False, np.sign(held), False
            else:
                resting[i] = True
        for i in range(2):
            if resting[i]:
                sign[i] = 0
        if resting[0]:
            y[2] = 0.0
        if resting[1]:
            y[3] = y[2]
        stuck, sign = next_state(t, y, resting, sign)
    print(f"    {events} events")


main()
