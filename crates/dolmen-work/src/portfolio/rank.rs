//! `dolmen rank`: many structures in order of priority.

use super::answer::{LeftOut, PortfolioAnswer, PortfolioEntry, of_score, of_study};
use super::table::{PortfolioRow, PortfolioTable, RowSource};
use crate::error::WorkError;
use crate::judgement::SevereDamage;
use crate::opened::Opened;
use crate::progress::Silent;
use crate::score::{ScoreDesigns, check_alike, factors};
use crate::study::StudyError;
use crate::study::{StudyAnswer, StudyJournals, studies_run};
use crate::told::told_both;
use dolmen::assess::{Hazard, ScoreModel, Unlike};
use dolmen_project::Structure;
use dolmen_records::Files;
use dolmen_words::message::Both;
use rayon::prelude::*;

/// Number of reasons given if no structure can be ranked.
const REASONS_MOST: usize = 10;

/// Options of a ranking.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RankOptions {
    /// Damage state to rank by, 0 to 3.
    pub state: usize,
    /// Whether to rank pagodas with factors outside the training range.
    pub extrapolate: bool,
    /// Number of draws for the intervals of the ranks.
    pub draws: usize,
}

/// A project of a portfolio, with its files and the journals of its studies.
pub struct FoundProject {
    /// The project.
    pub opened: Opened,
    /// Its files.
    pub files: Box<dyn Files>,
    /// The journals of its studies.
    pub journals: Vec<StudyJournals>,
}

/// Access to the projects of a portfolio.
pub trait Projects: Send + Sync {
    /// The project at `path`, as written in the table.
    ///
    /// # Errors
    /// [`WorkError`] if there is none or it cannot be read.
    fn open(&self, path: &str) -> Result<FoundProject, WorkError>;
}

/// The models of the four states, and the state of the ranking.
struct Scores<'a> {
    models: [Option<ScoreModel>; 4],
    options: &'a RankOptions,
}

/// The structures of a table in their order, with intervals and reasons.
///
/// # Errors
/// If none can be ranked.
pub fn rank(
    source: String,
    table: PortfolioTable,
    designs: &ScoreDesigns,
    options: &RankOptions,
    projects: &dyn Projects,
) -> Result<PortfolioAnswer, WorkError> {
    let PortfolioTable {
        rows,
        refused,
        left_out: columns_left_out,
    } = table;
    let scores = Scores {
        models: std::array::from_fn(|state| designs.model(state).ok()),
        options,
    };
    let found: Vec<Result<PortfolioEntry, LeftOut>> = rows
        .par_iter()
        .map(|row| {
            entry(row, projects, &scores).map_err(|why| LeftOut {
                name: row.name.clone(),
                why: told_both(&why),
            })
        })
        .collect();
    let bad = refused.into_iter().map(|(name, why)| LeftOut {
        name,
        why: told_both(&why),
    });
    let (mut entries, mut left_out) = (Vec::new(), bad.collect::<Vec<_>>());
    for one in found {
        match one {
            Ok(entry) => entries.push(entry),
            Err(why) => left_out.push(why),
        }
    }
    let without_place = PortfolioAnswer::without_place(&entries, options.state);
    if without_place.len() == entries.len() {
        left_out.extend(without_place);
        let reasons = |language| -> String {
            let told = left_out.iter().take(REASONS_MOST);
            told.map(|one| {
                format!(
                    "
  {}: {}",
                    one.name,
                    one.why.text(language)
                )
            })
            .collect()
        };
        return Err(WorkError::NoneRanked {
            structures: left_out.len(),
            reasons: Both::of(reasons),
        });
    }
    let mut answer = PortfolioAnswer::of(source, options.state, entries, left_out, options.draws)?;
    answer.designs = designs.designs.len();
    answer.columns_left_out = columns_left_out;
    Ok(answer)
}

fn entry(
    row: &PortfolioRow,
    projects: &dyn Projects,
    scores: &Scores<'_>,
) -> Result<PortfolioEntry, WorkError> {
    let name = row.name.clone();
    let RankOptions {
        state, extrapolate, ..
    } = *scores.options;
    let scored = |factors, unlike: &[Unlike], hazard| {
        if scores.models[state].is_none() {
            return Err(WorkError::TooFewDesignsOfState);
        }
        Ok(of_score(
            name.clone(),
            (factors, unlike),
            &scores.models,
            state,
            extrapolate,
            hazard,
        )?)
    };
    match &row.source {
        RowSource::Factors(factors) => scored(factors, &[], row.hazard.clone()),
        RowSource::Project { path, study } => {
            let FoundProject {
                opened,
                files,
                journals,
            } = projects.open(path)?;
            let (project, file) = (&opened.project, &opened.file);
            let own = project.site.as_ref().and_then(|site| site.hazard.as_ref());
            let own: Option<Hazard> = own.map(|hazard| hazard.curve.clone());
            let replaced = row.hazard.is_some() && own.is_some() && row.hazard != own;
            let hazard = row.hazard.clone().or(own);
            let (mut found, _) = studies_run(&opened, journals, &*files, &Silent);
            if let Some(wanted) = study {
                found.retain(|one| one.study.name == *wanted);
                if found.is_empty() {
                    return Err(StudyError::StudyNotRun {
                        study: wanted.clone(),
                        file: file.clone(),
                    }
                    .into());
                }
            }
            // the capacity after another motion is not that of the structure as it is now
            let is_own = |one: &StudyAnswer| study.is_some() || one.study.after.is_none();
            found.retain(|one| one.study.scan.is_some() && is_own(one));
            let mut entry = match found.as_slice() {
                [one] => of_study(name.clone(), one, hazard).map_err(|why| WorkError::CaseRefused { why }),
                [] => match factors(project)? {
                    Some(factors) => {
                        let unlike = check_alike(project, extrapolate)?;
                        scored(&factors, &unlike, hazard)
                    }
                    None if matches!(project.structure, Structure::Survey) => Err(WorkError::SurveyToRank),
                    None if project.studies.is_empty() => {
                        Err(WorkError::NoStudyToRankBy { file: file.clone() })
                    }
                    None => Err(WorkError::NothingToRankBy { file: file.clone() }),
                },
                several => {
                    let names: Vec<&str> = several.iter().map(|one| one.study.name.as_str()).collect();
                    Err(StudyError::SeveralStudies {
                        names: names.join(", "),
                    }
                    .into())
                }
            }?;
            entry.hazard_replaced = replaced;
            entry.severe_damage = SevereDamage::left_out(project);
            Ok(entry)
        }
    }
}
