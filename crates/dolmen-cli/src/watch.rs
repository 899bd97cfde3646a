//! `dolmen watch`: the record of a structure over the years, or of every structure of a store.

use crate::cli::Watch;
use crate::cli_survey::StoreWhere;
use crate::follow::follow;
use crate::manner::Manner;
use crate::note::note;
use crate::outcome::Outcome;
use crate::progress::Terminal;
use crate::say::{say, say_json};
use crate::survey::Where;
use crate::watch_call::judged;
use crate::wrong::Noted;
use anyhow::Result;
use dolmen::modal::ObservedMode;
use dolmen_folder::{Found, Outputs};
use dolmen_follow::Call;
use dolmen_report::files::watch_files;
use dolmen_report::json::watch_json;
use dolmen_report::kept::{inventory_csv, inventory_json, inventory_text, store_fault};
use dolmen_report::text::watch_text;
use dolmen_store::{Search, Store, StoreError, StoredFiles};
use dolmen_work::inventory::{InventoryLine, worst_first};
use dolmen_work::logs::Logs;
use dolmen_work::sensor_alarms::SensorFaults;
use dolmen_work::watch::{watch, watch_observed};
use dolmen_work::{Opened, told};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::path::Path;

/// Structures that are read before they are watched together.
const TOGETHER: usize = 256;

pub(crate) fn run(options: &Watch, manner: &Manner) -> Result<Outcome> {
    match (&options.project, &options.follow.follow) {
        (Some(project), _) => one(project, options, manner),
        (None, Some(folder)) => follow(folder, options, manner),
        (None, None) => all(options, manner),
    }
}

fn one(project: &Path, options: &Watch, manner: &Manner) -> Result<Outcome> {
    let found = Found::open(project, manner.access())?;
    let answer = watch(&found.opened, &found.files, &Terminal::new(manner.quiet))?;
    if manner.json {
        say_json(&watch_json(&answer))?;
    } else {
        say(&watch_text(&answer, manner.style()))?;
    }
    if let Some(folder) = &options.output {
        Outputs::of(manner.access(), &found).folder(folder, &watch_files(&answer, manner.language()))?;
        if !manner.quiet {
            note!(
                "{}",
                Noted::Watched {
                    folder: folder.display().to_string()
                }
                .text(manner)
            );
        }
    }
    let line = InventoryLine::watched(answer.project.name.english().to_owned(), &answer);
    call(options, std::slice::from_ref(&line))?;
    Ok(judged(line.is_alarming()))
}

/// Runs the program of `--on-alarm` for each structure that alarms, one after the other.
fn call(options: &Watch, lines: &[InventoryLine]) -> Result<()> {
    let Some(program) = &options.on_alarm else {
        return Ok(());
    };
    for line in lines.iter().filter(|line| line.is_alarming()) {
        let Some(history) = &line.history else { continue };
        Call {
            structure: &line.structure,
            survey: &history.last_survey,
            open_alarms: history.open_alarms,
            tilt_beyond: history.lean_beyond,
            kind: None,
        }
        .run(program)?;
    }
    Ok(())
}

/// A structure as it was read from the store.
struct Stored {
    structure: String,
    text: Vec<u8>,
    files: StoredFiles,
    observed: BTreeMap<String, Vec<ObservedMode>>,
    faults: SensorFaults,
}

fn all(options: &Watch, manner: &Manner) -> Result<Outcome> {
    let place = StoreWhere {
        store: options.store.clone(),
        who: None,
        wait: 10.0,
    };
    let at = Where {
        options: &place,
        manner,
    };
    let mut store = at.open()?;
    let mut names = Vec::new();
    store
        .structures(&Search::default(), &mut |row| {
            names.push(row.name);
            Ok(())
        })
        .map_err(|fault| at.told(fault))?;
    let mut lines: Vec<InventoryLine> = Vec::with_capacity(names.len());
    for some in names.chunks(TOGETHER) {
        let stored: Vec<(&String, Result<Stored, StoreError>)> =
            some.iter().map(|name| (name, read(&mut store, name))).collect();
        lines.par_extend(stored.into_par_iter().map(|(name, stored)| match stored {
            Ok(stored) => watched(stored),
            Err(fault) => {
                let why = store_fault(&fault.fault()).text(manner.language());
                InventoryLine::not_watched(name.clone(), why)
            }
        }));
    }
    let lines = worst_first(lines);
    match (manner.json, options.csv) {
        (true, _) => say_json(&inventory_json(&lines))?,
        (false, true) => say(&inventory_csv(&lines))?,
        (false, false) => say(&inventory_text(&lines, manner.style()))?,
    }
    call(options, &lines)?;
    Ok(judged(lines.iter().any(InventoryLine::is_alarming)))
}

fn read(store: &mut Store, structure: &str) -> Result<Stored, StoreError> {
    let exported = store.export(structure)?;
    Ok(Stored {
        structure: structure.to_owned(),
        files: store.files(&exported),
        text: exported.text,
        observed: store.observed(structure)?,
        faults: store.faults(structure)?,
    })
}

fn watched(stored: Stored) -> InventoryLine {
    let text = String::from_utf8_lossy(&stored.text).into_owned();
    let found = Opened::read(text, stored.structure.clone(), &stored.files).and_then(|opened| {
        let logs = Logs::read(&opened.project, &stored.files)?;
        watch_observed(&opened, &stored.observed, &stored.faults, &logs)
    });
    match found {
        Ok(answer) => InventoryLine::watched(stored.structure, &answer),
        Err(why) => InventoryLine::not_watched(stored.structure, told(&why)),
    }
}
