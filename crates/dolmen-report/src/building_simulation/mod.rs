//! What an answer says of a building under a motion: how it moved, floors, dampers, points, in time.

mod moved;
mod shown;
mod tables;

pub(crate) use moved::findings;
pub use shown::building_simulation_text;
pub(crate) use shown::sections;

use dolmen_words::Template;

/// The sentences on simulated buildings as they are written.
pub(crate) const TEMPLATES: [&[Template]; 3] = [
    moved::Moved::TEMPLATES,
    shown::Shown::TEMPLATES,
    tables::Tables::TEMPLATES,
];
