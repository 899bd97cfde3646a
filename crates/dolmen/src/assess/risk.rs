//! Annual rate at which a structure reaches a state, from a hazard curve and a fragility curve.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | H(x) | [`Hazard::annual_rate`] | rate at which an intensity x is exceeded | 1/year |
//! | k₀, k | `k0`, `k` | H = k₀ x^−k | 1/year, – |
//! | λ | `annual_rate` | rate at which the state is reached | 1/year |

use super::AssessError;
use super::demand::{KoreanSite, Site, site_demand};
use super::fragility::Fragility;
use crate::numeric::ln_normal_probability;

/// Return periods of the Korean code whose factors have a source, years.
const KOREAN_PERIODS: [u32; 6] = [50, 100, 200, 500, 1000, 2400];

/// Damping ratio for the query of the code; the peak ground acceleration does not depend on it.
const CODE_DAMPING: f64 = 0.05;

/// A hazard curve, linear between points in logarithms of rate and intensity.
#[derive(Clone, Debug, PartialEq)]
pub struct Hazard {
    /// Intensity (ascending) and annual rate of exceedance (descending).
    points: Vec<[f64; 2]>,
    /// Whether the curve is a single power law over all intensities.
    is_power_law: bool,
}

impl Hazard {
    /// A power law H = k₀ x^−k.
    ///
    /// # Errors
    /// [`AssessError::Hazard`] unless both are positive.
    pub fn power_law(k0: f64, k: f64) -> Result<Self, AssessError> {
        for (what, given) in [("k0", k0), ("k", k)] {
            if !(given > 0.0 && given.is_finite()) {
                return Err(AssessError::Hazard {
                    what,
                    given,
                    allowed: "a positive number",
                });
            }
        }
        let x = (k0 / 1e-3).powf(1.0 / k); // two points of the power law: at a thousand and at ten thousand years
        let line = Hazard::of_points(&[[x, 1e-3], [x * 10.0_f64.powf(1.0 / k), 1e-4]])?;
        Ok(Hazard {
            is_power_law: true,
            ..line
        })
    }

    /// A power law through one point, an intensity with its return period.
    ///
    /// # Errors
    /// As [`Hazard::power_law`].
    pub fn through(intensity: f64, return_period_years: f64, k: f64) -> Result<Self, AssessError> {
        for (what, given) in [("intensity", intensity), ("return period", return_period_years)] {
            if !(given > 0.0 && given.is_finite()) {
                return Err(AssessError::Hazard {
                    what,
                    given,
                    allowed: "a positive number",
                });
            }
        }
        Hazard::power_law(intensity.powf(k) / return_period_years, k)
    }

    /// Points (intensity, annual rate of exceedance) in ascending intensity; the first and last slope are extrapolated.
    ///
    /// # Errors
    /// [`AssessError::Hazard`] for fewer than two points, numbers that are not positive, or a rate that does not fall.
    pub fn of_points(points: &[[f64; 2]]) -> Result<Self, AssessError> {
        let refuse = |what, given, allowed| Err(AssessError::Hazard { what, given, allowed });
        if points.len() < 2 {
            return refuse("the number of points", points.len() as f64, "2 or more");
        }
        for [intensity, rate] in points {
            for (what, given) in [("an intensity", *intensity), ("a rate", *rate)] {
                if !(given > 0.0 && given.is_finite()) {
                    return refuse(what, given, "a positive number");
                }
            }
        }
        for pair in points.windows(2) {
            if pair[1][0] <= pair[0][0] {
                return refuse("an intensity", pair[1][0], "above the one before it");
            }
            if pair[1][1] >= pair[0][1] {
                return refuse(
                    "a rate",
                    pair[1][1],
                    "below the one before it: stronger shaking is rarer",
                );
            }
        }
        Ok(Hazard {
            points: points.to_vec(),
            is_power_law: false,
        })
    }

    /// Peak ground acceleration, m/s², soil included, by the return periods of KDS 17 10 00 from 50 to 2400 years.
    ///
    /// # Errors
    /// The errors of [`site_demand`] and of [`Hazard::of_points`].
    pub fn kds_17(zone_factor_g: f64, soil: KoreanSite) -> Result<Self, AssessError> {
        let mut points = Vec::with_capacity(KOREAN_PERIODS.len());
        for return_period_years in KOREAN_PERIODS {
            let site = Site::Kds17 {
                zone_factor_g,
                return_period_years,
                soil,
            };
            let demand = site_demand(&site, CODE_DAMPING, None)?;
            if let Some(peak_m_s2) = demand.peak_ground_acceleration_m_s2 {
                points.push([peak_m_s2, 1.0 / f64::from(return_period_years)]);
            }
        }
        Hazard::of_points(&points)
    }

