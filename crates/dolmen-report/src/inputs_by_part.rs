//! Inputs of an appendix, one row per stone, link or storey.

use crate::document::{Cell, Column, Table};
use crate::html::words::{evidence_word, part_and_quantity, set};
use dolmen_project::{Project, Quantity as Input};
use dolmen_words::message::Both;
use dolmen_words::{Language, messages};
use std::collections::BTreeSet;

/// Number of parts from which rows are better than one line for every number. Our choice.
const PARTS_LEAST: usize = 2;
/// Number of quantities that fit side by side on a page. Our choice.
const QUANTITIES_MOST: usize = 8;

messages! {
    /// The table of parts.
    pub(crate) enum ByPart in "given.parts" {
        Caption { source: Both } => {
            en: "What the project file gives of each part, as it is written. Source of all these numbers: {source}.",
            ko: "부재별 입력값(입력한 그대로). 출처는 모두 {source}이다.",
        },
        OfJoints { source: Both } => {
            en: "What the project file gives of each joint, as it is written. Source of all these numbers: {source}.",
            ko: "접합면별 입력값(입력한 그대로). 출처는 모두 {source}이다.",
        },
        Joint => { en: "Joint", ko: "접합면" },
        Part => { en: "Part", ko: "부재" },
        Text { text: Both } => { en: "{text}", ko: "{text}" },
    }
}

/// An input of a part: the part's path, its name, and the value.
struct OfPart<'a> {
    part: &'a str,
    group: &'a str,
    name: Both,
    quantity: Both,
    input: &'a Input,
}

fn of_part<'a>(project: &Project, input: &'a Input) -> Option<OfPart<'a>> {
    if input.cov.is_some() || input.note.is_some() {
        return None;
    }
    let (part, _) = input.path.split_once("].")?;
    let (group, number) = part.split_once('[')?;
    if group.contains('.') || number.parse::<usize>().is_err() {
        return None;
    }
    let words = |language| part_and_quantity(project, &input.path, language);
    let [(name, quantity), (name_ko, quantity_ko)] = [words(Language::English)?, words(Language::Korean)?];
    let both = |english: String, korean: String| Both { english, korean };
    Some(OfPart {
        part,
        group,
        name: both(name, name_ko),
        quantity: both(quantity, quantity_ko),
        input,
    })
}

/// A table per group of parts, and the remaining inputs.
pub(crate) fn by_part<'a>(project: &Project, inputs: &[&'a Input]) -> (Vec<Table>, Vec<&'a Input>) {
    let known: Vec<OfPart<'a>> = inputs
        .iter()
        .filter_map(|input| of_part(project, input))
        .collect();
    let mut groups: Vec<&str> = known.iter().map(|of| of.group).collect();
    groups.dedup();
    let mut tabled: BTreeSet<&str> = BTreeSet::new();
    let mut tables = Vec::new();
    for group in groups {
        let Some(source) = known
            .iter()
            .find(|of| of.group == group)
            .map(|of| of.input.source)
        else {
            continue;
        };
        let own: Vec<&OfPart<'a>> = known
            .iter()
            .filter(|of| {
                of.group == group && of.input.source == source && !tabled.contains(of.input.path.as_str())
            })
            .collect();
        if let Some((table, shown)) = table(&own) {
            tabled.extend(shown);
            tables.push(table);
        }
    }
    let rest = inputs
        .iter()
        .copied()
        .filter(|input| !tabled.contains(input.path.as_str()));
    (tables, rest.collect())
}

/// Parts by quantities, with the paths of the table's inputs; `None` if parts are few or have nothing in common.
fn table<'a>(own: &[&OfPart<'a>]) -> Option<(Table, Vec<&'a str>)> {
    let mut parts: Vec<&OfPart<'a>> = Vec::new();
    let mut quantities: Vec<(&Both, usize)> = Vec::new();
    for of in own {
        if parts.iter().all(|part| part.part != of.part) {
            parts.push(of);
        }
        match quantities.iter_mut().find(|(known, _)| **known == of.quantity) {
            Some((_, count)) => *count += 1,
            None => quantities.push((&of.quantity, 1)),
        }
    }
    quantities.retain(|(_, count)| *count > 1);
    quantities.truncate(QUANTITIES_MOST);
    if parts.len() < PARTS_LEAST || quantities.is_empty() {
        return None;
    }
    let said = |text: &Both| ByPart::Text { text: text.clone() };
    let mut shown = Vec::new();
    let mut rows = Vec::new();
    for part in parts {
        let mut row = vec![Cell::words(said(&part.name))];
        for (quantity, _) in &quantities {
            let found = own
                .iter()
                .find(|of| of.part == part.part && of.quantity == **quantity);
            shown.extend(found.map(|of| of.input.path.as_str()));
            let text = found.map_or_else(|| "–".to_owned(), |of| set(&of.input.written));
            row.push(Cell::words(said(&Both::from(text))));
        }
        // a part whose inputs are all elsewhere has no row
        if row.iter().skip(1).any(|cell| cell.text(Language::English) != "–") {
            rows.push(row);
        }
    }
    let first = own.first()?;
    let (source, are_joints) = (first.input.source, first.group == "joints");
    let mut columns = vec![Column::words(match are_joints {
        true => ByPart::Joint,
        false => ByPart::Part,
    })];
    columns.extend(
        quantities
            .iter()
            .map(|(quantity, _)| Column::words(said(quantity))),
    );
    let source = Both::of(|language| evidence_word(source, language));
    let caption = match are_joints {
        true => ByPart::OfJoints { source },
        false => ByPart::Caption { source },
    };
    let table = Table {
        caption: vec![caption.into()],
        columns,
        rows,
    };
    Some((table, shown))
}
