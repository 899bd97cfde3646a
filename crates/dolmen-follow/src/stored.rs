//! Copies projects into a store and out of it, and watches all structures of a store.

use crate::clock::now_us;
use crate::wrong::store_failure;
use anyhow::Result;
use dolmen_folder::{Found, fresh_folder, write};
use dolmen_records::{Files as _, RECORD_BYTES_MOST};
use dolmen_report::kept::store_fault;
use dolmen_store::{Act, Exported, Incoming, PROJECT_FILE, Search, Store, StoreError, StoredFiles};
use dolmen_work::felt::felt;
use dolmen_work::inventory::{InventoryLine, worst_first};
use dolmen_work::kept::{Added, AddedEarthquake, Imported, ListedStructure, Unidentified};
use dolmen_work::logs::Logs;
use dolmen_work::watch::{Observed, watch_stored};
use dolmen_work::watched::WatchedEarthquake;
use dolmen_work::{Opened, Progress, WorkError, survey_modes, told_both};
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Number of structures to read before they are watched in parallel.
const TOGETHER: usize = 256;

/// Stores a project with its surveys and files, under `name` or the name of the project. With `progress`, also identifies and stores
/// the modes of its records.
///
/// # Errors
/// If a file of the project cannot be read, or the store fails; then nothing is stored.
pub fn add_project(
    store: &mut Store,
    found: &Found,
    name: Option<&str>,
    who: &str,
    progress: Option<&dyn Progress>,
) -> Result<Added> {
    let project = &found.opened.project;
    let mut files = BTreeMap::new();
    let text_kept = store.keep(found.opened.text.as_bytes()).map_err(store_failure)?;
    for name in named_files(found) {
        let bytes = found
            .files
            .read(&name, RECORD_BYTES_MOST)
            .map_err(WorkError::from)?;
        files.insert(name, store.keep(&bytes).map_err(store_failure)?);
    }
    let mut incoming = Incoming {
        structure: name.unwrap_or(project.name.english()).trim(),
        project,
        text: &found.opened.text,
        text_kept,
        files,
        modes: BTreeMap::new(),
        faults: BTreeMap::new(),
        earthquakes: BTreeMap::new(),
    };
    let mut unidentified = Vec::new();
    if let Some(progress) = progress {
        for survey in store.due(&incoming).map_err(store_failure)? {
            match survey_modes(project, &survey, &found.files, progress) {
                Ok(Some(found)) => {
                    incoming.faults.insert(survey.clone(), found.faults);
                    let earthquake = found.earthquake.map(|of| (survey.clone(), of));
                    incoming.earthquakes.extend(earthquake);
                    incoming.modes.insert(survey, found.modes);
                }
                Ok(None) => {}
                Err(why) => unidentified.push(Unidentified {
                    survey,
                    why: told_both(&why),
                }),
            }
        }
    }
    let act = Act {
        who,
        now_us: now_us(),
    };
    let mut added = store.add(&incoming, &act).map_err(store_failure)?;
    added.unidentified = unidentified;
    added.earthquakes = earthquakes_of(store, &added.structure)?;
    Ok(added)
}

/// Earthquakes that a stored structure experienced.
fn earthquakes_of(store: &mut Store, structure: &str) -> Result<Vec<AddedEarthquake>> {
    let stored = read(store, structure).map_err(store_failure)?;
    let text = String::from_utf8_lossy(&stored.text).into_owned();
    let opened = Opened::read(text, structure.to_owned(), &stored.files)?;
    let found = &stored.observed.earthquakes;
    let all = felt(&opened.project, |survey| found.get(&survey.name).copied());
    let added = |of: WatchedEarthquake| AddedEarthquake {
        survey: of.survey,
        of: of.part.into(),
        is_answered: of.is_answered,
    };
    Ok(all.into_iter().map(added).collect())
}

/// All texts in the project file that name a file in its folder: records, motions, meshes, tables, and what later versions add. Only
/// records must exist.
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

/// Writes a structure of a store as a project folder, and returns the names of its files.
///
/// # Errors
/// If the structure does not exist, or the folder is not empty or cannot be written; a folder created by this call is then removed.
pub fn export_project(store: &mut Store, structure: &str, folder: &Path) -> Result<Vec<String>> {
    let exported = store.export(structure).map_err(store_failure)?;
    let was_there = folder.exists();
    fresh_folder(folder)?;
    if let Err(why) = fill(folder, store, &exported) {
        if !was_there {
            let _ = std::fs::remove_dir_all(folder); // ours: it was not there
        }
        return Err(why);
    }
    Ok(exported.files.into_iter().map(|(path, ..)| path).collect())
}

/// Writes the project file last, so that a folder with a project file is complete.
fn fill(folder: &Path, store: &Store, exported: &Exported) -> Result<()> {
    for (path, hash, bytes) in &exported.files {
        let parts = path.split(['/', '\\']).filter(|part| *part != ".");
        let target = parts.fold(folder.to_owned(), |target, part| target.join(part));
        write(&target, &store.raw(hash, *bytes).map_err(store_failure)?)?;
    }
    write(&folder.join(PROJECT_FILE), &exported.text)
}

/// Copies the contents of a store into another.
///
/// # Errors
/// If either store fails; what was copied stays, and a second call continues.
pub fn take_over(from: &mut Store, into: &mut Store, who: &str) -> Result<Imported> {
    let act = Act {
        who,
        now_us: now_us(),
    };
    into.import(from, &act).map_err(store_failure)
}

/// A structure as read from the store.
struct Stored {
    text: Vec<u8>,
    files: StoredFiles,
    observed: Observed,
}

/// All structures of a store, the worst first; one that cannot be watched gives the reason.
///
/// # Errors
/// If the structures cannot be listed.
pub fn watch_all(store: &mut Store) -> Result<Vec<InventoryLine>> {
    let mut names = Vec::new();
    let each = &mut |row: ListedStructure| {
        names.push(row.name);
        Ok(())
    };
    store
        .structures(&Search::default(), each)
        .map_err(store_failure)?;
    let mut lines: Vec<InventoryLine> = Vec::with_capacity(names.len());
    for some in names.chunks(TOGETHER) {
        let stored: Vec<_> = some.iter().map(|name| (name, read(store, name))).collect();
        let watched = stored.into_par_iter().map(|(name, stored)| match stored {
            Ok(stored) => watched(name.clone(), &stored),
            Err(fault) => InventoryLine::not_watched(name.clone(), store_fault(&fault.fault()).into()),
        });
        lines.par_extend(watched);
    }
    Ok(worst_first(lines))
}

fn read(store: &mut Store, structure: &str) -> Result<Stored, StoreError> {
    let exported = store.export(structure)?;
    Ok(Stored {
        files: store.files(&exported),
        text: exported.text,
        observed: observed(store, structure)?,
    })
}

/// Data in the store about the records of a structure's surveys.
pub(crate) fn observed(store: &mut Store, structure: &str) -> Result<Observed, StoreError> {
    Ok(Observed {
        modes: store.observed(structure)?,
        faults: store.faults(structure)?,
        earthquakes: store.earthquakes(structure)?,
    })
}

fn watched(structure: String, stored: &Stored) -> InventoryLine {
    let text = String::from_utf8_lossy(&stored.text).into_owned();
    let found = Opened::read(text, structure.clone(), &stored.files).and_then(|opened| {
        let logs = Logs::read(&opened.project, &stored.files)?;
        watch_stored(&opened, &stored.observed, &logs)
    });
    match found {
        Ok(answer) => InventoryLine::watched(structure, &answer),
        Err(why) => InventoryLine::not_watched(structure, told_both(&why)),
    }
}
