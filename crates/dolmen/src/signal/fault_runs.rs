//! Faults in part of a channel's samples: the channel is stuck, fades, has spikes, or follows another channel.

use crate::numeric::{inner, sum_of};

/// Fewest equal samples in a row that count as a fault, and shortest duration, of one second. Our choice.
const STUCK_LEAST: usize = 50;
const STUCK_S: f64 = 1.0;
/// Factor by which a run must exceed the average run of the channel, because a coarse digitiser also repeats one value in quiet hours. Our
/// choice: among a million runs that end by chance, the longest is 14 times the mean. Then the factor by which the run must exceed its
/// neighbours: at the crest of a slow wave this factor is 2.4.
const STUCK_RUNS: usize = 20;
const STUCK_BESIDE: usize = 5;
/// Largest motion, in digitiser steps, at which a channel may repeat one value in quiet time; and the least fraction of the record that such a
/// run must fill to count as a fault. Our choice.
const COARSE_STEPS: f64 = 4.0;
const COARSE_SHARE: f64 = 0.2;
/// Number of blocks in which strength is compared, fewest other channels, and smallest change that counts as a fault. Our choice.
const FADED_BLOCKS: usize = 10;
const FADED_OTHERS: usize = 2;
const FADED_FROM: f64 = 10.0;
/// Smallest rise over the record that counts as a fault, in standard deviations of the motion. Our choice.
const DRIFT_FROM: f64 = 10.0;
/// Number of samples compared between channels, and the limit of 1 − correlation of their steps. Below this limit two channels are the same
/// signal with 1 % noise. Our choice.
const ALIKE_SAMPLES: usize = 16_384;
const ALIKE_MOST: f64 = 1e-4;
/// A sample is a spike if its distance from the mean of its neighbours exceeds the usual distance by this factor; and the number of samples
/// needed to know the usual distance. Our choice.
const SPIKE_FROM: f64 = 25.0;
const SPIKE_SAMPLES: usize = 65_536;
/// Standard deviation of a normal variable over the median of its absolute value.
const NORMAL_MEDIAN: f64 = 1.482_602_218_505_602;

/// First sample of the longest run of one value and the sample after it, unless chance explains the run.
pub(super) fn stuck(x: &[f64], rate_hz: f64) -> Option<[usize; 2]> {
    let (mut runs, mut begin, mut longest) = (1, 0, [0, 0]);
    let (mut before, mut beside) = (0, 0);
    for i in 1..=x.len() {
        if i < x.len() && x[i] == x[i - 1] {
            continue;
        }
        if begin == longest[1] {
            beside = beside.max(i - begin); // the second longest run
        }
        if i - begin > longest[1] - longest[0] {
            (longest, beside) = ([begin, i], before);
        }
        (before, begin) = (i - begin, i);
        runs += usize::from(i < x.len());
    }
    let length = longest[1] - longest[0];
    let wanted = STUCK_LEAST.max((STUCK_S * rate_hz).ceil() as usize);
    // without the longest run: in a channel that is dead most of the time it would dominate the mean
    let others = (x.len() - length) / (runs - 1).max(1);
    let least = wanted.max(STUCK_RUNS * others.max(1)).max(STUCK_BESIDE * beside);
    let is_long = || length >= (COARSE_SHARE * x.len() as f64) as usize || !is_coarse(x);
    (runs > 1 && length >= least && is_long()).then_some(longest)
}

/// Whether the digitiser step is so coarse that quiet motion stays at one value.
fn is_coarse(x: &[f64]) -> bool {
    let steps = x
        .windows(2)
        .map(|pair| (pair[1] - pair[0]).abs())
        .filter(|step| *step > 0.0);
    let least = steps.fold(f64::INFINITY, f64::min);
    let n = x.len().max(1) as f64;
    let mean = x.iter().sum::<f64>() / n;
    let square = x.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / n;
    COARSE_STEPS * least >= square.sqrt()
}

pub(super) struct StrengthChange {
    pub(super) factor: f64,
    pub(super) from: usize,
    pub(super) to: usize,
}

/// Number of largest steps left out of each block, because a spike or a knock causes them. Our choice.
const FADED_LEAVES_OUT: usize = 100;

/// Strength of a channel in each block of time.
pub(super) struct BlockStrengths {
    block: usize,
    strengths: [f64; FADED_BLOCKS],
}

impl BlockStrengths {
    /// `None` for a record that is too short.
    pub(super) fn of(x: &[f64]) -> Option<Self> {
        let block = x.len() / FADED_BLOCKS;
        if block < STUCK_LEAST {
            return None;
        }
        let mut squares = Vec::with_capacity(block);
        let strengths = std::array::from_fn(|k| {
            let steps = x[k * block..(k + 1) * block].windows(2);
            squares.clear();
            squares.extend(steps.map(|pair| (pair[1] - pair[0]).powi(2)));
            let kept = squares.len() - squares.len() / FADED_LEAVES_OUT - 1;
            squares.select_nth_unstable_by(kept, f64::total_cmp);
            let usual: f64 = squares[..=kept].iter().sum();
            let all = || squares.iter().sum::<f64>();
            // a coarse digitiser may rarely change its value
            if usual > 0.0 { usual.sqrt() } else { all().sqrt() }
        });
        Some(Self { block, strengths })
    }
}

