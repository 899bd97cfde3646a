//! A damper compared with the rule and the optimum, as JSON.

use crate::as_json;
use dolmen::damper::{Compared, Goal, MapCell, RobustnessPoint};
use dolmen_work::building::{RoomCheck, TogetherAnswer, TogetherChoice, TuneAnswer, TuneLoad, TunedFloors};
use serde_json::Value;

/// The whole result.
pub fn tune_json(answer: &TuneAnswer) -> Value {
    let comparison = &answer.comparison;
    let tunings = comparison.tunings.iter().map(|row| {
        as_json!({
            "rule": row.rule.map(|rule| rule.name()),
            "exact_for": row.aim.map(|aim| aim.name()),
            "source": row.rule.map(|rule| rule.source()),
            "frequency_ratio": row.tuning.frequency_ratio,
            "damping_ratio": row.tuning.damping_ratio,
            "damping_ratio_on_structure": row.tuning.damping_ratio_on_structure(),
            "point_ratio": answer.over_without(&row.point_values),
            "cost": row.cost,
        })
    });
    let line =
        |cells: &[MapCell]| -> Vec<Value> { cells.iter().map(|cell| cell_json(answer, cell)).collect() };
    let map: Vec<Value> = comparison
        .map
        .cells
        .iter()
        .map(|cell| cell.as_ref().map_or(Value::Null, |cell| cell_json(answer, cell)))
        .collect();
    let curve = |points: &[RobustnessPoint]| -> Vec<Value> {
        points
            .iter()
            .map(|point| {
                as_json!({
                    "factor": point.factor, "cost": point.cost,
                    "point_rms": point.point_rms,
                    "stroke_rms_m": point.stroke_rms_m[0],
                })
            })
            .collect()
    };
    let curves = |of: &[Vec<RobustnessPoint>; 2]| as_json!({ "given": curve(&of[0]), "best": curve(&of[1]) });
    as_json!({
        "file": answer.file,
        "name": { "en": answer.name.en, "ko": answer.name.ko },
        "variant": answer.variant,
        "damper": answer.damper,
        "other_dampers_left_out": answer.others,
        "floor": answer.floor,
        "mode": {
            "number": answer.mode, "frequency_hz": answer.mode_frequency_hz, "damping_ratio": answer.mode_damping_ratio,
            "centre_m": answer.mode_centre_m, "modal_mass_kg": comparison.modal_mass_kg,
        },
        "mass_ratio": comparison.mass_ratio,
        "load": {
            "kind": answer.load.name(), "direction_degrees": answer.load_direction_degrees,
            "corner_hz": match answer.load { TuneLoad::Wind { corner_hz } => Some(corner_hz), _ => None },
            "ground_hz": match answer.load { TuneLoad::Ground { ground_hz } => Some(ground_hz), _ => None },
        },
        "goal": answer.goal,
        "stroke_most": answer.stroke_most, "off_by": answer.off_by,
        "prepared_frequencies_apart": comparison.apart,
        "points": answer.points.iter().zip(&comparison.without).map(|(point, without)| as_json!({
            "name": point.name, "floor": point.floor, "place_m": point.place_m,
            "direction_degrees": answer.direction_degrees, "without_damper": without,
        })).collect::<Vec<_>>(),
        "value_is": match answer.goal { Goal::LargestPeak => "largest_amplitude", _ => "rms" },
        "cost_without_damper": comparison.cost_without,
        "choices": comparison.rows.iter().map(|row| row_json(answer, row)).collect::<Vec<_>>(),
        "tunings": tunings.collect::<Vec<_>>(),
        "strokes_under_motions": room_json(&answer.room), "room_is_unjudged": answer.room.is_unjudged(),
        "line": { "tuned_as_given": line(&comparison.line_given), "tuned_best": line(&comparison.line_best) },
        "map": { "x_m": comparison.map.x_m, "y_m": comparison.map.y_m, "cells": map },
        "floors": answer.floors.as_ref().map(|floors| floors_json(answer, floors)),
        "other_floors": answer.other_floors,
        "frequency_off": curves(&comparison.off_frequency),
        "damping_off": curves(&comparison.off_damping),
    })
}

