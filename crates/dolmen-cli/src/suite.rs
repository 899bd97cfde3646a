//! `dolmen motion --suite`: selects and scales records of a folder for a demand.

use crate::cli_motion::GroundMotionVerb as Options;
use crate::manner::Manner;
use crate::note::note;
use crate::outcome::Outcome;
use crate::request;
use crate::say::{say, say_json};
use crate::wrong::Noted;
use anyhow::Result;
use dolmen::signal::SuiteRule;
use dolmen_folder::{Outputs, motions_in};
use dolmen_report::files::suite_files;
use dolmen_report::json::suite_json;
use dolmen_report::suite_text;
use dolmen_work::motion::{Demand, SuiteOptions, suite};
use std::path::Path;

/// Selects `count` records of the folder `from` for a demand over a range of periods.
pub(crate) fn run(
    options: &Options,
    (count, from): (usize, &Path),
    (demand, range_s): (Demand, [f64; 2]),
    manner: &Manner,
) -> Result<Outcome> {
    let (folder, names) = motions_in(from, manner.access())?;
    let usual = SuiteRule::default();
    let told = SuiteOptions {
        request: request::motion(&options.motion, &[], manner)?,
        demand,
        range_s,
        damping_ratio: options.damping,
        rule: SuiteRule {
            count,
            factors: options.factors.unwrap_or(usual.factors),
            alike_most: options.alike.map_or(usual.alike_most, usize::from),
            ..usual
        },
        matched: options.matched,
    };
    let answer = suite(&told, &names, &folder)?;
    match manner.json {
        true => say_json(&suite_json(&answer))?,
        false => say(&suite_text(&answer, manner.style()))?,
    }
    if let Some(output) = &options.output {
        let inputs = names.iter().map(|name| from.join(name));
        let outputs = inputs.fold(Outputs::new(manner.access()), |all, file| all.keeping(&file));
        outputs.folder(output, &suite_files(&answer, &called(output), manner.language()))?;
        if !manner.quiet {
            let files = output.display().to_string();
            note!("{}", Noted::Wrote(files).text(manner));
        }
    }
    Ok(Outcome::finished(answer.is_kept()))
}

/// The path of a folder as a project file would write it.
fn called(folder: &Path) -> String {
    let whole = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    let name = whole.file_name().or_else(|| folder.file_name());
    name.map_or_else(|| ".".to_owned(), |name| name.to_string_lossy().into_owned())
}
