//! Projects, outputs and journals on the file system.
//!
//! This crate opens all files of users, except a store of surveys. It limits the size of what it reads, and writes each file completely or
//! not at all. It never replaces measured data, and replaces files that Dolmen did not write only if forced.

mod access;
mod arriving;
mod files;
mod open;
mod outputs;
mod portfolio;
mod study_folder;
mod wrong;

pub use access::Access;
pub use arriving::{Inbox, InboxLook, Look, move_into, quarantine, quarantined};
pub use files::{fill_fresh, free_folder, fresh_folder, read, read_text, rewrite, start, write};
pub use open::{Folder, Found, motions_in};
pub use outputs::Outputs;
pub use portfolio::{ProjectsBelow, portfolio};
pub use study_folder::{JournalFile, StudyFolder, journals_beside, shard};
pub use wrong::{ERRORS, PathError, of_folders};
