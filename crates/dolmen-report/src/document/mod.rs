//! What a report says, as blocks that know neither language nor format. Sections make them, one folder a kind; renderers show them.

mod blocks;
mod finding;
mod html;
mod text;
mod text_table;

pub(crate) use blocks::{Block, Cell, Column, Document, Figure, Table};
pub(crate) use finding::{Finding, Tone};
pub(crate) use html::{document_html, findings_html};
pub use text::TextStyle;
pub(crate) use text::{document_text, findings_text, heading_text, wrapped};
