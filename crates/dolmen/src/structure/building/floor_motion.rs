//! Converts mode shapes at the sensors on a floor into rigid motion of the floor: sway along x, sway along y, and rotation.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | φ | `real` | components of a mode at the sensors on the floor, rotated in phase to be as real as possible | – |
//! | G | `motions` | motion at each sensor for unit u, v and ρθ of the centre of mass: d_x, d_y, (d_y r_x − d_x r_y)/ρ | – |
//! | q | `shape` | u, v, ρθ, by least squares: G q ≈ φ | – |
//! | d, r | | direction of a sensor; its position relative to the centre of mass | –, m |

use super::plan_storey::{PlanMode, PlanMotion, Twist};
use crate::modal::{Mode, Modes};
use crate::signal::Channel;
use crate::structure::real_shape::real_shape;
use dolmen_linalg::{Complex64, Matrix, solve};

/// Sensors within this vertical distance of the floor belong to it, m. Our choice, as for sensors that contradict each other.
const ON_FLOOR_M: f64 = 0.5;
/// A sensor whose direction has a larger vertical part than this is not horizontal. Our choice.
const VERTICAL_MOST: f64 = 0.1;
const SENSORS_LEAST: usize = 3;
/// Least independent fraction of each of the three motions at the sensors. Below it the motions cannot be distinguished. Our choice: sensors within
/// 5 cm of one line on a floor of 10 m have less.
const APART_LEAST: f64 = 1e-4;
const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];

/// Position of the floor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FloorPlace {
    /// Height above the ground, m.
    pub height_m: f64,
    /// Centre of mass in plan, m.
    pub centre_m: [f64; 2],
    /// Radius of gyration about the centre of mass, m.
    pub gyration_m: f64,
}

/// A measured mode as a motion of the floor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FloorMode {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Standard deviation of the frequency, Hz; 0 if unknown.
    pub frequency_sd_hz: f64,
    /// u, v, ρθ of the centre of mass; the sum of their squares is 1.
    pub shape: [f64; 3],
    /// Twist of the mode: ρθ/u for a mode along x, and ρθ/v for a mode along y.
    pub twist: [Twist; 2],
    /// Fraction of the motion at the sensors that a rigid floor cannot explain.
    pub unexplained: f64,
}

/// Measured modes as motions of the floor.
#[derive(Clone, Debug, PartialEq)]
pub struct FloorModes {
    /// Modes in ascending frequency.
    pub modes: Vec<FloorMode>,
    /// Number of sensors on the floor.
    pub sensors: usize,
}

/// Converts measured modes into motions of the floor. `None` if fewer than three horizontal sensors are on the floor, or if they cannot distinguish
/// sway along x, sway along y and rotation.
///
/// ```text
/// q = (GᵀG)⁻¹ Gᵀ φ = P φ,   var t = Σ_c ((ρθ row of P − t · u row of P)_c / u)² sd_c²,   t = ρθ/u
/// ```
/// sd_c is the standard deviation of shape component c; the components are assumed independent.
///
/// Tested by `floor_in_records`.
pub fn floor_modes(modes: &Modes, floor: &FloorPlace) -> Option<FloorModes> {
    let on_floor = |channel: &Channel| motion(channel, floor);
    let rows: Vec<(usize, [f64; 3])> = modes
        .channels
        .iter()
        .enumerate()
        .filter_map(|(at, channel)| Some((at, on_floor(channel)?)))
        .collect();
    let pseudo_inverse = pseudo_inverse(&rows)?;
    let each = modes.modes.iter();
    Some(FloorModes {
        modes: each
            .filter_map(|mode| floor_mode(mode, &rows, &pseudo_inverse))
            .collect(),
        sensors: rows.len(),
    })
}

/// Motion at a sensor for unit u, v and ρθ; `None` for a sensor that is not horizontal or not on the floor.
fn motion(channel: &Channel, floor: &FloorPlace) -> Option<[f64; 3]> {
    let ([x, y, z], [d_x, d_y, d_z]) = (channel.position_m?, channel.direction?);
    let is_on = (z - floor.height_m).abs() <= ON_FLOOR_M && d_z.abs() < VERTICAL_MOST;
    let (r_x, r_y) = (x - floor.centre_m[0], y - floor.centre_m[1]);
    is_on.then(|| [d_x, d_y, (d_y * r_x - d_x * r_y) / floor.gyration_m])
}

