//! Checks that a store still contains everything that was put into it: every file by its hash, every row by its name, and all references.

use crate::database::{Database, Value, all};
use crate::error::StoreError;
use crate::incoming::{SurveyTables, analysis_hash, project_hash, settings_hash};
use crate::raw::Standing;
use crate::rows::{
    AnalysisRow, ArrivalRow, ProjectFileRow, ProjectRow, RawRow, Row, SettingsRow, SurveyRow, TABLES, select,
};
use crate::store::Store;
use dolmen_work::kept::{Fault, StoreFault, Verified};
use std::collections::{BTreeMap, BTreeSet};

/// The table of the log, which is not part of the hash of the contents.
const LOG: &str = "log";

impl Store {
    /// Reads everything, and checks it against hashes, names and references.
    ///
    /// # Errors
    /// If the database or the folder cannot be read at all. Faults in their contents are not errors, but part of the answer.
    pub fn verify(&mut self) -> Result<Verified, StoreError> {
        self.database.begin_reading()?;
        let found = self.compared();
        let _ = self.database.rollback(); // a reading transaction: nothing to undo
        found
    }

    fn compared(&mut self) -> Result<Verified, StoreError> {
        let database = self.database.as_mut();
        let mut faults: Vec<Fault> = Vec::new();
        let said = match database.faults() {
            Ok(said) => said,
            Err(StoreError::Fault(StoreFault::Damaged { why })) => vec![why],
            Err(other) => return Err(other),
        };
        faults.extend(said.into_iter().map(|why| Fault::Database { why }));
        for table in TABLES {
            let columns = database.columns(table.name)?;
            let is_own = columns
                .iter()
                .map(|(name, kind)| (name.as_str(), *kind))
                .eq(table.columns.iter().copied());
            if !is_own {
                let why = format!("the table {} has other columns", table.name);
                faults.push(Fault::Database { why });
            }
        }
        let (mut raw_files, mut raw_bytes) = (0, 0);
        let (raw, mut found) = (&self.raw, Vec::new());
        let sql = format!("select {} from raw order by hash", RawRow::TABLE.names());
        database.query(&sql, &[], &mut |row| {
            let row = RawRow::of(row)?;
            raw_files += 1;
            raw_bytes += row.bytes;
            match raw.standing(&row.hash, u64::try_from(row.bytes).unwrap_or(0))? {
                Standing::Sound => {}
                Standing::Missing => found.push(Fault::Missing { hash: row.hash }),
                Standing::Changed => found.push(Fault::Changed { hash: row.hash }),
            }
            Ok(())
        })?;
        let is_sound = found.is_empty();
        faults.extend(found);
        faults.extend(self.rows_against_their_names(is_sound)?);
        let database = self.database.as_mut();
        let present = raw_files
            - faults
                .iter()
                .filter(|f| matches!(f, Fault::Missing { .. }))
                .count() as i64;
        Ok(Verified {
            structures: count(database, "structure")?,
            surveys: count(database, "survey")?,
            analyses: count(database, "analysis")?,
            raw_files,
            raw_bytes,
            unnamed_files: (self.raw.count()? as i64 - present).max(0),
            content: content(database)?,
            faults,
        })
    }

