//! Response spectra: the largest displacement of a linear oscillator under ground motion, exact also between samples.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | T, ω | `period_s`, `omega` | undamped period, 2π/T | s, rad/s |
//! | ζ | `damping_ratio`, `zeta` | damping ratio | – |
//! | ω_D | `omega_d` | ω √(1 − ζ²) | rad/s |
//! | h | `h` | time step of the motion | s |
//! | u, v | `u`, `v` | displacement and velocity relative to the ground | m, m/s |
//! | S_d | `displacement_m` | largest \|u\| | m |
//! | a, s | `a`, `s` | acceleration of the ground at the start of a step, its slope | m/s², m/s³ |

use super::{Component, GroundMotion, SignalError};
use crate::numeric::{Bracketing, bracketed_root};
use std::f64::consts::{PI, TAU};

/// Largest damping ratio: above it an oscillator hardly oscillates, and the closed form divides by a small √(1 − ζ²). Our choice.
const DAMPING_MOST: f64 = 0.9;
/// Shortest and longest period, in time steps of the motion. Below the shortest, one step holds more than 20 cycles, which the record does not
/// resolve; above the longest, the closed form loses digits (see Limits). Our choice.
const PERIOD_LEAST_STEPS: f64 = 0.05;
const PERIOD_MOST_STEPS: f64 = 2e4;
/// Accuracy of the time of a peak, in time steps; the error of the displacement is its square. Our choice.
const PEAK_WIDTH: f64 = 1e-9;

/// The response of one oscillator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpectralOrdinate {
    /// Undamped period T, s.
    pub period_s: f64,
    /// Damping ratio ζ.
    pub damping_ratio: f64,
    /// Largest absolute displacement relative to the ground, m: S_d, the true peak.
    pub displacement_m: f64,
    /// Time of the peak, s. It is after the end of the motion if the free oscillation reaches a larger peak.
    pub at_s: f64,
    /// Largest absolute displacement at the samples, m, as many programs and books print it.
    pub displacement_at_samples_m: f64,
}

impl SpectralOrdinate {
    /// Pseudo-velocity ω S_d, m/s.
    pub fn pseudo_velocity_m_s(&self) -> f64 {
        TAU / self.period_s * self.displacement_m
    }

    /// Pseudo-acceleration ω² S_d, m/s². Mass times this value is the largest spring force.
    pub fn pseudo_acceleration_m_s2(&self) -> f64 {
        (TAU / self.period_s).powi(2) * self.displacement_m
    }
}

