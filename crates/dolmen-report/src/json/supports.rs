//! A stack with slowly moving supports, over time, as JSON.

use super::simulation::outcome_of;
use super::stack::{lean, supports};
use crate::as_json;
use dolmen_work::stack::{SupportsRun, SupportsSimulation};
use serde_json::Value;

/// The movement of the supports, the result of each run, and that of the static check.
pub(crate) fn supports_json(of: &SupportsSimulation) -> Value {
    as_json!({
        "file": of.file,
        "name": { "en": of.name.en, "ko": of.name.ko },
        "variant": of.variant,
        "lean_as_surveyed": of.lean.as_ref().map(lean),
        "falls_at_factor": of.falls_at(),
        "falls_at_m": of.falls_at().map(|factor| of.length_m(factor)),
        "factor_most": of.factor_most,
        "limit_analysis": supports(&of.stack, &of.followed),
        "runs": of.runs.iter().map(|run| run_json(of, run)).collect::<Vec<_>>(),
        "laws_left_out": of.left_out.iter().map(|refused| as_json!({
            "law": refused.law.name(), "why": refused.why,
        })).collect::<Vec<_>>(),
    })
}

fn run_json(of: &SupportsSimulation, run: &SupportsRun) -> Value {
    let (moved, history) = (&run.moved, &run.moved.history);
    as_json!({
        "law": run.law.name(),
        "speed_m_s": moved.slow.ground.speed_m_s(),
        "own_time_s": moved.slow.own_time_s,
        "duration_s": history.time_s.last(),
        "time_step_s": history.time_step_s,
        "steps": history.steps,
        "gave_way_at_factor": moved.gave_way.map(|gave_way| gave_way.factor),
        "gave_way_at_m": moved.gave_way.map(|gave_way| of.length_m(gave_way.factor)),
        "gave_way_at_s": moved.gave_way.map(|gave_way| gave_way.at_s),
        "fell_at_factor": moved.fell_at(),
        "reached_factor": moved.reached(),
        "energy_made_ratio": history.energy_made_ratio(),
        "outcome": outcome_of(&of.stack, history),
    })
}
