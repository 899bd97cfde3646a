//! The judgement as JSON: words, colours and the quantities that decided.

use super::damage::damage;
use crate::as_json;
use crate::engineer::damage_words;
use crate::headline::{headline, over_the_years};
use dolmen_words::Language;
use dolmen_work::judgement::{
    DecidedBy, EarthquakeFinding, Evidence, GrownDamage, Growth, Judgement, MissedMode, MovedBy,
    SevereDamage, VersionJudgement, Weight, WindFinding, WindLimit,
};
use serde_json::Value;

/// The judgement of an answer, the structure as it is first.
pub(crate) fn judgement(judgement: &Judgement) -> Value {
    as_json!({
        "colour": judgement.colour().word(),
        "words": words(judgement),
        "headline": judgement.headline().map(|of| headline(of, Language::English)),
        "over_the_years": over_the_years(judgement).map(|of| of.text(Language::English)),
        "finished": judgement.is_done,
        "versions": judgement.versions.iter().map(version).collect::<Vec<_>>(),
    })
}

/// Words of the headline, then those of each worse variant.
fn words(judgement: &Judgement) -> Option<Vec<String>> {
    let mut words = judgement.headline()?.words(Language::English);
    words.extend(judgement.worse().map(|of| {
        let variant = of.variant.as_deref().unwrap_or_default();
        format!("variant {variant}: {}", of.words(Language::English).join(", "))
    }));
    Some(words)
}

fn version(version: &VersionJudgement) -> Value {
    let earthquake = version.earthquake_word();
    as_json!({
        "variant": version.variant,
        "words": version.words(Language::English),
        "colour": version.colour().word(),
        "weight": version.weight.map(weight),
        "crushes": version.crushes,
        "falling_share": version.falling_share,
        "governed_by": version.governed_by.as_ref().map(|by| by.key()),
        "earthquake": {
            "word": earthquake.word(Language::English),
            "colour": earthquake.colour().word(),
            "reasons": version.earthquake.iter().map(finding).collect::<Vec<_>>(),
        },
        "wind": {
            "word": version.wind_word().word(Language::English),
            "colour": version.wind_word().colour().word(),
            "reasons": version.wind.iter().map(in_wind).collect::<Vec<_>>(),
        },
        "evidence": evidence(&version.evidence),
        "tilt_left_out": version.tilt_left_out.as_ref().map(|of| as_json!({ "survey": of.survey, "tilt": of.written })),
        "tilt_beyond_limit": version.tilt_beyond_limit,
        "tilt_near_limit": version.tilt_near_limit,
        "damage_beyond_limit": version.damage_beyond_limit,
        "leans": version.leans.as_ref().map(|of| as_json!({ "survey": of.survey, "tilt": of.tilt })),
        "solution": version.solution.map(|of| as_json!({ "number": of.number, "of": of.of })),
        "after": version.after.as_ref().map(|of| as_json!({ "first": of.first, "second": of.second })),
        "undamped": version.is_undamped,
        "damage": version.damage.iter().map(damage).collect::<Vec<_>>(),
        "severe_damage_left_out": version.basis.severe_damage.iter().map(severe).collect::<Vec<_>>(),
        "grown_damage_left_out": version.basis.grown_damage.iter().map(grown).collect::<Vec<_>>(),
        "inspections_left_out": version.basis.inspections_left_out,
        "cap_left_out": version.basis.is_cap_left_out,
        "wind_left_out": version.basis.is_wind_left_out,
        "loads_left_out": version.basis.is_loads_left_out,
        "load_factor_without_supports": version.basis.load_factor_without_supports,
        "made_up_surveys": version.basis.made_up_surveys,
        "unchecked_stiffness_from": version.basis.unchecked_stiffness_from,
        "assumed_inputs": version.basis.inputs.assumed,
        "inputs": version.basis.inputs.all,
    })
}

pub(super) fn severe(of: &SevereDamage) -> Value {
    let what = damage_words(&of.what).text(Language::English);
    as_json!({ "survey": of.survey, "part": of.part, "what": what })
}

