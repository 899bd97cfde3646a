//! Keys that belong to another kind of structure.

use super::error::Fault;
use super::schema::KEYS_OF_KIND;
use toml::de::{DeTable, DeValue};

/// Keys of another kind: `storeys` in a chain.
pub(super) fn foreign_keys(root: &mut DeTable<'_>, faults: &mut Vec<Fault>) {
    let Some(kind) = root
        .get("kind")
        .and_then(|kind| kind.get_ref().as_str())
        .map(str::to_owned)
    else {
        return;
    };
    if kind != "survey" && KEYS_OF_KIND.iter().all(|(owner, _)| *owner != kind) {
        return; // a misspelled kind is one fault
    }
    if kind == "survey"
        && let Some((key, _)) = root.remove_entry("motion")
    {
        let message = "\"motion\" moves a structure, but this file has kind = \"survey\"";
        let fault = Fault::new(key.span(), "motion", message).allowed("has no meaning here");
        faults.push(fault.help("take it out, or write the kind of the structure with its parts"));
    }
    for (owner, keys) in KEYS_OF_KIND.iter().filter(|(owner, _)| *owner != kind) {
        for name in *keys {
            if let Some((key, _)) = root.remove_entry(*name) {
                let message =
                    format!("\"{name}\" belongs to kind = \"{owner}\", but this file has kind = \"{kind}\"");
                let help = format!("take it out, or write kind = \"{owner}\"");
                faults.push(
                    Fault::new(key.span(), name, message)
                        .allowed("has no meaning here")
                        .help(help),
                );
            }
        }
    }
    foreign_study_keys(root, &kind, faults);
}

/// Keys of a study that mean something for some kinds alone, with those kinds and their name.
const STUDY_KEYS: [(&str, &[&str], &str); 7] = [
    ("law", &["stack"], "stacks"),
    ("points", &["stack"], "stacks"),
    ("damage", &["stack"], "stacks"),
    ("direction", &["frame"], "frames"),
    ("harmonic", &["frame", "chain"], "frames and chains"),
    ("release", &["frame"], "frames"),
    ("drift_limits", &["building"], "buildings"),
];

fn foreign_study_keys(root: &mut DeTable<'_>, kind: &str, faults: &mut Vec<Fault>) {
    let Some(DeValue::Table(studies)) = root.get_mut("study").map(toml::Spanned::get_mut) else {
        return;
    };
    for (study, table) in studies.iter_mut() {
        let DeValue::Table(table) = table.get_mut() else {
            continue;
        };
        for (name, kinds, words) in STUDY_KEYS.iter().filter(|(_, kinds, _)| !kinds.contains(&kind)) {
            let Some((key, _)) = table.remove_entry(*name) else {
                continue;
            };
            let path = format!("study.{}.{name}", study.get_ref());
            let message = format!("{name} is for {words}, but this file has a {kind}");
            let help = match (*name, kinds) {
                ("direction", _) => "take it out; directions = [\"0 deg\", …] turn the motion",
                _ => "take it out",
            };
            faults.push(
                Fault::new(key.span(), &path, message)
                    .allowed("has no meaning here")
                    .help(help),
            );
        }
    }
}
