//! Sensors that contradict each other: two of one place and direction that move differently, one turned round, or two exchanged on a floor
//! that moves as a rigid body.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | x | `samples` | horizontal sensors of one floor, mean taken off |
//! | G | `motions` | what unit motions of the floor (along x, along y, a turn about z) give at the sensors: d_x, d_y, d_y p_x - d_x p_y |
//! | C | `covariance` | x xᵀ |
//! | r | `unexplained` | 1 - tr(Gᵀ C G) / tr C with G made orthonormal: share of the motion that no rigid floor has |

use super::record::{Channel, Record};

/// What sensors say against each other.
#[derive(Clone, Debug, PartialEq)]
pub enum SensorDoubt {
    /// Two sensors of one place and direction move differently.
    Twins {
        /// Their names.
        channels: [String; 2],
        /// Correlation coefficient, 1 for the same motion.
        correlation: f64,
    },
    /// With the sign of one sensor changed, a floor moves as a rigid body.
    Turned {
        /// Its name.
        channel: String,
        /// Share of the motion that no rigid floor has.
        unexplained: f64,
        /// The same with the sign changed.
        changed: f64,
    },
    /// With two sensors exchanged, a floor moves as a rigid body.
    Swapped {
        /// Their names.
        channels: [String; 2],
        /// Share of the motion that no rigid floor has.
        unexplained: f64,
        /// The same with the two exchanged.
        changed: f64,
    },
}

/// Sensors nearer than this, m, and within 10° of one direction measure one thing. Ours.
const ONE_PLACE_M: f64 = 0.02;
const ONE_DIRECTION: f64 = 0.985;
/// Correlation below which twins contradict each other. Ours: noise that is half of the motion gives 0.8.
const TWINS_LEAST: f64 = 0.5;
/// Heights within this are one floor, m. Ours.
const ONE_FLOOR_M: f64 = 0.5;
/// Fewest sensors of a floor: three give its motion, and two more are needed to name the wrong one.
const SENSORS_LEAST: usize = 5;
/// Share of the motion above which a floor is not rigid as its sensors are described, by how much the change must lessen it, and by how much
/// the second-best change must be worse. Ours.
const UNEXPLAINED: f64 = 0.1;
const LESSENS: f64 = 2.5;
const CLEARLY: f64 = 1.25;

/// What the sensors of a record say against each other.
///
/// # Limits
/// Two sensors that are exchanged with alike motion are not seen, nor is one alone at its height. A floor that is not rigid is left alone
/// unless one single change explains it.
pub fn doubt_sensors(record: &Record) -> Vec<SensorDoubt> {
    let channels = record.channels();
    let mut doubts = twins(record);
    if !doubts.is_empty() {
        return doubts;
    }
    let mut left: Vec<usize> = (0..channels.len()).filter(|&i| is_horizontal(&channels[i])).collect();
    while let Some(&first) = left.first() {
        let height = |i: usize| channels[i].position_m.map_or(f64::NAN, |place| place[2]);
        let (floor, rest) = left.iter().partition(|&&i| (height(i) - height(first)).abs() <= ONE_FLOOR_M);
        left = rest;
        doubts.extend(floor_doubt(record, &floor));
    }
    doubts
}

fn is_horizontal(channel: &Channel) -> bool {
    channel.position_m.is_some() && channel.direction.is_some_and(|direction| direction[2].abs() < 0.1)
}

fn twins(record: &Record) -> Vec<SensorDoubt> {
    let channels = record.channels();
    let mut doubts = Vec::new();
    for second in 0..channels.len() {
        for first in 0..second {
            let (a, b) = (&channels[first], &channels[second]);
            let (Some(p), Some(q), Some(d), Some(e)) = (a.position_m, b.position_m, a.direction, b.direction) else {
                continue;
            };
            let apart_m = (0..3).map(|axis| (p[axis] - q[axis]).powi(2)).sum::<f64>().sqrt();
            let along: f64 = (0..3).map(|axis| d[axis] * e[axis]).sum();
            if apart_m > ONE_PLACE_M || along.abs() < ONE_DIRECTION {
                continue;
            }
            let of = covariance(record, &[first, second]);
            let correlation = along.signum() * of[0][1] / (of[0][0] * of[1][1]).sqrt();
            if correlation < TWINS_LEAST {
                doubts.push(SensorDoubt::Twins { channels: [a.name.clone(), b.name.clone()], correlation });
            }
        }
    }
    doubts
}

