//! Compares a simulated series with the measured series of the same place and time.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | y, ŷ | `measured`, `simulated` | the two series |
//! | g | `input` | ground motion, the input of both |
//! | H | `response` | frequency response, smoothed over a few lines |

use realfft::RealFftPlanner;
use realfft::num_complex::Complex;

/// Number of lines on either side over which cross spectra are smoothed. Our choice: 0.13 Hz for an earthquake of 30 s.
const SMOOTHED: usize = 4;
/// Smallest power of the input, over its largest power, both smoothed. Below this limit a ratio is meaningless. Our choice.
const INPUT_LEAST: f64 = 1e-3;
/// Highest frequency considered, as a share of the sampling rate. Above it the linear interpolation of the input becomes visible.
const OF_RATE: f64 = 0.2;

/// Agreement between a simulated series and the measured one.
#[derive(Clone, Debug, PartialEq)]
pub struct SeriesBeside {
    /// Largest absolute value, measured.
    pub peak_measured: f64,
    /// Largest absolute value, simulated.
    pub peak_simulated: f64,
    /// Root mean square, measured.
    pub rms_measured: f64,
    /// Root mean square, simulated.
    pub rms_simulated: f64,
    /// Correlation coefficient; 0 if either series is constant.
    pub correlation: f64,
    /// Root mean square of the difference over that of the measured series; infinite if the measured series is zero.
    pub residual_ratio: f64,
    /// Frequency of the largest response of the measured series, Hz; `None` if the series are too short.
    pub frequency_measured_hz: Option<f64>,
    /// Frequency of the largest response of the simulated series, Hz.
    pub frequency_simulated_hz: Option<f64>,
}

/// Compares two series of one length and step, and the frequencies of their largest response to the input.
///
/// ```text
/// ρ = Σ (y − ȳ)(ŷ − ȳ̂) / √(Σ (y − ȳ)² Σ (ŷ − ȳ̂)²)
/// ε = √(Σ (ŷ − y)² / Σ y²)
/// H = ⟨Y G*⟩ / ⟨G G*⟩      ⟨⟩: mean over neighbouring lines; the peak of |H|, by a parabola
/// ```
///
/// # Limits
/// The frequency is that of the largest response at one place; at a node of the first mode it is the frequency of another mode. Both series are
/// smoothed in the same way. Series of different lengths are compared over the shorter length.
pub fn series_beside([measured, simulated, input]: [&[f64]; 3], step_s: f64) -> SeriesBeside {
    let length = measured.len().min(simulated.len()).min(input.len());
    let [y, s, g] = [&measured[..length], &simulated[..length], &input[..length]];
    let count = length.max(1) as f64;
    let peak = |x: &[f64]| x.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let square = |x: &[f64]| x.iter().map(|x| x * x).sum::<f64>();
    let mean = |x: &[f64]| x.iter().sum::<f64>() / count;
    let [my, ms] = [mean(y), mean(s)];
    let (mut both, mut yy, mut ss, mut off) = (0.0, 0.0, 0.0, 0.0);
    for (y, s) in y.iter().zip(s) {
        both += (y - my) * (s - ms);
        yy += (y - my).powi(2);
        ss += (s - ms).powi(2);
        off += (s - y).powi(2);
    }
    let moves = yy > 0.0 && ss > 0.0;
    SeriesBeside {
        peak_measured: peak(y),
        peak_simulated: peak(s),
        rms_measured: (square(y) / count).sqrt(),
        rms_simulated: (square(s) / count).sqrt(),
        correlation: if moves { both / (yy * ss).sqrt() } else { 0.0 },
        residual_ratio: match square(y) > 0.0 {
            true => (off / square(y)).sqrt(),
            false => f64::INFINITY,
        },
        frequency_measured_hz: peak_of_response_hz(y, g, step_s),
        frequency_simulated_hz: peak_of_response_hz(s, g, step_s),
    }
}

