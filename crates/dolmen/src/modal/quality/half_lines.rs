//! Lines of one half of a record, from those of the whole record near one frequency.

use super::sines::taper;
use dolmen_linalg::Complex64;
use rustfft::FftPlanner;
use std::f64::consts::PI;

/// Share of the record in which each half begins, and its length: where the taper of the whole record is 1.
const BEGINS: [f64; 2] = [0.05, 0.5];
const LONG: f64 = 0.45;
/// Share of the lines that the ends of the band do not touch.
const INNER: f64 = 0.8;

/// Lines of a half, one of them at the middle of the given ones.
pub(super) struct HalfLines {
    pub(super) lines: Vec<Complex64>,
    /// Distance between them, in lines of the whole record.
    pub(super) apart: f64,
}

/// Lines of both halves, tapered, from an odd number of neighbouring tapered lines of the whole record.
///
/// ```text
/// b(τ) = Σ_i z_i e^(2πi (i − R) τ)        motion near the middle line, R lines on each side, τ from 0 (begin) to 1 (end)
/// ```
pub(super) fn of_halves(whole: &[Complex64]) -> [HalfLines; 2] {
    let m = whole.len();
    let reach = m / 2;
    let mut planner = FftPlanner::new();
    let mut motion = vec![Complex64::ZERO; m];
    for (i, z) in whole.iter().enumerate() {
        let off = i as f64 - reach as f64;
        motion[(i + m - reach) % m] = z * Complex64::from_polar(1.0, PI * off / m as f64);
    }
    planner.plan_fft_inverse(m).process(&mut motion);
    BEGINS.map(|begin| {
        let (from, length) = ((begin * m as f64).ceil() as usize, (LONG * m as f64) as usize);
        let mut part: Vec<Complex64> = motion[from..from + length].to_vec();
        for (j, b) in part.iter_mut().enumerate() {
            *b *= taper((j as f64 + 0.5) / length as f64);
        }
        planner.plan_fft_forward(length).process(&mut part);
        let inner = (INNER * 0.5 * length as f64) as usize;
        let lines = (0..=2 * inner).map(|k| {
            let off = k as f64 - inner as f64;
            part[(k + length - inner) % length] * Complex64::from_polar(1.0, -PI * off / length as f64)
        });
        HalfLines {
            lines: lines.collect(),
            apart: m as f64 / length as f64,
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sums over the samples of each half of a motion of two sines, the first of them in the first half only.
    #[test]
    fn exact_lines_of_halves_are_those_of_their_samples() {
        let (n, middle, reach) = (40_100, 2_000, 200); // a hundred samples for each line
        let y = |t: usize| {
            let at = (t as f64 + 0.5) / n as f64;
            let runs = if at < 0.5 {
                (2.0 * PI * 2_003.3 * at).sin()
            } else {
                0.0
            };
            runs + 0.4 * (2.0 * PI * 1_990.0 * at + 1.0).sin()
        };
        let line = |(from, length): (usize, usize), weight: &dyn Fn(f64) -> f64, at_line: f64| -> Complex64 {
            let each = (0..length).map(|t| {
                let at = (t as f64 + 0.5) / length as f64;
                Complex64::from_polar(weight(at) * y(from + t), -2.0 * PI * at_line * at)
            });
            each.sum::<Complex64>() / length as f64
        };
        let whole: Vec<Complex64> = (middle - reach..=middle + reach)
            .map(|i| line((0, n), &taper, i as f64))
            .collect();
        let m = whole.len() as f64;
        for (half, begin) in of_halves(&whole).iter().zip(BEGINS) {
            let (from, length) = ((begin * m).ceil() / m, (LONG * m).floor() / m);
            let samples = (
                (from * n as f64).round() as usize,
                (length * n as f64).round() as usize,
            );
            // the phase is that at the begin of the half
            let begin = Complex64::from_polar(1.0, -2.0 * PI * middle as f64 * from);
            let centre = half.lines.len() / 2;
            let found: Vec<Complex64> = half.lines.iter().map(|z| z / (length * m)).collect();
            let top = found.iter().map(|z| z.norm()).fold(0.0, f64::max);
            for (k, found) in found.into_iter().enumerate() {
                let at_line = (middle as f64 + (k as f64 - centre as f64) * half.apart) * length;
                let exact = begin * line(samples, &taper, at_line);
                assert!((found - exact).norm() < 0.01 * top, "{k}: {found} {exact}");
            }
        }
    }
}
