//! Checks the sensors by the mode shapes: different units, channels without motion, delayed clocks.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | λ | `root` | continuous eigenvalue, ω (−ζ + i√(1 − ζ²)) | rad/s |
//! | φ_c | `z` | component of a channel; the largest of its mode is 1 | – |

use crate::modal::indicators::{normalized, phase_collinearity, phase_deviation};
use crate::modal::{Mode, Modes, Note, Pole, ShapeQuantity};
use crate::signal::{Channel, Quantity};
use dolmen_linalg::Complex64;
use std::f64::consts::TAU;

/// A channel does not move if its component in every mode is below this share of the largest. Our choice: a foundation on soil moves by a few
/// per cent.
const STILL: f64 = 0.01;
/// A component has a known phase if it is at least this share of the largest component, and at least this number of its standard deviations.
/// Our choice.
const PHASE_FROM: f64 = 0.1;
const PHASE_DEVIATIONS: f64 = 4.0;
/// Angles from the real axis that are impossible for a mode, rad: 45° in one mode, or 30° in two. Our choice: lightly damped shapes stay
/// within 10°.
const PHASE_ONCE: f64 = 45.0 * TAU / 360.0;
const PHASE_TWICE: f64 = 30.0 * TAU / 360.0;

/// Measured quantities of the channels of a record, if they differ.
pub(crate) struct Quantities {
    /// Number of derivatives of displacement for each channel, and the quantity of most channels; `None` if one is unknown or all are equal.
    orders: Option<(Vec<i32>, ShapeQuantity)>,
}

impl Quantities {
    pub(crate) fn of(channels: &[Channel]) -> Quantities {
        let orders: Option<Vec<i32>> = channels.iter().map(|c| order(c.quantity)).collect();
        let with_target = |orders: Vec<i32>| {
            let count = |wanted: ShapeQuantity| orders.iter().filter(|own| **own == wanted.order()).count();
            let all = ShapeQuantity::ALL.into_iter();
            let target = all.max_by_key(|wanted| (count(*wanted), wanted.order()))?;
            (count(target) < orders.len()).then_some((orders, target))
        };
        Quantities {
            orders: orders.and_then(with_target),
        }
    }

    /// Evaluates the phases of shapes in one quantity, because mixed velocities and accelerations have phases of 90°.
    pub(crate) fn judge_as_one(&self, poles: &mut [Pole]) {
        let Some((orders, target)) = &self.orders else {
            return;
        };
        for pole in poles {
            let factors = factors(pole.frequency_hz, pole.damping_ratio, (orders, target.order()));
            let one: Vec<Complex64> = pole.shape.iter().zip(&factors).map(|(z, f)| z * f).collect();
            pole.phase_collinearity = phase_collinearity(&one);
            pole.phase_deviation = phase_deviation(&one);
        }
    }
}

/// Converts shapes of channels with different quantities to the quantity of most channels.
///
/// ```text
/// acceleration = λ velocity = λ² displacement        at the pole, exactly
/// ```
pub(crate) fn to_one_quantity(modes: &mut Modes, notes: &mut Vec<Note>) {
    let Some((orders, target)) = Quantities::of(&modes.channels).orders else {
        return;
    };
    for mode in &mut modes.modes {
        convert(mode, &orders, target.order());
    }
    notes.push(Note::OneQuantity { quantity: target });
}

/// Number of derivatives of displacement, if known.
pub(super) fn order(quantity: Quantity) -> Option<i32> {
    match quantity {
        Quantity::Displacement => Some(ShapeQuantity::Displacement.order()),
        Quantity::Velocity => Some(ShapeQuantity::Velocity.order()),
        Quantity::Acceleration => Some(ShapeQuantity::Acceleration.order()),
        Quantity::Unknown => None,
    }
}

/// Powers of λ that convert each channel to the quantity of most channels.
fn factors(frequency_hz: f64, damping_ratio: f64, (orders, target): (&[i32], i32)) -> Vec<Complex64> {
    let zeta = damping_ratio.clamp(0.0, 1.0);
    let root = Complex64::new(-zeta, (1.0 - zeta * zeta).sqrt()) * (TAU * frequency_hz);
    orders.iter().map(|own| root.powi(target - own)).collect()
}

