//! Resistance of the free-standing columns of a frame.

use crate::error::WorkError;
use dolmen::stability::{ColumnPoint, ColumnStanding, FreeColumns};
use dolmen::structure::{Convention, Frame};
use dolmen_project::{FramePart, Pick};

/// Number of points of the curve of force against drift. Our choice: the plotted curve is smooth.
const CURVE_POINTS: usize = 80;
/// Amplitudes of free oscillations, as fractions of the rotation at which the columns fall. Our choice.
const SWINGS: [f64; 6] = [0.01, 0.05, 0.1, 0.25, 0.5, 0.75];

/// The free-standing columns of one storey.
#[derive(Clone, Debug, PartialEq)]
pub struct StoreyColumns {
    /// The storey, from 1 at the bottom.
    pub storey: usize,
    /// Number of columns.
    pub count: usize,
    /// N, the axial force of the storey, N.
    pub axial_n: f64,
    /// h, the height of the columns, m.
    pub height_m: f64,
    /// Bed stiffness given, N/m³; `None` for a rigid bed.
    pub bed_stiffness_n_m3: Option<f64>,
    /// Bed stiffness at which the columns alone are just stable, N/m³.
    pub least_bed_stiffness_n_m3: f64,
    /// Stiffness of the storey due to the beds at small drift, N/m; `None` for a rigid bed.
    pub bed_stiffness_n_m: Option<f64>,
    /// Resistance of the columns under their weight alone; `None` if they do not stand.
    pub standing: Option<ColumnStanding>,
    /// The springs in parallel with the columns.
    pub springs: Springs,
    /// Force of the columns against drift, from upright to the fall; empty if they do not stand.
    pub curve: Vec<ColumnPoint>,
    /// Free oscillations of the mass above the storey, in ascending amplitude; empty if the columns do not stand.
    pub swings: Vec<ColumnSwing>,
}

/// The springs of a storey in parallel with its columns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Springs {
    /// The stiffness of the storey is unknown.
    Unknown,
    /// The bed is rigid: a finite stiffness of the storey cannot be divided into springs and columns.
    RigidBed,
    /// The stiffness of the storey acts on the displacement from the ground, the columns on drift.
    Grounded,
    /// Stiffness of the storey minus that of the beds at small drift, N/m.
    Beside {
        /// Stiffness of joints, walls and braces, N/m.
        stiffness_n_m: f64,
    },
    /// The beds alone would be stiffer than the whole storey.
    LessThanBeds {
        /// Stiffness given, N/m.
        stiffness_n_m: f64,
    },
}

/// A free oscillation.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct ColumnSwing {
    /// Its amplitude, and the force of the columns at this amplitude.
    pub at: ColumnPoint,
    /// Frequency with the columns alone, Hz.
    pub columns_hz: f64,
    /// Frequency with the springs as well, Hz; `None` if the springs are unknown.
    pub with_springs_hz: Option<f64>,
}

/// The columns of each storey with columns, in a direction whose total storey stiffness is `stiffness_n_m`.
pub(super) fn columns(
    part: &FramePart,
    frame: &Frame,
    stiffness_n_m: Option<&[f64]>,
    pick: Pick<'_>,
) -> Result<Vec<StoreyColumns>, WorkError> {
    let mut all = Vec::new();
    for (i, (given, storey)) in part.storeys.iter().zip(frame.storeys()).enumerate() {
        let Some(given) = &given.columns else {
            continue;
        };
        let columns = given.build(storey, pick)?;
        let of_storey = stiffness_n_m.and_then(|all| all.get(i).copied());
        let springs = springs(of_storey, frame.convention(), columns.bed_stiffness_n_m());
        let mass_kg = frame.storeys()[i..].iter().map(|above| above.mass_kg).sum();
        let standing = columns.standing()?;
        all.push(StoreyColumns {
            storey: i + 1,
            count: given.count,
            axial_n: storey.axial_n,
            height_m: storey.height_m,
            bed_stiffness_n_m3: given.bed_stiffness.as_ref().map(&mut *pick),
            least_bed_stiffness_n_m3: columns.least_bed_stiffness_n_m3(),
            bed_stiffness_n_m: columns.bed_stiffness_n_m(),
            standing,
            springs,
            curve: columns.curve(CURVE_POINTS)?,
            swings: standing.map_or_else(Vec::new, |standing| {
                swings(&columns, standing.falls.rotation_rad, mass_kg, springs)
            }),
        });
    }
    Ok(all)
}