/// Sums of products of the samples with the mean taken off.
fn covariance(record: &Record, channels: &[usize]) -> Vec<Vec<f64>> {
    let centred: Vec<Vec<f64>> = channels
        .iter()
        .map(|&i| {
            let samples = record.samples(i);
            let mean = samples.iter().sum::<f64>() / samples.len() as f64;
            samples.iter().map(|x| x - mean).collect()
        })
        .collect();
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum();
    centred.iter().map(|a| centred.iter().map(|b| product(a, b)).collect()).collect()
}

/// A change of the channels of a floor.
#[derive(Clone, Copy)]
enum Change {
    Turned(usize),
    Swapped([usize; 2]),
}

fn floor_doubt(record: &Record, floor: &[usize]) -> Option<SensorDoubt> {
    if floor.len() < SENSORS_LEAST {
        return None;
    }
    let motions = orthonormal(motions(record.channels(), floor))?;
    let covariance = covariance(record, floor);
    let as_is = unexplained(&covariance, &motions, None);
    if as_is < UNEXPLAINED {
        return None;
    }
    let count = floor.len();
    let turned = (0..count).map(Change::Turned);
    let swapped = (0..count).flat_map(|j| (0..j).map(move |i| Change::Swapped([i, j])));
    let mut changes: Vec<(f64, Change)> =
        turned.chain(swapped).map(|change| (unexplained(&covariance, &motions, Some(change)), change)).collect();
    changes.sort_by(|a, b| a.0.total_cmp(&b.0));
    let [(changed, best), (second, _), ..] = changes[..] else { return None };
    if changed * LESSENS > as_is || changed * CLEARLY > second {
        return None;
    }
    let name = |i: usize| record.channels()[floor[i]].name.clone();
    Some(match best {
        Change::Turned(i) => SensorDoubt::Turned { channel: name(i), unexplained: as_is, changed },
        Change::Swapped([i, j]) => SensorDoubt::Swapped { channels: [name(i), name(j)], unexplained: as_is, changed },
    })
}

/// Unit motions of a rigid floor at its sensors.
fn motions(channels: &[Channel], floor: &[usize]) -> [Vec<f64>; 3] {
    let mut all = [Vec::new(), Vec::new(), Vec::new()];
    for &i in floor {
        let (Some([x, y, _]), Some([dx, dy, _])) = (channels[i].position_m, channels[i].direction) else { continue };
        all[0].push(dx);
        all[1].push(dy);
        all[2].push(dy * x - dx * y);
    }
    all
}

/// The same space by orthonormal vectors (Gram and Schmidt); `None` where the sensors do not span it.
fn orthonormal(vectors: [Vec<f64>; 3]) -> Option<Vec<Vec<f64>>> {
    let mut all: Vec<Vec<f64>> = Vec::new();
    for mut vector in vectors {
        let before = vector.iter().map(|x| x * x).sum::<f64>();
        for other in &all {
            let along: f64 = vector.iter().zip(other).map(|(x, y)| x * y).sum();
            vector.iter_mut().zip(other).for_each(|(x, y)| *x -= along * y);
        }
        let size = vector.iter().map(|x| x * x).sum::<f64>();
        (size > 1e-6 * before).then_some(())?;
        vector.iter_mut().for_each(|x| *x /= size.sqrt());
        all.push(vector);
    }
    Some(all)
}

/// Share of the motion that no rigid floor has.
fn unexplained(covariance: &[Vec<f64>], motions: &[Vec<f64>], change: Option<Change>) -> f64 {
    let place = |i: usize| match change {
        Some(Change::Swapped([a, b])) if i == a => b,
        Some(Change::Swapped([a, b])) if i == b => a,
        _ => i,
    };
    let sign = |i: usize| if matches!(change, Some(Change::Turned(of)) if of == i) { -1.0 } else { 1.0 };
    let count = covariance.len();
    let at = |i: usize, j: usize| sign(i) * sign(j) * covariance[place(i)][place(j)];
    let all: f64 = (0..count).map(|i| at(i, i)).sum();
    let explained: f64 = motions
        .iter()
        .map(|g| (0..count).map(|i| (0..count).map(|j| g[i] * at(i, j) * g[j]).sum::<f64>()).sum::<f64>())
        .sum();
    1.0 - explained / all
}
