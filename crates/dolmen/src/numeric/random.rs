//! Seeded random numbers: the same on every run and every platform.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | μ | `mean` | mean of the variable itself, not of its logarithm |
//! | δ | `cov` | coefficient of variation, standard deviation / mean |

use super::NumericError;
use super::elementary::{exp, ln};
use rand_core::Rng as _;
use rand_pcg::Pcg64Dxsm;

/// Largest cov: far above that of any measured quantity; keeps the exponential finite.
pub(super) const COV_MOST: f64 = 10.0;

/// A reproducible sequence of random numbers.
///
/// In a study each sample has its own stream, numbered by the sample. Sample 17 is therefore the same in any order,
/// on any number of threads, and in a study of any size.
///
/// The generator is PCG64-DXSM, whose integers are equal on every platform. `uniform`, `normal` and `lognormal` use
/// only operations whose bits IEEE 754 fixes, and a logarithm and an exponential of our own, not the system's
/// mathematics library.
///
/// # Source
/// O'Neill (2014) *PCG: a family of simple fast space-efficient statistically good algorithms for random number
/// generation*, HMC-CS-2014-0905. Differs from the source: seed and stream pass through the finaliser of SplitMix64
/// (Steele et al. 2014, OOPSLA, doi:10.1145/2660193.2660195) before they become the state, so that streams 0, 1, 2, …
/// of one seed start from unrelated states.
///
/// # Example
/// ```
/// use dolmen::numeric::Random;
/// let mut random = Random::new(1, 0);
/// let stiffness = random.lognormal(203.9e6, 0.1)?;
/// assert_eq!(Random::new(1, 0).lognormal(203.9e6, 0.1)?, stiffness);
/// # Ok::<(), dolmen::numeric::NumericError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Random {
    generator: Pcg64Dxsm,
    /// The second of the two normal numbers that the polar method gives at a time, kept for the next call.
    spare_normal: Option<f64>,
}

impl Random {
    /// The random stream of one sample.
    ///
    /// # Input
    /// * `seed` -- seed of the whole study, any number
    /// * `stream` -- number of the stream within that seed: the index of the sample
    pub fn new(seed: u64, stream: u64) -> Self {
        let state = (u128::from(mix(seed)) << 64) | u128::from(mix(seed ^ mix(stream)));
        Random {
            generator: Pcg64Dxsm::new(state, u128::from(stream)),
            spare_normal: None,
        }
    }

    /// Uniformly distributed in [0, 1), a multiple of 2⁻⁵³.
    pub fn uniform(&mut self) -> f64 {
        const BITS: u32 = f64::MANTISSA_DIGITS; // 53 bits: the finest uniform spacing of numbers below 1
        (self.generator.next_u64() >> (64 - BITS)) as f64 / (1_u64 << BITS) as f64
    }

    /// Normal, mean 0, standard deviation 1, by Marsaglia's polar method.
    ///
    /// ```text
    /// u, v uniform in (−1, 1) with 0 < s = u² + v² < 1:   z₁, z₂ = (u, v) √(−2 ln s / s)
    /// ```
    ///
    /// # Source
    /// Marsaglia & Bray (1964) SIAM Review 6(3):260-264, doi:10.1137/1006063.
    pub fn normal(&mut self) -> f64 {
        if let Some(z) = self.spare_normal.take() {
            return z;
        }
        loop {
            let u = 2.0 * self.uniform() - 1.0;
            let v = 2.0 * self.uniform() - 1.0;
            let s = u * u + v * v;
            if s > 0.0 && s < 1.0 {
                let scale = (-2.0 * ln(s) / s).sqrt();
                self.spare_normal = Some(v * scale);
                return u * scale;
            }
        }
    }

    /// Lognormal with this mean and coefficient of variation: [`lognormal_at`] the next normal number.
    ///
    /// # Errors
    /// As [`lognormal_at`].
    pub fn lognormal(&mut self, mean: f64, cov: f64) -> Result<f64, NumericError> {
        lognormal_at(self.normal(), mean, cov)
    }
}

/// A lognormal variable with this mean and coefficient of variation, at its standard normal one; always positive, for stiffnesses, weights and
/// lengths.
///
/// ```text
/// x = μ exp(σ z − σ²/2),   σ² = ln(1 + δ²)
/// ```
///
/// # Errors
/// [`NumericError::Range`] if `mean` is not positive and finite or `cov` is not in [0, 10].
pub fn lognormal_at(z: f64, mean: f64, cov: f64) -> Result<f64, NumericError> {
    if !(mean > 0.0 && mean.is_finite()) {
        return Err(NumericError::Range {
            quantity: "mean of a lognormal variable",
            given: mean,
            allowed: "a positive number",
        });
    }
    if !(0.0..=COV_MOST).contains(&cov) {
        return Err(NumericError::Range {
            quantity: "cov of a lognormal variable",
            given: cov,
            allowed: "between 0 and 10 (0.1 is 10 %)",
        });
    }
    let variance = ln(1.0 + cov * cov);
    Ok(mean * exp(variance.sqrt() * z - 0.5 * variance))
}

