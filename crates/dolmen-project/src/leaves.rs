//! Every value of a file as it is written: numbers, counts, choices, switches, lists.

use super::check::Node;
use super::schema_tree::{TREE, Tree};
use super::wrong::of_schema;
use dolmen_words::message::Both;
use std::collections::BTreeSet;
use std::sync::LazyLock;
use toml::de::{DeTable, DeValue};

/// Keys of words about a value, at any depth: no answer is built from them.
const WORDS: [&str; 9] = [
    "title",
    "description",
    "name",
    "names",
    "label",
    "note",
    "source",
    "cov_source",
    "evidence",
];

/// Tables of the file that hold no value of the model.
const BESIDE_THE_MODEL: [&str; 7] = [
    "schema", "allow", "report", "survey", "surveys", "motion", "variant",
];

/// A value of the file, or a list of values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Leaf {
    /// Its path, parts counted from 1: `floors[1].count`.
    pub path: String,
    /// As the file writes it, text without its quotes.
    pub written: String,
    /// Number of values of a list; `None` for a single value.
    pub values: Option<usize>,
    /// Name of the part that it belongs to, if the file gives one.
    pub part: Option<String>,
}

/// All values of a file in its order, without words about them, surveys, motions and the report's own contents.
pub(super) fn leaves(root: &DeTable<'_>) -> Vec<Leaf> {
    let mut all = Vec::new();
    of_table(root, "", None, &mut all);
    all
}

fn of_table(table: &DeTable<'_>, path: &str, part: Option<&str>, all: &mut Vec<Leaf>) {
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(key, _)| key.span().start);
    let named = table.get("name").and_then(|name| match name.get_ref() {
        DeValue::String(name) => Some(name.as_ref()),
        _ => None,
    });
    let part = named.filter(|_| !path.is_empty()).or(part);
    for (key, node) in entries {
        let key = key.get_ref().as_ref();
        if WORDS.contains(&key) || path.is_empty() && BESIDE_THE_MODEL.contains(&key) {
            continue;
        }
        let below = match path {
            "" => key.to_owned(),
            path => format!("{path}.{key}"),
        };
        of_value(node, below, part, all);
    }
}

fn of_value(node: &Node<'_>, path: String, part: Option<&str>, all: &mut Vec<Leaf>) {
    let values = match node.get_ref() {
        DeValue::Table(table) if !table.is_empty() && !table.contains_key("value") => {
            return of_table(table, &path, part, all);
        }
        DeValue::Array(list) if list.iter().any(holds_tables) => {
            for (at, item) in list.iter().enumerate() {
                of_value(item, format!("{path}[{}]", at + 1), part, all);
            }
            return;
        }
        DeValue::Array(list) => Some(list.iter().map(count).sum()),
        _ => None,
    };
    all.push(Leaf {
        path,
        written: written(node),
        values,
        part: part.map(str::to_owned),
    });
}

fn holds_tables(node: &Node<'_>) -> bool {
    match node.get_ref() {
        DeValue::Table(_) => true,
        DeValue::Array(list) => list.iter().any(holds_tables),
        _ => false,
    }
}

fn count(node: &Node<'_>) -> usize {
    match node.get_ref() {
        DeValue::Array(list) => list.iter().map(count).sum(),
        _ => 1,
    }
}

/// A value as the file writes it. A table with a value is that value, its unit, and what else it gives.
fn written(node: &Node<'_>) -> String {
    match node.get_ref() {
        DeValue::String(text) => text.to_string(),
        DeValue::Integer(number) => number.to_string(),
        DeValue::Float(number) => number.to_string(),
        DeValue::Boolean(switch) => switch.to_string(),
        DeValue::Datetime(day) => day.to_string(),
        DeValue::Array(list) => {
            let each: Vec<String> = list.iter().map(written).collect();
            format!("[{}]", each.join(", "))
        }
        DeValue::Table(table) => {
            let mut said: Vec<String> = ["value", "unit"]
                .iter()
                .filter_map(|key| table.get(*key).map(written))
                .collect();
            let others = table.iter().filter_map(|(key, value)| {
                let key = key.get_ref().as_ref();
                let is_said = ["value", "unit"].contains(&key) || WORDS.contains(&key);
                (!is_said).then(|| format!("({key} {})", written(value)))
            });
            said.extend(others);
            match said.is_empty() {
                true => "{}".to_owned(),
                false => said.join(" "),
            }
        }
    }
}

