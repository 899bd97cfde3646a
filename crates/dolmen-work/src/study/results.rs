//! From journals to answers: the requested studies, their stored runs, missing runs, and their combined results.

use super::answer::StudyAnswer;
use super::engine::missing;
use super::error::StudyError;
use super::harmonic::maps;
use super::journal::{JournalHeader, ReadJournal, read_journal};
use super::kind::StudyKind;
use super::left_out::LeftOutStudy;
use super::plan::Plan;
use super::run::Run;
use crate::check::falls_by_itself_as_given;
use crate::error::{Within as _, WorkError};
use crate::opened::Opened;
use crate::progress::Progress;
use crate::told::told_both;
use dolmen_project::StudyPart;
use dolmen_records::Files;
use std::collections::BTreeMap;

/// A journal as text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct JournalText {
    /// Its file, for the user.
    pub shown: String,
    /// The text.
    pub text: String,
}

/// The journals of an earlier study.
#[derive(Debug)]
pub struct StudyJournals {
    /// The study.
    pub study: String,
    /// Its journals, or why they cannot be read.
    pub journals: Result<Vec<JournalText>, WorkError>,
}

/// The requested studies of a project: those named, or all.
///
/// # Errors
/// An unknown name, a file without studies, a structure that falls under its own weight.
pub fn studies<'o>(opened: &'o Opened, named: &[String]) -> Result<Vec<&'o StudyPart>, WorkError> {
    let studies = &opened.project.studies;
    let mut meant: Vec<&StudyPart> = Vec::new();
    for name in named {
        let Some(study) = studies.iter().find(|study| study.name == *name) else {
            let names: Vec<&str> = studies.iter().map(|study| study.name.as_str()).collect();
            return Err(StudyError::NoSuchStudy {
                name: name.clone(),
                known: names.join(", "),
            }
            .into());
        };
        meant.push(study);
    }
    if named.is_empty() {
        meant.extend(studies);
    }
    if meant.is_empty() {
        return Err(StudyError::NoStudy.into());
    }
    if let Some(load_factor) = falls_by_itself_as_given(&opened.project)? {
        return Err(StudyError::StudyOfWhatFalls { load_factor }.into());
    }
    Ok(meant)
}

/// The contents of a journal, for a study that continues: the number of bytes in complete lines, and its runs.
///
/// # Errors
/// A journal of another study or of another state of this one.
pub fn resumed(
    header: &JournalHeader,
    kind: StudyKind,
    journal: &JournalText,
) -> Result<(usize, Vec<Run>), WorkError> {
    // a process killed before the header was complete leaves a part of it
    if !journal.text.contains('\n') {
        return Ok((0, Vec::new()));
    }
    let read = checked(header, kind, journal)?;
    Ok((read.whole_bytes, unique(read.runs, &journal.shown)?))
}

/// The runs of several journals of one study, without duplicates.
///
/// # Errors
/// A journal of another study or of another state of this one; two different results for one run.
pub fn merged(plan: &Plan<'_>, journals: &[JournalText]) -> Result<Vec<Run>, WorkError> {
    let header = plan.header((1, 1));
    let mut all = Vec::new();
    for journal in journals {
        all.extend(checked(&header, plan.kind, journal)?.runs);
    }
    unique(all, "the journals")
}

fn checked(header: &JournalHeader, kind: StudyKind, journal: &JournalText) -> Result<ReadJournal, WorkError> {
    let read = read_journal(&journal.text, kind).within(|| journal.shown.clone())?;
    match header.difference(&read.header) {
        Some(difference) => Err(StudyError::OtherJournal {
            shown: journal.shown.clone(),
            difference,
        }
        .into()),
        None => Ok(read),
    }
}

/// The runs without duplicates; two with the same inputs must be equal to the last bit.
fn unique(runs: Vec<Run>, shown: &str) -> Result<Vec<Run>, WorkError> {
    let mut seen: BTreeMap<(usize, u64), Run> = BTreeMap::new();
    for run in runs {
        let key = (run.job, run.scale.to_bits());
        match seen.get(&key) {
            Some(other) if !other.is_same(&run) => {
                return Err(StudyError::RunTwice {
                    shown: shown.to_owned(),
                    scan: run.job + 1,
                    scale: run.scale,
                }
                .into());
            }
            Some(_) => {}
            None => {
                seen.insert(key, run);
            }
        }
    }
    Ok(seen.into_values().collect())
}

/// The combined results of the runs of a study, with its maps of harmonic motions.
///
/// # Errors
/// If the inputs of every run were refused, or a map cannot be computed.
pub fn finish(plan: &Plan<'_>, runs: Vec<Run>, progress: &dyn Progress) -> Result<StudyAnswer, WorkError> {
    let answer = answered(plan, runs, progress)?;
    let all_refused = !answer.runs.is_empty() && answer.runs.iter().all(Run::is_refused);
    match answer.runs.first().filter(|_| all_refused) {
        Some(first) => Err(StudyError::EveryRunRefused {
            why: first.why.clone(),
        }
        .into()),
        None => Ok(answer),
    }
}

fn answered(plan: &Plan<'_>, runs: Vec<Run>, progress: &dyn Progress) -> Result<StudyAnswer, WorkError> {
    let missing = missing(plan, (1, 1), &runs);
    let mut answer = plan.answer(runs, missing);
    answer.maps = maps(plan, progress)?;
    Ok(answer)
}

/// The answers of earlier studies, from their journals; those of another state of the file are left out and named.
pub fn studies_run(
    opened: &Opened,
    journals: Vec<StudyJournals>,
    files: &dyn Files,
    progress: &dyn Progress,
) -> (Vec<StudyAnswer>, Vec<LeftOutStudy>) {
    let (mut found, mut left_out) = (Vec::new(), Vec::new());
    for StudyJournals { study, journals } in journals {
        let Some(part) = opened.project.studies.iter().find(|part| part.name == study) else {
            continue;
        };
        let answer = Plan::of(opened, part, files)
            .and_then(|plan| answered(&plan, merged(&plan, &journals?)?, progress));
        match answer {
            Ok(answer) => found.push(answer),
            Err(why) => left_out.push(LeftOutStudy {
                study,
                why: told_both(&why),
            }),
        }
    }
    (found, left_out)
}
