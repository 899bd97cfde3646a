//! Tests whether the columns of a level move together: compares the mode components at the sensors of the level.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | u_c | `ordinate` | component of a mode at column c, along the direction, complex | – |
//! | v_c | `variance` | variance of the real part, and of the imaginary part, of u_c | – |
//! | s_c | `aside_m` | place of the column across the direction | m |
//! | a, θ | | translation and rotation of the floor: u_c = a + θ s_c | –, 1/m |

use super::left_out::SHARE_LEAST;
use super::real_shape::{ALONG_LEAST, LEVEL_M, real_turn};
use crate::modal::{Mode, Modes};
use crate::numeric::fisher_quantile;
use dolmen_linalg::Complex64;

/// Probability of a false alarm in a whole survey in which all columns move together. Our choice.
const CHANCE: f64 = 0.01;
/// Degrees of freedom of a standard deviation if the number of time blocks is unknown: many.
const MANY: f64 = 1e4;

/// Relative motion of the columns of a level in a mode.
#[derive(Clone, Debug, PartialEq)]
pub enum ColumnsMove {
    /// Equal amplitude and phase, within their errors.
    AsOne,
    /// The motion of points on a floor that translates and rotates.
    Turning,
    /// Two sensors differ: either the floor rotates, or one column moves separately. A third sensor can decide.
    TwoDiffer,
    /// A motion that is impossible for a rigid floor.
    Apart {
        /// Indices of columns in `columns`: without any single one of them, the others move together. Empty if no single column explains the motion.
        any_of: Vec<usize>,
    },
}

/// Component of a mode at the sensor of one column.
#[derive(Clone, Debug, PartialEq)]
pub struct ColumnOrdinate {
    /// Channel of the sensor.
    pub channel: String,
    /// Component over the mean of the other sensors of the level: 1 for a column that moves with them.
    pub of_others: Complex64,
    /// Standard deviation of the real part and of the imaginary part of that ratio, including calibration.
    pub of_others_sd: f64,
}

/// Result for one level in one mode.
#[derive(Clone, Debug, PartialEq)]
pub struct ColumnsOfLevel {
    /// Frequency of the mode, Hz.
    pub frequency_hz: f64,
    /// Height of the level, m.
    pub height_m: f64,
    /// The sensors, in the order of the channels.
    pub columns: Vec<ColumnOrdinate>,
    /// Relative motion of the columns.
    pub moves: ColumnsMove,
}

/// Tolerances for columns that move together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColumnsTogether {
    /// Relative standard deviation of a sensor's calibration, in amplitude and in phase (rad). Default 0.02 (our choice): sensors of one kind, set up
    /// by hand.
    pub calibration: f64,
}

impl Default for ColumnsTogether {
    fn default() -> Self {
        ColumnsTogether { calibration: 0.02 }
    }
}

/// How the columns of each level move in each mode along a horizontal unit vector. Levels without two sensors in this direction, and modes whose
/// shape has no standard deviation, are left out.
///
/// ```text
/// as one:   χ² = Σ |u_c − a|²/v_c,             2 (n − 1) degrees of freedom,   v_c = sd_c² + (calibration |u_c|)²
/// a floor:  χ² = Σ |u_c − a − θ s_c|²/v_c,     2 (n − 2)
/// χ²/degrees > F of (degrees, blocks of time − 1): apart;  1 % is shared out over the levels and modes of the survey
/// ```
///
/// # Limits
/// The standard deviations of a shape include that of the channel that sets the scale. For this channel the test uses the smallest deviation of the
/// others, so it is conservative. Motion common to all columns is not detected. Validated by `tests/validation/columns_together.rs`.
pub fn columns_together(
    modes: &Modes,
    direction: [f64; 3],
    options: &ColumnsTogether,
) -> Vec<ColumnsOfLevel> {
    let sensors = sensors(modes, direction);
    let levels: Vec<&[Sensor]> = sensors
        .chunk_by(|a, b| b.height_m - a.height_m < LEVEL_M)
        .filter(|level| level.len() > 1)
        .collect();
    let along = |mode: &&Mode| mode.shape_sd.is_some() && is_along(mode, &sensors);
    let moving: Vec<&Mode> = modes.modes.iter().filter(along).collect();
    let chance = CHANCE / (levels.len() * moving.len()).max(1) as f64;
    let mut found = Vec::new();
    for mode in moving {
        let blocks = mode.frequency_changes_hz.len();
        let below = if blocks > 2 { (blocks - 1) as f64 } else { MANY };
        for level in &levels {
            let Some(points) = points(mode, level, options.calibration) else {
                continue;
            };
            let test = Test { chance, below };
            found.push(ColumnsOfLevel {
                frequency_hz: mode.frequency_hz,
                height_m: level[0].height_m,
                columns: ordinates(level, &points),
                moves: test.moves(&points),
            });
        }
    }
    found
}

struct Sensor {
    at: usize,
    name: String,
    height_m: f64,
    aside_m: f64,
    sign: f64,
}

/// Sensors along the direction, lowest first; within a level in the order of the channels.
fn sensors(modes: &Modes, direction: [f64; 3]) -> Vec<Sensor> {
    let each = modes.channels.iter().enumerate();
    let mut found: Vec<Sensor> = each
        .filter_map(|(at, channel)| {
            let own = channel.direction?.into_iter().zip(direction);
            let cosine: f64 = own.map(|(s, d)| s * d).sum();
            let [x, y, height_m] = channel.position_m?;
            (cosine.abs() >= ALONG_LEAST).then(|| Sensor {
                at,
                name: channel.name.clone(),
                height_m,
                aside_m: x * direction[1] - y * direction[0],
                sign: cosine.signum(),
            })
        })
        .collect();
    found.sort_by(|a, b| a.height_m.total_cmp(&b.height_m));
    found
}

