//! The record of a survey as used: read, joined, conditioned with the settings of the project.

use crate::error::{Within as _, WorkError};
use crate::record;
use crate::wrong::Place;
use dolmen::signal::Record;
use dolmen_project::{Project, RecordSource};
use dolmen_records::Files;

/// Choice of a record.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct WhichRecord {
    /// The survey; by default the only one with records.
    pub survey: Option<String>,
    /// Its setup, from 1; by default the only record.
    pub setup: Option<usize>,
}

/// A record and the name of its survey.
#[derive(Clone, Debug)]
pub struct UsedRecord {
    /// "2024", "2024, setup 2".
    pub name: String,
    /// The record.
    pub record: Record,
}

/// The record of a survey as identification uses it.
///
/// # Errors
/// [`WorkError::NoSuchSurvey`]; [`WorkError::NoRecord`]; [`WorkError::WhichRecord`] if none or several match; a record that cannot be read.
pub fn used_record(
    project: &Project,
    which: &WhichRecord,
    files: &dyn Files,
) -> Result<UsedRecord, WorkError> {
    if let Some(name) = &which.survey
        && !project.surveys.iter().any(|survey| survey.name == *name)
    {
        let known: Vec<&str> = project
            .surveys
            .iter()
            .map(|survey| survey.name.as_str())
            .collect();
        return Err(WorkError::NoSuchSurvey {
            name: name.clone(),
            known: known.join(", "),
        });
    }
    let all: Vec<(String, &RecordSource)> = project
        .surveys
        .iter()
        .flat_map(|survey| {
            let alone = survey.records.iter().map(|source| (survey.name.clone(), source));
            let setups = survey.setups.iter().enumerate();
            let setups = setups.map(|(at, source)| (named(&survey.name, at + 1), source));
            alone.chain(setups)
        })
        .collect();
    let is_meant = |name: &str| match (&which.survey, which.setup) {
        (None, None) => true,
        (Some(survey), None) => name == survey || name.starts_with(&format!("{survey}, setup ")),
        (Some(survey), Some(setup)) => name == named(survey, setup),
        (None, Some(setup)) => name.ends_with(&format!(", setup {setup}")),
    };
    let meant: Vec<&(String, &RecordSource)> = all.iter().filter(|(name, _)| is_meant(name)).collect();
    let [(name, source)] = meant.as_slice() else {
        if all.is_empty() {
            return Err(WorkError::NoRecord);
        }
        let known: Vec<&str> = all.iter().map(|(name, _)| name.as_str()).collect();
        return Err(WorkError::WhichRecord {
            meant: meant.len(),
            known: known.join("; "),
        });
    };
    let opened = record::record(source, files).within(|| Place::OfSurvey(name.clone()))?;
    Ok(UsedRecord {
        name: name.clone(),
        record: opened.record,
    })
}

fn named(survey: &str, setup: usize) -> String {
    format!("{survey}, setup {setup}")
}
