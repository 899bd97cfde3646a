//! A store: a database, and the folder of the raw files.

use crate::database::{Access, Database, Value, all, transaction};
use crate::error::StoreError;
use crate::incoming::{Group, Incoming, SurveyTables, refuse_name};
use crate::place::{Location, Place, files_of};
use crate::raw::{Kept, RawFiles};
use crate::raw_folder::RawFolder;
use crate::rows::{AdoptionRow, LogRow, MarkRow, ProjectRow, StructureRow, SurveyRow, insert, select};
use crate::schema::{is_current, migrate};
#[cfg(feature = "postgres")]
use crate::server::{Pieces, Session};
use crate::sqlite::Sqlite;
use dolmen_words::nearest;
use dolmen_work::kept::{Added, StoreFault};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use std::time::Duration;

/// A store.
pub struct Store {
    pub(crate) database: Box<dyn Database>,
    pub(crate) raw: Arc<dyn RawFiles>,
    can_write: bool,
}

/// Who acts, and when.
#[derive(Clone, Debug)]
pub struct Act<'a> {
    /// Name of the person.
    pub who: &'a str,
    /// Microseconds since 1970 (UTC).
    pub now_us: i64,
}

impl Store {
    /// Opens a store for reading; it changes nothing.
    ///
    /// # Errors
    /// If there is none, or it belongs to another program or a later version.
    pub fn open(place: &Place, wait: Duration) -> Result<Self, StoreError> {
        let mut database = connect(place, Access::Read, wait)?;
        let raw = raw_files(place, Access::Read, wait);
        if !is_current(database.as_mut())? {
            // created by an earlier version, or not finished
            let mut writing = connect(place, Access::Write, wait)?;
            migrate(writing.as_mut(), 0, &raw)?;
            database = connect(place, Access::Read, wait)?;
        }
        Ok(Store {
            database,
            raw,
            can_write: false,
        })
    }

    /// Opens a store for writing; creates it if it does not exist.
    ///
    /// # Errors
    /// As [`Store::open`], and if nothing can be written.
    pub fn open_to_write(place: &Place, wait: Duration, now_us: i64) -> Result<Self, StoreError> {
        let mut database = connect(place, Access::Write, wait)?;
        let raw = raw_files(place, Access::Write, wait);
        migrate(database.as_mut(), now_us, &raw)?;
        raw.prepare()?;
        Ok(Store {
            database,
            raw,
            can_write: true,
        })
    }

    /// Whether it was opened for writing.
    pub(crate) fn can_write(&self) -> bool {
        self.can_write
    }

    /// Stores the bytes of a file. They are on disk when this returns, but no row refers to them yet.
    ///
    /// # Errors
    /// If nothing can be written.
    pub fn keep(&self, bytes: &[u8]) -> Result<Kept, StoreError> {
        match self.can_write {
            true => self.raw.keep(bytes),
            false => Err(StoreFault::ReadOnly.into()),
        }
    }

    /// Surveys with records that have no modes yet for these records, settings and version.
    ///
    /// # Errors
    /// If the database cannot be read.
    pub fn due(&mut self, incoming: &Incoming<'_>) -> Result<Vec<String>, StoreError> {
        let known = known(self.database.as_mut(), incoming)?;
        let tables = SurveyTables::of(incoming.text)?;
        let surveys = incoming.project.surveys.iter();
        let is_due = |survey: &&dolmen_project::Survey| {
            let key = incoming.key(survey, &tables);
            key.is_some_and(|key| !known.contains(&key.hash()))
        };
        Ok(surveys.filter(is_due).map(|survey| survey.name.clone()).collect())
    }

    /// Adds a project in one transaction: when this returns, it is on disk.
    ///
    /// # Errors
    /// If a name is not allowed, the name belongs to another kind, or the database cannot be written.
    pub fn add(&mut self, incoming: &Incoming<'_>, act: &Act<'_>) -> Result<Added, StoreError> {
        incoming.refuse()?;
        refuse_name("who", act.who)?;
        transaction(self.database.as_mut(), |database| add(database, incoming, act))
    }

    /// Marks a structure as out of use, or as in use again; nothing is deleted.
    ///
    /// # Errors
    /// If there is no such structure.
    pub fn mark(
        &mut self,
        structure: &str,
        is_removed: bool,
        why: &str,
        act: &Act<'_>,
    ) -> Result<(), StoreError> {
        refuse_name("who", act.who)?;
        if !why.is_empty() {
            refuse_name("why", why)?;
        }
        transaction(self.database.as_mut(), |database| {
            refuse_unknown(database, structure)?;
            let at_us = next(database, act.now_us)?;
            set_mark(database, structure, is_removed, why, (act.who, at_us))
        })
    }
}

