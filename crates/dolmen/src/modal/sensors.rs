//! Finds contradictions between sensors: two sensors with one place and direction but different motion; or, on a floor that moves as a rigid body
//! in its lowest modes, a reversed sensor or station, or two exchanged ones.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | φ | `shapes` | shapes of the lowest modes at the horizontal sensors of one floor, scaled to length 1 |
//! | G | `motions` | unit motions of the floor (along x, along y, rotation about z) at the sensors: d_x, d_y, d_y p_x - d_x p_y |
//! | r | `unexplained` | mean of 1 - \|Gᵀ φ\|² with orthonormal G: share of the shapes that is impossible for a rigid floor |

use super::modes::Mode;
use crate::signal::{Channel, Record};
use dolmen_linalg::Complex64;

/// A contradiction between sensors.
#[derive(Clone, Debug, PartialEq)]
pub enum SensorDoubt {
    /// Two sensors with one place and direction move differently.
    Twins {
        /// Names of these channels.
        channels: [String; 2],
        /// 2 a·b / (a·a + b·b): 1 for the same motion, less for different size or form.
        likeness: f64,
    },
    /// With the sign of one sensor changed, a floor moves as a rigid body.
    Turned {
        /// Name of the channel.
        channel: String,
        /// Share of the motion impossible for a rigid floor.
        unexplained: f64,
        /// Similarity after the change of sign.
        changed: f64,
    },
    /// With the signs of both sensors of one place changed, a floor moves as a rigid body: the station is rotated by 180°.
    StationTurned {
        /// Names of these channels.
        channels: Vec<String>,
        /// Share of the motion impossible for a rigid floor.
        unexplained: f64,
        /// Similarity after the changes of sign.
        changed: f64,
    },
    /// With the sensors of two places exchanged (each with the one of the same direction), a floor moves as a rigid body.
    StationsSwapped {
        /// Names of the channels at each place.
        channels: [Vec<String>; 2],
        /// Share of the motion impossible for a rigid floor.
        unexplained: f64,
        /// Similarity after the exchange.
        changed: f64,
    },
    /// With two sensors exchanged, a floor moves as a rigid body.
    Swapped {
        /// Names of these channels.
        channels: [String; 2],
        /// Share of the motion impossible for a rigid floor.
        unexplained: f64,
        /// Similarity after the exchange.
        changed: f64,
    },
}

/// Largest distance between sensors at one place, m; their directions agree within 10°. Our choice.
const ONE_PLACE_M: f64 = 0.02;
const ONE_DIRECTION: f64 = 0.985;
/// Likeness, 2 a·b / (a·a + b·b), below which twins contradict each other. Our choice: noise of a third of the motion in each sensor gives 0.9.
const TWINS_LEAST: f64 = 0.85;
/// Largest difference of heights on one floor, m. Our choice.
const ONE_FLOOR_M: f64 = 0.5;
/// Fewest sensors on a floor: three determine its motion, and two more identify the faulty one.
const SENSORS_LEAST: usize = 5;
/// Largest number of lowest modes in the check, and the smallest number for a conclusion. Our choice: higher modes bend floors.
const MODES_MOST: usize = 3;
const MODES_LEAST: usize = 2;
/// Share of the shapes above which the sensors contradict a rigid floor, factor by which a change must reduce it, and factor to the second-best
/// change. Our choice: the roof of Palisaden has 0.008, and at least 0.17 with one reversed sensor.
const UNEXPLAINED: f64 = 0.05;
const LESSENS: f64 = 4.0;
const CLEARLY: f64 = 2.0;

/// Contradictions between the sensors of a record.
///
/// # Limits
/// An exchange of two sensors with similar motion is not detected, nor is a fault of a single sensor at its height. A sensor with a wrong position
/// may look like two exchanged stations. A floor that is not rigid is reported only if a single change explains its motion.
pub fn doubt_sensors(record: &Record, modes: &[Mode]) -> Vec<SensorDoubt> {
    let channels = record.channels();
    let mut doubts = twins(record);
    if !doubts.is_empty() {
        return doubts;
    }
    let mut left: Vec<usize> = (0..channels.len())
        .filter(|&i| is_horizontal(&channels[i]))
        .collect();
    while let Some(&first) = left.first() {
        let height = |i: usize| channels[i].position_m.map_or(f64::NAN, |place| place[2]);
        let (floor, rest) = left
            .iter()
            .partition(|&&i| (height(i) - height(first)).abs() <= ONE_FLOOR_M);
        left = rest;
        doubts.extend(floor_doubt(channels, modes, &floor));
    }
    doubts
}

