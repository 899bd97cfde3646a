//! Detects whether one of two surveys has its directions x and y exchanged.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | φ, ψ | | shapes of modes of the same frequency before and after |
//! | ψ' | | ψ with the x and y sensors exchanged |

use super::swapped::ONE_FREQUENCY;
use crate::modal::{ObservedMode, ObservedPoint, Pairing, assurance, shared};

/// Fewest modes of the same frequency for a decision. Our choice, as for exchanged channels.
const MODES_LEAST: usize = 2;
/// Mean similarity above which the directions are accepted as they are, and below which an exchange is not accepted either. Our choice, as
/// for exchanged channels.
const UNLIKE: f64 = 0.8;
const ALIKE: f64 = 0.95;

/// Directions that seem exchanged in one of two surveys.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExchangedDirections {
    /// Number of modes with the same frequency in both surveys.
    pub modes: usize,
    /// Mean similarity of these modes without the exchange: the MAC of their shapes, or the fraction with the same direction.
    pub likeness: f64,
    /// Mean similarity after the exchange of x and y.
    pub exchanged: f64,
}

/// Whether all frequencies are equal, but the modes are similar only after x and y are exchanged in the later survey.
///
/// # Limits
/// Needs at least two modes within 1 %, and all modes of the survey with fewer modes. For a structure with equal modes along x and y, no
/// decision is possible.
pub(super) fn exchanged_directions(
    before: &[ObservedMode],
    after: &[ObservedMode],
    options: &Pairing,
) -> Option<ExchangedDirections> {
    let mut free = vec![true; after.len()];
    let mut pairs = Vec::new();
    for mode in before {
        let apart = |i: &usize| (after[*i].frequency_hz / mode.frequency_hz - 1.0).abs();
        let nearest = (0..after.len())
            .filter(|i| free[*i] && apart(i) <= ONE_FREQUENCY)
            .min_by(|a, b| apart(a).total_cmp(&apart(b)));
        if let Some(i) = nearest {
            free[i] = false;
            pairs.push((mode, &after[i]));
        }
    }
    if pairs.len() < MODES_LEAST || pairs.len() < before.len().min(after.len()) {
        return None;
    }
    let mean = |turns: bool| {
        let each = pairs.iter().map(|(a, b)| likeness(a, b, turns, options));
        each.collect::<Option<Vec<f64>>>()
            .map(|all| all.iter().sum::<f64>() / all.len() as f64)
    };
    let (likeness, exchanged) = (mean(false)?, mean(true)?);
    (likeness < UNLIKE && exchanged >= ALIKE).then_some(ExchangedDirections {
        modes: pairs.len(),
        likeness,
        exchanged,
    })
}

/// Similarity of two modes, with x and y of the second exchanged if `turns`; `None` if neither shapes nor directions are known.
fn likeness(a: &ObservedMode, b: &ObservedMode, turns: bool, options: &Pairing) -> Option<f64> {
    if !a.shape.is_empty() && !b.shape.is_empty() {
        let has_directions =
            |of: &ObservedMode| of.shape.iter().all(|point| point.channel.direction.is_some());
        if has_directions(a) && has_directions(b) {
            let turned: Vec<ObservedPoint> = b.shape.iter().map(|point| turned(point, turns)).collect();
            let [phi, psi] = shared(&a.shape, &turned, options.place_within_m);
            // a direction that one survey did not measure gives no information
            return (phi.len() > 1).then(|| assurance(&phi, &psi));
        }
    }
    let (own, other) = (a.direction.as_deref()?, b.direction.as_deref()?);
    let other = match other {
        "x" if turns => "y",
        "y" if turns => "x",
        same => same,
    };
    Some(if own == other { 1.0 } else { 0.0 })
}

fn turned(point: &ObservedPoint, turns: bool) -> ObservedPoint {
    let mut point = point.clone();
    if let Some([x, y, z]) = point.channel.direction.filter(|_| turns) {
        point.channel.direction = Some([y, x, z]);
    }
    point
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stated(frequency_hz: f64, direction: &str) -> ObservedMode {
        ObservedMode {
            accepted: false,
            frequency_hz,
            frequency_sd_hz: Some(0.01),
            damping_ratio: None,
            damping_ratio_sd: None,
            degrees_of_freedom: f64::INFINITY,
            direction: Some(direction.to_owned()),
            shape: Vec::new(),
        }
    }

    #[test]
    fn holds_labels_exchanged_are_told_from_a_change() {
        let before = [stated(1.1, "x"), stated(1.5, "y")];
        let of = |after: [ObservedMode; 2]| exchanged_directions(&before, &after, &Pairing::default());
        let found = of([stated(1.1, "y"), stated(1.5, "x")]).unwrap();
        assert_eq!((found.modes, found.likeness, found.exchanged), (2, 0.0, 1.0));
        assert_eq!(of([stated(1.1, "x"), stated(1.5, "y")]), None);
        // different frequencies mean a change of the structure
        assert_eq!(of([stated(1.2, "y"), stated(1.5, "x")]), None);
    }
}
