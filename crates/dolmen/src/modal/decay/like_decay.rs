//! Recognises free decays among records that are analysed as ambient vibration: one from beginning to end, or one after each blow.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | P | `Energy::power` | mean square of all channels over a span, each channel with unit variance |
//! | w | `window` | samples before and after a time that are compared to find a blow |

use super::era::{Era, FreeDecay, era};
use crate::modal::Mode;
use crate::numeric::sum_of;
use crate::signal::{Record, cut};

/// Number of equal parts of a decay, and largest ratio of the power of a part to that of the part before. Our choice: a record of ambient vibration
/// or traffic hardly ever loses power in every eighth.
const PARTS: usize = 8;
const GROWTH_MOST: f64 = 1.2;
/// Least ratio of the power of the first part to that of the last, if the decay is the whole record, and if it follows a blow. Our choice.
const FALL_LEAST: f64 = 10.0;
const FALL_AFTER_BLOW_LEAST: f64 = 4.0;
/// Least share of the motion that decaying modes explain. Our choice.
const EXPLAINED_LEAST: f64 = 0.9;
/// Windows of a record, and ratio of the power after a blow to that before it. Our choice: the power of modes under random forces grows within their
/// decay time, not at once.
const WINDOWS: usize = 400;
const WINDOW_LEAST: usize = 8;
const RISE_LEAST: f64 = 4.0;
/// A decay ends where its power has fallen by this factor: ambient vibration remains. Our choice.
const ENDS_BELOW: f64 = 30.0;
/// Largest number of blows: more are footsteps. Our choice.
const BLOWS_MOST: usize = 40;
/// Least share of the energy of the record in decays. Our choice.
const ENERGY_LEAST: f64 = 0.8;
/// Number of the strongest decays that modes must explain, to bound the time. Our choice.
const EXPLAINED: usize = 4;

/// Free decays that make up a record.
#[derive(Clone, Debug, PartialEq)]
pub struct DecaysInRecord {
    /// Least share of the motion of one decay that modes explain which all decay from its beginning.
    pub explained: f64,
    /// From and to, s from the first sample of the record; one span from beginning to end if the record is a single decay.
    pub spans_s: Vec<[f64; 2]>,
}

/// Free decays, with the modes that they show.
pub(crate) struct Decaying {
    pub(crate) decays: DecaysInRecord,
    /// The modes of the strongest decays, one decay after the other: a mode stands there once for each of them.
    pub(crate) modes: Vec<Mode>,
}

/// The free decays of a record; `None` if it is not made up of them.
///
/// # Limits
/// A blow within a louder decay, beats of two modes in all channels, and vibration that hides a decay are not recognised.
pub(crate) fn decays_in(record: &Record) -> Option<Decaying> {
    let energy = Energy::of(record);
    let whole = [0, record.length()];
    // the power of a record with one early blow falls too, but its modes do not decay from its beginning
    if energy.falls(whole, GROWTH_MOST, FALL_LEAST)
        && let Some(found) = explained(record)
    {
        return Some(Decaying {
            decays: DecaysInRecord {
                explained: found.explained,
                spans_s: vec![[0.0, record.duration_s()]],
            },
            modes: found.modes.modes,
        });
    }
    let window = (record.length() / WINDOWS).max(WINDOW_LEAST);
    let blows = energy.blows(window);
    if blows.is_empty() || blows.len() > BLOWS_MOST {
        return None;
    }
    // the record may begin within a decay
    let starts = [0].into_iter().chain(blows.iter().map(|blow| blow + window / 2));
    let ends = blows
        .iter()
        .map(|next| next.saturating_sub(window / 2))
        .chain([record.length()]);
    let mut decays: Vec<[usize; 2]> = starts
        .zip(ends)
        .map(|(start, end)| energy.until_faded([start.min(end), end], window))
        .filter(|span| energy.falls(*span, RISE_LEAST.sqrt(), FALL_AFTER_BLOW_LEAST))
        .collect();
    let held: f64 = decays.iter().map(|span| energy.sum(*span)).sum();
    let in_windows: f64 = blows
        .iter()
        .map(|blow| energy.sum([*blow, blow + window / 2]))
        .sum();
    if held + in_windows < ENERGY_LEAST * energy.sum(whole) {
        return None;
    }
    let spans_s = decays
        .iter()
        .map(|span| span.map(|at| at as f64 / record.sampling_rate_hz()));
    let spans_s: Vec<[f64; 2]> = spans_s.collect();
    decays.sort_by(|a, b| energy.sum(*b).total_cmp(&energy.sum(*a)));
    let (mut least, mut modes) = (1.0_f64, Vec::new());
    for span in decays.iter().take(EXPLAINED) {
        let [from_s, to_s] = span.map(|at| at as f64 / record.sampling_rate_hz());
        let found = explained(&cut(record.clone(), from_s, to_s).ok()?)?;
        least = least.min(found.explained);
        modes.extend(found.modes.modes);
    }
    (!decays.is_empty()).then_some(Decaying {
        decays: DecaysInRecord {
            explained: least,
            spans_s,
        },
        modes,
    })
}

