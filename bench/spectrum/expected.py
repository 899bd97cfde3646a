"""Measures of El Centro 1940 by eqsig and numpy, for crates/dolmen/tests/validation/motion_measures.rs.

The record is interpolated along its straight lines, 40 points a step, before eqsig integrates it by trapezoids: what is left
between the two is below 1e-4. The spectrum of Housner's intensity is eqsig's (Nigam-Jennings, peaks at the samples, here 0.5 ms).
"""

import csv
from pathlib import Path

import eqsig
import numpy as np

G = 9.80665
ROOT = Path(__file__).resolve().parents[2]
with open(ROOT / "data/el_centro_1940_ns/el_centro_1940_ns.csv") as file:
    coarse = G * np.array([float(row["acceleration_g"]) for row in csv.DictReader(file)])
H, FINE = 0.02, 40
time = np.arange(len(coarse)) * H
fine_time = np.linspace(0, time[-1], (len(coarse) - 1) * FINE + 1)
signal = eqsig.AccSignal(np.interp(fine_time, time, coarse), H / FINE)
print("PGV", np.abs(signal.velocity).max(), "last", signal.velocity[-1])
print("PGD", np.abs(signal.displacement).max(), "last", signal.displacement[-1])
arias = eqsig.im.calc_arias_intensity(signal)
print("Arias", arias[-1] * 9.81 / G, "(eqsig's g is 9.81)" )
print("Arias at the samples", eqsig.im.calc_arias_intensity(eqsig.AccSignal(coarse, H))[-1] * 9.81 / G)
print("CAV", eqsig.im.calc_cav(signal)[-1])
print("D5-95", eqsig.im.calc_sig_dur(signal))
periods = np.arange(0.1, 2.5 + 0.005, 0.01)
sd, sv, sa = eqsig.sdof.pseudo_response_spectra(signal.values, signal.dt, periods, xi=0.05)
print("Housner", np.trapezoid(sv, periods))
n = max(len(coarse), int(np.ceil(1 / (0.05 * H))))
power, f = np.abs(np.fft.rfft(coarse, n)) ** 2, np.fft.rfftfreq(n, H)
band = (f >= 0.25) & (f <= 20)
print("mean period", (power[band] / f[band]).sum() / power[band].sum())
periods = 0.02 * 200 ** (np.arange(200) / 199)
sd, sv, sa = eqsig.sdof.pseudo_response_spectra(signal.values, signal.dt, periods, xi=0.05)
print("predominant", periods[sa.argmax()])
