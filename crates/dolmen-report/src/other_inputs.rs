//! Values of the file besides its quantities: counts, choices, switches, limits, names of codes.

use crate::check::title;
use crate::document::{Cell, Column, Table};
use crate::html::words::set;
use dolmen_project::{Leaf, Project, Structure, WindPart, meaning_of};
use dolmen_words::message::Both;
use dolmen_words::{Digits, Language, Quantity, Sentence, Unit, messages, printed_name};
use dolmen_work::answer::ProjectReport;
use dolmen_work::state::VariantAnswer;
use std::collections::BTreeSet;

/// Rows of the same key in several parts; more become one row. Our choice.
const ROWS_MOST: usize = 6;
/// Longest list that a cell shows, and longest meaning of a key, in characters. Our choice.
const LIST_MOST: usize = 48;
const MEANING_MOST: usize = 110;

messages! {
    /// The table of other values.
    pub(crate) enum OtherInputs in "given.others" {
        Caption => {
            en: "Other entries of the project file on which the results rest, as written: counts, choices, limits. The key is that of the file.",
            ko: "결과의 바탕이 되는 프로젝트 파일의 그 밖의 입력(개수, 선택, 한계 등)을 기재된 그대로 보인다. 키는 파일의 것이다.",
        },
        OfVariant { variant: Both } => {
            en: "Entries of the project file that the variant “{variant}” changes, as written.",
            ko: "대안 ‘{variant}’에서 달라지는 프로젝트 파일의 항목(기재된 그대로).",
        },
        Key => { en: "Key", ko: "키" },
        Value => { en: "Value", ko: "값" },
        AsItIs => { en: "As it is", ko: "현 상태" },
        InVariant => { en: "Variant", ko: "대안" },
        Meaning => { en: "Meaning", ko: "뜻" },
        Default { value: Quantity } => { en: "{value} (default)", ko: "{value}(기본값)" },
        Values { count: usize } => { en: "{count} values", ko: "값 {count}개" },
        Text { text: Both } => { en: "{text}", ko: "{text}" },
    }
}