/// (GᵀG)⁻¹ Gᵀ, 3 × sensors.
fn pseudo_inverse(rows: &[(usize, [f64; 3])]) -> Option<Matrix> {
    if rows.len() < SENSORS_LEAST {
        return None;
    }
    let g = Matrix::from_fn(rows.len(), 3, |row, column| rows[row].1[column]);
    let square = &g.transpose() * &g;
    let inverse = solve(&square, &Matrix::identity(3)).ok()?;
    // 1/((GᵀG)⁻¹)_ii is the squared length of the part of column i that is independent of the other columns
    let is_apart = |i: usize| {
        let own = 1.0 / inverse[(i, i)];
        own > APART_LEAST * square[(i, i)]
    };
    (0..3)
        .all(|i| square[(i, i)] > 0.0 && is_apart(i))
        .then(|| &inverse * &g.transpose())
}

fn floor_mode(mode: &Mode, rows: &[(usize, [f64; 3])], pseudo_inverse: &Matrix) -> Option<FloorMode> {
    let components: Vec<Complex64> = rows
        .iter()
        .map(|(at, _)| mode.shape.get(*at).copied())
        .collect::<Option<_>>()?;
    let real = real_shape(&components);
    let power: f64 = components.iter().map(|z| z.norm_sqr()).sum();
    let q: [f64; 3] = [0, 1, 2].map(|i| {
        let parts = real.iter().enumerate();
        parts.map(|(c, x)| pseudo_inverse[(i, c)] * x).sum()
    });
    let explained: f64 = rows
        .iter()
        .map(|(_, row)| row.iter().zip(&q).map(|(g, q)| g * q).sum::<f64>().powi(2))
        .sum();
    let length = q.iter().map(|q| q * q).sum::<f64>().sqrt();
    if !(power > 0.0 && length > 0.0) {
        return None;
    }
    let sd = |c: usize| {
        let known = mode.shape_sd.as_ref();
        known.and_then(|sd| sd.get(rows[c].0)).copied().unwrap_or(0.0)
    };
    let twist = |along: usize| {
        let ratio = q[2] / q[along];
        let part =
            |c: usize| (pseudo_inverse[(2, c)] - ratio * pseudo_inverse[(along, c)]) / q[along] * sd(c);
        let squares: f64 = (0..rows.len()).map(|c| part(c).powi(2)).sum();
        Twist {
            ratio,
            sd: squares.sqrt(),
        }
    };
    Some(FloorMode {
        frequency_hz: mode.frequency_hz,
        frequency_sd_hz: mode.frequency_sd_hz.unwrap_or(0.0),
        shape: q.map(|q| q / length),
        twist: [twist(0), twist(1)],
        unexplained: 1.0 - explained / power,
    })
}

impl FloorModes {
    /// Mean, over the lowest three modes, of the fraction of the motion that a rigid floor cannot explain.
    pub fn unexplained(&self) -> f64 {
        let lowest = self.modes.iter().take(3);
        let count = lowest.len().max(1) as f64;
        lowest.map(|mode| mode.unexplained).sum::<f64>() / count
    }

    /// The lowest three modes, with shapes. Its largest motion names each, if that gives three different names. The modes along x and y
    /// also have their twist.
    pub fn plan_modes(&self) -> Vec<PlanMode> {
        let lowest: Vec<&FloorMode> = self.modes.iter().take(3).collect();
        let share = |order: &[usize; 3]| -> f64 {
            let each = lowest.iter().zip(order);
            each.map(|(mode, motion)| mode.shape[*motion].powi(2)).sum()
        };
        let mut best = ORDERS[0];
        for order in ORDERS {
            if share(&order) > share(&best) {
                best = order;
            }
        }
        let each = lowest.iter().zip(best);
        each.map(|(mode, motion)| PlanMode {
            frequency_hz: mode.frequency_hz,
            frequency_sd_hz: mode.frequency_sd_hz,
            motion: Some(PlanMotion::ALL[motion]),
            twist: mode.twist.get(motion).copied(),
            shape: Some(mode.shape),
        })
        .collect()
    }

    /// The mode nearest to a frequency, if they differ by at most the fraction `within`.
    pub fn nearest(&self, frequency_hz: f64, within: f64) -> Option<&FloorMode> {
        let apart = |mode: &&FloorMode| (mode.frequency_hz / frequency_hz - 1.0).abs();
        let nearest = self.modes.iter().min_by(|a, b| apart(a).total_cmp(&apart(b)))?;
        (apart(&nearest) <= within).then_some(nearest)
    }
}
