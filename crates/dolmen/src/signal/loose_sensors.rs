//! Finds loose sensors: the fast motion of one channel changes back and forth between two strengths, and that of no other channel does.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | s_k | `levels` | ln of the mean size of the steps of a channel in block k of time |
//! | r_k | `relative` | s_k less the median of the other channels |
//! | w | `within` | standard deviation of r about the mean of its own state |

use super::Record;
use crate::numeric::{inner, middle};

/// Length of a block of time: in seconds, and least number of samples. Our choice: a step of the cable lasts longer.
const BLOCK_S: f64 = 1.0;
const BLOCK_SAMPLES: usize = 64;
/// Fewest blocks and fewest other channels of the kind.
const BLOCKS_LEAST: usize = 60;
const OTHERS_LEAST: usize = 3;
/// Least distance of the two states, in standard deviations within a state (one normal population, halved, gives 2.7) and as a ratio of strengths; fewest
/// changes of state, since a machine that starts and stops changes it once or twice; largest share of the changes that blocks in random order would have;
/// least share of the blocks in each state; and largest change that another channel may show with this one, as a share of its logarithm. Our choice: of
/// 4470 channels of 500 simulated records, 51 of 57 loose ones were found so, and none of the others.
const APART: f64 = 4.0;
const RATIO_LEAST: f64 = 1.4;
const CHANGES_LEAST: usize = 4;
const CHANGES_OF_RANDOM: f64 = 0.5;
const SHARE_LEAST: f64 = 0.03;
const BESIDE_MOST: f64 = 0.3;
/// Largest share of equal successive samples in the strong state.
const STANDING_MOST: f64 = 0.5;
/// Order of the autoregression that takes the modes and machines of a channel away, so that only its broad-band motion remains.
const ORDER: usize = 24;

/// A channel with two states.
pub(super) struct LooseSensor {
    /// Strength of the stronger state over that of the weaker one.
    pub(super) factor: f64,
    /// Share of time of the stronger state.
    pub(super) share: f64,
    /// Number of times that it begins.
    pub(super) times: usize,
    /// Sample at which it begins first.
    pub(super) first: usize,
}

/// Strength of the steps of a channel over time.
pub(super) struct FastMotion {
    block: usize,
    levels: Vec<f64>,
}

impl FastMotion {
    /// `None` for a channel that stands still or is too short.
    pub(super) fn of(x: &[f64], rate_hz: f64) -> Option<Self> {
        let block = ((BLOCK_S * rate_hz).ceil() as usize).max(BLOCK_SAMPLES);
        (x.len() / block >= BLOCKS_LEAST).then_some(())?;
        Some(FastMotion {
            block,
            levels: levels(x, block)?,
        })
    }
}

/// Logarithm of the mean size of the steps in each block; a coarse digitiser may have none, which counts as a thousandth of the mean.
fn levels(x: &[f64], block: usize) -> Option<Vec<f64>> {
    const FAINTEST: f64 = 1e-3;
    let sizes: Vec<f64> = x
        .chunks_exact(block)
        .map(|x| x.windows(2).map(|pair| (pair[1] - pair[0]).abs()).sum::<f64>())
        .collect();
    let mean = sizes.iter().sum::<f64>() / sizes.len() as f64;
    (mean > 0.0).then(|| sizes.iter().map(|size| (size + FAINTEST * mean).ln()).collect())
}

/// Whether channel `own` of `record` is loose; `others` are the other channels of its kind. `motions` has one place per channel.
pub(super) fn loose(
    record: &Record,
    own: usize,
    others: &[usize],
    motions: &[Option<FastMotion>],
) -> Option<LooseSensor> {
    let motion = motions[own].as_ref()?;
    let others: Vec<&FastMotion> = others.iter().filter_map(|c| motions[*c].as_ref()).collect();
    if others.len() < OTHERS_LEAST {
        return None;
    }
    let states = TwoStates::of(&relative(motion, &others))?;
    let is_alone = || {
        (0..others.len()).all(|i| {
            let rest: Vec<&FastMotion> = (0..others.len()).filter(|j| *j != i).map(|j| others[j]).collect();
            states.difference(&relative(others[i], &rest)).abs() <= BESIDE_MOST * states.apart
        })
    };
    // the steps of a coarse digitiser come and go with slow motion
    let is_fine = || states.share_standing(record.samples(own), motion.block) <= STANDING_MOST;
    // a machine beside a sensor leaves its broad-band motion as it is
    let is_broad = || {
        let rest = without_modes(record.samples(own));
        levels(&rest, motion.block).is_some_and(|levels| states.difference(&levels).abs() >= RATIO_LEAST.ln())
    };
    (states.recur() && is_fine() && is_alone() && is_broad()).then(|| states.as_sensor(motion.block))
}

