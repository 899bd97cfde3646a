//! The followed structure, as stored.

use crate::stored::observed;
use crate::wrong::{FollowError, store_failure};
use anyhow::Result;
use dolmen_store::{Search, Store, StoredFiles};
use dolmen_work::Opened;
use dolmen_work::follow::Pattern;
use dolmen_work::logs::Logs;
use dolmen_work::watch::Observed;
use std::collections::BTreeSet;

/// State of the structure for reading its records.
pub(crate) struct State {
    pub(crate) project: String,
    pub(crate) pattern: Pattern,
    pub(crate) files: StoredFiles,
    pub(crate) history: Opened,
    pub(crate) observed: Observed,
    pub(crate) logs: Logs,
}

impl State {
    pub(crate) fn of(store: &mut Store, structure: &str) -> Result<Self> {
        let project = store.state(structure).map_err(store_failure)?;
        let exported = store.export(structure).map_err(store_failure)?;
        let files = store.files(&exported);
        let read = |bytes: &[u8]| {
            let text = String::from_utf8_lossy(bytes).into_owned();
            Opened::read(text, structure.to_owned(), &files)
        };
        let pattern = Pattern::of(read(exported.text.get(..exported.own_bytes).unwrap_or_default())?)?;
        let history = read(&exported.text)?;
        Ok(State {
            logs: Logs::read(&history.project, &files)?,
            project,
            pattern,
            history,
            observed: observed(store, structure).map_err(store_failure)?,
            files,
        })
    }

    pub(crate) fn days_with_modes(&self) -> usize {
        let days: BTreeSet<&str> = self
            .observed
            .modes
            .iter()
            .filter(|(_, modes)| !modes.is_empty())
            .map(|(name, _)| dolmen_work::day_of_a_record(name).unwrap_or(name))
            .collect();
        days.len()
    }
}

/// The only structure of a store.
pub(crate) fn only_structure(store: &mut Store) -> Result<String> {
    let mut names = Vec::new();
    let all = store.structures(&Search::default(), &mut |row| {
        names.push(row.name);
        Ok(())
    });
    all.map_err(store_failure)?;
    match <[String; 1]>::try_from(names) {
        Ok([name]) => Ok(name),
        Err(names) => Err(FollowError::WhichStructure {
            count: names.len(),
            first: names.into_iter().take(5).collect(),
        }
        .into()),
    }
}
