//! Distinguishes modes from machines of variable amplitude or speed: random forces change a motion equally in phase with it and in quadrature.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | a_s | `motion` | complex amplitude of part s of the record at the frequency |
//! | ρ | `rho` | Σ a_(s+1) a_s* / Σ |a_s|², over [`RUN`] parts |
//! | w_s | | new motion in part s + 1: a_(s+1) − ρ a_s |
//! | ψ_s | | angle of w_s relative to ρ a_s |
//! | R | `along` | mean cos 2ψ |

use super::harmonics::{Parts, along_the_strongest, fourier_sums};
use crate::modal::ModalError;
use crate::signal::Record;
use dolmen_linalg::Complex64;
use std::f64::consts::TAU;

/// Fewest and most parts of the record. Our choice: fewer parts allow no conclusion, and more would be shorter than the required cycles.
const PARTS: [usize; 2] = [64, 2048];
/// Fewest cycles in a part: the band then extends an eighth to either side.
const CYCLES_LEAST: f64 = 16.0;
/// Number of parts with a common ρ: within them, temperature and amplitude hardly change the frequency. Our choice.
const RUN: usize = 32;
/// Distance from zero, in standard deviations, that indicates a machine. Our choice: chance gives one in a million modes.
const DEVIATIONS: f64 = 5.0;

/// Whether the motion near a frequency changes equally in amplitude and in phase.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wander {
    /// Middle of the band, Hz.
    pub frequency_hz: f64,
    /// 0 if amplitude and phase change equally, as under random forces; 1 if only the amplitude changes, −1 if only the phase changes.
    pub along: f64,
    /// Its standard deviation under random forces.
    pub deviation: f64,
}

impl Wander {
    /// Whether random forces cannot be the cause: five standard deviations from 0.
    pub fn is_machine(&self) -> bool {
        self.beyond() > DEVIATIONS
    }

    pub(super) fn beyond(&self) -> f64 {
        self.along.abs() / self.deviation
    }
}

impl std::fmt::Display for Wander {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Wander {
            frequency_hz,
            along,
            deviation,
        } = self;
        write!(f, "{frequency_hz:.3} Hz ({along:+.2} ± {deviation:.2})")
    }
}

/// Change of the motion near a frequency from one part of the record to the next, at the given channels in the direction of the largest motion;
/// `None` if the record is too short.
///
/// ```text
/// w_s = a_(s+1) − ρ a_s,   R = mean cos 2 arg(w_s (ρ a_s)*),   sd R = 1/√(2n)
/// ```
/// Under Gaussian forces a is circular for any spectrum and any slow variation of their intensity: w and a are independent, and ψ is uniform on the
/// circle. A machine changes its phase more than its amplitude (R < 0), or the reverse (R > 0), however slowly. The length of the parts decreases
/// by half from 1/64 of the record down to 16 cycles; the value farthest from 0 is used.
///
/// # Errors
/// [`ModalError::Linalg`].
///
/// # Limits
/// For a constant sine w is only noise. A machine that changes phase and amplitude equally looks like a mode: R = 0.
pub(super) fn wander(
    record: &Record,
    channels: &[usize],
    frequency_hz: f64,
) -> Result<Option<Wander>, ModalError> {
    let rate_hz = record.sampling_rate_hz();
    let mut furthest: Option<Wander> = None;
    let mut count = PARTS[0];
    while count <= PARTS[1] && (record.length() / count) as f64 >= CYCLES_LEAST * rate_hz / frequency_hz {
        let length = record.length() / count;
        let parts = Parts {
            length,
            halves: 2,
            count,
        };
        let sums = fourier_sums(record, channels, frequency_hz, parts);
        let turn = Complex64::from_polar(1.0, -TAU * frequency_hz * length as f64 / rate_hz);
        let along = along_the_strongest(&sums)?.into_iter();
        let motion: Vec<Complex64> = along.enumerate().map(|(s, a)| a * turn.powu(s as u32)).collect();
        let found = of_motion(&motion, frequency_hz);
        if found.along.is_finite() && furthest.is_none_or(|best| found.beyond() > best.beyond()) {
            furthest = Some(found);
        }
        count *= 2;
    }
    Ok(furthest)
}

