//! Pairs the modes of two parts of a record one to one and in order of frequency.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | d | `apart` | logarithm of the ratio of the two frequencies, less s, over the largest allowed fall |
//! | a | `likeness` | MAC of the two shapes, or the share of one shape in the plane of two close modes |
//! | c | `cost` | d + 1 − a |
//! | s | `scale` | logarithm of the common change of all frequencies |

use crate::modal::indicators::assurance;
use crate::modal::subspace::share_in_plane;
use crate::modal::{Mode, Modes};
use dolmen_linalg::Complex64;

/// Ratios of the frequency after to the frequency before of one mode: a structure softens in an earthquake, and hardly stiffens. Our choice.
const RATIO: [f64; 2] = [0.65, 1.15];
/// Least likeness of the shapes of one mode. Our choice.
const ALIKE: f64 = 0.8;
/// Cost of a mode without a partner, and of a forbidden pair.
const UNPAIRED: f64 = 1.0;
const FORBIDDEN: f64 = 1e6;
/// Least increase of the total cost without a pair, below which the pair may be chance. Our choice, as of [`ModePair`](crate::modal::ModePair).
const MARGIN: f64 = 0.2;
/// Step of the common change. Our choice.
const SCALE_STEP: f64 = 0.01;
/// Number of standard deviations of their distance within which two modes are close.
const CLOSE: f64 = 3.0;
/// Fewest common channels for the plane of two shapes: fewer lie in any plane.
const PLANE_LEAST: usize = 3;

/// Indices of one mode before and after.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct SameMode {
    pub(super) before: usize,
    pub(super) after: usize,
}

/// The modes that two parts have in common, in order of frequency.
///
/// ```text
/// minimise over s ≤ 0 and pairs in order:   Σ_pairs c + Σ_before without a partner 1 − s/w,   w = −ln 0.65
/// ```
/// Two modes whose half-power bands overlap, or whose distance is within three of its standard deviations, are close: their shapes are known as a
/// plane only. Close modes are compared in order of frequency, if all of them are found in both parts. A pair without which the total cost rises
/// little is left out.
pub(super) fn same_modes(before: &Modes, after: &Modes) -> Vec<SameMode> {
    let [of_before, of_after] = [Shapes::of(before, after), Shapes::of(after, before)];
    let likeness: Vec<Vec<f64>> = (0..before.modes.len())
        .map(|i| {
            let all = 0..after.modes.len();
            all.map(|j| of_before.likeness(i, &of_after, j)).collect()
        })
        .collect();
    let width = -RATIO[0].ln();
    let mut best: Option<(f64, Vec<Vec<f64>>)> = None;
    for step in 0..(width / SCALE_STEP) as usize {
        let scale = -(step as f64) * SCALE_STEP;
        let cost = costs((before, after), &likeness, scale);
        let total = in_order(&cost).total - scale / width;
        if best.as_ref().is_none_or(|(least, _)| total < *least - 1e-9) {
            best = Some((total, cost));
        }
    }
    let Some((_, mut cost)) = best else {
        return Vec::new();
    };
    let InOrder { total, pairs } = in_order(&cost);
    let is_sure = |pair: &&SameMode| {
        let own = std::mem::replace(&mut cost[pair.before][pair.after], FORBIDDEN);
        let margin = in_order(&cost).total - total;
        cost[pair.before][pair.after] = own;
        margin >= MARGIN
    };
    let sure: Vec<SameMode> = pairs.iter().filter(is_sure).copied().collect();
    let is_whole = |pair: &&SameMode| {
        let [from, to] = group(&before.modes, pair.before);
        let [first, last] = group(&after.modes, pair.after);
        let mut each = (from..=to).zip(first..=last);
        to - from == last - first && each.all(|(before, after)| sure.contains(&SameMode { before, after }))
    };
    sure.iter().filter(is_whole).copied().collect()
}

