//! `dolmen survey`: a store of surveys over years.

use crate::cli_survey::{Add, Export, Import, List, Remove, Show, StoreWhere, Survey, SurveyAction};
use crate::manner::Manner;
use crate::outcome::Outcome;
use crate::progress::Terminal;
use crate::say::{say, say_json};
use crate::wrong::CommandError;
use anyhow::{Context as _, Result};
use dolmen_folder::{Found, fresh_folder, write};
use dolmen_follow::now_us;
use dolmen_records::{Files as _, RECORD_BYTES_MOST};
use dolmen_report::kept::{
    ListFormat, Listing, StructureList, SurveyList, added_text, exported_text, imported_text, marked_text,
    store_fault, structure_text, verified_text,
};
use dolmen_store::{Act, Exported, Incoming, PROJECT_FILE, Place, Search, Store, StoreError};
use dolmen_work::kept::Unidentified;
use dolmen_work::survey_modes;
use serde_json::json;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::time::Duration;

/// Exit status where a store is not what it was.
const UNSOUND: u8 = 1;

pub(crate) fn run(options: &Survey, manner: &Manner) -> Result<Outcome> {
    let at = Where {
        options: &options.place,
        manner,
    };
    match &options.action {
        SurveyAction::Add(options) => add(options, &at),
        SurveyAction::List(options) => list(options, &at),
        SurveyAction::Show(options) => show(options, &at),
        SurveyAction::Export(options) => export(options, &at),
        SurveyAction::Import(options) => import(options, &at),
        SurveyAction::Verify => verify(&at),
        SurveyAction::Remove(options) => remove(options, &at),
    }
}

/// The store, and the manner of the answers.
pub(crate) struct Where<'a> {
    pub(crate) options: &'a StoreWhere,
    pub(crate) manner: &'a Manner,
}

fn variable(name: &str) -> Option<String> {
    std::env::var(name).ok().filter(|value| !value.is_empty())
}

impl Where<'_> {
    /// A fault of a store in the language of the user.
    pub(crate) fn told(&self, fault: StoreError) -> anyhow::Error {
        CommandError::Store {
            fault: store_fault(&fault.fault()).into(),
        }
        .into()
    }

    /// The file of the store as it was named.
    pub(crate) fn file(&self) -> String {
        let named = self.options.store.clone().or_else(|| variable("DOLMEN_STORE"));
        named.unwrap_or_default()
    }

    pub(crate) fn place(&self) -> Result<Place> {
        Place::of(&self.file()).map_err(|fault| self.told(fault))
    }

    pub(crate) fn wait(&self) -> Duration {
        Duration::from_secs_f64(self.options.wait.min(1e6))
    }

    pub(crate) fn who(&self) -> String {
        let user = ["USER", "LOGNAME", "USERNAME"].into_iter().find_map(variable);
        let named = self.options.who.clone().or(user);
        named.unwrap_or_else(|| "unknown".to_owned())
    }

    pub(crate) fn open(&self) -> Result<Store> {
        Store::open(&self.place()?, self.wait()).map_err(|fault| self.told(fault))
    }

    pub(crate) fn open_to_write(&self) -> Result<Store> {
        Store::open_to_write(&self.place()?, self.wait(), now_us()).map_err(|fault| self.told(fault))
    }
}

fn add(options: &Add, at: &Where<'_>) -> Result<Outcome> {
    if options.name.is_some() && options.projects.len() > 1 {
        return Err(CommandError::OneName.into());
    }
    let mut store = at.open_to_write()?;
    for path in &options.projects {
        let found = Found::open(path, at.manner.access())?;
        let context = || path.display().to_string();
        add_one(&mut store, options, &found, at).with_context(context)?;
    }
    Ok(Outcome::Done)
}