/// The decaying modes, if they explain a large share of the motion.
fn explained(decay: &Record) -> Option<FreeDecay> {
    let found = era(decay, &Era::default()).ok()?;
    (found.explained >= EXPLAINED_LEAST).then_some(found)
}

/// Sum of the squares of all channels up to each sample.
struct Energy {
    until: Vec<f64>,
}

impl Energy {
    fn of(record: &Record) -> Energy {
        let mut square = vec![0.0; record.length()];
        for c in 0..record.channels().len() {
            let (samples, mean) = (record.samples(c), record.mean(c));
            let whole = sum_of(samples, |y| (y - mean) * (y - mean)).max(f64::MIN_POSITIVE);
            let squares = samples.iter().map(|y| (y - mean) * (y - mean) / whole);
            square.iter_mut().zip(squares).for_each(|(sum, own)| *sum += own);
        }
        let mut total = 0.0;
        let sums = square.into_iter().map(|of| {
            total += of;
            total
        });
        Energy {
            until: std::iter::once(0.0).chain(sums).collect(),
        }
    }

    fn sum(&self, [from, to]: [usize; 2]) -> f64 {
        let last = self.until.len() - 1;
        self.until[to.min(last)] - self.until[from.min(last)]
    }

    fn power(&self, [from, to]: [usize; 2]) -> f64 {
        self.sum([from, to]) / (to.max(from + 1) - from) as f64
    }

    /// Whether the power never grows by more than `growth_most` from an eighth of the span to the next, and falls by `fall_least` in all.
    fn falls(&self, [from, to]: [usize; 2], growth_most: f64, fall_least: f64) -> bool {
        let length = (to - from) / PARTS;
        let part = |k: usize| self.power([from + k * length, from + (k + 1) * length]);
        let power: Vec<f64> = (0..PARTS).map(part).collect();
        length > 0
            && power.windows(2).all(|pair| pair[1] <= growth_most * pair[0])
            && power[0] >= fall_least * power[PARTS - 1]
    }

    /// Samples at which the power rises at once: the steepest rise within two windows.
    fn blows(&self, window: usize) -> Vec<usize> {
        let samples = self.until.len() - 1;
        let rise = |t: usize| {
            let before = self.power([t - window, t]).max(f64::MIN_POSITIVE);
            self.power([t, t + window]) / before
        };
        let mut found: Vec<(usize, f64)> = Vec::new();
        for t in window..samples.saturating_sub(window) {
            let own = rise(t);
            if own < RISE_LEAST {
                continue;
            }
            match found.last_mut() {
                Some((at, most)) if t - *at <= 2 * window => {
                    if own > *most {
                        (*at, *most) = (t, own);
                    }
                }
                _ => found.push((t, own)),
            }
        }
        found.into_iter().map(|(at, _)| at).collect()
    }

