//! Pairs all modes of two occasions together, by frequency and shape.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | d | `apart` | difference of two frequencies over the largest allowed difference |
//! | c | `cost` | d + 1 - MAC, or d alone if the shapes cannot be compared |

use crate::modal::error::refused;
use crate::modal::indicators::assurance;
use crate::modal::{ModalError, Mode, Modes};
use crate::numeric::assignment;
use crate::signal::Channel;
use dolmen_linalg::Complex64;

/// Cost of a mode without a partner: two modes are not paired if this costs more than leaving both single.
const UNPAIRED: f64 = 1.0;
/// Cost of a forbidden pair: more than any sum of other costs.
const FORBIDDEN: f64 = 1e6;
/// Cost of a mode without a partner when looking for the largest possible number of pairs.
const UNPAIRED_AT_ALL: f64 = 1e3;
/// Least MAC of two modes that may be the same for any difference of frequency. Our choice.
const LIKE_LEAST: f64 = 0.8;
/// Least cosine of the angle between two sensors with the same, or opposite, direction: 2.6°.
const PARALLEL: f64 = 0.999;
/// Fewest common places for a comparison of shapes: at a single place all shapes are equal.
const PLACES_LEAST: usize = 2;

/// Options of [`pair_modes`].
#[derive(Clone, Debug, PartialEq)]
pub struct Pairing {
    /// Largest relative difference of the frequencies of a pair; default 0.15 (our choice).
    pub frequency_within: f64,
    /// Least MAC for a pair with at least two common places; default 0.4 (our choice: two close modes rotate in the plane of their shapes, and
    /// unrelated shapes have a smaller MAC with four sensors or more).
    pub assurance_least: f64,
    /// Largest distance between two sensors at the same place, m; default 0.1 (our choice).
    pub place_within_m: f64,
}

impl Default for Pairing {
    fn default() -> Self {
        Pairing {
            frequency_within: 0.15,
            assurance_least: 0.4,
            place_within_m: 0.1,
        }
    }
}

/// Displacement of a mode at one sensor or one point of a survey.
#[derive(Clone, Debug, PartialEq)]
pub struct ObservedPoint {
    /// Name, place and direction of the sensor.
    pub channel: Channel,
    /// Component of the shape along the direction of the sensor, at any scale.
    pub component: Complex64,
}

impl ObservedPoint {
    /// A point that moves exactly in phase or in opposite phase.
    pub fn real(channel: Channel, displacement: f64) -> Self {
        ObservedPoint {
            channel,
            component: Complex64::new(displacement, 0.0),
        }
    }
}

/// A mode on one occasion, from any source.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ObservedMode {
    /// Natural frequency, Hz.
    pub frequency_hz: f64,
    /// Standard deviation of the frequency, Hz, if known.
    pub frequency_sd_hz: Option<f64>,
    /// Damping ratio.
    pub damping_ratio: Option<f64>,
    /// Standard deviation of the damping ratio.
    pub damping_ratio_sd: Option<f64>,
    /// Degrees of freedom of the standard deviations; infinite if these are assumed exact.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub degrees_of_freedom: f64,
    /// Known direction of the motion, or "torsion": modes with two different directions are never a pair. `None`: unknown.
    pub direction: Option<String>,
    /// Whether the user requested the mode although a test refused it.
    pub accepted: bool,
    /// Shape of the mode; empty if only the frequency is known.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub shape: Vec<ObservedPoint>,
}

impl ObservedMode {
    /// From a mode of [`identify`](crate::modal::identify); `time_blocks` is the number of blocks behind its standard deviations, below 2 if they are
    /// assumed exact.
    pub fn of(mode: &Mode, channels: &[Channel], time_blocks: usize) -> Self {
        let points = channels.iter().zip(&mode.shape);
        ObservedMode {
            frequency_hz: mode.frequency_hz,
            frequency_sd_hz: mode.frequency_sd_hz,
            damping_ratio: mode.damping_ratio,
            damping_ratio_sd: mode.damping_ratio_sd,
            degrees_of_freedom: mode.degrees_of_freedom(time_blocks),
            direction: None,
            accepted: !mode.is_found(),
            shape: points
                .map(|(channel, component)| ObservedPoint {
                    channel: channel.clone(),
                    component: *component,
                })
                .collect(),
        }
    }

