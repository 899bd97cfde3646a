//! The exit status of a watch.

use crate::outcome::Outcome;
use dolmen_work::judgement::{Colour, Verb, exit_status};

/// Outcome of a watch.
pub(crate) fn judged(is_alarming: bool) -> Outcome {
    let colour = if is_alarming { Colour::Red } else { Colour::Green };
    Outcome::Judged(exit_status(Verb::Watch, colour, true))
}