/// Compares the steps of the channel with the median of the other channels, block by block.
pub(super) fn faded(x: &BlockStrengths, others: &[&BlockStrengths]) -> Option<StrengthChange> {
    if others.len() < FADED_OTHERS {
        return None;
    }
    let block = x.block;
    let (mut most, mut least, mut at) = (0.0_f64, f64::INFINITY, 0);
    for k in 0..FADED_BLOCKS {
        let mut beside: Vec<f64> = others.iter().map(|other| other.strengths[k]).collect();
        beside.sort_by(f64::total_cmp);
        let median = 0.5 * (beside[(beside.len() - 1) / 2] + beside[beside.len() / 2]);
        if median <= 0.0 {
            return None;
        }
        let own = x.strengths[k] / median;
        most = most.max(own);
        if own < least {
            (least, at) = (own, k);
        }
    }
    (most >= FADED_FROM * least).then(|| StrengthChange {
        factor: most / least,
        from: at * block,
        to: (at + 1) * block,
    })
}

/// Samples that are summed together: they stay in the first cache.
const AT_ONCE: usize = 512;

/// Rise of the line through a channel over the record, in standard deviations about it, if it exceeds the motion.
pub(super) fn drifts(x: &[f64]) -> Option<f64> {
    let n = x.len() as f64;
    let (middle, mean) = (0.5 * (n - 1.0), sum_of(x, |x| x) / n);
    let xx = sum_of(x, |x| (x - mean) * (x - mean));
    let times: [f64; AT_ONCE] = std::array::from_fn(|i| i as f64);
    let mut tx = 0.0;
    for (k, part) in x.chunks(AT_ONCE).enumerate() {
        let begins = (k * AT_ONCE) as f64 - middle;
        let along = sum_of(part, |x| x - mean);
        tx += begins * along + inner(part, &times[..part.len()]) - mean * sum_of(&times[..part.len()], |t| t);
    }
    let tt = n * (n * n - 1.0) / 12.0;
    let left = (xx - tx * tx / tt).max(0.0) / n;
    let rise = (tx / tt * n).abs() / left.sqrt();
    (rise >= DRIFT_FROM).then_some(rise)
}

/// The first steps of a channel from sample to sample, and the sum of their squares.
pub(super) struct FirstSteps {
    steps: Vec<f64>,
    square: f64,
}

impl FirstSteps {
    pub(super) fn of(x: &[f64]) -> Self {
        let most = x.len().min(ALIKE_SAMPLES);
        let steps: Vec<f64> = x[..most].windows(2).map(|pair| pair[1] - pair[0]).collect();
        FirstSteps {
            square: inner(&steps, &steps),
            steps,
        }
    }
}

/// Correlation of the steps of two channels if they are almost the same signal.
pub(super) fn alike(a: &FirstSteps, b: &FirstSteps) -> Option<f64> {
    let correlation = inner(&a.steps, &b.steps) / (a.square * b.square).sqrt();
    (1.0 - correlation.abs() < ALIKE_MOST).then_some(correlation)
}

pub(super) struct Spikes {
    pub(super) count: usize,
    pub(super) first: usize,
}

