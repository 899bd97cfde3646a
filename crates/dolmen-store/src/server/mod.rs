//! PostgreSQL: one database of a server, for several machines and people; raw files are rows of it.

mod address;
mod columns;
mod dialect;
mod fault;
mod link;
mod pieces;
mod session;

pub(crate) use address::Address;
pub(crate) use pieces::Pieces;
pub(crate) use session::Session;
