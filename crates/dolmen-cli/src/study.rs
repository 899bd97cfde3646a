//! `dolmen study`: runs over grids of inputs, samples, motions and growing shaking; kept, resumed, shared out and put together.

use crate::cli::{Study as Options, StudyAction, StudyWhere};
use crate::note::note;
use crate::outcome::Outcome;
use crate::progress::{self, Terminal};
use crate::study_folder::{self, StudyFolder};
use crate::typed::Typed;
use crate::{files, open, request, tools};
use anyhow::{Context as _, Result};
use dolmen_report::json::study_json;
use dolmen_report::text::study_text;
use dolmen_words::Language;
use dolmen_work::FlagVerb;
use dolmen_work::study::{self, Plan, Run, merged, studies};
use serde_json::{Value, json};
use std::path::PathBuf;

/// Missing scans that are named; more are counted.
const MISSING_SHOWN: usize = 20;

pub(crate) fn run(options: &Options, typed: &Typed, as_json: bool, quiet: bool) -> Result<Outcome> {
    match &options.action {
        Some(StudyAction::Merge { place, from }) => each((place, typed), |plan, folder| {
            let runs = merged(plan, &folder.journals(&plan.study.name, from)?)?;
            finish(plan, folder, runs, &Printed::of(options, as_json, quiet))
        }),
        Some(StudyAction::Missing { place, from }) => each((place, typed), |plan, folder| {
            missing(plan, folder, from, as_json)
        }),
        None => each((&options.place, typed), |plan, folder| {
            simulated(options, plan, folder, as_json, quiet)
        }),
    }
}

/// Does something with each study that is meant.
fn each(
    (place, typed): (&StudyWhere, &Typed),
    act: impl Fn(&Plan<'_>, &StudyFolder) -> Result<Outcome>,
) -> Result<Outcome> {
    let project = place.project.as_deref();
    let project = project.context("name a project file, or a folder that holds project.toml")?;
    let found = open::project(project)?;
    typed.refuse_foreign(FlagVerb::Study, &[&found.opened.project])?;
    let meant = studies(&found.opened, &place.study)?;
    let mut worst = Ok(Outcome::Done);
    for study in meant {
        let done = Plan::of(&found.opened, study, &found.files)
            .map_err(anyhow::Error::new)
            .and_then(|plan| {
                let folder = StudyFolder::of(place.output.as_deref(), &found.file, &study.name);
                act(&plan, &folder)
            });
        let done = done.with_context(|| format!("study \"{}\"", study.name));
        worst = match (worst, done) {
            (Ok(Outcome::Done), done) => done,
            (Ok(_), Err(fault)) => Err(fault),
            (worst, Ok(_)) => worst,
            (Err(first), Err(fault)) => {
                tools::complain(&fault); // the first is said at the end
                Err(first)
            }
        };
        if progress::interrupted() {
            break;
        }
    }
    worst
}

fn simulated(
    options: &Options,
    plan: &Plan<'_>,
    folder: &StudyFolder,
    as_json: bool,
    quiet: bool,
) -> Result<Outcome> {
    let shard = match &options.shard {
        Some(text) => study_folder::shard(text)?,
        None => (1, 1),
    };
    let (journal, done) = folder.journal(&plan.header(shard), plan.kind, options.restart)?;
    let resumed = done.len();
    if resumed > 0 && !quiet {
        note!(
            "{}: {resumed} runs are kept from before",
            folder.journal_file(shard).display()
        );
    }
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(options.threads.unwrap_or(0))
        .build()?;
    let runs = pool.install(|| study::run(plan, shard, done, &journal, &Terminal::new(quiet)))?;
    drop(journal);
    if shard.1 > 1 {
        return shard_done(plan, folder, shard, &runs, as_json);
    }
    finish(plan, folder, runs, &Printed::of(options, as_json, quiet))
}

/// What is said at the end of a shard: its journal is its result.
fn shard_done(
    plan: &Plan<'_>,
    folder: &StudyFolder,
    shard: (usize, usize),
    runs: &[Run],
    as_json: bool,
) -> Result<Outcome> {
    let missing = study::missing(plan, shard, runs);
    let file = folder.journal_file(shard);
    if as_json {
        let value = serde_json::json!({
            "study": plan.study.name, "shard": format!("{}/{}", shard.0, shard.1), "runs": runs.len(),
            "scans_missing": missing.len(), "journal": file.display().to_string(),
        });
        files::say(&format!("{value:#}\n"))?;
    } else {
        files::say(&format!(
            "Study \"{}\", shard {} of {}: {} runs, {} scans missing, in {}\n`dolmen study merge` puts the shards together\n",
            plan.study.name,
            shard.0,
            shard.1,
            runs.len(),
            missing.len(),
            file.display()
        ))?;
    }
    Ok(Outcome::finished(missing.is_empty()))
}

/// How results are given.
struct Printed {
    as_json: bool,
    quiet: bool,
    language: Language,
}

impl Printed {
    fn of(options: &Options, as_json: bool, quiet: bool) -> Self {
        Printed {
            as_json,
            quiet,
            language: request::language(options.language),
        }
    }
}

/// Tables, figures and what is printed.
fn finish(plan: &Plan<'_>, folder: &StudyFolder, runs: Vec<Run>, printed: &Printed) -> Result<Outcome> {
    let answer = study::finish(plan, runs, &Terminal::new(printed.quiet))?;
    folder.write(&answer, printed.language)?;
    if printed.as_json {
        files::say(&format!("{:#}\n", study_json(&answer)?))?;
    } else {
        files::say(&study_text(&answer)?)?;
    }
    if !printed.quiet {
        note!("tables and figures are in {}", folder.path().display());
    }
    // a fall is what a study looks for; a scan without an answer is not
    let has_scan = answer.study.scan.is_some();
    let is_whole = answer.missing.is_empty() && !(has_scan && answer.left_out() > 0);
    Ok(Outcome::finished(is_whole))
}

fn missing(plan: &Plan<'_>, folder: &StudyFolder, from: &[PathBuf], as_json: bool) -> Result<Outcome> {
    let runs = merged(plan, &folder.journals(&plan.study.name, from)?)?;
    let missing = study::missing(plan, (1, 1), &runs);
    if as_json {
        let scans: Vec<_> = missing.iter().map(|&job| scan_json(plan, job)).collect();
        let value = serde_json::json!({
            "study": plan.study.name, "scans": plan.jobs(), "runs": runs.len(), "missing": scans,
        });
        files::say(&format!("{value:#}\n"))?;
    } else {
        let mut text = format!(
            "Study \"{}\": {} of {} scans are done, {} runs\n",
            plan.study.name,
            plan.jobs() - missing.len(),
            plan.jobs(),
            runs.len()
        );
        for &job in missing.iter().take(MISSING_SHOWN) {
            text += &format!("  missing: {}\n", plan.scan_words(job));
        }
        if missing.len() > MISSING_SHOWN {
            text += &format!("  and {} more\n", missing.len() - MISSING_SHOWN);
        }
        files::say(&text)?;
    }
    Ok(Outcome::finished(missing.is_empty()))
}

/// A scan as JSON: what its inputs are.
fn scan_json(plan: &Plan<'_>, job: usize) -> Value {
    json!({ "scan": job + 1, "inputs": plan.scan_words(job) })
}