fn convert(mode: &mut Mode, orders: &[i32], target: i32) {
    let factors = factors(
        mode.frequency_hz,
        mode.damping_ratio.unwrap_or(0.0),
        (orders, target),
    );
    let turned: Vec<Complex64> = mode.shape.iter().zip(&factors).map(|(z, f)| z * f).collect();
    let most = turned.iter().map(|z| z.norm()).fold(0.0, f64::max);
    if most > 0.0 {
        if let Some(sd) = &mut mode.shape_sd {
            let each = sd.iter_mut().zip(&factors);
            each.for_each(|(sd, factor)| *sd *= factor.norm() / most);
        }
        mode.shape = normalized(&turned);
        mode.phase_collinearity = phase_collinearity(&mode.shape);
    }
}

/// Notes channels without motion in all modes, and channels with a phase that is impossible in a mode shape.
pub(crate) fn doubt_channels(modes: &Modes, notes: &mut Vec<Note>) {
    for (c, channel) in modes.channels.iter().enumerate() {
        let most = modes
            .modes
            .iter()
            .map(|mode| mode.shape[c].norm())
            .fold(0.0, f64::max);
        if modes.modes.len() > 1 && most < STILL {
            notes.push(Note::StandsStill {
                channel: channel.name.clone(),
                share: most,
            });
        }
        let off: Vec<(f64, f64)> = modes.modes.iter().filter_map(|mode| phase_off(mode, c)).collect();
        let angles: Vec<f64> = off.iter().map(|(_, angle)| *angle).collect();
        if is_no_shapes(&angles) {
            let is_off = off.into_iter().filter(|(_, angle)| *angle >= PHASE_TWICE);
            notes.push(Note::PhaseOff {
                channel: channel.name.clone(),
                degrees_at_hz: is_off.map(|(f, angle)| [angle.to_degrees(), f]).collect(),
            });
        }
    }
}

/// Whether the angles of one channel from the real axis, 0 to π/2, are impossible in a mode shape.
fn is_no_shapes(angles: &[f64]) -> bool {
    let twice = angles.iter().filter(|angle| **angle >= PHASE_TWICE).count() > 1;
    twice || angles.iter().any(|angle| *angle >= PHASE_ONCE)
}

/// Frequency, Hz, and angle of a component from the line on which most others lie, 0 to π/2; `None` if its phase is too uncertain.
fn phase_off(mode: &Mode, c: usize) -> Option<(f64, f64)> {
    has_phase(mode, c).then(|| {
        (
            mode.frequency_hz,
            angle_between(mode.shape[c], middle_component(mode)),
        )
    })
}

/// Angle between the lines of two components, 0 to π/2.
fn angle_between(a: Complex64, b: Complex64) -> f64 {
    let z = a * b.conj();
    z.im.abs().atan2(z.re.abs())
}

/// The component with the least sum of angles to all others with a phase. The largest component may be that of the faulty channel.
fn middle_component(mode: &Mode) -> Complex64 {
    let known: Vec<Complex64> = (0..mode.shape.len())
        .filter(|&c| has_phase(mode, c))
        .map(|c| mode.shape[c])
        .collect();
    let sum = |z: &Complex64| known.iter().map(|other| angle_between(*z, *other)).sum::<f64>();
    let middle = known.iter().min_by(|a, b| sum(a).total_cmp(&sum(b)));
    middle.copied().unwrap_or(Complex64::ONE)
}

