// SOURCE     The files of dolmen-project, dolmen-work and dolmen-report, and the sentences that `dolmen words` prints.
// GOAL       `dolmen words` prints every group of messages, and no two sentences have the same name.
// TOLERANCE  none.

use dolmen_report::sentences::sentences;
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