    /// All modes of an identification.
    pub fn all(modes: &Modes, time_blocks: usize) -> Vec<Self> {
        let of = |mode| Self::of(mode, &modes.channels, time_blocks);
        modes.modes.iter().map(of).collect()
    }
}

/// Two modes that are considered the same.
#[derive(Clone, Debug, PartialEq)]
pub struct ModePair {
    /// Index in the first list.
    pub first: usize,
    /// Index in the second list.
    pub second: usize,
    /// MAC of the two shapes at their common places; `None` with fewer than two places: paired by frequency only.
    pub assurance: Option<f64>,
    /// Number of common places.
    pub places: usize,
    /// Increase of the total cost if these two must not be a pair, 0 to 1.
    pub margin: f64,
}

impl ModePair {
    /// Whether another pairing is nearly as good: the two may not be the same mode.
    pub fn doubtful(&self) -> bool {
        const NEARLY: f64 = 0.2; // ours: a fifth of what a mode without a partner costs
        self.margin < NEARLY
    }
}

/// Two lists of modes, paired.
#[derive(Clone, Debug, PartialEq)]
pub struct PairedModes {
    /// The pairs, in the order of the first list.
    pub pairs: Vec<ModePair>,
    /// Modes of the first list without a partner.
    pub only_first: Vec<usize>,
    /// Modes of the second list without a partner.
    pub only_second: Vec<usize>,
    /// Modes of the first list without a partner, each with a possible counterpart in the second list whose frequency differs more than allowed for a
    /// pair.
    pub moved_further: Vec<MovedFurther>,
    /// The pairing with the most pairs, as indices in both lists; empty if it has no more pairs than this one.
    pub most_pairs: Vec<[usize; 2]>,
}

/// A mode of the first list without a partner, and its possible counterpart in the second.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MovedFurther {
    /// Index in the first list.
    pub first: usize,
    /// Index in the second list, without a partner there; `None` if none is similar.
    pub second: Option<usize>,
    /// MAC of the two, if the shapes are known.
    pub assurance: Option<f64>,
}

