//! Finds measured shapes that contradict a chain or frame, and the single change of sensors that would make them agree.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | φ | `values` | components of a mode at the sensors along x and y, as real as possible |
//! | ψ | `shape` | the model's mode at the same frequency, at the sensors of its direction; 0 at the others |
//! | r | `residual` | 1 − (φ·ψ)²/(φ² ψ²): share of a mode that the model does not explain |

use super::inverse::Sprung;
use super::plan_pairs::unmixed;
use super::real_shape::real_shape;
use super::turning::turning_hz;
use super::{Chain, Frame};
use crate::modal::{Mode, Modes};
use dolmen_linalg::Complex64;
use std::collections::BTreeMap;

/// A sensor within 15° (cosine) of x or y measures that direction, as in `directional`.
const ALONG_LEAST: f64 = 0.966;
/// Height range of one level, m, and the difference between its sensors, as a share of the largest component, above which they twist. As in
/// `directional`.
const LEVEL_M: f64 = 0.05;
const TWIST_MOST: f64 = 0.3;
/// Largest number of parts of a model for which all stiffnesses with given frequencies are computed. Our choice: five parts have 120 solutions.
const PARTS_MOST: usize = 5;
/// Unexplained share of the shapes above which a single change of sensors is searched. If none is found, the shapes contradict the model. Our choice.
const UNEXPLAINED: f64 = 0.05;
const CONTRADICTS: f64 = 0.2;
/// Factor by which a change must reduce the unexplained share, and factor within which another change is as good as the best. As for sensors on a
/// floor.
const LESSENS: f64 = 4.0;
const AS_GOOD: f64 = 2.0;
/// Difference between unexplained shares below which two changes are equally good: noise of shapes. Our choice.
const NOISE: f64 = 0.005;
/// Standard deviations by which frequencies without an exact stiffness are spread to find the nearest ones that have one. Our choice.
const SPREADS: [f64; 3] = [1.0, 2.0, 3.0];
/// Factor of a channel beside which all others vanish.
const VANISHING: f64 = 1e6;
/// Largest number of possible changes in the answer; with more of them none is likely. Our choice.
const CHANGES_MOST: usize = 4;
/// Factors between units or ranges that are often confused. Shapes cannot distinguish 9.8 (g instead of m/s²) from 10, or 981 (g instead of gal) from
/// 1000.
const FACTORS: [f64; 3] = [10.0, 100.0, 1000.0];

/// A single change of the sensors of a record.
#[derive(Clone, Debug, PartialEq)]
pub enum ChannelChange {
    /// Reversed sign of one channel.
    Turned {
        /// Name of the channel.
        channel: String,
    },
    /// Two channels exchanged.
    Exchanged {
        /// Names of the two channels.
        channels: [String; 2],
    },
    /// One channel in another unit or range.
    Scaled {
        /// Name of the channel.
        channel: String,
        /// Correction factor for its samples.
        factor: f64,
    },
}

/// Contradiction between the shapes of a record and a model.
#[derive(Clone, Debug, PartialEq)]
pub struct ShapeDoubt {
    /// Share of the shapes that the model does not explain with any stiffness that has the measured frequencies.
    pub unexplained: f64,
    /// The same share for the modes along x and for the modes along y.
    pub unexplained_along: [f64; 2],
    /// The share after any of `changes`; equals `unexplained` if there are none.
    pub changed: f64,
    /// Single changes of sensors, each of which makes the shapes agree; empty if there is none.
    pub changes: Vec<ChannelChange>,
}

impl ShapeDoubt {
    /// Whether the modes along x (0) or y (1) are doubtful: both directions if a change of sensors explains the shapes.
    pub fn is_of(&self, axis: usize) -> bool {
        !self.changes.is_empty() || self.unexplained_along[axis] > CONTRADICTS
    }
}

/// Contradiction between the shapes of a record and a chain; `None` if they agree.
///
/// # Limits
/// As [`frame_shape_doubt`].
pub fn chain_shape_doubt(chain: &Chain, modes: &Modes) -> Option<ShapeDoubt> {
    shape_doubt(chain, modes)
}

