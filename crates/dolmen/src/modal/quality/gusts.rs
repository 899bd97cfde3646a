//! Effective number of blocks for standard deviations when blocks of time have unequal power.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | w_b | `share` | share of block b in the power of the record, each channel normalised |
//! | u_b | | w_b² (1 − 2 w_b + Σ w²) |

use crate::modal::modes::Mode;
use crate::numeric::sum_of;
use crate::signal::Record;

/// Correction of standard deviations from blocks of unequal power.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Unequal {
    /// Factor on variances from the blocks; 1 if all blocks have equal power.
    pub(crate) widening: f64,
    /// Expected standard deviation from the blocks, before the widening, over that from as many blocks of equal power; at least 1.
    pub(crate) scatter: f64,
    /// Effective number of blocks with equal power, at least 2.
    pub(crate) time_blocks: usize,
}

/// Variances from the scatter of blocks with unequal power.
///
/// ```text
/// x = Σ w_b x_b,   E Σ w_b² (x_b − x)² = σ² Σ u_b,   var x = σ² Σ w²:      widening = (b−1)/b Σ w² / Σ u,   ν = (Σ u)² / Σ u² − 1
/// scatter² = b²/(b−1) Σ u        1 for equal blocks, with u = (b−1)/b³
/// ```
/// Few strong blocks scatter more than the duration of the record explains.
///
/// A single strong block determines the mean, so its deviation is nearly zero: without this correction the results of a gusty record would
/// look far too accurate. For stationary records the widening is 1.00 to 1.02.
///
/// # Source
/// Satterthwaite (1946) Biom. Bull. 2:110-114 for ν. The expectation is our own derivation.
pub(crate) fn unequal(record: &Record, time_blocks: usize) -> Unequal {
    let length = record.length() / time_blocks.max(1);
    let mut share = vec![0.0; time_blocks];
    for c in 0..record.channels().len() {
        let samples = record.samples(c);
        let mean = record.mean(c);
        let power = |part: &[f64]| sum_of(part, |y| (y - mean) * (y - mean));
        let whole = power(samples).max(f64::MIN_POSITIVE);
        for (share, part) in share.iter_mut().zip(samples.chunks_exact(length.max(1))) {
            *share += power(part) / whole;
        }
    }
    let sum: f64 = share.iter().sum();
    of_shares(share.into_iter().map(|w| w / sum.max(f64::MIN_POSITIVE)))
}

fn of_shares(share: impl Iterator<Item = f64> + Clone) -> Unequal {
    let count = share.clone().count() as f64;
    let square: f64 = share.clone().map(|w| w * w).sum();
    let u = share.map(|w| w * w * (1.0 - 2.0 * w + square));
    let (first, second) = (u.clone().sum::<f64>(), u.map(|u| u * u).sum::<f64>());
    if count < 2.0 || first <= 0.0 || second <= 0.0 {
        return Unequal {
            widening: 1.0,
            scatter: 1.0,
            time_blocks: count as usize,
        };
    }
    Unequal {
        widening: (count - 1.0) / count * square / first,
        scatter: (count * count / (count - 1.0) * first).sqrt().max(1.0),
        time_blocks: ((first * first / second).floor() as usize).max(2),
    }
}

/// Increases every deviation that comes from the blocks.
pub(crate) fn widen<'a>(modes: impl IntoIterator<Item = &'a mut Mode>, widening: f64) {
    let by = widening.max(1.0).sqrt();
    for mode in modes {
        mode.frequency_sd_hz = mode.frequency_sd_hz.map(|sd| by * sd);
        mode.damping_ratio_sd = mode.damping_ratio_sd.map(|sd| by * sd);
        mode.frequency_changes_hz.iter_mut().for_each(|d| *d *= by);
        for sd in mode.shape_sd.iter_mut().flatten() {
            *sd *= by;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;
    use crate::signal::Channel;

    #[test]
    fn exact_equal_blocks_need_no_widening() {
        let found = of_shares([0.1; 10].into_iter());
        assert!((found.widening - 1.0).abs() < 1e-12, "{found:?}");
        assert!((found.scatter - 1.0).abs() < 1e-12, "{found:?}");
        assert_eq!(found.time_blocks, 10);
    }

    #[test]
    fn exact_widened_scatter_of_weighted_means_by_draws() {
        // nine weak blocks and a strong one
        let mut share = [0.05; 10];
        share[3] = 0.55;
        let Unequal {
            widening, scatter, ..
        } = of_shares(share.into_iter());
        let mut random = Random::new(5, 0);
        let (mut true_variance, mut stated) = (0.0, 0.0);
        for _ in 0..20_000 {
            let x = [(); 10].map(|()| random.normal());
            let mean: f64 = x.iter().zip(share).map(|(x, w)| w * x).sum();
            true_variance += mean * mean;
            let parts = x.iter().zip(share).map(|(x, w)| (w * (x - mean)).powi(2));
            stated += 10.0 / 9.0 * parts.sum::<f64>();
        }
        assert!(
            (widening * stated / true_variance - 1.0).abs() < 0.05,
            "{widening} {}",
            true_variance / stated
        );
        assert!(widening > 2.0, "{widening}");
        // of ten equal blocks the variance is 1/10
        let of_equal = 10.0 * stated / 20_000.0;
        assert!(
            (scatter * scatter / of_equal - 1.0).abs() < 0.05,
            "{scatter} {of_equal}"
        );
    }

    #[test]
    fn holds_gusts_leave_few_blocks_and_steady_noise_all() {
        let record = |gust: fn(usize) -> f64| {
            let mut random = Random::new(3, 0);
            let samples = (0..60_000).map(|t| gust(t) * random.normal()).collect();
            Record::new(vec![Channel::named("a")], vec![samples], 100.0).unwrap()
        };
        let steady = unequal(&record(|_| 1.0), 30);
        assert!(steady.time_blocks >= 29 && steady.widening < 1.01, "{steady:?}");
        let gusts = unequal(&record(|t| if t / 2000 % 10 == 0 { 5.0 } else { 0.5 }), 30);
        assert!(gusts.time_blocks <= 4 && gusts.widening > 1.3, "{gusts:?}");
    }
}