fn add_one(store: &mut Store, options: &Add, found: &Found, at: &Where<'_>) -> Result<()> {
    let project = &found.opened.project;
    let told = |fault| at.told(fault);
    let structure = options.name.as_deref().unwrap_or(project.name.english()).trim();
    let text_kept = store.keep(found.opened.text.as_bytes()).map_err(told)?;
    let mut kept = BTreeMap::new();
    for name in named_files(found) {
        let bytes = found
            .files
            .read(&name, RECORD_BYTES_MOST)
            .map_err(dolmen_work::WorkError::from)?;
        kept.insert(name, store.keep(&bytes).map_err(told)?);
    }
    let mut incoming = Incoming {
        structure,
        project,
        text: &found.opened.text,
        text_kept,
        files: kept,
        modes: BTreeMap::new(),
        faults: BTreeMap::new(),
    };
    let mut unidentified = Vec::new();
    if !options.without_modes {
        for survey in store.due(&incoming).map_err(told)? {
            let progress = Terminal::new(at.manner.quiet);
            match survey_modes(project, &survey, &found.files, &progress) {
                Ok(Some(found)) => {
                    incoming.faults.insert(survey.clone(), found.faults);
                    incoming.modes.insert(survey, found.modes);
                }
                Ok(None) => {}
                Err(why) => unidentified.push(Unidentified {
                    survey,
                    why: dolmen_work::told(&why),
                }),
            }
        }
    }
    let who = at.who();
    let act = Act {
        who: &who,
        now_us: now_us(),
    };
    let mut added = store.add(&incoming, &act).map_err(told)?;
    added.unidentified = unidentified;
    // said only now that it is on disk
    match at.manner.json {
        true => say(&format!("{}\n", json!(added))),
        false => say(&added_text(&added, at.manner.style())),
    }
}

/// Every text of the project file that is the name of a file in its folder: records, motions, meshes, tables, and whatever else is
/// named by later versions. Records must be there.
fn named_files(found: &Found) -> BTreeSet<String> {
    let mut names: BTreeSet<String> = dolmen_project::texts(&found.opened.text)
        .into_iter()
        .filter(|name| found.files.holds(name))
        .collect();
    let surveys = found.opened.project.surveys.iter();
    for source in surveys.flat_map(|survey| survey.records.iter().chain(&survey.setups)) {
        match source.stations.as_slice() {
            [] => names.insert(source.file.clone()),
            stations => {
                names.extend(stations.iter().map(|station| station.file.clone()));
                false
            }
        };
    }
    names
}

fn search(options: &List) -> Search {
    Search {
        words: options.words.clone().unwrap_or_default(),
        with_removed: options.removed,
    }
}

fn list(options: &List, at: &Where<'_>) -> Result<Outcome> {
    let mut store = at.open()?;
    let told = |fault| at.told(fault);
    let unsaid = |fault: anyhow::Error| StoreError::Reader(format!("{fault:#}"));
    let format = match (at.manner.json, options.csv, options.geojson) {
        (true, ..) => Some(ListFormat::Json),
        (_, true, _) => Some(ListFormat::Csv),
        (.., true) => Some(ListFormat::GeoJson),
        _ => None,
    };
    let search = search(options);
    let mut is_first = true;
    match (format, options.surveys) {
        (None, false) => {
            let mut all = StructureList::default();
            store
                .structures(&search, &mut |row| {
                    all.push(row);
                    Ok(())
                })
                .map_err(told)?;
            say(&all.text(at.manner.style()))?;
        }
        (None, true) => {
            let mut all = SurveyList::default();
            store
                .surveys(&search, &mut |row| {
                    all.push(row);
                    Ok(())
                })
                .map_err(told)?;
            say(&all.text(at.manner.style()))?;
        }
        (Some(format), false) => {
            say(&format.head(Listing::Structures))?;
            let each = &mut |row| match format.structure(&row, is_first) {
                Some(text) => {
                    is_first = false;
                    say(&text).map_err(unsaid)
                }
                None => Ok(()),
            };
            store.structures(&search, each).map_err(told)?;
            say(format.tail())?;
        }
        (Some(format), true) => {
            say(&format.head(Listing::Surveys))?;
            let each = &mut |row| match format.survey(&row, is_first) {
                Some(text) => {
                    is_first = false;
                    say(&text).map_err(unsaid)
                }
                None => Ok(()),
            };
            store.surveys(&search, each).map_err(told)?;
            say(format.tail())?;
        }
    }
    Ok(Outcome::Done)
}

fn show(options: &Show, at: &Where<'_>) -> Result<Outcome> {
    let mut store = at.open()?;
    let kept = store.structure(&options.name, options.survey.as_deref());
    let kept = kept.map_err(|fault| at.told(fault))?;
    match at.manner.json {
        true => say_json(&json!(kept))?,
        false => say(&structure_text(&kept, at.manner.style()))?,
    }
    Ok(Outcome::Done)
}

