//! Which part of a model explains changes of frequencies, as JSON.

use crate::as_json;
use dolmen::assess::PartFit;
use dolmen_work::changed_part::{ChangedPart, ModelOff};
use serde_json::Value;

/// Every part with the stiffness that it would need, in one direction.
pub(super) fn changed_part(of: &ChangedPart) -> Value {
    let fit = |fit: &PartFit| {
        as_json!({
            "part": fit.part.and_then(|at| of.parts.get(at)).map(|part| part.name()),
            "stiffness_left": fit.factor,
            "stiffness_left_lower": fit.factor_interval[0],
            "stiffness_left_upper": fit.factor_interval[1],
            "chi_squared": fit.chi_squared,
            "p": fit.p_value,
        })
    };
    as_json!({
        "direction": of.direction,
        "modes_hz": of.modes_hz,
        "candidates": of.found.candidates().len(),
        "fits": of.found.parts.iter().map(fit).collect::<Vec<_>>(),
        "all_alike": fit(&of.found.alike),
        "all_alike_explains": of.found.is_alike_possible(),
    })
}

/// Why no part is sought.
pub(super) fn model_off(of: &ModelOff) -> Value {
    as_json!({
        "measured_hz": of.measured_hz,
        "model_hz": of.model_hz,
        "factor": of.factor(),
        "factor_most": ModelOff::allowed(),
    })
}
