//! Errors of the verbs, in both languages.

mod asked;
mod flag;
mod list;
mod pieces;
mod store;
mod work;

pub(crate) use flag::FlagWords;
pub use list::ERRORS;
pub(crate) use list::of_work;
pub(crate) use pieces::{
    CaseRefused, DesignNeeds, FileRemark, JournalDiffers, KnownNames, NoPlace, NotHeld, OfRuns, Place,
    RowLacks, RowNeeds, RunEnded,
};
