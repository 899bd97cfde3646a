//! `dolmen check` as JSON.

use super::building::building;
use super::demand::demand;
use super::judgement::judgement;
use super::stack::stack;
use dolmen::assess::{CentroidEffect, ChainCheck, FrameCheck, Probability, Sensitivity};
use dolmen::stability::{ChainLimits, ChainStability, FrameStability, JointStability, StoreyStability};
use dolmen::structure::NaturalMode;
use dolmen_project::Project;
use dolmen_words::Language;
use dolmen_work::answer::CheckAnswer;
use dolmen_work::judgement::judge_check;
use dolmen_work::state::{Check, DirectionCheck, Sampled, SensitivityOf, State};
use serde_json::{Value, json};

/// A project's whole check.
pub fn check_json(answer: &CheckAnswer) -> Value {
    let variants = answer
        .variants
        .iter()
        .map(|variant| json!({ "name": variant.name, "state": state(&variant.state) }));
    json!({
        "project": project(&answer.project, &answer.file),
        "judgement": judgement(&judge_check(answer)),
        "state": answer.state.as_ref().map(state),
        "variants": variants.collect::<Vec<_>>(),
        "sensitivity_of": match answer.sensitivity_of {
            SensitivityOf::LoadFactor => "load_factor",
            SensitivityOf::EqualJoints => "equal_joints_n_m_rad",
            SensitivityOf::FirstMotion => "first_motion_m_s2",
        },
        "sensitivities": answer.sensitivities.iter().map(sensitivity).collect::<Vec<_>>(),
    })
}

/// What was read, with the warnings that every result carries.
pub(super) fn project(project: &Project, file: &str) -> Value {
    let inputs = project.inputs();
    let inputs = inputs.iter().map(|q| {
        json!({
            "path": q.path, "value": q.value, "unit": q.unit, "written": q.written, "cov": q.cov,
            "source": q.source.map(|s| s.word()),
        })
    });
    let warnings = project.warnings.iter();
    json!({
        "file": file,
        "schema": project.schema,
        "name": { "en": project.name.en, "ko": project.name.ko },
        "source": project.source,
        "gravity_m_s2": project.gravity_m_s2,
        "inputs": inputs.collect::<Vec<_>>(),
        "warnings": warnings.map(|w| json!({ "line": w.line, "path": w.path, "message": w.message.text(Language::English) })).collect::<Vec<_>>(),
    })
}

fn state(state: &State) -> Value {
    let check = match &state.check {
        Check::Chain(check) => json!({ "chain": chain(check) }),
        Check::Frame(directions) => json!({ "frame": directions.iter().map(direction).collect::<Vec<_>>() }),
        Check::Stack(check) => json!({ "stack": stack(check) }),
        Check::Building(check) => json!({ "building": building(check) }),
    };
    json!({
        "verdict": state.verdict().word(),
        "check": check,
        "tilts": state.tilts.iter().map(|t| json!({
            "survey": t.survey, "direction": t.direction, "tilt": t.tilt, "uplift_tilt": t.uplift_tilt,
            "verdict": t.verdict().word(),
        })).collect::<Vec<_>>(),
        "contradictions": state.contradictions.iter().map(|c| json!({
            "survey": c.survey, "direction": c.direction, "measured_hz": c.measured_hz, "computed_hz": c.computed_hz,
        })).collect::<Vec<_>>(),
        "spring_fits": state.spring_fits.iter().map(|fit| json!({
            "survey": fit.survey, "factor": fit.factor, "not_compared": fit.not_compared,
            "frequencies": fit.frequencies.iter().map(|(direction, found)| json!({
                "direction": direction, "measured_hz": found.measured_hz, "computed_hz": found.computed_hz,
            })).collect::<Vec<_>>(),
        })).collect::<Vec<_>>(),
        "demand": state.demand.as_ref().map(demand),
        "sampled": state.sampled.as_ref().map(sampled),
    })
}

fn chain(check: &ChainCheck) -> Value {
    json!({
        "limits": limits(&check.limits),
        "stability": check.stability.as_ref().map(chain_stability),
        "modes": modes(&check.modes),
        "centroids": check.centroids.iter().map(centroid).collect::<Vec<_>>(),
    })
}

