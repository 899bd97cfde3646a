//! The strokes of designed dampers under the motions of the file, beside the room that they have.

use crate::{motion, simulate_building};
use anyhow::{Context as _, Result};
use dolmen::dynamics::{BuildingRun, Histories, VibratingBuilding};
use dolmen::signal::GroundMotion;
use dolmen_formats::project::{BuildingPart, BuiltDamper, Project, Quantity};
use dolmen_formats::tune::{RoomCheck, RowStroke};
use std::path::Path;

/// Longest step between samples of a motion, s.
const STEP_S: f64 = 0.01;

/// Every row of dampers under every motion of the file; empty where no damper says how much room it has.
pub(crate) fn room_check(
    (project, part): (&Project, &BuildingPart),
    file: &Path,
    rows: &[Vec<BuiltDamper>],
) -> Result<RoomCheck> {
    let has_room = rows.iter().flatten().any(|damper| damper.room_m.is_some());
    if !has_room {
        return Ok(RoomCheck::default());
    }
    let pick = &mut Quantity::nominal;
    let alone = part.vibrating(part.build(pick)?, pick)?;
    let mut motions: Vec<(String, GroundMotion)> = Vec::new();
    for part in &project.motions {
        let read = motion::motion(&motion::named(&part.name), project, file);
        let read = read.with_context(|| format!("motion.{}, under which strokes are judged", part.name))?;
        motions.push((part.name.clone(), read.motion));
    }
    let mut strokes = Vec::new();
    for (row, dampers) in rows.iter().enumerate() {
        for (name, motion) in &motions {
            let peaks = strokes_m(alone.clone(), dampers, motion)?;
            let each = dampers.iter().zip(peaks);
            strokes.extend(each.filter_map(|(damper, stroke_m)| {
                Some(RowStroke {
                    row,
                    damper: damper.name.clone(),
                    motion: name.clone(),
                    stroke_m,
                    room_m: damper.room_m?,
                })
            }));
        }
    }
    Ok(RoomCheck {
        has_room,
        has_motion: !motions.is_empty(),
        strokes,
    })
}

/// The largest stroke of each damper, m.
fn strokes_m(alone: VibratingBuilding, dampers: &[BuiltDamper], motion: &GroundMotion) -> Result<Vec<f64>> {
    let run = BuildingRun {
        steps_per_sample: simulate_building::steps_per_sample(motion, STEP_S),
        histories: Histories::PeaksAlone,
        ..BuildingRun::default()
    };
    let (_, history) = simulate_building::moved(alone, dampers, motion, &run)?;
    let strokes = history.peaks.strokes_m.iter();
    Ok(strokes.map(|peak| peak.value.abs()).collect())
}