/// Whether most of the motion of the mode is along the direction.
fn is_along(mode: &Mode, sensors: &[Sensor]) -> bool {
    let all: f64 = mode.shape.iter().map(|z| z.norm_sqr()).sum();
    let own: f64 = sensors.iter().map(|of| mode.shape[of.at].norm_sqr()).sum();
    own >= SHARE_LEAST * all
}

#[derive(Clone, Copy)]
struct Point {
    ordinate: Complex64,
    variance: f64,
    aside_m: f64,
}

/// `None` if no ordinate of the level has a standard deviation.
fn points(mode: &Mode, level: &[Sensor], calibration: f64) -> Option<Vec<Point>> {
    let turn = real_turn(&mode.shape);
    let size = |at: &usize| mode.shape[*at].norm();
    let scaled = (0..mode.shape.len()).max_by(|a, b| size(a).total_cmp(&size(b)));
    let sd = |of: &Sensor| match mode.shape_sd.as_ref() {
        Some(sd) if Some(of.at) != scaled && sd[of.at] > 0.0 => Some(sd[of.at]),
        _ => None,
    };
    let least = level.iter().filter_map(sd).reduce(f64::min)?;
    let each = level.iter().map(|of| {
        let ordinate = of.sign * mode.shape[of.at] * turn;
        // the largest component, 1, has only a rounding deviation, because the shape is scaled by it
        let own = sd(of).unwrap_or(least);
        Point {
            ordinate,
            variance: own * own + (calibration * ordinate.norm()).powi(2),
            aside_m: of.aside_m,
        }
    });
    Some(each.collect())
}

/// Each ordinate relative to the mean of the others.
fn ordinates(level: &[Sensor], points: &[Point]) -> Vec<ColumnOrdinate> {
    let each = level.iter().enumerate().map(|(own, sensor)| {
        let others = without(points, own);
        let weight: f64 = others.iter().map(|of| 1.0 / of.variance).sum();
        let mean = mean(&others);
        let of_others = points[own].ordinate / mean;
        let variance = points[own].variance + of_others.norm_sqr() / weight;
        ColumnOrdinate {
            channel: sensor.name.clone(),
            of_others,
            of_others_sd: variance.sqrt() / mean.norm(),
        }
    });
    each.collect()
}

fn without(points: &[Point], own: usize) -> Vec<Point> {
    let others = points.iter().enumerate().filter(|(at, _)| *at != own);
    others.map(|(_, of)| *of).collect()
}

fn mean(points: &[Point]) -> Complex64 {
    let weight: f64 = points.iter().map(|of| 1.0 / of.variance).sum();
    points
        .iter()
        .map(|of| of.ordinate / of.variance)
        .sum::<Complex64>()
        / weight
}

struct Test {
    chance: f64,
    below: f64,
}

impl Test {
    fn moves(&self, points: &[Point]) -> ColumnsMove {
        if self.as_one(points) {
            return ColumnsMove::AsOne;
        }
        if points.len() == 2 {
            return ColumnsMove::TwoDiffer;
        }
        if self.as_floor(points) {
            return ColumnsMove::Turning;
        }
        let places = 0..points.len();
        let alike = |test: &dyn Fn(&[Point]) -> bool| -> Vec<usize> {
            places
                .clone()
                .filter(|own| test(&without(points, *own)))
                .collect()
        };
        let mut any_of = alike(&|others| self.as_one(others));
        if any_of.is_empty() {
            any_of = alike(&|others| self.as_floor(others));
        }
        ColumnsMove::Apart { any_of }
    }

    fn as_one(&self, points: &[Point]) -> bool {
        let mean = mean(points);
        let square: f64 = points
            .iter()
            .map(|of| (of.ordinate - mean).norm_sqr() / of.variance)
            .sum();
        self.holds(square, points.len() - 1)
    }

    /// Whether a rotating floor explains the points. `false` if it would explain any points, because they are too few or on one line along the
    /// motion.
    fn as_floor(&self, points: &[Point]) -> bool {
        let weight: f64 = points.iter().map(|of| 1.0 / of.variance).sum();
        let middle_m = points.iter().map(|of| of.aside_m / of.variance).sum::<f64>() / weight;
        let spread: f64 = points
            .iter()
            .map(|of| (of.aside_m - middle_m).powi(2) / of.variance)
            .sum();
        if points.len() < 3 || spread <= LEVEL_M * LEVEL_M * weight {
            return false;
        }
        let mean = mean(points);
        let turn = points
            .iter()
            .map(|of| (of.aside_m - middle_m) / of.variance * of.ordinate)
            .sum::<Complex64>()
            / spread;
        let square: f64 = points
            .iter()
            .map(|of| (of.ordinate - mean - turn * (of.aside_m - middle_m)).norm_sqr() / of.variance)
            .sum();
        self.holds(square, points.len() - 2)
    }

    /// Whether a sum of squares of this many complex contrasts is within its error.
    fn holds(&self, square: f64, contrasts: usize) -> bool {
        let degrees = 2.0 * contrasts as f64;
        // no alarm without a quantile
        fisher_quantile(self.chance, degrees, self.below).map_or(true, |most| square <= most * degrees)
    }
}