/// What the schema says of the key at a path, in both languages; `None` for names that the user gives, and where it says nothing.
///
/// # Example
/// ```
/// let said = dolmen_project::meaning_of("wind.drift_limit").unwrap();
/// assert!(said.english.contains("largest drift"));
/// assert_eq!(dolmen_project::meaning_of("combination.storm"), None);
/// ```
pub fn meaning_of(path: &str) -> Option<Both> {
    let mut at: &'static Tree = &TREE;
    let mut said = None;
    for segment in path.split('.') {
        let name = segment.split('[').next().unwrap_or(segment);
        let choices = alternatives(at);
        let own = choices.iter().find_map(|of| of.get("properties")?.get(name));
        said = own.and_then(|of| of.get("description")?.text());
        at = own.or_else(|| choices.iter().find_map(|of| of.get("additionalProperties")))?;
        for _ in segment.matches('[') {
            at = alternatives(at).iter().find_map(|of| of.get("items"))?;
        }
    }
    said.map(of_schema)
}

/// Whether a word is a key of project files, at any depth.
pub fn is_key(word: &str) -> bool {
    static ALL: LazyLock<BTreeSet<&'static str>> = LazyLock::new(|| {
        let mut all = BTreeSet::new();
        keys(&TREE, &mut all);
        all
    });
    ALL.contains(word)
}

fn keys(tree: &'static Tree, all: &mut BTreeSet<&'static str>) {
    let properties = tree.get("properties").and_then(Tree::entries);
    all.extend(properties.into_iter().flatten().map(|(name, _)| *name));
    let entries = tree.entries().into_iter().flatten().map(|(_, value)| value);
    entries
        .chain(tree.list().into_iter().flatten())
        .for_each(|of| keys(of, all));
}

/// The alternatives of a schema; itself without alternatives.
fn alternatives(schema: &'static Tree) -> Vec<&'static Tree> {
    let schema = TREE.resolved(schema);
    match schema.get("anyOf").and_then(Tree::list) {
        Some(each) => each.iter().flat_map(alternatives).collect(),
        None => vec![schema],
    }
}

#[cfg(test)]
mod tests {
    use crate::{meaning_of, parse_project};

    const HOUSE: &str = "schema = 1\nkind = \"building\"\nname = \"H\"\nsource = \"of its drawings\"\n\
        units = { mass = \"t\", stiffness = \"kN/mm\" }\np_delta = false\n\
        floors = [{ name = \"ground\", count = 2, mass = 420, sides = [26, 20], height = \"3.40 m\", stiffness = { x = 236.963108655, y = 500, rotation = \"6e7 kN*m/rad\", centre = [-2, 0] } }]\n\
        [damping]\nratio = 0.015\n[limits]\nstorey_drift = \"1/67\"\nsource = \"of the owner\"\n\
        [variant.stiff]\ntitle = \"Stiff\"\nfloors.1.stiffness.x = 700\np_delta = true\n";

    #[test]
    fn exact_leaves_are_all_values_as_written_and_no_words() {
        let project = parse_project(HOUSE, "p.toml").unwrap();
        let each: Vec<_> = project
            .leaves
            .iter()
            .map(|leaf| (leaf.path.as_str(), leaf.written.as_str()))
            .collect();
        assert_eq!(
            each,
            [
                ("kind", "building"),
                ("units.mass", "t"),
                ("units.stiffness", "kN/mm"),
                ("p_delta", "false"),
                ("floors[1].count", "2"),
                ("floors[1].mass", "420"),
                ("floors[1].sides", "[26, 20]"),
                ("floors[1].height", "3.40 m"),
                ("floors[1].stiffness.x", "236.963108655"),
                ("floors[1].stiffness.y", "500"),
                ("floors[1].stiffness.rotation", "6e7 kN*m/rad"),
                ("floors[1].stiffness.centre", "[-2, 0]"),
                ("damping.ratio", "0.015"),
                ("limits.storey_drift", "1/67"),
            ]
        );
        assert_eq!(project.leaves[4].part.as_deref(), Some("ground"));
        assert_eq!(project.leaves[6].values, Some(2));
        let variant = &project.variants[0].project;
        let switch = variant.leaves.iter().find(|leaf| leaf.path == "p_delta");
        assert_eq!(switch.unwrap().written, "true");
    }

    #[test]
    fn holds_a_number_as_written_is_not_rounded() {
        let project = parse_project(HOUSE, "p.toml").unwrap();
        let stiffness = project.input("floors[1].stiffness.x").unwrap();
        assert_eq!(stiffness.written, "236.963108655 kN/mm");
    }

    #[test]
    fn exact_the_meaning_of_a_key_is_that_of_the_schema() {
        let of = |path| meaning_of(path).map(|said| said.english);
        assert_eq!(of("floors[1].nothing"), None);
        assert_eq!(of("damper.roof"), None);
        for path in [
            "p_delta",
            "floors[1].count",
            "damper.roof.tuning",
            "wind.terrain",
            "arch.voussoirs",
            "tower.plan",
        ] {
            assert!(of(path).is_some(), "{path}");
        }
        let said = meaning_of("tower.plan").unwrap();
        assert!(
            said.korean.chars().any(|sign| ('가'..='힣').contains(&sign)),
            "{said:?}"
        );
    }
}
