//! `dolmen score`: the six-factor score of a pagoda, what it is worth, and designs to train it on.

use crate::cli_portfolio::Score as Options;
use crate::{Outcome, files, open, study};
use anyhow::{Context as _, Result, bail};
use dolmen::assess::{ScoreModel, SixFactors, Unlike, unlike_trained};
use dolmen_project::{Project, Quantity, Structure};
use dolmen_report::json::{score_json, score_quality_json};
use dolmen_report::text::{score_quality_text, score_text};
use dolmen_work::score::{ScoreAnswer, ScoreDesigns, ScoreQuality, unlike_words};
use rayon::prelude::*;
use std::path::Path;

pub(crate) fn run(options: &Options, as_json: bool, quiet: bool) -> Result<Outcome> {
    match (&options.train, &options.project, &options.output) {
        (Some(name), Some(project), Some(output)) => train(options, project, name, output, quiet)?,
        (_, Some(project), _) => one(options, project, as_json)?,
        _ => quality(options, as_json)?,
    }
    Ok(Outcome::Stands)
}

/// The designs of a file, or those that come with Dolmen.
pub(crate) fn designs(path: Option<&Path>) -> Result<ScoreDesigns> {
    match path {
        Some(path) => ScoreDesigns::read(&files::read(path)?).with_context(|| path.display().to_string()),
        None => Ok(ScoreDesigns::shipped()?),
    }
}

/// Refuses a pagoda that is unlike those that the score was trained on, unless told otherwise.
pub(crate) fn check_alike(project: &Project, outside_too: bool) -> Result<Vec<Unlike>> {
    let Structure::Stack(part) = &project.structure else {
        return Ok(Vec::new());
    };
    let unlike = unlike_trained(&part.build(&mut Quantity::nominal)?);
    if !unlike.is_empty() && !outside_too {
        bail!(
            "the score does not know such a pagoda: {}. Simulate it with dolmen study, or force the score with --extrapolate",
            unlike_words(&unlike)
        );
    }
    Ok(unlike)
}

/// The six factors of the pagoda of a project; `None` if it has another structure, or blocks.
pub(crate) fn factors(project: &Project) -> Result<Option<SixFactors>> {
    let Structure::Stack(part) = &project.structure else {
        return Ok(None);
    };
    let Some(pagoda) = &part.pagoda else {
        return Ok(None);
    };
    Ok(Some(SixFactors::of_pagoda(
        &pagoda.factors(&mut Quantity::nominal),
    )?))
}

fn one(options: &Options, path: &Path, as_json: bool) -> Result<()> {
    let designs = designs(options.designs.as_deref())?;
    let open::Opened { project, file } = open::project(path)?;
    let Some(factors) = factors(&project)? else {
        bail!(
            "{} has no pagoda of six factors: write pagoda = {{ storeys = 5, body_height = 6.0, … }} in a stack, or simulate its blocks with \
             dolmen study",
            file.display()
        );
    };
    let unlike = check_alike(&project, options.extrapolate)?;
    let (trained, states) = ScoreAnswer::states_of(&designs, &factors, options.extrapolate)?;
    let answer = ScoreAnswer {
        file: file.display().to_string(),
        name: project.name.clone(),
        factors,
        trained,
        unlike,
        designs: designs.designs.len(),
        states,
        gravity_m_s2: project.gravity_m_s2,
    };
    if as_json {
        files::say(&format!("{:#}\n", score_json(&answer)))
    } else {
        files::say(&score_text(&answer))
    }
}

fn quality(options: &Options, as_json: bool) -> Result<()> {
    let designs = designs(options.designs.as_deref())?;
    let found: Vec<Option<ScoreQuality>> = (0..4)
        .into_par_iter()
        .map(|state| ScoreQuality::of(&designs, state).ok())
        .collect();
    let found: Vec<ScoreQuality> = found.into_iter().flatten().collect();
    if found.is_empty() {
        bail!(
            "{} designs are too few for a score: 50 and more with a curve are needed",
            designs.designs.len()
        );
    }
    if as_json {
        files::say(&format!(
            "{:#}\n",
            score_quality_json(&found, designs.designs.len())
        ))
    } else {
        files::say(&score_quality_text(&found, designs.designs.len()))
    }
}

fn train(options: &Options, project: &Path, name: &str, output: &Path, quiet: bool) -> Result<()> {
    let mut found = study::designs(project, name, options.from.as_deref())?;
    let own = &found.designs;
    let settings: Vec<_> = (0..4)
        .into_par_iter()
        .map(|state| ScoreModel::settings(&own.of_state(state)).ok())
        .collect();
    for (place, settings) in found.designs.settings.iter_mut().zip(settings) {
        *place = settings;
    }
    files::write(output, found.designs.csv().as_bytes())?;
    if !quiet {
        note!(
            "{} designs are in {}; {} were left out: scans are missing or cannot be used",
            found.designs.designs.len(),
            output.display(),
            found.left_out
        );
    }
    Ok(())
}
