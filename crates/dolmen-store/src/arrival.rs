//! Records from a watched folder: each is stored once, as a survey of its own, in one transaction.

use crate::database::{Database, Value, all, transaction};
use crate::error::StoreError;
use crate::incoming::{Incoming, SurveyTables, analysis, refuse_name, refuse_path, shown};
use crate::raw::{Kept, RawFiles};
use crate::rows::{AdoptionRow, ArrivalRow, LogRow, RawRow, SurveyAnalysisRow, insert, select};
use crate::store::{Act, Store, next, put, refuse_unknown};
use dolmen_work::kept::StoreFault;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The verb that marks a call of the alarm in the log.
const ALARM: &str = "alarm";

/// A record to be stored as a survey of its own.
#[derive(Clone, Debug)]
pub struct Arriving<'a> {
    /// The project including the survey, the record file under the path that the project names, and the modes, if any were found.
    pub incoming: Incoming<'a>,
    /// The survey.
    pub survey: &'a str,
    /// The survey's table, as text of a project file.
    pub own_text: &'a str,
    /// Original name of the file.
    pub came_as: &'a str,
}

/// Outcome for a record.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arrived {
    /// It is on disk.
    Stored,
    /// A survey of the structure already has this record.
    There,
    /// Another survey of the structure has this name.
    NameTaken,
}

/// Stores the bytes of files, from any thread.
#[derive(Clone, Debug)]
pub struct Keeper(Arc<dyn RawFiles>);

impl Keeper {
    /// As [`Store::keep`].
    ///
    /// # Errors
    /// If nothing can be written.
    pub fn keep(&self, bytes: &[u8]) -> Result<Kept, StoreError> {
        self.0.keep(bytes)
    }
}

impl Store {
    /// A handle that stores files from several threads.
    ///
    /// # Errors
    /// If the store was opened for reading.
    pub fn keeper(&self) -> Result<Keeper, StoreError> {
        match self.can_write() {
            true => Ok(Keeper(self.raw.clone())),
            false => Err(StoreFault::ReadOnly.into()),
        }
    }

    /// The latest state of the project of a structure.
    ///
    /// # Errors
    /// If there is no such structure.
    pub fn state(&mut self, structure: &str) -> Result<String, StoreError> {
        let database = self.database.as_mut();
        refuse_unknown(database, structure)?;
        let condition = "where structure = $1 order by at_us desc limit 1";
        let rows: Vec<AdoptionRow> = select(database, condition, &[Value::Text(structure.to_owned())])?;
        let row = rows.into_iter().next();
        row.map(|row| row.project).ok_or_else(|| {
            let name = structure.to_owned();
            StoreFault::NoStructure { name, nearest: None }.into()
        })
    }

    /// Number of records of a structure from watched folders.
    ///
    /// # Errors
    /// If the database cannot be read.
    pub fn arrivals(&mut self, structure: &str) -> Result<u64, StoreError> {
        let sql = "select count(*) from arrival where structure = $1";
        let rows = all(self.database.as_mut(), sql, &[Value::Text(structure.to_owned())])?;
        Ok(match rows.first().map(Vec::as_slice) {
            Some([Value::Whole(count)]) => u64::try_from(*count).unwrap_or(0),
            _ => 0,
        })
    }

    /// Hashes of the records that surveys of a structure have or had, each with the original name of its file.
    ///
    /// # Errors
    /// If the database cannot be read.
    pub fn records(&mut self, structure: &str) -> Result<BTreeMap<String, String>, StoreError> {
        let sql = "select distinct r.hash, coalesce(a.came_as, r.path) from survey v join record r on r.survey = v.hash \
            left join arrival a on a.survey = v.hash where v.structure = $1";
        let rows = all(self.database.as_mut(), sql, &[Value::Text(structure.to_owned())])?;
        let pairs = rows.into_iter().filter_map(|row| match row.as_slice() {
            [Value::Text(hash), Value::Text(path)] => {
                let name = path.rsplit(['/', '\\']).next().unwrap_or(path);
                Some((hash.clone(), name.to_owned()))
            }
            _ => None,
        });
        Ok(pairs.collect())
    }

