//! Converts modes at sensors to modes of a structure that moves in one horizontal direction.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | φ_c | `shape` | component of channel c, rotated in phase to be as real as possible | |
//! | d | `direction` | unit vector of the direction of the structure | |
//! | s_c | `direction` of a channel | unit vector of the sensor direction | |

use super::left_out::SHARE_LEAST;
use super::plan_pairs::unmixed;
use super::real_shape::{ALONG_LEAST, LEVEL_M, real_shape};
use super::turning::turning_hz;
use super::{LeftOut, MeasuredMode, ShapePoint};
use crate::modal::{Mode, Modes};
use crate::signal::Channel;
use dolmen_linalg::Complex64;

/// Largest difference between sensors of one level, as a share of the largest component of the shape; a larger difference
/// is twisting. Our choice.
const TWIST_MOST: f64 = 0.3;

/// Modes of one direction, and the modes left out.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DirectionalModes {
    /// Modes with their shape along the direction, one point for each height, lowest first.
    pub modes: Vec<MeasuredMode>,
    /// The other modes of the record, with the reason.
    pub left_out: Vec<LeftOut>,
    /// Number of channels that measure the direction and have a height; if 0, `modes` is empty.
    pub channels_along: usize,
}

/// The modes of a record that move in `direction`, as input for the identification of stiffness.
///
/// ```text
/// share = Σ_along φ_c² / Σ φ_c²,  c along if |s_c · d| ≥ .966;  u(z) = mean of φ_c sign(s_c · d) over channels at z
/// ```
///
/// # Input
/// * `direction` -- unit vector, horizontal
///
/// # Limits
/// Channels without a direction or a position are not used. Two modes of nearly one frequency that are mixed in plan are taken apart along x and
/// y, if their plane allows it. Each height is taken as rigid in plan: a mode is left out as
/// twisting if its sensors at one height differ by more than 30 % of its largest component.
pub fn directional_modes(modes: &Modes, direction: [f64; 3]) -> DirectionalModes {
    let along = channels_along(&modes.channels, direction);
    let mut found = DirectionalModes {
        channels_along: along.iter().flatten().count(),
        ..DirectionalModes::default()
    };
    if found.channels_along == 0 {
        return found;
    }
    for mode in &unmixed(modes) {
        match along_direction(mode, &along) {
            Ok(measured) => found.modes.push(measured),
            Err(why) => found.left_out.push(why),
        }
    }
    found
}

/// Height of each channel that measures the direction, and its sign.
fn channels_along(channels: &[Channel], direction: [f64; 3]) -> Vec<Option<(f64, f64)>> {
    let of = |channel: &Channel| {
        let cosine: f64 = channel
            .direction?
            .iter()
            .zip(&direction)
            .map(|(s, d)| s * d)
            .sum();
        let height = channel.position_m?[2];
        (cosine.abs() >= ALONG_LEAST).then_some((height, cosine.signum()))
    };
    channels.iter().map(of).collect()
}

/// Motion of a mode at its sensors.
#[derive(Clone, Debug, PartialEq)]
pub enum ShapeMotion {
    /// Along x, each height rigid in plan.
    AlongX(Vec<ShapePoint>),
    /// Along y, each height rigid in plan.
    AlongY(Vec<ShapePoint>),
    /// The sensors of one direction differ at one height.
    Twists,
    /// Motion mainly along neither x nor y; or the sensors have no positions or directions.
    Other,
}

impl ShapeMotion {
    /// Direction of a shape with one component per channel (real and imaginary part), by the same criteria as
    /// [`directional_modes`].
    pub fn of(channels: &[Channel], shape: &[[f64; 2]]) -> Self {
        let shape: Vec<Complex64> = shape.iter().map(|[re, im]| Complex64::new(*re, *im)).collect();
        let mut motion = ShapeMotion::Other;
        for (axis, made) in [
            ([1.0, 0.0, 0.0], ShapeMotion::AlongX as fn(_) -> _),
            ([0.0, 1.0, 0.0], ShapeMotion::AlongY as fn(_) -> _),
        ] {
            let along = channels_along(channels, axis);
            match shape_along((0.0, &shape, None), &along) {
                Ok(points) => return made(points),
                Err(LeftOut::Twists { .. }) => motion = ShapeMotion::Twists,
                Err(_) => {}
            }
        }
        motion
    }

