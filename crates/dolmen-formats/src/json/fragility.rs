//! Fragility and risk of a study, as JSON.

use crate::study::{CombinationFragility, StudyAnswer, YEARS};
use dolmen::assess::{AssessError, FragilityFit};
use serde_json::{Value, json};

/// Confidence of intervals.
const CONFIDENCE: f64 = 0.95;

/// One object a combination of inputs, with one a state.
///
/// # Errors
/// None for curves as they are fitted.
pub(super) fn fragilities_json(
    answer: &StudyAnswer,
    found: &[CombinationFragility],
) -> Result<Vec<Value>, AssessError> {
    let each = found.iter().map(|one| {
        let states = one.states.iter().map(|state| {
            Ok(json!({
                "state": answer.kind.states()[state.state],
                "by_peak_acceleration_m_s2": fit_json(&state.by_acceleration)?,
                "by_peak_velocity_m_s": fit_json(&state.by_velocity)?,
                "motions_enough": state.motions_enough(),
                "annual_rate": state.risk.map(|risk| risk.annual_rate),
                "probability_in_50_years": state.risk.map(|risk| risk.probability_in(YEARS)),
                "rate_share_below_hazard": state.risk.map(|risk| risk.share_below_points),
                "rate_share_above_hazard": state.risk.map(|risk| risk.share_above_points),
            }))
        });
        let crossings = one.crossings().into_iter().map(|(mild, severe, at, is_below)| {
            json!({
                "states": [answer.kind.states()[mild], answer.kind.states()[severe]],
                "peak_acceleration_m_s2": at.intensity, "probability": at.probability,
                "worse_state_likelier": if is_below { "below" } else { "above" },
            })
        });
        Ok(json!({
            "combination": one.combination + 1,
            "inputs": answer.combination_words(one.job),
            "scans_usable": one.usable,
            "states": states.collect::<Result<Vec<_>, AssessError>>()?,
            "crossings": crossings.collect::<Vec<_>>(),
        }))
    });
    each.collect()
}

fn fit_json(fit: &Result<FragilityFit, AssessError>) -> Result<Value, AssessError> {
    let fit = match fit {
        Ok(fit) => fit,
        Err(why) => return Ok(json!({ "why_not": why.to_string() })),
    };
    let (theta, beta) = (fit.theta_interval(CONFIDENCE)?, fit.beta_interval(CONFIDENCE)?);
    Ok(json!({
        "theta": fit.curve.theta(), "theta_q025": theta.lower, "theta_q975": theta.upper,
        "beta": fit.curve.beta(), "beta_q025": beta.lower, "beta_q975": beta.upper,
        "ln_theta_error": fit.ln_theta_error, "beta_error": fit.beta_error, "covariance": fit.covariance,
        "log_likelihood": fit.log_likelihood, "reached": fit.reached, "observations": fit.observations,
    }))
}
