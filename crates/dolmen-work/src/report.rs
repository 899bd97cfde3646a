//! `dolmen report`: all answers for one project.

use crate::answer::{Answer, CheckAnswer, FileRead, ProjectReport};
use crate::building::tune;
use crate::check::{CheckOptions, Sampling, check};
use crate::compare::compared_of;
use crate::compared_surveys::surveys_to_compare;
use crate::error::WorkError;
use crate::fingerprint::fingerprint;
use crate::identify::{IdentifyOptions, identify};
use crate::judgement::{Evidence, drift_left};
use crate::kinds;
use crate::motion::{MotionRequest, prepared};
use crate::opened::Opened;
use crate::photos::photos;
use crate::progress::Progress;
use crate::simulate::{SimulateOptions, is_loose, moves_supports, prepare, settle, settle_and_shake};
use crate::simulation::SimulateAnswer;
use crate::study::{StudyJournals, studies_run};
use crate::tilt_left_out::TiltLeftOut;
use crate::unreadable_motions::unreadable_motions;
use crate::version::Version;
use crate::watch::{can_watch, watch_of};
use dolmen::stability::Verdict;
use dolmen_project::{Structure, TemperaturePart};
use dolmen_records::{Files, RECORD_BYTES_MOST};

/// Options of a report.
#[derive(Debug, Default)]
pub struct ReportOptions {
    /// Samples of the uncertain inputs; none for a stack, whose verdict has no load factor.
    pub sampling: Option<Sampling>,
    /// The motion of the simulations; without one, none are run.
    pub motion: MotionRequest,
    /// The journals of earlier studies.
    pub journals: Vec<StudyJournals>,
}

/// The check, the surveys, the change between them, simulations, dampers, and studies of a project.
///
/// # Errors
/// [`WorkError`] of any of them and of photographs; studies with errors are left out and named.
pub fn report(
    opened: &Opened,
    options: ReportOptions,
    files: &dyn Files,
    progress: &dyn Progress,
) -> Result<ProjectReport, WorkError> {
    let project = &opened.project;
    let photos = photos(opened, files)?; // before the long computations
    let is_shaken = options.motion.is_given();
    let is_stack = matches!(project.structure, Structure::Stack(_));
    let identified = identify(opened, &IdentifyOptions::default(), files, progress)?;
    let how = CheckOptions {
        sampling: options.sampling.filter(|_| !is_stack),
        sensitivity: true,
        beside_the_verdict: true,
    };
    let mut checked = match is_loose(project) {
        true => CheckAnswer::without_model(opened), // loose stones settle instead
        false => check(opened, &how)?,
    };
    checked.unreadable_motions = unreadable_motions(project, files);
    let mut answers = Vec::new();
    let is_watched = can_watch(project);
    // `watch` removes the effect of the weather; a comparison of only the first and the last survey does not, unless the file gives the
    // temperature coefficient
    let is_covered = is_watched && project.change.temperature == TemperaturePart::Unknown;
    if !is_covered && let Ok(compared) = surveys_to_compare(project, None, None) {
        answers.push(Answer::Compare(Box::new(compared_of(
            opened,
            &compared,
            &identified.surveys,
            files,
        )?)));
    }
    if is_watched {
        let watched = watch_of(opened, &identified.surveys, files)?;
        answers.push(Answer::Watch(Box::new(watched)));
    }
    if is_loose(project) {
        let settled = settled(opened, &options.motion, files, progress)?;
        answers.push(Answer::Simulate(Box::new(settled)));
    } else if is_shaken {
        let simulated = simulated(opened, &checked, &options.motion, files, progress)?;
        answers.push(Answer::Simulate(Box::new(simulated)));
    } else if let Some(moved) = supports_moved(opened, files, progress)? {
        answers.push(Answer::Simulate(Box::new(moved)));
    }
    answers.push(Answer::Tune(tune::of_report(opened, files)?));
    let (studies, left_out) = studies_run(opened, options.journals, files, progress);
    answers.extend(studies.into_iter().map(|study| Answer::Study(Box::new(study))));
    answers.splice(
        0..0,
        [
            Answer::Check(Box::new(checked)),
            Answer::Identify(Box::new(identified)),
        ],
    );
    Ok(ProjectReport {
        file: opened.file.clone(),
        project: opened.project.clone(),
        answers,
        left_out,
        photos,
        fingerprint: fingerprint(opened.text.as_bytes()),
        files: files_read(files),
    })
}

/// The files read so far, each with its hash.
fn files_read(files: &dyn Files) -> Vec<FileRead> {
    let of = |name: String| {
        let bytes = files.read(&name, RECORD_BYTES_MOST).ok()?;
        Some(FileRead {
            bytes: bytes.len(),
            fingerprint: fingerprint(&bytes),
            name,
        })
    };
    files.names_read().into_iter().filter_map(of).collect()
}

/// The loose stones at rest, by both laws, and then under the motion if there is one.
fn settled(
    opened: &Opened,
    request: &MotionRequest,
    files: &dyn Files,
    progress: &dyn Progress,
) -> Result<SimulateAnswer, WorkError> {
    if !request.is_given() {
        return settle(opened, progress);
    }
    let options = SimulateOptions {
        motion: request.clone(),
        ..SimulateOptions::default()
    };
    settle_and_shake(opened, &options, files, progress)
}

/// The stack as it is with slowly moving supports, if the file has movements and there is no motion.
fn supports_moved(
    opened: &Opened,
    files: &dyn Files,
    progress: &dyn Progress,
) -> Result<Option<SimulateAnswer>, WorkError> {
    let options = SimulateOptions::default();
    if !moves_supports(&opened.project) {
        return Ok(None);
    }
    let moved = SimulateAnswer {
        evidence: Evidence::none(), // from the check
        basis: None,
        ..prepare(opened, &options, files)?.run(progress)?
    };
    Ok(moved.does_not_stand.is_none().then_some(moved))
}

/// Every version that can be simulated, as it is and in its variants; none if a stack does not stand as it is.
fn simulated(
    opened: &Opened,
    checked: &CheckAnswer,
    request: &MotionRequest,
    files: &dyn Files,
    progress: &dyn Progress,
) -> Result<SimulateAnswer, WorkError> {
    let mut simulations = Vec::new();
    for version in Version::all(&opened.project, &opened.file) {
        if let Structure::Stack(_) = version.project.structure {
            let states = checked.variants.iter();
            let state = match version.variant {
                None => checked.state.as_ref(),
                Some(name) => states
                    .clone()
                    .find(|variant| variant.name == name)
                    .map(|variant| &variant.state),
            };
            let stands = state.is_some_and(|state| state.verdict() != Verdict::Unstable);
            if !stands {
                match version.variant {
                    None => break,
                    Some(_) => continue,
                }
            }
        }
        if !kinds::can_move(version.project) {
            continue;
        }
        let motion = prepared(request, (version.project, files))?;
        simulations.extend(kinds::simulated_for_report(&version, motion, progress)?);
    }
    Ok(SimulateAnswer {
        file: opened.file.clone(),
        simulations,
        variant: None,
        does_not_stand: None,
        evidence: Evidence::none(), // from the check, like the next fields
        without_shaking: None,
        tilt_beyond_limit: false, // from the check, as above
        tilt_left_out: TiltLeftOut::of_runs(&opened.project),
        drift_left: drift_left(&opened.project),
        after: None,
        damage: Vec::new(), // from the check as well
        basis: None,
    })
}
