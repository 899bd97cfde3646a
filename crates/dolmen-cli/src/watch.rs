//! `dolmen watch`: the history of a structure, or of every structure of a store.

use crate::cli::Watch;
use crate::cli_survey::StoreWhere;
use crate::follow::follow;
use crate::manner::Manner;
use crate::note::note;
use crate::outcome::Outcome;
use crate::progress::Terminal;
use crate::say::{say, say_json};
use crate::survey::StoreAccess;
use crate::watch_call::judged;
use crate::wrong::Noted;
use anyhow::Result;
use dolmen_folder::Outputs;
use dolmen_follow::{call_for_alarming, watch_all};
use dolmen_report::files::watch_files;
use dolmen_report::json::watch_json;
use dolmen_report::kept::{inventory_csv, inventory_json, inventory_text};
use dolmen_report::text::watch_text;
use dolmen_work::inventory::InventoryLine;
use dolmen_work::watch::watch;
use std::path::Path;

pub(crate) fn run(options: &Watch, manner: &Manner) -> Result<Outcome> {
    match (&options.project, &options.follow.follow) {
        (Some(project), _) => one(project, options, manner),
        (None, Some(folder)) => follow(folder, options, manner),
        (None, None) => all(options, manner),
    }
}

fn one(project: &Path, options: &Watch, manner: &Manner) -> Result<Outcome> {
    let found = manner.open(project)?;
    let answer = watch(&found.opened, &found.files, &Terminal::new(manner.quiet))?;
    if manner.json {
        say_json(&watch_json(&answer))?;
    } else {
        say(&watch_text(&answer, manner.style()))?;
    }
    if let Some(folder) = &options.output {
        Outputs::of(manner.access(), &found).folder(folder, &watch_files(&answer, manner.language()))?;
        if !manner.quiet {
            note!("{}", Noted::Watched(folder.display().to_string()).text(manner));
        }
    }
    let line = InventoryLine::watched(answer.project.name.english().to_owned(), &answer);
    ended(options, std::slice::from_ref(&line))
}

fn all(options: &Watch, manner: &Manner) -> Result<Outcome> {
    let place = StoreWhere {
        store: options.store.clone(),
        who: None,
        wait: 10.0,
    };
    let at = StoreAccess {
        options: &place,
        manner,
    };
    let lines = watch_all(&mut at.open()?)?;
    match (manner.json, options.csv) {
        (true, _) => say_json(&inventory_json(&lines))?,
        (false, true) => say(&inventory_csv(&lines))?,
        (false, false) => say(&inventory_text(&lines, manner.style()))?,
    }
    ended(options, &lines)
}

/// Runs the program of `--on-alarm`, and returns the outcome.
fn ended(options: &Watch, lines: &[InventoryLine]) -> Result<Outcome> {
    if let Some(program) = &options.on_alarm {
        call_for_alarming(program, lines)?;
    }
    Ok(judged(lines.iter().any(InventoryLine::is_alarming)))
}