/// Pairs the modes of two occasions so that the sum of their differences is smallest.
///
/// ```text
/// d = |f - f'| / (½ (f + f') w),   w = frequency_within            c = d + 1 - MAC, or d where fewer than two places are the same
/// minimise Σ_pairs c + Σ_first without a partner 1                 d > 1, c > 1 or MAC < assurance_least: no pair
/// ```
/// Two sensors are at one place if their distance is at most `place_within_m` and their directions are parallel (opposite directions change the
/// sign). If a place or direction is unknown, their names must be equal.
///
/// # Errors
/// [`ModalError::Option`] for an option out of its range; [`ModalError::Compared`] for a frequency that is not positive.
///
/// # Limits
/// A mode whose frequency changed by more than `frequency_within` appears as lost and as new. Two modes closer than their bandwidths share the plane
/// of their shapes, so their pairing may be chance; [`ModePair::doubtful`] indicates this.
pub fn pair_modes(
    first: &[ObservedMode],
    second: &[ObservedMode],
    options: &Pairing,
) -> Result<PairedModes, ModalError> {
    check(first.iter().chain(second), options)?;
    let likeness: Vec<Vec<Likeness>> = first
        .iter()
        .map(|a| second.iter().map(|b| Likeness::of(a, b, options)).collect())
        .collect();
    let mut cost: Vec<Vec<f64>> = likeness
        .iter()
        .map(|row| {
            let own = row.iter().map(|l| l.cost);
            own.chain((0..first.len()).map(|_| UNPAIRED)).collect()
        })
        .collect();
    let chosen = assignment(&cost)?;
    let total = |chosen: &[usize], cost: &[Vec<f64>]| -> f64 {
        chosen.iter().zip(cost).map(|(j, row)| row[*j]).sum()
    };
    let least = total(&chosen, &cost);
    let mut pairs = Vec::new();
    for (i, &j) in chosen.iter().enumerate().filter(|(_, j)| **j < second.len()) {
        let own = std::mem::replace(&mut cost[i][j], FORBIDDEN);
        let other = assignment(&cost)?;
        let margin = total(&other, &cost) - least;
        cost[i][j] = own;
        pairs.push(ModePair {
            first: i,
            second: j,
            assurance: likeness[i][j].assurance,
            places: likeness[i][j].places,
            margin,
        });
    }
    let without = |count: usize, of: fn(&ModePair) -> usize| -> Vec<usize> {
        let paired: Vec<usize> = pairs.iter().map(of).collect();
        (0..count).filter(|i| !paired.contains(i)).collect()
    };
    let only_first = without(first.len(), |pair| pair.first);
    let only_second = without(second.len(), |pair| pair.second);
    for row in &mut cost {
        row[second.len()..].fill(UNPAIRED_AT_ALL);
    }
    let most = assignment(&cost)?;
    let most = most.into_iter().enumerate();
    let mut most_pairs: Vec<[usize; 2]> = most
        .filter(|(i, j)| *j < second.len() && cost[*i][*j] < FORBIDDEN)
        .map(|(i, j)| [i, j])
        .collect();
    if most_pairs.len() <= pairs.len() {
        most_pairs.clear();
    }
    Ok(PairedModes {
        moved_further: moved_further(&only_first, &only_second, &likeness),
        only_first,
        only_second,
        most_pairs,
        pairs,
    })
}

/// Possible counterparts of modes without a partner: the mode with the most similar shape, or, without shapes, the next in order of frequency.
fn moved_further(
    only_first: &[usize],
    only_second: &[usize],
    likeness: &[Vec<Likeness>],
) -> Vec<MovedFurther> {
    let mut left = only_second.to_vec();
    let mut found = Vec::with_capacity(only_first.len());
    for &first in only_first {
        let like = |second: usize| &likeness[first][second];
        let may_be = |second: &&usize| {
            let like = like(**second);
            !like.strangers && like.assurance.is_none_or(|mac| mac >= LIKE_LEAST)
        };
        let best = left.iter().filter(may_be).copied().reduce(|best, other| {
            let mac = |second: usize| like(second).assurance.unwrap_or(0.0);
            if mac(other) > mac(best) { other } else { best }
        });
        left.retain(|second| Some(*second) != best);
        found.push(MovedFurther {
            first,
            second: best,
            assurance: best.and_then(|second| like(second).assurance),
        });
    }
    found
}

fn check<'a>(modes: impl Iterator<Item = &'a ObservedMode>, options: &Pairing) -> Result<(), ModalError> {
    if !(options.frequency_within > 0.0 && options.frequency_within <= 1.0) {
        return refused(
            "frequency_within",
            options.frequency_within,
            "above 0 and at most 1",
        );
    }
    if !(0.0..=1.0).contains(&options.assurance_least) {
        return refused("assurance_least", options.assurance_least, "between 0 and 1");
    }
    if options.place_within_m.is_nan() || options.place_within_m < 0.0 {
        return refused("place_within_m", options.place_within_m, "0 or more");
    }
    for mode in modes {
        if !(mode.frequency_hz > 0.0 && mode.frequency_hz.is_finite()) {
            return Err(ModalError::Compared {
                what: "frequency",
                given: mode.frequency_hz,
            });
        }
        let sds = [mode.frequency_sd_hz, mode.damping_ratio_sd];
        if let Some(given) = sds
            .into_iter()
            .flatten()
            .find(|sd| !(*sd >= 0.0 && sd.is_finite()))
        {
            return Err(ModalError::Compared {
                what: "standard deviation",
                given,
            });
        }
    }
    Ok(())
}

