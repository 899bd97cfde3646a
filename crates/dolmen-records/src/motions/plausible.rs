//! Whether a peak is possible for an earthquake, and in which unit it would be.

use super::MotionError;
use super::options::STANDARD_GRAVITY_M_S2;
use crate::unit::Unit;
use std::ops::RangeInclusive;

/// Peaks, in g, for which a unit is suggested: those of most records in simulations. Our choice.
const USUAL_G: RangeInclusive<f64> = 0.02..=2.0;
/// Common units of files of motions.
const USUAL_UNITS: [Unit; 5] = [
    Unit::Gravity,
    Unit::Gal,
    Unit::MetrePerSecondSquared,
    Unit::MillimetrePerSecondSquared,
    Unit::MilliGravity,
];

/// Refuses a peak, m/s², outside the range; `unit` is that of the samples.
pub(super) fn refuse_implausible(
    peak_m_s2: f64,
    unit: Unit,
    allowed_m_s2: &RangeInclusive<f64>,
) -> Result<(), MotionError> {
    if allowed_m_s2.contains(&peak_m_s2) {
        return Ok(());
    }
    let printed = peak_m_s2 / unit.si();
    let usual = |u: &&Unit| **u != unit && USUAL_G.contains(&(printed * u.si() / STANDARD_GRAVITY_M_S2));
    Err(MotionError::Peak {
        peak_g: peak_m_s2 / STANDARD_GRAVITY_M_S2,
        least_g: allowed_m_s2.start() / STANDARD_GRAVITY_M_S2,
        most_g: allowed_m_s2.end() / STANDARD_GRAVITY_M_S2,
        unit: unit.symbol(),
        suggested: USUAL_UNITS.iter().filter(usual).map(|u| u.symbol()).collect(),
    })
}
