//! Numbers of a comparison, with suitable digits.

use crate::document::Cell;
use dolmen::assess::Evidence;
use dolmen::modal::ObservedMode;
use dolmen_words::{Digits, Quantity, Sentence, Unit, Values};

/// Smaller probabilities are given as below this.
const PROBABILITY_LEAST: f64 = 1e-4;

pub(super) fn hertz(frequency_hz: f64) -> Quantity {
    Quantity::new(frequency_hz, Unit::si("Hz"), Digits::Significant(4))
}

pub(super) fn frequencies(modes: &[ObservedMode]) -> Values {
    Values(modes.iter().map(|mode| hertz(mode.frequency_hz)).collect())
}

/// A share as per cent, with this many digits after the point.
pub(super) fn percent(share: f64, decimals: usize) -> Quantity {
    Quantity::new(share, Unit::percent(), Digits::Fixed(decimals))
}

/// The same without its unit, for "2.12 ± 0.32 %".
pub(super) fn bare_percent(share: f64, decimals: usize) -> Quantity {
    let mut bare = percent(share, decimals);
    bare.unit.symbol.clear();
    bare
}

/// The plus sign of an increase, which numbers omit.
pub(super) fn plus(change: f64) -> String {
    if change > 0.0 { "+" } else { "" }.to_owned()
}

pub(super) fn temperature(temperature_c: f64) -> Quantity {
    Quantity::new(temperature_c, Unit::si("°C"), Digits::Trimmed(3))
}

/// Change, half its interval, p, p of all, smallest detectable change.
pub(super) fn difference(relative: f64, evidence: Option<&Evidence>, decimals: usize) -> Vec<Cell> {
    let share = |share: f64| percent(share, decimals);
    let Some(evidence) = evidence else {
        let mut cells = vec![Cell::number(share(relative))];
        cells.resize(5, Cell::Number(None));
        return cells;
    };
    let change = match evidence.significant {
        true => Cell::Bad(share(relative)),
        false => Cell::number(share(relative)),
    };
    vec![
        change,
        Cell::number(share(evidence.half_width_95)),
        probability(evidence.p),
        probability(evidence.p_holm),
        Cell::number(share(evidence.detectable)),
    ]
}

fn probability(p: f64) -> Cell {
    match p < PROBABILITY_LEAST {
        true => Cell::words(Sentence::of_symbol("< 0.0001")),
        false => Cell::number(Quantity::new(p, Unit::ratio(), Digits::Fixed(4))),
    }
}