/// The largest displacement of linear oscillators of given periods and one damping ratio under one component of a motion.
///
/// ```text
/// ü + 2ζω u̇ + ω² u = −a(t)        u = u̇ = 0 at the first sample
/// within a step     u = A + B τ + e^(−ζωτ) (C cos ω_D τ + D sin ω_D τ)
///                   B = −s/ω²     A = −(a + 2ζωB)/ω²     C = u_0 − A     D = (v_0 − B + ζωC)/ω_D
/// ```
/// The ground acceleration is linear between samples, so u is exact. Between the zeros of its rate, which have a closed form, the velocity is
/// monotone, so each sign change of the velocity is found. After the last sample the ground stands still; the search includes the first free
/// cycle.
///
/// # Errors
/// [`SignalError::Argument`] for a damping ratio outside 0 … 0.9; [`SignalError::Period`] for a period outside 0.05 … 20 000 time steps.
///
/// # Limits
/// The base line is used as given: an offset of the record appears at long periods. At the samples the relative error of S_d for El Centro 1940
/// is 7e-15 at T = 400 s = 20 000 steps, and smaller for shorter periods (mpmath, 40 digits). A peak between samples may lose digits in the
/// closed form: its error is up to 7e-9 at this period.
///
/// A spectrum of 200 periods of its 1560 samples takes less than 5 ms on one core.
///
/// # Source
/// Nigam, Jennings (1969) Bull. Seism. Soc. Am. 59(2):909-922, eqs 2-8. Differs from the source: the peak is also searched between samples and
/// after the end. For El Centro 1940, T = 0.1 s, ζ = 5 %, the peak at the samples is 6.4 % too low.
///
/// # Example
/// ```
/// use dolmen::signal::{Component, GroundMotion, response_spectrum};
/// // constant acceleration: u swings to twice the static a/ω²
/// let step = GroundMotion::new("step", 0.01, vec![(Component::X, vec![2.0; 200])])?;
/// let spectrum = response_spectrum(&step, Component::X, &[0.73], 0.0)?;
/// assert!((spectrum[0].pseudo_acceleration_m_s2() - 4.0).abs() < 1e-12);
/// # Ok::<(), dolmen::signal::SignalError>(())
/// ```
pub fn response_spectrum(
    motion: &GroundMotion,
    component: Component,
    periods_s: &[f64],
    damping_ratio: f64,
) -> Result<Vec<SpectralOrdinate>, SignalError> {
    if !(0.0..=DAMPING_MOST).contains(&damping_ratio) {
        return Err(SignalError::Argument {
            argument: "damping_ratio",
            given: damping_ratio,
            allowed: "0 to 0.9: is it in percent?",
        });
    }
    let h = motion.time_step_s();
    let (least_s, most_s) = (PERIOD_LEAST_STEPS * h, PERIOD_MOST_STEPS * h);
    if let Some(&given) = periods_s.iter().find(|t| !(least_s..=most_s).contains(*t)) {
        return Err(SignalError::Period {
            given,
            least_s,
            most_s,
        });
    }
    let peaks = signed_peaks(motion.acceleration_m_s2(component), h, periods_s, damping_ratio)?;
    let ordinates = periods_s
        .iter()
        .zip(peaks)
        .map(|(&period_s, peak)| SpectralOrdinate {
            period_s,
            damping_ratio,
            displacement_m: peak.displacement_m.abs(),
            at_s: peak.at_s,
            displacement_at_samples_m: peak.at_samples_m,
        });
    Ok(ordinates.collect())
}

struct Oscillator {
    zeta_omega: f64,
    omega_d: f64,
    omega_squared: f64,
}

/// The solution within one step: A, B, C, D of the closed form.
struct Step {
    mean: f64,
    slope: f64,
    cos: f64,
    sin: f64,
}

impl Oscillator {
    fn new(period_s: f64, zeta: f64) -> Self {
        let omega = TAU / period_s;
        Oscillator {
            zeta_omega: zeta * omega,
            omega_d: omega * (1.0 - zeta * zeta).sqrt(),
            omega_squared: omega * omega,
        }
    }

    /// Solution from the displacement, velocity, ground acceleration and its slope at the start of the step.
    fn step(&self, u: f64, v: f64, a: f64, s: f64) -> Step {
        let slope = -s / self.omega_squared;
        let mean = -(a + 2.0 * self.zeta_omega * slope) / self.omega_squared;
        let cos = u - mean;
        Step {
            mean,
            slope,
            cos,
            sin: (v - slope + self.zeta_omega * cos) / self.omega_d,
        }
    }

    /// e^(−ζωτ) cos ω_D τ and e^(−ζωτ) sin ω_D τ.
    fn swing(&self, tau: f64) -> [f64; 2] {
        let decay = (-self.zeta_omega * tau).exp();
        let (sin, cos) = (self.omega_d * tau).sin_cos();
        [decay * cos, decay * sin]
    }

    /// Cosine and sine part of the rate of e^(−ζωτ) (c cos ω_D τ + s sin ω_D τ).
    fn rate(&self, [c, s]: [f64; 2]) -> [f64; 2] {
        [
            self.omega_d * s - self.zeta_omega * c,
            -self.omega_d * c - self.zeta_omega * s,
        ]
    }