struct Likeness {
    cost: f64,
    assurance: Option<f64>,
    places: usize,
    /// Whether the directions of the two are known and different.
    strangers: bool,
}

impl Likeness {
    fn of(a: &ObservedMode, b: &ObservedMode, options: &Pairing) -> Self {
        let middle_hz = 0.5 * (a.frequency_hz + b.frequency_hz);
        let apart = (a.frequency_hz - b.frequency_hz).abs() / (middle_hz * options.frequency_within);
        let [phi, psi] = shared(&a.shape, &b.shape, options.place_within_m);
        let places = phi.len();
        let assurance = (places >= PLACES_LEAST).then(|| assurance(&phi, &psi));
        let strangers = matches!((&a.direction, &b.direction), (Some(a), Some(b)) if a != b);
        let unlike = assurance.is_some_and(|mac| mac < options.assurance_least);
        let cost = apart + assurance.map_or(0.0, |mac| 1.0 - mac);
        Likeness {
            cost: if strangers || unlike || apart > 1.0 || cost > UNPAIRED {
                FORBIDDEN
            } else {
                cost
            },
            assurance,
            places,
            strangers,
        }
    }
}

/// Components of two shapes at their common places; each place occurs once.
pub(crate) fn shared(a: &[ObservedPoint], b: &[ObservedPoint], within_m: f64) -> [Vec<Complex64>; 2] {
    let mut free = vec![true; b.len()];
    let (mut of_a, mut of_b) = (Vec::new(), Vec::new());
    for point in a {
        let found = b.iter().enumerate().find_map(|(j, other)| {
            let sign = same_place(&point.channel, &other.channel, within_m).filter(|_| free[j])?;
            Some((j, sign))
        });
        if let Some((j, sign)) = found {
            free[j] = false;
            of_a.push(point.component);
            of_b.push(b[j].component * sign);
        }
    }
    [of_a, of_b]
}