/// Strength in each block relative to the median of other channels.
fn relative(motion: &FastMotion, others: &[&FastMotion]) -> Vec<f64> {
    let at = |k: usize| motion.levels[k] - middle(others.iter().map(|of| of.levels[k]).collect());
    (0..motion.levels.len()).map(at).collect()
}

/// Blocks of time in two groups.
struct TwoStates {
    is_strong: Vec<bool>,
    apart: f64,
    within: f64,
}

impl TwoStates {
    /// The two groups with the least squares within them; `None` if there are none.
    fn of(relative: &[f64]) -> Option<Self> {
        let n = relative.len();
        let mut sorted = relative.to_vec();
        sorted.sort_by(f64::total_cmp);
        let sum: f64 = sorted.iter().sum();
        let mut below = 0.0;
        let (mut most, mut cut) = (0.0, 0);
        for i in 1..n {
            below += sorted[i - 1];
            let apart = (sum - below) / (n - i) as f64 - below / i as f64;
            let between = (i * (n - i)) as f64 * apart * apart;
            if between > most {
                (most, cut) = (between, i);
            }
        }
        let from = *sorted.get(cut)?;
        let mean = |group: &[f64]| group.iter().sum::<f64>() / group.len() as f64;
        let scatter = |group: &[f64]| {
            let of = mean(group);
            group.iter().map(|r| (r - of).powi(2)).sum::<f64>()
        };
        let (weak, strong) = sorted.split_at(cut);
        (!weak.is_empty()).then(|| TwoStates {
            is_strong: relative.iter().map(|r| *r >= from).collect(),
            apart: mean(strong) - mean(weak),
            within: ((scatter(weak) + scatter(strong)) / n as f64).sqrt(),
        })
    }

    /// Share of the strong blocks.
    fn share(&self) -> f64 {
        self.is_strong.iter().filter(|strong| **strong).count() as f64 / self.is_strong.len() as f64
    }

    /// Whether the groups are two states that last and come back.
    fn recur(&self) -> bool {
        let share = self.share();
        let changes = self
            .is_strong
            .windows(2)
            .filter(|pair| pair[0] != pair[1])
            .count();
        let of_random = 2.0 * share * (1.0 - share) * self.is_strong.len() as f64;
        self.apart >= APART * self.within
            && self.apart >= RATIO_LEAST.ln()
            && share.min(1.0 - share) >= SHARE_LEAST
            && changes >= CHANGES_LEAST
            && changes as f64 <= CHANGES_OF_RANDOM * of_random
    }

    /// Mean of other values in the strong blocks less that in the weak ones.
    fn difference(&self, values: &[f64]) -> f64 {
        let mean = |strong: bool| {
            let of = || {
                let pairs = values.iter().zip(&self.is_strong);
                pairs
                    .filter(move |(_, own)| **own == strong)
                    .map(|(value, _)| value)
            };
            of().sum::<f64>() / of().count() as f64
        };
        mean(true) - mean(false)
    }

    /// Share of the steps in the strong state that are zero.
    fn share_standing(&self, x: &[f64], block: usize) -> f64 {
        let (mut all, mut standing) = (0, 0);
        for (x, _) in x
            .chunks_exact(block)
            .zip(&self.is_strong)
            .filter(|(_, strong)| **strong)
        {
            all += x.len() - 1;
            standing += x.windows(2).filter(|pair| pair[0] == pair[1]).count();
        }
        standing as f64 / all.max(1) as f64
    }

    fn as_sensor(&self, block: usize) -> LooseSensor {
        let begins = |k: &usize| self.is_strong[*k] && (*k == 0 || !self.is_strong[k - 1]);
        let begun: Vec<usize> = (0..self.is_strong.len()).filter(begins).collect();
        LooseSensor {
            factor: self.apart.exp(),
            share: self.share(),
            times: begun.len(),
            first: begun.first().map_or(0, |k| k * block),
        }
    }
}

