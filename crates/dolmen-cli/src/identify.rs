//! `dolmen identify`: records → modes → stiffness.

use crate::cli::Identify as Options;
use crate::manner::Manner;
use crate::note::note;
use crate::outcome::Outcome;
use crate::progress::Terminal;
use crate::say::{say, say_json};
use crate::wrong::Noted;
use anyhow::Result;
use dolmen_folder::{Found, Outputs};
use dolmen_report::files::identification_files;
use dolmen_report::identification_text;
use dolmen_report::json::identification_json;
use dolmen_work::{IdentifyOptions, identify};

pub(crate) fn run(options: &Options, manner: &Manner) -> Result<Outcome> {
    let found = Found::open(&options.project, manner.access())?;
    let how = IdentifyOptions {
        survey: options.survey.clone(),
    };
    let answer = identify(&found.opened, &how, &found.files, &Terminal::new(manner.quiet))?;
    if manner.json {
        say_json(&identification_json(&answer))?;
    } else {
        say(&identification_text(&answer, manner.style()))?;
    }
    if let Some(folder) = &options.output {
        Outputs::of(manner.access(), &found)
            .folder(folder, &identification_files(&answer, manner.language()))?;
        if !manner.quiet {
            note!(
                "{}",
                Noted::Identified {
                    folder: folder.display().to_string()
                }
                .text(manner)
            );
        }
    }
    Ok(Outcome::Done)
}
