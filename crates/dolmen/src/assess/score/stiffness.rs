//! Effect of softer or stiffer joints on the capacity of a pagoda.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | x | `ln_ratio` | ln of the stiffness of all joints relative to the designs | – |
//! | z | `z` | coordinates of the factors, standardised | 6 |
//! | y | `ln_change` | ln θ with these joints minus ln θ with the joints of the designs, under the same motions | – |

use super::factors::SixFactors;
use super::kriging::dot;
use super::surface::ridge;
use crate::assess::AssessError;
use crate::numeric::Interval;

/// Fewest pagodas with other joints: three for each coefficient. Our choice.
const DESIGNS_LEAST: usize = 39;
/// Indices of the factors that vary independently: tan α follows from the others.
const INDEPENDENT: [usize; 5] = [0, 1, 3, 4, 5];

/// A simulated pagoda whose joints have another stiffness than those of the designs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StiffnessDesign {
    /// Its factors.
    pub factors: SixFactors,
    /// Stiffness of all its joints relative to the designs.
    pub stiffness_ratio: f64,
    /// ln of the ratio of its median capacity to that of the same pagoda with the joints of the designs.
    pub ln_change: f64,
}

/// Dependence of the capacity on the stiffness of all joints together.
///
/// ```text
/// y = x (a₀ + Σ a_i z_i) + x² (b₀ + Σ b_i z_i) + c x³        13 coefficients by ridge regression; y = 0 for the joints of the designs
/// ```
#[derive(Clone, Debug)]
pub struct StiffnessEffect {
    middle: [f64; 6],
    spread: [f64; 6],
    coefficients: Vec<f64>,
    /// Root mean square of the leave-one-out errors.
    pub ln_change_sd: f64,
    /// Root mean square of the changes.
    pub ln_change_rms: f64,
    /// Range of the stiffness ratios in the training.
    pub trained: Interval,
}

impl StiffnessEffect {
    /// Fits the effect to simulated pagodas.
    ///
    /// # Errors
    /// [`AssessError::TooFewDesigns`] below 39; [`AssessError::Factor`] for a ratio or factor that is not positive.
    pub fn train(designs: &[StiffnessDesign]) -> Result<Self, AssessError> {
        if designs.len() < DESIGNS_LEAST {
            return Err(AssessError::TooFewDesigns {
                given: designs.len(),
                least: DESIGNS_LEAST,
            });
        }
        let places = designs.iter().map(|one| one.factors.coordinates());
        let places: Vec<[f64; 6]> = places.collect::<Result<_, _>>()?;
        let count = places.len() as f64;
        let middle: [f64; 6] = std::array::from_fn(|i| places.iter().map(|x| x[i]).sum::<f64>() / count);
        let spread: [f64; 6] = std::array::from_fn(|i| {
            let squares = places.iter().map(|x| (x[i] - middle[i]).powi(2));
            (squares.sum::<f64>() / count).sqrt()
        });
        let mut effect = StiffnessEffect {
            middle,
            spread,
            coefficients: Vec::new(),
            ln_change_sd: 0.0,
            ln_change_rms: 0.0,
            trained: Interval {
                lower: f64::INFINITY,
                upper: f64::NEG_INFINITY,
            },
        };
        let mut rows = Vec::with_capacity(designs.len());
        for (design, place) in designs.iter().zip(&places) {
            let ratio = design.stiffness_ratio;
            if !(ratio > 0.0 && ratio.is_finite()) {
                return Err(AssessError::Factor {
                    factor: "normal_stiffness",
                    given: ratio,
                    allowed: "a positive number",
                });
            }
            effect.trained.lower = effect.trained.lower.min(ratio);
            effect.trained.upper = effect.trained.upper.max(ratio);
            rows.push(effect.features(place, ratio.ln()));
        }
        let y: Vec<f64> = designs.iter().map(|design| design.ln_change).collect();
        let fit = ridge(&rows, &y)?;
        effect.coefficients = fit.coefficients;
        effect.ln_change_sd = fit.left_out_variance.sqrt();
        effect.ln_change_rms = (y.iter().map(|y| y * y).sum::<f64>() / count).sqrt();
        Ok(effect)
    }

    /// Change of ln θ of a pagoda whose joints have this stiffness ratio.
    ///
    /// # Errors
    /// [`AssessError::Factor`] for factors that are not positive.
    pub fn ln_change(&self, factors: &SixFactors, stiffness_ratio: f64) -> Result<f64, AssessError> {
        Ok(self.at(&factors.coordinates()?, stiffness_ratio.ln()))
    }

    /// The change at given coordinates of the factors.
    pub(super) fn at(&self, place: &[f64; 6], ln_ratio: f64) -> f64 {
        dot(&self.features(place, ln_ratio), &self.coefficients)
    }

    fn features(&self, place: &[f64; 6], ln_ratio: f64) -> Vec<f64> {
        let z = INDEPENDENT.map(|i| match self.spread[i] > 0.0 {
            true => (place[i] - self.middle[i]) / self.spread[i],
            false => 0.0,
        });
        let mut features = vec![ln_ratio];
        features.extend(z.map(|z| ln_ratio * z));
        features.push(ln_ratio.powi(2));
        features.extend(z.map(|z| ln_ratio.powi(2) * z));
        features.push(ln_ratio.powi(3));
        features
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;

    fn designs(count: usize, law: impl Fn(f64, f64, f64) -> f64) -> Vec<StiffnessDesign> {
        let mut random = Random::new(9, 0);
        let made = (0..count).map(|_| {
            let mut u = |low: f64, high: f64| low + (high - low) * random.uniform();
            let factors = SixFactors {
                storeys: 5,
                body_height_m: u(2.0, 9.0),
                slenderness_angle: 0.3,
                body_slenderness: u(2.5, 5.0),
                taper_rad: u(0.05, 0.17),
                body_base_height_ratio: u(1.1, 4.0),
            };
            let x = u(-2.3, 2.3);
            StiffnessDesign {
                factors,
                stiffness_ratio: x.exp(),
                ln_change: law(x, factors.body_height_m, 2.0 * random.normal()),
            }
        });
        made.collect()
    }

    /// The fit reproduces a change that its terms can represent, and gives 0 for the joints of the designs.
    #[test]
    fn exact_law_is_found_again() {
        let law = |x: f64, height_m: f64| x * (0.2 + 0.1 * height_m.ln()) + 0.03 * x * x;
        let own = designs(80, |x, height_m, _| law(x, height_m));
        let effect = StiffnessEffect::train(&own).unwrap();
        assert!(effect.ln_change_sd < 1e-6, "{}", effect.ln_change_sd);
        for one in designs(10, |x, height_m, _| law(x, height_m)) {
            let found = effect.ln_change(&one.factors, one.stiffness_ratio).unwrap();
            assert!((found - one.ln_change).abs() < 1e-6, "{found} {}", one.ln_change);
            assert_eq!(effect.ln_change(&one.factors, 1.0).unwrap(), 0.0);
        }
    }

    /// For pure noise, the leave-one-out error equals the noise.
    #[test]
    fn holds_noise_is_stated() {
        let effect = StiffnessEffect::train(&designs(300, |_, _, noise| noise)).unwrap();
        assert!((effect.ln_change_sd / effect.ln_change_rms - 1.0).abs() < 0.1);
        assert!(StiffnessEffect::train(&designs(38, |_, _, noise| noise)).is_err());
    }
}