    /// Name of the direction in surveys; `None` for other motions.
    pub fn direction(&self) -> Option<&'static str> {
        match self {
            ShapeMotion::AlongX(_) => Some("x"),
            ShapeMotion::AlongY(_) => Some("y"),
            ShapeMotion::Twists => Some("torsion"),
            ShapeMotion::Other => None,
        }
    }
}

impl DirectionalModes {
    /// Leaves out the first mode at one of these frequencies, Hz, and all modes above it: a fit needs the lowest modes
    /// without gaps.
    pub fn end_before(&mut self, doubtful_hz: &[f64]) {
        let doubtful = |mode: &MeasuredMode| doubtful_hz.contains(&mode.frequency_hz);
        if let Some(at) = self.modes.iter().position(doubtful) {
            self.left_out.push(LeftOut::Doubtful {
                frequency_hz: self.modes[at].frequency_hz,
                above: self.modes.len() - at - 1,
            });
            self.modes.truncate(at);
        }
    }
}

impl DirectionalModes {
    /// If there are more modes than `parts`, the number that a model has: leaves out those that turn about the vertical axis through the origin,
    /// and then those above the `parts` lowest, which it returns.
    pub fn keep(&mut self, modes: &Modes, parts: usize) -> Vec<MeasuredMode> {
        let turning_hz = match self.modes.len() > parts {
            true => turning_hz(modes),
            false => Vec::new(),
        };
        let turns = |mode: &MeasuredMode| turning_hz.contains(&mode.frequency_hz);
        // with too few left, none of them is torsion: the axes of the sensors may be turned
        if self.modes.iter().filter(|mode| !turns(mode)).count() >= parts {
            let turning = self.modes.iter().filter(|mode| turns(mode));
            let left_out = turning.map(|mode| LeftOut::Turns {
                frequency_hz: mode.frequency_hz,
            });
            self.left_out.extend(left_out);
            self.modes.retain(|mode| !turns(mode));
        }
        let beyond = self.modes.split_off(parts.min(self.modes.len()));
        self.left_out.extend(beyond.iter().map(|mode| LeftOut::Beyond {
            frequency_hz: mode.frequency_hz,
            modes: parts,
        }));
        beyond
    }
}

fn along_direction(mode: &Mode, along: &[Option<(f64, f64)>]) -> Result<MeasuredMode, LeftOut> {
    let shape = shape_along((mode.frequency_hz, &mode.shape, mode.shape_sd.as_deref()), along)?;
    Ok(MeasuredMode {
        frequency_hz: mode.frequency_hz,
        frequency_sd_hz: mode.frequency_sd_hz.unwrap_or(0.0),
        frequency_changes_hz: mode.frequency_changes_hz.clone(),
        shape,
    })
}