/// 1 if two sensors measure the same motion, -1 if they measure the opposite, `None` for different motions.
pub(crate) fn same_place(a: &Channel, b: &Channel, within_m: f64) -> Option<f64> {
    if let (Some(p), Some(q), Some(u), Some(v)) = (a.position_m, b.position_m, a.direction, b.direction) {
        let apart_m = p.iter().zip(q).map(|(x, y)| (x - y).powi(2)).sum::<f64>().sqrt();
        let cosine: f64 = u.iter().zip(v).map(|(x, y)| x * y).sum();
        return (apart_m <= within_m && cosine.abs() >= PARALLEL).then(|| cosine.signum());
    }
    (a.name == b.name).then_some(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mode(frequency_hz: f64, shape: &[f64]) -> ObservedMode {
        let points = shape.iter().enumerate();
        ObservedMode {
            frequency_hz,
            frequency_sd_hz: Some(0.01),
            damping_ratio: None,
            damping_ratio_sd: None,
            degrees_of_freedom: f64::INFINITY,
            direction: None,
            accepted: false,
            shape: points
                .map(|(c, x)| ObservedPoint {
                    channel: Channel::named(format!("s{c}")),
                    component: Complex64::new(*x, 0.0),
                })
                .collect(),
        }
    }

    fn indices(found: &PairedModes) -> Vec<(usize, usize)> {
        found.pairs.iter().map(|p| (p.first, p.second)).collect()
    }

    #[test]
    fn holds_shapes_pair_modes_that_crossed() {
        let (a, b) = ([1.0, 0.5, 0.1], [-0.1, 0.3, 1.0]);
        let first = [mode(2.00, &a), mode(2.05, &b)];
        let second = [mode(1.98, &b), mode(2.02, &a)];
        let found = pair_modes(&first, &second, &Pairing::default()).unwrap();
        assert_eq!(indices(&found), [(0, 1), (1, 0)]);
        assert!(
            found
                .pairs
                .iter()
                .all(|p| p.assurance.is_some_and(|mac| mac > 0.99) && !p.doubtful())
        );
        // the same frequencies without shapes: the nearest are paired, as doubtful
        let bare = |modes: &[ObservedMode]| -> Vec<ObservedMode> {
            modes.iter().map(|m| mode(m.frequency_hz, &[])).collect()
        };
        let found = pair_modes(&bare(&first), &bare(&second), &Pairing::default()).unwrap();
        assert_eq!(indices(&found), [(0, 0), (1, 1)]);
        assert!(
            found.pairs.iter().all(|p| p.assurance.is_none() && p.doubtful()),
            "{found:?}"
        );
    }

    #[test]
    fn holds_the_whole_is_paired_best_and_not_mode_by_mode() {
        // the nearest partner of 2.10 is 2.13, but 2.20 needs this partner more
        let first = [mode(2.10, &[]), mode(2.20, &[])];
        let second = [mode(1.95, &[]), mode(2.13, &[])];
        let found = pair_modes(&first, &second, &Pairing::default()).unwrap();
        assert_eq!(indices(&found), [(0, 0), (1, 1)]);
    }

    #[test]
    fn holds_modes_without_a_partner_are_lost_and_new() {
        let first = [mode(1.0, &[1.0, 0.2, 0.1]), mode(3.0, &[])];
        let second = [mode(1.01, &[0.1, -1.0, 0.3]), mode(4.0, &[])];
        let found = pair_modes(&first, &second, &Pairing::default()).unwrap();
        assert!(found.pairs.is_empty(), "{found:?}"); // unlike shapes, frequencies too far apart
        assert_eq!((found.only_first, found.only_second), (vec![0, 1], vec![0, 1]));
    }

    #[test]
    fn holds_sensors_are_told_by_place_and_way_and_not_by_a_name_that_moved() {
        let at = |name: &str, x: f64, direction: [f64; 3]| Channel {
            position_m: Some([x, 0.0, 2.0]),
            direction: Some(direction),
            ..Channel::named(name)
        };
        let (a, way) = (at("a", 1.0, [1.0, 0.0, 0.0]), [-1.0, 0.0, 0.0]);
        assert_eq!(same_place(&a, &at("other", 1.05, way), 0.1), Some(-1.0));
        assert_eq!(same_place(&a, &at("a", 4.0, [1.0, 0.0, 0.0]), 0.1), None);
        assert_eq!(same_place(&a, &at("a", 1.0, [0.0, 1.0, 0.0]), 0.1), None);
        assert_eq!(same_place(&a, &Channel::named("a"), 0.1), Some(1.0));
        assert_eq!(same_place(&a, &Channel::named("b"), 0.1), None);
    }

    #[test]
    fn holds_modes_of_two_directions_are_never_a_pair() {
        let of = |direction: &str| ObservedMode {
            direction: Some(direction.to_owned()),
            ..mode(2.0, &[])
        };
        let found = pair_modes(&[of("x")], &[of("y")], &Pairing::default()).unwrap();
        assert!(found.pairs.is_empty());
        let found = pair_modes(&[of("x")], &[mode(2.0, &[])], &Pairing::default()).unwrap();
        assert_eq!(indices(&found), [(0, 0)]);
    }

    #[test]
    fn refuses_options_and_modes_that_make_no_sense() {
        let within = |frequency_within| Pairing {
            frequency_within,
            ..Pairing::default()
        };
        let message = pair_modes(&[], &[], &within(0.0)).unwrap_err().to_string();
        assert_eq!(
            message,
            "frequency_within is 0, but must be above 0 and at most 1"
        );
        let message = pair_modes(&[mode(-1.0, &[])], &[], &within(0.1))
            .unwrap_err()
            .to_string();
        assert_eq!(
            message,
            "frequency of a mode to be compared is -1, but must be positive and finite: correct the survey"
        );
    }
}
