//! Intensity measures of one component of a ground motion, exact for an acceleration that is linear between samples; the Arias intensity sums the
//! squares of the samples.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | a, v, u | `a`, `v`, `u` | acceleration, velocity and displacement of the ground | m/s², m/s, m |
//! | h, s | `h`, `s` | time step; slope of a within it | s, m/s³ |
//! | E | `energy` | ∫ a² dt, trapezoids of a² | m²/s³ |
//! | C_k, f_k | `spectrum`, `f` | Fourier coefficient and its frequency | m/s², Hz |

use super::{Component, GroundMotion, SignalError, response_spectrum};
use crate::known::STANDARD_GRAVITY_M_S2;
use realfft::RealFftPlanner;
use std::f64::consts::PI;

/// Damping ratio and periods of the Housner intensity, s (Housner 1952, with today's usual damping).
const HOUSNER_DAMPING: f64 = 0.05;
const HOUSNER_PERIODS_S: [f64; 2] = [0.1, 2.5];
const HOUSNER_STEP_S: f64 = 0.01;
/// Frequencies of the mean period, Hz, and the widest step between them (Rathje et al. 1998).
const MEAN_PERIOD_HZ: [f64; 2] = [0.25, 20.0];
const MEAN_PERIOD_STEP_HZ: f64 = 0.05;
/// Shares of the Arias intensity at the start and end of the significant duration (Trifunac, Brady 1975).
const SIGNIFICANT: [f64; 2] = [0.05, 0.95];

/// Strength of one component of a motion, in the measures of the field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IntensityMeasures {
    /// Largest |a|, m/s².
    pub peak_acceleration_m_s2: f64,
    /// Largest |v|, m/s, from rest at the first sample: the true peak between samples, without base-line correction.
    pub peak_velocity_m_s: f64,
    /// Largest |u|, m, defined in the same way.
    pub peak_displacement_m: f64,
    /// v at the last sample, m/s: the effect of an uncorrected base line.
    pub last_velocity_m_s: f64,
    /// u at the last sample, m.
    pub last_displacement_m: f64,
    /// Arias intensity π/(2g) ∫ a² dt, m/s.
    pub arias_intensity_m_s: f64,
    /// Cumulative absolute velocity ∫ |a| dt, m/s.
    pub cumulative_absolute_velocity_m_s: f64,
    /// Housner intensity ∫ PSV dT, T 0.1 … 2.5 s, ζ 5 %, m. `None` if the time step does not resolve those periods.
    pub housner_intensity_m: Option<f64>,
    /// Time from 5 % to 95 % of the Arias intensity, s: D5–95.
    pub significant_duration_s: f64,
    /// Time at which 5 % is reached, s.
    pub significant_from_s: f64,
    /// Mean period Σ C² / f / Σ C², f 0.25 … 20 Hz, s. `None` if no frequency of the motion lies there.
    pub mean_period_s: Option<f64>,
    /// Period of the largest pseudo-acceleration, ζ 5 %, T 0.02 … 4 s in 200 steps, s. `None` as for the Housner intensity.
    pub predominant_period_s: Option<f64>,
}