/// Contradiction between the shapes of a record and a frame; `None` if they agree.
///
/// Each mode belongs to the direction with the larger motion. If a direction has as many modes as the model has parts, their frequencies determine
/// all possible stiffnesses, and the measured shapes are compared with those of the best one. With fewer modes, only motion in the other direction is
/// unexplained. Frequencies that noise has moved to where no stiffness exists are spread by up to three standard deviations.
///
/// Two modes of nearly one frequency that are mixed in plan are taken apart first. In a direction with more modes than parts, those that turn about
/// the vertical axis through the origin are torsion and left out.
///
/// # Limits
/// Models of at most five parts. A change that does not alter the relation between the modes is not detected. With only two sensors in a direction,
/// the reversed one is unknown: the doubt names both.
pub fn frame_shape_doubt(frame: &Frame, modes: &Modes) -> Option<ShapeDoubt> {
    shape_doubt(frame, modes)
}

/// A sensor along x or y, on the model.
struct Sensor {
    name: String,
    /// 0 along x, 1 along y.
    axis: usize,
    sign: f64,
    height_m: f64,
    /// Displacement of the sensor per unit of each coordinate of the model.
    lever: Vec<f64>,
}

#[derive(Clone, Copy)]
enum Change {
    None,
    Turned(usize),
    Exchanged([usize; 2]),
    Scaled(usize, f64),
}

/// Modal coordinates for each stiffness that has given frequencies.
type Roots = Vec<Vec<Vec<f64>>>;

struct Measured<'a, S: Sprung> {
    of: &'a S,
    parts: usize,
    sensors: Vec<Sensor>,
    modes: Vec<MeasuredShape>,
    roots: BTreeMap<Vec<u64>, Roots>,
}

struct MeasuredShape {
    frequency_hz: f64,
    /// Standard deviation, Hz; 0 if unknown.
    sd_hz: f64,
    /// Measured components at the sensors.
    components: Vec<f64>,
}

fn shape_doubt<S: Sprung>(of: &S, modes: &Modes) -> Option<ShapeDoubt> {
    let mut measured = Measured::new(of, modes)?;
    let [all, x, y] = measured.unexplained(Change::None);
    if all <= UNEXPLAINED {
        return None;
    }
    let found = measured.best_changes(all);
    if found.is_empty() && all <= CONTRADICTS {
        return None;
    }
    let changed = found.first().map_or(all, |(share, _)| *share);
    Some(ShapeDoubt {
        unexplained: all,
        unexplained_along: [x, y],
        changed,
        changes: found
            .into_iter()
            .filter_map(|(_, change)| measured.named(change))
            .collect(),
    })
}

impl<'a, S: Sprung> Measured<'a, S> {
    /// `None` if no shape can be compared with the model.
    fn new(of: &'a S, modes: &Modes) -> Option<Self> {
        let parts = of.model().ok()?.parts();
        let mut places = Vec::new();
        let mut sensors = Vec::new();
        for (at, channel) in modes.channels.iter().enumerate() {
            let (Some(position), Some(direction)) = (channel.position_m, channel.direction) else {
                continue;
            };
            let Some(axis) = [0, 1]
                .into_iter()
                .find(|axis| direction[*axis].abs() >= ALONG_LEAST)
            else {
                continue;
            };
            let Ok(lever) = of.sensor(position[2]) else {
                continue;
            };
            places.push(at);
            sensors.push(Sensor {
                name: channel.name.clone(),
                axis,
                sign: direction[axis].signum(),
                height_m: position[2],
                lever,
            });
        }
        let components = |mode: &Mode| -> Option<Vec<f64>> {
            let own: Option<Vec<Complex64>> = places.iter().map(|at| mode.shape.get(*at).copied()).collect();
            own.map(|own| real_shape(&own))
        };
        let mut measured = Measured {
            of,
            parts,
            sensors,
            modes: unmixed(modes)
                .iter()
                .filter_map(|mode| {
                    Some(MeasuredShape {
                        frequency_hz: mode.frequency_hz,
                        sd_hz: mode.frequency_sd_hz.unwrap_or(0.0),
                        components: components(mode)?,
                    })
                })
                .collect(),
            roots: BTreeMap::new(),
        };
        let twisting: Vec<bool> = (0..measured.modes.len()).map(|m| measured.twists(m)).collect();
        let mut kept = twisting.into_iter();
        measured.modes.retain(|_| !kept.next().unwrap_or(false));
        measured.leave_out_turning(&turning_hz(modes));
        let is_enough = measured.sensors.len() > 1 && !measured.modes.is_empty();
        (is_enough && parts <= PARTS_MOST).then_some(measured)
    }

