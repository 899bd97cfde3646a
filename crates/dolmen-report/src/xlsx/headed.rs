//! A table with what stands around it, and words for its cells.

use super::words::Workbook;
use crate::document::{Cell, Table};
use dolmen_words::message::Both;
use dolmen_words::{Language, Sentence};

/// A table, the head under which it stands, and what its section warns of before it.
pub(crate) struct Headed {
    pub(crate) head: Sentence,
    pub(crate) warnings: Vec<Sentence>,
    pub(crate) table: Table,
}

impl Headed {
    /// What the table shows, in one line.
    pub(super) fn caption_text(&self, language: Language) -> String {
        let each: Vec<String> = self.table.caption.iter().map(|one| one.text(language)).collect();
        each.join(" ")
    }
}

/// Words that are the same in both languages.
pub(super) fn verbatim(text: &str) -> Cell {
    Cell::words(Workbook::Verbatim {
        text: Both::of(|_| text),
    })
}