/// The intensity measures of one component.
///
/// ```text
/// within a step     a = a_0 + s τ     v = v_0 + a_0 τ + s τ²/2     u = u_0 + v_0 τ + a_0 τ²/2 + s τ³/6
/// Arias             π/(2g) Σ h (a_0² + a_1²)/2
/// ```
///
/// # Errors
/// [`SignalError::NoMotion`] if the component does not move.
///
/// # Limits
/// Velocity and displacement are those of the uncorrected record: an offset makes them grow with t and t². Remove it first
/// ([`GroundMotion::baseline_corrected`]). The Arias intensity and its duration are trapezoids of a², as in most programs: by Parseval exact for a
/// motion without frequencies above half the sampling rate. The square of the straight lines is (2 + cos 2πfh)/3 times as large: 6 % less for ten
/// samples in a period, 4.3 % less for El Centro 1940 at 0.02 s.
///
/// # Source
/// Arias (1970) in *Seismic Design for Nuclear Power Plants*, MIT Press; Housner (1952) Caltech; Trifunac, Brady (1975) Bull. Seism.
/// Soc. Am. 65(3):581-626; Rathje, Abrahamson, Bray (1998) J. Geotech. Geoenviron. Eng. 124(2):150-159.
///
/// # Example
/// ```
/// use dolmen::signal::{Component, GroundMotion, intensity_measures};
/// let motion = GroundMotion::new("step", 0.5, vec![(Component::X, vec![1.0, 1.0, 1.0])])?;
/// let measures = intensity_measures(&motion, Component::X)?;
/// assert_eq!((measures.peak_velocity_m_s, measures.peak_displacement_m), (1.0, 0.5));
/// # Ok::<(), dolmen::signal::SignalError>(())
/// ```
pub fn intensity_measures(
    motion: &GroundMotion,
    component: Component,
) -> Result<IntensityMeasures, SignalError> {
    let h = motion.time_step_s();
    let (peak, a) = moving(motion, component)?;
    let travel = Travel::of(a, h);
    let mut absolute = 0.0;
    let mut energy = vec![0.0; a.len()];
    for (i, pair) in a.windows(2).enumerate() {
        let (a0, a1) = (pair[0], pair[1]);
        absolute += if a0 * a1 < 0.0 {
            0.5 * h * (a0 * a0 + a1 * a1) / (a0 - a1).abs()
        } else {
            0.5 * h * (a0 + a1).abs()
        };
        energy[i + 1] = energy[i] + 0.5 * h * (a0 * a0 + a1 * a1);
    }
    let [from, to] = SIGNIFICANT.map(|share| reached(a, h, &energy, share));
    let periods =
        |count: usize, at: &dyn Fn(f64) -> f64| -> Vec<f64> { (0..count).map(|k| at(k as f64)).collect() };
    let housner_count = ((HOUSNER_PERIODS_S[1] - HOUSNER_PERIODS_S[0]) / HOUSNER_STEP_S).round() as usize + 1;
    let housner_periods = periods(housner_count, &|k| HOUSNER_PERIODS_S[0] + k * HOUSNER_STEP_S);
    let psv = response_spectrum(motion, component, &housner_periods, HOUSNER_DAMPING).ok();
    let housner = psv.map(|psv| {
        let pairs = psv
            .windows(2)
            .map(|two| two[0].pseudo_velocity_m_s() + two[1].pseudo_velocity_m_s());
        0.5 * HOUSNER_STEP_S * pairs.sum::<f64>()
    });
    let all = periods(200, &|k| 0.02 * 200f64.powf(k / 199.0));
    let spectrum = response_spectrum(motion, component, &all, HOUSNER_DAMPING).ok();
    let largest = spectrum.and_then(|spectrum| {
        let by_size = |one: &super::SpectralOrdinate| one.pseudo_acceleration_m_s2();
        spectrum
            .into_iter()
            .max_by(|one, other| by_size(one).total_cmp(&by_size(other)))
    });
    Ok(IntensityMeasures {
        peak_acceleration_m_s2: peak,
        peak_velocity_m_s: travel.peak_velocity,
        peak_displacement_m: travel.peak_displacement,
        last_velocity_m_s: travel.velocity,
        last_displacement_m: travel.displacement,
        arias_intensity_m_s: PI / (2.0 * STANDARD_GRAVITY_M_S2) * energy[a.len() - 1],
        cumulative_absolute_velocity_m_s: absolute,
        housner_intensity_m: housner,
        significant_duration_s: to - from,
        significant_from_s: from,
        mean_period_s: mean_period(a, h)?,
        predominant_period_s: largest.map(|one| one.period_s),
    })
}

/// The largest velocity of a component, m/s: as [`intensity_measures`], without the other measures.
///
/// # Errors
/// [`SignalError::NoMotion`] if the component does not move.
pub fn peak_velocity_m_s(motion: &GroundMotion, component: Component) -> Result<f64, SignalError> {
    let (_, a) = moving(motion, component)?;
    Ok(Travel::of(a, motion.time_step_s()).peak_velocity)
}

/// The samples of a component and its peak, which must not be zero.
fn moving(motion: &GroundMotion, component: Component) -> Result<(f64, &[f64]), SignalError> {
    let peak_m_s2 = motion.component_peak_m_s2(component);
    if peak_m_s2 == 0.0 {
        return Err(SignalError::NoMotion {
            component: component.name(),
            peak_m_s2,
        });
    }
    Ok((peak_m_s2, motion.acceleration_m_s2(component)))
}