    /// Leaves out the modes at these frequencies, which turn about the origin, in a direction with more modes than parts.
    fn leave_out_turning(&mut self, turning_hz: &[f64]) {
        let turns = |mode: &MeasuredShape| turning_hz.contains(&mode.frequency_hz);
        let axes: Vec<usize> = (0..self.modes.len())
            .map(|mode| {
                let share = self.shares(&self.values(mode, Change::None));
                usize::from(share[1] > share[0])
            })
            .collect();
        let is_out: Vec<bool> = (0..self.modes.len())
            .map(|mode| {
                let own = (0..self.modes.len()).filter(|other| axes[*other] == axes[mode]);
                let others = own.filter(|other| !turns(&self.modes[*other])).count();
                turns(&self.modes[mode]) && others >= self.parts
            })
            .collect();
        let mut is_out = is_out.into_iter();
        self.modes.retain(|_| !is_out.next().unwrap_or(false));
    }

    /// Share of the squared components along x and along y.
    fn shares(&self, values: &[f64]) -> [f64; 2] {
        let power: f64 = values.iter().map(|x| x * x).sum();
        [0, 1].map(|axis| {
            let own = values.iter().zip(&self.sensors).filter(|(_, of)| of.axis == axis);
            own.map(|(x, _)| x * x).sum::<f64>() / power
        })
    }

    /// Components of a mode along the axes after a change.
    fn values(&self, mode: usize, change: Change) -> Vec<f64> {
        let mut read = self.modes[mode].components.clone();
        match change {
            Change::None => {}
            Change::Turned(at) => read[at] = -read[at],
            Change::Exchanged([a, b]) => read.swap(a, b),
            Change::Scaled(at, factor) => read[at] *= factor,
        }
        read.iter()
            .zip(&self.sensors)
            .map(|(x, of)| x * of.sign)
            .collect()
    }

    /// Whether sensors of one level and direction differ.
    fn twists(&self, mode: usize) -> bool {
        let values = self.values(mode, Change::None);
        let largest = values.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let mut pairs = (0..values.len()).flat_map(|j| (0..j).map(move |i| [i, j]));
        pairs.any(|[i, j]| {
            let (a, b) = (&self.sensors[i], &self.sensors[j]);
            a.axis == b.axis
                && (a.height_m - b.height_m).abs() < LEVEL_M
                && (values[i] - values[j]).abs() > TWIST_MOST * largest
        })
    }

    /// Mean unexplained share of all modes, of those along x, and of those along y.
    fn unexplained(&mut self, change: Change) -> [f64; 3] {
        let mut along: [Vec<(usize, Vec<f64>, f64)>; 2] = [Vec::new(), Vec::new()];
        for mode in 0..self.modes.len() {
            let values = self.values(mode, change);
            let share = self.shares(&values);
            let axis = usize::from(share[1] > share[0]);
            along[axis].push((mode, values, 1.0 - share[axis]));
        }
        let mut sums = [0.0; 2];
        for (axis, own) in along.iter().enumerate() {
            let across: f64 = own.iter().map(|(_, _, across)| across).sum();
            sums[axis] = across;
            if own.len() >= self.parts {
                let lowest = &own[..self.parts];
                let beyond: f64 = own[self.parts..].iter().map(|(_, _, across)| across).sum();
                let modes: Vec<usize> = lowest.iter().map(|(mode, ..)| *mode).collect();
                let values: Vec<&Vec<f64>> = lowest.iter().map(|(_, values, _)| values).collect();
                sums[axis] = beyond + self.of_frequencies(&modes, &values, axis);
            }
        }
        let mean = |sum: f64, count: usize| if count == 0 { 0.0 } else { sum / count as f64 };
        [
            mean(sums[0] + sums[1], along[0].len() + along[1].len()),
            mean(sums[0], along[0].len()),
            mean(sums[1], along[1].len()),
        ]
    }

    /// Sum of the residuals with the best stiffness that has the frequencies of these modes; the number of modes if there is none.
    fn of_frequencies(&mut self, modes: &[usize], values: &[&Vec<f64>], axis: usize) -> f64 {
        let key: Vec<u64> = modes
            .iter()
            .map(|mode| self.modes[*mode].frequency_hz.to_bits())
            .collect();
        if !self.roots.contains_key(&key) {
            let spreads = [0.0].into_iter().chain(SPREADS);
            let mut found = spreads.map(|deviations| self.solved(&self.spread(modes, deviations)));
            let found = found.find(|roots| !roots.is_empty()).unwrap_or_default();
            self.roots.insert(key.clone(), found);
        }
        let roots = self.roots.get(&key).map_or(&[][..], Vec::as_slice);
        let residual = |(values, coordinates): (&&Vec<f64>, &Vec<f64>)| {
            let shape = self.sensors.iter().map(|of| match of.axis == axis {
                true => of.lever.iter().zip(coordinates).map(|(l, q)| l * q).sum::<f64>(),
                false => 0.0,
            });
            let shape: Vec<f64> = shape.collect();
            let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            let scale = dot(values, values) * dot(&shape, &shape);
            match scale > 0.0 {
                true => 1.0 - dot(values, &shape).powi(2) / scale,
                false => 1.0,
            }
        };
        let sum = |root: &Vec<Vec<f64>>| values.iter().zip(root).map(residual).sum::<f64>();
        roots.iter().map(sum).fold(values.len() as f64, f64::min)
    }

