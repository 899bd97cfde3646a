//! Capacity of a pagoda from its six factors, with an interval and the contribution of each factor.

use super::factors::{Factor, SixFactors};
use super::kriging::{Kriging, Predicted, SurfaceSettings};
use super::shapley::shapley_shares;
use super::surface::Surface;
use crate::assess::{AssessError, Fragility};
use crate::numeric::{Interval, normal_quantile};

/// Fewest training designs: the number of terms of a quadratic surface of six factors. Our choice; 150 are recommended.
const DESIGNS_LEAST: usize = 28;
/// Largest extrapolation: a factor may exceed the training range by this ratio, or lie below it by its inverse. Farther off, its unit is probably
/// wrong, and the score is not valid. Our choice.
const FARTHEST: f64 = 1.5;
/// The coalition of all six factors.
const ALL: u32 = 0b11_1111;

/// A simulated pagoda: its factors and its fragility.
#[derive(Clone, Debug, PartialEq)]
pub struct TrainedDesign {
    /// Its factors.
    pub factors: SixFactors,
    /// Its fragility in one damage state over peak ground acceleration, m/s².
    pub fragility: Fragility,
}

/// A factor outside the training range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutsideFactor {
    /// The factor.
    pub factor: Factor,
    /// Its value.
    pub given: f64,
    /// The training range.
    pub trained: Interval,
}

/// The score of one pagoda in one damage state.
#[derive(Clone, Debug, PartialEq)]
pub struct PagodaScore {
    /// θ: half of the motions bring it to the state at this peak ground acceleration, m/s².
    pub capacity_m_s2: f64,
    /// Standard deviation of ln θ: prediction error for new designs, which depends on the factors.
    pub ln_capacity_sd: f64,
    /// Standard deviation of ln θ that all designs share, because the same few motions shook them: β/√motions, an upper bound. It shifts θ but not
    /// the ranking. 0 if the number of motions is unknown.
    pub ln_shared_sd: f64,
    /// Mean β of the designs: scatter between motions.
    pub beta: f64,
    /// Percentage of the designs with a lower capacity in this state.
    pub percentile: f64,
    /// Percentages of the designs below both ends of the interval of θ.
    pub percentile_interval: Interval,
    /// Contribution of each factor to ln θ relative to the mean of the designs, in the order of [`Factor::ALL`]; the contributions sum to the
    /// difference. They are Shapley values from quadratic surfaces over subsets of the factors, and from the full score over all factors. Correlated
    /// factors share their effect, and an effect that only the full score has is divided equally.
    pub reasons: [f64; 6],
    /// Factors outside the training range; only if extrapolation was allowed.
    pub outside: Vec<OutsideFactor>,
}

impl PagodaScore {
    /// Interval of θ with a confidence, including the error that all designs share, m/s².
    ///
    /// # Errors
    /// [`AssessError::Numeric`] unless 0 < confidence < 1.
    pub fn capacity_interval_m_s2(&self, confidence: f64) -> Result<Interval, AssessError> {
        let half = normal_quantile(0.5 + 0.5 * confidence)? * self.ln_capacity_sd.hypot(self.ln_shared_sd);
        Ok(Interval {
            lower: self.capacity_m_s2 * (-half).exp(),
            upper: self.capacity_m_s2 * half.exp(),
        })
    }
}

/// The score of one damage state.
///
/// ```text
/// ln θ = kriged surface of (ln N_f, ln H_t, ln tan α, ln λ, φ, ln γ_H),   through simulated designs
/// ```
/// Kriging predicts left-out designs better than a quadratic surface: for 150 pagodas Kendall's τ is 0.79 instead of 0.73 (DS2) and 0.82 instead of
/// 0.75 (DS3). Quadratic surfaces of some of the factors show the contribution of each factor.
#[derive(Clone, Debug)]
pub struct ScoreModel {
    designs: Vec<TrainedDesign>,
    surface: Kriging,
    /// A surface for each subset of the factors, indexed by bit mask.
    parts: Vec<Surface>,
    range: [Interval; 6],
    /// ln θ of the designs, ascending.
    sorted: Vec<f64>,
    beta: f64,
    /// Number of motions that shook every design, if known.
    motions: Option<usize>,
}