/// Displacement of the ground at the end of a motion, and its largest displacement, m. They show whether the base line drifts.
///
/// # Errors
/// [`SignalError::NoMotion`] if the component does not move.
///
/// # Example
/// ```
/// use dolmen::signal::{Component, GroundMotion, last_and_peak_displacement_m};
/// let motion = GroundMotion::new("step", 0.5, vec![(Component::X, vec![1.0, 1.0, 1.0])])?;
/// assert_eq!(last_and_peak_displacement_m(&motion, Component::X)?, [0.5, 0.5]);
/// # Ok::<(), dolmen::signal::SignalError>(())
/// ```
pub fn last_and_peak_displacement_m(
    motion: &GroundMotion,
    component: Component,
) -> Result<[f64; 2], SignalError> {
    let (_, a) = moving(motion, component)?;
    let travel = Travel::of(a, motion.time_step_s());
    Ok([travel.displacement, travel.peak_displacement])
}

/// Final and largest velocity and displacement of an acceleration that is linear between its samples.
struct Travel {
    velocity: f64,
    displacement: f64,
    peak_velocity: f64,
    peak_displacement: f64,
}

impl Travel {
    fn of(a: &[f64], h: f64) -> Self {
        let (mut v, mut u, mut most_v, mut most_u) = (0.0_f64, 0.0_f64, 0.0_f64, 0.0_f64);
        for pair in a.windows(2) {
            let (a0, a1) = (pair[0], pair[1]);
            let s = (a1 - a0) / h;
            let at = |tau: f64| {
                let speed = v + tau * (a0 + 0.5 * s * tau);
                (speed, u + tau * (v + tau * (0.5 * a0 + s * tau / 6.0)))
            };
            if a0 * a1 < 0.0 {
                most_v = most_v.max(at(-a0 / s).0.abs());
            }
            for tau in zeros(0.5 * s, a0, v)
                .into_iter()
                .filter(|tau| (0.0..=h).contains(tau))
            {
                most_u = most_u.max(at(tau).1.abs());
            }
            (v, u) = at(h);
            most_v = most_v.max(v.abs());
            most_u = most_u.max(u.abs());
        }
        Travel {
            velocity: v,
            displacement: u,
            peak_velocity: most_v,
            peak_displacement: most_u,
        }
    }
}

/// Real zeros of p τ² + q τ + r, without loss of digits.
fn zeros(p: f64, q: f64, r: f64) -> [f64; 2] {
    let root = (q * q - 4.0 * p * r).sqrt(); // NaN if there are no zeros: comparisons are then false
    let w = -0.5 * (q + root.copysign(q));
    [w / p, r / w]
}

/// Time at which a share of the energy is reached, by bisection within a step, where a² is linear in time.
fn reached(a: &[f64], h: f64, energy: &[f64], share: f64) -> f64 {
    let wanted = share * energy[energy.len() - 1];
    let after = energy.partition_point(|e| *e < wanted).clamp(1, a.len() - 1);
    let [before, then] = [a[after - 1], a[after]].map(|a| a * a);
    let grown = |tau: f64| energy[after - 1] + tau * (before + 0.5 * tau * (then - before) / h);
    let (mut low, mut high) = (0.0, h);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if grown(middle) < wanted {
            low = middle
        } else {
            high = middle
        }
    }
    (after - 1) as f64 * h + low
}

