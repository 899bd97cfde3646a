//! Errors of files, in both languages, one file for each chapter.

mod damage;
mod file;
mod list;
mod mesh;
mod mesh_place;
mod more;
mod motion;
mod pieces;
mod record;
mod remark;
mod seismic;
mod sheet;
mod station;
mod unread;

pub(crate) use damage::Damage;
pub use list::{ERRORS, of_records};
pub(crate) use mesh_place::OfMesh;
pub(crate) use more::and_more;
pub(crate) use pieces::DiffersFromATable;
pub(crate) use remark::Remark;
pub(crate) use station::{OfStation, Turned};
pub(crate) use unread::{Expected, Unread};
