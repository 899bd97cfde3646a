//! Wind and static loads in a report: findings, and the section of their combinations.

mod findings;
mod on_buildings;
mod on_frames;
mod on_stones;
mod section;
mod words;

pub(crate) use findings::findings;
pub(crate) use section::{Loaded, as_given, sections};

use dolmen_words::Template;

/// Templates of the sentences on wind and static loads.
pub(crate) const TEMPLATES: [&[Template]; 6] = [
    words::Found::TEMPLATES,
    findings::WhyNot::TEMPLATES,
    section::Shown::TEMPLATES,
    on_stones::OnStones::TEMPLATES,
    on_frames::OnFrames::TEMPLATES,
    on_buildings::OnBuildings::TEMPLATES,
];
