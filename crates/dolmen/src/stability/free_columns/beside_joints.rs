//! Free-standing columns of a storey that joints, walls and braces hold as well.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | k, k_b, k_j | `stiffness_n_m`, –, `joints_n_m` | stiffness of the storey at small drift; of the beds of its columns; of joints and walls | N/m |
//! | u, V, T | `drift_m`, –, `force_n` | drift; force of the columns; force of columns and joints | m, N, N |

use super::column::{ColumnPoint, FreeColumns};
use crate::numeric::{Bracketing, bracketed_root, maximum_between};
use crate::stability::StabilityError;

/// Columns with joints in parallel: both ends of a rigid column rotate by the drift over its height, so that the stiffnesses add.
///
/// ```text
/// T(u) = V(u) + k_j u,   k_j = k − k_b
/// ```
///
/// # Limits
/// The joints are linear. Where columns bend by themselves, bed and column are in series; here the columns are rigid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColumnsBesideJoints {
    /// The columns.
    pub columns: FreeColumns,
    /// k_j, N/m; 0 for columns alone.
    pub joints_n_m: f64,
}

impl ColumnsBesideJoints {
    /// The columns of a storey of stiffness k: the beds have the stiffness given, the joints the rest. On rigid stones, and where the beds given
    /// would be stiffer than the storey, all of it is in the beds.
    pub fn sharing(columns: &FreeColumns, stiffness_n_m: f64) -> Self {
        let (columns, joints_n_m) = match columns.bed_stiffness_n_m() {
            _ if stiffness_n_m == 0.0 => (*columns, 0.0),
            Some(beds_n_m) if beds_n_m <= stiffness_n_m => (*columns, stiffness_n_m - beds_n_m),
            Some(_) | None => (columns.on_beds_of(stiffness_n_m), 0.0),
        };
        ColumnsBesideJoints { columns, joints_n_m }
    }

    /// Drift, and force of columns and joints, at a rotation θ ≥ 0.
    pub fn at(&self, rotation_rad: f64) -> ColumnPoint {
        let of = self.columns.at(rotation_rad);
        ColumnPoint {
            force_n: of.force_n + self.joints_n_m * of.drift_m,
            ..of
        }
    }

    /// Where the storey counts as fallen: at `drift_most_m`, or before where the columns alone have no resistance left, or, if they do not stand
    /// alone, where columns and joints together have none. `None` if it does not stand upright.
    ///
    /// # Errors
    /// As [`FreeColumns::standing`].
    pub fn falls(&self, drift_most_m: f64) -> Result<Option<ColumnPoint>, StabilityError> {
        let alone = self.columns.standing()?.map(|standing| standing.falls);
        let beds_n_m = self.columns.bed_stiffness_n_m().unwrap_or(f64::INFINITY);
        let stands = beds_n_m + self.joints_n_m > self.columns.axial_n() / self.columns.height_m();
        let end = match alone {
            Some(falls) if falls.drift_m <= drift_most_m => return Ok(Some(falls)),
            None if self.joints_n_m == 0.0 || !stands => return Ok(None),
            Some(_) => drift_most_m,
            None => drift_most_m.min(self.columns.height_m() * self.columns.rigid_fall_rad().sin()),
        };
        let end_rad = self.columns.rotation_at_rad(end)?;
        let force_n = |rotation: f64| self.at(rotation).force_n;
        if force_n(end_rad) > 0.0 {
            return Ok(Some(self.at(end_rad)));
        }
        let greatest_rad = maximum_between(&force_n, 0.0, end_rad);
        if force_n(greatest_rad) <= 0.0 {
            return Ok(None); // a stiffness that rounding does not tell from N/h
        }
        let falls_rad = bracketed_root(force_n, greatest_rad, end_rad, &Bracketing::default())?;
        Ok(Some(self.at(falls_rad)))
    }

    /// The rotation at which columns and joints balance a horizontal force, up to their largest resistance, rad; `None` if they do not.
    ///
    /// # Errors
    /// As [`FreeColumns::standing`].
    pub(crate) fn rotation_under_rad(
        &self,
        force_n: f64,
        drift_most_m: f64,
    ) -> Result<Option<f64>, StabilityError> {
        if self.joints_n_m == 0.0 {
            return self.columns.rotation_under_rad(force_n);
        }
        let Some(falls) = self.falls(drift_most_m)? else {
            return Ok(None);
        };
        let end_rad = falls.rotation_rad;
        let off = |rotation: f64| self.at(rotation).force_n - force_n;
        let top_rad = maximum_between(&off, 0.0, end_rad);
        let greatest_rad = match off(end_rad) > off(top_rad) {
            true => end_rad,
            false => top_rad,
        };
        match (off(greatest_rad) > 0.0, force_n > 0.0) {
            (false, _) => Ok(None),
            (true, false) => Ok(Some(0.0)),
            (true, true) => Ok(Some(bracketed_root(
                off,
                0.0,
                greatest_rad,
                &Bracketing::default(),
            )?)),
        }
    }
}
