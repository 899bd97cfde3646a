// SOURCE     The files of dolmen-project, dolmen-work and dolmen-report, and the sentences that `dolmen words` prints.
// GOAL       `dolmen words` prints every group of messages, no two sentences have the same name, and those of a report name on paper no
//            command and no key of the file.
// TOLERANCE  none.

use dolmen_report::sentences::sentences;
use dolmen_words::Language;
use dolmen_words::message::Medium;
use std::collections::BTreeSet;
use std::path::Path;

/// Names of the groups of messages in the files of a folder.
fn groups(folder: &Path, found: &mut BTreeSet<String>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            groups(&path, found);
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            groups_of(&path, found);
        }
    }
}

/// Names of the groups of messages and errors in a file.
fn groups_of(file: &Path, found: &mut BTreeSet<String>) {
    let text = std::fs::read_to_string(file).unwrap();
    let lines = text
        .lines()
        .filter(|line| line.ends_with('{') && !line.trim_start().starts_with("//"));
    let named = lines.filter_map(|line| line.split_once(" in \"")?.1.strip_suffix("\" {"));
    found.extend(named.map(str::to_owned));
}

#[test]
fn holds_every_group_of_messages_is_in_the_table() {
    let mut written = BTreeSet::new();
    for of in [
        "../dolmen-project/src",
        "../dolmen-work/src",
        "../dolmen-records/src",
        "../dolmen-report/src",
    ] {
        groups(&Path::new(env!("CARGO_MANIFEST_DIR")).join(of), &mut written);
    }
    for of in ["../dolmen-words/src/advice.rs", "../dolmen-words/src/system.rs"] {
        groups_of(&Path::new(env!("CARGO_MANIFEST_DIR")).join(of), &mut written);
    }
    let listed: BTreeSet<String> = sentences().iter().map(|of| of.group.to_owned()).collect();
    assert!(listed.len() > 5);
    assert_eq!(listed, written);
    let ids: BTreeSet<String> = sentences().iter().map(dolmen_words::Template::id).collect();
    assert_eq!(ids.len(), sentences().len(), "identifiers are unlike");
}

/// Groups that a report never prints: errors, the store, and answers that only a terminal gives.
const NOT_ON_PAPER: [&str; 12] = [
    "error",
    "fault",
    "store.",
    "science.advice",
    "score",
    "portfolio",
    "rank",
    "scanned",
    "sheet",
    "kept",
    "workbook",
    "made-stones",
];

/// A table, a key of several words or with its value, or a command of the terminal in a text.
fn typed(text: &str) -> Option<&str> {
    if let Some((_, behind)) = text.split_once("`dolmen ") {
        return Some(behind);
    }
    let is_of_key = |sign: char| sign.is_ascii_lowercase() || sign == '_';
    let places = text
        .split_inclusive('{')
        .map(|part| part.split_once('}').map_or(part, |of| of.1));
    for part in places {
        let mut rest = part;
        while let Some(start) = rest.find(is_of_key) {
            let last = rest[..start].chars().next_back();
            let own = &rest[start..];
            let (word, after) = own.split_at(own.find(|sign| !is_of_key(sign)).unwrap_or(own.len()));
            let is_named = word.contains('_')
                || after.starts_with(" = ")
                || (last == Some('[') && !after.starts_with('-'));
            if word.len() > 2 && dolmen_project::is_key(word) && is_named {
                return Some(word);
            }
            rest = after;
        }
    }
    None
}

#[test]
fn holds_sentences_of_a_report_name_no_command_and_no_key_on_paper() {
    assert_eq!(typed("let `dolmen check` judge it"), Some("check` judge it"));
    assert_eq!(typed("give bed_width of {link}"), Some("bed_width"));
    assert_eq!(
        typed("the mode turns about x = 2, so does tower_1 ({bed_width})"),
        None
    );
    let all = sentences();
    let printed = all
        .iter()
        .filter(|of| !NOT_ON_PAPER.iter().any(|part| of.group.contains(part)));
    let mut wrong = Vec::new();
    for template in printed {
        for language in [Language::English, Language::Korean] {
            let text = template.on(language, Medium::Paper);
            if let Some(word) = typed(&text) {
                wrong.push(format!("{}: {word}: {text}", template.id()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
