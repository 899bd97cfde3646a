//! Projects, outputs and journals in folders of a file system, for the command and whatever else runs on one.
//!
//! It opens all files of users (a store of surveys opens its own). What it reads has a limit of size; what it writes is whole or not there; it replaces nothing that
//! was measured and, unless it is forced to, nothing that Dolmen did not write.

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
