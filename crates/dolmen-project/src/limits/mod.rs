//! Limits of a structure: `[limits]`, with the allowable drift of its storeys.

mod file;
mod read;

pub(crate) use file::LimitsRaw;
pub(crate) use read::limits;
