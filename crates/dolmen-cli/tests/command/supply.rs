// SOURCE     Cargo.lock and the manifests of all its crates, from `cargo metadata`.
// GOAL       No crate has a licence that was not agreed to, an unlisted second version, or no line in THIRD-PARTY.md.
// TOLERANCE  none: names, versions and licences.

use super::verbs::root;
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::process::Command;

/// Licences agreed to, as in `deny.toml`.
const LICENCES: [&str; 8] = [
    "Apache-2.0",
    "Apache-2.0 WITH LLVM-exception",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "CC0-1.0",
    "MIT",
    "Unicode-3.0",
    "Zlib",
];
/// Crates with several versions in Cargo.lock, except those that only Typst needs; `deny.toml` says who needs the older ones, apart from
/// those below Typst.
const SEVERAL: [(&str, usize); 15] = [
    ("bitflags", 2),
    ("constant_time_eq", 2),
    ("equator", 2),
    ("equator-macro", 2),
    ("fallible-iterator", 2),
    ("getrandom", 3),
    ("imagesize", 2),
    ("miniz_oxide", 2),
    ("r-efi", 2),
    ("strsim", 2),
    ("syn", 3),
    ("thiserror", 2),
    ("thiserror-impl", 2),
    ("wasi", 2),
    ("web-time", 2),
];

fn metadata() -> Value {
    let cargo = Command::new(env!("CARGO"))
        .args(["metadata", "--format-version", "1", "--locked"])
        .args([
            "--features",
            "dolmen-cli/pdf,dolmen-cli/postgres,dolmen-cli/parquet",
        ])
        .current_dir(root())
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&cargo.stderr);
    assert!(
        cargo.status.success(),
        "once online: cargo fetch --locked\n{said}"
    );
    serde_json::from_slice(&cargo.stdout).unwrap()
}

fn text<'a>(of: &'a Value, key: &str) -> &'a str {
    of[key].as_str().unwrap_or_default()
}

fn list<'a>(of: &'a Value, key: &str) -> &'a [Value] {
    of[key].as_array().unwrap()
}

/// Third-party crates.
fn others(metadata: &Value) -> impl Iterator<Item = &Value> {
    let all = list(metadata, "packages").iter();
    all.filter(|package| !package["source"].is_null())
}

/// Whether the agreed licences satisfy an SPDX expression.
fn is_agreed(expression: &str) -> bool {
    let spaced = expression
        .replace('/', " OR ")
        .replace('(', " ( ")
        .replace(')', " ) ");
    let words: Vec<&str> = spaced.split_whitespace().collect();
    let mut rest = words.as_slice();
    either(&mut rest) && rest.is_empty()
}

/// OR binds less tightly than AND.
fn either(rest: &mut &[&str]) -> bool {
    let mut met = both(rest);
    while let Some(("OR", after)) = rest.split_first().map(|(word, after)| (*word, after)) {
        *rest = after;
        met |= both(rest);
    }
    met
}

fn both(rest: &mut &[&str]) -> bool {
    let mut met = one(rest);
    while let Some(("AND", after)) = rest.split_first().map(|(word, after)| (*word, after)) {
        *rest = after;
        met &= one(rest);
    }
    met
}

/// A licence, with its exception if any, or an expression in brackets.
fn one(rest: &mut &[&str]) -> bool {
    match **rest {
        ["(", ref inside @ ..] => {
            *rest = inside;
            let met = either(rest);
            let closed = rest.first() == Some(&")");
            *rest = rest.get(1..).unwrap_or_default();
            met && closed
        }
        [licence, "WITH", exception, ref after @ ..] => {
            *rest = after;
            LICENCES.contains(&format!("{licence} WITH {exception}").as_str())
        }
        [licence, ref after @ ..] => {
            *rest = after;
            LICENCES.contains(&licence)
        }
        [] => false,
    }
}

