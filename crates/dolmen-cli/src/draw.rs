//! `dolmen draw`: the structure as entered, before anything is computed.

use crate::cli::Draw as Options;
use crate::manner::Manner;
use crate::outcome::Outcome;
use crate::say::say;
use crate::wrong::CommandError;
use anyhow::Result;
use dolmen_folder::{Found, Outputs};
use dolmen_report::files::drawing_file;

pub(crate) fn run(options: &Options, manner: &Manner) -> Result<Outcome> {
    if manner.json {
        return Err(CommandError::NoJsonOfDrawing.into());
    }
    let found = Found::open(&options.project, manner.access())?;
    let outputs = Outputs::of(manner.access(), &found);
    if let Some(output) = &options.output {
        let extension = output.extension().map(|of| of.to_string_lossy().to_lowercase());
        if let Some(other) = extension.as_deref().filter(|extension| *extension != "svg") {
            return Err(CommandError::DrawingFormat {
                ending: other.to_owned(),
            }
            .into());
        }
        outputs.refuse(output)?;
    }
    let drawn = drawing_file(&found.opened.project, manner.language()).ok_or_else(|| {
        CommandError::NothingToDraw {
            path: found.file.display().to_string(),
        }
    })?;
    match &options.output {
        None => say(&String::from_utf8_lossy(&drawn.bytes))?,
        Some(output) => {
            outputs.file(output, &drawn.bytes)?;
            if !manner.quiet {
                say(&format!("{}\n", output.display()))?;
            }
        }
    }
    Ok(Outcome::Done)
}