    /// Rows whose key does not fit their contents. Surveys are compared with the texts of the projects where those can be read.
    fn rows_against_their_names(&mut self, with_texts: bool) -> Result<Vec<Fault>, StoreError> {
        let database = self.database.as_mut();
        let mut faults = Vec::new();
        let mut wrong = |table: &str, name: &str| {
            faults.push(Fault::Row {
                table: table.to_owned(),
                name: name.to_owned(),
            });
        };
        for row in select::<SettingsRow>(database, "order by hash", &[])? {
            if settings_hash(&row.text) != row.hash {
                wrong("settings", &row.hash);
            }
        }
        for row in select::<AnalysisRow>(database, "order by hash", &[])? {
            if analysis_hash(&row.records, &row.settings, &row.version) != row.hash {
                wrong("analysis", &row.hash);
            }
        }
        for row in select::<ArrivalRow>(database, "order by survey", &[])? {
            let hash_of_file = |path: &str| (path == row.path).then(|| row.raw.clone());
            let should = SurveyTables::of_arrival(&row.text, &row.units)
                .map(|tables| tables.survey_hash(&row.structure, &row.name, &hash_of_file));
            if should.ok().as_ref() != Some(&row.survey) {
                wrong("arrival", &row.survey);
            }
        }
        // one project at a time: there may be many, with many surveys each
        for [hash] in texts::<1>(database, "select hash from project order by hash")? {
            let named = [Value::Text(hash)];
            for project in select::<ProjectRow>(database, "where hash = $1", &named)? {
                let files: Vec<ProjectFileRow> =
                    select(database, "where project = $1 order by path", &named)?;
                let pairs = files.iter().map(|file| (file.path.as_str(), file.hash.as_str()));
                if project_hash(&project.structure, &project.text_hash, pairs) != project.hash {
                    wrong("project", &project.hash);
                }
                if !with_texts {
                    continue;
                }
                let hashes: BTreeMap<&str, &str> = files
                    .iter()
                    .map(|file| (file.path.as_str(), file.hash.as_str()))
                    .collect();
                let bytes = all(
                    database,
                    "select bytes from raw where hash = $1",
                    &[Value::Text(project.text_hash.clone())],
                )?;
                let bytes = match bytes.first().map(Vec::as_slice) {
                    Some([Value::Whole(bytes)]) => u64::try_from(*bytes).unwrap_or(0),
                    _ => continue, // a dangling reference, reported above
                };
                let text = String::from_utf8(self.raw.read(&project.text_hash, bytes)?).unwrap_or_default();
                let Ok(tables) = SurveyTables::of(&text) else {
                    wrong("project", &project.hash);
                    continue;
                };
                let hash_of_file = |path: &str| hashes.get(path).map(|hash| (*hash).to_owned());
                let should: BTreeSet<String> = tables
                    .names()
                    .iter()
                    .map(|name| tables.survey_hash(&project.structure, name, &hash_of_file))
                    .collect();
                let condition = "where hash in (select survey from project_survey where project = $1)";
                let there = select::<SurveyRow>(database, condition, &named)?;
                let there: BTreeSet<String> = there.into_iter().map(|row| row.hash).collect();
                for hash in should.symmetric_difference(&there) {
                    wrong("survey", hash);
                }
            }
        }
        Ok(faults)
    }
}

fn count(database: &mut dyn Database, table: &str) -> Result<i64, StoreError> {
    let rows = all(database, &format!("select count(*) from {table}"), &[])?;
    match rows.first().map(Vec::as_slice) {
        Some([Value::Whole(count)]) => Ok(*count),
        _ => Ok(0),
    }
}

/// Rows that store texts.
fn texts<const N: usize>(database: &mut dyn Database, sql: &str) -> Result<Vec<[String; N]>, StoreError> {
    let mut found = Vec::new();
    database.query(sql, &[], &mut |row| {
        let texts = row.into_iter().filter_map(|value| match value {
            Value::Text(text) => Some(text),
            _ => None,
        });
        let texts: Vec<String> = texts.collect();
        found.extend(<[String; N]>::try_from(texts));
        Ok(())
    })?;
    Ok(found)
}

/// BLAKE3 over all rows in the order of their keys: the same for every database with the same contents.
fn content(database: &mut dyn Database) -> Result<String, StoreError> {
    let mut hasher = blake3::Hasher::new();
    for table in TABLES.iter().filter(|table| table.name != LOG) {
        hasher.update(table.name.as_bytes());
        let sql = format!(
            "select {} from {} order by {}",
            table.names(),
            table.name,
            table.key
        );
        database.query(&sql, &[], &mut |row| {
            for value in row {
                let (sign, bytes) = match &value {
                    Value::Null => (0, Vec::new()),
                    Value::Whole(whole) => (1, whole.to_le_bytes().to_vec()),
                    Value::Number(number) => (2, number.to_bits().to_le_bytes().to_vec()),
                    Value::Text(text) => (3, text.as_bytes().to_vec()),
                };
                hasher.update(&[sign]);
                hasher.update(&(bytes.len() as u64).to_le_bytes());
                hasher.update(&bytes);
            }
            Ok(())
        })?;
    }
    Ok(hasher.finalize().to_hex().to_string())
}
