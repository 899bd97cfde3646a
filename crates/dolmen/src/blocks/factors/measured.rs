//! Measured modes of a stack.

use super::error::JointFactorsError;
use super::stack_motion::StackMotion;
use crate::structure::MeasuredMode;

/// A measured mode of a stack.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredStackMode {
    /// Its motion.
    pub motion: StackMotion,
    /// Frequency, its standard deviation, and points of the shape along the direction; points of torsion
    /// modes are not used.
    pub mode: MeasuredMode,
}

/// Standard deviations assumed for data without one.
pub(super) struct Assumed {
    /// Standard deviation of a frequency, relative.
    pub(super) frequency_sd: f64,
    /// Standard deviation of a point of a shape, relative to its largest displacement.
    pub(super) shape_sd: f64,
}

pub(super) fn check_measured(measured: &[MeasuredStackMode], height_m: f64) -> Result<(), JointFactorsError> {
    if measured.is_empty() {
        return Err(JointFactorsError::NoModes);
    }
    for one in measured {
        let mode = &one.mode;
        let refuse = |quantity, given, allowed| {
            Err(JointFactorsError::Mode {
                quantity,
                given,
                frequency_hz: mode.frequency_hz,
                allowed,
            })
        };
        if !(mode.frequency_hz > 0.0 && mode.frequency_hz.is_finite()) {
            return refuse("frequency_hz", mode.frequency_hz, "a positive number");
        }
        if !(mode.frequency_sd_hz >= 0.0 && mode.frequency_sd_hz < mode.frequency_hz) {
            let allowed = "0 or more, and less than the frequency";
            return refuse("frequency_sd_hz", mode.frequency_sd_hz, allowed);
        }
        if one.motion == StackMotion::Torsion {
            continue;
        }
        for point in &mode.shape {
            if !(point.height_m >= 0.0 && point.height_m <= height_m * (1.0 + 1e-9)) {
                let allowed = "between the ground and the top of the stack";
                return refuse("height_m", point.height_m, allowed);
            }
            if !point.displacement.is_finite() {
                return refuse("displacement", point.displacement, "a finite number");
            }
            if !(point.displacement_sd >= 0.0 && point.displacement_sd.is_finite()) {
                return refuse("displacement_sd", point.displacement_sd, "0 or a positive number");
            }
        }
    }
    Ok(())
}
