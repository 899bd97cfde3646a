//! Two channels that one survey has exchanged, or one that it has turned round, told by the shapes of another.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | φ, ψ | `phi`, `psi` | shapes of one frequency before and after, at the places that both show |
//! | MAC | `mean` | mean assurance of all of them |

use crate::modal::{ObservedMode, Pairing, assurance, shared};
use dolmen_linalg::Complex64;

/// Two channels that look exchanged.
#[derive(Clone, Debug, PartialEq)]
pub struct SwappedChannels {
    /// Names of the channels in the first survey.
    pub channels: [String; 2],
    /// Mean assurance of the shapes as they are.
    pub assurance: f64,
    /// Similarity after the exchange.
    pub exchanged: f64,
    /// Modes that it is the mean of.
    pub modes: usize,
}

/// A channel that looks turned round.
#[derive(Clone, Debug, PartialEq)]
pub struct TurnedChannel {
    /// Its name in the first survey.
    pub channel: String,
    /// Mean assurance of the shapes as they are.
    pub assurance: f64,
    /// Similarity after the change of sign.
    pub turned: f64,
    /// Modes that it is the mean of.
    pub modes: usize,
}

/// The single change of the channels that makes the shapes of both surveys similar.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Slip {
    Swapped(SwappedChannels),
    Turned(TurnedChannel),
}

/// A change of the channels of the second survey.
#[derive(Clone, Copy)]
enum Change {
    Exchanged([usize; 2]),
    Turned(usize),
}

/// Relative difference of frequencies that count as one. Our choice: a hundredth, above what surveys of an unchanged structure differ by.
pub(super) const ONE_FREQUENCY: f64 = 0.01;
/// Fewest modes that may say so: one shape can be turned into another by chance. Our choice.
const MODES_LEAST: usize = 2;
/// Fewest places: of two, every exchange is a change of the shape that damage or noise could make. Our choice.
const PLACES_LEAST: usize = 3;
/// Mean assurance above which shapes need no explanation, and below which an exchange explains nothing. Our choice.
const UNLIKE: f64 = 0.8;
const ALIKE: f64 = 0.95;
/// Least ratio of the unexplained part, 1 - MAC, of the second-best exchange to that of the best. Our choice.
const CLEARLY: f64 = 3.0;

/// The two channels whose exchange, or the one whose change of sign, makes the shapes of two surveys alike, if one such change alone does.
///
/// ```text
/// MAC = 1/n Σ MAC(φ_i, ψ_i)        n modes of one frequency (within 1 %), at the places that both surveys show
/// ```
/// At least two modes and three places; mean MAC below 0.8 as they are and 0.95 or more changed; and 1 - MAC of every other change three
/// times that of the best.
///
/// # Limits
/// Two channels with like components in every mode may be exchanged unseen: nothing changes then but their names. Three channels in a ring
/// are not found. Shapes that look alike under two exchanges say nothing.
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

/// Mean assurance, with one change of the second shapes.
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
