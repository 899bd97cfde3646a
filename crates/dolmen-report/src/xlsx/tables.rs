//! The tables of a report in reading order.

use super::headed::{Headed, verbatim};
use super::inputs::inputs_tables;
use super::words::Workbook;
use crate::check::is_of_variant;
use crate::document::{Answered, Block, Cell, Column, Framed, Photo, Signatory, Table};
use crate::engineer::front;
use crate::whole::whole_document;
use dolmen_words::message::Both;
use dolmen_words::{Sentence, Unit};
use dolmen_work::answer::ProjectReport;

/// The tables of inputs, then those of the document.
pub(super) fn tables(answer: &ProjectReport) -> Vec<Headed> {
    let mut all = inputs_tables(answer, &answer.project.inputs());
    let mut head: Sentence = Workbook::Summary {}.into();
    let front = front(answer);
    let answers = front.answers.map(|block| (Workbook::Answers {}.into(), block));
    for (head, block) in front.signatures.into_iter().chain(answers) {
        all.extend(rows_table(&head, block).map(|table| Headed {
            head,
            warnings: Vec::new(),
            table,
        }));
    }
    let mut warnings = Vec::new();
    let mut variant = None;
    for block in whole_document(answer).blocks {
        let table = match block {
            Block::Heading(of) => {
                variant = Some(of.clone()).filter(is_of_variant);
                (head, warnings) = (of, Vec::new());
                continue;
            }
            Block::Subheading(of) => {
                head = match variant.clone() {
                    Some(variant) => Workbook::PartOf { variant, part: of }.into(),
                    None => of,
                };
                continue;
            }
            Block::Warning(of) => {
                warnings.push(of);
                continue;
            }
            other => match rows_table(&head, other) {
                Some(table) => table,
                None => continue,
            },
        };
        all.push(Headed {
            head: head.clone(),
            warnings: warnings.clone(),
            table,
        });
    }
    all
}

/// A block with rows as a table; `None` for words and figures.
fn rows_table(head: &Sentence, block: Block<'_>) -> Option<Table> {
    let of = |heads: Vec<Framed>, rows: Vec<Vec<Cell>>| Table {
        caption: vec![head.clone()],
        columns: heads.into_iter().map(Column::words).collect(),
        rows,
    };
    Some(match block {
        Block::Table(table) => table,
        Block::KeyValues(rows) => key_values(head, rows),
        Block::Photos(photos) => {
            let shows = |photo: &Photo<'_>| Workbook::Verbatim(Both::of(|language| photo.text(language)));
            let cells = |photo: &Photo<'_>| vec![Cell::words(shows(photo)), verbatim(photo.file)];
            of(
                vec![Framed::Photo, Framed::File],
                photos.iter().map(cells).collect(),
            )
        }
        Block::Signatures(rows) => {
            let cells = |row: Signatory| [row.role, row.name, row.licence].map(Cell::Words).to_vec();
            let heads = vec![Framed::Role, Framed::Name, Framed::Licence];
            of(heads, rows.into_iter().map(cells).collect())
        }
        Block::Answers(answers) => {
            let cells = |answer: Answered| [answer.question, answer.word].map(Cell::Words).to_vec();
            of(
                vec![Framed::Question, Framed::Answer],
                answers.into_iter().map(cells).collect(),
            )
        }
        Block::Heading(_)
        | Block::Subheading(_)
        | Block::Paragraph(_)
        | Block::Warning(_)
        | Block::Note(_)
        | Block::List(_)
        | Block::Equation(_)
        | Block::Figures(_) => return None,
    })
}

/// A few values, each with its unit in the next cell.
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