    /// The exponent k of a hazard given as one power law; `None` for a curve through points.
    pub fn exponent(&self) -> Option<f64> {
        self.is_power_law.then(|| self.piece(0).0)
    }

    /// The points.
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// Rate at which an intensity is exceeded, 1/year; infinite at 0.
    pub fn annual_rate(&self, intensity: f64) -> f64 {
        let last = self.points.len() - 2;
        let piece = self.points[1..=last].partition_point(|point| point[0] < intensity);
        let (k, [x, rate]) = self.piece(piece);
        rate * (intensity / x).powf(-k)
    }

    /// Slope and one point of a piece.
    fn piece(&self, piece: usize) -> (f64, [f64; 2]) {
        let ([x0, r0], [x1, r1]) = (self.points[piece], self.points[piece + 1]);
        ((r0 / r1).ln() / (x1 / x0).ln(), [x0, r0])
    }
}

/// Annual rate of reaching a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AnnualRisk {
    /// λ, 1/year.
    pub annual_rate: f64,
    /// Fraction of λ from intensities below the first point of the hazard, where its first slope is extrapolated.
    pub share_below_points: f64,
    /// Fraction of λ from intensities above the last point of the hazard.
    pub share_above_points: f64,
}

impl AnnualRisk {
    /// Probability that the state is reached within n years, if the structure does not change: 1 − e^(−λ n).
    pub fn probability_in(&self, years: f64) -> f64 {
        -(-self.annual_rate * years).exp_m1()
    }
}

/// Annual rate at which a state is reached: the hazard averaged over the scatter of the capacity. Exact, piece by piece.
///
/// ```text
/// λ = ∫ H(x) f(x) dx,   f the density of the capacity, lognormal (θ, β)
/// H = r₀ (x/x₀)^−k from x_a to x_b:   r₀ (θ/x₀)^−k e^(k²β²/2) [Φ(z_b + kβ) − Φ(z_a + kβ)],   z = ln(x/θ)/β
/// one power law:   λ = k₀ θ^−k e^(k²β²/2)
/// ```
///
/// # Limits
/// If a large part of λ comes from beyond the points of the hazard, it depends on extrapolated slopes: the result contains both
/// fractions. The structure is taken as undamaged before each earthquake.
///
/// # Source
/// Cornell, C. A. (1996) Calculating building seismic performance reliability. Proc. 11th WCEE.
///
/// # Example
/// ```
/// use dolmen::assess::{Fragility, Hazard, annual_risk};
/// let hazard = Hazard::through(0.11, 475.0, 2.2)?; // g, years
/// let risk = annual_risk(&hazard, &Fragility::new(0.40, 0.40)?);
/// assert!((risk.annual_rate - 1.811328e-4).abs() < 1e-10);
/// assert!((risk.probability_in(50.0) - 0.00902).abs() < 5e-6);
/// # Ok::<(), dolmen::assess::AssessError>(())
/// ```
pub fn annual_risk(hazard: &Hazard, fragility: &Fragility) -> AnnualRisk {
    let (theta, beta) = (fragility.theta(), fragility.beta());
    // the contribution to λ between two intensities of one piece
    let part = |piece: usize, from: f64, to: f64| {
        let (k, [x0, rate]) = hazard.piece(piece);
        let z = |x: f64| (x / theta).ln() / beta + k * beta;
        // in logarithms: the first factor may overflow where the product is negligible
        let front = rate.ln() - k * (theta / x0).ln() + 0.5 * (k * beta).powi(2);
        (front + ln_between(z(from), z(to))).exp()
    };
    let points = &hazard.points;
    let last = points.len() - 2;
    let inside: f64 = (0..=last).map(|i| part(i, points[i][0], points[i + 1][0])).sum();
    let below = part(0, 0.0, points[0][0]);
    let above = part(last, points[last + 1][0], f64::INFINITY);
    let annual_rate = below + inside + above;
    let share = |part: f64| match annual_rate {
        _ if hazard.is_power_law => 0.0, // a power law has no last point
        rate if rate.is_infinite() => f64::from(u8::from(part.is_infinite())),
        rate if rate > 0.0 => part / rate,
        _ => 0.0,
    };
    AnnualRisk {
        annual_rate,
        share_below_points: share(below),
        share_above_points: share(above),
    }
}

