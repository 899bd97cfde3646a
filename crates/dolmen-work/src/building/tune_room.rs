//! The strokes of designed dampers under the motions of the file and the spectrum of its site, compared with their rooms.

use super::check::site_strokes_m;
use super::limits::{by_peaks, falls};
use super::simulate::{moved, steps_per_sample};
use super::tune_answer::{RoomCheck, RowRun, RowStroke};
use super::tuned::standing;
use crate::error::{Within as _, WorkError};
use crate::motion::{self, MotionRequest};
use crate::wrong::Place;
use dolmen::dynamics::{BuildingPeaks, BuildingRun, Histories, VibratingBuilding};
use dolmen::signal::GroundMotion;
use dolmen_project::{BuildingPart, BuiltDamper, Project, strokes_of};
use dolmen_records::Files;

/// Longest step between samples of a motion, s.
const STEP_S: f64 = 0.01;

/// Every row of dampers under every motion of the file; empty where no damper has a room.
pub(crate) fn room_check(
    (project, part): (&Project, &BuildingPart),
    files: &dyn Files,
    rows: &[Vec<BuiltDamper>],
) -> Result<RoomCheck, WorkError> {
    let of_rows = rows.iter().flat_map(|dampers| strokes_of(dampers));
    let has_room = of_rows.into_iter().any(|stroke| stroke.room_m.is_some());
    if !has_room {
        return Ok(RoomCheck::default());
    }
    let alone = standing(part)?;
    let mut motions: Vec<(String, GroundMotion)> = Vec::new();
    for part in &project.motions {
        let read = motion::prepared(&MotionRequest::named(&part.name), (project, files));
        let read = read.within(|| Place::StrokesUnder(part.name.clone()))?;
        motions.push((part.name.clone(), read.motion));
    }
    let (mut strokes, mut runs) = (Vec::new(), Vec::new());
    let floors = part.floor_names();
    let storeys = alone.building().storeys();
    let mut is_judged = !motions.is_empty();
    for (row, dampers) in rows.iter().enumerate() {
        let mut add = |motion: Option<&String>, peaks: Vec<f64>| {
            let each = strokes_of(dampers).into_iter().zip(peaks);
            strokes.extend(each.filter_map(|(damper, stroke_m)| {
                Some(RowStroke {
                    row,
                    damper: damper.name,
                    motion: motion.cloned(),
                    stroke_m,
                    room_m: damper.room_m?,
                })
            }));
        };
        for (name, motion) in &motions {
            let peaks = peaks(alone.clone(), dampers, motion)?;
            let limit = project.drift_limit.as_ref();
            let parts = by_peaks(&peaks, (&floors, storeys), dampers, limit);
            runs.push(RowRun {
                row,
                motion: name.clone(),
                falls: falls(&peaks, storeys, &parts),
                parts,
            });
            let each = peaks.strokes_m.iter().map(|peak| peak.value.abs());
            add(Some(name), each.collect());
        }
        if let Some(peaks) = site_strokes_m(project, alone, dampers) {
            is_judged = true;
            add(None, peaks);
        }
    }
    Ok(RoomCheck {
        has_room,
        is_judged,
        has_wind: project.loads.wind().is_some(),
        strokes,
        runs,
    })
}

/// Largest drifts and strokes.
fn peaks(
    alone: VibratingBuilding,
    dampers: &[BuiltDamper],
    motion: &GroundMotion,
) -> Result<BuildingPeaks, WorkError> {
    let run = BuildingRun {
        steps_per_sample: steps_per_sample(motion, STEP_S),
        histories: Histories::PeaksAlone,
        ..BuildingRun::default()
    };
    let (_, history) = moved(alone, dampers, motion, &run)?;
    Ok(history.peaks)
}
