//! Titles of simulations of a frame.

use crate::simulated::version_name;
use dolmen_words::{Sentence, messages};
use dolmen_work::frame::FrameSimulation;

messages! {
    /// Direction and variant.
    pub(crate) enum Title in "frame.simulation.title" {
        Direction { direction: String } => { en: "Direction {direction}", ko: "{direction} 방향" },
        Directions { directions: Vec<String> } => {
            en: "Directions {directions}",
            ko: "{directions} 방향",
        },
        VersionOfDirections { directions: Vec<String>, variant: Sentence } => {
            en: "Directions {directions}, {variant}",
            ko: "{directions} 방향, {variant}",
        },
        OfDirections { of: Sentence, said: Sentence } => { en: "{of}: {said}", ko: "{of}: {said}" },
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

/// All directions of a version, and its variant.
pub(super) fn title_of_all(simulations: &[&FrameSimulation]) -> Sentence {
    let directions: Vec<String> = simulations.iter().map(|of| of.direction.clone()).collect();
    let first = simulations.first();
    let variant = first.and_then(|of| version_name(of.variant.as_deref(), of.variant_title.as_ref()));
    match variant {
        None => Title::Directions { directions }.into(),
        Some(variant) => Title::VersionOfDirections { directions, variant }.into(),
    }
}
