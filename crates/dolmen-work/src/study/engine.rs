//! Execution of a study: scans in chunks, each run on any free thread and written to the journal as it ends. The results depend only on the
//! inputs.

use super::before::EarlierShaking;
use super::error::StudyError;
use super::inputs::{Drawn, drawn};
use super::journal::Journal;
use super::model::{Model, NoModel, model_of};
use super::motions::PreparedMotion;
use super::plan::Plan;
use super::run::{Run, RunOutcome};
use crate::error::WorkError;
use crate::progress::{Progress, Stage};
use crate::stack::study::run_stacks;
use crate::{building, chain, frame, stack};
use dolmen::assess::{ScaleTrial, next_in_bracket};
use dolmen::blocks::StackRun;
use dolmen_words::message::Both;
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Fewest and most runs given to a thread at once; they run in parallel in the lanes of the vector unit. Our choice: more fill the lanes
/// longer, fewer spread over the threads.
const BATCH: [usize; 2] = [8, 64];
/// Scans prepared at once for each thread. Our choice: keeps memory small and threads busy.
const CHUNK_A_THREAD: usize = 32;
/// The damage state of a fall: all four are reached.
const ALL_STATES: u8 = 4;

/// A scan in progress.
struct Job<'p> {
    job: usize,
    model: Result<Model, NoModel>,
    before: Option<&'p EarlierShaking>,
    motion: Option<PreparedMotion>,
    turn_rad: f64,
    grid: Vec<f64>,
    runs: Vec<Run>,
}

/// Destination of the runs of a study, and receiver of its progress.
struct Sink<'a> {
    journal: &'a dyn Journal,
    progress: &'a dyn Progress,
    ended: AtomicUsize,
}

/// All runs of a shard, including earlier ones; fewer if it was stopped. Each is written to the journal when it ends.
///
/// # Errors
/// [`WorkError`] if the journal cannot be written.
pub fn run(
    plan: &Plan<'_>,
    shard: (usize, usize),
    done: Vec<Run>,
    journal: &dyn Journal,
    progress: &dyn Progress,
) -> Result<Vec<Run>, WorkError> {
    let sink = Sink {
        journal,
        progress,
        ended: AtomicUsize::new(0),
    };
    let jobs = jobs_of(plan, shard);
    let mut before: BTreeMap<usize, Vec<Run>> = BTreeMap::new();
    for run in done {
        before.entry(run.job).or_default().push(run);
    }
    let steps = plan
        .study
        .scan
        .as_ref()
        .map_or(0, |scan| scan.steps() + plan.study.refine as usize);
    progress.begin(&Stage::Runs {
        about: jobs.len() * steps,
    });
    let mut all = Vec::new();
    for chunk in jobs.chunks(CHUNK_A_THREAD * rayon::current_num_threads()) {
        if progress.is_cancelled() {
            break;
        }
        let mut scans: Vec<Job<'_>> = chunk
            .par_iter()
            .map(|&job| prepare(plan, job, before.get(&job).cloned().unwrap_or_default()))
            .collect::<Result<_, WorkError>>()?;
        for scan in &mut scans {
            if let (Err(why), true) = (&scan.model, scan.runs.is_empty()) {
                let (why, outcome, damage_state) = match why {
                    NoModel::Refused(why) => (why, RunOutcome::Refused, 0),
                    NoModel::FallsAlone(why) => (why, RunOutcome::Fell, ALL_STATES),
                };
                let run = Run {
                    why: why.clone(),
                    outcome,
                    damage_state,
                    ..Run::empty(scan.job)
                };
                journal.append(&run)?;
                scan.runs.push(run);
            }
            // a structure that has fallen stands at no size of a second motion
            if let (Ok(_), true, Some(EarlierShaking::Fell(state))) =
                (&scan.model, scan.runs.is_empty(), scan.before)
            {
                let run = state.fallen(scan.job);
                journal.append(&run)?;
                scan.runs.push(run);
            }
        }
        loop {
            let wanted = wanted(plan, &scans)?;
            if wanted.is_empty() || progress.is_cancelled() {
                break;
            }
            let share = wanted.len() / (2 * rayon::current_num_threads());
            let found: Vec<Vec<(usize, Run)>> = wanted
                .par_chunks(share.clamp(BATCH[0], BATCH[1]))
                .map(|batch| run_batch(plan, &scans, batch, &sink))
                .collect::<Result<_, WorkError>>()?;
            for (index, run) in found.into_iter().flatten() {
                scans[index].runs.push(run);
            }
        }
        all.extend(scans.into_iter().flat_map(|scan| scan.runs));
    }
    let reached: BTreeSet<usize> = all.iter().map(|run: &Run| run.job).collect();
    before.retain(|job, _| !reached.contains(job)); // of chunks that were not reached
    all.extend(before.into_values().flatten());
    progress.end();
    Ok(all)
}

