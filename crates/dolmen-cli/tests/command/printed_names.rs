// SOURCE     docs/project-file.md, "Names in two languages".
// GOAL       A Korean reader sees the Korean names of parts in text, page and figures; JSON, CSV and files keep those of the project file.
// TOLERANCE  none.

use super::verbs::Scratch;
use std::fs;

const PAGODA: &str = "examples/five_storey_pagoda";

#[test]
fn holds_names_are_printed_in_the_language_of_the_reader() {
    let scratch = Scratch::with_examples("printed-names");
    let said = |language: &str, words: &str| {
        let answer = scratch.dolmen(&format!("{words} --language {language}"));
        assert!(answer.status <= 1, "{}{}", answer.stdout, answer.stderr);
        answer.words()
    };
    let korean = said("ko", &format!("check {PAGODA}"));
    assert!(
        korean.contains("5층 옥개석") && !korean.contains("roof 5") && !korean.contains("post a"),
        "{korean}"
    );
    let english = said("en", &format!("check {PAGODA}"));
    assert!(
        english.contains("roof 5") && !english.contains("옥개석"),
        "{english}"
    );
    let data = said("ko", &format!("check {PAGODA} --json"));
    assert!(data.contains("roof 5") && !data.contains("옥개석"));
    said("ko", &format!("report {PAGODA} -o page.html --figures drawn"));
    let read = |name: &str| fs::read_to_string(scratch.path().join(name)).unwrap();
    let page = read("page.html");
    assert!(page.contains("5층 옥개석") && page.contains(">노반</text>"));
    assert!(!page.contains(">dew basin<"));
    let folder = scratch.path().join("drawn");
    let csv = fs::read_dir(folder).unwrap().flatten().map(|entry| entry.path());
    let csv =
        csv.filter(|path| path.extension().is_some_and(|of| of == "csv") && !path.ends_with("figures.csv"));
    let heads: String = csv.map(|path| fs::read_to_string(path).unwrap()).collect();
    assert!(heads.contains("dew basin") && !heads.contains("노반"), "{heads}");
}
