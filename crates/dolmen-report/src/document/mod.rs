//! The content of a report as blocks without language or format. Sections create them, one folder per kind; renderers show them.

mod blocks;
mod finding;
mod formula;
mod html;
mod numbers;
mod photos;
mod series;
mod table_series;
mod text;
mod text_table;
mod words;

pub(crate) use blocks::{Block, Cell, Column, Document, Figure, Table};
pub(crate) use finding::{Finding, Role, Tone};
pub(crate) use formula::{Equation, Math, linear};
pub(crate) use html::{block_html, document_html, findings_html, numbered};
pub(crate) use numbers::{Label, Numbers, figure_label, table_label};
pub(crate) use photos::{Answered, Photo, Signatory};
pub(crate) use series::{Entries, Series, csv_row, series_csv};
pub(crate) use table_series::table_series;
pub use text::TextStyle;
pub(crate) use text::{block_text, document_text, findings_text, heading_text, joined, wrapped};
pub(crate) use words::Framed;
