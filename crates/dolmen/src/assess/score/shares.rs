//! Share of each factor in the differences between pagodas: the weights of the score.

use super::factors::Factor;
use super::model::{TrainedDesign, coordinates};
use super::shapley::shapley_shares;
use super::surface::Surface;
use crate::assess::AssessError;
use crate::numeric::{Interval, Random, mean, quantile};

/// The weight of one factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FactorShare {
    /// The factor.
    pub factor: Factor,
    /// Its Shapley share of the variance of ln θ, –.
    pub share: f64,
    /// 90 % interval of the share, from random halves of the designs.
    pub interval: Interval,
}

/// The weights of all factors.
#[derive(Clone, Debug, PartialEq)]
pub struct FactorShares {
    /// The shares, in the order of [`Factor::ALL`]; they sum to `explained`.
    pub shares: Vec<FactorShare>,
    /// Fraction of the variance that all factors together explain, by leave-one-out prediction, –.
    pub explained: f64,
}

/// Shapley shares of the variance of ln θ, with intervals from random halves of the designs (Shao and Wu, 1989).
///
/// ```text
/// v(S) = share of the variance of ln θ of left-out designs that a quadratic surface of the factors in S explains, at least 0
/// ```
///
/// v includes the information of a factor about correlated factors: α and λ depend on each other, and share their joint effect.
///
/// # Errors
/// As [`super::ScoreModel::train`].
///
/// # Source
/// Owen, A. B. (2014) Sobol' indices and Shapley value. SIAM/ASA J. Uncertain. Quantif. 2(1):245–251; of regressions: Lindeman, Merenda,
/// Gold (1980); halves: Shao, J. and Wu, C. F. J. (1989) Ann. Stat. 17(3):1176–1197. Differs from the sources: v of left-out designs, so that a
/// factor without information gets nothing.
pub fn factor_shares(
    designs: &[TrainedDesign],
    resamples: usize,
    seed: u64,
) -> Result<FactorShares, AssessError> {
    let (x, y) = coordinates(designs)?;
    let whole = shares_of(&x, &y)?;
    let mut drawn: Vec<Vec<f64>> = vec![Vec::new(); 6];
    for resample in 0..resamples {
        let half = random_half(designs.len(), &mut Random::new(seed, resample as u64));
        let half_x: Vec<[f64; 6]> = half.iter().map(|i| x[*i]).collect();
        let half_y: Vec<f64> = half.iter().map(|i| y[*i]).collect();
        for (drawn, share) in drawn.iter_mut().zip(shares_of(&half_x, &half_y)?.shares) {
            drawn.push(share);
        }
    }
    let mut shares = Vec::with_capacity(6);
    for ((factor, share), drawn) in Factor::ALL.into_iter().zip(whole.shares).zip(&drawn) {
        // all halves are biased by the same amount: only their scatter is used
        let about = if resamples == 0 { 0.0 } else { mean(drawn)? };
        let at = |p| match resamples {
            0 => Ok(share),
            _ => quantile(drawn, p).map(|own| share + own - about),
        };
        let interval = Interval {
            lower: at(0.05)?,
            upper: at(0.95)?,
        };
        shares.push(FactorShare {
            factor,
            share,
            interval,
        });
    }
    Ok(FactorShares {
        shares,
        explained: whole.all,
    })
}

/// A random half of n numbers. The scatter of results from halves equals the scatter of the result from all.
fn random_half(n: usize, random: &mut Random) -> Vec<usize> {
    let mut numbers: Vec<usize> = (0..n).collect();
    for place in 0..n / 2 {
        let left = n - place;
        let other = place + ((random.uniform() * left as f64) as usize).min(left - 1);
        numbers.swap(place, other);
    }
    numbers.truncate(n / 2);
    numbers.sort_unstable();
    numbers
}

struct Explained {
    shares: Vec<f64>,
    /// Explained share of all factors.
    all: f64,
}