    fn displacement(&self, step: &Step, tau: f64, [c, s]: [f64; 2]) -> f64 {
        step.mean + step.slope * tau + step.cos * c + step.sin * s
    }

    fn velocity(&self, step: &Step, [c, s]: [f64; 2]) -> f64 {
        let [cos, sin] = self.rate([step.cos, step.sin]);
        step.slope + cos * c + sin * s
    }
}

/// Coefficients of the effect of one time step on displacement and velocity: u ← uu u + uv v + ua a + ub b, and v in the same way; a and b are
/// the ground accelerations at both ends of the step.
#[derive(Clone, Copy, Default)]
struct Advance {
    u: [f64; 4],
    v: [f64; 4],
}

impl Advance {
    /// Uses the closed form. If a step is a small part of a cycle, uses the Taylor series of u, which loses no digits there.
    ///
    /// ```text
    /// u = Σ c_n τⁿ        c_(n+2) = −(a_n + 2ζω (n + 1) c_(n+1) + ω² c_n) / ((n + 1)(n + 2))        a_0 = a, a_1 = s
    /// ```
    fn new(oscillator: &Oscillator, h: f64) -> Self {
        const SMALL: f64 = 0.5; // ωh; then 24 terms leave less than 1e-29
        const TERMS: usize = 24;
        let swing = oscillator.swing(h);
        let is_small = h * h * oscillator.omega_squared < SMALL * SMALL;
        let mut advance = Advance::default();
        for given in 0..4 {
            let [u, v, a, b] = std::array::from_fn(|k| if k == given { 1.0 } else { 0.0 });
            let s = (b - a) / h;
            if is_small {
                let mut c = [0.0; TERMS];
                (c[0], c[1]) = (u, v);
                let (mut end, mut rate, mut power) = (u + v * h, v, h);
                for n in 0..TERMS - 2 {
                    let ground = [a, s].get(n).copied().unwrap_or(0.0);
                    let (next, k) = (n as f64 + 1.0, n as f64 + 2.0);
                    let inner =
                        2.0 * oscillator.zeta_omega * next * c[n + 1] + oscillator.omega_squared * c[n];
                    c[n + 2] = -(ground + inner) / (next * k);
                    rate += k * c[n + 2] * power;
                    power *= h;
                    end += c[n + 2] * power;
                }
                (advance.u[given], advance.v[given]) = (end, rate);
            } else {
                let step = oscillator.step(u, v, a, s);
                advance.u[given] = oscillator.displacement(&step, h, swing);
                advance.v[given] = oscillator.velocity(&step, swing);
            }
        }
        advance
    }
}

/// The largest |u| so far, and its time.
#[derive(Clone, Copy, Default)]
struct Peak {
    u: f64,
    at_s: f64,
}

impl Peak {
    fn offer(&mut self, u: f64, at_s: f64) {
        if u.abs() > self.u.abs() {
            *self = Peak { u, at_s };
        }
    }
}

/// Number of oscillators stepped together: two vector registers of most processors.
const LANES: usize = 4;

/// Displacement and velocity of [`LANES`] oscillators at every sample.
struct Histories {
    u: Vec<[f64; LANES]>,
    v: Vec<[f64; LANES]>,
    /// Largest squared amplitude of ü within any step, (m/s²)².
    swing_squared: [f64; LANES],
}

/// The signed displacement with the largest absolute value, and the other fields of [`SpectralOrdinate`].
#[derive(Clone, Copy)]
pub(super) struct SignedPeak {
    pub(super) displacement_m: f64,
    pub(super) at_s: f64,
    pub(super) at_samples_m: f64,
}

