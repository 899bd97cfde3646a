//! `dolmen record`: the record of a survey for other programs.

use crate::cli::Record as Options;
use crate::manner::Manner;
use crate::outcome::Outcome;
use crate::say::say;
use crate::wrong::CommandError;
use anyhow::Result;
use dolmen_folder::Outputs;
use dolmen_records::records::{UffNumbers, record_csv, record_uff};
use dolmen_work::{WhichRecord, used_record};
use std::path::Path;

/// Output format of a record.
enum Format {
    Universal(UffNumbers),
    Csv,
}

impl Format {
    /// The format for the ending of a file.
    fn of(file: &Path, binary: bool) -> Result<Self, CommandError> {
        let ending = file.extension().map(|of| of.to_string_lossy().to_lowercase());
        match (ending.as_deref(), binary) {
            (Some("uff" | "unv"), false) => Ok(Format::Universal(UffNumbers::Text)),
            (Some("uff" | "unv"), true) => Ok(Format::Universal(UffNumbers::Binary)),
            (Some("csv"), false) => Ok(Format::Csv),
            (Some("csv"), true) => Err(CommandError::BinaryCsv),
            _ => Err(CommandError::RecordFormat {
                path: file.display().to_string(),
            }),
        }
    }
}

pub(crate) fn run(options: &Options, manner: &Manner) -> Result<Outcome> {
    if manner.json {
        return Err(CommandError::NoJsonOfRecord.into());
    }
    let format = Format::of(&options.output, options.binary)?;
    let found = manner.open(&options.project)?;
    let outputs = Outputs::of(manner.access(), &found);
    outputs.refuse(&options.output)?;
    let which = WhichRecord {
        survey: options.survey.clone(),
        setup: options.setup,
    };
    let project = &found.opened.project;
    let used = used_record(project, &which, &found.files)?;
    let bytes = match format {
        Format::Csv => record_csv(&used.record).into_bytes(),
        Format::Universal(numbers) => {
            let title = format!("{}: {}", project.name.english(), used.name);
            record_uff(&used.record, &title, numbers)
        }
    };
    outputs.file(&options.output, &bytes)?;
    if !manner.quiet {
        say(&format!("{}\n", options.output.display()))?;
    }
    Ok(Outcome::Done)
}
