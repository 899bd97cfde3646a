//! `dolmen score`: the six-factor score of a pagoda, what it is worth, and designs to train it on.

use crate::cli_portfolio::Score as Options;
use crate::{Outcome, files, open, study};
use anyhow::{Context as _, Result, bail};
use dolmen::assess::{ScoreModel, SixFactors};
use dolmen::structure::stack::{Joint, JointMaterial, PagodaFactors};
use dolmen_formats::json::{score_json, score_quality_json};
use dolmen_formats::project::{Project, Quantity, Structure};
use dolmen_formats::score::{ScoreAnswer, ScoreDesigns, ScoreQuality};
use dolmen_formats::text::{score_quality_text, score_text};
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

/// Part by which a material may differ from that of the designs and count as the same. Chosen here: granite is 2600 to 2700 kg/m³.
const ALIKE: f64 = 0.05;

/// How the pagoda of a project differs from those that the score was trained on in all but its factors, in words.
pub(crate) fn unlike_trained(project: &Project) -> Result<Vec<String>> {
    let Structure::Stack(part) = &project.structure else {
        return Ok(Vec::new());
    };
    let stack = part.build(&mut Quantity::nominal)?;
    let mut unlike: Vec<String> = Vec::new();
    let mut see = |what: &str, given: f64, trained: f64| {
        let words = format!("{what} is {given}, trained {trained}");
        if (given - trained).abs() > ALIKE * trained && !unlike.contains(&words) {
            unlike.push(words);
        }
    };
    let usual = JointMaterial::default();
    for joint in stack.joints() {
        let own = &joint.material;
        see("friction", own.friction_static, usual.friction_static);
        see("kinetic friction", own.friction_kinetic, usual.friction_kinetic);
        let stiffness = [own.normal_stiffness_pa_m, usual.normal_stiffness_pa_m];
        see("normal stiffness in Pa/m", stiffness[0], stiffness[1]);
        let stiffness = [own.shear_stiffness_pa_m, usual.shear_stiffness_pa_m];
        see("shear stiffness in Pa/m", stiffness[0], stiffness[1]);
        see("damping ratio of a joint", own.damping_ratio, usual.damping_ratio);
    }
    for block in stack.blocks() {
        see(
            "density in kg/m³",
            block.density_kg_m3,
            PagodaFactors::default().density_kg_m3,
        );
    }
    let has_bonds = |joint: &Joint| joint.material.cohesion_pa > 0.0 || joint.material.tension_pa > 0.0;
    for (is_so, words) in [
        (
            stack.joints().iter().any(has_bonds),
            "joints are bonded, trained dry",
        ),
        (
            !stack.ties().is_empty(),
            "it has dowels or clamps, trained without",
        ),
        (
            !stack.side_supports().is_empty(),
            "it has side supports, trained without",
        ),
    ] {
        if is_so {
            unlike.push(words.to_owned());
        }
    }
    Ok(unlike)
}

/// Refuses a pagoda that is unlike those that the score was trained on, unless told otherwise.
pub(crate) fn check_alike(project: &Project, outside_too: bool) -> Result<Vec<String>> {
    let unlike = unlike_trained(project)?;
    if !unlike.is_empty() && !outside_too {
        bail!(
            "the score does not know such a pagoda: {}. Simulate it with dolmen study, or force the score with --extrapolate",
            unlike.join("; ")
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
        eprintln!(
            "{} designs are in {}; {} were left out: scans are missing or cannot be used",
            found.designs.designs.len(),
            output.display(),
            found.left_out
        );
    }
    Ok(())
}