    /// Stores a record as a survey in one transaction: when this returns [`Arrived::Stored`], it is on disk.
    ///
    /// # Errors
    /// If a name is not allowed, the structure does not exist, or the database cannot be written.
    pub fn arrive(&mut self, arriving: &Arriving<'_>, act: &Act<'_>) -> Result<Arrived, StoreError> {
        refuse_name("who", act.who)?;
        refuse_name("survey", arriving.survey)?;
        transaction(self.database.as_mut(), |database| arrive(database, arriving, act))
    }

    /// Whether the alarm of a structure was called.
    ///
    /// # Errors
    /// If the database cannot be read.
    pub fn is_called(&mut self, structure: &str, alarm: &str) -> Result<bool, StoreError> {
        let of = [ALARM, structure, alarm].map(|text| Value::Text(text.to_owned()));
        let condition = "where verb = $1 and subject = $2 and detail = $3";
        Ok(!select::<LogRow>(self.database.as_mut(), condition, &of)?.is_empty())
    }

    /// Records that the alarm of a structure was called.
    ///
    /// # Errors
    /// If the database cannot be written.
    pub fn set_called(&mut self, structure: &str, alarm: &str, act: &Act<'_>) -> Result<(), StoreError> {
        transaction(self.database.as_mut(), |database| {
            let row = LogRow {
                at_us: next(database, act.now_us)?,
                who: act.who.to_owned(),
                verb: ALARM.to_owned(),
                subject: structure.to_owned(),
                detail: alarm.to_owned(),
            };
            insert(database, &row).map(|_| ())
        })
    }
}

fn arrive(
    database: &mut dyn Database,
    arriving: &Arriving<'_>,
    act: &Act<'_>,
) -> Result<Arrived, StoreError> {
    let incoming = &arriving.incoming;
    let structure = incoming.structure;
    refuse_unknown(database, structure)?;
    let refused = || {
        StoreError::from(StoreFault::Name {
            what: "survey",
            shown: shown(arriving.survey),
        })
    };
    let mut surveys = incoming.project.surveys.iter();
    let survey = surveys
        .find(|survey| survey.name == arriving.survey)
        .ok_or_else(refused)?;
    let (path, kept) = incoming.files.iter().next().ok_or_else(refused)?;
    refuse_path(path)?;
    let text_of = |text: &str| Value::Text(text.to_owned());
    let sql = "select v.hash from survey v join record r on r.survey = v.hash where v.structure = $1 and r.hash = $2 limit 1";
    if !all(database, sql, &[text_of(structure), text_of(&kept.hash)])?.is_empty() {
        return Ok(Arrived::There);
    }
    let sql = "select hash from survey where structure = $1 and name = $2 limit 1";
    if !all(database, sql, &[text_of(structure), text_of(arriving.survey)])?.is_empty() {
        return Ok(Arrived::NameTaken);
    }
    let at_us = next(database, act.now_us)?;
    let tables = SurveyTables::of(incoming.text)?;
    let hash_of_file = |named: &str| (named == path).then(|| kept.hash.clone());
    let hash = tables.survey_hash(structure, &survey.name, &hash_of_file);
    let mut rows = crate::incoming::Rows::default();
    rows.put(&RawRow {
        hash: kept.hash.clone(),
        bytes: i64::try_from(kept.bytes).unwrap_or(i64::MAX),
        at_us,
    });
    incoming.survey(&mut rows, survey, &hash)?;
    incoming.faults_of(&mut rows, &survey.name, &hash);
    rows.put(&ArrivalRow {
        survey: hash.clone(),
        structure: structure.to_owned(),
        name: survey.name.clone(),
        path: path.clone(),
        raw: kept.hash.clone(),
        came_as: shown(arriving.came_as),
        text: arriving.own_text.to_owned(),
        units: tables.units(),
        at_us,
        who: act.who.to_owned(),
    });
    let modes = incoming.modes.get(&survey.name);
    if let (Some(modes), Some(key)) = (modes, incoming.key(survey, &tables)) {
        analysis(&mut rows, modes, &key, (act.who, at_us));
        rows.put(&SurveyAnalysisRow {
            survey: hash,
            analysis: key.hash(),
        });
    }
    for group in rows.0 {
        put(database, &group)?;
    }
    Ok(Arrived::Stored)
}
