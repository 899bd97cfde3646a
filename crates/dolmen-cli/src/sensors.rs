//! `dolmen sensors`: where a few sensors observe the modes of a structure best.

use crate::cli::Sensors as Options;
use crate::manner::Manner;
use crate::note::note;
use crate::outcome::Outcome;
use crate::say::{say, say_json};
use crate::wrong::Noted;
use anyhow::Result;
use dolmen_folder::Outputs;
use dolmen_report::files::sensors_files;
use dolmen_report::json::sensors_json;
use dolmen_report::sensors_text;
use dolmen_work::sensors::{SensorsOptions, sensors};

pub(crate) fn run(options: &Options, manner: &Manner) -> Result<Outcome> {
    let found = manner.open(&options.project)?;
    let how = SensorsOptions {
        count: options.count,
        axes: options.axes,
        up_to_m: options.up_to,
        modes: options.modes,
        setups: options.setups,
        references: options.references,
    };
    let answer = sensors(&found.opened, &how)?;
    if manner.json {
        say_json(&sensors_json(&answer))?;
    } else {
        say(&sensors_text(&answer, manner.style()))?;
    }
    if let Some(folder) = &options.output {
        Outputs::of(manner.access(), &found).folder(folder, &sensors_files(&answer, manner.language()))?;
        if !manner.quiet {
            let folder = folder.display().to_string();
            note!("{}", Noted::Sensors(folder).text(manner));
        }
    }
    Ok(Outcome::Done)
}
