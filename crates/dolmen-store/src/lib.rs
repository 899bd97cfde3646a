//! Surveys over years in one place: structures with their projects, records, modes and log, in an SQLite file with the raw files next to it.
//!
//! ```text
//! Place ─→ Store ─→ keep (a file) · add (a project) · structures, surveys, structure · export · import · verify · mark
//! ```
//!
//! The key of every row is its content or a name that people gave. Rows never change: new data are new rows, and a mark takes a structure out of
//! use. Names and files from strangers are parameters, never part of a statement; the name of a file in the folder is only the hash of its
//! bytes.

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
