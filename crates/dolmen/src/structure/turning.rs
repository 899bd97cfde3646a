//! Shapes that turn about the vertical axis through the origin: modes of torsion seen by a sensor off the centre.

use super::real_shape::{LEVEL_M, real_shape};
use crate::modal::Modes;
use dolmen_linalg::Complex64;

/// Largest share of a shape that is not motion at right angles to the line from the origin. Our choice: 6°.
const RADIAL_MOST: f64 = 0.01;
/// Smallest share of each coordinate in the squared distance from the origin: with less, a motion along an axis is almost a turn. Our choice: 13°.
const OBLIQUE_LEAST: f64 = 0.05;
/// Smallest distance of a sensor from the origin, m. Our choice.
const ARM_LEAST_M: f64 = 0.5;

/// A place that is measured along x and along y: its two channels, each with its sign.
struct Place {
    at_m: [f64; 2],
    channels: [(usize, f64); 2],
}

/// Frequencies, Hz, of the modes whose motion at every place with a sensor along x and one along y is a turn about the origin.
///
/// ```text
/// Σ (X u_x + Y u_y)² / (X² + Y²)  ≤  .01 Σ (u_x² + u_y²)
/// ```
/// # Limits
/// One place on the floor cannot tell a turn from a motion in just this oblique direction, so that a caller needs another reason to leave the mode
/// out. Places on an axis, or within 0.5 m of the origin, show no turn.
pub(super) fn turning_hz(modes: &Modes) -> Vec<f64> {
    let along = |axis: usize, at: usize| -> Option<f64> {
        let direction = modes.channels[at].direction?;
        (direction[axis].abs() > 0.99).then(|| direction[axis].signum())
    };
    let mut places: Vec<Place> = Vec::new();
    for (x, channel) in modes.channels.iter().enumerate() {
        let (Some(place), Some(sign_x)) = (channel.position_m, along(0, x)) else {
            continue;
        };
        let is_here = |at: &usize| {
            let other = modes.channels[*at].position_m;
            other.is_some_and(|other| other.iter().zip(place).all(|(a, b)| (a - b).abs() < LEVEL_M))
        };
        let mut others = (0..modes.channels.len()).filter(is_here);
        if let Some((y, sign_y)) = others.find_map(|y| Some((y, along(1, y)?))) {
            places.push(Place {
                at_m: [place[0], place[1]],
                channels: [(x, sign_x), (y, sign_y)],
            });
        }
    }
    let shows = |place: &Place| {
        let [x, y] = place.at_m;
        let arm2 = x * x + y * y;
        arm2 >= ARM_LEAST_M * ARM_LEAST_M && (x * x).min(y * y) >= OBLIQUE_LEAST * arm2
    };
    if places.is_empty() || !places.iter().all(shows) {
        return Vec::new();
    }
    let turns = |shape: &[Complex64]| {
        let real = real_shape(shape);
        let (mut radial, mut all) = (0.0, 0.0);
        for place in &places {
            let ([x, y], [(of_x, sign_x), (of_y, sign_y)]) = (place.at_m, place.channels);
            let (u, v) = (sign_x * real[of_x], sign_y * real[of_y]);
            radial += (x * u + y * v).powi(2) / (x * x + y * y);
            all += u * u + v * v;
        }
        all > 0.0 && radial <= RADIAL_MOST * all
    };
    let own = modes
        .modes
        .iter()
        .filter(|mode| mode.shape.len() == modes.channels.len() && turns(&mode.shape));
    own.map(|mode| mode.frequency_hz).collect()
}