fn is_horizontal(channel: &Channel) -> bool {
    channel.position_m.is_some()
        && channel
            .direction
            .is_some_and(|direction| direction[2].abs() < 0.1)
}

fn twins(record: &Record) -> Vec<SensorDoubt> {
    let channels = record.channels();
    let mut doubts = Vec::new();
    for second in 0..channels.len() {
        for first in 0..second {
            let (a, b) = (&channels[first], &channels[second]);
            let (Some(p), Some(q), Some(d), Some(e)) = (a.position_m, b.position_m, a.direction, b.direction)
            else {
                continue;
            };
            let apart_m = (0..3).map(|axis| (p[axis] - q[axis]).powi(2)).sum::<f64>().sqrt();
            let along: f64 = (0..3).map(|axis| d[axis] * e[axis]).sum();
            if apart_m > ONE_PLACE_M || along.abs() < ONE_DIRECTION {
                continue;
            }
            let of = covariance(record, &[first, second]);
            let likeness = 2.0 * along.signum() * of[0][1] / (of[0][0] + of[1][1]);
            if likeness < TWINS_LEAST {
                doubts.push(SensorDoubt::Twins {
                    channels: [a.name.clone(), b.name.clone()],
                    likeness,
                });
            }
        }
    }
    doubts
}

/// Sums of products of the samples without the mean.
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
    centred
        .iter()
        .map(|a| centred.iter().map(|b| product(a, b)).collect())
        .collect()
}

/// A change of the channels of a floor: sensors whose signs change, and pairs that are exchanged.
#[derive(Clone, Default)]
struct Change {
    turned: Vec<usize>,
    swapped: Vec<[usize; 2]>,
}

impl Change {
    fn turned(turned: Vec<usize>) -> Self {
        Change {
            turned,
            swapped: Vec::new(),
        }
    }

    fn swapped(swapped: Vec<[usize; 2]>) -> Self {
        Change {
            turned: Vec::new(),
            swapped,
        }
    }
}

/// Sensors of a floor by their places, two or more at each.
fn stations(channels: &[Channel], floor: &[usize]) -> Vec<Vec<usize>> {
    let place = |i: usize| channels[floor[i]].position_m.unwrap_or([f64::NAN; 3]);
    let mut all: Vec<Vec<usize>> = Vec::new();
    for i in 0..floor.len() {
        let near = |of: &&mut Vec<usize>| {
            let (p, q) = (place(of[0]), place(i));
            (0..3).map(|axis| (p[axis] - q[axis]).powi(2)).sum::<f64>().sqrt() <= ONE_PLACE_M
        };
        match all.iter_mut().find(near) {
            Some(of) => of.push(i),
            None => all.push(vec![i]),
        }
    }
    all.retain(|of| of.len() > 1);
    all
}

/// Exchanges of the sensors of two stations by direction; `None` if the stations measure different directions.
fn exchanged(channels: &[Channel], floor: &[usize], stations: [&[usize]; 2]) -> Option<Change> {
    let along = |a: usize, b: usize| -> f64 {
        let of = |i: usize| channels[floor[i]].direction.unwrap_or([f64::NAN; 3]);
        of(a).iter().zip(of(b)).map(|(d, e)| d * e).sum()
    };
    let [first, second] = stations;
    let partner = |a: &usize| {
        let own = second.iter().find(|b| along(*a, **b) >= ONE_DIRECTION);
        own.map(|b| [*a, *b])
    };
    let pairs: Vec<[usize; 2]> = first.iter().map(partner).collect::<Option<_>>()?;
    (first.len() == second.len()).then(|| Change::swapped(pairs))
}

fn changes(channels: &[Channel], floor: &[usize]) -> Vec<Change> {
    let count = floor.len();
    let turned = (0..count).map(|i| Change::turned(vec![i]));
    let swapped = (0..count).flat_map(|j| (0..j).map(move |i| Change::swapped(vec![[i, j]])));
    let stations = stations(channels, floor);
    let half_turns = stations.iter().cloned().map(Change::turned);
    let pairs = (0..stations.len()).flat_map(|j| (0..j).map(move |i| [i, j]));
    let moved = pairs.filter_map(|[i, j]| exchanged(channels, floor, [&stations[i], &stations[j]]));
    turned.chain(swapped).chain(half_turns).chain(moved).collect()
}

