// SOURCE     The layout of the project as in CONTRIBUTING.md: imports go one way.
// GOAL       No file of a crate imports, directly or indirectly, a file that imports it.
// METHOD     imports.rs resolves every path to the file that defines the item; files that import each other form a
//            strongly connected component.
// LIMITS     A method called on a value is no import: only the name of its type is. Names inside format strings and
//            string literals of attributes are not read.
// TOLERANCE  none.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use crate::imports::{Imports, Sources, imports};
use crate::layout::{root, rust_files};

/// A set of files that import each other, and the names that connect them.
struct Circle {
    files: BTreeSet<String>,
    ties: Imports,
}

/// The cycles of a crate.
fn circles(sources: &Sources) -> Vec<Circle> {
    let imports = imports(sources);
    let mut next: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for (from, to) in imports.keys() {
        next.entry(from).or_default().push(to);
    }
    let reached = |start: &str| {
        let mut seen = BTreeSet::new();
        let mut open = vec![start.to_owned()];
        while let Some(file) = open.pop() {
            for to in next.get(file.as_str()).into_iter().flatten() {
                if seen.insert((*to).to_owned()) {
                    open.push((*to).to_owned());
                }
            }
        }
        seen
    };
    let reach: BTreeMap<&str, BTreeSet<String>> = next.keys().map(|file| (*file, reached(file))).collect();
    let mut found: Vec<Circle> = Vec::new();
    for (file, ahead) in &reach {
        if !ahead.contains(*file) || found.iter().any(|c| c.files.contains(*file)) {
            continue;
        }
        let back = |other: &String| reach.get(other.as_str()).is_some_and(|r| r.contains(*file));
        let files: BTreeSet<String> = ahead.iter().filter(|other| back(other)).cloned().collect();
        let ties = imports
            .iter()
            .filter(|((from, to), _)| files.contains(from) && files.contains(to))
            .map(|(pair, names)| (pair.clone(), names.clone()))
            .collect();
        found.push(Circle { files, ties });
    }
    found
}

impl std::fmt::Display for Circle {
    fn fmt(&self, to: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let list = |names: &BTreeSet<String>| names.iter().cloned().collect::<Vec<_>>().join(", ");
        writeln!(
            to,
            "a circle of {} files: {}",
            self.files.len(),
            list(&self.files)
        )?;
        for ((from, other), names) in &self.ties {
            writeln!(to, "  {from} -> {other}: {}", list(names))?;
        }
        Ok(())
    }
}

fn sources_of(folder: &Path) -> Sources {
    rust_files(folder)
        .iter()
        .map(|path| {
            let inside = path.strip_prefix(folder).unwrap().to_str().unwrap();
            (inside.replace('\\', "/"), fs::read_to_string(path).unwrap())
        })
        .collect()
}

#[test]
fn holds_no_file_imports_itself_over_a_detour() {
    let mut told = String::new();
    let mut crates = 0;
    for entry in fs::read_dir(root().join("crates")).unwrap() {
        let folder = entry.unwrap().path();
        let name = folder.file_name().unwrap().to_str().unwrap().to_owned();
        crates += 1;
        for circle in circles(&sources_of(&folder.join("src"))) {
            told += &format!("{name}: {circle}");
        }
    }
    assert!(crates > 0, "no crate was found");
    assert!(
        told.is_empty(),
        "move what both files need into the file where it belongs:\n{told}"
    );
}

/// Files of a made-up crate.
fn planted(files: &[(&str, &str)]) -> Sources {
    let owned = |(path, text): &(&str, &str)| ((*path).to_owned(), (*text).to_owned());
    files.iter().map(owned).collect()
}

/// The cycles of a made-up crate, each as its files.
fn files_in_circles(files: &[(&str, &str)]) -> Vec<Vec<String>> {
    let found = circles(&planted(files));
    found
        .into_iter()
        .map(|circle| circle.files.into_iter().collect())
        .collect()
}

#[test]
fn refuses_two_files_that_import_each_other() {
    let files = [
        ("lib.rs", "mod beam; mod load;"),
        (
            "beam.rs",
            "use crate::load::{Load, as_drawn};\npub struct Beam(Load);",
        ),
        (
            "load.rs",
            "pub struct Load;\npub fn as_drawn(beam: &crate::beam::Beam) {}",
        ),
    ];
    let found = circles(&planted(&files));
    assert_eq!(found.len(), 1);
    assert_eq!(
        found[0].to_string(),
        "a circle of 2 files: beam.rs, load.rs\n  beam.rs -> load.rs: Load, as_drawn\n  load.rs -> beam.rs: Beam\n"
    );
}