    /// The frequencies of modes, Hz, the lowest lowered and the highest raised by this many standard deviations, the others in proportion: only
    /// frequencies too close to each other have no stiffness.
    fn spread(&self, modes: &[usize], deviations: f64) -> Vec<f64> {
        let last = modes.len().saturating_sub(1).max(1) as f64;
        let each = modes.iter().enumerate().map(|(at, mode)| {
            let MeasuredShape {
                frequency_hz, sd_hz, ..
            } = self.modes[*mode];
            frequency_hz + deviations * sd_hz * (2.0 * at as f64 / last - 1.0)
        });
        each.collect()
    }

    fn solved(&self, frequencies: &[f64]) -> Roots {
        let Ok(Some(found)) = self.of.roots(frequencies) else {
            return Vec::new();
        };
        let modes = |k: &Vec<f64>| -> Option<Vec<Vec<f64>>> {
            let modes = self.of.natural_modes_with(k).ok()?;
            Some(modes.into_iter().map(|mode| mode.coordinates).collect())
        };
        found.stiffness.iter().filter_map(modes).collect()
    }

    /// The changes with the smallest residual, best first. The list is empty if the best does not reduce the residual enough, or if too many are
    /// equally good.
    fn best_changes(&mut self, as_is: f64) -> Vec<(f64, Change)> {
        let count = self.sensors.len();
        let turned = (0..count).map(Change::Turned);
        let exchanged = (0..count).flat_map(|j| (0..j).map(move |i| Change::Exchanged([i, j])));
        let both_ways = FACTORS.iter().flat_map(|factor| [*factor, 1.0 / factor]);
        let both_ways: Vec<f64> = both_ways.collect();
        let scaled =
            (0..count).flat_map(|at| both_ways.iter().map(move |factor| Change::Scaled(at, *factor)));
        let all: Vec<Change> = turned.chain(exchanged).chain(scaled).collect();
        let mut tried: Vec<(f64, Change)> = all
            .into_iter()
            .map(|change| (self.unexplained(change)[0], change))
            .collect();
        tried.retain(|(share, change)| self.is_evident(*share, *change));
        tried.sort_by(|a, b| a.0.total_cmp(&b.0));
        let Some(best) = tried.first().map(|(share, _)| *share) else {
            return Vec::new();
        };
        if best * LESSENS > as_is {
            return Vec::new();
        }
        tried.retain(|(share, _)| *share <= (AS_GOOD * best).max(NOISE));
        let mut found: Vec<(f64, Change)> = Vec::new();
        for (share, change) in tried {
            // keeps only the best factor of each sensor
            let is_known = |(_, known): &(f64, Change)| match (known, change) {
                (Change::Scaled(a, _), Change::Scaled(b, _)) => *a == b,
                _ => false,
            };
            if !found.iter().any(is_known) {
                found.push((share, change));
            }
        }
        match found.len() <= CHANGES_MOST {
            true => found,
            false => Vec::new(),
        }
    }

    /// Whether the data show a change. A factor at which a channel vanishes from the shapes, or all others beside it, explains any shape: without
    /// the channel, or with it alone, there is little left to explain.
    fn is_evident(&mut self, share: f64, change: Change) -> bool {
        let Change::Scaled(at, factor) = change else {
            return true;
        };
        let vanished = if factor < 1.0 { 0.0 } else { VANISHING };
        self.unexplained(Change::Scaled(at, vanished))[0] > LESSENS * share.max(NOISE)
    }

    fn named(&self, change: Change) -> Option<ChannelChange> {
        let name = |at: usize| self.sensors[at].name.clone();
        match change {
            Change::None => None,
            Change::Turned(at) => Some(ChannelChange::Turned { channel: name(at) }),
            Change::Exchanged(pair) => Some(ChannelChange::Exchanged {
                channels: pair.map(name),
            }),
            Change::Scaled(at, factor) => Some(ChannelChange::Scaled {
                channel: name(at),
                factor,
            }),
        }
    }
}
