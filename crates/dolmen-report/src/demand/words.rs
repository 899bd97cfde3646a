//! Words and values for capacity against demand.

use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen::stability::stack::DemandVerdict;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

messages! {
    /// Capacity against demand.
    pub(crate) enum Words in "demand.words" {
        Above => { en: "above demand", ko: "기준 만족" },
        Near => { en: "near demand", ko: "기준에 근접" },
        Below => { en: "below demand", ko: "기준 불만족" },
        Unknown => { en: "unknown", ko: "판정 불가" },
    }
}

pub(super) fn verdict_words(verdict: DemandVerdict) -> Sentence {
    match verdict {
        DemandVerdict::Above => Words::Above,
        DemandVerdict::Near => Words::Near,
        DemandVerdict::Below => Words::Below,
        DemandVerdict::Unknown => Words::Unknown,
    }
    .into()
}

/// Accelerations in g.
pub(super) fn gravities() -> Unit {
    Unit {
        symbol: "g".to_owned(),
        factor: 1.0 / STANDARD_GRAVITY_M_S2,
    }
}

/// An acceleration in g.
pub(super) fn in_g(acceleration_m_s2: f64, digits: Digits) -> Quantity {
    Quantity::new(acceleration_m_s2, gravities(), digits)
}
