"""Cramér-Rao bound of frequency and damping of the made records, over the floor of Au (2014).

    python bench/ssi_cov/bound.py [chain] [pairs] [twisting]      # numpy and scipy; half a minute

Whittle's information of the exact spectral matrix of the record, noise of 20 dB included, of all lines to half the sampling rate:
    I_ab = T Σ_f df tr(S⁻¹ ∂S/∂a S⁻¹ ∂S/∂b)
known: that each mode is under its own white force. Unknown: frequencies, damping ratios, real shapes, noise of each channel. The cases are built
here anew, from the words of docs/measured.md.
"""
import sys

import numpy as np
from scipy.linalg import expm


def shear(floors):
    storey = lambda k: 1 - 0.4 * k / (floors - 1)
    k = np.zeros((floors, floors))
    for i in range(floors):
        k[i, i] = storey(i) + (storey(i + 1) if i + 1 < floors else 0)
        if i:
            k[i, i - 1] = k[i - 1, i] = -storey(i)
    return k


def case(name):
    """Frequencies, damping ratio, shapes (channels x modes), duration, rate."""
    if name == "chain":
        return np.array([1.1, 4.2]), 0.02, np.array([[0.5, 1], [1, -0.5]]).T, 600, 100
    if name == "pairs":
        s, c = 0.5, np.sqrt(0.75)
        sensors = np.kron(np.eye(4), np.array([[c, -s], [s, c]]))
        w2, v = np.linalg.eigh(np.kron(shear(4), np.diag([1, 1.04])))
        return 1.5 * np.sqrt(w2 / w2[0]), 0.01, sensors @ v, 600, 100
    storey = np.array([[1, 0, -0.06], [0, 1.04, 1.04 * 0.12], [-0.06, 1.04 * 0.12, 1.5]])
    sensors = np.kron(np.eye(4), np.array([[1, 0, 1.2], [0, 1, 1.2], [0, 1, -1.2]]))
    w2, v = np.linalg.eigh(np.kron(shear(4), storey))
    return 1.2 * np.sqrt(w2 / w2[0]), 0.012, sensors @ v, 3600, 200


def gain(f, zeta, rate, hz):
    """|acceleration / force|² of one mode, force held over a sample."""
    w = 2 * np.pi * f
    a = np.array([[0, 1], [-w * w, -2 * zeta * w]])
    ad = expm(a / rate)
    bd = np.linalg.solve(a, (ad - np.eye(2)) @ np.array([0, 1]))
    z = np.exp(2j * np.pi * hz / rate)
    det = z * z - np.trace(ad) * z + np.linalg.det(ad)
    q = (z - ad[1, 1]) * bd[0] + ad[0, 1] * bd[1]
    v = ad[1, 0] * bd[0] + (z - ad[0, 0]) * bd[1]
    return np.abs(1 + (a[1, 0] * q + a[1, 1] * v) / det) ** 2


def bound(name):
    f, zeta, phi, duration, rate = case(name)
    channels, modes = phi.shape
    near = [fi * (1 + zeta * np.sinh(np.linspace(-6.5, 6.5, 500))) for fi in f]
    hz = np.unique(np.concatenate([np.linspace(0.05, rate / 2, 1500), *near]))
    hz = hz[(hz > 0.02) & (hz < rate / 2)]
    weight = np.gradient(hz) * duration
    every = np.linspace(0, rate / 2, 400001)
    power = [gain(fi, zeta, rate, hz) for fi in f]
    noise = 0.01 * sum(phi[:, i] ** 2 * gain(f[i], zeta, rate, every).mean() for i in range(modes))
    outer = [np.outer(phi[:, i], phi[:, i]) for i in range(modes)]
    s = sum(p[:, None, None] * o for p, o in zip(power, outer)) + np.diag(noise)
    changes, e = [], 1e-6
    for i in range(modes):
        by_f = (gain(f[i] * (1 + e), zeta, rate, hz) - gain(f[i] * (1 - e), zeta, rate, hz)) / (2 * e)
        by_zeta = (gain(f[i], zeta * (1 + e), rate, hz) - gain(f[i], zeta * (1 - e), rate, hz)) / (2 * e)
        changes += [by_f[:, None, None] * outer[i], by_zeta[:, None, None] * outer[i]]
    for i in range(modes):
        for c in range(channels):
            unit = np.eye(channels)[c] * np.abs(phi[:, i]).max()
            changes.append(power[i][:, None, None] * (np.outer(unit, phi[:, i]) + np.outer(phi[:, i], unit)))
    for c in range(channels):
        changes.append(np.broadcast_to(np.diag(np.eye(channels)[c] * noise[c]), s.shape))
    turned = [np.linalg.solve(s, change) for change in changes]
    left = np.array([x.reshape(len(hz), -1) for x in turned])
    right = np.array([np.swapaxes(x, 1, 2).reshape(len(hz), -1) for x in turned])
    information = np.einsum("agk,bgk,g->ab", left, right, weight, optimize=True)
    sd = np.sqrt(np.diag(np.linalg.inv(information)))
    for i in range(modes):
        turns = 2 * np.pi * f[i] * duration
        over = sd[2 * i] / np.sqrt(zeta / turns), sd[2 * i + 1] * np.sqrt(zeta * turns)
        print(f"{name} {f[i]:.4f} Hz: bound over floor, f {over[0]:.3f}, damping {over[1]:.3f}")


for which in sys.argv[1:] or ["chain", "pairs", "twisting"]:
    bound(which)
