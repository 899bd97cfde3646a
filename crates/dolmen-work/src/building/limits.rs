//! Storeys and dampers of a building compared with their limits.

use super::{BuildingAnswer, BuildingSimulation};
use crate::part_limit::{Limited, Part, PartLimit};
use dolmen::assess::demand::{DRIFT_RATIO_MOST, DriftLimit};
use dolmen::dynamics::BuildingPeaks;
use dolmen::structure::building::Storey;
use dolmen_project::{BuiltDamper, strokes_of};

/// Under the spectrum of the site, with the dampers if there are any and with accidental torsion; empty if that is not computed.
pub(crate) fn by_spectrum(answer: &BuildingAnswer, limit: Option<&DriftLimit>) -> Vec<PartLimit> {
    let Some(standing) = &answer.stands else {
        return Vec::new();
    };
    let Some(drifts_m) = standing.judged_drift_m() else {
        return Vec::new();
    };
    let mut all = Vec::new();
    for (i, storey) in standing.building.storeys().iter().enumerate() {
        for (axis, direction) in ["x", "y"].into_iter().enumerate() {
            let part = Part::BelowFloor(answer.floors[i].clone());
            all.push(PartLimit::of_drift(
                part,
                direction,
                drifts_m[i][axis] / storey.height_m,
                limit,
            ));
        }
    }
    all.extend(rooms(&standing.dampers, standing.judged_strokes_m().into_iter()));
    all
}

/// Strokes of dampers compared with their rooms, m, in the order of [`strokes_of`].
fn rooms(dampers: &[BuiltDamper], strokes_m: impl Iterator<Item = f64>) -> Vec<PartLimit> {
    let pairs = strokes_of(dampers).into_iter().zip(strokes_m);
    pairs
        .map(|(stroke, stroke_m)| PartLimit {
            taken: 0.0,
            lean: [0.0; 2],
            part: Part::Damper(stroke.name),
            direction: None,
            limited: Limited::Room,
            demand: stroke_m.abs(),
            capacity: stroke.room_m,
        })
        .collect()
}

/// Drifts of storeys at their edges along x and along y compared with the allowable drift, and strokes of dampers compared with their rooms,
/// from the peaks of a run.
pub(super) fn by_peaks(
    peaks: &BuildingPeaks,
    (floors, storeys): (&[String], &[Storey]),
    dampers: &[BuiltDamper],
    limit: Option<&DriftLimit>,
) -> Vec<PartLimit> {
    let drifts = floors.iter().zip(storeys).zip(&peaks.storeys);
    let mut all: Vec<PartLimit> = drifts
        .flat_map(|((floor, storey), peak)| {
            let along_x = peak.edge_drift_x_m.unwrap_or(peak.drift_x_m);
            let along_y = peak.edge_drift_y_m.unwrap_or(peak.drift_y_m);
            [("x", along_x), ("y", along_y)].map(|(direction, drift_m)| {
                let part = Part::BelowFloor(floor.clone());
                PartLimit::of_drift(part, direction, drift_m.value.abs() / storey.height_m, limit)
            })
        })
        .collect();
    let strokes = peaks.strokes_m.iter().map(|stroke| stroke.value);
    all.extend(rooms(dampers, strokes));
    all
}

impl BuildingSimulation {
    /// The drift of each storey at its edges along x and along y compared with the allowable drift, under the spectrum of the site, and the
    /// stroke of each damper compared with its room.
    pub fn parts(&self) -> Vec<PartLimit> {
        let storeys = self.building.building().storeys();
        by_peaks(
            &self.history.peaks,
            (&self.floors, storeys),
            &self.dampers,
            self.drift_limit.as_ref(),
        )
    }

    /// Whether the drift of a storey in any direction is beyond the validity of small drifts.
    pub fn falls(&self) -> bool {
        falls(
            &self.history.peaks,
            self.building.building().storeys(),
            &self.parts(),
        )
    }
}

/// Whether the drift of a storey of a run in any direction is beyond the validity of small drifts.
pub(super) fn falls(peaks: &BuildingPeaks, storeys: &[Storey], parts: &[PartLimit]) -> bool {
    let mut resultants = peaks.storeys.iter().zip(storeys);
    resultants.any(|(peak, storey)| peak.resultant.size_m / storey.height_m > DRIFT_RATIO_MOST)
        || parts.iter().any(PartLimit::falls)
}
