"""Poles by pyOMA2 of the small record of crates/dolmen/tests/validation/pyoma2.rs, as the tables kept there.

One table for each of its methods cov and dat, with all channels and with channels 0 and 2 as references; then two of its pLSCF,
given half spectra on the lines and with the window of Dolmen's plscf.
"""

import numpy as np
from pyoma2.functions import plscf, ssi

SAMPLES, BLOCK_ROWS, ORDER, RATE = 600, 8, 12, 20.0


def record():
    state = 2021
    resonators = [(1.90, -0.97), (1.55, -0.96)]  # x_t = a x_(t-1) + b x_(t-2) + u
    shapes = [(1.0, 0.6, -0.3), (-0.5, 1.0, 0.8)]
    past = [[0.0, 0.0], [0.0, 0.0]]
    rows = []
    for t in range(2 * SAMPLES):
        draws = []
        for _ in range(5):
            state = (1664525 * state + 1013904223) % 2**32
            draws.append(state / 2**32 - 0.5)
        for (a, b), p, u in zip(resonators, past, draws):
            p[0], p[1] = a * p[0] + b * p[1] + u, p[0]
        if t >= SAMPLES:
            rows.append([sum(s[c] * p[0] for s, p in zip(shapes, past)) + draws[2 + c] for c in range(3)])
    x = np.array(rows)
    return (x - x.mean(axis=0)).T


y = record()
for method in ("cov", "dat"):
    for references in ([0, 1, 2], [0, 2]):
        order = min(ORDER, len(references) * BLOCK_ROWS)
        hankel, _ = ssi.build_hank(y, y[references], BLOCK_ROWS, method=method)
        observability, a, c, _ = ssi.SSI_fast(hankel, BLOCK_ROWS, order, step=2)
        frequency, damping = ssi.SSI_poles(observability, a, c, order, 1 / RATE, step=2, HC=False)[:2]
        print(f"// {method}, references {references}")
        for column in range(1, frequency.shape[1]):
            f, z = frequency[:, column], damping[:, column]
            for i in np.argsort(f):
                # one of each conjugate pair, and no real pole
                if np.isfinite(f[i]) and abs(z[i]) < 1 - 1e-9 and np.sum(np.isclose(f, f[i], rtol=1e-9)) == 2:
                    if i == np.flatnonzero(np.isclose(f, f[i], rtol=1e-9))[0]:
                        print(f"    ({2 * column}, {f[i]:.10f}, {z[i]:.10f}),")

LAGS, WINDOW_END, DEGREES = 59, 0.01, 3
starts = SAMPLES - LAGS
beta = -np.log(WINDOW_END) / LAGS
for references in ([0, 1, 2], [0, 2]):
    lags = np.array([y[:, k : k + starts] @ y[references, :starts].T / starts for k in range(LAGS + 1)])
    weighted = lags * np.exp(-beta * np.arange(LAGS + 1))[:, None, None]
    weighted[0] *= 0.5
    spectra = np.moveaxis(np.fft.rfft(weighted, axis=0), 0, 2)
    # its powers are those of exp(-i w dt): conjugate spectra make them the same sums
    denominators, numerators = plscf.pLSCF(spectra.conj(), 1 / RATE, DEGREES, sgn_basf=-1)
    print(f"// plscf, references {references}")
    for degree, (a, b) in enumerate(zip(denominators, numerators), 1):
        state, _ = plscf.rmfd2ac(a, b)
        # its own window correction makes damping larger, so the window is taken out here
        poles = np.log(np.linalg.eigvals(state))
        poles = poles[(poles.real < 0) & (poles.imag > 1e-9)] + beta
        for mu in sorted(poles * RATE, key=abs):
            print(f"    ({degree * len(references)}, {abs(mu) / (2 * np.pi):.10f}, {-mu.real / abs(mu):.10f}),")