/// The scans of a shard.
fn jobs_of(plan: &Plan<'_>, (part, of): (usize, usize)) -> Vec<usize> {
    (0..plan.jobs()).filter(|job| job % of == part - 1).collect()
}

/// Scans of a shard that are not done.
pub fn missing(plan: &Plan<'_>, shard: (usize, usize), runs: &[Run]) -> Vec<usize> {
    let mut by_job: BTreeMap<usize, Vec<&Run>> = BTreeMap::new();
    for run in runs {
        by_job.entry(run.job).or_default().push(run);
    }
    let is_done = |job: &usize| {
        let Some(runs) = by_job.get(job) else { return false };
        if runs.iter().any(|run| run.scale == 0.0) {
            return true; // refused, or it falls by itself: there is nothing to scan
        }
        let trials: Vec<ScaleTrial> = runs.iter().map(|run| trial(run)).collect();
        let Some(grid) = plan.grid_of(*job) else {
            return false;
        };
        let whole = grid
            .iter()
            .all(|scale| runs.iter().any(|run| run.scale == *scale));
        whole && matches!(next_in_bracket(&grid, &trials, plan.study.refine), Ok(None))
    };
    jobs_of(plan, shard)
        .into_iter()
        .filter(|job| !is_done(job))
        .collect()
}

fn prepare<'p>(plan: &'p Plan<'_>, job: usize, runs: Vec<Run>) -> Result<Job<'p>, WorkError> {
    let (turns, samples) = (plan.study.turns_rad.len(), plan.samples());
    let case = job / (plan.motions.len() * turns);
    let mut scan = Job {
        job,
        model: Err(NoModel::Refused(Both::from(""))),
        before: None,
        motion: None,
        turn_rad: plan.study.turns_rad[job % turns],
        grid: Vec::new(),
        runs,
    };
    let project = match plan.project(case / samples) {
        Ok(project) => project,
        Err(why) => {
            scan.model = Err(NoModel::Refused(why));
            return Ok(scan);
        }
    };
    let sample = match plan.study.samples {
        Some(_) => drawn(&project, plan.study.seed, (case % samples) as u64)?,
        None => Drawn::default(),
    };
    let motion;
    (motion, scan.turn_rad) = plan.motion(&project, job / turns % plan.motions.len(), scan.turn_rad)?;
    scan.grid = plan.scales(&motion);
    scan.motion = Some(motion);
    scan.model = model_of(plan.study, &project, &sample);
    scan.before = plan.before(case);
    if let (Ok(_), Some(EarlierShaking::Refused { why, .. })) = (&scan.model, scan.before) {
        scan.model = Err(NoModel::Refused(why.clone()));
    }
    Ok(scan)
}

fn trial(run: &Run) -> ScaleTrial {
    ScaleTrial {
        scale: run.scale,
        trial: run.outcome.trial(),
    }
}

