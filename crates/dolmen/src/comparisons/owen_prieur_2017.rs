//! Shapley shares of a sum of two dependent inputs: Owen and Prieur (2017), section 3.

use super::{Case, ValidationError};
use crate::assess::{AssessError, Factor, Fragility, SixFactors, TrainedDesign, factor_shares};
use crate::numeric::normal_quantile;

const SOURCE: &str = "Owen & Prieur (2017)";
const NOTE: &str = "Two normal inputs, correlation −.77 as theory has it for tan α and λ. The closed form against shares of what surfaces explain of 900 designs left out, hence .005.";
const CORRELATION: f64 = -0.77;
/// Number of points of each of two independent inputs, in the middle of equal intervals.
const POINTS: usize = 30;

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let mut places = Vec::with_capacity(POINTS);
    for i in 0..POINTS {
        places.push(normal_quantile((i as f64 + 0.5) / POINTS as f64).map_err(AssessError::from)?);
    }
    let spread = (places.iter().map(|z| z * z).sum::<f64>() / POINTS as f64).sqrt();
    let mut designs = Vec::with_capacity(POINTS * POINTS);
    for a in &places {
        for b in &places {
            let first = a / spread;
            let second = CORRELATION * first + (1.0 - CORRELATION * CORRELATION).sqrt() * b / spread;
            designs.push(TrainedDesign {
                factors: SixFactors {
                    storeys: 1,
                    body_height_m: 1.0,
                    slenderness_angle: first.exp(),
                    body_slenderness: second.exp(),
                    taper_rad: 0.1,
                    body_base_height_ratio: 1.0,
                },
                fragility: Fragility::new((first + 0.5 * second).exp(), 0.4)?,
            });
        }
    }
    let found = factor_shares(&designs, 0, 0)?;
    let share = |factor: Factor| {
        let own = found.shares.iter().find(|share| share.factor == factor);
        own.map_or(f64::NAN, |own| own.share)
    };
    let row = |what: &str, published: f64, computed: f64| Case {
        source: SOURCE,
        what: what.to_owned(),
        unit: "",
        published,
        computed,
        tolerance: 0.005,
        corrected: None,
        note: NOTE,
    };
    Ok(vec![
        row(
            "x₁ + x₂/2: share of x₁",
            0.818_047,
            share(Factor::SlendernessAngle),
        ),
        row(
            "x₁ + x₂/2: share of x₂",
            0.181_953,
            share(Factor::BodySlenderness),
        ),
    ])
}
