//! Quantities of a building in the wind from one side. Each has several rows, of which the worst governs; means, mean squares and
//! histories use the same rows.

use crate::error::WorkError;
use dolmen::damper::{GustMotion, GustPeak, GustQuantity, GustRow};
use dolmen::structure::Building;
use dolmen::structure::building::{Outline, PlanDirection};

/// The rows of a building; in those of the first case the wind acts at the middle of the breadth.
pub(crate) struct WindRows {
    /// Each floor, lowest first.
    pub(crate) floors: Vec<FloorRows>,
    /// Shear along the wind in the walls of the lowest storey.
    pub(crate) base_shear: GustRow,
    /// Their torque, all cases.
    pub(crate) base_torque: Vec<GustRow>,
}

pub(crate) struct FloorRows {
    /// Displacement along the wind.
    pub(crate) displacement: GustRow,
    /// Drift along the wind of the storey below, both edges, all cases.
    pub(crate) drift: Vec<GustRow>,
    /// Acceleration along the wind.
    pub(crate) acceleration: GustRow,
    /// Acceleration across the wind.
    pub(crate) across: GustRow,
    /// Acceleration of the rotation.
    pub(crate) rotation: GustRow,
    /// Acceleration of each corner in its worst direction, all cases.
    pub(crate) corner: Vec<GustRow>,
}

impl WindRows {
    /// The rows for the wind along x, 0, or y, 1; `all` is the motion in each case.
    pub(crate) fn of(building: &Building, axis: usize, all: &[GustMotion]) -> Result<Self, WorkError> {
        let [shear_x, shear_y, torque] = building.base_rows();
        let floors = (0..building.floors().len()).map(|i| FloorRows::of(building, (i, axis), all));
        Ok(WindRows {
            floors: floors.collect::<Result<_, WorkError>>()?,
            base_shear: displaced(0, if axis == 0 { shear_x } else { shear_y }),
            base_torque: (0..all.len())
                .map(|case| displaced(case, torque.clone()))
                .collect(),
        })
    }
}

impl FloorRows {
    fn of(building: &Building, (i, axis): (usize, usize), all: &[GustMotion]) -> Result<Self, WorkError> {
        let unit = |k: usize| {
            let mut row = vec![0.0; building.coordinates()];
            row[3 * i + k] = 1.0;
            row
        };
        let edges = building.edge_drift_rows(i + 1)?.into_iter().flatten();
        let edges: Vec<Vec<f64>> = edges.skip(2 * axis).take(2).collect();
        let drift = edges
            .iter()
            .flat_map(|row| (0..all.len()).map(|case| displaced(case, row.clone())));
        let mut corner = Vec::new();
        let corners = building.floors()[i].outline.iter().flat_map(Outline::corners_m);
        for [x_m, y_m] in corners {
            let row = |direction| building.point_row(i + 1, *x_m, *y_m, direction);
            let (x, y) = (row(PlanDirection::X)?, row(PlanDirection::Y)?);
            let cases = all.iter().enumerate();
            corner.extend(cases.map(|(case, of)| accelerated(case, of.most_accelerated([&x, &y]))));
        }
        Ok(FloorRows {
            displacement: displaced(0, unit(axis)),
            drift: drift.collect(),
            acceleration: accelerated(0, unit(axis)),
            across: accelerated(0, unit(1 - axis)),
            rotation: accelerated(0, unit(2)),
            corner,
        })
    }
}

fn displaced(case: usize, row: Vec<f64>) -> GustRow {
    GustRow {
        case,
        row,
        quantity: GustQuantity::Displacement,
    }
}

fn accelerated(case: usize, row: Vec<f64>) -> GustRow {
    GustRow {
        case,
        row,
        quantity: GustQuantity::Acceleration,
    }
}

/// The row with the largest peak by the mean square.
pub(crate) fn worst(all: &[GustMotion], rows: &[GustRow]) -> GustPeak {
    let peaks = rows.iter().map(|row| all[row.case].of(row));
    largest(peaks)
}

/// The one with the largest peak.
pub(crate) fn largest(all: impl Iterator<Item = GustPeak>) -> GustPeak {
    all.max_by(|a, b| a.peak().total_cmp(&b.peak()))
        .unwrap_or_default()
}
