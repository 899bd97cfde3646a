//! Text that no project may contain: project files come from strangers, and their names become file names and are shown in terminals.

use super::error::Fault;
use super::wrong::WrongFile;
use dolmen_words::folded_file_name;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Tables whose keys become names of folders and files.
const NAMED: [&str; 6] = ["study", "damper", "direction", "variant", "survey", "motion"];

/// All faults of texts and names.
pub(super) fn unsafe_text(root: &DeTable<'_>) -> Vec<Fault> {
    let mut faults = Vec::new();
    signs_of_table(root, "", &mut faults);
    for table in NAMED {
        if let Some(DeValue::Table(named)) = root.get(table).map(Spanned::get_ref) {
            one_file_each(table, named, &mut faults);
        }
    }
    faults
}

/// Every text of a project file; empty for a text that is not TOML.
pub fn texts(text: &str) -> Vec<String> {
    fn of(value: &DeValue<'_>, all: &mut Vec<String>) {
        match value {
            DeValue::String(text) => all.push(text.to_string()),
            DeValue::Array(list) => list.iter().for_each(|value| of(value.get_ref(), all)),
            DeValue::Table(table) => table.values().for_each(|value| of(value.get_ref(), all)),
            _ => {}
        }
    }
    let (root, _) = DeTable::parse_recoverable(text);
    let mut all = Vec::new();
    root.get_ref()
        .values()
        .for_each(|value| of(value.get_ref(), &mut all));
    all
}

/// Names that would be one file where case is ignored.
fn one_file_each(table: &str, named: &DeTable<'_>, faults: &mut Vec<Fault>) {
    let mut keys: Vec<_> = named.keys().collect();
    keys.sort_by_key(|key| key.span().start);
    // the first name of each file
    let mut files = BTreeMap::new();
    for key in keys {
        let name = key.get_ref();
        let twin = match files.entry(folded_file_name(name)) {
            Entry::Vacant(free) => {
                free.insert(key);
                continue;
            }
            Entry::Occupied(taken) => *taken.get(),
        };
        let path = format!("{table}.{name}");
        let message = WrongFile::IsNamedAsBut {
            table: table.to_string(),
            name: name.to_string(),
            twin: twin.get_ref().to_string(),
        };
        let fault = Fault::new(key.span(), &path, message);
        faults.push(
            fault
                .allowed(WrongFile::ResultsWouldBeOne)
                .help(WrongFile::GiveItAnotherName),
        );
    }
}

/// Whether a character controls a terminal or changes the direction of writing.
fn steers(sign: char) -> bool {
    let turns = matches!(sign, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    turns || (sign.is_control() && !matches!(sign, '\n' | '\r' | '\t'))
}

fn signs(text: &str, span: std::ops::Range<usize>, path: &str, faults: &mut Vec<Fault>) {
    let Some(sign) = text.chars().find(|sign| steers(*sign)) else {
        return;
    };
    let path: String = path
        .chars()
        .map(|sign| if steers(sign) { '?' } else { sign })
        .collect();
    let message = WrongFile::HoldsControlCharacterU {
        path: path.to_string(),
        sign: format!("{:04X}", u32::from(sign)),
    };
    let fault = Fault::new(span, &path, message);
    faults.push(
        fault
            .allowed(WrongFile::OnlyLettersDigitsSigns)
            .help(WrongFile::TakeItOutCopied),
    );
}

fn signs_of_table(table: &DeTable<'_>, at: &str, faults: &mut Vec<Fault>) {
    for (key, value) in table {
        let path = match at {
            "" => key.get_ref().to_string(),
            _ => format!("{at}.{}", key.get_ref()),
        };
        signs(key.get_ref(), key.span(), &path, faults);
        signs_of(value, &path, faults);
    }
}

fn signs_of(value: &Spanned<DeValue<'_>>, path: &str, faults: &mut Vec<Fault>) {
    match value.get_ref() {
        DeValue::String(text) => signs(text, value.span(), path, faults),
        DeValue::Array(list) => {
            for (at, value) in list.iter().enumerate() {
                signs_of(value, &format!("{path}[{}]", at + 1), faults);
            }
        }
        DeValue::Table(table) => signs_of_table(table, path, faults),
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse_project;

    fn messages_of(text: &str) -> Vec<String> {
        let fault = parse_project(text, "p.toml").unwrap_err();
        fault
            .problems
            .into_iter()
            .map(|problem| problem.message.english)
            .collect()
    }

    #[test]
    fn refuses_names_that_would_be_one_folder() {
        let text =
            "schema = 1\nkind = \"survey\"\nname = \"a\"\n[survey.Weak]\n[survey.weak]\n[survey.week]\n";
        assert_eq!(
            messages_of(text),
            ["survey \"weak\" is named as \"Weak\" but for capitals or the way letters are composed"]
        );
    }

    #[test]
    fn refuses_signs_that_steer_a_terminal() {
        let text = "schema = 1\nkind = \"survey\"\nname = \"a\\u001b[2Jb\"\n[survey.\"x\\u202ey\"]\n";
        assert_eq!(
            messages_of(text),
            [
                "name holds the control character U+001B",
                "survey.x?y holds the control character U+202E"
            ]
        );
    }

    #[test]
    fn exact_texts() {
        let text = "a = \"x.csv\"\n[b]\nc = [\"y.npy\", { d = \"z.ply\" }]\n";
        let mut all = texts(text);
        all.sort();
        assert_eq!(all, ["x.csv", "y.npy", "z.ply"]);
    }
}
