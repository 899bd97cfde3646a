//! The check of a stack, as JSON.

use super::local_mechanisms::local_mechanisms;
use crate::as_json;
use dolmen::assess::{Crushing, SettleRun};
use dolmen::stability::stack::{CutLimits, MovedStack, MovedSupports, MovementEnding};
use dolmen::structure::stack::{Body, Solid, Stack};
use dolmen_project::SurveyedLean;
use dolmen_work::state::{MODES_SHOWN, StackAnswer, StackFrequencies};
use serde_json::Value;

/// Blocks, joints and limits.
pub(super) fn stack(answer: &StackAnswer) -> Value {
    let (stack, check) = (&answer.stack, &answer.check);
    let limits = &check.limits;
    let name = |block: &usize| stack.blocks().get(*block).map(|block| block.name.as_str());
    let names = |group: &Vec<usize>| group.iter().map(name).collect::<Vec<_>>();
    as_json!({
        "blocks": stack.blocks().iter().map(|block| as_json!({
            "name": block.name, "mass_kg": block.mass_kg(), "volume_m3": block.solid.volume_m3(),
            "centroid_m": block.solid.centroid_m(), "bounds_m": block.solid.bounds_m(),
        })).collect::<Vec<_>>(),
        "joints": joints(stack),
        "lean_as_surveyed": answer.lean.as_ref().map(lean),
        "height_m": stack.height_m(),
        "mass_kg": stack.mass_kg(),
        "cuts": limits.cuts.iter().map(|cut| self::cut(cut, names(&cut.cut.blocks))).collect::<Vec<_>>(),
        "standing": limits.standing.to_string(),
        "gravity_margin": limits.gravity_margin,
        "verdict": check.verdict,
        "settle_run": check.settle_run.as_ref().map(settle_run),
        "supports": check.supports.as_ref().map(|supports| self::supports(stack, supports)),
        "capacity": check.capacity,
        "crushing": check.crushing.as_ref().map(crushing),
        "frequencies": answer.frequencies.as_ref().map(frequencies),
        "frequency_by_height": answer.frequency_by_height.iter().map(|of| as_json!({
            "storeys": of.storeys,
            "points": of.points.iter().map(|point| as_json!({
                "body_height_m": point.body_height_m, "height_m": point.height_m, "frequency_hz": point.frequency_hz,
            })).collect::<Vec<_>>(),
        })).collect::<Vec<_>>(),
        "side_supports_in_frequencies": answer.beside,
        "local_mechanisms": local_mechanisms(answer),
        "period_of_thumb_s": check.period_of_thumb.period_s,
        "notes": check.notes.iter().map(ToString::to_string).collect::<Vec<_>>(),
        "uplift": limits.uplift,
        "sliding": limits.sliding,
        "governing": limits.governing,
        "governing_with_ties": limits.governing_with_ties,
        "soil_factor": limits.footing.map_or(1.0, |footing| footing.factor()),
        "statically_determinate": limits.statically_determinate,
        "mechanism": check.analysis.as_ref().and_then(|analysis| analysis.mechanism.as_ref()),
        "undecided": limits.undecided.iter().map(names).collect::<Vec<_>>(),
    })
}

/// The survey, and its slope in the model.
pub(super) fn lean(of: &SurveyedLean) -> Value {
    as_json!({ "survey": of.survey, "slope": of.slope })
}

/// The capacity without crushing edges.
fn crushing(of: &Crushing) -> Value {
    as_json!({
        "strength_pa": of.strength_pa,
        "governs": of.governs(),
        "moves_at_g": of.moves_at_g,
        "uncrushed_g": of.uncrushed_g,
        "uncrushed_verdict": of.uncrushed_verdict,
    })
}

/// The run under its own weight.
fn settle_run(of: &SettleRun) -> Value {
    match of {
        SettleRun::Stood {
            settlement_m,
            length_s,
        } => {
            as_json!({ "kind": "stood", "settlement_m": settlement_m, "length_s": length_s })
        }
        SettleRun::Fell { block } => as_json!({ "kind": "fell", "block": block }),
        SettleRun::NoRest { why } => {
            as_json!({ "kind": "no_rest", "why": why.as_ref().map(ToString::to_string) })
        }
        SettleRun::TooMany { stones } => {
            as_json!({ "kind": "too_many", "stones": stones, "stones_most": SettleRun::STONES_MOST })
        }
    }
}

