//! `dolmen identify`: records → modes → stiffness.

use crate::cli::Identify as Options;
use crate::note::note;
use crate::outcome::Outcome;
use crate::progress::Terminal;
use crate::{files, open};
use anyhow::Result;
use dolmen_report::files::identification_files;
use dolmen_report::json::identification_json;
use dolmen_report::text::identification_text;
use dolmen_words::Language;
use dolmen_work::{IdentifyOptions, identify};

pub(crate) fn run(options: &Options, as_json: bool, quiet: bool) -> Result<Outcome> {
    let found = open::project(&options.project)?;
    let how = IdentifyOptions {
        survey: options.survey.clone(),
    };
    let answer = identify(&found.opened, &how, &found.files, &Terminal::new(quiet))?;
    if as_json {
        files::say_json(&identification_json(&answer))?;
    } else {
        files::say(&identification_text(&answer))?;
    }
    if let Some(folder) = &options.output {
        files::write_all(folder, &identification_files(&answer, Language::English))?;
        if !quiet {
            note!("figures and identification.json are in {}", folder.display());
        }
    }
    Ok(Outcome::Done)
}
