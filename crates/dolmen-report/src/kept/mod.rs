//! Answers on a store of surveys.

mod done;
mod fault;
mod formats;
mod list;
mod moment;
mod show;

pub use done::{added_text, exported_text, imported_text, marked_text, verified_text};
pub use fault::store_fault;
pub use formats::{ListFormat, Listing};
pub use list::{StructureList, SurveyList};
pub use show::structure_text;

use dolmen_words::Template;

/// The sentences on stores as they are written.
pub(crate) const TEMPLATES: [&[Template]; 4] = [
    fault::Faults::TEMPLATES,
    list::Listed::TEMPLATES,
    show::Shown::TEMPLATES,
    done::Done::TEMPLATES,
];
