//! Strokes of dampers from the modal displacements of the structure.

use super::{AttachedDamper, DamperKind};
use dolmen_linalg::Complex64;
use std::f64::consts::TAU;

/// Strokes of the dampers, then liquid rises of columns on springs, for modal displacements `eta`; `places` are the damper rows in modal
/// coordinates.
pub(super) fn strokes_under(
    dampers: &[AttachedDamper],
    places: &[Vec<f64>],
    eta: &[Complex64],
    omega: f64,
) -> Vec<Complex64> {
    let (mut strokes, mut liquids) = (Vec::new(), Vec::new());
    for (damper, row) in dampers.iter().zip(places) {
        let place: Complex64 = row.iter().zip(eta).map(|(a, x)| x * *a).sum();
        let stroke = match damper.kind {
            DamperKind::Viscous { .. } => place,
            _ => omega * omega * place * damper.kind.stroke_per_acceleration(omega),
        };
        strokes.push(stroke);
        if let DamperKind::LiquidColumnMass {
            length_ratio,
            liquid_frequency_hz,
            liquid_damping_ratio,
            ..
        } = damper.kind
        {
            let own = TAU * liquid_frequency_hz;
            let link = Complex64::new(
                own * own - omega * omega,
                2.0 * liquid_damping_ratio * own * omega,
            );
            liquids.push(length_ratio * omega * omega * (place + stroke) / link);
        }
    }
    strokes.extend(liquids);
    strokes
}