/// True peaks of oscillators with these periods; the samples are h apart.
pub(super) fn signed_peaks(
    samples: &[f64],
    h: f64,
    periods_s: &[f64],
    zeta: f64,
) -> Result<Vec<SignedPeak>, SignalError> {
    let mut histories = Histories {
        u: vec![[0.0; LANES]; samples.len()],
        v: vec![[0.0; LANES]; samples.len()],
        swing_squared: [0.0; LANES],
    };
    let mut peaks = Vec::with_capacity(periods_s.len());
    for chunk in periods_s.chunks(LANES) {
        let of_lane = |lane: usize| Oscillator::new(chunk[lane.min(chunk.len() - 1)], zeta);
        let oscillators: [Oscillator; LANES] = std::array::from_fn(of_lane);
        together(samples, h, &oscillators, &mut histories);
        for (lane, oscillator) in oscillators.iter().take(chunk.len()).enumerate() {
            peaks.push(peak(samples, h, oscillator, lane, &histories)?);
        }
    }
    Ok(peaks)
}

/// Steps all lanes through the motion.
fn together(samples: &[f64], h: f64, oscillators: &[Oscillator; LANES], histories: &mut Histories) {
    let advances: [Advance; LANES] = std::array::from_fn(|lane| Advance::new(&oscillators[lane], h));
    let u_by: [[f64; LANES]; 4] = std::array::from_fn(|k| advances.map(|advance| advance.u[k]));
    let v_by: [[f64; LANES]; 4] = std::array::from_fn(|k| advances.map(|advance| advance.v[k]));
    let two_zeta_omega = std::array::from_fn(|lane| 2.0 * oscillators[lane].zeta_omega);
    let omega_squared: [f64; LANES] = std::array::from_fn(|lane| oscillators[lane].omega_squared);
    let per_omega_d: [f64; LANES] = std::array::from_fn(|lane| 1.0 / oscillators[lane].omega_d);
    let two_zeta_omega: [f64; LANES] = two_zeta_omega;
    let (mut u, mut v, mut most) = ([0.0; LANES], [0.0; LANES], [0.0_f64; LANES]);
    for (i, pair) in samples.windows(2).enumerate() {
        let (a, b) = (pair[0], pair[1]);
        let s = (b - a) / h;
        let (mut next_u, mut next_v) = ([0.0; LANES], [0.0; LANES]);
        for l in 0..LANES {
            // ü = e^(−ζωτ) (R cos ω_D τ + S sin ω_D τ): R = ü_0, S from the rate of ü_0
            let r = -a - two_zeta_omega[l] * v[l] - omega_squared[l] * u[l];
            let rate = -s - two_zeta_omega[l] * r - omega_squared[l] * v[l];
            let sine = (rate + 0.5 * two_zeta_omega[l] * r) * per_omega_d[l];
            let squared = r * r + sine * sine;
            most[l] = if squared > most[l] { squared } else { most[l] };
            next_u[l] = u_by[0][l] * u[l] + u_by[1][l] * v[l] + (u_by[2][l] * a + u_by[3][l] * b);
            next_v[l] = v_by[0][l] * u[l] + v_by[1][l] * v[l] + (v_by[2][l] * a + v_by[3][l] * b);
        }
        (u, v) = (next_u, next_v);
        histories.u[i + 1] = u;
        histories.v[i + 1] = v;
    }
    histories.swing_squared = most;
}

