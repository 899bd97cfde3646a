//! A table with its context, and words for its cells.

use super::words::Workbook;
use crate::document::{Cell, Table};
use dolmen_words::message::Both;
use dolmen_words::{Language, Sentence};

/// A table, the heading above it, and the warnings of its section.
pub(crate) struct Headed {
    pub(crate) head: Sentence,
    pub(crate) warnings: Vec<Sentence>,
    pub(crate) table: Table,
}

impl Headed {
    /// The caption of the table in one line.
    pub(super) fn caption_text(&self, language: Language) -> String {
        let each: Vec<String> = self.table.caption.iter().map(|one| one.text(language)).collect();
        each.join(" ")
    }
}

/// Words that are the same in both languages.
pub(super) fn verbatim(text: &str) -> Cell {
    Cell::words(Workbook::Verbatim(Both::of(|_| text)))
}
