//! Detects two exchanged channels, or one channel with the wrong sign, from the mode shapes of two surveys.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | φ, ψ | `phi`, `psi` | shapes of one frequency before and after, at the common sensors |
//! | MAC | `mean` | mean MAC of all these modes |

use crate::modal::{ObservedMode, Pairing, assurance, shared};
use dolmen_linalg::Complex64;

/// Two channels that seem exchanged.
#[derive(Clone, Debug, PartialEq)]
pub struct SwappedChannels {
    /// Names of the channels in the first survey.
    pub channels: [String; 2],
    /// Mean MAC of the shapes as given.
    pub assurance: f64,
    /// Mean MAC after the exchange.
    pub exchanged: f64,
    /// Number of modes in these means.
    pub modes: usize,
}

/// A channel that seems to have the wrong sign.
#[derive(Clone, Debug, PartialEq)]
pub struct TurnedChannel {
    /// Its name in the first survey.
    pub channel: String,
    /// Mean MAC of the shapes as given.
    pub assurance: f64,
    /// Mean MAC after the change of sign.
    pub turned: f64,
    /// Number of modes in these means.
    pub modes: usize,
}

/// The single change of the channels that makes the shapes of both surveys similar.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Slip {
    Swapped(SwappedChannels),
    Turned(TurnedChannel),
}

impl Slip {
    /// The modes of the first survey with the change.
    pub(super) fn corrected(&self, modes: &[ObservedMode]) -> Vec<ObservedMode> {
        let mut modes = modes.to_vec();
        for mode in &mut modes {
            let at = |name: &String| mode.shape.iter().position(|point| point.channel.name == *name);
            match self {
                Slip::Turned(turned) => {
                    if let Some(at) = at(&turned.channel) {
                        mode.shape[at].component = -mode.shape[at].component;
                    }
                }
                Slip::Swapped(swapped) => {
                    let [first, second] = &swapped.channels;
                    if let Some((a, b)) = at(first).zip(at(second)) {
                        let component = mode.shape[a].component;
                        mode.shape[a].component = mode.shape[b].component;
                        mode.shape[b].component = component;
                    }
                }
            }
        }
        modes
    }
}

/// A change of the channels of the second survey.
#[derive(Clone, Copy)]
enum Change {
    Exchanged([usize; 2]),
    Turned(usize),
}

/// Relative difference up to which frequencies count as equal. Our choice: 1 %, above the difference between surveys of an unchanged
/// structure.
pub(super) const ONE_FREQUENCY: f64 = 0.01;
/// Fewest modes for a decision: a single shape can resemble another by chance. Our choice.
const MODES_LEAST: usize = 2;
/// Fewest common sensors: with two, damage or noise can change the shape as an exchange does. Our choice.
const PLACES_LEAST: usize = 3;
/// Mean MAC above which shapes need no explanation, and which a change of the channels must exceed. Our choice.
const UNLIKE: f64 = 0.8;
const ALIKE: f64 = 0.95;
/// Least ratio of the unexplained part, 1 - MAC, of the second-best exchange to that of the best. Our choice.
const CLEARLY: f64 = 3.0;

/// The single exchange of two channels, or the single change of sign, that makes the shapes of two surveys similar.
///
/// ```text
/// MAC = 1/n Σ MAC(φ_i, ψ_i)        n modes of one frequency (within 1 %), at the common sensors
/// ```
/// A result needs at least two modes, three sensors, a mean MAC below 0.8 as given and of at least 0.95 after the change. In addition, 1 -
/// MAC of every other change must be at least three times that of the best.
///
/// # Limits
/// An exchange of two channels with similar components in every mode is not found. Neither is an exchange of three channels. If two
/// exchanges give similar shapes, there is no result.
pub(super) fn slip_of_channels(
    before: &[ObservedMode],
    after: &[ObservedMode],
    options: &Pairing,
) -> Option<Slip> {
    let mut shapes = Vec::new();
    let mut free = vec![true; after.len()];
    for mode in before {
        let apart = |i: &usize| (after[*i].frequency_hz / mode.frequency_hz - 1.0).abs();
        let nearest = (0..after.len())
            .filter(|i| free[*i] && apart(i) <= ONE_FREQUENCY)
            .min_by(|a, b| apart(a).total_cmp(&apart(b)));
        let Some(i) = nearest else { continue };
        free[i] = false;
        shapes.push(shared(&mode.shape, &after[i].shape, options.place_within_m));
    }
    let places = shapes.first().map_or(0, |[phi, _]| phi.len());
    let same = shapes.iter().all(|[phi, _]| phi.len() == places);
    if shapes.len() < MODES_LEAST || places < PLACES_LEAST || !same {
        return None;
    }
    let assurance = mean(&shapes, None);
    if assurance >= UNLIKE {
        return None;
    }
    let pairs = (0..places).flat_map(|a| (a + 1..places).map(move |b| Change::Exchanged([a, b])));
    let all = pairs.chain((0..places).map(Change::Turned));
    let mut changed: Vec<(Change, f64)> = all.map(|change| (change, mean(&shapes, Some(change)))).collect();
    changed.sort_by(|a, b| b.1.total_cmp(&a.1));
    let [(change, best), (_, second), ..] = changed[..] else {
        return None;
    };
    if best < ALIKE || 1.0 - second < CLEARLY * (1.0 - best) {
        return None;
    }
    let mode = before.iter().find(|mode| !mode.shape.is_empty())?;
    let shown: Vec<&str> = mode
        .shape
        .iter()
        .filter(|point| {
            let one = std::slice::from_ref(*point);
            after
                .iter()
                .any(|m| !shared(one, &m.shape, options.place_within_m)[0].is_empty())
        })
        .map(|point| point.channel.name.as_str())
        .collect();
    let name = |at: usize| shown.get(at).map_or_else(String::new, |name| (*name).to_owned());
    let modes = shapes.len();
    Some(match change {
        Change::Exchanged(pair) => Slip::Swapped(SwappedChannels {
            channels: pair.map(name),
            assurance,
            exchanged: best,
            modes,
        }),
        Change::Turned(at) => Slip::Turned(TurnedChannel {
            channel: name(at),
            assurance,
            turned: best,
            modes,
        }),
    })
}

/// Mean MAC, with one change of the second shapes.
fn mean(shapes: &[[Vec<Complex64>; 2]], change: Option<Change>) -> f64 {
    let of = |[phi, psi]: &[Vec<Complex64>; 2]| {
        let mut psi = psi.clone();
        match change {
            Some(Change::Exchanged([a, b])) => psi.swap(a, b),
            Some(Change::Turned(at)) => psi[at] = -psi[at],
            None => {}
        }
        assurance(phi, &psi)
    };
    shapes.iter().map(of).sum::<f64>() / shapes.len() as f64
}