/// Largest |u| of one lane: at the samples, between samples where it could be larger, and in the free cycle after the end.
fn peak(
    samples: &[f64],
    h: f64,
    oscillator: &Oscillator,
    lane: usize,
    histories: &Histories,
) -> Result<SignedPeak, SignalError> {
    let mut peak = Peak::default();
    for (i, u) in histories.u.iter().enumerate() {
        if u[lane].abs() > peak.u.abs() {
            peak = Peak {
                u: u[lane],
                at_s: i as f64 * h,
            };
        }
    }
    let at_samples_m = peak.u.abs();
    // between two samples u deviates from the chord by no more than h²/8 of the largest |ü|
    let chord = h * h / 8.0;
    let most = chord * histories.swing_squared[lane].sqrt();
    for (i, pair) in histories.u.windows(2).enumerate() {
        let ends = pair[0][lane].abs().max(pair[1][lane].abs());
        if ends + most <= peak.u.abs() {
            continue;
        }
        let slope = (samples[i + 1] - samples[i]) / h;
        let step = oscillator.step(pair[0][lane], histories.v[i][lane], samples[i], slope);
        let [cos, sin] = oscillator.rate(oscillator.rate([step.cos, step.sin]));
        if ends + chord * cos.hypot(sin) > peak.u.abs() {
            within(oscillator, &step, h, i as f64 * h, &mut peak)?;
        }
    }
    // the ground stands still: a free oscillation peaks within half a damped period, and later peaks are lower
    let last = samples.len() - 1;
    let free = oscillator.step(histories.u[last][lane], histories.v[last][lane], 0.0, 0.0);
    within(
        oscillator,
        &free,
        PI / oscillator.omega_d,
        last as f64 * h,
        &mut peak,
    )?;
    Ok(SignedPeak {
        displacement_m: peak.u,
        at_s: peak.at_s,
        at_samples_m,
    })
}