/// Shape along the channels that measure a direction, one point for each height.
fn shape_along(
    (frequency_hz, shape, shape_sd): (f64, &[Complex64], Option<&[f64]>),
    along: &[Option<(f64, f64)>],
) -> Result<Vec<ShapePoint>, LeftOut> {
    let real = real_shape(shape);
    let square = |chosen: bool| -> f64 {
        real.iter()
            .zip(along)
            .filter(|(_, a)| !chosen || a.is_some())
            .map(|(x, _)| x * x)
            .sum()
    };
    let share = square(true) / square(false);
    if share.is_nan() || share < SHARE_LEAST {
        return Err(LeftOut::OtherDirection { frequency_hz, share });
    }
    let sd = |channel: usize| shape_sd.and_then(|sd| sd.get(channel)).copied().unwrap_or(0.0);
    let mut heard: Vec<(f64, f64, f64)> = along // height, displacement, its standard deviation
        .iter()
        .enumerate()
        .filter_map(|(channel, a)| a.map(|(height, sign)| (height, sign * real[channel], sd(channel))))
        .collect();
    heard.sort_by(|a, b| a.0.total_cmp(&b.0));
    let largest = heard.iter().map(|point| point.1.abs()).fold(0.0, f64::max);
    let mut shape = Vec::new();
    for level in heard.chunk_by(|a, b| b.0 - a.0 < LEVEL_M) {
        let (low, high) = level
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), p| {
                (lo.min(p.1), hi.max(p.1))
            });
        let difference = (high - low) / largest;
        let height_m = level[0].0;
        if difference > TWIST_MOST {
            return Err(LeftOut::Twists {
                frequency_hz,
                height_m,
                difference,
            });
        }
        let n = level.len() as f64;
        shape.push(ShapePoint {
            height_m,
            displacement: level.iter().map(|p| p.1).sum::<f64>() / n,
            displacement_sd: level.iter().map(|p| p.2 * p.2).sum::<f64>().sqrt() / n,
        });
    }
    Ok(shape)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::Method;
    use crate::signal::Quantity;

    fn channel(z: f64, direction: [f64; 3]) -> Channel {
        Channel {
            name: format!("{z} {direction:?}"),
            quantity: Quantity::Acceleration,
            position_m: Some([0.0, 0.0, z]),
            direction: Some(direction),
        }
    }

    fn modes(shapes: &[Vec<Complex64>]) -> Modes {
        let mode = |(i, shape): (usize, &Vec<Complex64>)| Mode {
            frequency_sd_hz: Some(0.01),
            damping_ratio: None,
            shape: shape.clone(),
            ..Mode::made(1.0 + i as f64, 0.01, &[])
        };
        let (x, y) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
        Modes {
            modes: shapes.iter().enumerate().map(mode).collect(),
            // one sensor is mounted in the opposite direction; the top has two sensors
            channels: vec![
                channel(3.0, x),
                channel(6.0, [-1.0, 0.0, 0.0]),
                channel(6.0, x),
                channel(6.0, y),
            ],
            method: Method::SsiCov,
            duration_s: 600.0,
            history: vec![],
        }
    }

    #[test]
    fn exact_motions_of_shapes() {
        let channels = modes(&[]).channels;
        let motion = |shape: [f64; 4]| ShapeMotion::of(&channels, &shape.map(|re| [re * 0.6, re * 0.8]));
        for (shape, direction) in [
            ([0.5, -1.0, 1.0, 0.0], Some("x")),
            ([0.0, 0.0, 0.0, 1.0], Some("y")),
            ([0.0, 1.0, 1.0, 0.1], Some("torsion")),
            ([0.0, -0.5, 0.5, 0.7], None),
        ] {
            assert_eq!(motion(shape).direction(), direction, "{shape:?}");
        }
        let ShapeMotion::AlongX(points) = motion([0.5, -1.0, 1.0, 0.0]) else {
            panic!("along x");
        };
        for (point, (height_m, displacement)) in points.iter().zip([(3.0, 0.5), (6.0, 1.0)]) {
            assert_eq!(point.height_m, height_m);
            assert!((point.displacement.abs() - displacement).abs() < 1e-12);
        }
    }

    #[test]
    fn exact_shape_from_turned_and_reversed_sensors() {
        let turn = Complex64::from_polar(1.0, 0.7);
        let shape = [0.5, -1.0, 1.0, 0.0].map(|x| turn * x).to_vec();
        let found = directional_modes(&modes(&[shape]), [1.0, 0.0, 0.0]);
        let points = &found.modes[0].shape;
        assert_eq!(points.len(), 2);
        assert!((points[0].displacement / points[1].displacement - 0.5).abs() < 1e-14);
        assert_eq!((points[0].height_m, points[1].height_m), (3.0, 6.0));
    }

    #[test]
    fn holds_a_doubtful_mode_ends_what_goes_into_a_fit() {
        let shape = |a: f64, b: f64| [a, -b, b, 0.0].map(|x| Complex64::new(x, 0.0)).to_vec();
        let all = modes(&[shape(0.5, 1.0), shape(1.0, -0.5), shape(0.2, 1.0)]);
        let mut found = directional_modes(&all, [1.0, 0.0, 0.0]);
        found.end_before(&[5.0]);
        assert_eq!((found.modes.len(), found.left_out.len()), (3, 0));
        found.end_before(&[3.0, 2.0]);
        assert_eq!(found.modes.len(), 1);
        let said = found.left_out[0].to_string();
        assert!(
            said.starts_with(
                "The mode at 2.000 Hz is left out: the setups may not show one mode there. 1 above it"
            ),
            "{said}"
        );
    }

    #[test]
    fn refuses_modes_of_the_other_direction_and_twisting_ones() {
        let across = [0.1, -0.1, 0.1, 1.0].map(|x| Complex64::new(x, 0.0)).to_vec();
        let twisting = [0.5, 1.0, 1.0, 0.1].map(|x| Complex64::new(x, 0.0)).to_vec();
        let found = directional_modes(&modes(&[across, twisting]), [1.0, 0.0, 0.0]);
        assert!(found.modes.is_empty());
        assert!(
            found.left_out[0].to_string().contains("only 3 % of its motion"),
            "{}",
            found.left_out[0]
        );
        assert!(
            found.left_out[1]
                .to_string()
                .contains("at 6.00 m its sensors differ by 200 %")
        );
    }
}