/// ln(Φ(b) − Φ(a)) with a ≤ b, on the side where both are small; −∞ for a = b.
fn ln_between(a: f64, b: f64) -> f64 {
    let (small, large) = if a > 0.0 { (-b, -a) } else { (a, b) };
    let (small, large) = (ln_normal_probability(small), ln_normal_probability(large));
    large + (-(small - large).exp()).ln_1p()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_where_a_hazard_is_so_steep_that_its_front_is_no_number() {
        // .1 at 95 years and .102 at 475: k = 81, e^(k² β²/2) = e^825 with β = .5
        let hazard = Hazard::of_points(&[[0.1, 1.0 / 95.0], [0.102, 1.0 / 475.0]]).unwrap();
        let steep = annual_risk(&hazard, &Fragility::new(0.3, 0.5).unwrap());
        assert!(
            steep.annual_rate.is_infinite() && steep.share_below_points > 0.99,
            "{steep:?}"
        );
        // closed form, with a β that does not overflow
        let k = 5.0_f64.ln() / 1.02_f64.ln();
        let one = annual_risk(&hazard, &Fragility::new(0.3, 0.2).unwrap());
        let closed = (3.0_f64.ln() * -k + 0.5 * (0.2 * k).powi(2)).exp() / 95.0;
        assert!((one.annual_rate / closed - 1.0).abs() < 1e-9, "{one:?} {closed}");
    }

    /// ∫ H(x) f(x) dx by the trapezoidal rule in z, which converges faster than any power for a function that decays at both
    /// ends.
    fn by_quadrature(hazard: &Hazard, fragility: &Fragility) -> f64 {
        const STEP: f64 = 1e-3;
        (-20_000..=20_000)
            .map(|i| {
                let z = STEP * f64::from(i);
                let density = (-0.5 * z * z).exp() / std::f64::consts::TAU.sqrt();
                STEP * density * hazard.annual_rate(fragility.theta() * (fragility.beta() * z).exp())
            })
            .sum()
    }

    #[test]
    fn published_risk_of_a_power_law_and_its_integral() {
        let hazard = Hazard::through(0.11, 475.0, 2.2).unwrap();
        let fragility = Fragility::new(0.40, 0.40).unwrap();
        let risk = annual_risk(&hazard, &fragility);
        assert!((risk.annual_rate - 1.811_328e-4).abs() < 5e-11, "{risk:?}");
        assert!((risk.probability_in(50.0) - 0.009_02).abs() < 5e-6);
        // closed form from the documentation of the function
        let k0 = 0.11_f64.powf(2.2) / 475.0;
        let closed = k0 * 0.4_f64.powf(-2.2) * (0.5 * 2.2_f64.powi(2) * 0.4_f64.powi(2)).exp();
        assert!((risk.annual_rate / closed - 1.0).abs() < 1e-12);
        let integral = by_quadrature(&hazard, &fragility);
        assert!((integral / closed - 1.0).abs() < 1e-10, "{integral:e} {closed:e}");
    }

    #[test]
    fn agrees_pieces_with_quadrature() {
        let of_code = Hazard::kds_17(0.11, KoreanSite::S1).unwrap();
        assert_eq!(of_code.points().len(), 6);
        // rock: S = Z I, I = 1 for 500 years
        assert!((of_code.annual_rate(0.11 * 9.80665) * 500.0 - 1.0).abs() < 1e-12);
        let in_g: Vec<[f64; 2]> = of_code
            .points()
            .iter()
            .map(|[x, rate]| [x / 9.80665, *rate])
            .collect();
        let hazard = Hazard::of_points(&in_g).unwrap();
        for (theta, beta) in [(0.2, 0.4), (0.05, 0.6), (1.5, 0.2)] {
            let fragility = Fragility::new(theta, beta).unwrap();
            let risk = annual_risk(&hazard, &fragility);
            let integral = by_quadrature(&hazard, &fragility);
            // the kinks of the hazard make the quadrature second order in the step
            assert!(
                (risk.annual_rate / integral - 1.0).abs() < 1e-6,
                "{theta}: {risk:?} {integral:e}"
            );
        }
        // the risk of a strong structure comes from intensities above the points
        let strong = annual_risk(&hazard, &Fragility::new(1.5, 0.2).unwrap());
        assert!(
            strong.share_above_points > 0.99 && strong.share_below_points < 1e-6,
            "{strong:?}"
        );
        let weak = annual_risk(&hazard, &Fragility::new(0.02, 0.2).unwrap());
        assert!(weak.share_below_points > 0.9, "{weak:?}");
    }

    #[test]
    fn refuses_hazards_that_cannot_be() {
        let said = |points: &[[f64; 2]]| Hazard::of_points(points).unwrap_err().to_string();
        assert_eq!(
            said(&[[0.1, 1e-2], [0.2, 1e-2]]),
            "a rate of the hazard is 0.01, but must be below the one before it: stronger shaking is rarer"
        );
        assert!(said(&[[0.1, 1e-2]]).contains("2 or more"));
        assert!(said(&[[0.2, 1e-2], [0.1, 1e-3]]).contains("above the one before it"));
        assert!(said(&[[0.0, 1e-2], [0.1, 1e-3]]).contains("a positive number"));
        assert!(Hazard::power_law(0.0, 2.0).is_err() && Hazard::power_law(1e-5, f64::NAN).is_err());
    }
}
