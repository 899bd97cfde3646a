//! Checks whether each factor changes the capacity in the published direction.

use super::factors::{Factor, SixFactors};
use super::model::ScoreModel;
use crate::assess::AssessError;
use crate::numeric::{normal_quantile, quantile};
use crate::structure::stack::{PagodaFactors, PagodaSlenderness};

/// A factor moves between this quantile of the designs and its complement. Our choice.
const TAIL: f64 = 0.1;
/// Confidence level at which the direction of an effect is significant. Our choice.
const CONFIDENCE: f64 = 0.9;

/// Significance of the effect of a factor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub enum EffectVerdict {
    /// The capacity changes in the published direction.
    #[cfg_attr(feature = "serde", serde(rename = "holds"))]
    Holds,
    /// It changes in the opposite direction.
    #[cfg_attr(feature = "serde", serde(rename = "contradicted"))]
    Contradicted,
    /// The effect is not significant.
    #[cfg_attr(feature = "serde", serde(rename = "not seen"))]
    NotSeen,
}

/// Change of the capacity of the median design with one factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FactorEffect {
    /// The factor. tan α and λ vary together, so λ represents both.
    pub factor: Factor,
    /// Start value, in the unit of the factor.
    pub from: f64,
    /// End value.
    pub to: f64,
    /// Change of ln θ.
    pub ln_change: f64,
    /// Its standard deviation, from the uncertainty of the surface.
    pub ln_change_sd: f64,
    /// Significance of the change, at 90 % confidence.
    pub verdict: EffectVerdict,
}

impl ScoreModel {
    /// Moves each factor of the median design of `all` alone, from its 10 % to its 90 % quantile; tan α follows λ. The same `all` for several
    /// states makes their effects comparable.
    ///
    /// # Errors
    /// The errors of quantiles, and of impossible pagodas.
    ///
    /// # Source
    /// Directions: Kim, N., Koo, I. Y. and Hong, S. G. (2018), Figs. 13 and 19 (falls only; the source has no DS1 to DS3).
    pub fn effects(&self, all: &[SixFactors]) -> Result<Vec<FactorEffect>, AssessError> {
        let at = |axis: usize, p: f64| {
            let values: Vec<f64> = all.iter().map(|factors| factors.values()[axis]).collect();
            quantile(&values, p)
        };
        let mut middle = [0.0; 6];
        for (axis, middle) in middle.iter_mut().enumerate() {
            *middle = at(axis, 0.5)?;
        }
        let mut found = Vec::with_capacity(5);
        for (axis, factor) in Factor::ALL.into_iter().enumerate() {
            if factor == Factor::SlendernessAngle {
                continue; // tan α follows from the others
            }
            let ends = [at(axis, TAIL)?, at(axis, 1.0 - TAIL)?];
            let mut places = [[0.0; 6]; 2];
            for (place, end) in places.iter_mut().zip(ends) {
                let mut own = middle;
                own[axis] = end;
                *place = made(&own)?.coordinates()?;
            }
            let change = self.difference(&places[0], &places[1]);
            let least = normal_quantile(0.5 + 0.5 * CONFIDENCE)? * change.sd;
            found.push(FactorEffect {
                factor,
                from: ends[0],
                to: ends[1],
                ln_change: change.value,
                ln_change_sd: change.sd,
                verdict: if change.sd == 0.0 || change.value.abs() <= least {
                    EffectVerdict::NotSeen
                } else if change.value * factor.published_direction() > 0.0 {
                    EffectVerdict::Holds
                } else {
                    EffectVerdict::Contradicted
                },
            });
        }
        Ok(found)
    }
}

/// The pagoda with these factors; tan α follows from the others.
fn made(values: &[f64; 6]) -> Result<SixFactors, AssessError> {
    SixFactors::of_pagoda(&PagodaFactors {
        storeys: values[0].round() as u32,
        body_height_m: values[1],
        slenderness: PagodaSlenderness::Body(values[3]),
        taper_rad: values[4],
        body_base_height_ratio: values[5],
        ..PagodaFactors::default()
    })
}

#[cfg(test)]
mod tests {
    use super::super::model::TrainedDesign;
    use super::*;
    use crate::assess::Fragility;
    use crate::numeric::Random;

    /// A power law: height in the published direction, storeys in the opposite one, no effect of the taper.
    #[test]
    fn exact_effects_in_a_law_of_powers() {
        let mut random = Random::new(2, 0);
        let designs: Vec<TrainedDesign> = (0..90)
            .map(|i| {
                let mut u = |low: f64, high: f64| low + (high - low) * random.uniform();
                let values = [
                    f64::from([3, 5, 7][i % 3]),
                    u(3.0, 8.0),
                    0.0,
                    u(2.6, 4.4),
                    u(0.06, 0.13),
                    u(1.2, 3.6),
                ];
                let factors = made(&values).unwrap();
                let theta = factors.body_height_m.powf(0.8) * f64::from(factors.storeys).powf(0.3);
                let noise = (0.02 * random.normal()).exp();
                let fragility = Fragility::new(theta * noise, 0.4).unwrap();
                TrainedDesign { factors, fragility }
            })
            .collect();
        let all: Vec<SixFactors> = designs.iter().map(|d| d.factors).collect();
        let found = ScoreModel::train(&designs, None).unwrap().effects(&all).unwrap();
        let of = |factor: Factor| found.iter().find(|one| one.factor == factor).unwrap();
        let height = of(Factor::BodyHeight);
        assert_eq!(height.verdict, EffectVerdict::Holds);
        let exact = 0.8 * (height.to / height.from).ln();
        assert!(
            (height.ln_change - exact).abs() < 4.0 * height.ln_change_sd,
            "{height:?} {exact}"
        );
        assert!(height.ln_change_sd < 0.03, "{height:?}");
        assert_eq!(of(Factor::Storeys).verdict, EffectVerdict::Contradicted);
        assert_eq!(of(Factor::Taper).verdict, EffectVerdict::NotSeen);
        assert_eq!(found.len(), 5);
        // a constant factor has no significant effect
        let flat: Vec<TrainedDesign> = designs.into_iter().filter(|d| d.factors.storeys == 5).collect();
        let all: Vec<SixFactors> = flat.iter().map(|d| d.factors).collect();
        let found = ScoreModel::train(&flat, None).unwrap().effects(&all).unwrap();
        assert_eq!(found[0].verdict, EffectVerdict::NotSeen, "{:?}", found[0]);
    }
}
