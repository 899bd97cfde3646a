//! Texts of the project file as sentences, and tables without empty columns.

use crate::document::{Cell, Column, Table};
use dolmen_project::Names;
use dolmen_words::message::Both;
use dolmen_words::{Sentence, messages};

messages! {
    /// Texts of the project file.
    pub(crate) enum Given in "engineer" {
        Text(text: Both) => { en: "{text}", ko: "{text}" },
        Fingerprint(print: String) => {
            en: "Fingerprint of the project file (FNV-1a, 128 bits): {print}",
            ko: "프로젝트 파일의 식별값(FNV-1a, 128비트): {print}",
        },
        FileRead { name: String, bytes: String, print: String } => {
            en: "File {name}, {bytes} bytes: {print}",
            ko: "파일 {name}, {bytes} 바이트: {print}",
        },
        FilesRead { count: usize, print: String } => {
            en: "{count} files that it names, together: {print}",
            ko: "프로젝트 파일에 기재된 파일 {count}개 전체: {print}",
        },
    }
}

/// A text in both languages; a missing language takes the other's text.
pub(super) fn both(names: &Names) -> Both {
    Both::of(|language| language.pick(names.english(), names.korean()))
}

/// A text of the file.
pub(super) fn said(names: &Names) -> Sentence {
    Given::Text(both(names)).into()
}

/// Words that are the same in both languages.
pub(super) fn verbatim(text: &str) -> Sentence {
    Given::Text(Both::of(|_| text)).into()
}

/// Text of the file, or an empty cell.
pub(super) fn cell(names: Option<&Names>) -> Cell {
    names.map_or_else(|| Cell::words(verbatim("")), |names| Cell::words(said(names)))
}

/// The same for a text in one language.
pub(super) fn text_cell(text: Option<&str>) -> Cell {
    Cell::words(verbatim(text.unwrap_or_default()))
}

/// A table of the non-empty columns, each with its cells.
pub(super) fn table_of(caption: impl Into<Sentence>, columns: Vec<(Column, Vec<Cell>)>) -> Table {
    let is_empty = |cell: &Cell| match cell {
        Cell::Words(words) => words.english.iter().all(|run| run.text().is_empty()),
        Cell::Number(number) => number.is_none(),
        _ => false,
    };
    let shown = columns
        .into_iter()
        .filter(|(_, cells)| !cells.iter().all(is_empty));
    let (columns, cells): (Vec<Column>, Vec<Vec<Cell>>) = shown.unzip();
    let count = cells.first().map_or(0, Vec::len);
    let row = |number: usize| {
        cells
            .iter()
            .filter_map(|column| column.get(number).cloned())
            .collect()
    };
    Table {
        caption: vec![caption.into()],
        rows: (0..count).map(row).collect(),
        columns,
    }
}
