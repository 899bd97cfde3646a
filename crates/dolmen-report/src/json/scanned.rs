//! A scan cut into stones as JSON.

use crate::as_json;
use dolmen_work::scanned::ScanAnswer;
use serde_json::Value;

/// The cuts and the stones; the meshes are separate files.
pub fn scan_json(answer: &ScanAnswer) -> Value {
    let sliced = &answer.sliced;
    let stones = answer.stones.iter().zip(&sliced.stones);
    let stones = stones.map(|(stone, cut)| {
        as_json!({
            "name": stone.name,
            "file": stone.file,
            "course": cut.course + 1,
            "volume_m3": stone.volume_m3,
            "triangles": stone.triangles,
        })
    });
    let beds = sliced.beds.iter().map(|bed| {
        as_json!({
            "given_m": bed.named_m,
            "cut_m": bed.at_m,
            "is_at_step": bed.is_at_step,
            "area_below_m2": bed.area_below_m2,
            "area_above_m2": bed.area_above_m2,
        })
    });
    let steps = sliced.steps_without_bed.iter().map(|step| {
        as_json!({
            "at_m": step.at_m,
            "area_below_m2": step.area_below_m2,
            "area_above_m2": step.area_above_m2,
        })
    });
    as_json!({
        "scan": answer.file,
        "unit": answer.unit.symbol(),
        "unit_is_recognised": answer.is_unit_recognised,
        "moved_m": answer.moved_m,
        "noise_m": sliced.noise_m,
        "volume_m3": sliced.volume_m3,
        "stones_over_scan_volume": sliced.volume_ratio,
        "beds": beds.collect::<Vec<_>>(),
        "steps_without_bed": steps.collect::<Vec<_>>(),
        "stones": stones.collect::<Vec<_>>(),
    })
}