#[test]
fn exact_expressions_of_licences() {
    for met in [
        "MIT",
        "MIT/Apache-2.0",
        "GPL-3.0 OR MIT",
        "Apache-2.0 WITH LLVM-exception OR MIT",
        "(MIT OR GPL-3.0) AND Unicode-3.0",
    ] {
        assert!(is_agreed(met), "{met}");
    }
    for unmet in [
        "",
        "GPL-3.0-only",
        "MIT AND GPL-3.0-only",
        "MIT WITH LLVM-exception",
        "(MIT",
        "MIT)",
    ] {
        assert!(!is_agreed(unmet), "{unmet}");
    }
}

#[test]
fn holds_every_crate_has_a_licence_that_was_agreed_to_and_comes_from_the_registry() {
    for package in others(&metadata()) {
        let (name, licence) = (text(package, "name"), text(package, "license"));
        assert!(
            is_agreed(licence),
            "{name} has the licence \"{licence}\": leave it, or add its licence here and to deny.toml"
        );
        let source = text(package, "source");
        assert_eq!(
            source, "registry+https://github.com/rust-lang/crates.io-index",
            "{name}"
        );
    }
}

#[test]
fn holds_no_crate_is_there_twice_but_those_named() {
    let mut versions: BTreeMap<String, usize> = BTreeMap::new();
    let metadata = metadata();
    for package in without_print(&metadata) {
        *versions.entry(text(package, "name").to_owned()).or_default() += 1;
    }
    versions.retain(|_, versions| *versions > 1);
    let named = SEVERAL.map(|(name, versions)| (name.to_owned(), versions));
    assert_eq!(
        versions,
        BTreeMap::from(named),
        "several versions of a crate are larger and slower to build: do without, or name it here and in deny.toml"
    );
}

/// Third-party crates that anything other than PDF output needs.
fn without_print(metadata: &Value) -> Vec<&Value> {
    let packages = list(metadata, "packages").iter();
    let packages: BTreeMap<&str, &Value> = packages.map(|package| (text(package, "id"), package)).collect();
    let nodes = list(&metadata["resolve"], "nodes").iter();
    let nodes: BTreeMap<&str, &Value> = nodes.map(|node| (text(node, "id"), node)).collect();
    let is_print = |id: &str| text(packages[id], "name") == "dolmen-print";
    let members = list(metadata, "workspace_members").iter();
    let mut left: Vec<&str> = members.filter_map(Value::as_str).collect();
    let mut seen = BTreeSet::new();
    while let Some(id) = left.pop() {
        if !is_print(id) && seen.insert(id) {
            left.extend(list(nodes[id], "deps").iter().map(|need| text(need, "pkg")));
        }
    }
    let seen = seen.into_iter().map(|id| packages[id]);
    seen.filter(|package| !package["source"].is_null()).collect()
}

/// Third-party crates in the command on any system, with all features; without build and test dependencies.
fn contained(metadata: &Value) -> BTreeSet<[String; 3]> {
    let by_id = |of: &'static str, all: &[Value]| -> BTreeMap<String, Value> {
        all.iter()
            .map(|one| (text(one, of).to_owned(), one.clone()))
            .collect()
    };
    let packages = by_id("id", list(metadata, "packages"));
    let nodes = by_id("id", list(&metadata["resolve"], "nodes"));
    let ours = packages
        .iter()
        .filter(|(_, package)| text(package, "name") == "dolmen-cli");
    let mut left: Vec<&str> = ours.map(|(id, _)| id.as_str()).collect();
    let mut seen = BTreeSet::new();
    while let Some(id) = left.pop() {
        if seen.insert(id) {
            let needs = list(&nodes[id], "deps").iter().filter(|need| {
                let kinds = list(need, "dep_kinds");
                kinds.iter().any(|kind| kind["kind"].is_null())
            });
            left.extend(needs.map(|need| text(need, "pkg")));
        }
    }
    let others = seen
        .into_iter()
        .map(|id| &packages[id])
        .filter(|package| !package["source"].is_null());
    others
        .map(|package| ["name", "version", "license"].map(|key| text(package, key).to_owned()))
        .collect()
}