fn floor_doubt(channels: &[Channel], modes: &[Mode], floor: &[usize]) -> Option<SensorDoubt> {
    let shapes: Vec<Vec<Complex64>> = modes
        .iter()
        .take(MODES_MOST)
        .filter_map(|mode| shape_of(mode, channels.len(), floor))
        .collect();
    if floor.len() < SENSORS_LEAST || shapes.len() < MODES_LEAST {
        return None;
    }
    let motions = orthonormal(motions(channels, floor))?;
    let as_is = unexplained(&shapes, &motions, None);
    if as_is < UNEXPLAINED {
        return None;
    }
    let mut changes: Vec<(f64, Change)> = changes(channels, floor)
        .into_iter()
        .map(|change| (unexplained(&shapes, &motions, Some(&change)), change))
        .collect();
    changes.sort_by(|a, b| a.0.total_cmp(&b.0));
    let [(changed, best), (second, _), ..] = changes.as_slice() else {
        return None;
    };
    let changed = *changed;
    if changed * LESSENS > as_is || changed * CLEARLY > *second {
        return None;
    }
    let name = |i: &usize| channels[floor[*i]].name.clone();
    let unexplained = as_is;
    Some(match (best.turned.as_slice(), best.swapped.as_slice()) {
        ([i], _) => SensorDoubt::Turned {
            channel: name(i),
            unexplained,
            changed,
        },
        ([], [[i, j]]) => SensorDoubt::Swapped {
            channels: [name(i), name(j)],
            unexplained,
            changed,
        },
        ([], pairs) => SensorDoubt::StationsSwapped {
            channels: [0, 1].map(|of| pairs.iter().map(|pair| name(&pair[of])).collect()),
            unexplained,
            changed,
        },
        (turned, _) => SensorDoubt::StationTurned {
            channels: turned.iter().map(name).collect(),
            unexplained,
            changed,
        },
    })
}

/// Unit motions of a rigid floor at its sensors.
fn motions(channels: &[Channel], floor: &[usize]) -> [Vec<f64>; 3] {
    let mut all = [Vec::new(), Vec::new(), Vec::new()];
    for &i in floor {
        let (Some([x, y, _]), Some([dx, dy, _])) = (channels[i].position_m, channels[i].direction) else {
            continue;
        };
        all[0].push(dx);
        all[1].push(dy);
        all[2].push(dy * x - dx * y);
    }
    all
}

/// An orthonormal basis of the same space (Gram and Schmidt); `None` if the sensors do not determine it.
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

/// The shape at the sensors of a floor, with length 1; `None` if it lacks these channels or does not move there.
fn shape_of(mode: &Mode, channels: usize, floor: &[usize]) -> Option<Vec<Complex64>> {
    if mode.shape.len() != channels {
        return None;
    }
    let shape: Vec<Complex64> = floor.iter().map(|&i| mode.shape[i]).collect();
    let size = shape.iter().map(|x| x.norm_sqr()).sum::<f64>().sqrt();
    (size > 0.0).then(|| shape.iter().map(|x| x / size).collect())
}

