//! `dolmen compare`: changes between two surveys.

use crate::cli::Compare;
use crate::manner::Manner;
use crate::note::note;
use crate::outcome::Outcome;
use crate::progress::Terminal;
use crate::say::{say, say_json};
use crate::wrong::Noted;
use anyhow::Result;
use dolmen_folder::Outputs;
use dolmen_report::files::change_files;
use dolmen_report::json::change_json;
use dolmen_report::text::change_text;
use dolmen_work::compare::{CompareOptions, compare};

pub(crate) fn run(options: &Compare, manner: &Manner) -> Result<Outcome> {
    let found = manner.open(&options.project)?;
    let how = CompareOptions {
        from: options.from.clone(),
        to: options.to.clone(),
    };
    let answer = compare(&found.opened, &how, &found.files, &Terminal::new(manner.quiet))?;
    if manner.json {
        say_json(&change_json(&answer))?;
    } else {
        say(&change_text(&answer, manner.style()))?;
    }
    if let Some(folder) = &options.output {
        Outputs::of(manner.access(), &found).folder(folder, &change_files(&answer, manner.language()))?;
        if !manner.quiet {
            note!("{}", Noted::Compared(folder.display().to_string()).text(manner));
        }
    }
    Ok(Outcome::Done)
}
