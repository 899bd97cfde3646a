//! `dolmen score`: the six-factor score of a pagoda, its accuracy, and designs to train it on.

use crate::cli_portfolio::Score as Options;
use crate::manner::Manner;
use crate::note::note;
use crate::outcome::Outcome;
use crate::report;
use crate::say::{say, say_json};
use crate::tools::told_both;
use crate::wrong::{CommandError, Noted};
use anyhow::{Context as _, Result};
use dolmen_folder::{Outputs, StudyFolder};
use dolmen_records::{NoFiles, TABLE_BYTES_MOST, read_score_form};
use dolmen_report::html::score_form_html;
use dolmen_report::json::{score_given_json, score_json, score_quality_json};
use dolmen_report::xlsx::score_form_workbook;
use dolmen_report::{score_given_text, score_quality_text, score_text};
use dolmen_work::Opened;
use dolmen_work::WorkError;
use dolmen_work::score::{ScoreDesigns, score, score_given, score_quality};
use dolmen_work::study::{study_designs, trained};
use std::path::Path;

pub(crate) fn run(options: &Options, manner: &Manner) -> Result<Outcome> {
    if let Some(sheet) = &options.sheet {
        form(sheet, manner)?;
        return Ok(Outcome::Done);
    }
    match (&options.train, &options.project, &options.output) {
        (Some(name), Some(project), Some(output)) => train(options, project, name, output, manner)?,
        // clap refuses --train without --output
        (_, Some(project), _) => one(options, project, manner)?,
        _ => quality(options, manner)?,
    }
    Ok(Outcome::Done)
}

/// The designs of a file, or the built-in ones.
pub(crate) fn designs(path: Option<&Path>, manner: &Manner) -> Result<ScoreDesigns> {
    match path {
        Some(path) => ScoreDesigns::read(&dolmen_folder::read(
            path,
            manner.access().most(TABLE_BYTES_MOST),
        )?)
        .with_context(|| path.display().to_string()),
        None => Ok(ScoreDesigns::shipped()?),
    }
}

fn one(options: &Options, path: &Path, manner: &Manner) -> Result<()> {
    let opened = opened(path, manner)?;
    if let Some(survey) = &options.given {
        let answer = score_given(&opened, survey, options.extrapolate)?;
        return match manner.json {
            true => say_json(&score_given_json(&answer)),
            false => say(&score_given_text(&answer, manner.style())),
        };
    }
    let designs = designs(options.designs.as_deref(), manner)?;
    let answer = score(&opened, &designs, options.extrapolate)?;
    if manner.json {
        say_json(&score_json(&answer))
    } else {
        say(&score_text(&answer, manner.style()))
    }
}

/// A project, or a filled form.
fn opened(path: &Path, manner: &Manner) -> Result<Opened> {
    if !has_ending(path, "xlsx") {
        return Ok(manner.open(path)?.opened);
    }
    let file = path.display().to_string();
    let form = read_score_form(&dolmen_folder::read(
        path,
        manner.access().most(TABLE_BYTES_MOST),
    )?);
    let text = form.with_context(|| file.clone())?.project_text();
    Ok(Opened::read(text, file, &NoFiles)?)
}

fn has_ending(path: &Path, ending: &str) -> bool {
    path.extension().is_some_and(|of| of.eq_ignore_ascii_case(ending))
}

/// Writes the form to fill in at a pagoda.
fn form(path: &Path, manner: &Manner) -> Result<()> {
    let outputs = Outputs::new(manner.access());
    outputs.refuse(path)?;
    let (language, imprint) = (manner.language(), report::imprint(None));
    let bytes = match (has_ending(path, "xlsx"), has_ending(path, "html")) {
        (true, _) => score_form_workbook(language, &imprint)?,
        (_, true) => score_form_html(language, &imprint).into_bytes(),
        _ => return Err(CommandError::FormFormat.into()),
    };
    outputs.file(path, &bytes)?;
    if !manner.quiet {
        say(&format!("{}\n", path.display()))?;
    }
    Ok(())
}

fn quality(options: &Options, manner: &Manner) -> Result<()> {
    let designs = designs(options.designs.as_deref(), manner)?;
    let found = score_quality(&designs)?;
    if manner.json {
        say_json(&score_quality_json(&found, designs.designs.len()))
    } else {
        say(&score_quality_text(&found, designs.designs.len(), manner.style()))
    }
}

fn train(options: &Options, project: &Path, name: &str, output: &Path, manner: &Manner) -> Result<()> {
    let found = manner.open(project)?;
    let outputs = Outputs::of(manner.access(), &found);
    outputs.refuse(output)?;
    let folder = StudyFolder::of(options.from.as_deref(), &found, name);
    let journals = || {
        let journals = folder.journals(name, &[]);
        journals.map_err(|why| WorkError::Outside {
            why: told_both(why.as_ref()),
        })
    };
    let designs = trained(study_designs(&found.opened, name, journals, &found.files)?);
    outputs.file(output, designs.designs.csv().as_bytes())?;
    if !manner.quiet {
        let said = Noted::Designs {
            designs: designs.designs.designs.len(),
            path: output.display().to_string(),
            left_out: designs.left_out,
        };
        note!("{}", said.text(manner));
    }
    Ok(())
}