fn connect(place: &Place, access: Access, wait: Duration) -> Result<Box<dyn Database>, StoreError> {
    Ok(match place.place() {
        Location::File(file) => Box::new(Sqlite::open(file, access, wait)?),
        #[cfg(feature = "postgres")]
        Location::Server(address) => Box::new(Session::open(address, access, wait)?),
    })
}

#[cfg_attr(
    not(feature = "postgres"),
    allow(
        unused_variables,
        reason = "a folder is opened by no one, and nobody waits for it"
    )
)]
fn raw_files(place: &Place, access: Access, wait: Duration) -> Arc<dyn RawFiles> {
    match place.place() {
        Location::File(file) => Arc::new(RawFolder::new(files_of(file))),
        #[cfg(feature = "postgres")]
        Location::Server(address) => Arc::new(Pieces::new(address, access, wait)),
    }
}

/// Refuses a structure that does not exist, and gives the most similar name.
pub(crate) fn refuse_unknown(database: &mut dyn Database, name: &str) -> Result<(), StoreError> {
    let named = [Value::Text(name.to_owned())];
    if !select::<StructureRow>(database, "where name = $1", &named)?.is_empty() {
        return Ok(());
    }
    let mut names = Vec::new();
    for row in all(database, "select name from structure order by name", &[])? {
        if let [Value::Text(name)] = row.as_slice() {
            names.push(name.clone());
        }
    }
    let close = nearest(name, names.iter().map(String::as_str));
    Err(StoreFault::NoStructure {
        name: name.chars().filter(|sign| !sign.is_control()).collect(),
        nearest: close.map(str::to_owned),
    }
    .into())
}

/// A time after that of every row, even if the clock is behind, so that the order of events is kept.
pub(crate) fn next(database: &mut dyn Database, now_us: i64) -> Result<i64, StoreError> {
    let sql = "select max(at_us) from (select max(at_us) as at_us from adoption union all select max(at_us) from mark \
               union all select max(at_us) from log) as moments";
    let rows = all(database, sql, &[])?;
    Ok(match rows.first().map(Vec::as_slice) {
        Some([Value::Whole(last)]) => now_us.max(last + 1),
        _ => now_us,
    })
}

fn set_mark(
    database: &mut dyn Database,
    structure: &str,
    is_removed: bool,
    why: &str,
    (who, at_us): (&str, i64),
) -> Result<(), StoreError> {
    insert(
        database,
        &MarkRow {
            structure: structure.to_owned(),
            at_us,
            is_removed,
            who: who.to_owned(),
            why: why.to_owned(),
        },
    )?;
    let log = LogRow {
        at_us,
        who: who.to_owned(),
        verb: if is_removed { "remove" } else { "restore" }.to_owned(),
        subject: structure.to_owned(),
        detail: why.to_owned(),
    };
    insert(database, &log).map(|_| ())
}

/// Whether the latest mark removes the structure from use.
fn is_removed(database: &mut dyn Database, structure: &str) -> Result<bool, StoreError> {
    let condition = "where structure = $1 order by at_us desc limit 1";
    let marks: Vec<MarkRow> = select(database, condition, &[Value::Text(structure.to_owned())])?;
    Ok(marks.first().is_some_and(|mark| mark.is_removed))
}

/// Stored analyses of the records of a project.
fn known(database: &mut dyn Database, incoming: &Incoming<'_>) -> Result<BTreeSet<String>, StoreError> {
    let tables = SurveyTables::of(incoming.text)?;
    let mut known = BTreeSet::new();
    for survey in &incoming.project.surveys {
        if let Some(key) = incoming.key(survey, &tables) {
            let hash = key.hash();
            let sql = "select count(*) from analysis where hash = $1";
            let rows = all(database, sql, &[Value::Text(hash.clone())])?;
            if rows != [[Value::Whole(0)]] {
                known.insert(hash);
            }
        }
    }
    Ok(known)
}

/// Adds the missing rows of a group; returns whether its first row was added.
pub(crate) fn put(database: &mut dyn Database, Group(rows): &Group) -> Result<bool, StoreError> {
    let Some(((table, head), parts)) = rows.split_first() else {
        return Ok(false);
    };
    if !table.insert(database, head)? {
        return Ok(false);
    }
    for (table, part) in parts {
        table.insert(database, part)?;
    }
    Ok(true)
}

