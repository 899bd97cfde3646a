//! `dolmen draw`: the structure as entered, without any computation.

use crate::cli::Draw as Options;
use crate::manner::Manner;
use crate::outcome::Outcome;
use crate::report::PIXELS;
use crate::say::say;
use crate::wrong::CommandError;
use anyhow::Result;
use dolmen_folder::Outputs;
use dolmen_picture::Painter;
use dolmen_report::files::drawing_file;
use std::path::Path;

/// Output format of a drawing.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Format {
    Svg,
    Png,
}

impl Format {
    /// The format for the ending of a file; SVG without an ending, as for a pipe.
    fn of(file: &Path) -> Result<Self, CommandError> {
        let ending = file.extension().map(|of| of.to_string_lossy().to_lowercase());
        match ending.as_deref() {
            None | Some("svg") => Ok(Format::Svg),
            Some("png") => Ok(Format::Png),
            Some(other) => Err(CommandError::DrawingFormat {
                ending: other.to_owned(),
            }),
        }
    }
}

pub(crate) fn run(options: &Options, manner: &Manner) -> Result<Outcome> {
    if manner.json {
        return Err(CommandError::NoJsonOfDrawing.into());
    }
    let found = manner.open(&options.project)?;
    let outputs = Outputs::of(manner.access(), &found);
    let mut is_png = false;
    if let Some(output) = &options.output {
        is_png = Format::of(output)? == Format::Png;
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
            let bytes = match is_png {
                true => Painter::new().png(&String::from_utf8_lossy(&drawn.bytes), PIXELS)?,
                false => drawn.bytes,
            };
            outputs.file(output, &bytes)?;
            if !manner.quiet {
                say(&format!("{}\n", output.display()))?;
            }
        }
    }
    Ok(Outcome::Done)
}
