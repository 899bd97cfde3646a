//! Wind and static loads in a report: findings, and the section of their combinations.

mod findings;
mod on_stones;
mod section;

pub(crate) use findings::findings;
pub(crate) use section::{Loaded, as_given, sections};

use dolmen_words::Template;

/// The sentences on wind and static loads as they are written.
pub(crate) const TEMPLATES: [&[Template]; 4] = [
    findings::Found::TEMPLATES,
    findings::WhyNot::TEMPLATES,
    section::Shown::TEMPLATES,
    on_stones::OnStones::TEMPLATES,
];