fn shares_of(x: &[[f64; 6]], y: &[f64]) -> Result<Explained, AssessError> {
    let mut fault = None;
    let mut all = 0.0;
    let shares = shapley_shares(6, |used| {
        if used == 0 {
            return 0.0;
        }
        match Surface::fit(x, y, used) {
            Ok(surface) => {
                all = surface.explained.max(0.0); // the mask of all factors comes last
                all
            }
            Err(why) => {
                fault.get_or_insert(why);
                0.0
            }
        }
    });
    match fault {
        Some(why) => Err(why),
        None => Ok(Explained { shares, all }),
    }
}

#[cfg(test)]
mod tests {
    use super::super::factors::SixFactors;
    use super::*;
    use crate::assess::Fragility;

    /// Designs with factors x = exp(z) from a known population, ln θ = Σ b z + noise.
    fn designs(count: usize, correlation: f64, slope: [f64; 6], noise: f64) -> Vec<TrainedDesign> {
        let mut random = Random::new(11, 0);
        (0..count)
            .map(|_| {
                let mut z: [f64; 6] = std::array::from_fn(|_| random.normal());
                z[3] = correlation * z[2] + (1.0 - correlation * correlation).sqrt() * z[3];
                z[0] = 0.0; // every design has one storey
                z[4] = 0.1 + 0.01 * z[4];
                let ln_theta: f64 = slope.iter().zip(z).map(|(b, z)| b * z).sum();
                let factors = SixFactors {
                    storeys: 1,
                    body_height_m: z[1].exp(),
                    slenderness_angle: z[2].exp(),
                    body_slenderness: z[3].exp(),
                    taper_rad: z[4],
                    body_base_height_ratio: z[5].exp(),
                };
                let theta = (ln_theta + noise * random.normal()).exp();
                let fragility = Fragility::new(theta, 0.4).unwrap();
                TrainedDesign { factors, fragility }
            })
            .collect()
    }

    /// Two correlated normal inputs of a sum, b1 = 1, b2 = .5, ρ = −.77: the closed form of Owen and Prieur (2017), sec. 3.
    #[test]
    fn exact_shares_of_a_sum_of_two_correlated_inputs() {
        let (b1, b2, rho) = (1.0_f64, 0.5, -0.77);
        let variance = b1 * b1 + b2 * b2 + 2.0 * rho * b1 * b2;
        let both = rho * b1 * b2;
        let [first, second] = [b1, b2].map(|own| {
            let other = b1 + b2 - own;
            (own * own * (1.0 - 0.5 * rho * rho) + both + other * other * 0.5 * rho * rho) / variance
        });
        assert!((first + second - 1.0).abs() < 1e-12);
        let found = factor_shares(&designs(3000, rho, [0.0, 0.0, b1, b2, 0.0, 0.0], 0.0), 0, 1).unwrap();
        assert!((found.explained - 1.0).abs() < 1e-6);
        // 3000 draws: correlations are accurate to .01
        assert!((found.shares[2].share - first).abs() < 0.02, "{found:?} {first}");
        assert!(
            (found.shares[3].share - second).abs() < 0.02,
            "{found:?} {second}"
        );
        for idle in [0, 1, 4, 5] {
            assert!(found.shares[idle].share.abs() < 0.005, "{found:?}");
        }
    }

    #[test]
    fn holds_intervals_cover_what_more_designs_say() {
        let slope = [0.0, 0.3, 1.0, 0.0, -5.0, 0.2];
        let few = factor_shares(&designs(120, -0.5, slope, 0.3), 40, 1).unwrap();
        let many = factor_shares(&designs(3000, -0.5, slope, 0.3), 0, 1).unwrap();
        for (few, many) in few.shares.iter().zip(&many.shares) {
            let Interval { lower, upper } = few.interval;
            let slack = 0.5 * (upper - lower); // 90 % intervals of six factors
            assert!(
                (lower - slack..=upper + slack).contains(&many.share),
                "{few:?} {many:?}"
            );
        }
        assert_eq!(
            factor_shares(&designs(60, 0.0, slope, 0.3), 5, 1),
            factor_shares(&designs(60, 0.0, slope, 0.3), 5, 1)
        );
    }
}
