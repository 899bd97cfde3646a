//! Keys that belong to another kind of structure.

use super::error::Fault;
use super::schema::KEYS_OF_KIND;
use super::wrong::{Common, WrongFile};
use dolmen_words::message::Both;
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
        let message = WrongFile::MotionMovesStructureBut;
        let fault = Fault::new(key.span(), "motion", message).allowed(Common::NoMeaningHere);
        faults.push(fault.help(WrongFile::TakeItOutOr));
    }
    let own = KEYS_OF_KIND.iter().find(|(owner, _)| *owner == kind);
    let own = own.map_or(&[][..], |(_, keys)| keys);
    for (owner, keys) in KEYS_OF_KIND {
        for name in keys.iter().filter(|name| !own.contains(name)) {
            if let Some((key, _)) = root.remove_entry(*name) {
                let message = WrongFile::BelongsToKindBut {
                    name: name.to_string(),
                    owner: owner.to_string(),
                    kind: kind.to_string(),
                };
                let help = match (*name, kind.as_str()) {
                    ("damping_ratio", "building") => WrongFile::DampingOfBuilding,
                    _ => WrongFile::TakeItOutOrWrite(owner.to_string()),
                };
                faults.push(
                    Fault::new(key.span(), name, message)
                        .allowed(Common::NoMeaningHere)
                        .help(help)
                        .of_key(),
                );
            }
        }
    }
    foreign_study_keys(root, &kind, faults);
}

/// Keys of a study that have a meaning for some kinds only, with those kinds and their name.
const STUDY_KEYS: [(&str, &[&str], WrongFile); 7] = [
    ("law", &["stack"], WrongFile::Stacks),
    ("points", &["stack"], WrongFile::Stacks),
    ("damage", &["stack"], WrongFile::Stacks),
    ("direction", &["frame"], WrongFile::Frames),
    ("harmonic", &["frame", "chain"], WrongFile::FramesAndChains),
    ("release", &["frame"], WrongFile::Frames),
    ("drift_limits", &["building"], WrongFile::Buildings),
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
            let message = WrongFile::IsForButThis {
                name: name.to_string(),
                words: words.clone().into(),
                kind: kind.to_string(),
            };
            let help: Both = match (*name, kinds) {
                ("direction", _) => WrongFile::TakeItOutDirections.into(),
                _ => Common::TakeItOut.into(),
            };
            faults.push(
                Fault::new(key.span(), &path, message)
                    .allowed(Common::NoMeaningHere)
                    .help(help),
            );
        }
    }
}