fn costs((before, after): (&Modes, &Modes), likeness: &[Vec<f64>], scale: f64) -> Vec<Vec<f64>> {
    let width = -RATIO[0].ln();
    let of = |(from, alike): (&Mode, &Vec<f64>)| {
        let each = after.modes.iter().zip(alike);
        each.map(|(to, alike)| {
            let ratio = to.frequency_hz / from.frequency_hz;
            let cost = (ratio.ln() - scale).abs() / width + 1.0 - alike;
            let is_allowed = (RATIO[0]..=RATIO[1]).contains(&ratio) && *alike >= ALIKE && cost <= UNPAIRED;
            if is_allowed { cost } else { FORBIDDEN }
        })
        .collect()
    };
    before.modes.iter().zip(likeness).map(of).collect()
}

/// Pairs in order, and their total cost.
struct InOrder {
    total: f64,
    pairs: Vec<SameMode>,
}

/// The pairs of least total cost of which none crosses another, by dynamic programming.
///
/// ```text
/// D(i, j) = min { D(i, j−1),  D(i−1, j) + 1,  D(i−1, j−1) + c(i, j) }
/// ```
fn in_order(cost: &[Vec<f64>]) -> InOrder {
    let columns = cost.first().map_or(0, Vec::len);
    let mut least = vec![vec![0.0; columns + 1]];
    for (i, row) in cost.iter().enumerate() {
        let above = &least[i];
        let mut own = vec![above[0] + UNPAIRED];
        for (j, cost) in row.iter().enumerate() {
            own.push(own[j].min(above[j + 1] + UNPAIRED).min(above[j] + cost));
        }
        least.push(own);
    }
    let (mut i, mut j) = (cost.len(), columns);
    let total = least[i][j];
    let mut pairs = Vec::new();
    while i > 0 && j > 0 {
        let here = least[i][j];
        if here == least[i][j - 1] {
            j -= 1;
        } else if here == least[i - 1][j] + UNPAIRED {
            i -= 1;
        } else {
            (i, j) = (i - 1, j - 1);
            pairs.push(SameMode { before: i, after: j });
        }
    }
    pairs.reverse();
    InOrder { total, pairs }
}

/// Shapes of the modes of one part at the channels of both.
struct Shapes<'a> {
    modes: &'a [Mode],
    shapes: Vec<Vec<Complex64>>,
}

impl<'a> Shapes<'a> {
    fn of(own: &'a Modes, other: &Modes) -> Self {
        let mut names: Vec<&str> = own.channels.iter().map(|of| of.name.as_str()).collect();
        names.retain(|name| other.channels.iter().any(|of| of.name == *name));
        names.sort_unstable();
        let place = |name: &&str| own.channels.iter().position(|of| of.name == **name);
        let places: Vec<usize> = names.iter().filter_map(place).collect();
        let shape = |mode: &Mode| places.iter().map(|at| mode.shape[*at]).collect();
        Shapes {
            modes: &own.modes,
            shapes: own.modes.iter().map(shape).collect(),
        }
    }

    /// MAC of two modes, or the largest share of one of them in the plane of the other and a mode close to it.
    fn likeness(&self, own: usize, other: &Shapes, at: usize) -> f64 {
        let (one, two) = (&self.shapes[own], &other.shapes[at]);
        if one.is_empty() {
            return 0.0;
        }
        let mac = assurance(one, two);
        if one.len() < PLANE_LEAST {
            return mac;
        }
        mac.max(other.share_in_planes(at, one))
            .max(self.share_in_planes(own, two))
    }

    fn share_in_planes(&self, at: usize, shape: &[Complex64]) -> f64 {
        let near =
            (0..self.modes.len()).filter(|of| *of != at && is_close(&self.modes[at], &self.modes[*of]));
        near.map(|of| share_in_plane(shape, [&self.shapes[at], &self.shapes[of]]))
            .fold(0.0, f64::max)
    }
}

fn is_close(one: &Mode, other: &Mode) -> bool {
    let sd = |of: &Mode| of.frequency_sd_hz.unwrap_or(0.0);
    let apart_hz = (one.frequency_hz - other.frequency_hz).abs();
    one.overlaps(other) || apart_hz < CLOSE * sd(one).hypot(sd(other))
}

