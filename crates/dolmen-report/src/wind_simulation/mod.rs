//! Histories of a building in the wind: its motion, compared with the mean square.

mod said;
mod shown;

pub use shown::wind_simulation_text;

use dolmen_words::Template;

/// Templates of the sentences on histories of the wind.
pub(crate) const TEMPLATES: [&[Template]; 2] = [said::Blew::TEMPLATES, shown::Histories::TEMPLATES];
