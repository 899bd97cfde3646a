//! A frame of one storey whose beds and joints share its stiffness, under the spectrum of a site: its drift with all of it in the beds.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | u, V(u) | `drift_m`, `force_n` | drift, and the force of the columns at it, P-delta included | m, N |
//! | N, h | `axial_n`, `height_m` | weight on the columns, their height | N, m |
//! | S_d | – | displacement of the spectrum at a stiffness | m |

use crate::error::WorkError;
use dolmen::assess::demand::{SiteDemand, frame_drifts_by_spectrum};
use dolmen::stability::FreeColumns;
use dolmen::structure::Frame;
use dolmen_project::{DirectionPart, FramePart, Quantity};

/// Relative change of the drift at which the iteration ends.
const CHANGE_MOST: f64 = 1e-6;
/// Largest number of iterations; each brings the drift nearer by a constant factor.
const ITERATIONS_MOST: usize = 500;

/// The drift ratio at which feet lift off, and that of the spectrum, with all of the stiffness in the beds of the columns; `None` where the
/// file gives no beds beside joints, where joints rub or have slack, and where no foot lifts off.
///
/// ```text
/// u = S_d(V(u)/u + N/h), from the drift of the linear storey upwards
/// ```
/// The secant stiffness with the damping of the linear storey: on the safe side, since rocking adds damping.
pub(super) fn in_beds(
    (part, frame): (&FramePart, &Frame),
    direction: &DirectionPart,
    (site, damping_ratio): (&SiteDemand, f64),
    linear_m: f64,
) -> Result<Option<(f64, f64)>, WorkError> {
    let pick = &mut Quantity::nominal;
    let ([storey], [given]) = (frame.storeys(), part.storeys.as_slice()) else {
        return Ok(None);
    };
    let stiffness = part.stiffness_n_m(&direction.name, pick);
    let Some(([stiffness_n_m], columns)) = stiffness.as_deref().zip(given.columns.as_ref()) else {
        return Ok(None);
    };
    let is_alone = direction
        .stiffness
        .as_ref()
        .is_some_and(|all| all[0].value == 0.0);
    let has_joints_of_their_own = direction.friction.is_some() || direction.tenons.is_some();
    if columns.bed_stiffness.is_none() || is_alone || has_joints_of_their_own {
        return Ok(None);
    }
    let columns = columns.build(storey, pick)?.on_beds_of(*stiffness_n_m);
    let Some(standing) = columns.standing()?.filter(|of| of.uplift.drift_m < linear_m) else {
        return Ok(None);
    };
    let drift_m = by_secant(
        (&columns, frame),
        (site, damping_ratio),
        [linear_m, standing.falls.drift_m],
    )?;
    let height_m = storey.height_m;
    Ok(Some((standing.uplift.drift_m / height_m, drift_m / height_m)))
}

/// The drift at which the spectrum at its secant stiffness asks for no more; infinite where it is not below that of the fall.
fn by_secant(
    (columns, frame): (&FreeColumns, &Frame),
    (site, damping_ratio): (&SiteDemand, f64),
    [linear_m, falls_m]: [f64; 2],
) -> Result<f64, WorkError> {
    let weight_n_m = columns.axial_n() / columns.height_m();
    let mut drift_m = linear_m;
    for _ in 0..ITERATIONS_MOST {
        if drift_m >= falls_m {
            return Ok(f64::INFINITY);
        }
        let force_n = columns.at(columns.rotation_at_rad(drift_m)?).force_n;
        let secant_n_m = force_n / drift_m + weight_n_m;
        // a period beyond the spectrum: its drift is not known, and larger
        let found = frame_drifts_by_spectrum(frame, &[secant_n_m], site, damping_ratio);
        let Some(asked_m) = found.ok().flatten().and_then(|all| all.first().copied()) else {
            return Ok(f64::INFINITY);
        };
        if (asked_m - drift_m).abs() <= CHANGE_MOST * drift_m {
            return Ok(asked_m);
        }
        drift_m = asked_m;
    }
    Ok(f64::INFINITY)
}
