//! Titles of simulations of a frame.

use crate::simulated::version_name;
use dolmen_words::{Sentence, messages};
use dolmen_work::frame::FrameSimulation;

messages! {
    /// Direction and variant.
    pub(crate) enum Title in "frame.simulation.title" {
        Direction { direction: String } => { en: "Direction {direction}", ko: "{direction} 방향" },
        Version { direction: String, variant: Sentence } => {
            en: "Direction {direction}, {variant}",
            ko: "{direction} 방향, {variant}",
        },
    }
}

/// Direction and variant.
pub(super) fn title(simulation: &FrameSimulation) -> Sentence {
    let direction = simulation.direction.clone();
    let variant = version_name(simulation.variant.as_deref(), simulation.variant_title.as_ref());
    match variant {
        None => Title::Direction { direction }.into(),
        Some(variant) => Title::Version { direction, variant }.into(),
    }
}
