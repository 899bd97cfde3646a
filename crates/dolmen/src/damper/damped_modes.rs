//! Frequencies of a building with its dampers, as a survey measures them.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | λ_k, φ_k | | complex modes of building and dampers, upper half-plane | rad/s |
//! | α_k | | φᵀ (2 λ M + C) φ | |
//! | s_jk | `share` | 2 \|λ_k\| \|φ_jk² / α_k\|: share of mode k in the response of building mode j to a modal force; 1 without dampers | – |

use super::building_motion::in_modes;
use super::{AttachedDamper, DamperError};
use crate::dynamics::VibratingBuilding;
use dolmen_linalg::{Complex64, Matrix, eigen, solve};
use std::f64::consts::TAU;

/// A mode oscillates if the imaginary part of its λ is more than this fraction of \|λ\|: damping below 0.999 995 of critical, as for spectra.
const SWINGS: f64 = 3e-3;
/// A mode of building and dampers is visible in a survey if its peak is at least this fraction of the highest peak in the response of a
/// building mode. Our choice.
const SEEN: f64 = 0.5;

/// A mode of a building with its dampers.
#[derive(Clone, Debug, PartialEq)]
pub struct DampedMode {
    /// |λ|/2π, Hz.
    pub frequency_hz: f64,
    /// −Re λ/|λ|.
    pub damping_ratio: f64,
    /// Share of the mode in the response of each mode of the building alone, lowest first. Without dampers the share is 1 in one of them and 0
    /// in the others.
    pub share: Vec<f64>,
}

/// The oscillating modes of a building with its dampers, lowest first; overdamped modes are left out.
///
/// # Errors
/// [`DamperError`] if a damper is out of its range, or the eigenvalues are not found.
///
/// # Limits
/// Dampers are linear, with the given coefficients. Under the small motion of a survey a damper with friction sticks.
pub fn damped_modes(
    building: &VibratingBuilding,
    dampers: &[AttachedDamper],
) -> Result<Vec<DampedMode>, DamperError> {
    let damped = in_modes(building, dampers)?;
    let system = &damped.system;
    let (size, own) = (system.degrees_of_freedom(), building.modes().modes.len());
    let k = solve(system.mass(), system.stiffness())?;
    let c = solve(system.mass(), system.damping())?;
    // velocities are scaled by a high frequency; otherwise rows of size ω² next to rows of size 1 lose digits
    let high = (0..size).map(|i| k[(i, i)].abs().sqrt()).fold(0.0, f64::max);
    let states = Matrix::from_fn(2 * size, 2 * size, |i, j| match (i < size, j < size) {
        (true, true) => 0.0,
        (true, false) => f64::from(u8::from(j - size == i)) * high,
        (false, true) => -k[(i - size, j)] / high,
        (false, false) => -c[(i - size, j - size)],
    });
    let found = eigen(&states)?;
    let swings = |at: &usize| found.values[*at].im > SWINGS * found.values[*at].norm();
    let modes = (0..2 * size).filter(swings).map(|at| {
        let lambda = found.values[at];
        let shape: Vec<Complex64> = (0..size).map(|row| found.vectors[(row, at)]).collect();
        let mut alpha = Complex64::ZERO;
        for i in 0..size {
            for j in 0..size {
                let of = 2.0 * lambda * system.mass()[(i, j)] + system.damping()[(i, j)];
                alpha += shape[i] * of * shape[j];
            }
        }
        let norm = lambda.norm();
        DampedMode {
            frequency_hz: norm / TAU,
            damping_ratio: -lambda.re / norm,
            share: shape[..own]
                .iter()
                .map(|phi| 2.0 * norm * (phi * phi / alpha).norm())
                .collect(),
        }
    });
    let mut modes: Vec<DampedMode> = modes.collect();
    modes.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
    Ok(modes)
}

/// The lowest mode of building and dampers whose peak (share over damping ratio) is at least half the highest peak in the response of building
/// mode `own`. A tuned mass splits one mode into two, and a survey sees the lower one first.
pub fn lowest_seen(modes: &[DampedMode], own: usize) -> Option<&DampedMode> {
    let peak = |mode: &DampedMode| {
        mode.share.get(own).copied().unwrap_or(0.0) / mode.damping_ratio.max(f64::MIN_POSITIVE)
    };
    let highest = modes.iter().map(peak).fold(0.0, f64::max);
    modes
        .iter()
        .find(|mode| highest > 0.0 && peak(mode) >= SEEN * highest)
}