/// The finaliser of SplitMix64: a bijection in which every input bit changes half of the output bits.
fn mix(seed: u64) -> u64 {
    const GOLDEN_GAMMA: u64 = 0x9e37_79b9_7f4a_7c15; // 2⁶⁴ / golden ratio, Steele et al. (2014)
    let z = seed.wrapping_add(GOLDEN_GAMMA);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9); // Stafford's variant 13 of the constants
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Mean, variance, skewness, kurtosis.
    fn moments(x: &[f64]) -> [f64; 4] {
        let n = x.len() as f64;
        let mean = x.iter().sum::<f64>() / n;
        let about = |p: i32| x.iter().map(|x| (x - mean).powi(p)).sum::<f64>() / n;
        let variance = about(2);
        [
            mean,
            variance,
            about(3) / variance.powf(1.5),
            about(4) / variance.powi(2),
        ]
    }

    #[test]
    fn regress_first_numbers_of_two_streams() {
        // Our own values only: the bits that every platform must give.
        let mut random = Random::new(1, 0);
        let first = [
            random.uniform(),
            random.normal(),
            random.normal(),
            random.lognormal(2.0, 0.3).unwrap(),
        ];
        assert_eq!(
            first,
            [
                0.6406685337621487,
                1.4766454629400572,
                -1.3538533644463766,
                1.3376022511180707
            ]
        );
        let mut random = Random::new(1, 1);
        assert_eq!(
            [random.uniform(), random.normal()],
            [0.4000369297391908, -0.15866362064926123]
        );
    }

    #[test]
    fn exact_first_outputs_of_splitmix64() {
        // Seed 1234567: the values of the reference code of SplitMix64, as in many test suites.
        const GAMMA: u64 = 0x9e37_79b9_7f4a_7c15;
        assert_eq!(mix(1_234_567), 6_457_827_717_110_365_317);
        assert_eq!(mix(1_234_567_u64.wrapping_add(GAMMA)), 3_203_168_211_198_807_973);
    }

    #[test]
    fn holds_moments_of_uniform_normal_and_lognormal() {
        // 200,000 numbers: bounds are 4 standard errors of each moment.
        const N: usize = 200_000;
        let n = N as f64;
        let mut random = Random::new(7, 3);
        let uniform: Vec<f64> = (0..N).map(|_| random.uniform()).collect();
        assert!(uniform.iter().all(|u| (0.0..1.0).contains(u)));
        let [mean, variance, _, _] = moments(&uniform);
        assert!((mean - 0.5).abs() < 4.0 * (1.0 / 12.0 / n).sqrt(), "{mean}");
        assert!(
            (variance - 1.0 / 12.0).abs() < 4.0 * (1.0 / 180.0 / n).sqrt(),
            "{variance}"
        );

        let normal: Vec<f64> = (0..N).map(|_| random.normal()).collect();
        let [mean, variance, skewness, kurtosis] = moments(&normal);
        assert!(mean.abs() < 4.0 / n.sqrt(), "{mean}");
        assert!((variance - 1.0).abs() < 4.0 * (2.0 / n).sqrt(), "{variance}");
        assert!(skewness.abs() < 4.0 * (6.0 / n).sqrt(), "{skewness}");
        assert!((kurtosis - 3.0).abs() < 4.0 * (24.0 / n).sqrt(), "{kurtosis}");
        let beyond = normal.iter().filter(|z| z.abs() > 1.959_963_984_540_054).count() as f64 / n;
        assert!((beyond - 0.05).abs() < 4.0 * (0.05 * 0.95 / n).sqrt(), "{beyond}");

        let lognormal: Vec<f64> = (0..N).map(|_| random.lognormal(5.0, 0.2).unwrap()).collect();
        let [mean, variance, _, _] = moments(&lognormal);
        assert!((mean - 5.0).abs() < 4.0 / n.sqrt(), "{mean}");
        assert!((variance - 1.0).abs() < 4.0 * (2.7 / n).sqrt(), "{variance}"); // Var of s² : κ − 1 = 2.7 at δ = 0.2
    }

    #[test]
    fn holds_first_numbers_of_neighbouring_streams_are_independent() {
        // Correlation at lags 1 to 5 of the first number of streams 0…49,999; 4.5 standard errors.
        const N: u64 = 50_000;
        for seed in [0, 1, 2, u64::MAX] {
            let first: Vec<f64> = (0..N).map(|s| Random::new(seed, s).uniform() - 0.5).collect();
            for lag in 1..=5 {
                let r = 12.0 * first.iter().zip(&first[lag..]).map(|(a, b)| a * b).sum::<f64>() / N as f64;
                assert!(r.abs() < 4.5 / (N as f64).sqrt(), "seed {seed}, lag {lag}: {r}");
            }
            let mut counts = [0_u32; 100];
            for u in &first {
                counts[((u + 0.5) * 100.0) as usize] += 1;
            }
            let expected = N as f64 / 100.0;
            let chi = counts
                .iter()
                .map(|&c| (f64::from(c) - expected).powi(2) / expected)
                .sum::<f64>();
            assert!(
                (chi - 99.0).abs() < 4.5 * (2.0 * 99.0_f64).sqrt(),
                "seed {seed}: χ² {chi} of 99 degrees"
            );
        }
    }

    #[test]
    fn exact_no_variation_gives_the_mean() {
        assert_eq!(Random::new(0, 0).lognormal(3.5, 0.0), Ok(3.5));
    }

    #[test]
    fn refuses_a_mean_or_cov_out_of_range_and_says_which() {
        let mut random = Random::new(0, 0);
        for mean in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let message = random.lognormal(mean, 0.1).unwrap_err().to_string();
            assert_eq!(
                message,
                format!("mean of a lognormal variable is {mean}, but must be a positive number")
            );
        }
        for cov in [-0.1, 11.0, f64::NAN] {
            let message = random.lognormal(1.0, cov).unwrap_err().to_string();
            assert_eq!(
                message,
                format!("cov of a lognormal variable is {cov}, but must be between 0 and 10 (0.1 is 10 %)")
            );
        }
    }
}