/// Its behaviour while its supports move.
pub(super) fn supports(stack: &Stack, supports: &MovedSupports) -> Value {
    let (kind, falls_by_factor) = match supports.ending {
        MovementEnding::Falls { by_factor } => ("falls", Some(by_factor)),
        MovementEnding::Stands => ("stands", None),
        MovementEnding::NotFollowed => ("not_followed", None),
    };
    let state = |moved: &MovedStack| {
        as_json!({
            "factor": moved.factor,
            "reactions": moved.reactions.iter().map(|reaction| as_json!({
                "under": stack.name(Body::Block(reaction.block)), "force_n": reaction.force_n,
            })).collect::<Vec<_>>(),
            "mechanism": moved.mechanism,
            "slip_m": moved.slip_m,
            "corners_m": moved.solids.iter().map(Solid::vertices_m).collect::<Vec<_>>(),
        })
    };
    as_json!({
        "movements": stack.support_movements().iter().map(|movement| as_json!({
            "under": stack.name(Body::Block(movement.block)), "movement_m": movement.movement_m,
        })).collect::<Vec<_>>(),
        "ending": kind,
        "stands_to_factor": supports.last.factor,
        "falls_by_factor": falls_by_factor,
        "small": state(&supports.small),
        "given": supports.given.as_ref().map(state),
        "last": state(&supports.last),
        "jumps": supports.jumps,
        "residual": supports.residual,
        "steps": supports.steps,
    })
}

fn frequencies(frequencies: &StackFrequencies) -> Value {
    match frequencies {
        StackFrequencies::Known { modes, sways } => as_json!({
            "modes": modes.iter().take(MODES_SHOWN).map(|mode| as_json!({
                "frequency_hz": mode.frequency_hz, "effective_mass_ratio": mode.effective_mass_ratio, "shape": mode.shape,
            })).collect::<Vec<_>>(),
            "sway_x_hz": sways[0].map(|(_, hz)| hz),
            "sway_y_hz": sways[1].map(|(_, hz)| hz),
        }),
        StackFrequencies::Refused(why) => as_json!({ "refused": why.english }),
    }
}

fn joints(stack: &Stack) -> Vec<Value> {
    let of = |joint: &dolmen::structure::stack::Joint| {
        let material = &joint.material;
        as_json!({
            "lower": stack.name(joint.lower), "upper": stack.name(Body::Block(joint.upper)),
            "origin_m": joint.origin_m, "axes": joint.axes, "corners_m": joint.patch.corners_m,
            "area_m2": joint.patch.moments().area_m2,
            "friction_static": material.friction_static, "friction_kinetic": material.friction_kinetic,
            "cohesion_pa": material.cohesion_pa, "tension_pa": material.tension_pa,
            "compressive_strength_pa": material.compressive_strength_pa,
            "normal_stiffness_pa_m": material.normal_stiffness_pa_m,
            "shear_stiffness_pa_m": material.shear_stiffness_pa_m,
            "damping_ratio": material.damping_ratio,
            "normal_restitution": material.normal_restitution,
            "rocking_restitution": material.rocking_restitution,
        })
    };
    stack.joints().iter().map(of).collect()
}

fn cut(cut: &CutLimits, blocks: Vec<Option<&str>>) -> Value {
    as_json!({
        "above": cut.above,
        "blocks": blocks,
        "weight_n": cut.weight_n,
        "centroid_m": cut.centroid_m,
        "origin_m": cut.origin_m,
        "area_m2": cut.area_m2,
        "resultant_m": cut.resultant_m,
        "depth_m": cut.depth_m,
        "crushed_m": cut.crushed_m,
        "gravity_margin": cut.gravity_margin,
        "uplift": cut.uplift,
        "uplift_with_ties": cut.uplift_with_ties,
        "sliding": cut.sliding,
        "sliding_with_ties": cut.sliding_with_ties,
        "standing": cut.standing.to_string(),
    })
}