fn peak_of_response_hz(y: &[f64], g: &[f64], step_s: f64) -> Option<f64> {
    let length = y.len();
    if length < 16 * SMOOTHED {
        return None;
    }
    let transform = RealFftPlanner::<f64>::new().plan_fft_forward(length);
    let lines = |x: &[f64]| {
        let mean = x.iter().sum::<f64>() / length as f64;
        let mut part: Vec<f64> = x.iter().map(|x| x - mean).collect();
        let mut lines = transform.make_output_vec();
        // the buffers have the required lengths
        let _ = transform.process(&mut part, &mut lines);
        lines
    };
    let (y, g) = (lines(y), lines(g));
    let step_hz = 1.0 / (length as f64 * step_s);
    let last = ((OF_RATE / step_s / step_hz) as usize).min(y.len().checked_sub(SMOOTHED + 1)?);
    let smooth = |k: usize| {
        let (mut cross, mut own) = (Complex::new(0.0, 0.0), 0.0);
        for i in k - SMOOTHED..=k + SMOOTHED {
            cross += y[i] * g[i].conj();
            own += g[i].norm_sqr();
        }
        (cross.norm(), own)
    };
    let all: Vec<(f64, f64)> = (SMOOTHED + 1..=last).map(smooth).collect();
    let most = all.iter().fold(0.0_f64, |most, (_, own)| most.max(*own));
    let response: Vec<f64> = all
        .iter()
        .map(|(cross, own)| {
            if *own > INPUT_LEAST * most {
                cross / own
            } else {
                0.0
            }
        })
        .collect();
    let inner = 1..response.len().checked_sub(1)?;
    let at = inner
        .filter(|k| response[*k] > response[k - 1] && response[*k] >= response[k + 1])
        .max_by(|a, b| response[*a].total_cmp(&response[*b]))?;
    let [a, b, c] = [response[at - 1], response[at], response[at + 1]];
    let off = 0.5 * (a - c) / (a - 2.0 * b + c);
    let off = if off.is_finite() {
        off.clamp(-0.5, 0.5)
    } else {
        0.0
    };
    Some((at as f64 + off + (SMOOTHED + 1) as f64) * step_hz)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;

    #[test]
    fn exact_a_scaled_and_a_delayed_sine() {
        let sine = |size: f64, phase: f64| -> Vec<f64> {
            (0..1000)
                .map(|i| size * (std::f64::consts::TAU * (f64::from(i) / 100.0) + phase).sin())
                .collect()
        };
        let (y, s) = (sine(2.0, 0.0), sine(1.0, std::f64::consts::FRAC_PI_3));
        let of = series_beside([&y, &s, &y], 0.01);
        assert!((of.correlation - 0.5).abs() < 1e-9, "{of:?}");
        assert!((of.rms_measured - 2f64.sqrt()).abs() < 1e-9 && (of.peak_measured - 2.0).abs() < 1e-9);
        // |2 − e^(iπ/3)| / 2
        assert!((of.residual_ratio - 3f64.sqrt() / 2.0).abs() < 1e-9, "{of:?}");
        let still = series_beside([&y, &[0.0; 1000], &y], 0.01);
        assert_eq!((still.correlation, still.residual_ratio), (0.0, 1.0));
    }

    #[test]
    fn exact_the_frequency_of_one_oscillator_under_noise() {
        // x'' + 2ζω x' + ω² x = −g, 2.4 Hz, 5 %: the absolute acceleration is largest at ω, within ζ²
        let (w, zeta, h) = (std::f64::consts::TAU * 2.4, 0.05, 1e-3);
        let random = &mut Random::new(3, 0);
        let (mut x, mut v, mut ground, mut answer) = (0.0, 0.0, Vec::new(), Vec::new());
        let mut g = 0.0;
        for step in 0..60_000 {
            g += 0.1 * (random.normal() - g);
            let a = -2.0 * zeta * w * v - w * w * x;
            v += h * (a - g);
            x += h * v;
            if step % 10 == 0 {
                ground.push(g);
                answer.push(a);
            }
        }
        let of = series_beside([&answer, &answer, &ground], 0.01);
        let hz = of.frequency_measured_hz.unwrap();
        assert!((hz - 2.4).abs() < 0.05, "{hz}");
        assert_eq!(of.frequency_measured_hz, of.frequency_simulated_hz);
    }
}