impl ScoreModel {
    /// Trains the score of one state on designs with this number of motions each. The search for the settings of the surface takes half a second for
    /// 150 designs.
    ///
    /// # Errors
    /// [`AssessError::TooFewDesigns`] below 28; [`AssessError::Factor`].
    pub fn train(designs: &[TrainedDesign], motions: Option<usize>) -> Result<Self, AssessError> {
        Self::of(designs, motions, &Self::settings(designs)?)
    }

    /// The settings of the surface for one state.
    ///
    /// # Errors
    /// As [`ScoreModel::train`].
    pub fn settings(designs: &[TrainedDesign]) -> Result<SurfaceSettings, AssessError> {
        enough(designs)?;
        let (x, y) = coordinates(designs)?;
        Kriging::settings(&x, &y)
    }

    /// As [`ScoreModel::train`], but with settings from an earlier search: takes milliseconds.
    ///
    /// # Errors
    /// As [`ScoreModel::train`].
    pub fn of(
        designs: &[TrainedDesign],
        motions: Option<usize>,
        settings: &SurfaceSettings,
    ) -> Result<Self, AssessError> {
        enough(designs)?;
        let n = designs.len();
        let (x, y) = coordinates(designs)?;
        let mut range = [Interval {
            lower: f64::INFINITY,
            upper: f64::NEG_INFINITY,
        }; 6];
        for design in designs {
            for (range, value) in range.iter_mut().zip(design.factors.values()) {
                range.lower = range.lower.min(value);
                range.upper = range.upper.max(value);
            }
        }
        let surface = Kriging::of(&x, &y, settings)?;
        let fits = (0..ALL).map(|used| Surface::fit(&x, &y, used));
        let parts = fits.collect::<Result<Vec<_>, _>>()?;
        let mut sorted = y;
        sorted.sort_by(f64::total_cmp);
        Ok(ScoreModel {
            designs: designs.to_vec(),
            surface,
            parts,
            range,
            sorted,
            motions,
            beta: designs.iter().map(|design| design.fragility.beta()).sum::<f64>() / n as f64,
        })
    }

    /// The designs.
    pub fn designs(&self) -> &[TrainedDesign] {
        &self.designs
    }

    /// The training range of each factor, in the order of [`Factor::ALL`].
    pub fn trained_range(&self) -> &[Interval; 6] {
        &self.range
    }

    /// The score of a pagoda. `outside_too` allows factors outside the training range, which the result lists.
    ///
    /// # Errors
    /// [`AssessError::OutsideTraining`] for a factor outside the training range without `outside_too`, and in any case for a factor more than half
    /// beyond it; [`AssessError::Factor`].
    ///
    /// # Limits
    /// Valid for pagodas like the training pagodas: square, of whole stones, a single stack, with the same friction and stiffness, undamaged. The
    /// range is checked for each factor separately; for combinations far from every design, `ln_capacity_sd` is large.
    pub fn score(&self, factors: &SixFactors, outside_too: bool) -> Result<PagodaScore, AssessError> {
        let x = factors.coordinates()?;
        let mut outside = Vec::new();
        for ((factor, given), trained) in Factor::ALL.into_iter().zip(factors.values()).zip(self.range) {
            if given < trained.lower || given > trained.upper {
                outside.push(OutsideFactor {
                    factor,
                    given,
                    trained,
                });
            }
        }
        let is_far = |one: &&OutsideFactor| {
            one.given > FARTHEST * one.trained.upper || one.given * FARTHEST < one.trained.lower
        };
        let refused = match outside_too {
            true => outside.iter().find(is_far),
            false => outside.first(),
        };
        if let Some(first) = refused {
            // units as in tables and project files
            let (factor, in_unit): (_, fn(f64) -> f64) = match first.factor {
                Factor::Taper => ("taper, in degrees,", f64::to_degrees),
                other => (other.name(), |value| value),
            };
            return Err(AssessError::OutsideTraining {
                factor,
                given: in_unit(first.given),
                least: in_unit(first.trained.lower),
                most: in_unit(first.trained.upper),
            });
        }
        let found = self.surface.predict(&x);
        let rank = |ln_theta: f64| {
            let below = self.sorted.partition_point(|own| *own < ln_theta);
            100.0 * below as f64 / self.sorted.len() as f64
        };
        let half = normal_quantile(0.95)? * found.sd; // half width of the 90 % interval
        Ok(PagodaScore {
            capacity_m_s2: found.value.exp(),
            ln_capacity_sd: found.sd,
            ln_shared_sd: self
                .motions
                .map_or(0.0, |motions| self.beta / (motions as f64).sqrt()),
            beta: self.beta,
            percentile: rank(found.value),
            percentile_interval: Interval {
                lower: rank(found.value - half),
                upper: rank(found.value + half),
            },
            reasons: self.reasons(&x, found.value),
            outside,
        })
    }