/// Mean period: the Fourier transform is padded with zeros until its lines are close enough.
fn mean_period(a: &[f64], h: f64) -> Result<Option<f64>, SignalError> {
    let least = (1.0 / (MEAN_PERIOD_STEP_HZ * h)).ceil() as usize;
    let length = a.len().max(least);
    let transform = RealFftPlanner::<f64>::new().plan_fft_forward(length);
    let mut padded = a.to_vec();
    padded.resize(length, 0.0);
    let mut spectrum = transform.make_output_vec();
    if transform.process(&mut padded, &mut spectrum).is_err() {
        return Ok(None); // the lengths are those it asked for
    }
    let (mut weighted, mut sum) = (0.0, 0.0);
    for (k, c) in spectrum.iter().enumerate() {
        let f = k as f64 / (length as f64 * h);
        if (MEAN_PERIOD_HZ[0]..=MEAN_PERIOD_HZ[1]).contains(&f) {
            weighted += c.norm_sqr() / f;
            sum += c.norm_sqr();
        }
    }
    Ok((sum > 0.0).then_some(weighted / sum))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn measured(h: f64, a: Vec<f64>) -> IntensityMeasures {
        let motion = GroundMotion::new("test", h, vec![(Component::X, a)]).unwrap();
        intensity_measures(&motion, Component::X).unwrap()
    }

    #[test]
    fn exact_a_triangle_between_samples() {
        // a falls from 3 to −1 m/s² in 4 s: at its zero, at 3 s, v is 4.5; u(4) = ∫ = 3·4²/2 − 4³/6
        let m = measured(1.0, vec![3.0, 2.0, 1.0, 0.0, -1.0]);
        assert!((m.peak_velocity_m_s - 4.5).abs() < 1e-14 && (m.last_velocity_m_s - 4.0).abs() < 1e-14);
        assert!((m.peak_displacement_m - (24.0 - 64.0 / 6.0)).abs() < 1e-13);
        let coarse = measured(1.0, vec![0.0, 3.0, -1.0, 0.0]);
        assert!(
            (coarse.peak_velocity_m_s - (1.5 + 9.0 / 8.0)).abs() < 1e-14,
            "between samples"
        );
        assert!(
            (coarse.cumulative_absolute_velocity_m_s - (1.5 + 9.0 / 8.0 + 1.0 / 8.0 + 0.5)).abs() < 1e-14
        );
        let squares = 9.0 / 2.0 + (9.0 + 1.0) / 2.0 + 1.0 / 2.0;
        assert!((coarse.arias_intensity_m_s - PI / (2.0 * 9.80665) * squares).abs() < 1e-14);
    }

    #[test]
    fn exact_a_sine_whose_displacement_peaks_between_samples() {
        let (h, f) = (0.01, 1.7);
        let m = measured(
            h,
            (0..=1000)
                .map(|i| (2.0 * PI * f * h * f64::from(i)).sin())
                .collect(),
        );
        let omega = 2.0 * PI * f;
        assert!(
            (m.peak_velocity_m_s / (2.0 / omega) - 1.0).abs() < 1e-3,
            "1 − cos"
        );
        // the spectrum of 10 s of a sine leaks into other frequencies, and low ones have more weight
        assert!((m.mean_period_s.unwrap() * f - 1.0).abs() < 0.06, "{m:?}");
        assert!(
            (m.significant_duration_s / 9.0 - 1.0).abs() < 0.02,
            "{}",
            m.significant_duration_s
        );
        assert!((m.predominant_period_s.unwrap() * f - 1.0).abs() < 0.03);
    }

    #[test]
    fn exact_arias_intensity_of_a_sine_however_few_samples_a_period_has() {
        // A² T/2 · π/2g for whole periods
        let (amplitude, duration_s, f) = (2.5, 8.0, 5.0);
        let wanted = amplitude * amplitude * duration_s / 2.0 * PI / (2.0 * 9.80665);
        for a_period in [3, 4, 10, 40] {
            let h = 1.0 / (f * f64::from(a_period));
            let samples = (0..=40 * a_period).map(|i| amplitude * (2.0 * PI * f * h * f64::from(i)).sin());
            let m = measured(h, samples.collect());
            assert!(
                (m.arias_intensity_m_s / wanted - 1.0).abs() < 1e-12,
                "{a_period}: {m:?}"
            );
            let within_s = 1.0 / f;
            assert!(
                (m.significant_duration_s - 0.9 * duration_s).abs() < within_s,
                "{a_period}: {m:?}"
            );
        }
    }

    #[test]
    fn refuses_a_component_that_stands() {
        let motion = GroundMotion::new("test", 0.01, vec![(Component::X, vec![0.0; 9])]).unwrap();
        assert!(matches!(
            intensity_measures(&motion, Component::X),
            Err(SignalError::NoMotion { .. })
        ));
    }
}
