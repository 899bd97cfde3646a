"""Made records of a frame of three storeys on soft ground, whose footing is measured, with its exact modes on a fixed base."""

import numpy as np
import scipy.linalg
import scipy.signal

RATE_HZ, LENGTH_S, FINER = 100.0, 60.0, 20
MASSES_T = np.array([40.0, 40.0, 40.0])
STIFFNESS_KN_M = np.array([40e3, 36e3, 30e3])
FOOTING_T, SOIL_KN_M, SOIL_DAMPING = 60.0, 60e3, 0.08
DAMPING = 0.015
NOISE = 0.01


def storeys():
    """Stiffness of the frame on a fixed base."""
    k = np.zeros((3, 3))
    for floor, spring in enumerate(STIFFNESS_KN_M):
        k[floor, floor] += spring
        if floor:
            k[floor - 1, floor - 1] += spring
            k[floor, floor - 1] -= spring
            k[floor - 1, floor] -= spring
    return k


def fixed_base_hz():
    values = scipy.linalg.eigh(storeys(), np.diag(MASSES_T), eigvals_only=True)
    return np.sqrt(values) / (2 * np.pi)


def matrices():
    """Mass, damping and stiffness of frame and footing; damping of the frame is modal."""
    mass = np.diag([FOOTING_T, *MASSES_T])
    k, m = storeys(), np.diag(MASSES_T)
    values, shapes = scipy.linalg.eigh(k, m)
    c = m @ shapes @ np.diag(2 * DAMPING * np.sqrt(values)) @ shapes.T @ m
    total = lambda inner, base: np.block([[np.array([[inner.sum() + base]]), -inner.sum(axis=0)[None]], [-inner.sum(axis=1)[:, None], inner]])
    whole = FOOTING_T + MASSES_T.sum()
    soil_c = 2 * SOIL_DAMPING * np.sqrt(SOIL_KN_M * whole)
    return mass, total(c, soil_c), total(k, SOIL_KN_M), soil_c


def record(seed, wind_kn=0.0, is_steady=False):
    """Times, and absolute accelerations of footing and floors with noise, columns.

    Waves of an earthquake, or steady ones, come through the soil; a wind pushes each floor by this much (root mean square, in the band of the waves).
    """
    rng = np.random.default_rng(seed)
    mass, c, k, soil_c = matrices()
    n = len(mass)
    inverse = np.linalg.inv(mass)
    a = np.block([[np.zeros((n, n)), np.eye(n)], [-inverse @ k, -inverse @ c]])
    pull = np.zeros((n, 2 + n - 1))
    pull[0, :2] = [SOIL_KN_M, soil_c]  # from displacement and velocity of the ground around the footing
    pull[1:, 2:] = np.eye(n - 1)
    b = np.vstack([np.zeros_like(pull), inverse @ pull])
    out = np.hstack([-inverse @ k, -inverse @ c])
    steps = int(LENGTH_S * RATE_HZ * FINER)
    t = np.arange(steps) / (RATE_HZ * FINER)
    shape = 1.0 if is_steady else 0.05 + np.exp(-(((t - 15) / 8) ** 2))
    shaking = shape * rng.standard_normal(steps)
    band = scipy.signal.butter(2, [0.3, 20.0], "bandpass", fs=RATE_HZ * FINER, output="sos")
    velocity = scipy.signal.sosfilt(band, shaking)
    velocity *= 0.05 / velocity.std()
    push = scipy.signal.sosfilt(band, rng.standard_normal((steps, n - 1)), axis=0)
    acts = np.column_stack([np.cumsum(velocity) / (RATE_HZ * FINER), velocity, wind_kn * push / push.std()])
    _, _, x = scipy.signal.lsim((a, b, np.eye(2 * n), np.zeros((2 * n, b.shape[1]))), acts, t)
    measured = (x @ out.T + acts @ (inverse @ pull).T)[::FINER]
    measured /= np.abs(measured).max()
    noise = NOISE * measured.std(axis=0) * rng.standard_normal(measured.shape)
    return t[::FINER], measured + noise