/// Scans (indices) and scales to run next: missing points of the grids, and once these are complete, the middle of each bracket.
fn wanted(plan: &Plan<'_>, scans: &[Job<'_>]) -> Result<Vec<(usize, f64)>, WorkError> {
    let mut wanted = Vec::new();
    let is_shaken =
        |scan: &Job<'_>| scan.model.is_ok() && !matches!(scan.before, Some(EarlierShaking::Fell(_)));
    for (index, scan) in scans.iter().enumerate().filter(|(_, scan)| is_shaken(scan)) {
        let is_done = |scale: f64| scan.runs.iter().any(|run| run.scale == scale);
        let open: Vec<f64> = scan
            .grid
            .iter()
            .copied()
            .filter(|scale| !is_done(*scale))
            .collect();
        if open.is_empty() {
            let trials: Vec<ScaleTrial> = scan.runs.iter().map(trial).collect();
            let next = next_in_bracket(&scan.grid, &trials, plan.study.refine)?;
            wanted.extend(next.map(|scale| (index, scale)));
        } else {
            wanted.extend(open.into_iter().map(|scale| (index, scale)));
        }
    }
    Ok(wanted)
}

/// Runs a batch and returns its rows; stopped runs are missing.
fn run_batch(
    plan: &Plan<'_>,
    scans: &[Job<'_>],
    batch: &[(usize, f64)],
    sink: &Sink<'_>,
) -> Result<Vec<(usize, Run)>, WorkError> {
    if sink.progress.is_cancelled() {
        return Ok(Vec::new());
    }
    let mut found = Vec::with_capacity(batch.len());
    let mut keep = |index: usize, row: Option<Run>| -> Result<(), WorkError> {
        if let Some(row) = row {
            sink.journal.append(&row)?;
            let ended = 1 + sink.ended.fetch_add(1, Ordering::Relaxed);
            sink.progress.advance(ended as f64);
            found.push((index, row));
        }
        Ok(())
    };
    let options = stack::study::springs(plan.study);
    let mut of_stacks = Vec::new();
    for &(index, scale) in batch {
        let scan = &scans[index];
        let motion = scan.motion.as_ref().ok_or(StudyError::StudyWithoutMotion)?;
        let acting = motion.acting(scale, scan.turn_rad)?;
        let run = Run {
            scale,
            peak_ground_acceleration_m_s2: plan.peak_at(&scan.grid, scale, motion),
            peak_ground_velocity_m_s: scale * motion.velocity_m_s,
            ..Run::empty(scan.job)
        };
        let acting = match scan.before {
            Some(EarlierShaking::Left(left)) => left.then(&acting)?,
            Some(EarlierShaking::Unshaken(_) | EarlierShaking::Refused { .. } | EarlierShaking::Fell(_))
            | None => acting,
        };
        match &scan.model {
            Ok(Model::Stack(model)) => of_stacks.push((index, run, model, acting)),
            Ok(Model::Frame(model)) => keep(
                index,
                frame::study::row(plan.study, run, model, (&acting, sink.progress)),
            )?,
            Ok(Model::Chain(model)) => keep(
                index,
                chain::study::row(plan.study, run, model, (&acting, sink.progress)),
            )?,
            Ok(Model::Building(model)) => {
                keep(index, Some(building::study::row(plan.study, run, model, &acting)))?;
            }
            Err(_) => {}
        }
    }
    let runs: Vec<StackRun<'_>> = of_stacks
        .iter()
        .map(|(_, _, model, motion)| StackRun {
            stack: &model.0,
            motion: Some(motion),
            options: &options,
        })
        .collect();
    let mut failed = None;
    run_stacks(plan.study.law, &runs, sink.progress, &mut |place, history| {
        let (index, run, model, _) = &of_stacks[place];
        let kept = keep(
            *index,
            stack::study::row(plan.study, run.clone(), (&model.0, &model.1), history),
        );
        if let Err(fault) = kept {
            failed = Some(fault);
        }
    });
    match failed {
        Some(fault) => Err(fault),
        None => Ok(found),
    }
}
