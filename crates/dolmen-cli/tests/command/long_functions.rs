// SOURCE     The source of every crate, laid out by rustfmt.
// GOAL       A function can be read at one glance: at most 100 lines. Functions that are lists of sentences or cases are exempt.
// TOLERANCE  none.

use super::layout::{root, rust_files};
use std::fs;

/// Largest number of lines of a function, from `fn` to its closing brace.
const LINES_MOST: usize = 100;
/// Functions that are lists: a sentence for each variant, or published cases.
const LISTS: [&str; 9] = [
    "dolmen-report/src/identification/notes.rs stiffness_note",
    "dolmen-report/src/modal/notes.rs note_words",
    "dolmen-report/src/modal/steps.rs step_words",
    "dolmen/src/assess/stack_notes.rs fmt",
    "dolmen/src/comparisons/fragility.rs cases",
    "dolmen/src/comparisons/kim_koo_hong_2018.rs cases",
    "dolmen/src/modal/notes.rs fmt",
    "dolmen/src/signal/processing.rs fmt",
    "dolmen/src/structure/stiffness_note.rs fmt",
];
struct Long {
    name: String,
    line: usize,
    lines: usize,
}

/// The name in a line that begins a function.
fn function(line: &str) -> Option<&str> {
    let mut words = line.trim_start();
    for word in ["pub(crate) ", "pub(super) ", "pub ", "const ", "async "] {
        words = words.strip_prefix(word).unwrap_or(words);
    }
    let name = words.strip_prefix("fn ")?;
    name.split(|c: char| !c.is_alphanumeric() && c != '_').next()
}

/// Functions of more than `most` lines; each ends with a brace at the same indentation.
fn longer(text: &str, most: usize) -> Vec<Long> {
    let lines: Vec<&str> = text.lines().collect();
    let mut found = Vec::new();
    for (at, line) in lines.iter().enumerate() {
        let Some(name) = function(line) else { continue };
        let within = line.len() - line.trim_start().len();
        let end = format!("{}}}", &line[..within]);
        let none = format!("{};", &line[..within]);
        let length = lines[at..]
            .iter()
            .position(|line| {
                **line == end || line.ends_with('}') && line.contains("fn ") || line.starts_with(&none)
            })
            .map_or(0, |last| last + 1);
        if length > most {
            found.push(Long {
                name: name.to_owned(),
                line: at + 1,
                lines: length,
            });
        }
    }
    found
}

#[test]
fn holds_functions_can_be_read_in_one_look() {
    let crates = fs::canonicalize(root().join("crates")).unwrap();
    let mut seen = Vec::new();
    for entry in fs::read_dir(&crates).unwrap() {
        for file in rust_files(&entry.unwrap().path().join("src")) {
            let text = fs::read_to_string(&file).unwrap();
            let code = text.split("#[cfg(test)]\nmod ").next().unwrap_or_default();
            for long in longer(code, LINES_MOST) {
                let path = file.strip_prefix(&crates).unwrap().display();
                let name = format!("{path} {}", long.name);
                assert!(
                    LISTS.contains(&name.as_str()),
                    "{name}, line {}: {} lines, at most {LINES_MOST}: split it by what it does",
                    long.line,
                    long.lines
                );
                seen.push(name);
            }
        }
    }
    for list in LISTS {
        assert!(
            seen.iter().any(|name| name == list),
            "{list} is short: take it out"
        );
    }
}

#[test]
fn refuses_a_long_function_in_a_sample() {
    let inner = "        let x = 1;\n".repeat(4);
    let text = format!(
        "impl A {{\n    pub(crate) fn long<T>(\n        a: T,\n    ) {{\n{inner}    }}\n\n    fn short() {{}}\n}}\nfn last() {{\n    x\n}}\n"
    );
    let found = longer(&text, 6);
    let [long] = &found[..] else {
        panic!("{}", found.len())
    };
    assert_eq!((long.name.as_str(), long.line, long.lines), ("long", 2, 8));
    assert!(longer(&text, 8).is_empty());
}
