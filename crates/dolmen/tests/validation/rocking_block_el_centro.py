"""Rocking of one block under El Centro 1940 north-south, with SciPy's DOP853 restarted at every sample of the motion and
every event. Writes the impacts that rocking_block.rs compares with.

python rocking_block_el_centro.py el_centro_1940_ns.csv 24        (numpy 2.4.6, scipy 1.17.1)
"""
import sys
import numpy as np
from scipy.integrate import solve_ivp

G, B, H, PEAK_G = 9.81, 0.4, 2.0, 0.35
alpha = np.arctan2(B, H)
p2 = 1.5 * G / np.hypot(B, H)
r = 1 - 1.5 * np.sin(alpha) ** 2

table = np.loadtxt(sys.argv[1], delimiter=",", skiprows=1)
x = table[:, 1] * (PEAK_G * G / np.abs(table[:, 1]).max())
z = 0.5 * x[::-1]
dt = 0.02


def run(most):
    impacts, side, u, v, peak = [], 0, 0.0, 0.0, 0.0
    for i in range(len(x) - 1):
        t, end = i * dt, (i + 1) * dt
        ground = lambda s: (np.interp(s, [i * dt, end], x[i : i + 2]), np.interp(s, [i * dt, end], z[i : i + 2]))
        while t < end - 1e-13:
            if side == 0:
                first = None
                for s in (1, -1):
                    hold = lambda q: (1 + ground(q)[1] / G) * np.sin(alpha) + s * ground(q)[0] / G * np.cos(alpha)
                    a, b = hold(t), hold(end)
                    if b < 0:
                        at = t if a <= 0 else t + (end - t) * a / (a - b)
                        if first is None or at < first[0]:
                            first = (at, s)
                if first is None:
                    t = end
                    continue
                t, side = first
                u = v = 0.0
            s = side

            def f(q, y):
                gx, gz = ground(q)
                return [y[1], -p2 * ((1 + gz / G) * np.sin(alpha - y[0]) + s * gx / G * np.cos(alpha - y[0]))]

            start = t
            hit = lambda q, y: y[0] if q > start + 1e-12 else 1.0
            hit.terminal, hit.direction = True, -1
            out = solve_ivp(f, (t, end), [u, v], "DOP853", rtol=1e-13, atol=1e-16, events=hit, max_step=2e-3)
            peak = max(peak, out.y[0].max())
            t = out.t[-1]
            u, v = out.y[:, -1]
            if out.status == 1:
                impacts.append((t, s * v))
                side, u, v = -s, 0.0, -r * v
                if len(impacts) == most:
                    return impacts, peak
                if v < 1e-7:
                    side = 0
    return impacts, peak


impacts, peak = run(int(sys.argv[2]) if len(sys.argv) > 2 else 30)
for at, velocity in impacts:
    print(f"    ({at:.12f}, {velocity:.12f}),")
print("peak", repr(peak))
