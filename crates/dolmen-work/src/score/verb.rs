//! `dolmen score`: the six-factor score of a pagoda, its quality, and designs for its training.

use super::answer::{ScoreAnswer, ScoreQuality};
use super::designs::ScoreDesigns;
use crate::error::WorkError;
use crate::judgement::{Evidence, SevereDamage};
use crate::opened::Opened;
use crate::portfolio::unlike_words;
use crate::simulate::evidence;
use dolmen::assess::{SixFactors, Unlike, unlike_trained};
use dolmen_project::{Project, Quantity, Structure};
use dolmen_words::message::Both;
use rayon::prelude::*;

/// Slope above which a pagoda leans. Our choice.
const LEANS: f64 = 0.01;

/// Refuses a pagoda that is unlike the training designs, unless `outside_too`.
pub(crate) fn check_alike(project: &Project, outside_too: bool) -> Result<Vec<Unlike>, WorkError> {
    let mut unlike = unlike_but_frequency(project)?;
    if matches!(project.structure, Structure::Stack(_))
        && let Evidence::Contradicted(of) = evidence(project, None)?
    {
        unlike.push(Unlike::Frequency {
            measured_hz: of.measured_hz,
            computed_hz: of.computed_hz,
        });
    }
    allowed(unlike, outside_too)
}

/// The differences other than a measured frequency.
pub(super) fn unlike_but_frequency(project: &Project) -> Result<Vec<Unlike>, WorkError> {
    let Structure::Stack(part) = &project.structure else {
        return Ok(Vec::new());
    };
    let mut unlike = unlike_trained(&part.build(&mut Quantity::nominal)?);
    let count = project.damage.len();
    unlike.extend((count > 0).then_some(Unlike::Damage { count }));
    if let Some(lean) = &part.lean {
        let slope = lean.slope[0].hypot(lean.slope[1]);
        unlike.extend((slope >= LEANS).then_some(Unlike::Leans { slope }));
    }
    Ok(unlike)
}

/// Refuses differences, unless `outside_too`.
pub(super) fn allowed(unlike: Vec<Unlike>, outside_too: bool) -> Result<Vec<Unlike>, WorkError> {
    if !unlike.is_empty() && !outside_too {
        return Err(WorkError::PagodaUnlike {
            how: Both::of(|language| {
                let words: Vec<String> = unlike.iter().map(|one| unlike_words(one, language)).collect();
                words.join("; ")
            }),
        });
    }
    Ok(unlike)
}

/// The six factors of the pagoda of a project; `None` for another structure, or one given by blocks.
pub(crate) fn factors(project: &Project) -> Result<Option<SixFactors>, WorkError> {
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

/// The score of a pagoda; with `extrapolate` also for factors outside the training range.
///
/// # Errors
/// A project without a pagoda of six factors, a pagoda unlike the designs, too few designs.
pub fn score(opened: &Opened, designs: &ScoreDesigns, extrapolate: bool) -> Result<ScoreAnswer, WorkError> {
    factors_or_error(opened)?;
    let unlike = check_alike(&opened.project, extrapolate)?;
    scored(opened, designs, unlike, extrapolate)
}

/// The factors, or an error that the project has none.
pub(super) fn factors_or_error(opened: &Opened) -> Result<SixFactors, WorkError> {
    factors(&opened.project)?.ok_or_else(|| WorkError::NoPagoda {
        file: opened.file.clone(),
    })
}

/// The score of a pagoda whose differences were judged.
pub(super) fn scored(
    opened: &Opened,
    designs: &ScoreDesigns,
    unlike: Vec<Unlike>,
    extrapolate: bool,
) -> Result<ScoreAnswer, WorkError> {
    let project = &opened.project;
    let factors = factors_or_error(opened)?;
    let (trained, states) = ScoreAnswer::states_of(designs, &factors, extrapolate)?;
    Ok(ScoreAnswer {
        file: opened.file.clone(),
        name: project.name.clone(),
        factors,
        trained,
        unlike,
        severe_damage: SevereDamage::left_out(project),
        designs: designs.designs.len(),
        states,
        gravity_m_s2: project.gravity_m_s2,
    })
}

/// The quality of the score for each state.
///
/// # Errors
/// Too few designs.
pub fn score_quality(designs: &ScoreDesigns) -> Result<Vec<ScoreQuality>, WorkError> {
    let found: Vec<Option<ScoreQuality>> = (0..4)
        .into_par_iter()
        .map(|state| ScoreQuality::of(designs, state).ok())
        .collect();
    let found: Vec<ScoreQuality> = found.into_iter().flatten().collect();
    match found.is_empty() {
        true => Err(WorkError::TooFewDesigns {
            designs: designs.designs.len(),
        }),
        false => Ok(found),
    }
}
