//! Names of states and factors, and values of factors.

use crate::document::{Cell, Column};
use dolmen::assess::Factor;
use dolmen::numeric::Interval;
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Unit, messages};
use dolmen_work::portfolio::{factor_words, state_words};

messages! {
    /// States, factors, ranges.
    pub(crate) enum Words in "score.words" {
        Factor(factor: Both) => { en: "{factor}", ko: "{factor}" },
        FactorHead => { en: "factor", ko: "인자" },
        State(state: Both) => { en: "{state}", ko: "{state}" },
        StateHead => { en: "state", ko: "상태" },
        Range { lower: Quantity, upper: Quantity } => { en: "{lower} – {upper}", ko: "{lower} – {upper}" },
        Within { value: Quantity, lower: Quantity, upper: Quantity } => {
            en: "{value} ({lower} – {upper})",
            ko: "{value} ({lower} – {upper})",
        },
        Ninety => { en: "90 %", ko: "90 %" },
    }
}

/// Name of a factor, with its unit.
pub(super) fn factor_name(factor: Factor) -> Both {
    Both::of(|language| factor_words(factor, language))
}

pub(super) fn factor_cell(factor: Factor) -> Cell {
    Cell::words(Words::Factor(factor_name(factor)))
}

/// Name of a damage state.
pub(crate) fn state_name(state: usize) -> Both {
    Both::of(|language| state_words(state, language))
}

pub(super) fn state_cell(state: usize) -> Cell {
    Cell::words(Words::State(state_name(state)))
}

pub(super) fn state_column(state: usize, unit: Unit) -> Column {
    let state = state_name(state);
    Column::numbers(Words::State(state), unit)
}

/// A value of a factor, in the unit of its name.
pub(super) fn factor_value(factor: Factor, value: f64) -> Quantity {
    let shown = match factor {
        Factor::Taper => value.to_degrees(),
        Factor::Storeys
        | Factor::BodyHeight
        | Factor::SlendernessAngle
        | Factor::BodySlenderness
        | Factor::BodyBaseHeightRatio => value,
    };
    Quantity::new(shown, Unit::ratio(), Digits::Trimmed(3))
}

/// Both ends of an interval, in the unit of the column.
pub(crate) fn range_cell(range: &Interval, quantity: impl Fn(f64) -> Quantity) -> Cell {
    Cell::words(Words::Range {
        lower: quantity(range.lower),
        upper: quantity(range.upper),
    })
}
