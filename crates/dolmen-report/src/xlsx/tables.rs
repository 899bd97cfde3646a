//! The tables of a report in the order in which they are read.

use super::headed::{Headed, verbatim};
use super::inputs::inputs_tables;
use super::words::Workbook;
use crate::document::{Block, Cell, Column, Table};
use crate::whole::whole_document;
use dolmen_words::{Sentence, Unit};
use dolmen_work::answer::ProjectReport;

/// Those of inputs, then those of the document.
pub(super) fn tables(answer: &ProjectReport) -> Vec<Headed> {
    let mut all = inputs_tables(answer);
    let mut head: Sentence = Workbook::Summary {}.into();
    let mut warnings = Vec::new();
    for block in whole_document(answer).blocks {
        let table = match block {
            Block::Heading(of) => {
                (head, warnings) = (of, Vec::new());
                continue;
            }
            Block::Subheading(of) => {
                head = of;
                continue;
            }
            Block::Warning(of) => {
                warnings.push(of);
                continue;
            }
            Block::Table(table) => table,
            Block::KeyValues(rows) => key_values(&head, rows),
            Block::Paragraph(_) | Block::Note(_) | Block::List(_) | Block::Figures(_) => continue,
        };
        all.push(Headed {
            head: head.clone(),
            warnings: warnings.clone(),
            table,
        });
    }
    all
}

/// What is said of each of a few things: each number with the unit beside it.
fn key_values(head: &Sentence, rows: Vec<(Sentence, Cell)>) -> Table {
    let row = |(key, cell): (Sentence, Cell)| {
        let unit = match &cell {
            Cell::Number(Some(quantity)) | Cell::Bad(quantity) | Cell::Rises(quantity) => {
                quantity.unit.symbol.clone()
            }
            Cell::Number(None) | Cell::Words(_) | Cell::BadWords(_) => String::new(),
        };
        vec![Cell::Words(key), verbatim(&unit), cell]
    };
    Table {
        caption: vec![head.clone()],
        columns: vec![
            Column::words(Workbook::Quantity {}),
            Column::words(Workbook::Unit {}),
            Column::numbers(Workbook::Value {}, Unit::ratio()),
        ],
        rows: rows.into_iter().map(row).collect(),
    }
}
