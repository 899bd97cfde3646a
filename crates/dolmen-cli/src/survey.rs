//! `dolmen survey`: a store of surveys over years.

use crate::cli_survey::{Add, Export, Import, List, Remove, Show, StoreWhere, Survey, SurveyAction};
use crate::manner::Manner;
use crate::outcome::Outcome;
use crate::progress::Terminal;
use crate::say::{say, say_json};
use crate::wrong::CommandError;
use anyhow::{Context as _, Result};
use dolmen_folder::Found;
use dolmen_follow::{add_project, export_project, now_us, take_over};
use dolmen_report::as_json;
use dolmen_report::kept::{
    ListFormat, Listing, StructureList, SurveyList, added_text, exported_text, imported_text, marked_text,
    store_fault, structure_text, verified_text,
};
use dolmen_store::{Act, Place, Search, Store, StoreError};
use dolmen_work::Progress;
use std::path::PathBuf;
use std::time::Duration;

/// Exit status of a store with faults.
const UNSOUND: u8 = 1;

pub(crate) fn run(options: &Survey, manner: &Manner) -> Result<Outcome> {
    let at = StoreAccess {
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

/// The store, and how answers are printed.
pub(crate) struct StoreAccess<'a> {
    pub(crate) options: &'a StoreWhere,
    pub(crate) manner: &'a Manner,
}

fn variable(name: &str) -> Option<String> {
    std::env::var(name).ok().filter(|value| !value.is_empty())
}

impl StoreAccess<'_> {
    /// A fault of a store in the language of the user.
    pub(crate) fn store_failure(&self, fault: StoreError) -> anyhow::Error {
        CommandError::Store {
            fault: store_fault(&fault.fault()).into(),
        }
        .into()
    }

    pub(crate) fn place(&self) -> Result<Place> {
        let named = self.options.store.clone().or_else(|| variable("DOLMEN_STORE"));
        self.place_of(&named.unwrap_or_default())
    }

    /// The place that the user names; its password may come from where psql looks for one.
    fn place_of(&self, named: &str) -> Result<Place> {
        let place = Place::of(named).map_err(|fault| self.store_failure(fault))?;
        let file = variable("PGPASSFILE").map(PathBuf::from);
        let file = file.or_else(|| Some(PathBuf::from(variable("HOME")?).join(".pgpass")));
        Ok(place.with_password(variable("PGPASSWORD"), file.as_deref()))
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
        Store::open(&self.place()?, self.wait()).map_err(|fault| self.store_failure(fault))
    }

    pub(crate) fn open_to_write(&self) -> Result<Store> {
        Store::open_to_write(&self.place()?, self.wait(), now_us()).map_err(|fault| self.store_failure(fault))
    }
}

fn add(options: &Add, at: &StoreAccess<'_>) -> Result<Outcome> {
    if options.name.is_some() && options.projects.len() > 1 {
        return Err(CommandError::OneName.into());
    }
    let mut store = at.open_to_write()?;
    for path in &options.projects {
        let found = at.manner.open(path)?;
        let context = || path.display().to_string();
        add_one(&mut store, options, &found, at).with_context(context)?;
    }
    Ok(Outcome::Done)
}

fn add_one(store: &mut Store, options: &Add, found: &Found, at: &StoreAccess<'_>) -> Result<()> {
    let terminal = Terminal::new(at.manner.quiet);
    let progress: Option<&dyn Progress> = (!options.without_modes).then_some(&terminal);
    let added = add_project(store, found, options.name.as_deref(), &at.who(), progress)?;
    // printed only when it is on disk
    match at.manner.json {
        true => say(&format!("{}\n", as_json!(added))),
        false => say(&added_text(&added, at.manner.style())),
    }
}

fn search(options: &List) -> Search {
    Search {
        words: options.words.clone().unwrap_or_default(),
        with_removed: options.removed,
    }
}

