//! Answers about the six-factor score: of one pagoda, and the accuracy of the score.

mod effects;
mod form;
mod given;
mod pagoda;
mod quality;
mod weights;
mod words;

pub(crate) use form::{Form, form};
pub use given::score_given_text;
pub use pagoda::score_text;
pub use quality::score_quality_text;
pub(crate) use words::{range_cell, state_name};

use dolmen_words::Template;

/// Templates of the sentences on scores.
pub(crate) const TEMPLATES: [&[Template]; 7] = [
    effects::Effects::TEMPLATES,
    form::Form::TEMPLATES,
    given::Given::TEMPLATES,
    pagoda::Pagoda::TEMPLATES,
    quality::Quality::TEMPLATES,
    weights::Weights::TEMPLATES,
    words::Words::TEMPLATES,
];