/// Columns that alone support a storey in a direction. Springs with the stiffness of their beds represent them up to `uplift`. All drifts are
/// over the height of the storey, and 0 if the columns do not stand.
#[derive(Clone, Debug, PartialEq)]
pub struct AloneStorey {
    /// The columns.
    pub columns: FreeColumns,
    /// Drift ratio at which feet lift off.
    pub uplift: f64,
    /// Drift ratio at the largest resistance.
    pub most: f64,
    /// Drift ratio at which there is no resistance left.
    pub falls: f64,
    /// Tilt, horizontal over vertical, with which the weight exceeds the largest resistance.
    pub overturns: f64,
}

impl AloneStorey {
    /// Drift ratio at which the columns balance their weight with this tilt; `None` if it overturns them.
    pub(super) fn balance(&self, tilt: f64, height_m: f64) -> Result<Option<f64>, WorkError> {
        let push_n = self.columns.axial_n() * tilt.abs();
        let drift_m = self.columns.drift_under_m(push_n)?;
        Ok(drift_m.map(|drift_m| drift_m / height_m))
    }
}

/// The storeys that only columns support in a direction; `None` for other storeys.
pub(super) fn alone_storeys(
    part: &FramePart,
    direction: &str,
    pick: Pick<'_>,
) -> Result<Vec<Option<AloneStorey>>, WorkError> {
    let frame = part.build(pick)?;
    let own = part.directions.iter().find(|own| own.name == direction);
    let stiffness = own.and_then(|own| own.stiffness.as_ref());
    let mut all = Vec::with_capacity(part.storeys.len());
    for (i, (given, storey)) in part.storeys.iter().zip(frame.storeys()).enumerate() {
        let is_alone = stiffness.is_some_and(|all| all[i].value == 0.0);
        let Some(columns) = given.columns.as_ref().filter(|_| is_alone) else {
            all.push(None);
            continue;
        };
        let columns = columns.build(storey, pick)?;
        let standing = columns.standing()?;
        let ratio = |of: fn(&ColumnStanding) -> ColumnPoint| {
            standing.map_or(0.0, |standing| of(&standing).drift_m / storey.height_m)
        };
        all.push(Some(AloneStorey {
            uplift: ratio(|of| of.uplift),
            most: ratio(|of| of.greatest),
            falls: ratio(|of| of.falls),
            overturns: standing.map_or(0.0, |standing| standing.greatest.force_n / columns.axial_n()),
            columns,
        }));
    }
    Ok(all)
}

fn springs(stiffness_n_m: Option<f64>, convention: Convention, beds_n_m: Option<f64>) -> Springs {
    match (stiffness_n_m, convention, beds_n_m) {
        (None, _, _) => Springs::Unknown,
        (Some(_), Convention::Grounded, _) => Springs::Grounded,
        (Some(_), Convention::Drift, None) => Springs::RigidBed,
        (Some(whole), Convention::Drift, Some(beds)) if whole < beds => {
            Springs::LessThanBeds { stiffness_n_m: whole }
        }
        (Some(whole), Convention::Drift, Some(beds)) => Springs::Beside {
            stiffness_n_m: whole - beds,
        },
    }
}

fn swings(columns: &FreeColumns, falls_rad: f64, mass_kg: f64, springs: Springs) -> Vec<ColumnSwing> {
    let each = SWINGS.iter().map(|share| {
        let rotation_rad = share * falls_rad;
        let on = |spring_n_m| columns.swing_frequency_hz(mass_kg, spring_n_m, rotation_rad);
        ColumnSwing {
            at: columns.at(rotation_rad),
            columns_hz: on(0.0),
            with_springs_hz: match springs {
                Springs::Beside { stiffness_n_m } => Some(on(stiffness_n_m)),
                Springs::Unknown | Springs::RigidBed | Springs::Grounded | Springs::LessThanBeds { .. } => {
                    None
                }
            },
        }
    });
    each.collect()
}
