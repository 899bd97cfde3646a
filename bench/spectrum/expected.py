"""Measures of El Centro 1940 by eqsig and numpy, for crates/dolmen/tests/validation/ground_motions.rs.

The record is interpolated along its straight lines, 40 points a step, before eqsig integrates it by trapezoids: what is left
between the two is below 1e-4. The Arias intensity is that of the record at its samples, and D5-95
that of its squares, interpolated likewise. The spectrum of Housner's intensity is eqsig's (Nigam-Jennings, peaks at the samples, here 0.5 ms).
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
at_samples = eqsig.AccSignal(coarse, H)
print("Arias", eqsig.im.calc_arias_intensity(at_samples)[-1] * 9.81 / G, "(eqsig's g is 9.81)")
print("CAV", eqsig.im.calc_cav(signal)[-1])
square = np.interp(fine_time, time, coarse**2)
grown = np.concatenate([[0], np.cumsum(0.5 * (square[1:] + square[:-1]))])
print("D5-95", np.subtract(*np.interp([0.95, 0.05], grown / grown[-1], fine_time)))
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
