//! PostgreSQL: one database of a server, for several machines and people; raw files are stored in its rows.

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
