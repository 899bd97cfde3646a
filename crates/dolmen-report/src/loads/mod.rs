//! Wind and static loads in a report: findings, and the section of their combinations.

mod findings;
mod section;

pub(crate) use findings::findings;
pub(crate) use section::sections;

use dolmen_words::Template;

/// The sentences on wind and static loads as they are written.
pub(crate) const TEMPLATES: [&[Template]; 3] = [
    findings::Found::TEMPLATES,
    findings::WhyNot::TEMPLATES,
    section::Shown::TEMPLATES,
];
