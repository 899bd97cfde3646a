// SOURCE     The layout of the project, as in CONTRIBUTING.md.
// GOAL       Chapters import only downwards, and files stay readable in one sitting.
// TOLERANCE  none.

use std::fs;
use std::path::{Path, PathBuf};

/// The chapters of the science crate: each may import itself and earlier ones.
const CHAPTERS: [&str; 12] = [
    "known",
    "numeric",
    "signal",
    "modal",
    "structure",
    "stability",
    "dynamics",
    "blocks",
    "damper",
    "assess",
    "monitoring",
    "comparisons",
];
/// Crates, lowest first, with the crates that each may use.
const CRATES: [(&str, &[&str]); 13] = [
    ("dolmen-picture", &[]),
    ("dolmen-print", &["dolmen-picture"]),
    ("dolmen-linalg", &[]),
    ("dolmen", &["dolmen-linalg"]),
    ("dolmen-words", &["dolmen", "dolmen-linalg"]),
    ("dolmen-records", &["dolmen", "dolmen-words"]),
    ("dolmen-project", &["dolmen", "dolmen-words", "dolmen-records"]),
    (
        "dolmen-work",
        &["dolmen", "dolmen-words", "dolmen-records", "dolmen-project"],
    ),
    (
        "dolmen-report",
        &[
            "dolmen",
            "dolmen-words",
            "dolmen-records",
            "dolmen-project",
            "dolmen-work",
        ],
    ),
    (
        "dolmen-folder",
        &[
            "dolmen-words",
            "dolmen-records",
            "dolmen-project",
            "dolmen-work",
            "dolmen-report",
        ],
    ),
    (
        "dolmen-store",
        &[
            "dolmen",
            "dolmen-linalg",
            "dolmen-words",
            "dolmen-records",
            "dolmen-project",
            "dolmen-work",
        ],
    ),
    (
        "dolmen-follow",
        &[
            "dolmen",
            "dolmen-words",
            "dolmen-records",
            "dolmen-project",
            "dolmen-work",
            "dolmen-report",
            "dolmen-folder",
            "dolmen-store",
        ],
    ),
    (
        "dolmen-cli",
        &[
            "dolmen",
            "dolmen-folder",
            "dolmen-follow",
            "dolmen-words",
            "dolmen-records",
            "dolmen-picture",
            "dolmen-print",
            "dolmen-project",
            "dolmen-work",
            "dolmen-report",
            "dolmen-store",
        ],
    ),
];
/// Largest number of lines of a file before its `#[cfg(test)]` module.
const LINES_MOST: usize = 550;

pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

pub(crate) fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(rust_files(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
    found.sort();
    found
}

fn code(path: &Path) -> String {
    let text = fs::read_to_string(path).unwrap();
    text.split("#[cfg(test)]\nmod ")
        .next()
        .unwrap_or_default()
        .to_owned()
}

/// Chapters that `text` refers to through `crate::`, outside comments.
fn imports(text: &str) -> Vec<&'static str> {
    let lines = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    let mut named: Vec<&str> = lines
        .flat_map(|line| {
            line.match_indices("crate::")
                .map(|(at, _)| &line[at + "crate::".len()..])
                .collect::<Vec<_>>()
        })
        .filter_map(|rest| {
            let word: String = rest
                .chars()
                .take_while(|c| c.is_alphanumeric() || *c == '_')
                .collect();
            CHAPTERS.iter().copied().find(|chapter| *chapter == word)
        })
        .collect();
    named.dedup();
    named
}

#[test]
fn holds_chapters_import_only_downwards() {
    let source = root().join("crates/dolmen/src");
    let rank = |chapter: &str| CHAPTERS.iter().position(|c| *c == chapter);
    for folder in fs::read_dir(&source)
        .unwrap()
        .map(|e| e.unwrap().path())
        .filter(|p| p.is_dir())
    {
        let chapter = folder.file_name().unwrap().to_str().unwrap().to_owned();
        let own =
            rank(&chapter).unwrap_or_else(|| panic!("chapter {chapter} is not in the list of this test"));
        for file in rust_files(&folder) {
            for named in imports(&code(&file)) {
                assert!(
                    rank(named) <= Some(own),
                    "{} imports {named}, a later chapter",
                    file.display()
                );
            }
        }
    }
}

