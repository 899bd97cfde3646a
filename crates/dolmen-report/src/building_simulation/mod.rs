//! The answer for a building under a motion: peaks, floors, dampers, points, time histories.

mod moved;
mod shown;
mod tables;

pub(crate) use moved::findings;
pub use shown::building_simulation_text;
pub(crate) use shown::sections;

use dolmen_words::Template;

/// Templates of the sentences on simulated buildings.
pub(crate) const TEMPLATES: [&[Template]; 3] = [
    moved::Moved::TEMPLATES,
    shown::Shown::TEMPLATES,
    tables::Tables::TEMPLATES,
];
