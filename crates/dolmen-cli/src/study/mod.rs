//! `dolmen study`: runs over grids of inputs, samples, motions and growing shaking; kept, resumed, shared out and put together.

mod buildings;
mod chains;
mod engine;
mod folder;
mod frames;
mod inputs;
mod maps;
mod motions;
mod plan;
mod stacks;

use crate::cli::{Study as Options, StudyAction, StudyWhere};
use crate::{Outcome, files, score, simulate, tools};
use anyhow::{Context as _, Result, bail};
use dolmen_project::StudyPart;
use dolmen_report::json::study_json;
use dolmen_report::text::study_text;
use dolmen_words::Language;
use dolmen_work::score::{ScoreDesign, ScoreDesigns};
use dolmen_work::study::{Run, StudyAnswer};
use folder::StudyFolder;
use plan::Plan;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

pub(crate) fn run(options: &Options, as_json: bool, quiet: bool) -> Result<Outcome> {
    match &options.action {
        Some(StudyAction::Merge { place, from }) => each(place, |plan, folder| {
            let found = folder.merged(plan, from)?;
            finish(plan, folder, found, &Printed::of(options, as_json, quiet))
        }),
        Some(StudyAction::Missing { place, from }) => {
            each(place, |plan, folder| missing(plan, folder, from, as_json))
        }
        None => each(&options.place, |plan, folder| {
            simulated(options, plan, folder, as_json, quiet)
        }),
    }
}

/// Does something with each study that is meant.
fn each(place: &StudyWhere, act: impl Fn(&Plan, &StudyFolder) -> Result<Outcome>) -> Result<Outcome> {
    let project = place.project.as_deref();
    let project = project.context("name a project file, or a folder that holds project.toml")?;
    let opened = plan::open(project)?;
    let studies = &opened.project.studies;
    let known = || {
        let names: Vec<&str> = studies.iter().map(|study| study.name.as_str()).collect();
        names.join(", ")
    };
    let meant: Vec<&StudyPart> = match place.study.as_slice() {
        [] => studies.iter().collect(),
        named => {
            let mut meant = Vec::new();
            for name in named {
                let Some(study) = studies.iter().find(|study| study.name == *name) else {
                    bail!("there is no study \"{name}\": the file has {}", known());
                };
                meant.push(study);
            }
            meant
        }
    };
    if meant.is_empty() {
        bail!("the file has no study: write one as [study.NAME]; docs/study.md has its keys");
    }
    if let Some(load_factor) = crate::check::falls_by_itself(&opened.project)? {
        bail!(
            "it does not stand under its own weight (load factor {load_factor:.3}): no shaking is needed to fell it, and a capacity against shaking would \
             say nothing. `dolmen check` says what it lacks"
        );
    }
    let mut worst = Ok(Outcome::Stands);
    for study in meant {
        let done = Plan::of(&opened, study).and_then(|plan| {
            let folder = StudyFolder::of(place.output.as_deref(), &opened.file, &study.name);
            act(&plan, &folder)
        });
        let done = done.with_context(|| format!("study \"{}\"", study.name));
        worst = match (worst, done) {
            (Ok(Outcome::Stands), done) => done,
            (Ok(_), Err(fault)) => Err(fault),
            (worst, Ok(_)) => worst,
            (Err(first), Err(fault)) => {
                tools::complain(&fault); // the first is said at the end
                Err(first)
            }
        };
        if simulate::interrupted() {
            break;
        }
    }
    worst
}

fn simulated(
    options: &Options,
    plan: &Plan,
    folder: &StudyFolder,
    as_json: bool,
    quiet: bool,
) -> Result<Outcome> {
    let shard = match &options.shard {
        Some(text) => folder::shard(text)?,
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
    let runs = pool.install(|| engine::run(plan, shard, done, &journal, quiet))?;
    drop(journal);
    if shard.1 > 1 {
        return shard_done(plan, folder, shard, &runs, as_json);
    }
    finish(plan, folder, runs, &Printed::of(options, as_json, quiet))
}

/// What is said at the end of a shard: its journal is its result.
fn shard_done(
    plan: &Plan,
    folder: &StudyFolder,
    shard: (usize, usize),
    runs: &[Run],
    as_json: bool,
) -> Result<Outcome> {
    let missing = engine::missing(plan, shard, runs);
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
    Ok(if missing.is_empty() {
        Outcome::Stands
    } else {
        Outcome::Unfinished
    })
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
            language: simulate::language(options.language),
        }
    }
}