/// First and last mode of those around one, each close to the next.
fn group(modes: &[Mode], at: usize) -> [usize; 2] {
    let below = (1..=at).rev().take_while(|i| is_close(&modes[i - 1], &modes[*i]));
    let above = (at + 1..modes.len()).take_while(|i| is_close(&modes[i - 1], &modes[*i]));
    [at - below.count(), at + above.count()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::Method;
    use crate::signal::Channel;

    const A: [f64; 4] = [1.0, 0.0, 0.0, 0.0];
    const B: [f64; 4] = [0.0, 1.0, 0.0, 0.0];
    const C: [f64; 4] = [0.0, 0.0, 1.0, 0.0];
    /// MAC with B: 0.86.
    const LIKE_B: [f64; 4] = [0.0, 1.0, 0.0, 0.4];

    fn modes(all: &[(f64, [f64; 4])]) -> Modes {
        let mode = |(frequency_hz, shape): &(f64, [f64; 4])| Mode {
            frequency_sd_hz: Some(0.015),
            ..Mode::made(*frequency_hz, 0.015, shape)
        };
        Modes {
            modes: all.iter().map(mode).collect(),
            channels: ["a", "b", "c", "d"].map(Channel::named).to_vec(),
            method: Method::SsiCov,
            duration_s: 300.0,
            history: Vec::new(),
        }
    }

    fn turned(by: f64) -> [[f64; 4]; 2] {
        let (sin, cos) = f64::sin_cos(by);
        [[cos, sin, 0.0, 0.0], [-sin, cos, 0.0, 0.0]]
    }

    fn pairs(before: &Modes, after: &Modes) -> Vec<[usize; 2]> {
        let all = same_modes(before, after);
        all.into_iter().map(|of| [of.before, of.after]).collect()
    }

    #[test]
    fn exact_close_modes_whose_shapes_mix_keep_their_places() {
        // the best MAC of the second mode, 0.86, is that of the fourth: 28 % higher, beyond the third
        let [low, high] = turned(0.7);
        let before = modes(&[(6.06, A), (6.12, B), (6.71, C), (7.86, LIKE_B)]);
        let after = modes(&[(6.07, low), (6.119, high), (6.725, C), (7.88, LIKE_B)]);
        assert_eq!(pairs(&before, &after), [[0, 0], [1, 1], [2, 2], [3, 3]]);
        assert_eq!(pairs(&after, &before), [[0, 0], [1, 1], [2, 2], [3, 3]]);
    }

    #[test]
    fn exact_close_modes_of_which_one_is_missing_are_not_compared() {
        let [_, high] = turned(0.7);
        let before = modes(&[(6.06, A), (6.12, B), (6.71, C), (7.86, LIKE_B)]);
        let after = modes(&[(6.119, high), (6.725, C), (7.88, LIKE_B)]);
        assert_eq!(pairs(&before, &after), [[2, 1], [3, 2]]);
        // nor is the mode above taken for it
        let after = modes(&[(6.725, C), (7.88, LIKE_B)]);
        assert_eq!(pairs(&before, &after), [[2, 0], [3, 1]]);
    }

    #[test]
    fn exact_all_modes_fall_together_or_one_alone() {
        let before = [(1.43, A), (2.2, C), (3.9, LIKE_B), (6.7, A)];
        let all = before.map(|(hz, shape)| (0.74 * hz, shape));
        let each = [[0, 0], [1, 1], [2, 2], [3, 3]];
        assert_eq!(pairs(&modes(&before), &modes(&all)), each);
        let mut one = before;
        one[2].0 *= 0.85;
        assert_eq!(pairs(&modes(&before), &modes(&one)), each);
    }

    #[test]
    fn exact_a_mode_far_off_may_be_another() {
        // the second mode is missing after, the third before
        let before = modes(&[(1.43, A), (6.1, B)]);
        let after = modes(&[(1.43, A), (4.2, LIKE_B)]);
        assert_eq!(pairs(&before, &after), [[0, 0]]);
        assert_eq!(pairs(&after, &before), [[0, 0]]);
    }
}
