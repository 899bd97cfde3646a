//! `dolmen identify`: records → modes → stiffness.

use crate::cli::Identify as Options;
use crate::manner::Manner;
use crate::note::note;
use crate::outcome::Outcome;
use crate::progress::Terminal;
use crate::report::PIXELS;
use crate::say::{say, say_json};
use crate::wrong::Noted;
use anyhow::Result;
use dolmen_folder::Outputs;
use dolmen_picture::Painter;
use dolmen_report::files::identification_files;
use dolmen_report::json::{identification_json, written_back_json};
use dolmen_report::{identification_text, written_back_text};
use dolmen_work::{IdentifyOptions, identify, write_back};

pub(crate) fn run(options: &Options, manner: &Manner) -> Result<Outcome> {
    let found = manner.open(&options.project)?;
    let how = IdentifyOptions {
        survey: options.survey.clone(),
    };
    let mut answer = identify(&found.opened, &how, &found.files, &Terminal::new(manner.quiet))?;
    let written = options
        .write
        .then(|| write_back(&found.opened, &answer, &found.files));
    if let Some(Ok(written)) = &written {
        answer.project = written.opened.project.clone();
    }
    if manner.json {
        let mut value = identification_json(&answer);
        if let Some(Ok(written)) = &written {
            value["written"] = written_back_json(written);
        }
        say_json(&value)?;
    } else {
        say(&identification_text(&answer, manner.style()))?;
    }
    if let Some(written) = written.transpose()? {
        dolmen_folder::rewrite(&found.file, written.opened.text.as_bytes())?;
        if !manner.json {
            say(&written_back_text(&answer.file, &written, manner.style()))?;
        }
    }
    if let Some(folder) = &options.output {
        let painter = Painter::new();
        let painted = |svg: &str| painter.png(svg, PIXELS).map_err(|fault| fault.to_string());
        let files = identification_files(&answer, manner.language(), &painted)?;
        Outputs::of(manner.access(), &found).folder(folder, &files)?;
        if !manner.quiet {
            note!("{}", Noted::Identified(folder.display().to_string()).text(manner));
        }
    }
    Ok(Outcome::Done)
}