/// Tables, figures and what is printed.
fn finish(plan: &Plan, folder: &StudyFolder, runs: Vec<Run>, printed: &Printed) -> Result<Outcome> {
    let missing = engine::missing(plan, (1, 1), &runs);
    let mut answer = plan.answer(runs, missing);
    answer.maps = maps::maps(plan)?;
    if let Some(why) = inputs_refused(&answer) {
        bail!("the inputs of every run were refused: {why}");
    }
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
    Ok(
        if answer.missing.is_empty() && !(has_scan && answer.left_out() > 0) {
            Outcome::Stands
        } else {
            Outcome::Unfinished
        },
    )
}

/// Why nothing could be run, if nothing could.
fn inputs_refused(answer: &StudyAnswer) -> Option<&str> {
    let all = !answer.runs.is_empty() && answer.runs.iter().all(|run| run.scale == 0.0);
    all.then(|| answer.runs.first().map_or("", |run| run.why.as_str()))
}

fn missing(plan: &Plan, folder: &StudyFolder, from: &[PathBuf], as_json: bool) -> Result<Outcome> {
    let runs = folder.merged(plan, from)?;
    let missing = engine::missing(plan, (1, 1), &runs);
    if as_json {
        let scans: Vec<_> = missing.iter().map(|&job| plan.scan_json(job)).collect();
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
    Ok(if missing.is_empty() {
        Outcome::Stands
    } else {
        Outcome::Unfinished
    })
}

/// The studies of a project file that were run before, from the journals beside it; what is of another state of the file is left out,
/// and said.
pub(crate) fn of_report(file: &Path, quiet: bool) -> Result<Vec<StudyAnswer>> {
    let opened = plan::open(file)?;
    let mut found = Vec::new();
    for study in &opened.project.studies {
        let folder = StudyFolder::of(None, &opened.file, &study.name);
        if !folder.path().is_dir() {
            continue;
        }
        let answered = || -> Result<StudyAnswer> {
            let plan = Plan::of(&opened, study)?;
            let runs = folder.merged(&plan, &[])?;
            let missing = engine::missing(&plan, (1, 1), &runs);
            let mut answer = plan.answer(runs, missing);
            answer.maps = maps::maps(&plan)?;
            Ok(answer)
        };
        match answered() {
            Ok(answer) => found.push(answer),
            Err(why) if !quiet => note!("study \"{}\" is left out of the report: {why:#}", study.name),
            Err(_) => {}
        }
    }
    Ok(found)
}

/// Simulated designs of a study, for the score.
pub(crate) struct StudyDesigns {
    pub(crate) designs: ScoreDesigns,
    /// Combinations without enough scans that can be used.
    pub(crate) left_out: usize,
}

/// The pagodas that a study ran with their fragilities, from its journals beside the project file or below `output`.
pub(crate) fn designs(path: &Path, name: &str, output: Option<&Path>) -> Result<StudyDesigns> {
    let opened = plan::open(path)?;
    let studies = &opened.project.studies;
    let Some(study) = studies.iter().find(|study| study.name == name) else {
        bail!("there is no study \"{name}\" in {}", opened.file.display());
    };
    let plan = Plan::of(&opened, study)?;
    let runs = StudyFolder::of(output, &opened.file, name).merged(&plan, &[])?;
    let missing = engine::missing(&plan, (1, 1), &runs);
    let unfinished: BTreeSet<usize> = missing
        .iter()
        .map(|job| job * study.combinations() / plan.jobs().max(1))
        .collect();
    let answer = plan.answer(runs, missing);
    let enough = (USABLE_LEAST * answer.motions.len() as f64).ceil() as usize;
    let mut designs = Vec::new();
    for found in answer.fragilities() {
        if unfinished.contains(&found.combination) || found.usable < enough {
            continue;
        }
        let project = plan.project(found.combination).map_err(anyhow::Error::msg)?;
        let Some(factors) = score::factors(&project)? else {
            bail!("study \"{name}\" has no pagoda of six factors: write pagoda = {{ storeys = 5, … }}");
        };
        let mut states = [None; 4];
        for state in &found.states {
            states[state.state] = state.by_acceleration.as_ref().ok().map(|fit| fit.curve);
        }
        designs.push(ScoreDesign { factors, states });
    }
    Ok(StudyDesigns {
        left_out: study.combinations() - designs.len(),
        designs: ScoreDesigns {
            designs,
            motions: Some(answer.motions.len()),
            ..ScoreDesigns::default()
        },
    })
}

/// Share of the motions whose scans must be usable for a design to count. Chosen here.
const USABLE_LEAST: f64 = 0.75;

/// Missing scans that are named; more are counted.
const MISSING_SHOWN: usize = 20;
