//! Loose stones that settle, as JSON.

use crate::as_json;
use dolmen::blocks::{LooseEnding, LooseStones};
use dolmen_work::stack::{SettledRun, SettledSimulation};
use serde_json::Value;

/// How the stones end by each law, and how far the two laws are apart.
pub(crate) fn settled_json(of: &SettledSimulation) -> Value {
    let apart = of.apart().map(|apart| {
        as_json!({
            "block": of.drawn.blocks()[apart.block].name,
            "distance_m": apart.distance_m,
        })
    });
    as_json!({
        "file": of.file,
        "name": { "en": of.name.en, "ko": of.name.ko },
        "variant": of.variant,
        "motion": of.motion.as_ref().map(|motion| motion.motion.name()),
        "laws_differ": of.laws_differ(),
        "laws_apart": apart,
        "runs": of.runs.iter().map(|run| run_json(of, run)).collect::<Vec<_>>(),
        "laws_left_out": of.left_out.iter().map(|refused| as_json!({
            "law": refused.law.name(), "why": refused.why,
        })).collect::<Vec<_>>(),
    })
}

fn run_json(of: &SettledSimulation, run: &SettledRun) -> Value {
    as_json!({
        "law": run.law.name(),
        "settled": stones_json(of, &run.settled),
        "shaken": run.shaken.as_ref().map(|shaken| stones_json(of, shaken)),
    })
}

fn stones_json(of: &SettledSimulation, stones: &LooseStones) -> Value {
    let name = |block: usize| of.drawn.blocks().get(block).map(|block| block.name.as_str());
    let outcome = match stones.ending {
        LooseEnding::Stood => as_json!({ "kind": "stood" }),
        LooseEnding::Fell => as_json!({
            "kind": "left_places",
            "blocks": stones.left().into_iter().map(name).collect::<Vec<_>>(),
        }),
        LooseEnding::StillMoving { block } => as_json!({ "kind": "still_moving", "block": name(block) }),
        LooseEnding::Sank { block } => as_json!({ "kind": "sank", "block": name(block) }),
        LooseEnding::Unusable => as_json!({ "kind": "unusable" }),
    };
    let each = stones.stones.iter().zip(stones.stack.blocks());
    as_json!({
        "outcome": outcome,
        "duration_s": stones.end_s(),
        "energy_made_ratio": stones.energy_made_ratio(),
        "stones": each.map(|(stone, block)| as_json!({
            "block": block.name,
            "moved_m": stone.moved_m,
            "dropped_m": stone.dropped_m,
            "turned_rad": stone.turned_rad,
            "leaves_its_place_from_m": stone.allowed_m,
            "centroid_m": block.solid.centroid_m(),
        })).collect::<Vec<_>>(),
    })
}