fn row_json(answer: &TuneAnswer, row: &Compared) -> Value {
    as_json!({
        "choice": row.choice.name(),
        "damper": row.damper,
        "point_rms": row.judged.point_rms,
        "point_ratio": answer.ratios(row),
        "worse_than_none": !answer.worse(row).is_empty(),
        "stroke_rms_m": row.judged.stroke_rms_m[0],
        "cost": row.cost,
        "cost_ratio": row.cost / answer.comparison.cost_without,
        "end": row.end,
    })
}

/// The damper placed and tuned best on each floor.
fn floors_json(answer: &TuneAnswer, floors: &TunedFloors) -> Value {
    let each = floors.comparison.floors.iter().map(|of| {
        as_json!({
            "floor": of.floor, "damper": of.damper, "modal_mass_kg": of.modal_mass_kg,
            "cost": of.cost, "cost_ratio": of.cost / answer.comparison.cost_without, "end": of.end,
            "is_assembled": of.effect.is_some(),
            "point_ratio": of.effect.as_ref().map(|effect| answer.ratios(effect)),
            "stroke_rms_m": of.effect.as_ref().map(|effect| effect.judged.stroke_rms_m[0]),
        })
    });
    as_json!({
        "best": floors.comparison.best().map(|of| of.floor),
        "designs": each.collect::<Vec<_>>(),
        "prepared_frequencies_apart": floors.comparison.apart,
        "without_outline": floors.without_outline,
        "strokes_under_motions_on_best": room_json(&floors.room),
    })
}

fn cell_json(answer: &TuneAnswer, cell: &MapCell) -> Value {
    as_json!({
        "place_m": cell.damper.place_m, "frequency_hz": cell.damper.frequency_hz, "damping_ratio": cell.damper.damping_ratio,
        "point_rms_ratio": answer.over_without(&cell.point_rms), "cost": cell.cost, "at_limit": cell.at_limit,
    })
}

/// All dampers at once.
pub fn together_json(answer: &TogetherAnswer) -> Value {
    let rows = answer.rows.iter().map(|row| {
        as_json!({
            "choice": row.choice.name(),
            "damper": match &row.choice {
                TogetherChoice::Only(name) | TogetherChoice::AllBut(name) => Some(name),
                _ => None,
            },
            "dampers": row.dampers.iter().map(super::building::damper).collect::<Vec<_>>(),
            "point_rms": row.point_rms, "point_ratio": answer.ratios(row), "stroke_rms_m": row.stroke_rms_m,
            "cost": row.cost, "cost_ratio": answer.cost_ratio(row),
            "end": row.end,
        })
    });
    as_json!({
        "file": answer.file,
        "name": { "en": answer.name.en, "ko": answer.name.ko },
        "variant": answer.variant,
        "load": { "kind": answer.load.name(), "directions_degrees": answer.load_directions_degrees },
        "goal": answer.goal,
        "stroke_most": answer.stroke_most,
        "points": answer.points.iter().map(|(point, degrees)| as_json!({
            "name": point.name, "floor": point.floor, "place_m": point.place_m, "direction_degrees": degrees,
        })).collect::<Vec<_>>(),
        "rows": rows.collect::<Vec<_>>(),
        "strokes_under_motions": room_json(&answer.room), "room_is_unjudged": answer.room.is_unjudged(),
    })
}

fn room_json(room: &RoomCheck) -> Vec<Value> {
    let each = room.strokes.iter().map(|of| {
        as_json!({
            "row": of.row, "damper": of.damper, "motion": of.motion, "stroke_m": of.stroke_m, "room_m": of.room_m,
            "beyond_room": of.stroke_m > of.room_m,
        })
    });
    each.collect()
}