fn list(options: &List, at: &StoreAccess<'_>) -> Result<Outcome> {
    let mut store = at.open()?;
    let store_failure = |fault| at.store_failure(fault);
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
                .map_err(store_failure)?;
            say(&all.text(at.manner.style()))?;
        }
        (None, true) => {
            let mut all = SurveyList::default();
            store
                .surveys(&search, &mut |row| {
                    all.push(row);
                    Ok(())
                })
                .map_err(store_failure)?;
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
            store.structures(&search, each).map_err(store_failure)?;
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
            store.surveys(&search, each).map_err(store_failure)?;
            say(format.tail())?;
        }
    }
    Ok(Outcome::Done)
}

fn show(options: &Show, at: &StoreAccess<'_>) -> Result<Outcome> {
    let mut store = at.open()?;
    let kept = store.structure(&options.name, options.survey.as_deref());
    let kept = kept.map_err(|fault| at.store_failure(fault))?;
    match at.manner.json {
        true => say_json(&as_json!(kept))?,
        false => say(&structure_text(&kept, at.manner.style()))?,
    }
    Ok(Outcome::Done)
}

fn export(options: &Export, at: &StoreAccess<'_>) -> Result<Outcome> {
    match &options.name {
        Some(name) => export_one(name, options, at),
        None => export_all(options, at),
    }
}

fn export_one(name: &str, options: &Export, at: &StoreAccess<'_>) -> Result<Outcome> {
    let files = export_project(&mut at.open()?, name, &options.output)?;
    let folder = options.output.display().to_string();
    match at.manner.json {
        true => say_json(&as_json!({ "structure": name, "folder": folder, "files": files }))?,
        false => say(&exported_text(name, &folder, files.len(), at.manner.style()))?,
    }
    Ok(Outcome::Done)
}

/// Exports a whole store as a file with its folder.
fn export_all(options: &Export, at: &StoreAccess<'_>) -> Result<Outcome> {
    if Place::is_server(&options.output.to_string_lossy()) {
        return Err(CommandError::StoreIsServer.into());
    }
    if options.output.exists() {
        return Err(CommandError::StoreThere {
            path: options.output.display().to_string(),
        }
        .into());
    }
    let from = at.open()?;
    let into = at.place_of(&options.output.to_string_lossy())?;
    taken_over(from, &into, at)
}

fn import(options: &Import, at: &StoreAccess<'_>) -> Result<Outcome> {
    let from =
        Store::open(&at.place_of(&options.from)?, at.wait()).map_err(|fault| at.store_failure(fault))?;
    taken_over(from, &at.place()?, at)
}

fn taken_over(mut from: Store, into: &Place, at: &StoreAccess<'_>) -> Result<Outcome> {
    let into = Store::open_to_write(into, at.wait(), now_us());
    let done = take_over(
        &mut from,
        &mut into.map_err(|fault| at.store_failure(fault))?,
        &at.who(),
    )?;
    match at.manner.json {
        true => say_json(&as_json!(done))?,
        false => say(&imported_text(&done, at.manner.style()))?,
    }
    Ok(Outcome::Done)
}

fn verify(at: &StoreAccess<'_>) -> Result<Outcome> {
    let found = at.open()?.verify().map_err(|fault| at.store_failure(fault))?;
    match at.manner.json {
        true => say_json(&as_json!(found))?,
        false => say(&verified_text(&found, at.manner.style()))?,
    }
    match found.faults.is_empty() {
        true => Ok(Outcome::Done),
        false => Ok(Outcome::Judged(UNSOUND)),
    }
}

fn remove(options: &Remove, at: &StoreAccess<'_>) -> Result<Outcome> {
    let store_failure = |fault| at.store_failure(fault);
    let place = at.place()?;
    Store::open(&place, at.wait()).map_err(store_failure)?; // the store must exist
    let mut store = at.open_to_write()?;
    let who = at.who();
    let act = Act {
        who: &who,
        now_us: now_us(),
    };
    let is_removed = !options.undo;
    store
        .mark(&options.name, is_removed, &options.why, &act)
        .map_err(store_failure)?;
    match at.manner.json {
        true => say_json(&as_json!({ "structure": options.name, "is_removed": is_removed }))?,
        false => say(&marked_text(&options.name, is_removed, at.manner.style()))?,
    }
    Ok(Outcome::Done)
}