fn limits(limits: &ChainLimits) -> Value {
    json!({
        "gravity_moment_n_m_rad": limits.gravity_moment_n_m_rad,
        "published_critical_n_m_rad": limits.published_critical_n_m_rad,
        "published_buckling_n_m_rad": limits.published_buckling_n_m_rad,
        "published_ratio": limits.published_ratio,
        "necessary_n_m_rad": limits.necessary_n_m_rad,
        "published_eigenvalues_n_m_rad": limits.published_eigenvalues_n_m_rad,
        "published_critical_factor": limits.published_critical_factor,
        "published_buckling_factor": limits.published_buckling_factor,
        "necessary_factor": limits.necessary_factor,
        "equal_joints_n_m_rad": limits.equal_joints_n_m_rad,
    })
}

fn chain_stability(stability: &ChainStability) -> Value {
    let joint = |joint: &JointStability| {
        json!({
            "stiffness_n_m_rad": joint.stiffness_n_m_rad,
            "stiffness_least_n_m_rad": joint.stiffness_least_n_m_rad,
            "margin": joint.margin,
            "lean_moment_n_m_rad": joint.lean_moment_n_m_rad,
            "uplift_moment_n_m": joint.uplift_moment_n_m,
            "uplift_tilt_rad": joint.uplift_tilt_rad,
        })
    };
    json!({
        "joints": stability.joints.iter().map(joint).collect::<Vec<_>>(),
        "load_factor": stability.load_factor,
        "stiffness_factor": stability.stiffness_factor,
        "stiffness_factor_least": stability.stiffness_factor_least,
        "stiffness_factor_most": stability.stiffness_factor_most,
        "failing_joint": stability.failing_joint,
        "lean_amplification": stability.lean_amplification,
        "side_support_counted": stability.side_support_counted,
        "verdict": stability.verdict.word(),
    })
}

fn centroid(effect: &CentroidEffect) -> Value {
    json!({
        "link": effect.link,
        "change": effect.change,
        "published_critical_n_m_rad": effect.published_critical_n_m_rad,
        "necessary_n_m_rad": effect.necessary_n_m_rad,
        "equal_joints_n_m_rad": effect.equal_joints_n_m_rad,
        "load_factor": effect.load_factor,
    })
}

fn direction(direction: &DirectionCheck) -> Value {
    json!({
        "direction": direction.direction,
        "check": frame(&direction.check),
        "slipping": direction.slipping.as_ref().map(frame),
    })
}

fn frame(check: &FrameCheck) -> Value {
    json!({
        "geometric_n_m": check.geometric_n_m,
        "level_load_ratios": check.level_load_ratios,
        "stability": check.stability.as_ref().map(frame_stability),
        "modes": modes(&check.modes),
        "notes": check.notes.iter().map(ToString::to_string).collect::<Vec<_>>(),
    })
}

fn frame_stability(stability: &FrameStability) -> Value {
    let storey = |storey: &StoreyStability| {
        json!({
            "stiffness_n_m": storey.stiffness_n_m,
            "geometric_n_m": storey.geometric_n_m,
            "stiffness_least_n_m": storey.stiffness_least_n_m,
            "margin": storey.margin,
        })
    };
    json!({
        "storeys": stability.storeys.iter().map(storey).collect::<Vec<_>>(),
        "load_factor": stability.load_factor,
        "falling_shape": stability.falling_shape,
        "verdict": stability.verdict.word(),
    })
}

/// Natural modes, the same for every kind of structure.
pub(super) fn modes(modes: &[NaturalMode]) -> Value {
    let mode = |mode: &NaturalMode| {
        json!({
            "omega_squared": mode.omega_squared,
            "frequency_hz": mode.frequency_hz,
            "displacement": mode.displacement,
            "coordinates": mode.coordinates,
        })
    };
    modes.iter().map(mode).collect()
}

fn sampled(sampled: &Sampled) -> Value {
    json!({
        "unstable": probability(&sampled.unstable),
        "load_factors": sampled.load_factors,
        "inputs": sampled.inputs,
    })
}

fn probability(p: &Probability) -> Value {
    json!({
        "count": p.count, "samples": p.samples, "estimate": p.estimate, "lower": p.lower, "upper": p.upper,
        "confidence": p.confidence, "seed": p.seed,
    })
}

fn sensitivity(s: &Sensitivity) -> Value {
    json!({ "input": s.input, "value": s.value, "elasticity": s.elasticity, "cov": s.cov })
}
