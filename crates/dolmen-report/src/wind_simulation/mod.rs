//! What an answer says of a building in histories of the wind: how it moved, beside the mean square.

mod said;
mod shown;

pub use shown::wind_simulation_text;

use dolmen_words::Template;

/// The sentences on histories of the wind as they are written.
pub(crate) const TEMPLATES: [&[Template]; 2] = [said::Blew::TEMPLATES, shown::Histories::TEMPLATES];
