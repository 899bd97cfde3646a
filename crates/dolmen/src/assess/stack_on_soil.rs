//! The limit of a stack on its soil, from limit analysis on rigid ground.

use super::AssessError;
use crate::stability::stack::{
    LimitAnalysis, LimitAnalysisStatus, OnSoil, Shaking, Threshold, limit_analysis_undilated,
};
use crate::structure::stack::Stack;

/// Largest number of analyses with turned loads. Our choice: each has a tenth of the error of the one before on common soils.
const ROUNDS_MOST: usize = 6;
/// Relative difference of two rounds at which the limit counts as found. Our choice.
const SETTLED: f64 = 1e-7;

/// The acceleration on the soil at which a stack begins to move, from that of the limit analysis on rigid ground.
///
/// ```text
/// a_0 without the horizontal parts that vertical static loads have on the turned footing, then a_n with those at θ(a_n-1)
/// a_0, a_2, ... are too large, a_1, a_3, ... too small
/// ```
///
/// # Errors
/// Those of [`limit_analysis`](crate::stability::stack::limit_analysis).
pub(super) fn on_soil(
    stack: &Stack,
    soil: &OnSoil,
    analysis: &LimitAnalysis,
    rigid: &Threshold,
) -> Result<Threshold, AssessError> {
    let mut at = soil.threshold(rigid);
    if stack.static_loads().iter().all(|load| load.force_n[2] == 0.0) {
        return Ok(at);
    }
    for _ in 0..ROUNDS_MOST {
        let Some(loads) = soil.with_turned_loads(stack, &analysis.loads, &at) else {
            return Ok(at);
        };
        let turned = LimitAnalysis {
            loads,
            shaking: Shaking::Along(at.direction),
            ..analysis.clone()
        };
        let next = match limit_analysis_undilated(stack, &turned)?.analysis.status {
            LimitAnalysisStatus::Limited(found) => soil.threshold(&found),
            LimitAnalysisStatus::Unlimited => return Ok(at),
            LimitAnalysisStatus::DoesNotStand => Threshold {
                acceleration_m_s2: 0.0,
                acceleration_g: 0.0,
                ..at
            },
        };
        let difference = (next.acceleration_m_s2 - at.acceleration_m_s2).abs();
        let is_found = difference <= SETTLED * at.acceleration_m_s2.abs();
        at = match next.acceleration_m_s2 < at.acceleration_m_s2 || !is_found {
            true => next,
            false => at,
        };
        if is_found {
            break;
        }
    }
    Ok(at)
}