fn grown(of: &GrownDamage) -> Value {
    let what = damage_words(&of.what).text(Language::English);
    let sizes_m = match of.growth {
        Growth::Size { before_m, after_m } => Some([before_m, after_m]),
        Growth::Severity { .. } => None,
    };
    let severities = match of.growth {
        Growth::Size { .. } => None,
        Growth::Severity { before, after } => Some([before.word(), after.word()]),
    };
    as_json!({
        "survey": of.survey, "since": of.since, "part": of.part, "what": what,
        "sizes_m": sizes_m, "severities": severities,
    })
}

fn weight(weight: Weight) -> Value {
    let load_factor_if_right = match weight {
        Weight::Unknown { load_factor_if_right } => load_factor_if_right,
        _ => None,
    };
    as_json!({
        "word": weight.word(Language::English),
        "colour": weight.colour().word(),
        "load_factor_if_right": load_factor_if_right,
    })
}

fn finding(finding: &EarthquakeFinding) -> Value {
    let damage_state = match &finding.decided_by {
        DecidedBy::DamageState(state) | DecidedBy::DamageOfRuns { state, .. } => Some(state),
        _ => None,
    };
    as_json!({
        "word": finding.word.word(Language::English),
        "decided_by": finding.decided_by.key(),
        "motion": finding.motion,
        "part": finding.part,
        "capacity_over_demand": finding.ratio,
        "damage_state": damage_state,
    })
}

fn in_wind(finding: &WindFinding) -> Value {
    as_json!({
        "word": finding.word.word(Language::English),
        "decided_by": finding.limit.map(WindLimit::key),
        "moved_by": match finding.by {
            MovedBy::Wind => "wind",
            MovedBy::Loads => "loads",
            MovedBy::Both => "wind and loads",
            MovedBy::WithEarthquake => "combination with the earthquake",
        },
        "part": finding.part,
        "limit_over_peak": finding.ratio,
    })
}

fn missed_mode(of: &MissedMode) -> Value {
    as_json!({ "direction": of.direction, "mode": of.number, "computed_hz": of.computed_hz })
}

fn evidence(evidence: &Evidence) -> Value {
    let (survey, calibrated_to) = match evidence {
        Evidence::Agrees { survey } | Evidence::NotCompared { survey } | Evidence::Unread { survey } => {
            (Some(survey), None)
        }
        Evidence::Contradicted(of) | Evidence::TooRough(of) => (Some(&of.survey), None),
        Evidence::InDoubt(of) => (Some(&of.survey), None),
        Evidence::MarkedAssumed { survey, .. } => (Some(survey), None),
        Evidence::NotMeasured { calibrated_to } => (None, calibrated_to.as_ref()),
    };
    let contradicted = match evidence {
        Evidence::Contradicted(of) | Evidence::TooRough(of) => Some(of),
        Evidence::MarkedAssumed { farthest, .. } => farthest.as_ref(),
        _ => None,
    };
    let doubt = match evidence {
        Evidence::InDoubt(of) => Some(of),
        _ => None,
    };
    let mode = doubt.and_then(|of| of.mode.as_ref());
    as_json!({
        "word": evidence.key(),
        "colour": evidence.colour().word(),
        "survey": survey,
        "calibrated_to": calibrated_to,
        "direction": contradicted.map(|of| &of.direction).or(mode.and_then(|of| of.direction.as_ref())),
        "measured_hz": contradicted.map(|of| of.measured_hz).or(mode.map(|of| of.measured_hz)),
        "computed_hz": contradicted.map(|of| of.computed_hz).or(mode.map(|of| of.computed_hz)),
        "mode": mode.map(|of| of.number),
        "modes_in_doubt": doubt.map(|of| of.modes),
        "modes_missed": doubt.map(|of| of.missed.iter().map(missed_mode).collect::<Vec<_>>()),
        "unexplained": doubt.and_then(|of| of.unexplained.as_ref()).map(|of| as_json!({
            "direction": of.direction,
            "deviations": of.deviations,
        })),
        "stiffness_off": doubt.and_then(|of| of.stiffness.as_ref()).map(|of| as_json!({
            "direction": of.direction,
            "ratio": of.ratio,
            "deviations": of.deviations,
        })),
    })
}
