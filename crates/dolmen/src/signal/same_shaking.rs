//! Whether two accelerograms are the same motion: equal, scaled, inverted, cut or resampled.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | a_i, b_i | `a`, `b` | accelerations at t = i Δt | any |
//! | l | `lag` | samples by which b begins after a | – |
//! | r | `likeness` | correlation of the overlap, either sign | – |

/// Correlation above which two accelerograms are the same. Our choice: the correlation between two components of one station, or two stations
/// of one earthquake, is far lower.
pub const SAME_SHAKING: f64 = 0.999;
/// Smallest share of the energy of each accelerogram in the overlap. Our choice.
const OVERLAP_LEAST: f64 = 0.5;
/// Number of samples to either side of the peak for a first comparison, and the correlation there that leads to a full comparison. Our choice,
/// for speed only.
const NEAR_PEAK: usize = 50;
const NEAR_LIKENESS: f64 = 0.9;

/// Whether two accelerograms, each with its time step in s, are the same motion. They are if, aligned at their peaks, their correlation reaches
/// [`SAME_SHAKING`] over an overlap that holds at least half the energy of each.
///
/// ```text
/// r = |Σ a_i b_(i+l)| / √(Σ a_i² Σ b_(i+l)²),   l the lag of the peaks or a sample beside it
/// ```
///
/// The series with the smaller step is interpolated linearly at the times of the other.
///
/// # Limits
/// Copies without the peak, and filtered copies, are not recognised.
///
/// # Example
/// ```
/// use dolmen::signal::is_same_shaking;
/// let a: Vec<f64> = (0..400).map(|i| (0.1 * i as f64).sin() * (0.017 * i as f64).sin()).collect();
/// let turned_and_cut: Vec<f64> = a[20..].iter().map(|x| -0.3 * x).collect();
/// assert!(is_same_shaking((&a, 0.01), (&turned_and_cut, 0.01)));
/// let other: Vec<f64> = (0..400).map(|i| (0.13 * i as f64).sin() * (0.017 * i as f64).sin()).collect();
/// assert!(!is_same_shaking((&a, 0.01), (&other, 0.01)));
/// ```
pub fn is_same_shaking((a, a_step_s): (&[f64], f64), (b, b_step_s): (&[f64], f64)) -> bool {
    let step_s = a_step_s.max(b_step_s);
    let (a, b) = (sampled(a, a_step_s, step_s), sampled(b, b_step_s, step_s));
    let (Some(a_peak), Some(b_peak)) = (peak_at(&a), peak_at(&b)) else {
        return false;
    };
    let lags = [0, -1, 1].map(|beside| b_peak as isize - a_peak as isize + beside);
    lags.into_iter().any(|lag| {
        let near = a_peak.saturating_sub(NEAR_PEAK)..(a_peak + NEAR_PEAK).min(a.len());
        let is_near = overlap(&a[near.clone()], &b, lag + near.start as isize).likeness() >= NEAR_LIKENESS;
        is_near && {
            let all = overlap(&a, &b, lag);
            let energy = |of: &[f64]| of.iter().map(|x| x * x).sum::<f64>();
            all.likeness() >= SAME_SHAKING
                && all.of_a >= OVERLAP_LEAST * energy(&a)
                && all.of_b >= OVERLAP_LEAST * energy(&b)
        }
    })
}

#[derive(Default)]
struct Overlap {
    of_both: f64,
    of_a: f64,
    of_b: f64,
}

impl Overlap {
    fn likeness(&self) -> f64 {
        match self.of_a * self.of_b > 0.0 {
            true => self.of_both.abs() / (self.of_a.sqrt() * self.of_b.sqrt()),
            false => 0.0,
        }
    }
}

/// Sums of a_i and b_(i + lag).
fn overlap(a: &[f64], b: &[f64], lag: isize) -> Overlap {
    let first = usize::try_from(-lag).unwrap_or(0);
    let from = usize::try_from(lag).unwrap_or(0);
    let pairs = a.iter().skip(first).zip(b.iter().skip(from));
    pairs.fold(Overlap::default(), |sum, (a, b)| Overlap {
        of_both: sum.of_both + a * b,
        of_a: sum.of_a + a * a,
        of_b: sum.of_b + b * b,
    })
}

/// The series at another time step, which must not be smaller than its own.
fn sampled(of: &[f64], own_step_s: f64, step_s: f64) -> Vec<f64> {
    let ratio = step_s / own_step_s;
    if ratio == 1.0 || of.is_empty() {
        return of.to_vec();
    }
    let count = ((of.len() - 1) as f64 / ratio + 1e-9).floor() as usize + 1;
    let at = |k: usize| {
        let place = k as f64 * ratio;
        let before = (place.floor() as usize).min(of.len() - 1);
        let after = (before + 1).min(of.len() - 1);
        of[before] + (place - before as f64) * (of[after] - of[before])
    };
    (0..count).map(at).collect()
}

/// Index of the largest absolute value; `None` if all are zero.
fn peak_at(of: &[f64]) -> Option<usize> {
    let sizes = of.iter().enumerate().filter(|(_, x)| x.abs() > 0.0);
    let largest = sizes.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
    largest.map(|(at, _)| at)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;

    /// Noise that swells and fades, smooth over some samples.
    fn shaking(seed: u64, count: usize) -> Vec<f64> {
        let mut random = Random::new(seed, 0);
        let mut state = [0.0; 2];
        let each = (0..count).map(|i| {
            let next = 1.8 * state[0] - 0.88 * state[1] + random.normal();
            state = [next, state[0]];
            let along = i as f64 / count as f64;
            next * (std::f64::consts::PI * along).sin().powi(2)
        });
        each.collect()
    }

    #[test]
    fn holds_copies_are_found_and_other_motions_are_not() {
        let a = shaking(1, 3000);
        let scaled: Vec<f64> = a.iter().map(|x| -9.81 * x).collect();
        let every_other: Vec<f64> = a.iter().step_by(2).copied().collect();
        let mut late = vec![0.0; 37];
        late.extend(&a);
        for (what, copy, step_s) in [
            ("the same", &a[..], 0.01),
            ("turned over, in another unit", &scaled, 0.01),
            ("cut", &a[2..], 0.01),
            ("cut at both ends", &a[400..2600], 0.01),
            ("begun later", &late, 0.01),
            ("every other sample", &every_other, 0.02),
        ] {
            assert!(is_same_shaking((&a, 0.01), (copy, step_s)), "{what}");
            assert!(
                is_same_shaking((copy, step_s), (&a, 0.01)),
                "{what}, asked in turn"
            );
        }
        for seed in 2..40 {
            let other = shaking(seed, 3000);
            assert!(!is_same_shaking((&a, 0.01), (&other, 0.01)), "{seed}");
        }
        // the same numbers at another step are a different motion
        assert!(!is_same_shaking((&a, 0.01), (&a, 0.02)));
        // a record plus a tenth of another record: a correlation of 0.995
        for seed in 2..20 {
            let other = shaking(seed, 3000);
            let near: Vec<f64> = a.iter().zip(&other).map(|(a, b)| a + 0.1 * b).collect();
            assert!(!is_same_shaking((&a, 0.01), (&near, 0.01)), "{seed}");
        }
        assert!(!is_same_shaking((&[0.0; 5], 0.01), (&[0.0; 5], 0.01)));
        assert!(!is_same_shaking((&[], 0.01), (&a, 0.01)));
    }
}
