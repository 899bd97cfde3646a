//! A suite of motions, as JSON.

use crate::as_json;
use dolmen_records::motions::Orientation;
use dolmen_work::motion::{NotTaken, SuiteAnswer, SuiteMember};
use serde_json::Value;

/// Everything but the samples.
pub fn suite_json(answer: &SuiteAnswer) -> Value {
    let not_taken = answer.not_taken.iter().map(|(file, why)| match why {
        NotTaken::Vertical => as_json!({ "file": file, "kind": "vertical", "why": null }),
        NotTaken::CopyOf { file: first } => as_json!({ "file": file, "kind": "copy", "why": first }),
        NotTaken::Refused { why } => as_json!({ "file": file, "kind": "refused", "why": why.english }),
    });
    as_json!({
        "demand": answer.demand,
        "damping_ratio": answer.damping_ratio,
        "count": answer.rule.count,
        "factor_least": answer.rule.factors[0],
        "factor_most": answer.rule.factors[1],
        "least_share": answer.rule.least_share,
        "alike_most": answer.rule.alike_most,
        "candidates": answer.candidates,
        "without_direction": answer.without_direction,
        "is_kept": answer.is_kept(),
        "misfit": answer.misfit,
        "worst_period_s": answer.worst_s,
        "members": answer.members.iter().map(member).collect::<Vec<_>>(),
        "not_taken": not_taken.collect::<Vec<_>>(),
        "period_s": answer.periods_s,
        "target_acceleration_m_s2": answer.target_m_s2,
        "mean_acceleration_m_s2": answer.mean_m_s2,
    })
}

fn member(member: &SuiteMember) -> Value {
    let azimuth = match member.orientation {
        Some(Orientation::Horizontal { azimuth_deg }) => Some(azimuth_deg),
        _ => None,
    };
    as_json!({
        "name": member.name,
        "file": member.file,
        "channel": member.channel,
        "azimuth_deg": azimuth,
        "event": member.origin.event,
        "station": member.origin.station,
        "factor": member.factor,
        "is_matched": member.matched.is_some(),
        "peak_acceleration_m_s2": member.peak_m_s2(),
        "misfit": member.misfit,
        "pseudo_acceleration_m_s2": member.acceleration_m_s2,
    })
}