/// Share of the shapes impossible for a rigid floor.
fn unexplained(shapes: &[Vec<Complex64>], motions: &[Vec<f64>], change: Option<&Change>) -> f64 {
    let place = |i: usize| {
        let pairs = change.iter().flat_map(|change| &change.swapped);
        let mut others = pairs.rev().filter_map(|[a, b]| match i {
            _ if i == *a => Some(*b),
            _ if i == *b => Some(*a),
            _ => None,
        });
        others.next().unwrap_or(i)
    };
    let sign = |i: usize| match change.is_some_and(|change| change.turned.contains(&i)) {
        true => -1.0,
        false => 1.0,
    };
    let along = |shape: &[Complex64], motion: &[f64]| {
        (0..shape.len())
            .map(|i| shape[place(i)] * (sign(i) * motion[i]))
            .sum::<Complex64>()
            .norm_sqr()
    };
    let explained = |shape: &Vec<Complex64>| motions.iter().map(|motion| along(shape, motion)).sum::<f64>();
    1.0 - shapes.iter().map(explained).sum::<f64>() / shapes.len() as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two sensors at each of three corners of a floor of 10 by 8 m, at one height.
    fn corners() -> Vec<Channel> {
        let places = [[0.0, 0.0], [10.0, 0.0], [3.0, 8.0]];
        let both = |at: usize| [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|direction| (at, direction));
        let each = (0..3).flat_map(both);
        each.map(|(at, direction)| Channel {
            position_m: Some([places[at][0], places[at][1], 12.0]),
            direction: Some(direction),
            ..Channel::named(format!("{at}{}", if direction[0] == 1.0 { "x" } else { "y" }))
        })
        .collect()
    }

    /// Motion of a rigid body, u = a - θ y, v = b + θ x, written without `motions`.
    fn rigid(a: f64, b: f64, theta: f64) -> Vec<Complex64> {
        let each = [[0.0, 0.0], [10.0, 0.0], [3.0, 8.0]].into_iter();
        each.flat_map(|[x, y]| [a - theta * y, b + theta * x])
            .map(|u| Complex64::new(u, 0.0))
            .collect()
    }

    fn shapes() -> Vec<Vec<Complex64>> {
        let unit = |shape: Vec<Complex64>| {
            let size = shape.iter().map(|x| x.norm_sqr()).sum::<f64>().sqrt();
            shape.iter().map(|x| x / size).collect::<Vec<_>>()
        };
        [
            rigid(1.0, 0.2, 0.01),
            rigid(-0.1, 1.0, 0.03),
            rigid(0.5, -0.6, 0.15),
        ]
        .map(unit)
        .to_vec()
    }

    #[test]
    fn exact_a_rigid_floor_is_explained_whole_and_every_sensor_turned_is_named() {
        let channels = corners();
        let floor: Vec<usize> = (0..6).collect();
        let motions = orthonormal(motions(&channels, &floor)).unwrap();
        assert!(unexplained(&shapes(), &motions, None).abs() < 1e-12);
        for wrong in 0..6 {
            let mut turned = shapes();
            turned.iter_mut().for_each(|shape| shape[wrong] = -shape[wrong]);
            let named = best(&turned, &motions);
            assert!(named.0.turned == [wrong] && named.1.abs() < 1e-12, "{wrong}");
        }
    }

    #[test]
    fn exact_two_sensors_exchanged_are_named() {
        let (channels, floor) = (corners(), (0..6).collect::<Vec<_>>());
        let motions = orthonormal(motions(&channels, &floor)).unwrap();
        for pair in [[0, 1], [1, 4], [2, 5], [3, 4]] {
            let mut swapped = shapes();
            swapped.iter_mut().for_each(|shape| shape.swap(pair[0], pair[1]));
            let named = best(&swapped, &motions);
            assert!(named.0.swapped == [pair] && named.1.abs() < 1e-12, "{pair:?}");
        }
    }

    #[test]
    fn exact_a_station_turned_round_and_two_exchanged_are_named() {
        let (channels, floor) = (corners(), (0..6).collect::<Vec<_>>());
        let motions = orthonormal(motions(&channels, &floor)).unwrap();
        for station in [0, 2, 4] {
            let mut turned = shapes();
            for shape in &mut turned {
                (station..station + 2).for_each(|i| shape[i] = -shape[i]);
            }
            let named = best(&turned, &motions);
            assert!(
                named.0.turned == [station, station + 1] && named.1.abs() < 1e-12,
                "{station}"
            );
        }
        for [a, b] in [[0, 2], [0, 4], [2, 4]] {
            let mut moved = shapes();
            for shape in &mut moved {
                shape.swap(a, b);
                shape.swap(a + 1, b + 1);
            }
            let named = best(&moved, &motions);
            // two sensors with equal motion on a rigid floor may be exchanged without effect
            let (swapped, pairs) = (&named.0.swapped, [[a, b], [a + 1, b + 1]]);
            assert!(
                !swapped.is_empty()
                    && swapped.iter().all(|pair| pairs.contains(pair))
                    && named.1.abs() < 1e-12,
                "{a} {b}: {swapped:?}"
            );
        }
    }

    fn best(shapes: &[Vec<Complex64>], motions: &[Vec<f64>]) -> (Change, f64) {
        let all = changes(&corners(), &(0..6).collect::<Vec<_>>()).into_iter();
        let tried = all.map(|change| {
            let left = unexplained(shapes, motions, Some(&change));
            (change, left)
        });
        tried.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap()
    }
}
