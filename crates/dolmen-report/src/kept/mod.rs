//! Answers on a store of surveys.

mod done;
mod fault;
mod follow;
mod formats;
mod inventory;
mod list;
mod moment;
mod show;

pub use done::{added_text, exported_text, imported_text, marked_text, verified_text};
pub use fault::store_fault;
pub use follow::{
    JudgedRecord, followed_json, followed_text, metrics_text, quarantined_json, quarantined_text,
};
pub use formats::{ListFormat, Listing};
pub use inventory::{inventory_csv, inventory_json, inventory_text};
pub use list::{StructureList, SurveyList};
pub use show::structure_text;

use dolmen_words::Template;

/// Templates of the sentences on stores.
pub(crate) const TEMPLATES: [&[Template]; 6] = [
    fault::Faults::TEMPLATES,
    list::Listed::TEMPLATES,
    inventory::Watched::TEMPLATES,
    follow::Followed::TEMPLATES,
    show::Shown::TEMPLATES,
    done::Done::TEMPLATES,
];