/// d_i = x_i − (x_{i−1} + x_{i+1})/2: a single spike changes d of each neighbour by minus half its height, and no other d.
pub(super) fn spikes(x: &[f64]) -> Option<Spikes> {
    let out = |i: usize| x[i] - 0.5 * (x[i - 1] + x[i + 1]);
    let last = x.len().checked_sub(2).filter(|last| *last > 2)?;
    let stride = (x.len() / SPIKE_SAMPLES).max(1);
    let mut usual: Vec<f64> = (1..=last).step_by(stride).map(|i| out(i).abs()).collect();
    let middle = usual.len() / 2;
    let (_, median, _) = usual.select_nth_unstable_by(middle, f64::total_cmp);
    let bound = SPIKE_FROM * NORMAL_MEDIAN * *median;
    if bound <= 0.0 {
        return None; // more than half of the samples lie on straight lines: the digitiser is too coarse
    }
    let mut found: Option<Spikes> = None;
    for i in 3..last.saturating_sub(1) {
        let own = out(i).abs();
        let alone = || {
            let beside = [i - 1, i + 1].map(|k| -out(k) / out(i));
            let beyond = [i - 2, i + 2].map(|k| (out(k) / out(i)).abs());
            beside.iter().all(|share| (0.35..0.65).contains(share)) && beyond.iter().all(|share| *share < 0.3)
        };
        if own > bound && alone() {
            match &mut found {
                Some(spikes) => spikes.count += 1,
                None => found = Some(Spikes { count: 1, first: i }),
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;

    fn noise(seed: u64, samples: usize) -> Vec<f64> {
        let mut random = Random::new(seed, 0);
        (0..samples).map(|_| random.normal()).collect()
    }

    #[test]
    fn exact_where_a_channel_stood() {
        let mut x = noise(1, 6000);
        x[2000..2500].fill(0.25);
        assert_eq!(stuck(&x, 100.0), Some([2000, 2500]));
        // a run up to the end is a fault; a run shorter than a second is not
        x[2000..].fill(0.0);
        assert_eq!(stuck(&x, 100.0), Some([2000, 6000]));
        let mut short = noise(2, 6000);
        short[100..190].fill(1.0);
        assert_eq!(stuck(&short, 100.0), None);
        // a coarse digitiser repeats one value for long in quiet hours
        let coarse: Vec<f64> = (0..60_000)
            .map(|i| (1.4 * (0.002 * f64::from(i)).sin()).round())
            .collect();
        assert_eq!(stuck(&coarse, 100.0), None);
    }

    fn faded_beside(x: &[f64], others: [&[f64]; 2]) -> Option<StrengthChange> {
        let [own, a, b] = [x, others[0], others[1]].map(|x| BlockStrengths::of(x).unwrap());
        faded(&own, &[&a, &b])
    }

    #[test]
    fn exact_which_block_faded() {
        let (a, b) = (noise(3, 10_000), noise(4, 10_000));
        let mut x = noise(5, 10_000);
        assert!(faded_beside(&x, [&a, &b]).is_none());
        // one knock is not a loose contact
        x[7500] += 900.0;
        assert!(faded_beside(&x, [&a, &b]).is_none());
        assert!(faded_beside(&a, [&x, &b]).is_none());
        x[7500] -= 900.0;
        x[7000..8000].iter_mut().for_each(|x| *x *= 0.02);
        let found = faded_beside(&x, [&a, &b]).unwrap();
        assert_eq!((found.from, found.to), (7000, 8000));
        assert!((found.factor / 50.0 - 1.0).abs() < 0.2, "{}", found.factor);
        // all channels fade together because the wind dropped
        let all: Vec<Vec<f64>> = [3, 4, 5]
            .map(|seed| {
                noise(seed, 10_000)
                    .iter()
                    .enumerate()
                    .map(|(i, x)| x / (1.0 + i as f64 / 500.0))
                    .collect()
            })
            .to_vec();
        assert!(faded_beside(&all[0], [&all[1], &all[2]]).is_none());
    }

    #[test]
    fn exact_two_channels_are_one_down_to_noise_of_a_hundredth() {
        let (a, own) = (noise(6, 9000), noise(7, 9000));
        let with =
            |share: f64| -> Vec<f64> { a.iter().zip(&own).map(|(a, n)| -3.0 * (a + share * n)).collect() };
        let alike = |a: &[f64], b: &[f64]| super::alike(&FirstSteps::of(a), &FirstSteps::of(b));
        // 1 − r = share²/2
        let r = alike(&a, &with(0.005)).unwrap();
        assert!(((1.0 + r) / (0.5 * 0.005_f64.powi(2)) - 1.0).abs() < 0.1, "{r}");
        assert_eq!(alike(&a, &with(0.02)), None);
        assert_eq!(alike(&a, &own), None);
    }

    #[test]
    fn exact_rise_of_a_drifting_channel() {
        let mut x = noise(10, 20_000);
        assert_eq!(drifts(&x), None);
        x.iter_mut()
            .enumerate()
            .for_each(|(i, x)| *x = 0.5 * *x - 15.0 * i as f64 / 20_000.0 + 3.0);
        assert!(
            (drifts(&x).unwrap() / 30.0 - 1.0).abs() < 0.02,
            "{:?}",
            drifts(&x)
        );
    }

    #[test]
    fn exact_number_of_spikes() {
        let mut x = noise(8, 20_000);
        assert!(spikes(&x).is_none());
        for k in 1..=7 {
            x[2000 * k + 31 * k] += 60.0;
        }
        let found = spikes(&x).unwrap();
        assert_eq!((found.count, found.first), (7, 2031));
        // a burst, a step and a sine are not spikes
        let mut burst = noise(9, 20_000);
        for (i, x) in burst[5000..5200].iter_mut().enumerate() {
            *x += 80.0 * (1.9 * i as f64).sin() * (-0.05 * i as f64).exp();
        }
        burst[9000..].iter_mut().for_each(|x| *x += 90.0);
        assert!(spikes(&burst).is_none());
    }
}