#[test]
fn holds_crates_depend_only_downwards() {
    for (name, allowed) in CRATES {
        let manifest = fs::read_to_string(root().join("crates").join(name).join("Cargo.toml")).unwrap();
        let section = manifest.split("[dependencies]").nth(1).unwrap_or_default();
        let section = section.split("\n[").next().unwrap_or_default();
        for line in section.lines().filter(|line| line.starts_with("dolmen")) {
            let dependency = line.split(['.', ' ', '=']).next().unwrap_or_default();
            assert!(allowed.contains(&dependency), "{name} depends on {dependency}");
        }
    }
}

#[test]
fn holds_files_can_be_read_in_one_sitting() {
    for (name, _) in CRATES {
        for file in rust_files(&root().join("crates").join(name).join("src")) {
            let lines = code(&file).lines().count();
            assert!(
                lines <= LINES_MOST,
                "{} has {lines} lines before its tests",
                file.display()
            );
        }
    }
}

#[test]
fn refuses_an_upward_import_in_a_sample() {
    assert_eq!(imports("use crate::assess::Probability;\n"), ["assess"]);
    assert_eq!(imports("// use crate::assess::Probability;\n"), [""; 0]);
}

/// The string literals of `text`, each with its line, without comments.
fn literals(text: &str) -> Vec<(usize, String)> {
    let bytes = text.as_bytes();
    let (mut found, mut at, mut line) = (Vec::new(), 0, 1);
    while at < bytes.len() {
        let rest = &text[at..];
        let hashes = rest
            .strip_prefix('r')
            .map_or(0, |r| r.len() - r.trim_start_matches('#').len());
        let raw = rest.starts_with('r') && rest[1 + hashes..].starts_with('"');
        let named = at > 0 && (bytes[at - 1].is_ascii_alphanumeric() || bytes[at - 1] == b'_');
        let length = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if raw && !named {
            let end = format!("\"{}", "#".repeat(hashes));
            let from = 2 + hashes;
            let inside = rest[from..].find(&end).unwrap();
            found.push((line, rest[from..from + inside].to_owned()));
            from + inside + end.len()
        } else if rest.starts_with('"') {
            let mut end = 1;
            while bytes[at + end] != b'"' {
                end += if bytes[at + end] == b'\\' { 2 } else { 1 };
            }
            found.push((line, rest[1..end].replace("\\\"", "\"")));
            end + 1
        } else if rest.starts_with("'\"'") {
            3
        } else if rest.starts_with("'\\\"'") {
            4
        } else {
            rest.chars().next().map_or(1, char::len_utf8)
        };
        line += rest[..length].matches('\n').count();
        at += length;
    }
    found
}

/// Whether a text contains a flag of the command: "--" followed by a letter.
fn names_a_flag(text: &str) -> bool {
    let mut parts = text.split("--").skip(1);
    parts.any(|rest| rest.starts_with(|c: char| c.is_ascii_lowercase()))
}

#[test]
fn holds_the_science_names_no_key_of_a_project_and_no_command() {
    const ABOVE: [&str; 17] = [
        "`dolmen ",
        "(dolmen ",
        "project file",
        "project.toml",
        "conditioning",
        "[survey",
        "[site",
        "[motion",
        "[study",
        "[variant",
        "= { ",
        "= {{",
        "merge = ",
        "starts = ",
        "leave_out",
        "decimate_factor",
        "detrend_degree",
    ];
    for name in ["dolmen", "dolmen-linalg"] {
        for file in rust_files(&root().join("crates").join(name).join("src")) {
            for (line, text) in literals(&code(&file)) {
                let named = ABOVE.iter().find(|word| text.contains(**word));
                assert!(
                    named.is_none() && !names_a_flag(&text),
                    "{}:{line} names what stands above the science: {text}",
                    file.display()
                );
            }
        }
    }
}