/// Calls back at each extreme of u within a step of the given length, that is at each sign change of v. Between the zeros of v̇ = e^(−ζωτ) (R
/// cos ω_D τ + S sin ω_D τ), v is monotone.
fn within(
    oscillator: &Oscillator,
    step: &Step,
    length: f64,
    start_s: f64,
    peak: &mut Peak,
) -> Result<(), SignalError> {
    let velocity = |tau: f64| oscillator.velocity(step, oscillator.swing(tau));
    let [r, s] = oscillator.rate(oscillator.rate([step.cos, step.sin]));
    let half_swing = PI / oscillator.omega_d;
    let first = f64::atan2(-r, s).rem_euclid(PI) / oscillator.omega_d;
    let bracketing = Bracketing {
        width_most: PEAK_WIDTH * length,
        ..Default::default()
    };
    let (mut from, mut at_from) = (0.0, velocity(0.0));
    let mut turn = 0.0;
    while from < length {
        let to = length.min(first + turn * half_swing);
        turn += 1.0;
        if to <= from {
            continue;
        }
        let at_to = velocity(to);
        if at_from.signum() != at_to.signum() {
            let tau = bracketed_root(velocity, from, to, &bracketing)?;
            let u = oscillator.displacement(step, tau, oscillator.swing(tau));
            peak.offer(u, start_s + tau);
        }
        (from, at_from) = (to, at_to);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn motion(time_step_s: f64, samples: Vec<f64>) -> GroundMotion {
        GroundMotion::new("test", time_step_s, vec![(Component::X, samples)]).unwrap()
    }

    fn one(motion: &GroundMotion, period_s: f64, damping_ratio: f64) -> SpectralOrdinate {
        response_spectrum(motion, Component::X, &[period_s], damping_ratio).unwrap()[0]
    }

    #[test]
    fn exact_a_ramp() {
        // u = −s/ω³ (ωτ − sin ωτ) is monotone, so the peak of a ramp is at its end or in the free oscillation after it
        let (s, period_s, h) = (3.0, 0.8, 0.1);
        let omega = TAU / period_s;
        let ramp = motion(h, (0..=8).map(|i| s * h * f64::from(i)).collect());
        let end = one(&ramp, period_s, 0.0);
        // after one whole period: u = −sT/ω², v = 0
        assert!((end.displacement_m - s * period_s / omega.powi(2)).abs() < 1e-14);
        assert!((end.displacement_at_samples_m - end.displacement_m).abs() < 1e-14);
    }

    #[test]
    fn exact_the_peak_of_a_damped_step_lies_between_samples() {
        let (period_s, zeta, h) = (0.5, 0.05, 0.07);
        let held = one(&motion(h, vec![-1.0; 40]), period_s, zeta);
        let decay = (-PI * zeta / (1.0_f64 - zeta * zeta).sqrt()).exp();
        let omega = TAU / period_s;
        assert!((held.displacement_m * omega.powi(2) - (1.0 + decay)).abs() < 1e-14);
        assert!((held.at_s - PI / (omega * (1.0 - zeta * zeta).sqrt())).abs() < 1e-9);
        assert!(held.displacement_at_samples_m < held.displacement_m);
    }

    #[test]
    fn exact_a_swing_after_the_end() {
        // a pulse of one step; the record ends before the next half period: the peak of u is nearly its impulse over ω
        let (h, period_s) = (1e-3, 2.0);
        let kick = one(&motion(h, vec![0.0, 5.0, 0.0]), period_s, 0.0);
        let omega = TAU / period_s;
        assert!((kick.displacement_m / (5.0 * h / omega) - 1.0).abs() < 1e-5);
        assert!((kick.at_s - (h + period_s / 4.0)).abs() < 1e-9);
    }

    #[test]
    fn holds_long_periods_show_the_displacement_of_the_ground() {
        let (h, f) = (0.01, 1.0);
        let sine = (0..=100).map(|i| (TAU * f * h * f64::from(i)).sin()).collect();
        let far = one(&motion(h, sine), PERIOD_MOST_STEPS * h, 0.0);
        // t/(2πf) − sin(2πft)/(2πf)² at t = 1/f; linear interpolation of the sine reduces it by 3e-4, the spring by (ω/f)²/6 = 2e-4
        let ground = 1.0 / (TAU * f * f);
        assert!(
            (far.displacement_at_samples_m / ground - 1.0).abs() < 6e-4,
            "{far:?}"
        );
    }

    #[test]
    fn holds_stiff_oscillators_follow_the_ground() {
        let h = 0.01;
        let sine: Vec<f64> = (0..=200).map(|i| 3.0 * (0.1 * f64::from(i)).sin()).collect();
        let stiff = one(&motion(h, sine), 0.06 * h, 0.05);
        assert!((stiff.pseudo_acceleration_m_s2() / 3.0 - 1.0).abs() < 1e-3);
    }

    proptest! {
        #[test]
        fn holds_a_finer_step_of_the_same_motion_changes_nothing(
            samples in prop::collection::vec(-5.0..5.0, 3..30),
            period_s in 0.004..5.0,
            zeta in 0.0..0.5,
        ) {
            let h = 0.05;
            let coarse = motion(h, samples.clone());
            let fine: Vec<f64> = (0..=8 * (samples.len() - 1))
                .map(|i| {
                    let (k, part) = (i / 8, (i % 8) as f64 / 8.0);
                    let next = samples[(k + 1).min(samples.len() - 1)];
                    samples[k] + part * (next - samples[k])
                })
                .collect();
            let (coarse, fine) = (one(&coarse, period_s, zeta), one(&motion(h / 8.0, fine), period_s, zeta));
            prop_assert!((coarse.displacement_m / fine.displacement_m - 1.0).abs() < 1e-9);
            prop_assert!(fine.displacement_at_samples_m <= coarse.displacement_m * (1.0 + 1e-9));
        }
    }

    #[test]
    fn refuses_percent_and_periods_out_of_range() {
        let still = motion(0.01, vec![0.0; 5]);
        let say = |periods: &[f64], zeta: f64| {
            response_spectrum(&still, Component::X, periods, zeta)
                .unwrap_err()
                .to_string()
        };
        for zeta in [5.0, -0.01, f64::NAN] {
            let wanted = format!("damping_ratio is {zeta}, but must be 0 to 0.9: is it in percent?");
            assert_eq!(say(&[1.0], zeta), wanted);
        }
        for period in [0.0, -1.0, 1e-4, 201.0, f64::NAN, f64::INFINITY] {
            assert_eq!(
                say(&[1.0, period], 0.05),
                format!(
                    "a period of {period} s is refused: a motion with this time step tells of 0.0005 to 200 s"
                )
            );
        }
        assert_eq!(one(&still, 1.0, 0.05).displacement_m, 0.0);
    }
}
