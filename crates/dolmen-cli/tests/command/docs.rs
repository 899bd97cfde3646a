// SOURCE     README.md and docs/*.md.
// GOAL       Every `console` listing is reproducible: a shell runs each line after "$ " in a fresh folder with a copy of examples/, and the
//            output is the lines that follow. A line "..." stands for any lines, "…" within a line for any characters. "$ echo $?" shows
//            an exit status other than 0.
// TOLERANCE  none: a listing is cut with "...", not approximated.

use super::verbs::{Scratch, root};
use std::fs;
use std::path::Path;
use std::process::Command;

struct Listing {
    line: usize,
    commands: Vec<(String, Vec<String>)>,
}

/// The `console` blocks of a page.
fn listings(text: &str) -> Vec<Listing> {
    let mut found = Vec::new();
    let mut open: Option<Listing> = None;
    for (number, line) in text.lines().enumerate() {
        match &mut open {
            None if line.trim() == "```console" => {
                open = Some(Listing {
                    line: number + 1,
                    commands: Vec::new(),
                })
            }
            None => {}
            Some(_) if line.trim() == "```" => found.extend(open.take()),
            Some(listing) => match line.strip_prefix("$ ") {
                Some(command) => listing.commands.push((command.to_owned(), Vec::new())),
                None => listing
                    .commands
                    .last_mut()
                    .unwrap()
                    .1
                    .push(line.trim_end().to_owned()),
            },
        }
    }
    assert!(open.is_none(), "a listing is not closed");
    found
}

fn line_fits(pattern: &str, line: &str) -> bool {
    let mut parts = pattern.split('…');
    let first = parts.next().unwrap();
    let Some(mut rest) = line.strip_prefix(first) else {
        return false;
    };
    let mut last = None;
    for part in parts {
        let Some(at) = rest.find(part) else { return false };
        rest = &rest[at + part.len()..];
        last = Some(part);
    }
    rest.is_empty() || last == Some("")
}

/// Whether `printed` matches `expected`, where "..." matches any number of lines.
fn fits(expected: &[String], printed: &[&str]) -> bool {
    match expected.split_first() {
        None => printed.iter().all(|line| line.trim().is_empty()),
        Some((first, rest)) if first == "..." => (0..=printed.len()).any(|skip| fits(rest, &printed[skip..])),
        Some((first, rest)) => printed
            .split_first()
            .is_some_and(|(line, others)| line_fits(first, line.trim_end()) && fits(rest, others)),
    }
}

fn run_page(page: &Path) {
    let text = fs::read_to_string(page).unwrap();
    let parts: Vec<_> = page
        .components()
        .rev()
        .take(2)
        .map(|part| part.as_os_str().to_string_lossy())
        .collect();
    let name = parts.join("-"); // two pages have the name README.md
    let scratch = Scratch::with_examples(&name);
    for listing in listings(&text) {
        let mut status = 0;
        for (command, expected) in &listing.commands {
            if command.starts_with("cargo ") || command.starts_with("scripts/") {
                continue; // scripts/test runs this test and the demo itself
            }
            let script = command.replace("$?", &status.to_string());
            let output = Command::new("sh")
                .args(["-c", &script])
                .current_dir(scratch.path())
                .env("PATH", scratch.path_with_dolmen())
                .env("LC_ALL", "C.UTF-8")
                .output()
                .unwrap();
            status = output.status.code().unwrap_or(-1);
            let printed = String::from_utf8_lossy(&output.stdout).into_owned()
                + &String::from_utf8_lossy(&output.stderr);
            let lines: Vec<&str> = printed.lines().collect();
            let shown = expected.is_empty() || fits(expected, &lines);
            assert!(
                shown,
                "{name}, listing at line {}: `{command}` printed\n{printed}",
                listing.line
            );
            assert!(status != 101, "{name}: `{command}` panicked\n{printed}");
        }
    }
}

#[test]
fn holds_listings_of_the_readme_run_as_printed() {
    run_page(&root().join("README.md"));
}

#[test]
fn holds_listings_of_the_docs_run_as_printed() {
    let mut pages: Vec<_> = fs::read_dir(root().join("docs"))
        .unwrap()
        .map(|e| e.unwrap().path())
        .collect();
    pages.sort();
    for page in pages.iter().filter(|p| p.extension().is_some_and(|e| e == "md")) {
        run_page(page);
    }
}

#[test]
fn holds_patterns_fit_what_they_should_and_nothing_else() {
    assert!(line_fits("wrote … in … s", "wrote report.html in 0.2 s"));
    assert!(!line_fits("wrote … in … s", "wrote report.html"));
    assert!(!line_fits("4.7356", "4.73560"));
    let expected = ["a".to_owned(), "...".to_owned(), "d".to_owned()];
    assert!(fits(&expected, &["a", "b", "c", "d"]));
    assert!(!fits(&expected, &["a", "b", "c"]));
}
