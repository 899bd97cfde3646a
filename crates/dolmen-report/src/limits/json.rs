//! Parts compared with their limits, as JSON.

use crate::as_json;
use dolmen::assess::demand::DriftLimit;
use dolmen_work::part_limit::{Limited, Part, PartLimit};
use serde_json::Value;

/// Every part, and the allowable drift.
pub(crate) fn parts_json(parts: &[PartLimit], limit: Option<&DriftLimit>) -> Value {
    as_json!({
        "storey_drift": limit.map(|limit| as_json!({ "ratio": limit.ratio(), "source": limit.source() })),
        "parts": parts.iter().map(part).collect::<Vec<_>>(),
    })
}

fn part(of: &PartLimit) -> Value {
    as_json!({
        "part": of.part.name(),
        "is": match of.part {
            Part::Storey(_) => "storey",
            Part::BelowFloor(_) => "storey below floor",
            Part::JointBelow(_) => "joint below",
            Part::Damper(_) => "damper",
        },
        "direction": of.direction,
        "limit": match of.limited {
            Limited::Drift => "drift_ratio",
            Limited::BedEdge => "bed_edge_n_m",
            Limited::Room => "room_m",
        },
        "demand": of.demand,
        "capacity": of.capacity,
        "taken": of.taken,
        "demand_over_capacity": of.use_ratio(),
        "verdict": of.verdict(),
    })
}