#[test]
fn holds_third_parties_are_named_with_version_and_licence() {
    let named = fs::read_to_string(root().join("THIRD-PARTY.md")).unwrap();
    let rows = named
        .lines()
        .take_while(|line| !line.starts_with("## "))
        .filter_map(|line| line.strip_prefix("| "));
    let named: BTreeSet<[String; 3]> = rows
        .skip(1)
        .map(|row| {
            let mut cells = row.split(" | ").map(str::to_owned);
            [(); 3].map(|()| cells.next().unwrap_or_default())
        })
        .collect();
    let contained = contained(&metadata());
    assert!(contained.len() > 100, "{}", contained.len());
    let (missing, gone): (Vec<_>, Vec<_>) = (
        contained.difference(&named).collect(),
        named.difference(&contained).collect(),
    );
    assert!(
        missing.is_empty() && gone.is_empty(),
        "THIRD-PARTY.md lacks {missing:?} and has {gone:?}: run scripts/third-party"
    );
}

#[test]
fn holds_no_crate_has_an_advisory_that_was_not_excused() {
    let known = fs::read_to_string(root().join("data/advisories.csv")).unwrap();
    let excused = fs::read_to_string(root().join("deny.toml")).unwrap();
    let lock = fs::read_to_string(root().join("Cargo.lock")).unwrap();
    let mut versions: BTreeMap<&str, Vec<semver::Version>> = BTreeMap::new();
    for package in lock.split("[[package]]").skip(1) {
        let value = |key: &str| {
            package
                .lines()
                .find_map(|line| line.strip_prefix(key)?.split('"').nth(1))
        };
        let (name, version) = (value("name = ").unwrap(), value("version = ").unwrap());
        versions
            .entry(name)
            .or_default()
            .push(semver::Version::parse(version).unwrap());
    }
    let (mut looked_at, mut open) = (0, Vec::new());
    for row in known.lines().skip(2) {
        let mut cells = row.splitn(3, ',');
        let [id, name, free] = [(); 3].map(|()| cells.next().unwrap());
        let free: Vec<semver::VersionReq> = free
            .trim_matches('"')
            .split(" || ")
            .filter(|requirement| !requirement.is_empty())
            .map(|requirement| semver::VersionReq::parse(requirement).unwrap())
            .collect();
        for version in versions.get(name).into_iter().flatten() {
            looked_at += 1;
            if !free.iter().any(|free| free.matches(version)) && !excused.contains(id) {
                open.push(format!("{name} {version}: {id}"));
            }
        }
    }
    assert!(looked_at > 30, "{looked_at}");
    assert!(
        open.is_empty(),
        "raise their versions, do without, or excuse them in deny.toml with the reason: {open:#?}"
    );
}

#[test]
fn holds_every_manifest_of_ours_is_complete() {
    let metadata = metadata();
    let ours = list(&metadata, "packages")
        .iter()
        .filter(|package| package["source"].is_null());
    let mut read = 0;
    for package in ours {
        let name = text(package, "name");
        assert!(text(package, "description").len() > 20, "{name}: no description");
        assert_eq!(text(package, "license"), "MIT OR Apache-2.0", "{name}");
        assert!(
            !text(package, "rust_version").is_empty(),
            "{name}: no rust-version"
        );
        for key in ["keywords", "categories"] {
            let words = list(package, key);
            assert!(
                (1..=5).contains(&words.len()),
                "{name}: 1 to 5 {key}, not {}",
                words.len()
            );
            // what crates.io accepts
            let plain = |word: &str| {
                word.len() <= 20
                    && word
                        .chars()
                        .all(|c| c.is_ascii_lowercase() || "-0123456789".contains(c))
            };
            let taken = words.iter().all(|word| word.as_str().is_some_and(plain));
            assert!(taken || key == "categories", "{name}: {words:?}");
        }
        read += 1;
    }
    assert_eq!(read, 13, "crates of the workspace");
}
