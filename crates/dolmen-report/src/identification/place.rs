//! The stiffness that vibration determines.

use crate::html::words::convention_word;
use dolmen_project::{Project, Structure};
use dolmen_words::message::Both;
use dolmen_words::{Sentence, messages};
use dolmen_work::surveyed::StiffnessAnswer;

messages! {
    /// Direction and springs.
    pub(crate) enum Place in "identification.place" {
        Direction { direction: String } => { en: "direction {direction}", ko: "{direction} 방향" },
        On { direction: String, springs: Both } => {
            en: "direction {direction}, {springs}",
            ko: "{direction} 방향, {springs}",
        },
    }
}

/// Direction and convention of the springs.
pub(super) fn place(answer: &StiffnessAnswer) -> Sentence {
    let direction = answer.direction.clone();
    match answer.convention {
        None => Place::Direction { direction },
        Some(convention) => Place::On {
            direction,
            springs: Both::of(|language| convention_word(convention, language)),
        },
    }
    .into()
}

/// Whether the springs of an answer have the convention of the file.
pub(super) fn is_asked(project: &Project, answer: &StiffnessAnswer) -> bool {
    match &project.structure {
        Structure::Frame(part) => answer.convention.is_none_or(|own| own == part.convention),
        Structure::Chain(_) | Structure::Stack(_) | Structure::Building(_) | Structure::Survey => true,
    }
}