/// What the past of a signal does not predict: the remainder of the autoregression of order [`ORDER`] (Yule-Walker equations, recursion of Levinson and
/// Durbin).
fn without_modes(x: &[f64]) -> Vec<f64> {
    let n = x.len();
    let mean = x.iter().sum::<f64>() / n as f64;
    let x: Vec<f64> = x.iter().map(|x| x - mean).collect();
    let r: Vec<f64> = (0..=ORDER).map(|lag| inner(&x[lag..], &x[..n - lag])).collect();
    let mut a: Vec<f64> = Vec::with_capacity(ORDER);
    let mut rest = r[0] * (1.0 + 1e-9); // keeps the last step finite for a pure sine
    for m in 0..ORDER {
        let reflected = (r[m + 1] - (0..m).map(|i| a[i] * r[m - i]).sum::<f64>()) / rest;
        let before = a.clone();
        (0..m).for_each(|i| a[i] -= reflected * before[m - 1 - i]);
        a.push(reflected);
        rest *= (1.0 - reflected * reflected).max(f64::EPSILON);
    }
    let predicted = |t: usize| (0..ORDER).map(|i| a[i] * x[t - 1 - i]).sum::<f64>();
    (0..n)
        .map(|t| if t < ORDER { 0.0 } else { x[t] - predicted(t) })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::{Channel, ChannelFault, Record, inspect};
    use crate::numeric::Random;
    use std::f64::consts::PI;

    const RATE_HZ: f64 = 100.0;
    const LENGTH: usize = 30_000;

    /// Noise of five channels that follow a common slow motion; `of_fourth` changes the fourth: time (s), sample, new noise.
    fn faults(of_fourth: fn(f64, f64, f64) -> f64) -> Vec<ChannelFault> {
        let samples = (0..5).map(|c| {
            let mut random = Random::new(7, c);
            let mut other = Random::new(8, c);
            let each = (0..LENGTH).map(|t| {
                let at_s = t as f64 / RATE_HZ;
                let x = 3.0 * (2.0 * PI * 1.7 * at_s).sin() + 0.2 * random.normal();
                if c == 3 {
                    of_fourth(at_s, x, other.normal())
                } else {
                    x
                }
            });
            each.collect()
        });
        let channels = (1..=5).map(|c| Channel::named(format!("ch{c}"))).collect();
        inspect(&Record::new(channels, samples.collect(), RATE_HZ).unwrap())
    }

    /// Whether a second is one of those from 20 to 45, 65 to 90 and so on.
    fn is_bad(at_s: f64) -> bool {
        at_s.rem_euclid(45.0) >= 20.0
    }

    #[test]
    fn exact_a_loose_sensor_is_named_with_its_times() {
        let found = faults(|at_s, x, noise| if is_bad(at_s) { 0.3 * x + 2.0 * noise } else { x });
        let [
            ChannelFault::Loose {
                channel,
                factor,
                share,
                times,
                first_s,
            },
        ] = &found[..]
        else {
            panic!("{found:?}")
        };
        assert_eq!((channel.as_str(), *times, *first_s), ("ch4", 7, 20.0));
        // 6 spans of 25 s and one of 10 s
        assert!((share - 160.0 / 300.0).abs() < 1e-3, "{share}");
        assert!((4.0..12.0).contains(factor), "{factor}");
    }

    /// A machine beside the sensor that runs at the same times, one that runs once, and a coarse digitiser under motion that comes and goes.
    #[test]
    fn holds_other_changes_of_strength_are_none_of_it() {
        let machine = |at_s: f64, x: f64, _| match is_bad(at_s) {
            true => x + 3.0 * (2.0 * PI * 24.3 * at_s).sin(),
            false => x,
        };
        let coarse = |at_s: f64, _, noise: f64| {
            let slow = if is_bad(at_s) { 1.0 } else { 0.1 };
            (slow * (2.0 * PI * at_s).sin() + 0.05 * noise).round()
        };
        let once = |at_s: f64, x: f64, noise: f64| if at_s > 140.0 { x + 2.0 * noise } else { x };
        assert_eq!(faults(|_, x, _| x), []);
        assert_eq!(faults(machine), []);
        assert_eq!(faults(once), []);
        assert_eq!(faults(coarse), []);
    }
}