    /// The span up to where its power has fallen by [`ENDS_BELOW`].
    fn until_faded(&self, [from, to]: [usize; 2], window: usize) -> [usize; 2] {
        let first = self.power([from, (from + window).min(to)]);
        let starts = (from..to.saturating_sub(window)).step_by(window);
        let faded = starts
            .map(|t| t + window)
            .find(|t| ENDS_BELOW * self.power([t - window, *t]) < first);
        [from, faded.unwrap_or(to)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::{MadeMode, MadeRecord};
    use crate::numeric::Random;
    use crate::signal::Channel;
    use std::f64::consts::TAU;

    #[test]
    fn holds_a_free_decay_is_recognised_and_ambient_vibration_is_not() {
        let mut random = Random::new(3, 0);
        let mut of = |shape: [f64; 2]| {
            let modes: [(f64, f64); 3] = [(1.0, 0.01), (1.03, 0.01), (3.2, 0.012)];
            let y = |t: f64| -> f64 {
                let each = modes.iter().enumerate().map(|(k, (hz, zeta))| {
                    shape[k % 2] * (-zeta * TAU * hz * t).exp() * (TAU * hz * t).cos()
                });
                each.sum()
            };
            (0..4000)
                .map(|i| y(0.01 * f64::from(i)) + 0.01 * random.normal())
                .collect()
        };
        let samples = vec![of([1.0, 0.4]), of([-0.5, 1.0])];
        let decays = Record::new(["x", "y"].map(Channel::named).to_vec(), samples, 100.0).unwrap();
        assert!(decays_in(&decays).unwrap().decays.explained > 0.99);
        let mode = |frequency_hz, shape: [f64; 2]| MadeMode {
            frequency_hz,
            damping_ratio: 0.01,
            shape: shape.to_vec(),
        };
        for seed in 0..20 {
            let made = MadeRecord {
                modes: vec![mode(1.9, [0.6, 1.0]), mode(5.3, [1.0, -0.7])],
                duration_s: 60.0,
                seed,
                ..MadeRecord::default()
            };
            let ambient = made.make().unwrap();
            assert!(decays_in(&ambient).is_none());
            // nor is a gust that dies away
            let fades = |c: usize| {
                let each = ambient.samples(c).iter().enumerate();
                each.map(|(t, y)| y * (-4.0 * t as f64 / ambient.length() as f64).exp())
                    .collect()
            };
            let rate_hz = ambient.sampling_rate_hz();
            let gust = Record::new(ambient.channels().to_vec(), vec![fades(0), fades(1)], rate_hz).unwrap();
            assert!(decays_in(&gust).is_none());
        }
    }
    #[test]
    fn holds_one_early_blow_in_a_quiet_record_is_a_decay() {
        let mut random = Random::new(5, 0);
        let modes: [(f64, f64, [f64; 2]); 3] = [
            (1.85, 0.006, [0.5, 1.0]),
            (11.25, 0.008, [-0.6, 1.0]),
            (30.84, 0.011, [0.7, 1.0]),
        ];
        let mut of = |c: usize| -> Vec<f64> {
            let y = |t: f64| -> f64 {
                let each = modes
                    .iter()
                    .map(|(hz, zeta, shape)| shape[c] * (-zeta * TAU * hz * t).exp() * (TAU * hz * t).sin());
                each.sum()
            };
            let at = |i: u32| 0.005 * f64::from(i) - 3.0;
            (0..12_000)
                .map(|i| if at(i) < 0.0 { 0.0 } else { y(at(i)) } + 1e-3 * random.normal())
                .collect()
        };
        let samples = vec![of(0), of(1)];
        let record = Record::new(["low", "high"].map(Channel::named).to_vec(), samples, 200.0).unwrap();
        // the power falls in every eighth of the whole record too
        assert!(Energy::of(&record).falls([0, record.length()], GROWTH_MOST, FALL_LEAST));
        let found = decays_in(&record).unwrap();
        let [from_s, to_s] = found.decays.spans_s[0];
        assert!(
            found.decays.spans_s.len() == 1 && (3.0..3.3).contains(&from_s) && to_s > 4.0,
            "{:?}",
            found.decays
        );
        let is_found = |(hz, ..): &(f64, f64, [f64; 2])| {
            let own = found.modes.iter();
            own.filter(|mode| (mode.frequency_hz / hz - 1.0).abs() < 1e-3)
                .count()
                == 1
        };
        assert!(modes.iter().all(is_found), "{:?}", found.modes);
    }
}