fn of_motion(motion: &[Complex64], frequency_hz: f64) -> Wander {
    let cosines = motion.chunks_exact(RUN).flat_map(|run| {
        let power: f64 = run[..RUN - 1].iter().map(|a| a.norm_sqr()).sum();
        let follows: Complex64 = run.windows(2).map(|pair| pair[1] * pair[0].conj()).sum();
        let rho = follows / power.max(f64::MIN_POSITIVE);
        let cosine = move |pair: &[Complex64]| {
            let before = rho * pair[0];
            let against = (pair[1] - before) * before.conj();
            (against * against).re / against.norm_sqr()
        };
        run.windows(2).map(cosine)
    });
    let cosines: Vec<f64> = cosines.collect();
    let count = cosines.len() as f64;
    Wander {
        frequency_hz,
        along: cosines.iter().sum::<f64>() / count,
        deviation: (0.5 / count).sqrt(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::{Harmonics, Identify, MadeMode, MadeRecord, ModalAnalysis, Note, identify};
    use crate::numeric::Random;
    use std::f64::consts::PI;

    /// A slowly varying quantity with unit mean square; it varies over this number of steps.
    fn slow(random: &mut Random, length: usize, steps: f64) -> Vec<f64> {
        let rho = (-1.0 / steps).exp();
        let (mut fast, mut smooth) = (0.0, 0.0);
        let of: Vec<f64> = (0..length)
            .map(|_| {
                fast = rho * fast + (1.0 - rho * rho).sqrt() * random.normal();
                smooth = rho * smooth + (1.0 - rho) * fast;
                smooth
            })
            .collect();
        let size = (of.iter().map(|x| x * x).sum::<f64>() / length as f64).sqrt();
        of.iter().map(|x| x / size).collect()
    }

    #[test]
    fn exact_random_motion_changes_in_all_directions_alike_and_machines_in_one() {
        const COUNT: usize = 1024;
        let mut random = Random::new(4, 0);
        // a circular process with two time constants and a gust, which no single mode under stationary forces produces
        let mut a = [Complex64::ZERO; 2];
        let mut next = |s: usize| {
            let mut normal = || Complex64::new(random.normal(), random.normal());
            a = [0.97 * a[0] + normal(), 0.6 * a[1] + 2.0 * normal()];
            let gust = if s % 200 < 60 { 3.0 } else { 1.0 };
            gust * (a[0] + a[1]) * Complex64::from_polar(1.0, 0.3 * s as f64)
        };
        let random_motion: Vec<Complex64> = (0..COUNT).map(&mut next).collect();
        let found = of_motion(&random_motion, 1.0);
        assert!(found.beyond() < 3.0 && !found.is_machine(), "{found:?}");
        // 32 runs of 31 steps
        assert!((found.deviation - (0.5_f64 / 992.0).sqrt()).abs() < 1e-12);
        let wandering = slow(&mut random, COUNT, 20.0);
        let polar = |(size, phase): (f64, f64)| Complex64::from_polar(size, phase);
        let in_speed: Vec<Complex64> = wandering.iter().map(|x| polar((1.0, 2.0 * x))).collect();
        let found = of_motion(&in_speed, 1.0);
        assert!(found.along < -0.8 && found.is_machine(), "{found:?}");
        let in_strength: Vec<Complex64> = wandering.iter().map(|x| polar((1.0 + 0.2 * x, 0.7))).collect();
        let found = of_motion(&in_strength, 1.0);
        assert!(found.along > 0.99 && found.is_machine(), "{found:?}");
    }

    /// Four sensors, half an hour: modes at 1.1, 4.9 and 8.3 Hz, and a machine at 3.5 Hz with `strength` times the total motion. Its amplitude
    /// varies by half within 20 s; its phase drifts randomly, with the bandwidth of a mode with 0.06 % damping.
    fn with_a_machine(strength: f64, seed: u64, options: &Identify) -> ModalAnalysis {
        const HALF_WIDTH_HZ: f64 = 0.002;
        let shapes = [
            [0.3, 0.6, 0.85, 1.0],
            [0.9, 0.8, -0.2, -1.0],
            [1.0, -0.6, -0.6, 1.0],
        ];
        let mode = |((frequency_hz, damping_ratio), shape): ((f64, f64), [f64; 4])| MadeMode {
            frequency_hz,
            damping_ratio,
            shape: shape.to_vec(),
        };
        let modes = [(1.1, 0.015), (4.9, 0.012), (8.3, 0.01)];
        let made = MadeRecord {
            modes: modes.into_iter().zip(shapes).map(mode).collect(),
            duration_s: 1800.0,
            seed,
            ..MadeRecord::default()
        };
        let record = made.make().unwrap();
        let (length, step_s) = (record.length(), 1.0 / record.sampling_rate_hz());
        let mut random = Random::new(seed, 777);
        let sizes = slow(&mut random, length, 20.0 / step_s);
        let mut phase = 0.0;
        let motor = |size: &f64| {
            phase += 2.0 * PI * 3.5 * step_s + (4.0 * PI * HALF_WIDTH_HZ * step_s).sqrt() * random.normal();
            (1.0 + 0.5 * size) * 2_f64.sqrt() * phase.sin()
        };
        let motor: Vec<f64> = sizes.iter().map(motor).collect();
        let top = record.samples(3);
        let spread = (top.iter().map(|y| y * y).sum::<f64>() / length as f64).sqrt();
        let seen = [0.4, 0.7, 0.8, 1.0].map(|share| share * strength * spread);
        let of = |(c, share): (usize, f64)| -> Vec<f64> {
            let both = record.samples(c).iter().zip(&motor);
            both.map(|(y, m)| y + share * m).collect()
        };
        let samples = seen.into_iter().enumerate().map(of).collect();
        let record = Record::new(record.channels().to_vec(), samples, 1.0 / step_s).unwrap();
        identify(&record, options).unwrap()
    }

    fn wandering(found: &ModalAnalysis) -> Vec<(f64, bool)> {
        let each = found.notes.iter().filter_map(|note| match note {
            Note::Wandering { machines, removed } => Some(
                machines
                    .iter()
                    .map(|of| (of.frequency_hz, *removed))
                    .collect::<Vec<_>>(),
            ),
            _ => None,
        });
        each.flatten().collect()
    }

    #[test]
    fn holds_a_machine_whose_strength_and_speed_wander_is_no_mode() {
        let mut count = 0;
        for seed in 0..6 {
            let found = with_a_machine(0.3, seed, &Identify::default());
            let [(machine_hz, true)] = wandering(&found)[..] else {
                // a machine within five standard deviations is kept, with the note that its damping is unusually low
                let is_light = |note: &Note| matches!(note, Note::LightModes { .. });
                assert!(found.notes.iter().any(is_light), "{seed}: {:?}", found.notes);
                continue;
            };
            count += 1;
            assert!((machine_hz - 3.5).abs() < 0.01, "{machine_hz}");
            assert!(found.modes.nearest(3.5, 0.07).is_err());
            for hz in [1.1, 4.9, 8.3] {
                found.modes.nearest(hz, 0.02 * hz).unwrap();
            }
        }
        assert!(count >= 4, "{count} of 6");
        // a user who allows such damping gets the mode, with a note
        let mut admitting = Identify::default();
        admitting.criteria.damping_ratio_least = Some(0.0001);
        let found = with_a_machine(0.3, 0, &admitting);
        assert!(matches!(wandering(&found)[..], [(_, false)]), "{:?}", found.notes);
        assert!(found.modes.nearest(3.5, 0.07).unwrap().harmonic());
        admitting.harmonics = Harmonics::Remove;
        let found = with_a_machine(0.3, 0, &admitting);
        assert!(found.modes.nearest(3.5, 0.07).is_err());
    }

    #[test]
    fn holds_modes_of_random_forces_are_left_alone() {
        for seed in 100..104 {
            let found = with_a_machine(0.0, seed, &Identify::default());
            assert_eq!(found.modes.modes.len(), 3);
            assert_eq!(wandering(&found), []);
        }
    }
}
