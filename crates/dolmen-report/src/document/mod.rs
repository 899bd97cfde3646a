//! What a report says, as blocks that know neither language nor format. Sections make them, one folder a kind; renderers show them.

mod blocks;
mod finding;
mod html;

pub(crate) use blocks::{Block, Cell, Column, Document, Figure, Table};
pub(crate) use finding::{Finding, Tone};
pub(crate) use html::document_html;