/// The surveys of a state of a project by name, each with its hash.
fn surveys_of(database: &mut dyn Database, project: &str) -> Result<BTreeMap<String, String>, StoreError> {
    let of = [Value::Text(project.to_owned())];
    let sql = "where hash in (select survey from project_survey where project = $1)";
    let rows: Vec<SurveyRow> = select(database, sql, &of)?;
    Ok(rows.into_iter().map(|row| (row.name, row.hash)).collect())
}

/// The text of the first column of the first row.
fn first_text(
    database: &mut dyn Database,
    sql: &str,
    values: &[Value],
) -> Result<Option<String>, StoreError> {
    let rows = all(database, sql, values)?;
    Ok(rows.into_iter().flatten().find_map(|value| match value {
        Value::Text(text) => Some(text),
        _ => None,
    }))
}

/// Another structure whose name differs only in case or in spaces at its ends.
fn named_like(database: &mut dyn Database, structure: &str) -> Result<Option<String>, StoreError> {
    let sql = "select name from structure where lower(trim(name)) = lower(trim($1)) and name <> $1 order by name limit 1";
    first_text(database, sql, &[Value::Text(structure.to_owned())])
}

/// Refuses a project of another kind than those kept of its structure.
fn refuse_other_kind(database: &mut dyn Database, structure: &str, kind: &str) -> Result<(), StoreError> {
    let named = [Value::Text(structure.to_owned())];
    let projects: Vec<ProjectRow> = select(database, "where structure = $1 order by hash limit 1", &named)?;
    match projects.first() {
        Some(project) if project.kind != kind => Err(StoreFault::OtherKind {
            name: structure.to_owned(),
            kept: project.kind.clone(),
            given: kind.to_owned(),
        }
        .into()),
        _ => Ok(()),
    }
}

fn add(database: &mut dyn Database, incoming: &Incoming<'_>, act: &Act<'_>) -> Result<Added, StoreError> {
    let structure = incoming.structure.to_owned();
    let named = [Value::Text(structure.clone())];
    refuse_other_kind(database, &structure, incoming.kind())?;
    let at_us = next(database, act.now_us)?;
    let who = act.who.to_owned();
    let is_new = insert(
        database,
        &StructureRow {
            name: structure.clone(),
            at_us,
            who: who.clone(),
        },
    )?;
    let known = known(database, incoming)?;
    let mut added = Added {
        structure: structure.clone(),
        project: incoming.hash(),
        is_new_state: false,
        surveys: incoming.project.surveys.len(),
        new_surveys: 0,
        files: incoming.files.len() + 1,
        new_files: 0,
        new_analyses: 0,
        unidentified: Vec::new(),
        earthquakes: Vec::new(),
        changed_surveys: Vec::new(),
        gone_surveys: Vec::new(),
        named_like: None,
    };
    if is_new {
        added.named_like = named_like(database, &structure)?;
    }
    for group in incoming.rows(&known, act.who, at_us)?.0 {
        let table = group.0.first().map_or("", |(table, _)| table.name);
        if put(database, &group)? {
            match table {
                "raw" => added.new_files += 1,
                "survey" => added.new_surveys += 1,
                "analysis" => added.new_analyses += 1,
                "project" => added.is_new_state = true,
                _ => {}
            }
        }
    }
    let last = "where structure = $1 order by at_us desc limit 1";
    let last: Vec<AdoptionRow> = select(database, last, &named)?;
    let is_adopted = last.first().is_some_and(|last| last.project == added.project);
    if let Some(before) = last.first().filter(|_| !is_adopted) {
        let before = surveys_of(database, &before.project)?;
        let now = surveys_of(database, &added.project)?;
        for (name, hash) in &before {
            match now.get(name) {
                None => added.gone_surveys.push(name.clone()),
                Some(other) if other != hash => added.changed_surveys.push(name.clone()),
                Some(_) => {}
            }
        }
    }
    if !is_adopted {
        insert(
            database,
            &AdoptionRow {
                structure: structure.clone(),
                at_us,
                project: added.project.clone(),
                who: who.clone(),
            },
        )?;
    }
    if is_removed(database, &structure)? {
        set_mark(database, &structure, false, "added again", (act.who, at_us))?;
    }
    if is_new || !is_adopted || added.new_analyses > 0 {
        let detail = format!(
            "{} surveys, {} new; {} files, {} new; {} analyses new",
            added.surveys, added.new_surveys, added.files, added.new_files, added.new_analyses
        );
        insert(
            database,
            &LogRow {
                at_us,
                who,
                verb: "add".to_owned(),
                subject: structure,
                detail,
            },
        )?;
    }
    Ok(added)
}
