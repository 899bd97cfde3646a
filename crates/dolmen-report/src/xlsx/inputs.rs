//! Inputs as tables.

use super::headed::{Headed, verbatim};
use super::words::Workbook;
use crate::check::{title, version};
use crate::document::{Cell, Column, Table};
use crate::html::words::{evidence_word, input_words, set, unit_text};
use crate::other_inputs::{other_inputs, other_inputs_of};
use crate::surveys_given::{Given, surveys_table};
use dolmen_project::{Project, Quantity as Input};
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Sentence, Unit};
use dolmen_work::answer::ProjectReport;

/// Digits of a value from the project file.
const DIGITS: usize = 6;

/// The inputs, then the different ones of each variant, then the surveys.
pub(crate) fn inputs_tables(answer: &ProjectReport, own: &[&Input]) -> Vec<Headed> {
    let headed = |caption: Sentence, project: &Project, inputs: &[&Input]| Headed {
        head: Workbook::Inputs {}.into(),
        warnings: Vec::new(),
        table: inputs_table(caption, project, inputs),
    };
    let others = |table: Table| Headed {
        head: Workbook::Inputs {}.into(),
        warnings: Vec::new(),
        table,
    };
    let mut all = vec![headed(Workbook::InputsCaption {}.into(), &answer.project, own)];
    all.extend(other_inputs(answer).map(others));
    for variant in answer.variants() {
        let inputs: Vec<&Input> = variant.own_inputs.iter().collect();
        let own = version(&answer.project, variant);
        let mut of = headed(Workbook::InputsOf(title(variant)).into(), own, &inputs);
        beside_given(&mut of.table, &inputs, &answer.project.structure_inputs());
        all.push(of);
        all.extend(other_inputs_of(answer, variant).map(others));
    }
    all.extend(
        surveys_table(&answer.project, answer.surveys()).map(|table| Headed {
            head: Given::Surveys.into(),
            warnings: Vec::new(),
            table: table.without_empty_columns(),
        }),
    );
    all.retain(|headed| !headed.table.rows.is_empty());
    all
}

/// Adds a column before the inputs of a variant, with their values in the structure as it is.
fn beside_given(table: &mut Table, inputs: &[&Input], given: &[&Input]) {
    const BEFORE: usize = 2;
    table.columns.insert(BEFORE, Column::words(Workbook::AsItIs {}));
    for (row, input) in table.rows.iter_mut().zip(inputs) {
        let own = given.iter().find(|own| own.path == input.path);
        row.insert(
            BEFORE,
            verbatim(&own.map_or_else(String::new, |own| set(&own.written))),
        );
    }
}

fn inputs_table(caption: Sentence, project: &Project, inputs: &[&Input]) -> Table {
    Table {
        caption: vec![caption],
        columns: vec![
            Column::words(Workbook::Input {}),
            Column::words(Workbook::Source {}),
            Column::words(Workbook::AsWritten {}),
            Column::words(Workbook::Unit {}),
            Column::numbers(Workbook::Value {}, Unit::ratio()),
            Column::numbers(Workbook::Scatter {}, Unit::percent()),
            Column::words(Workbook::Note {}),
        ],
        rows: inputs.iter().map(|input| row(project, input)).collect(),
    }
}

fn row(project: &Project, input: &Input) -> Vec<Cell> {
    let both = |text: Both| Cell::words(Workbook::Verbatim(text));
    vec![
        both(Both::of(|language| input_words(project, &input.path, language))),
        both(Both::of(|language| evidence_word(input.source, language))),
        verbatim(&set(&input.written)),
        verbatim(&unit_text(input.unit)),
        Cell::number(Quantity::new(input.value, Unit::ratio(), Digits::Trimmed(DIGITS))),
        Cell::Number(input.cov.map(|cov| Quantity::percent(cov, 2))),
        verbatim(input.note.as_deref().unwrap_or_default()),
    ]
}
