//! `dolmen study`: runs over grids of inputs, samples, motions and increasing shaking, which can be resumed, sharded and merged.

use crate::cli::{Study as Options, StudyAction, StudyWhere};
use crate::manner::Manner;
use crate::note::note;
use crate::outcome::Outcome;
use crate::progress::Terminal;
use crate::say::{say, say_json};
use crate::typed::Typed;
use crate::wrong::{CommandError, Noted};
use crate::{signals, tools};
use anyhow::{Context as _, Result};
use dolmen_folder::{StudyFolder, shard};
use dolmen_report::against_studies_text;
use dolmen_report::json::{missing_json, shard_json, study_json};
use dolmen_report::text::{missing_text, shard_text, study_text};
use dolmen_work::study::{self, Plan, Run, merged, studies};
use dolmen_work::{FlagVerb, evidence_of};
use std::path::PathBuf;

pub(crate) fn run(options: &Options, typed: &Typed, manner: &Manner) -> Result<Outcome> {
    match &options.action {
        Some(StudyAction::Merge { place, from }) => each((place, typed, manner), |plan, folder| {
            let journals = folder.journals(&plan.study.name, from)?;
            let runs = merged(plan, &journals)?;
            let own = folder.journal_file((1, 1)).display().to_string();
            if journals.iter().any(|journal| journal.shown != own) {
                folder.keep(&plan.header((1, 1)), plan.kind, &runs)?;
            }
            finish(plan, folder, runs, manner)
        }),
        Some(StudyAction::Missing { place, from }) => each((place, typed, manner), |plan, folder| {
            missing(plan, folder, from, manner.json)
        }),
        None => each((&options.place, typed, manner), |plan, folder| {
            simulated(options, plan, folder, manner)
        }),
    }
}

/// Calls a closure for each selected study.
fn each(
    (place, typed, manner): (&StudyWhere, &Typed, &Manner),
    act: impl Fn(&Plan<'_>, &StudyFolder) -> Result<Outcome>,
) -> Result<Outcome> {
    let project = place.project.as_deref();
    let project = project.ok_or(CommandError::NameProject)?;
    let found = manner.open(project)?;
    typed.refuse_foreign(FlagVerb::Study, &[&found.opened.project])?;
    let found = found.with_stiffness_of_surveys(&Terminal::new(manner.quiet))?;
    let meant = studies(&found.opened, &place.study)?;
    if !manner.json {
        say(&against_studies_text(
            &found.opened.project,
            &meant,
            &evidence_of(&found.opened)?,
            manner.style(),
        ))?;
    }
    let mut worst = Ok(Outcome::Done);
    for study in meant {
        let done = Plan::of(&found.opened, study, &found.files)
            .map_err(anyhow::Error::new)
            .and_then(|plan| {
                let folder = StudyFolder::of(place.output.as_deref(), &found, &study.name);
                act(&plan, &folder)
            });
        let done = done.with_context(|| format!("study \"{}\"", study.name));
        worst = match (worst, done) {
            (Ok(Outcome::Done), done) => done,
            (Ok(_), Err(fault)) => Err(fault),
            (worst, Ok(_)) => worst,
            (Err(first), Err(fault)) => {
                tools::complain(&fault, manner); // the first is returned at the end
                Err(first)
            }
        };
        if signals::asked_to_stop() {
            break;
        }
    }
    worst
}

fn simulated(options: &Options, plan: &Plan<'_>, folder: &StudyFolder, manner: &Manner) -> Result<Outcome> {
    let shard = match &options.shard {
        Some(text) => shard(text)?,
        None => (1, 1),
    };
    let (journal, done) = folder.journal(&plan.header(shard), plan.kind, options.restart)?;
    let resumed = done.len();
    if resumed > 0 && !manner.quiet {
        let said = Noted::RunsKept {
            journal: folder.journal_file(shard).display().to_string(),
            runs: resumed,
        };
        note!("{}", said.text(manner));
    }
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(options.threads.unwrap_or(0))
        .build()?;
    let runs = pool.install(|| study::run(plan, shard, done, &journal, &Terminal::new(manner.quiet)))?;
    drop(journal);
    if shard.1 > 1 {
        return shard_done(plan, folder, shard, &runs, manner.json);
    }
    finish(plan, folder, runs, manner)
}

/// Ends a shard with its sentence; its result is the journal.
fn shard_done(
    plan: &Plan<'_>,
    folder: &StudyFolder,
    shard: (usize, usize),
    runs: &[Run],
    as_json: bool,
) -> Result<Outcome> {
    let missing = study::missing(plan, shard, runs);
    let (file, counts) = (
        folder.journal_file(shard).display().to_string(),
        [runs.len(), missing.len()],
    );
    if as_json {
        say_json(&shard_json(plan, shard, counts, &file))?;
    } else {
        say(&shard_text(plan, shard, counts, &file))?;
    }
    Ok(Outcome::finished(missing.is_empty()))
}

/// Writes tables and figures, and prints the answer.
fn finish(plan: &Plan<'_>, folder: &StudyFolder, runs: Vec<Run>, manner: &Manner) -> Result<Outcome> {
    let answer = study::finish(plan, runs, &Terminal::new(manner.quiet))?;
    folder.write(&answer, manner.language())?;
    if manner.json {
        say_json(&study_json(&answer)?)?;
    } else {
        say(&study_text(&answer, manner.style()))?;
    }
    if !manner.quiet {
        note!(
            "{}",
            Noted::Tables(folder.path().display().to_string()).text(manner)
        );
    }
    Ok(Outcome::finished(answer.is_whole()))
}

fn missing(plan: &Plan<'_>, folder: &StudyFolder, from: &[PathBuf], as_json: bool) -> Result<Outcome> {
    let runs = merged(plan, &folder.journals(&plan.study.name, from)?)?;
    let missing = study::missing(plan, (1, 1), &runs);
    if as_json {
        say_json(&missing_json(plan, runs.len(), &missing))?;
    } else {
        say(&missing_text(plan, runs.len(), &missing))?;
    }
    Ok(Outcome::finished(missing.is_empty()))
}
