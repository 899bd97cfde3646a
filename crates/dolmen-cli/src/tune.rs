//! `dolmen tune`: dampers of a building compared with design rules and the optimum: position and tuning.

use crate::cli_tune::{Tune as Options, TuneGoal, TuneLoad as Load};
use crate::manner::Manner;
use crate::note::note;
use crate::outcome::Outcome;
use crate::say::{say, say_json};
use crate::typed::Typed;
use crate::wrong::Noted;
use anyhow::Result;
use dolmen::damper::Goal;
use dolmen_folder::Outputs;
use dolmen_report::against_text;
use dolmen_report::as_json;
use dolmen_report::files::tune_files;
use dolmen_report::json::{together_json, tune_json};
use dolmen_report::text::{together_text, tune_text};
use dolmen_work::building::{TuneLoad, TuneOptions, tune};
use dolmen_work::{FlagVerb, evidence_of};

fn options_of(options: &Options) -> TuneOptions {
    TuneOptions {
        damper: options.damper.clone(),
        variant: options.variant.clone(),
        load: match options.load {
            Load::Force => TuneLoad::Force,
            Load::Wind => TuneLoad::Wind {
                corner_hz: options.corner,
            },
            Load::Gusts => TuneLoad::Gusts,
            Load::Base => TuneLoad::Base,
            Load::Ground => TuneLoad::Ground {
                ground_hz: options.ground,
            },
        },
        load_direction_degrees: options.load_direction,
        goal: match options.goal {
            TuneGoal::LargestRms => Goal::LargestRms,
            TuneGoal::MeanSquare => Goal::MeanSquare,
            TuneGoal::LargestPeak => Goal::LargestPeak,
        },
        map: options.map,
        stroke_most: options.stroke_most,
        off_by: options.off,
        share_mass: options.share_mass,
        floors: options.floors.unwrap_or_default(),
    }
}

pub(crate) fn run(options: &Options, typed: &Typed, manner: &Manner) -> Result<Outcome> {
    let found = manner.open(&options.project)?;
    typed.refuse_foreign(FlagVerb::Tune, &[&found.opened.project])?;
    let answers = tune(&found.opened, &options_of(options), &found.files)?;
    if manner.json {
        let each: Vec<_> = answers.tunings.iter().map(tune_json).collect();
        let of_all: Vec<_> = answers.together.iter().map(together_json).collect();
        say_json(&as_json!({ "dampers": each, "together": of_all }))?;
    } else {
        say(&against_text(
            &found.opened.project,
            &evidence_of(&found.opened)?,
            manner.style(),
        ))?;
        for answer in &answers.tunings {
            say(&tune_text(answer, manner.style()))?;
        }
        for answer in &answers.together {
            say(&together_text(answer, manner.style()))?;
        }
    }
    if let Some(folder) = &options.output {
        let files = tune_files(&answers, manner.language());
        Outputs::of(manner.access(), &found).folder(folder, &files)?;
        if !manner.quiet {
            note!("{}", Noted::Results(folder.display().to_string()).text(manner));
        }
    }
    Ok(Outcome::Done)
}