/// Whether a component is large and accurate enough to have a phase.
fn has_phase(mode: &Mode, c: usize) -> bool {
    let size = mode.shape[c].norm();
    let sd = mode
        .shape_sd
        .as_ref()
        .and_then(|sd| sd.get(c))
        .copied()
        .unwrap_or(0.0);
    size >= PHASE_FROM && size >= PHASE_DEVIATIONS * sd
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::{Identify, Method, identify};
    use crate::signal::{Channel, Record};

    const FREQUENCIES_HZ: [f64; 2] = [1.8, 4.9];
    const DAMPING: f64 = 0.015;
    const SHAPES: [[f64; 3]; 2] = [[1.0, 0.75, 0.4], [0.8, -0.5, -1.0]];

    fn root(mode: usize) -> Complex64 {
        Complex64::new(-DAMPING, (1.0 - DAMPING * DAMPING).sqrt()) * (TAU * FREQUENCIES_HZ[mode])
    }

    /// A free decay of both modes: accelerations, the channels of `velocity` as velocities.
    fn decay(velocity: &[usize]) -> Record {
        let sample = |c: usize, i: usize| -> f64 {
            let t = i as f64 / 100.0;
            let of = |mode: usize| {
                let size = if velocity.contains(&c) {
                    root(mode).inv()
                } else {
                    Complex64::ONE
                };
                (size * SHAPES[mode][c] * (root(mode) * t).exp()).re
            };
            of(0) + of(1)
        };
        let channels = (0..3).map(|c| Channel {
            quantity: match velocity.contains(&c) {
                true => Quantity::Velocity,
                false => Quantity::Acceleration,
            },
            ..Channel::named(["roof", "mid", "low"][c])
        });
        let samples = (0..3).map(|c| (0..2000).map(|i| sample(c, i)).collect());
        Record::new(channels.collect(), samples.collect(), 100.0).unwrap()
    }

    fn found(record: &Record) -> crate::modal::ModalAnalysis {
        let options = Identify {
            method: Method::Era,
            ..Identify::default()
        };
        identify(record, &options).unwrap()
    }

    /// φ of a velocity is that of the acceleration over λ: the conversion restores the original shape.
    #[test]
    fn exact_velocities_and_accelerations_make_one_shape() {
        let analysis = found(&decay(&[2]));
        assert!(
            analysis.notes.contains(&Note::OneQuantity {
                quantity: ShapeQuantity::Acceleration
            }),
            "{:?}",
            analysis.notes
        );
        for (mode, shape) in analysis.modes.modes.iter().zip(SHAPES) {
            for (z, exact) in mode.shape.iter().zip(shape) {
                let most = shape
                    .iter()
                    .fold(0.0_f64, |most, x| if x.abs() > most.abs() { *x } else { most });
                assert!((z - exact / most).norm() < 1e-5, "{:?}", mode.shape);
            }
        }
    }

    fn modes(shapes: &[[Complex64; 2]]) -> Modes {
        let template = found(&decay(&[])).modes.modes[0].clone();
        let mode = |(j, shape): (usize, &[Complex64; 2])| Mode {
            frequency_hz: 1.0 + j as f64,
            shape: shape.to_vec(),
            shape_sd: None,
            ..template.clone()
        };
        Modes {
            modes: shapes.iter().enumerate().map(mode).collect(),
            channels: vec![Channel::named("roof"), Channel::named("low")],
            method: Method::Era,
            duration_s: 20.0,
            history: Vec::new(),
        }
    }

    fn sentences(shapes: &[[Complex64; 2]]) -> Vec<String> {
        let mut notes = Vec::new();
        doubt_channels(&modes(shapes), &mut notes);
        notes.iter().map(ToString::to_string).collect()
    }

    #[test]
    fn holds_a_late_clock_and_a_channel_that_stands_still_are_named() {
        let turned = |degrees: f64| Complex64::from_polar(0.6, degrees.to_radians());
        let one = Complex64::ONE;
        // 10° and 20° twice are no fault; 46° once and 35° twice are, also near 180°
        assert_eq!(sentences(&[[one, turned(10.0)], [one, turned(-160.0)]]), [""; 0]);
        assert_eq!(sentences(&[[one, turned(35.0)], [one, turned(5.0)]]), [""; 0]);
        for [a, b] in [[46.0, 5.0], [35.0, 145.0]] {
            let said = sentences(&[[one, turned(a)], [one, turned(b)]]);
            assert!(
                said.len() == 1 && said[0].starts_with("the phase of \"low\""),
                "{said:?}"
            );
        }
        let still = Complex64::new(0.004, 0.0);
        let said = sentences(&[[one, still], [one, -still]]);
        assert!(
            said.len() == 1 && said[0].contains("\"low\" moves by less than 0.4"),
            "{said:?}"
        );
    }
}