/// A value in the table.
#[derive(Clone, PartialEq)]
enum Shown {
    /// As the file writes it.
    Written(String),
    /// What Dolmen takes, because the file gives nothing.
    Default { value: f64, unit: &'static str },
    /// So many values.
    Values(usize),
    /// The file has no such key.
    Nothing,
}

/// An entry: its key, the part that it belongs to, and its value in each column.
struct Entry {
    path: String,
    part: Option<String>,
    shown: Vec<Shown>,
}

/// The values of the file that no table of quantities has; `None` without any.
pub(crate) fn other_inputs(answer: &ProjectReport) -> Option<Table> {
    let studied: Vec<&str> = answer.studies().iter().map(|of| of.study.name.as_str()).collect();
    let mut own = entries(&answer.project);
    own.retain(|entry| match entry.path.strip_prefix("study.") {
        Some(rest) => studied.iter().any(|name| is_within(rest, name)),
        None => true,
    });
    table(OtherInputs::Caption.into(), &[OtherInputs::Value], own)
}

/// The same that a variant changes, beside the structure as it is; `None` where it changes nothing but quantities.
pub(crate) fn other_inputs_of(answer: &ProjectReport, variant: &VariantAnswer) -> Option<Table> {
    let project = &answer.project;
    let of = project.variants.iter().find(|own| own.name == variant.name)?;
    let changed = changed(project, &of.project);
    let variant = title(variant);
    table(
        OtherInputs::OfVariant { variant }.into(),
        &[OtherInputs::AsItIs, OtherInputs::InVariant],
        changed,
    )
}

/// Whether a path is a key or lies below it.
fn is_within(path: &str, key: &str) -> bool {
    let rest = path.strip_prefix(key);
    rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
}

/// Whether quantities have the value at a path, or parts of it.
fn is_covered(path: &str, inputs: &BTreeSet<&str>) -> bool {
    let below = inputs.range(path..).take_while(|input| input.starts_with(path));
    let mut above = path.match_indices(['.', '[']).map(|(end, _)| &path[..end]);
    below.into_iter().any(|input| is_within(input, path)) || above.any(|above| inputs.contains(above))
}

fn entries(project: &Project) -> Vec<Entry> {
    let inputs = project.structure_inputs();
    let covered: BTreeSet<&str> = inputs.iter().map(|input| input.path.as_str()).collect();
    let leaves = project.leaves.iter();
    let mut all: Vec<Entry> = leaves
        .filter(|leaf| !is_covered(&leaf.path, &covered))
        .map(|leaf| Entry {
            path: leaf.path.clone(),
            part: leaf.part.clone(),
            shown: vec![shown(leaf)],
        })
        .collect();
    all.extend(defaults(project));
    all
}

fn shown(leaf: &Leaf) -> Shown {
    match leaf.values {
        Some(count) if leaf.written.chars().count() > LIST_MOST => Shown::Values(count),
        _ => Shown::Written(set(&leaf.written)),
    }
}

/// What Dolmen takes for gravity and for the density of air where the file gives none.
fn defaults(project: &Project) -> Vec<Entry> {
    let is_given = |path: &str| project.leaves.iter().any(|leaf| is_within(&leaf.path, path));
    let mut all = Vec::new();
    if !matches!(project.structure, Structure::Survey) {
        all.push(("gravity", project.gravity_m_s2, "m/s²"));
    }
    if let WindPart::Given(wind) = &project.loads.wind {
        all.push(("wind.density", wind.air_density_kg_m3, "kg/m³"));
    }
    all.retain(|(path, ..)| !is_given(path));
    let each = all.into_iter().map(|(path, value, unit)| Entry {
        path: path.to_owned(),
        part: None,
        shown: vec![Shown::Default { value, unit }],
    });
    each.collect()
}

/// Entries that differ, with the value as it is and that of the variant; quantities that the variant leaves out too.
fn changed(project: &Project, variant: &Project) -> Vec<Entry> {
    let (before, after) = (entries(project), entries(variant));
    let value = |all: &[Entry], path: &str| {
        let found = all.iter().find(|entry| entry.path == path);
        found.map_or(vec![Shown::Nothing], |entry| entry.shown.clone())
    };
    let mut all = Vec::new();
    for entry in &after {
        let old = value(&before, &entry.path);
        if old != entry.shown {
            all.push((entry.path.clone(), entry.part.clone(), [old, entry.shown.clone()]));
        }
    }
    let own = variant.structure_inputs();
    let is_left = |path: &str| own.iter().any(|input| input.path == path);
    // studies belong to the file as a whole
    let gone = before.iter().filter(|entry| {
        !is_within(&entry.path, "study")
            && !after.iter().any(|of| of.path == entry.path)
            && !is_left(&entry.path)
    });
    all.extend(gone.map(|entry| {
        let values = [entry.shown.clone(), vec![Shown::Nothing]];
        (entry.path.clone(), entry.part.clone(), values)
    }));
    let given = project.structure_inputs();
    let gone = given.iter().filter(|input| {
        !is_left(&input.path) && !after.iter().any(|entry| is_within(&input.path, &entry.path))
    });
    all.extend(gone.map(|input| {
        let values = [vec![Shown::Written(set(&input.written))], vec![Shown::Nothing]];
        (input.path.clone(), None, values)
    }));
    let each = all.into_iter().map(|(path, part, values)| Entry {
        path,
        part,
        shown: values.concat(),
    });
    each.collect()
}

fn table(caption: Sentence, columns: &[OtherInputs], entries: Vec<Entry>) -> Option<Table> {
    if entries.is_empty() {
        return None;
    }
    let mut heads = vec![OtherInputs::Key];
    heads.extend(columns.iter().cloned());
    heads.push(OtherInputs::Meaning);
    let table = Table {
        caption: vec![caption],
        columns: heads.into_iter().map(Column::words).collect(),
        rows: together(entries).iter().map(row).collect(),
    };
    Some(table.without_empty_columns())
}

/// The key without the numbers of parts: `blocks[].shape`.
fn of_all(path: &str) -> String {
    let each = path.split('[').map(|piece| match piece.split_once(']') {
        Some((_, rest)) => rest,
        None => piece,
    });
    each.collect::<Vec<_>>().join("[]")
}

/// Entries of the same key in neighbouring parts with the same values as one; one row for all where too many remain.
fn together(entries: Vec<Entry>) -> Vec<Entry> {
    let mut groups: Vec<(String, Vec<Entry>)> = Vec::new();
    for entry in entries {
        let key = of_all(&entry.path);
        match groups.iter_mut().find(|(known, _)| *known == key) {
            Some((_, all)) => all.push(entry),
            None => groups.push((key, vec![entry])),
        }
    }
    let mut rows = Vec::new();
    for (key, all) in groups {
        let count = all.len();
        let runs = runs(all);
        match runs.first() {
            Some(first) if runs.len() > ROWS_MOST => rows.push(Entry {
                path: key,
                part: None,
                shown: vec![Shown::Values(count); first.shown.len()],
            }),
            _ => rows.extend(runs),
        }
    }
    rows
}

/// Neighbours of equal values as one entry: `floors[1–4].count`.
fn runs(all: Vec<Entry>) -> Vec<Entry> {
    let mut runs: Vec<(Entry, String)> = Vec::new();
    for entry in all {
        match runs.last_mut() {
            Some((first, last)) if first.shown == entry.shown => last.clone_from(&entry.path),
            _ => {
                let path = entry.path.clone();
                runs.push((entry, path));
            }
        }
    }
    let each = runs.into_iter().map(|(first, last)| match first.path == last {
        true => first,
        false => Entry {
            path: from_to(&first.path, &last),
            part: None,
            ..first
        },
    });
    each.collect()
}

/// `blocks[1].shape` and `blocks[4].shape` as `blocks[1–4].shape`.
fn from_to(first: &str, last: &str) -> String {
    let numbers = |path: &str| -> Vec<String> {
        let each = path.split('[').skip(1);
        each.map(|piece| piece.split(']').next().unwrap_or_default().to_owned())
            .collect()
    };
    let (from, to) = (numbers(first), numbers(last));
    let mut ranges = from.iter().zip(&to).map(|(from, to)| match from == to {
        true => format!("[{from}]"),
        false => format!("[{from}–{to}]"),
    });
    let mut said = String::new();
    for (at, piece) in of_all(first).split("[]").enumerate() {
        if at > 0 {
            said += &ranges.next().unwrap_or_default();
        }
        said += piece;
    }
    said
}

fn row(entry: &Entry) -> Vec<Cell> {
    let text = |text: Both| Cell::words(OtherInputs::Text { text });
    let mut cells = vec![text(Both::of(|_| entry.path.clone()))];
    cells.extend(entry.shown.iter().map(cell));
    cells.push(text(Both::of(|language| meaning(entry, language))));
    cells
}

fn cell(shown: &Shown) -> Cell {
    match shown {
        Shown::Written(written) => Cell::words(OtherInputs::Text {
            text: Both::of(|_| written.clone()),
        }),
        Shown::Default { value, unit } => Cell::words(OtherInputs::Default {
            value: Quantity::new(*value, Unit::si(unit), Digits::Trimmed(6)),
        }),
        Shown::Values(count) => Cell::words(OtherInputs::Values { count: *count }),
        Shown::Nothing => Cell::words(OtherInputs::Text {
            text: Both::of(|_| "–"),
        }),
    }
}

/// The part and what the schema says of the key, if it is short.
fn meaning(entry: &Entry, language: Language) -> String {
    let said = meaning_of(&entry.path.replace("[]", "[1]")).and_then(|said| short(&said));
    let said = said.map(|said| said.text(language).to_owned());
    let part = entry.part.as_deref();
    let part = part.map(|part| printed_name(part, language).into_owned());
    match (part, said) {
        (Some(part), Some(said)) => format!("{part}: {said}"),
        (Some(one), None) | (None, Some(one)) => one,
        (None, None) => String::new(),
    }
}

/// A description without the kind of structure: whole, or its first sentence or clause, in both languages alike; `None` if that is long or
/// speaks of a command.
fn short(said: &Both) -> Option<Both> {
    let cuts = [Language::English, Language::Korean].map(|language| cuts(said.text(language)));
    let [english, korean] = cuts;
    let is_short =
        |text: &str| !text.is_empty() && text.chars().count() <= MEANING_MOST && !text.contains('`');
    let mut both = english.into_iter().zip(korean);
    let (english, korean) = both.find(|(english, korean)| is_short(english) && is_short(korean))?;
    Some(Both { english, korean })
}

/// A description, its first sentence, and its first clause.
fn cuts(said: &str) -> [String; 3] {
    let said = said.split_whitespace().collect::<Vec<_>>().join(" ");
    let own = match said.starts_with("kind = ") {
        true => said.split_once(": ").map_or("", |(_, own)| own),
        false => said.as_str(),
    };
    let first = |end: &str| own.split(end).next().unwrap_or(own).to_owned();
    let sentence = first(". ");
    let clause = sentence.split("; ").next().unwrap_or(&sentence).to_owned();
    [own.trim_end_matches('.').to_owned(), sentence, clause]
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen_project::parse_project;

    const TOWER: &str = "schema = 1\nkind = \"building\"\nname = \"T\"\nevidence = \"assumed\"\n\
        units = { mass = \"t\", stiffness = \"kN/mm\" }\n\
        floors = [{ count = 18, mass = 420, sides = [26, 20], height = 3.4, stiffness = { x = 620, y = 500, rotation = \"62000000 kN*m/rad\", centre = [-2, 0] } }]\n\
        damping = { ratio = 0.015 }\n\
        wind = { speed = \"27 m/s\", means = \"10 min\", code = \"EN 1991-1-4\", terrain = \"III\", force_coefficient = 1.3, drift_limit = 0.0025 }\n\
        [variant.town]\nwind.terrain = \"IV\"\n";

    fn rows(table: &Table, language: Language) -> Vec<Vec<String>> {
        let of_row = |row: &Vec<Cell>| row.iter().map(|cell| cell.text(language)).collect();
        table.rows.iter().map(of_row).collect()
    }

    #[test]
    fn holds_every_value_of_the_file_is_among_the_quantities_or_here() {
        let project = parse_project(TOWER, "p.toml").unwrap();
        let table = table(
            OtherInputs::Caption.into(),
            &[OtherInputs::Value],
            entries(&project),
        )
        .unwrap();
        let rows = rows(&table, Language::English);
        let value = |key: &str| rows.iter().find(|row| row[0] == key).map(|row| row[1].as_str());
        for (key, written) in [
            ("floors[1].count", "18"),
            ("floors[1].sides", "[26, 20]"),
            ("wind.drift_limit", "0.0025"),
            ("wind.means", "10 min"),
            ("wind.code", "EN 1991-1-4"),
            ("wind.terrain", "III"),
            ("gravity", "9.80665\u{202f}m/s² (default)"),
            ("wind.density", "1.25\u{202f}kg/m³ (default)"),
        ] {
            assert_eq!(value(key), Some(written), "{key}: {rows:?}");
        }
        // each value once
        assert_eq!(value("floors[1].mass"), None);
        assert_eq!(value("floors[1].stiffness.x"), None);
        assert_eq!(value("wind.speed"), None);
    }

    #[test]
    fn exact_a_variant_lists_what_it_changes() {
        let project = parse_project(TOWER, "p.toml").unwrap();
        let changed = changed(&project, &project.variants[0].project);
        let columns = [OtherInputs::AsItIs, OtherInputs::InVariant];
        let table = table(OtherInputs::Caption.into(), &columns, changed).unwrap();
        let rows = rows(&table, Language::Korean);
        assert_eq!(rows.len(), 1, "{rows:?}");
        assert_eq!(rows[0][..3], ["wind.terrain", "III", "IV"]);
    }

    #[test]
    fn exact_equal_neighbours_share_a_row_and_many_values_are_counted() {
        let entry = |at: usize, value: String| Entry {
            path: format!("blocks[{at}].shape"),
            part: None,
            shown: vec![Shown::Written(value)],
        };
        let same = together((1..=9).map(|at| entry(at, "box".to_owned())).collect());
        assert_eq!(same.len(), 1);
        assert_eq!(same[0].path, "blocks[1–9].shape");
        let other = together((1..=9).map(|at| entry(at, at.to_string())).collect());
        assert_eq!(other.len(), 1);
        assert_eq!(other[0].path, "blocks[].shape");
        assert!(other[0].shown == [Shown::Values(9)]);
    }
}
