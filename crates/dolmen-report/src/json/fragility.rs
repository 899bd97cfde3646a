//! Fragility and risk of a study, as JSON.

use crate::as_json;
use dolmen::assess::{AssessError, FragilityFit};
use dolmen_work::study::{CrossingSide, StateFragility, StudyAnswer};
use serde_json::{Map, Value};

/// Confidence of intervals.
const CONFIDENCE: f64 = 0.95;

/// One object for each combination of inputs, each with one for each state.
///
/// # Errors
/// None for fitted curves.
pub(super) fn fragilities_json(answer: &StudyAnswer) -> Result<Vec<Value>, AssessError> {
    let each = answer.fragilities().iter().map(|one| {
        let states = one.states.iter().map(|state| {
            Ok(as_json!({
                "state": answer.kind.state(state.state),
                "scans": state.scans(),
                "scans_reached": state.reached(),
                "scans_fell_by_themselves": state.fell_alone,
                "scans_lean_beyond_at_rest": state.leans_beyond,
                "probability_without_shaking": state.share_alone(),
                "by_peak_acceleration_m_s2": fit_json(&state.by_acceleration)?,
                "by_measure": by_measure(state)?,
                "beta_of_motions": state.scatter.map(|split| split.of_motions),
                "beta_of_inputs": state.scatter.map(|split| split.of_inputs),
                "beta_of_inputs_95": match &state.scatter {
                    Some(split) => { let found = split.of_inputs_interval(CONFIDENCE)?; Some([found.lower, found.upper]) }
                    None => None,
                },
                "samples_without_curve": state.scatter.map(|split| split.without_curve),
                "motions_enough": state.motions_enough(),
                "annual_rate": state.annual_rate(),
                "annual_rate_of_standing": state.risk.map(|risk| risk.annual_rate),
                "annual_rate_at_ends_95": state.rate_interval,
                "probability_in_50_years": state.probability_in_years(),
                "rate_share_below_hazard": state.risk.map(|risk| risk.share_below_points),
                "rate_share_above_hazard": state.risk.map(|risk| risk.share_above_points),
            }))
        });
        let crossings = one.crossings().into_iter().map(|of| {
            as_json!({
                "states": [answer.kind.state(of.milder), answer.kind.state(of.worse)],
                "peak_acceleration_m_s2": of.at.intensity, "probability": of.at.probability,
                "worse_state_likelier": match of.likelier_is_worse {
                    CrossingSide::Below => "below",
                    CrossingSide::Above => "above",
                },
            })
        });
        Ok(as_json!({
            "combination": one.combination + 1,
            "inputs": answer.combination_words(one.job),
            "scans_usable": one.usable,
            "states": states.collect::<Result<Vec<_>, AssessError>>()?,
            "crossings": crossings.collect::<Vec<_>>(),
        }))
    });
    each.collect()
}

/// One object for each measure of shaking, by the name of its column.
fn by_measure(state: &StateFragility) -> Result<Value, AssessError> {
    let each = state.by_measure.iter();
    let each = each.map(|by| Ok((by.measure.column(), fit_json(&by.fit)?)));
    Ok(Value::Object(each.collect::<Result<Map<_, _>, AssessError>>()?))
}

/// β by each measure of the shaking, within combinations and for all together.
pub(super) fn measures_json(answer: &StudyAnswer) -> Vec<Value> {
    let mut names = vec!["peak_acceleration_m_s2".to_owned()];
    names.extend(answer.measures().iter().map(|measure| measure.column()));
    let each = answer.compare_measures().iter().map(|row| {
        let measures = names.iter().zip(&row.within).zip(&row.together);
        let measures = measures.map(|((name, within), together)| {
            (
                name.clone(),
                as_json!({ "beta": within, "beta_of_all_as_one": together }),
            )
        });
        as_json!({
            "state": answer.kind.state(row.state),
            "combinations": row.combinations,
            "measures": measures.collect::<Map<_, _>>(),
        })
    });
    each.collect()
}

/// Whether capacities by each measure also depend on the earthquake.
pub(super) fn sufficiency_json(answer: &StudyAnswer) -> Vec<Value> {
    let mut names = vec!["peak_acceleration_m_s2".to_owned()];
    names.extend(answer.measures().iter().map(|measure| measure.column()));
    let each = answer.sufficiencies().into_iter().map(|own| {
        let by_measure = own.by_measure.as_ref().map(|all| {
            let each = names.iter().zip(all).map(|(name, of)| {
                let of = as_json!({
                    "slope": of.slope, "slope_error": of.slope_error, "p_value": of.p_value, "motions": of.motions,
                });
                (name.clone(), of)
            });
            each.collect::<Map<_, _>>()
        });
        as_json!({
            "state": answer.kind.state(own.state),
            "against": own.predictor.key(),
            "measures": by_measure.as_ref().ok(),
            "why_not": by_measure.err().map(|why| why.to_string()),
        })
    });
    each.collect()
}

/// Every joint of a stack with the peaks at which it reaches each state.
///
/// # Errors
/// None for fitted curves.
pub(super) fn joints_json(answer: &StudyAnswer) -> Result<Vec<Value>, AssessError> {
    let joints = answer.joint_fragilities().iter().map(|one| {
        let states = one.states.iter().map(|state| {
            Ok(as_json!({
                "state": answer.kind.state(state.state),
                "median_above_m_s2": state.median_between[0],
                "median_at_most_m_s2": state.median_between[1],
                "by_peak_acceleration_m_s2": match state.fit { Some(fit) => fit_json(&Ok(fit))?, None => Value::Null },
            }))
        });
        Ok(as_json!({
            "combination": one.combination + 1, "joint": one.joint + 1, "name": one.name, "gave_way": one.gave_way,
            "states": states.collect::<Result<Vec<_>, AssessError>>()?,
        }))
    });
    joints.collect()
}

fn fit_json(fit: &Result<FragilityFit, AssessError>) -> Result<Value, AssessError> {
    let fit = match fit {
        Ok(fit) => fit,
        Err(why) => return Ok(as_json!({ "why_not": why.to_string() })),
    };
    let (theta, beta) = (fit.theta_interval(CONFIDENCE)?, fit.beta_interval(CONFIDENCE)?);
    Ok(as_json!({
        "theta": fit.curve.theta(), "theta_q025": theta.lower, "theta_q975": theta.upper,
        "beta": fit.curve.beta(), "beta_q025": beta.lower, "beta_q975": beta.upper,
        "ln_theta_error": fit.ln_theta_error, "beta_error": fit.beta_error, "covariance": fit.covariance,
        "log_likelihood": fit.log_likelihood, "reached": fit.reached, "observations": fit.observations,
    }))
}
