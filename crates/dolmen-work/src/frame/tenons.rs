//! Tenons with slack in a check: resistance of the storeys before and after the tenons bear.

use crate::error::WorkError;
use dolmen::assess::{FrameCheck, check_frame};
use dolmen::dynamics::Tenon;
use dolmen::structure::Frame;
use dolmen_project::{FramePart, Pick};

/// Drift ratio for the secant stiffness: the allowable value of codes for most timber frames. Our choice.
pub const SECANT_DRIFT_RATIO: f64 = 0.02;

/// The tenons of a storey of a frame.
#[derive(Clone, Debug, PartialEq)]
pub struct StoreyTenons {
    /// The storey, 0 the lowest.
    pub storey: usize,
    /// Its height, m.
    pub height_m: f64,
    /// Its stiffness within the slack, N/m: that of the file.
    pub within_slack_n_m: f64,
    /// The tenons.
    pub tenon: Tenon,
}

impl StoreyTenons {
    /// Tangent stiffness of the storey once its tenons bear, N/m.
    pub fn bearing_n_m(&self) -> f64 {
        self.within_slack_n_m + self.tenon.stiffness_n_m
    }

    /// Secant stiffness of the storey at [`SECANT_DRIFT_RATIO`] of its height, N/m, without earlier crushing.
    pub fn secant_n_m(&self) -> f64 {
        self.within_slack_n_m
            + self
                .tenon
                .secant_stiffness_n_m(SECANT_DRIFT_RATIO * self.height_m)
    }

    /// Drift at which the faces begin to crush, m; `None` if they never crush.
    pub fn crushing_drift_m(&self) -> Option<f64> {
        let force_n = self.tenon.crushing_force_n?;
        Some(self.tenon.slack_m + force_n / self.tenon.stiffness_n_m)
    }
}

/// A frame in one direction before and after its tenons bear.
#[derive(Clone, Debug, PartialEq)]
pub struct TenonsCheck {
    /// The storeys with tenons.
    pub storeys: Vec<StoreyTenons>,
    /// The frame with all of them bearing.
    pub bearing: FrameCheck,
}

/// The tenons of a direction; `None` without tenons, or if the stiffness within the slack is unknown.
pub(crate) fn tenons(
    part: &FramePart,
    frame: &Frame,
    (direction, stiffness_n_m): (&str, Option<&[f64]>),
    pick: Pick<'_>,
) -> Result<Option<TenonsCheck>, WorkError> {
    let (Some(tenons), Some(within)) = (part.tenons(direction, pick)?, stiffness_n_m) else {
        return Ok(None);
    };
    let each = tenons.iter().zip(within).zip(frame.storeys()).enumerate();
    let storeys: Vec<StoreyTenons> = each
        .filter_map(|(storey, ((tenon, within), of))| {
            Some(StoreyTenons {
                storey,
                height_m: of.height_m,
                within_slack_n_m: *within,
                tenon: (*tenon)?,
            })
        })
        .collect();
    if storeys.is_empty() {
        return Ok(None);
    }
    let bearing = bearing_n_m(&tenons, within);
    Ok(Some(TenonsCheck {
        storeys,
        bearing: check_frame(frame, Some(&bearing))?,
    }))
}

/// Stiffness of each storey with all tenons bearing, N/m, lowest first.
pub(crate) fn bearing_n_m(tenons: &[Option<Tenon>], within: &[f64]) -> Vec<f64> {
    let each = tenons.iter().zip(within);
    each.map(|(tenon, within)| within + tenon.map_or(0.0, |of| of.stiffness_n_m))
        .collect()
}
