//! `dolmen watch`: the record of a structure over the years.

use crate::cli::Watch;
use crate::manner::Manner;
use crate::note::note;
use crate::outcome::Outcome;
use crate::progress::Terminal;
use crate::say::{say, say_json};
use anyhow::Result;
use dolmen_folder::{Found, Outputs};
use dolmen_report::files::watch_files;
use dolmen_report::json::watch_json;
use dolmen_report::text::watch_text;
use dolmen_work::judgement::{Colour, Verb, exit_status};
use dolmen_work::watch::watch;

pub(crate) fn run(options: &Watch, manner: &Manner) -> Result<Outcome> {
    let found = Found::open(&options.project, manner.access())?;
    let answer = watch(&found.opened, &found.files, &Terminal::new(manner.quiet))?;
    if manner.json {
        say_json(&watch_json(&answer))?;
    } else {
        say(&watch_text(&answer, manner.style()))?;
    }
    if let Some(folder) = &options.output {
        Outputs::of(manner.access(), &found).folder(folder, &watch_files(&answer, manner.language()))?;
        if !manner.quiet {
            note!("years.svg and watch.json are in {}", folder.display());
        }
    }
    let colour = match answer.open_alarms() {
        0 => Colour::Green,
        _ => Colour::Red,
    };
    Ok(Outcome::Judged(exit_status(Verb::Watch, colour, true)))
}
