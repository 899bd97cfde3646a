//! The six-factor score as JSON.

use super::judgement::severe;
use crate::as_json;
use crate::finite::JsonObject;
use dolmen::assess::Factor;
use dolmen_work::score::{GIVEN_PEAKS_G, GivenAnswer, SCORE_STATES, ScoreAnswer, ScoreQuality};
use serde::Serialize;
use serde_json::Value;

fn by_factor<T: Serialize>(values: impl IntoIterator<Item = T>) -> Value {
    let names = Factor::ALL.iter().map(|factor| factor.name());
    names.zip(values).collect::<JsonObject>().done()
}

/// The score of one pagoda.
pub fn score_json(answer: &ScoreAnswer) -> Value {
    let states = answer.states.iter().map(|one| {
        let score = &one.score;
        as_json!({
            "state": SCORE_STATES[one.state],
            "capacity_m_s2": score.capacity_m_s2,
            "interval_90_m_s2": [one.interval_m_s2.lower, one.interval_m_s2.upper],
            "ln_capacity_sd": score.ln_capacity_sd,
            "ln_shared_sd": score.ln_shared_sd,
            "designs": one.designs,
            "beta": score.beta,
            "percentile": score.percentile,
            "percentile_interval_90": [score.percentile_interval.lower, score.percentile_interval.upper],
            "reasons_ln": by_factor(score.reasons),
            "outside_training": score.outside.iter().map(|one| one.factor.name()).collect::<Vec<_>>(),
        })
    });
    as_json!({
        "file": answer.file,
        "name": { "en": answer.name.en, "ko": answer.name.ko },
        "designs": answer.designs,
        "unlike_the_designs": answer.unlike.iter().map(|one| one.to_string()).collect::<Vec<_>>(),
        "severe_damage": answer.severe_damage.iter().map(severe).collect::<Vec<_>>(),
        "factors": by_factor(answer.factors.values()),
        "trained": by_factor(answer.trained.iter().map(|range| [range.lower, range.upper])),
        "states": states.collect::<Vec<_>>(),
    })
}

/// The score of one pagoda with a measured frequency: that of [`score_json`], and `given`.
pub fn score_given_json(answer: &GivenAnswer) -> Value {
    let of = &answer.frequency;
    let capacity = |[median, lower, upper]: [f64; 3]| as_json!({ "capacity_m_s2": median, "interval_90_m_s2": [lower, upper] });
    let states = answer.states.iter().map(|one| {
        let pairs = one.probability_unknown.iter().zip(&one.probability_given);
        let reached = GIVEN_PEAKS_G.iter().zip(pairs).map(|(peak, (unknown, given))| {
            as_json!({ "peak_g": peak, "stiffness_unknown": unknown, "frequency_given": given })
        });
        as_json!({
            "state": SCORE_STATES[one.state],
            "stiffness_unknown": capacity(one.unknown_m_s2),
            "frequency_given": capacity(one.given_m_s2),
            "probability": reached.collect::<Vec<_>>(),
        })
    });
    let given = as_json!({
        "survey": of.survey,
        "direction": of.direction,
        "measured_hz": of.measured_hz,
        "ln_frequency_sd": of.ln_sd,
        "frequency_on_joints_of_designs_hz": of.computed_hz,
        "draws": answer.draws,
        "effective_draws": answer.effective_draws,
        "stiffness_ratio": answer.stiffness_ratio[0],
        "stiffness_ratio_interval_90": [answer.stiffness_ratio[1], answer.stiffness_ratio[2]],
        "stiffness_ratio_before": [answer.prior_ratio.lower, answer.prior_ratio.upper],
        "states": states.collect::<Vec<_>>(),
    });
    let mut value = score_json(&answer.score);
    value["given"] = given;
    value
}

/// Accuracy of the score, state by state.
pub fn score_quality_json(qualities: &[ScoreQuality], designs: usize) -> Value {
    let states = qualities.iter().map(|one| {
        let shares = one.shares.shares.iter();
        as_json!({
            "state": SCORE_STATES[one.state],
            "designs": one.designs,
            "weights": by_factor(shares.map(|share| {
                as_json!({ "share": share.share, "interval_90": [share.interval.lower, share.interval.upper] })
            })),
            "effects": one.effects.iter().map(|effect| as_json!({
                "factor": effect.factor.name(),
                "from": effect.from,
                "to": effect.to,
                "ln_change": effect.ln_change,
                "ln_change_sd": effect.ln_change_sd,
                "as_published": effect.verdict,
            })).collect::<Vec<_>>(),
            "explained": one.shares.explained,
            "correlation_of_slendernesses": one.slenderness_correlation,
            "held_out": one.held_out,
        })
    });
    as_json!({ "designs": designs, "states": states.collect::<Vec<_>>() })
}
