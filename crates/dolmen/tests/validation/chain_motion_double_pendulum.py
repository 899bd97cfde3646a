"""Double pendulum of two rigid bodies on springs, by Hamilton's equations in 22 digits: mpmath 1.4.1, odefun (Taylor).

Prints the rotations, rad, that chain_motion.rs compares with.  python chain_motion_double_pendulum.py
"""
from mpmath import mp, mpf, odefun, cos, sin

mp.dps = 22
g = mpf("9.81")
m1, m2 = mpf(3), mpf(2)
L1, l1, l2 = mpf("1.5"), mpf("0.7"), mpf("0.5")
J1, J2 = mpf("0.6"), mpf("0.25")
k1, k2 = mpf(40), mpf(15)


# T = a/2 u² + b/2 v² + e u v cos(x - y),  V = gravity + springs, from the positions of the two centres of mass
a = m1 * l1**2 + J1 + m2 * L1**2
b = m2 * l2**2 + J2
e = m2 * L1 * l2


def hamilton(t, state):
    x, y, p, q = state
    c, s = cos(x - y), sin(x - y)
    d = a * b - e**2 * c**2
    u = (b * p - e * c * q) / d
    v = (a * q - e * c * p) / d
    pull = e * u * v * s
    dp = -pull + (m1 * l1 + m2 * L1) * g * sin(x) - k1 * x + k2 * (y - x)
    dq = pull + m2 * l2 * g * sin(y) - k2 * (y - x)
    return [u, v, dp, dq]


solution = odefun(hamilton, 0, [mpf("0.9"), mpf("-0.6"), mpf(0), mpf(0)])
for t in (1, 2, 3):
    x, y = solution(t)[:2]
    print(t, mp.nstr(x, 15), mp.nstr(y, 15))
