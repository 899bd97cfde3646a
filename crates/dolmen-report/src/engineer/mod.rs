//! The engineer's own contribution to a report, and its answers: cover, signatures, place, photographs, tests, opinion. None of it is
//! computed, and missing data are left out.

mod cover;
mod damage;
mod front;
mod opinion;
mod photos;
mod place;
mod structure;
mod tests_made;
mod words;

pub(crate) use cover::{cover_photo, cover_rows, date_of, report_title};
pub(crate) use damage::{damage, named as named_damage, severity_words, what as damage_words};
pub(crate) use front::front;
pub(crate) use opinion::opinion;
pub(crate) use photos::Pictures;
pub(crate) use place::place;
pub(crate) use structure::structure;
pub(crate) use tests_made::tests_made;
pub(crate) use words::Given;

use dolmen_words::Template;

/// Templates of the sentences.
pub(crate) const TEMPLATES: [&[Template]; 8] = [
    words::Given::TEMPLATES,
    cover::Cover::TEMPLATES,
    damage::Damage::TEMPLATES,
    front::Front::TEMPLATES,
    place::Place::TEMPLATES,
    structure::Structure::TEMPLATES,
    tests_made::Tests::TEMPLATES,
    opinion::Opinion::TEMPLATES,
];
