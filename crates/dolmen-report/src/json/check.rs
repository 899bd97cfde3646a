//! `dolmen check` as JSON.

use super::building::building;
use super::damage::damage;
use super::demand::demand;
use super::judgement::judgement;
use super::loads::loads;
use super::stack::stack;
use crate::as_json;
use dolmen::assess::FrameCheck;
use dolmen_project::{Project, WhyNotIdentified};
use dolmen_words::Language;
use dolmen_work::answer::CheckAnswer;
use dolmen_work::frame::{SECANT_DRIFT_RATIO, Springs, StoreyColumns};
use dolmen_work::judgement::judge_check;
use dolmen_work::state::{Check, DirectionCheck, SensitivityOf, State};
use serde_json::Value;

/// A project's whole check.
pub fn check_json(answer: &CheckAnswer) -> Value {
    let variants = answer
        .variants
        .iter()
        .map(|variant| as_json!({ "name": variant.name, "state": state(&variant.state) }));
    as_json!({
        "project": project(&answer.project, &answer.file),
        "judgement": judgement(&judge_check(answer)),
        "state": answer.state.as_ref().map(state),
        "variants": variants.collect::<Vec<_>>(),
        "sensitivity_of": match answer.sensitivity_of {
            SensitivityOf::LoadFactor => "load_factor",
            SensitivityOf::EqualJoints => "equal_joints_n_m_rad",
            SensitivityOf::FirstMotion => "first_motion_m_s2",
        },
        "sensitivities": answer.sensitivities,
        "unreadable_motions": answer.unreadable_motions.iter().map(|of| as_json!({
            "motion": of.motion, "why": of.why.text(Language::English),
        })).collect::<Vec<_>>(),
    })
}

/// The input, with the warnings that every result carries.
pub(super) fn project(project: &Project, file: &str) -> Value {
    let inputs = project.inputs();
    let inputs = inputs.iter().map(|q| {
        as_json!({
            "path": q.path, "value": q.value, "unit": q.unit, "written": q.written, "cov": q.cov,
            "source": q.source.map(|s| s.word()),
        })
    });
    let warnings = project.warnings.iter();
    as_json!({
        "file": file,
        "schema": project.schema,
        "name": { "en": project.name.en, "ko": project.name.ko },
        "source": project.source,
        "gravity_m_s2": project.gravity_m_s2,
        "inputs": inputs.collect::<Vec<_>>(),
        "from_surveys": project.from_surveys.as_ref().map(|told| as_json!({
            "solution": told.number,
            "solutions": told.of,
            "parts": told.parts.iter().map(|part| as_json!({
                "path": part.path, "survey": part.survey, "unknown": part.unknown.map(why_word),
                "unchecked": part.is_unchecked,
            })).collect::<Vec<_>>(),
        })),
        "damage": project.damage.iter().map(damage).collect::<Vec<_>>(),
        "warnings": warnings.map(|w| as_json!({ "line": w.line, "path": w.path, "message": w.message.text(Language::English) })).collect::<Vec<_>>(),
    })
}

fn why_word(why: WhyNotIdentified) -> &'static str {
    match why {
        WhyNotIdentified::NoSurvey => "no_survey",
        WhyNotIdentified::NoModes => "no_modes",
        WhyNotIdentified::Bounded => "bounded",
        WhyNotIdentified::Underdetermined => "underdetermined",
        WhyNotIdentified::Meet => "meet",
        WhyNotIdentified::Impossible => "impossible",
        WhyNotIdentified::Doubted => "doubted",
        WhyNotIdentified::TooMany { .. } => "too_many",
    }
}

fn state(state: &State) -> Value {
    let check = match &state.check {
        Check::Chain(check) => as_json!({ "chain": check }),
        Check::Frame(directions) => {
            as_json!({ "frame": directions.iter().map(direction).collect::<Vec<_>>() })
        }
        Check::Stack(check) => as_json!({ "stack": stack(check) }),
        Check::Building(check) => as_json!({ "building": building(check) }),
    };
    as_json!({
        "verdict": state.verdict(),
        "check": check,
        "tilts": state.tilts.iter().map(|t| as_json!({
            "survey": t.survey, "direction": t.direction, "tilt": t.tilt, "uplift_tilt": t.uplift_tilt,
            "verdict": t.verdict(),
        })).collect::<Vec<_>>(),
        "contradictions": state.contradictions,
        "spring_fits": state.spring_fits.iter().map(|fit| as_json!({
            "survey": fit.survey, "factor": fit.factor, "not_compared": fit.not_compared,
            "frequencies": fit.frequencies.iter().map(|(direction, found)| as_json!({
                "direction": direction, "measured_hz": found.measured_hz, "computed_hz": found.computed_hz,
            })).collect::<Vec<_>>(),
        })).collect::<Vec<_>>(),
        "loads": state.loads.as_ref().map(loads),
        "demand": state.demand.as_ref().map(demand),
        "sampled": state.sampled,
    })
}

fn direction(direction: &DirectionCheck) -> Value {
    as_json!({
        "direction": direction.direction,
        "check": frame(&direction.check),
        "slipping": direction.slipping.as_ref().map(frame),
        "tenons": direction.tenons.as_ref().map(|tenons| as_json!({
            "bearing": frame(&tenons.bearing),
            "storeys": tenons.storeys.iter().map(|of| as_json!({
                "storey": of.storey + 1,
                "slack_m": of.tenon.slack_m,
                "within_slack_n_m": of.within_slack_n_m,
                "bearing_n_m": of.bearing_n_m(),
                "secant_n_m": of.secant_n_m(),
                "secant_drift_ratio": SECANT_DRIFT_RATIO,
                "crushing_force_n": of.tenon.crushing_force_n,
                "crushing_drift_m": of.crushing_drift_m(),
                "half_stiffness_depth_m": of.tenon.half_stiffness_depth_m,
            })).collect::<Vec<_>>(),
        })),
        "columns": direction.columns.iter().map(columns).collect::<Vec<_>>(),
        "lean": direction.lean.as_ref().map(|lean| as_json!({
            "tilt": lean.tilt, "at_rest": lean.at_rest, "falls_from": lean.most,
        })),
    })
}

fn frame(check: &FrameCheck) -> Value {
    as_json!({
        "geometric_n_m": check.geometric_n_m,
        "level_load_ratios": check.level_load_ratios,
        "stability": check.stability,
        "modes": check.modes,
        "notes": check.notes.iter().map(ToString::to_string).collect::<Vec<_>>(),
    })
}

fn columns(columns: &StoreyColumns) -> Value {
    let springs_n_m = match columns.springs {
        Springs::Beside { stiffness_n_m } => Some(stiffness_n_m),
        Springs::Unknown | Springs::RigidBed | Springs::Grounded | Springs::LessThanBeds { .. } => None,
    };
    as_json!({
        "storey": columns.storey,
        "count": columns.count,
        "axial_n": columns.axial_n,
        "height_m": columns.height_m,
        "bed_stiffness_n_m3": columns.bed_stiffness_n_m3,
        "least_bed_stiffness_n_m3": columns.least_bed_stiffness_n_m3,
        "bed_stiffness_n_m": columns.bed_stiffness_n_m,
        "stands": columns.standing.is_some(),
        "standing": columns.standing,
        "springs_n_m": springs_n_m,
        "curve": columns.curve,
        "swings": columns.swings,
    })
}
