//! `dolmen score`: the six-factor score of a pagoda, what it is worth, and designs to train it on.

use crate::cli_portfolio::Score as Options;
use crate::note::note;
use crate::outcome::Outcome;
use crate::study_folder::StudyFolder;
use crate::{files, open};
use anyhow::{Context as _, Result};
use dolmen_report::json::{score_json, score_quality_json};
use dolmen_report::text::{score_quality_text, score_text};
use dolmen_work::score::{ScoreDesigns, score, score_quality};
use dolmen_work::study::{study_designs, trained};
use dolmen_work::{WorkError, told};
use std::path::Path;

pub(crate) fn run(options: &Options, as_json: bool, quiet: bool) -> Result<Outcome> {
    match (&options.train, &options.project, &options.output) {
        (Some(name), Some(project), Some(output)) => train(options, project, name, output, quiet)?,
        (_, Some(project), _) => one(options, project, as_json)?,
        _ => quality(options, as_json)?,
    }
    Ok(Outcome::Done)
}

/// The designs of a file, or those that come with Dolmen.
pub(crate) fn designs(path: Option<&Path>) -> Result<ScoreDesigns> {
    match path {
        Some(path) => ScoreDesigns::read(&files::read(path)?).with_context(|| path.display().to_string()),
        None => Ok(ScoreDesigns::shipped()?),
    }
}

fn one(options: &Options, path: &Path, as_json: bool) -> Result<()> {
    let designs = designs(options.designs.as_deref())?;
    let found = open::project(path)?;
    let answer = score(&found.opened, &designs, options.extrapolate)?;
    if as_json {
        files::say_json(&score_json(&answer))
    } else {
        files::say(&score_text(&answer))
    }
}

fn quality(options: &Options, as_json: bool) -> Result<()> {
    let designs = designs(options.designs.as_deref())?;
    let found = score_quality(&designs)?;
    if as_json {
        files::say_json(&score_quality_json(&found, designs.designs.len()))
    } else {
        files::say(&score_quality_text(&found, designs.designs.len()))
    }
}

fn train(options: &Options, project: &Path, name: &str, output: &Path, quiet: bool) -> Result<()> {
    let found = open::project(project)?;
    let folder = StudyFolder::of(options.from.as_deref(), &found.file, name);
    let journals = || {
        let journals = folder.journals(name, &[]);
        journals.map_err(|why| WorkError::Outside {
            why: told(why.as_ref()),
        })
    };
    let designs = trained(study_designs(&found.opened, name, journals, &found.files)?);
    files::write(output, designs.designs.csv().as_bytes())?;
    if !quiet {
        note!(
            "{} designs are in {}; {} were left out: scans are missing or cannot be used",
            designs.designs.designs.len(),
            output.display(),
            designs.left_out
        );
    }
    Ok(())
}
