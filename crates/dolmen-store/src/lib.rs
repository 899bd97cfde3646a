//! Surveys over years in one place: structures with their projects, records, modes and what was done, in a file of SQLite with the raw
//! files beside it.
//!
//! ```text
//! Place ─→ Store ─→ keep (a file) · add (a project) · structures, surveys, structure · export · import · verify · mark
//! ```
//!
//! The key of every row is its content or a name that people gave, and no row ever changes: what is new is another row, what is taken
//! out of use is marked. Names and files of strangers are values of parameters and never part of a statement; a file in the folder
//! takes its name from the hash of its bytes alone.

mod arrival;
mod copy;
mod database;
mod earthquake_rows;
mod error;
mod find;
mod incoming;
mod inspection_rows;
mod observed;
mod place;
mod raw;
mod raw_folder;
mod rows;
mod schema;
mod schema_files;
#[cfg(feature = "postgres")]
mod server;
mod sqlite;
mod store;
mod stored_files;
mod verify;

pub use arrival::{Arrived, Arriving, Keeper};
pub use error::StoreError;
pub use find::{Exported, Search};
pub use incoming::{Incoming, PROJECT_FILE};
pub use place::Place;
pub use raw::{Kept, hash_of_bytes};
pub use store::{Act, Store};
pub use stored_files::StoredFiles;