    /// Difference of ln θ between the points `to` and `from`.
    pub(super) fn difference(&self, from: &[f64; 6], to: &[f64; 6]) -> Predicted {
        self.surface.difference(from, to)
    }

    /// Contribution of each factor; `ln_theta` is the prediction from all factors.
    fn reasons(&self, x: &[f64; 6], ln_theta: f64) -> [f64; 6] {
        let shares = shapley_shares(6, |used| {
            self.parts
                .get(used as usize)
                .map_or(ln_theta, |part| part.value(x))
        });
        std::array::from_fn(|axis| shares[axis])
    }
}

fn enough(designs: &[TrainedDesign]) -> Result<(), AssessError> {
    match designs.len() {
        given if given < DESIGNS_LEAST => Err(AssessError::TooFewDesigns {
            given,
            least: DESIGNS_LEAST,
        }),
        _ => Ok(()),
    }
}

pub(super) fn coordinates(designs: &[TrainedDesign]) -> Result<(Vec<[f64; 6]>, Vec<f64>), AssessError> {
    let x = designs.iter().map(|design| design.factors.coordinates());
    let y = designs.iter().map(|design| design.fragility.theta().ln());
    Ok((x.collect::<Result<_, _>>()?, y.collect()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::stack::{PagodaFactors, PagodaSlenderness};

    /// Designs over the five independent factors, with capacities by `law`.
    fn designs(count: usize) -> Vec<TrainedDesign> {
        let mut random = crate::numeric::Random::new(2, 0);
        (0..count)
            .map(|i| {
                let factors = SixFactors::of_pagoda(&PagodaFactors {
                    storeys: [3, 5, 7][i % 3],
                    body_height_m: 3.0 + 5.0 * random.uniform(),
                    slenderness: PagodaSlenderness::Body(2.6 + 2.0 * random.uniform()),
                    taper_rad: 0.06 + 0.08 * random.uniform(),
                    body_base_height_ratio: 1.2 + 2.5 * random.uniform(),
                    density_kg_m3: 2600.0,
                })
                .unwrap();
                let fragility = Fragility::new(law(&factors), 0.35).unwrap();
                TrainedDesign { factors, fragility }
            })
            .collect()
    }

    fn law(factors: &SixFactors) -> f64 {
        9.81 * factors.slenderness_angle * (factors.body_height_m / 3.0).sqrt()
            / f64::from(factors.storeys).powf(0.3)
    }

    #[test]
    fn exact_scores_of_a_law_of_powers() {
        let designs = designs(90);
        let model = ScoreModel::train(&designs, None).unwrap();
        let own = SixFactors::of_pagoda(&PagodaFactors::default()).unwrap();
        let found = model.score(&own, true).unwrap();
        assert!((found.capacity_m_s2 / law(&own) - 1.0).abs() < 1e-3, "{found:?}");
        assert!((found.beta - 0.35).abs() < 1e-12);
        let below = designs
            .iter()
            .filter(|design| law(&design.factors) < law(&own))
            .count();
        assert!(
            (found.percentile - 100.0 * below as f64 / 90.0).abs() < 1.2,
            "{found:?}"
        );
    }

    #[test]
    fn holds_reasons_sum_to_what_sets_a_pagoda_apart() {
        let model = ScoreModel::train(&designs(60), None).unwrap();
        let own = model.designs()[17].factors;
        let found = model.score(&own, false).unwrap();
        let logs = model.designs().iter().map(|design| design.fragility.theta().ln());
        let mean = logs.sum::<f64>() / 60.0;
        let sum: f64 = found.reasons.iter().sum();
        assert!((mean + sum - found.capacity_m_s2.ln()).abs() < 1e-9);
        let interval = found.capacity_interval_m_s2(0.9).unwrap();
        assert!(interval.lower < found.capacity_m_s2 && found.capacity_m_s2 < interval.upper);
        // 22 motions with the same effect on all designs: β/√22 more for θ, not for the ranking
        let shaken = ScoreModel::train(model.designs(), Some(22)).unwrap();
        let shared = shaken.score(&own, false).unwrap();
        assert!((shared.ln_shared_sd / (shared.beta / 22.0_f64.sqrt()) - 1.0).abs() < 1e-14);
        let wider = shared.capacity_interval_m_s2(0.9).unwrap();
        let half = 1.644_853_626_951_472_6 * found.ln_capacity_sd.hypot(shared.ln_shared_sd);
        assert!(((wider.upper / shared.capacity_m_s2).ln() / half - 1.0).abs() < 1e-9);
        assert_eq!(shared.percentile_interval, found.percentile_interval);
    }

    /// With independent factors and a power law, each factor contributes its exponent times ln of its ratio to the mean.
    #[test]
    fn exact_reasons_of_independent_factors() {
        let mut random = crate::numeric::Random::new(9, 0);
        let designs: Vec<TrainedDesign> = (0..240)
            .map(|_| {
                let mut u = || 0.7 + 0.6 * random.uniform();
                let factors = SixFactors {
                    storeys: 3,
                    body_height_m: 4.0 * u(),
                    slenderness_angle: 0.3 * u(),
                    body_slenderness: 3.0 * u(),
                    taper_rad: 0.1,
                    body_base_height_ratio: 2.0 * u(),
                };
                let fragility = Fragility::new(law(&factors), 0.4).unwrap();
                TrainedDesign { factors, fragility }
            })
            .collect();
        let model = ScoreModel::train(&designs, None).unwrap();
        let own = SixFactors {
            body_height_m: 5.0,
            slenderness_angle: 0.22,
            ..designs[0].factors
        };
        let found = model.score(&own, false).unwrap();
        let mean = |of: fn(&SixFactors) -> f64| {
            designs.iter().map(|design| of(&design.factors).ln()).sum::<f64>() / 240.0
        };
        let height = 0.5 * (5.0_f64.ln() - mean(|f| f.body_height_m));
        let angle = 0.22_f64.ln() - mean(|f| f.slenderness_angle);
        // 240 draws: their chance correlation
        assert!((found.reasons[1] - height).abs() < 0.02, "{found:?} {height}");
        assert!((found.reasons[2] - angle).abs() < 0.02, "{found:?} {angle}");
        for idle in [0, 3, 4, 5] {
            assert!(found.reasons[idle].abs() < 0.02, "{found:?}");
        }
    }

    #[test]
    fn refuses_what_was_not_trained_unless_told() {
        let model = ScoreModel::train(&designs(60), None).unwrap();
        let mut own = model.designs()[3].factors;
        own.body_height_m = 450.0; // cm
        assert!(model.score(&own, true).is_err());
        own.body_height_m = 11.0;
        let fault = model.score(&own, false).unwrap_err().to_string();
        assert!(
            fault.starts_with("body_height_m is 11, but the score was trained from 3."),
            "{fault}"
        );
        let marked = model.score(&own, true).unwrap();
        assert_eq!(marked.outside.len(), 1);
        assert_eq!(marked.outside[0].factor, Factor::BodyHeight);
        own.body_height_m = -1.0;
        let fault = model.score(&own, true).unwrap_err().to_string();
        assert_eq!(fault, "body_height_m is -1, but must be a positive number");
        assert!(matches!(
            ScoreModel::train(&designs(20), None),
            Err(AssessError::TooFewDesigns { given: 20, least: 28 })
        ));
    }
}
