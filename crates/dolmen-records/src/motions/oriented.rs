//! A motion in x, y and z from channels with stated directions.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | θ₁, θ₂ | `azimuth_deg` | directions of the horizontal channels, from north, clockwise |
//! | ψ | `x_azimuth_deg` | direction of x, likewise; y is a quarter turn to its left |
//! | n, e | `n`, `e` | acceleration to the north and to the east |

use super::read::{motion_of, refuse_unfit};
use super::{ComponentReading, MotionError, MotionOptions, Orientation, read_channels};
use crate::wrong::Turned;
use dolmen::signal::{Component, GroundMotion, Processing};

/// Smallest sine of the angle between two horizontal channels. Our choice: below 30° the errors of both are doubled.
const SINE_LEAST: f64 = 0.5;

/// A motion from files whose channels state their directions, rotated so that x points to an azimuth.
///
/// ```text
/// a₁ = n cos θ₁ + e sin θ₁        a₂ = n cos θ₂ + e sin θ₂        solved for n, e
/// x = n cos ψ + e sin ψ           y = n sin ψ − e cos ψ           ψ = 90°: x to the east, y to the north
/// ```
///
/// # Errors
/// [`MotionError::Orientation`] unless there are two horizontal channels at 30° or more, with or without a vertical one, or a
/// vertical one alone; as [`read_motion`](super::read_motion) otherwise.
///
/// # Example
/// ```
/// use dolmen::signal::Component;
/// use dolmen_records::motions::{MotionOptions, read_oriented};
/// let file = |stream: &str, a: f64| {
///     format!("STATION_CODE: A\nSAMPLING_INTERVAL_S: 0.01\nNDATA: 2\nSTREAM: HN{stream}\nUNITS: m/s^2\n0\n{a}\n")
/// };
/// let (north, east) = (file("N", 1.0), file("E", 3.0));
/// let motion = read_oriented("A", &[north.as_bytes(), east.as_bytes()], 90.0, &MotionOptions::default())?;
/// assert_eq!(motion.acceleration_m_s2(Component::X)[1], 3.0);
/// # Ok::<(), dolmen_records::motions::MotionError>(())
/// ```
pub fn read_oriented(
    name: &str,
    files: &[&[u8]],
    x_azimuth_deg: f64,
    options: &MotionOptions,
) -> Result<GroundMotion, MotionError> {
    if !x_azimuth_deg.is_finite() {
        return Err(MotionError::Orientation {
            why: Turned::Azimuth(x_azimuth_deg).into(),
        });
    }
    let mut horizontal: Vec<(f64, ComponentReading)> = Vec::new();
    let mut vertical: Vec<ComponentReading> = Vec::new();
    for bytes in files {
        for mut channel in read_channels(bytes, options)? {
            match channel.orientation {
                Some(Orientation::Horizontal { azimuth_deg }) => horizontal.push((azimuth_deg, channel)),
                Some(Orientation::Up) => vertical.push(channel),
                Some(Orientation::Down) => {
                    channel.acceleration_m_s2.iter_mut().for_each(|a| *a = -*a);
                    vertical.push(channel);
                }
                None => {
                    let why = Turned::NoDirection(channel.name);
                    return Err(MotionError::Orientation { why: why.into() });
                }
            }
        }
    }
    let found = (horizontal.len(), vertical.len());
    if !matches!(found, (2, 0) | (2, 1) | (0, 1)) {
        let why = Turned::ChannelsOfDirections {
            horizontal: found.0,
            vertical: found.1,
        };
        return Err(MotionError::Orientation { why: why.into() });
    }
    let mut placed: Vec<(Component, ComponentReading)> = Vec::new();
    if let [first, second] = &horizontal[..] {
        placed.extend(turned(first, second, x_azimuth_deg, options)?);
    }
    placed.extend(vertical.into_iter().map(|channel| (Component::Z, channel)));
    refuse_unfit(&placed, options)?;
    let mut motion = motion_of(name, placed, options)?;
    if found.0 > 0 {
        motion.note(Processing::Oriented { x_azimuth_deg });
    }
    Ok(motion)
}

/// Two horizontal channels as x and y.
fn turned(
    (first_deg, first): &(f64, ComponentReading),
    (second_deg, second): &(f64, ComponentReading),
    x_azimuth_deg: f64,
    options: &MotionOptions,
) -> Result<[(Component, ComponentReading); 2], MotionError> {
    let pair = vec![(Component::X, first.clone()), (Component::Y, second.clone())];
    let agreed = motion_of("", pair, options)?; // equal step, start and length
    let [(sin1, cos1), (sin2, cos2)] = [first_deg, second_deg].map(|deg| exact_sin_cos(*deg));
    let determinant = cos1 * sin2 - sin1 * cos2;
    if determinant.abs() < SINE_LEAST {
        let why = Turned::NearlyParallel {
            first_deg: *first_deg,
            second_deg: *second_deg,
        };
        return Err(MotionError::Orientation { why: why.into() });
    }
    let (sin, cos) = exact_sin_cos(x_azimuth_deg);
    let (mut x, mut y) = (first.clone(), second.clone());
    let [a1, a2] = [Component::X, Component::Y].map(|component| agreed.acceleration_m_s2(component));
    let both = a1.iter().zip(a2).map(|(a1, a2)| {
        let n = (a1 * sin2 - a2 * sin1) / determinant;
        let e = (a2 * cos1 - a1 * cos2) / determinant;
        (n * cos + e * sin, n * sin - e * cos)
    });
    (x.acceleration_m_s2, y.acceleration_m_s2) = both.unzip();
    Ok([(Component::X, x), (Component::Y, y)])
}

/// Sine and cosine, exact at quarter turns so that north and east stay exact.
fn exact_sin_cos(degrees: f64) -> (f64, f64) {
    match degrees.rem_euclid(360.0) {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        other => other.to_radians().sin_cos(),
    }
}