#[test]
fn refuses_a_circle_through_a_mod_rs_that_hands_on() {
    let files = [
        ("lib.rs", "pub mod modal;"),
        (
            "modal/mod.rs",
            "mod pole;\nmod ssi;\npub use pole::Pole;\npub(crate) use ssi::{Options as Ssi, run};",
        ),
        ("modal/pole.rs", "use super::Ssi;\npub struct Pole(Ssi);"),
        (
            "modal/ssi.rs",
            "pub struct Options;\npub fn run() -> super::Pole { todo!() }",
        ),
    ];
    assert_eq!(files_in_circles(&files), [["modal/pole.rs", "modal/ssi.rs"]]);
}

#[test]
fn refuses_a_circle_through_a_function_that_has_the_name_of_its_module() {
    let files = [
        ("lib.rs", "mod era;\nmod fit;\npub use era::era;"),
        ("era.rs", "pub fn era() { crate::fit::fit() }"),
        ("fit.rs", "use super::era;\npub fn fit() { era() }"),
    ];
    assert_eq!(files_in_circles(&files), [["era.rs", "fit.rs"]]);
}

#[test]
fn refuses_a_circle_of_three_files_however_they_name_each_other() {
    // by an import, by a path in a macro, and by a glob
    let files = [
        ("lib.rs", "mod a; mod b; mod deep;"),
        ("a.rs", "use super::b;\npub fn first() { b::second() }"),
        (
            "b.rs",
            "pub fn second() { println!(\"{}\", super::deep::c::third(0)) }",
        ),
        ("deep/mod.rs", "pub mod c;"),
        (
            "deep/c.rs",
            "use super::super::a::*;\npub fn third(_: u8) -> u8 { first(); 0 }",
        ),
    ];
    assert_eq!(files_in_circles(&files), [["a.rs", "b.rs", "deep/c.rs"]]);
}

#[test]
fn refuses_a_mod_rs_that_defines_what_its_children_use() {
    let files = [
        ("lib.rs", "mod ensemble;"),
        (
            "ensemble/mod.rs",
            "mod lane;\npub struct Queue;\npub fn run(q: Queue) { lane::drive(q) }",
        ),
        ("ensemble/lane.rs", "pub(super) fn drive(_: super::Queue) {}"),
    ];
    assert_eq!(
        files_in_circles(&files),
        [["ensemble/lane.rs", "ensemble/mod.rs"]]
    );
}

#[test]
fn refuses_a_macro_of_the_root_that_names_the_files_that_call_it() {
    let files = [
        (
            "main.rs",
            "macro_rules! note { () => {} }\nmod check;\nfn main() { check::run() }",
        ),
        ("check.rs", "pub fn run() { note!() }"),
    ];
    assert_eq!(files_in_circles(&files), [["check.rs", "main.rs"]]);
}

#[test]
fn holds_a_good_layout_has_no_circle() {
    let files = [
        ("lib.rs", "pub mod modal;\npub use modal::{Pole, identify};"),
        (
            "modal/mod.rs",
            "mod identify;\nmod options;\nmod pole;\npub use identify::identify;\npub use options::Options;\npub use pole::*;",
        ),
        // a module and a function with the same name, and an inherent function of a type
        (
            "modal/identify.rs",
            "use super::{Options, Pole};\npub fn identify(o: &Options) -> Pole { Options::default(); Pole::at(o.hz) }",
        ),
        (
            "modal/options.rs",
            "#[derive(Default)]\npub struct Options { pub(super) hz: f64 }\n#[cfg(test)]\nmod tests { use super::super::identify; }",
        ),
        // a field and a variable may have the name of a function in another file
        (
            "modal/pole.rs",
            "pub struct Pole { identify: f64 }\nimpl Pole { pub fn at(identify: f64) -> Self { assert!(identify > 0.0); Pole { identify } } }\n#[cfg(test)]\nmod tests;",
        ),
        ("modal/pole/tests.rs", "use crate::modal::{Options, identify};"),
    ];
    assert_eq!(files_in_circles(&files), [[""; 0]; 0]);
}

#[test]
#[should_panic(expected = "no `mod` declares left.rs")]
fn refuses_a_file_that_no_module_declares() {
    circles(&planted(&[("lib.rs", ""), ("left.rs", "")]));
}
