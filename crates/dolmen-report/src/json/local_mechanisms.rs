//! Local mechanisms of a stack as codes require, as JSON.

use crate::as_json;
use dolmen::stability::stack::RigidPart;
use dolmen_work::state::{LocalMechanismAgainstSite, StackAnswer};
use serde_json::Value;

/// The code of the formulas.
const CODE: &str = "Circolare 7/2019 to NTC 2018, C8.7.1.2.1";

/// The moving part in each direction, and its capacity.
pub(super) fn local_mechanisms(answer: &StackAnswer) -> Value {
    let found = answer.local_mechanisms.iter().flatten();
    let rows = found.map(|row| {
        let capacity = row.capacity.as_ref();
        let mechanism = capacity.map(|capacity| &capacity.mechanism);
        let displacement = capacity.and_then(|capacity| capacity.displacement);
        as_json!({
            "direction": row.direction,
            "multiplier": mechanism.map(|mechanism| mechanism.multiplier),
            "parts": mechanism.map(|mechanism| mechanism.parts.iter().map(|of| part(answer, of)).collect::<Vec<_>>()),
            "participating_mass_kg": mechanism.map(|mechanism| mechanism.mass_kg),
            "participating_ratio": mechanism.map(|mechanism| mechanism.mass_ratio),
            "slides": mechanism.map(|mechanism| mechanism.slides),
            "activation_m_s2": capacity.map(|capacity| capacity.activation_m_s2),
            "ground_by_force_m_s2": capacity.and_then(|capacity| capacity.by_force_m_s2),
            "overturning_m": displacement.map(|of| of.overturning_m),
            "displacement_limit_m": displacement.map(|of| of.limit_m),
            "acceleration_at_limit_m_s2": displacement.map(|of| of.acceleration_m_s2),
            "period_s": displacement.map(|of| of.period_s),
        })
    });
    as_json!({ "code": CODE, "verified": false, "rows": rows.collect::<Vec<_>>() })
}

fn part(answer: &StackAnswer, part: &RigidPart) -> Value {
    let blocks = answer.stack.blocks();
    let name = |block: &usize| blocks.get(*block).map(|block| block.name.as_str());
    as_json!({
        "blocks": part.blocks.iter().map(name).collect::<Vec<_>>(),
        "weight_n": part.weight_n,
        "centroid_m": part.centroid_m,
        "moves": part.moves,
        "rises": part.rises,
    })
}

/// The same against a site.
pub(super) fn local_mechanisms_demand(all: &[LocalMechanismAgainstSite]) -> Value {
    let rows = all.iter().map(|against| {
        let displacement = against.demand.by_displacement;
        as_json!({
            "direction": against.capacity.mechanism.direction,
            "ground_m_s2": against.demand.ground_m_s2,
            "ratio_by_force": against.demand.by_force,
            "ratio_by_displacement": displacement.map(|of| of.ratio),
            "displacement_m": displacement.map(|of| of.displacement_m),
            "damping_ratio": displacement.map(|of| of.damping_ratio),
        })
    });
    as_json!({ "code": CODE, "verified": false, "rows": rows.collect::<Vec<_>>() })
}
