//! **Dolmen**: whether stacked-stone and timber heritage stands, how it moves, and what shaking it survives.
//!
//! Each chapter hands on one type and knows only the chapters before it:
//!
//! ```text
//! signal::Record → modal::Modes → structure::{Chain, Frame, stack::Stack} → stability → blocks → assess
//! ```
//!
//! Everything here is a pure function of its arguments, in SI units: no file, clock, print or log; the
//! crates above it turn bytes into these values and answers into pages; the command `dolmen` opens the files.

pub mod assess;
pub mod blocks;
pub mod comparisons;
pub mod damper;
pub mod dynamics;
pub mod known;
pub mod modal;
pub mod monitoring;
pub mod numeric;
pub mod signal;
pub mod stability;
pub mod structure;