fn export(options: &Export, at: &Where<'_>) -> Result<Outcome> {
    match &options.name {
        Some(name) => export_one(name, options, at),
        None => export_all(options, at),
    }
}

fn export_one(name: &str, options: &Export, at: &Where<'_>) -> Result<Outcome> {
    let mut store = at.open()?;
    let exported = store.export(name).map_err(|fault| at.told(fault))?;
    let was_there = options.output.exists();
    fresh_folder(&options.output)?;
    if let Err(why) = fill(&options.output, &store, &exported, at) {
        if !was_there {
            let _ = std::fs::remove_dir_all(&options.output); // ours: it was not there
        }
        return Err(why);
    }
    let folder = options.output.display().to_string();
    match at.manner.json {
        true => say_json(&json!({
            "structure": name, "folder": folder, "files": exported.files.iter().map(|(path, ..)| path).collect::<Vec<_>>(),
        }))?,
        false => say(&exported_text(
            name,
            &folder,
            exported.files.len(),
            at.manner.style(),
        ))?,
    }
    Ok(Outcome::Done)
}

/// Writes the files first: a folder with a project file is whole.
fn fill(folder: &Path, store: &Store, exported: &Exported, at: &Where<'_>) -> Result<()> {
    for (path, hash, bytes) in &exported.files {
        let parts = path.split(['/', '\\']).filter(|part| *part != ".");
        let target = parts.fold(folder.to_owned(), |target, part| target.join(part));
        write(&target, &store.raw(hash, *bytes).map_err(|fault| at.told(fault))?)?;
    }
    write(&folder.join(PROJECT_FILE), &exported.text)
}

/// A whole store as a file of its own, with its folder.
fn export_all(options: &Export, at: &Where<'_>) -> Result<Outcome> {
    if options.output.exists() {
        return Err(CommandError::StoreThere {
            path: options.output.display().to_string(),
        }
        .into());
    }
    let from = at.open()?;
    let into = Place::of(&options.output.to_string_lossy()).map_err(|fault| at.told(fault))?;
    take_over(from, &into, at)
}

fn import(options: &Import, at: &Where<'_>) -> Result<Outcome> {
    let from = Place::of(&options.from).map_err(|fault| at.told(fault))?;
    let from = Store::open(&from, at.wait()).map_err(|fault| at.told(fault))?;
    take_over(from, &at.place()?, at)
}

fn take_over(mut from: Store, into: &Place, at: &Where<'_>) -> Result<Outcome> {
    let told = |fault| at.told(fault);
    let mut into = Store::open_to_write(into, at.wait(), now_us()).map_err(told)?;
    let who = at.who();
    let act = Act {
        who: &who,
        now_us: now_us(),
    };
    let done = into.import(&mut from, &act).map_err(told)?;
    match at.manner.json {
        true => say_json(&json!(done))?,
        false => say(&imported_text(&done, at.manner.style()))?,
    }
    Ok(Outcome::Done)
}

fn verify(at: &Where<'_>) -> Result<Outcome> {
    let found = at.open()?.verify().map_err(|fault| at.told(fault))?;
    match at.manner.json {
        true => say_json(&json!(found))?,
        false => say(&verified_text(&found, at.manner.style()))?,
    }
    match found.faults.is_empty() {
        true => Ok(Outcome::Done),
        false => Ok(Outcome::Judged(UNSOUND)),
    }
}

fn remove(options: &Remove, at: &Where<'_>) -> Result<Outcome> {
    let told = |fault| at.told(fault);
    let place = at.place()?;
    Store::open(&place, at.wait()).map_err(told)?; // a store that is not there is not made
    let mut store = at.open_to_write()?;
    let who = at.who();
    let act = Act {
        who: &who,
        now_us: now_us(),
    };
    let is_removed = !options.undo;
    store
        .mark(&options.name, is_removed, &options.why, &act)
        .map_err(told)?;
    match at.manner.json {
        true => say_json(&json!({ "structure": options.name, "is_removed": is_removed }))?,
        false => say(&marked_text(&options.name, is_removed, at.manner.style()))?,
    }
    Ok(Outcome::Done)
}
