//! Messages about project files: listings of the book, carets, inputs of the fuzzer, and run time.

use super::project::{CHAIN, chain_with, read, refused};
use dolmen_project::parse_project;
use std::path::Path;

#[test]
fn holds_the_listings_of_the_book_are_read_and_its_errors_are_what_is_said() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/project-file.md");
    let page = std::fs::read_to_string(page).unwrap();
    let blocks = |fence: &str| -> Vec<String> {
        let parts = page.split(fence).skip(1);
        parts
            .map(|part| part.split("\n```").next().unwrap().trim_start().to_owned())
            .collect()
    };
    let listings = blocks("```toml\n");
    assert_eq!(listings.len(), 4);
    for listing in listings {
        read(&listing);
    }
    let said = [
        refused(&chain_with(&[("centroid = 1.18", "centroid = 5.2")])),
        refused(&chain_with(&[(
            "joints = \"unknown\"\n",
            "\n[survey.2010-05-12]\ntemperature_c = 18\njoints = \"unknown\"\n",
        )])),
        refused(&chain_with(&[("15.13", "15130")])),
    ];
    let errors = blocks("```text\n");
    assert_eq!(
        errors.iter().map(|error| error.trim_end()).collect::<Vec<_>>(),
        said.each_ref().map(|s| s.trim_end())
    );
}

/// Width of a text on a terminal, Hangul two columns each: counted here without the code under test.
fn columns(text: &str) -> usize {
    text.chars()
        .map(|c| if ('가'..='힣').contains(&c) { 2 } else { 1 })
        .sum()
}

#[test]
fn holds_carets_stand_below_what_is_wrong() {
    let hangul = [("{ weight = 15.13,", "{ name = \"둘째 돌\", weight = \"열다섯\",")];
    let far = format!("{CHAIN}\n\n[survey.a]\ntilt = {{ \"동쪽\" = 177 }}\n");
    for (text, wrong) in [
        (chain_with(&[("centroid = 1.18", "centroid = 5.2")]), "5.2"),
        (chain_with(&hangul), "\"열다섯\""),
        (far, "177"),
    ] {
        let said = refused(&text);
        let lines: Vec<&str> = said.lines().collect();
        let [bar, source, carets] = lines[2..5] else {
            panic!("{said}")
        };
        let at = source.find(wrong).unwrap();
        let from = carets.find('^').unwrap();
        let count = carets.matches('^').count();
        assert_eq!(columns(&source[..at]), columns(&carets[..from]), "{said}");
        assert_eq!(columns(wrong), count, "{said}");
        assert_eq!(bar.find('|'), source.find('|'), "{said}");
        let column: usize = lines[1].rsplit(':').next().unwrap().parse().unwrap();
        let start_of_text = source.find("| ").unwrap() + 2;
        assert_eq!(source[start_of_text..at].chars().count() + 1, column, "{said}");
    }
}

#[test]
fn holds_every_input_of_the_fuzzer_is_read_or_refused() {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus/project");
    let mut count = 0;
    for entry in std::fs::read_dir(corpus).unwrap() {
        let bytes = std::fs::read(entry.unwrap().path()).unwrap();
        let text = String::from_utf8_lossy(&bytes);
        if let Err(error) = parse_project(&text, "fuzz") {
            assert!(!error.problems.is_empty());
            assert!(error.to_string().contains("error: "));
        }
        count += 1;
    }
    assert!(count >= 20, "{count}");
}
