//! `dolmen report` and `dolmen demo`: projects to one page.

use crate::check::{self, Sampling};
use crate::cli::{Demo, Motion, Report};
use crate::simulate::language;
use crate::{
    Outcome, files, identify, motion, new, open, simulate, simulate_building, simulate_chain, simulate_frame,
    study, tools, tune,
};
use anyhow::{Result, bail};
use dolmen::dynamics::ChainRotations;
use dolmen::stability::Verdict;
use dolmen::structure::{Choice, Convention};
use dolmen_project::{Names, Project, Structure};
use dolmen_report::html::{Imprint, NotReported, html};
use dolmen_work::answer::Answer;
use dolmen_work::change::{change_of, surveys_to_compare};
use dolmen_work::simulation::{BuildingSimulation, ChainSimulation, FrameSimulation, Simulation};
use std::path::{Path, PathBuf};

/// Samples of the demo: enough for a figure, few enough for a blink.
const DEMO_SAMPLES: usize = 2000;
/// Time between the samples of a frame's histories in a report, s.
const REPORT_STEP_S: f64 = 0.01;
/// Seed of the demo.
const DEMO_SEED: u64 = 1;

fn imprint(date: Option<String>) -> Imprint {
    Imprint {
        program: concat!("dolmen ", env!("CARGO_PKG_VERSION")).to_owned(),
        date,
    }
}

/// Everything that can be said of one project: its check, with samples and sensitivities, its surveys, and a stack under the
/// motion that was asked for.
fn whole(path: &Path, sampling: Option<Sampling>, motion: Option<&Motion>, quiet: bool) -> Result<Answer> {
    let open::Opened { project, file } = open::project(path)?;
    if let (Structure::Survey, Some(options)) = (&project.structure, motion)
        && motion::is_given(options)
    {
        bail!(
            "{}: only stacks, frames and chains can be simulated; leave the motion out",
            file.display()
        );
    }
    let is_stack = matches!(project.structure, Structure::Stack(_));
    let sampling = sampling.filter(|_| !is_stack); // a stack's verdict is without shaking: nothing is drawn for it
    let surveys = identify::surveys(&project, &file, None, quiet)?;
    let mut answer = check::answer(project, &file, sampling, true)?;
    answer.surveys = surveys;
    if let Ok(compared) = surveys_to_compare(&answer.project, None, None) {
        answer.change = Some(change_of(&answer.project, &compared, &answer.surveys)?);
    }
    let stands = answer
        .state
        .as_ref()
        .is_some_and(|state| state.verdict() != Verdict::Unstable);
    if let (true, true, Some(options)) = (
        is_stack,
        stands,
        motion.filter(|options| motion::is_given(options)),
    ) {
        let simulated = |project: &Project, variant: Option<&str>| -> Result<Box<Simulation>> {
            let motion = motion::motion(options, project, &file)?;
            let run = simulate::of_report((project, variant), &file, motion, quiet)?;
            Ok(Box::new(run))
        };
        answer.simulation = Some(simulated(&answer.project, None)?);
        for variant in &mut answer.variants {
            let own = answer
                .project
                .variants
                .iter()
                .find(|other| other.name == variant.name);
            if let (Some(own), true) = (own, variant.state.verdict() != Verdict::Unstable) {
                variant.simulation = Some(simulated(&own.project, Some(&variant.name))?);
            }
        }
    }
    if let Some(options) = motion.filter(|options| motion::is_given(options)) {
        answer.frame_simulations = frames(&answer.project, &file, options, quiet)?;
        answer.chain_simulations = chains(&answer.project, &file, options, quiet)?;
        answer.building_simulations = buildings(&answer.project, &file, options)?;
    }
    (answer.tunings, answer.together) = tune::of_report(&answer.project, &file)?;
    answer.studies = study::of_report(&file, quiet)?;
    Ok(answer)
}

/// The frame, as it is and in its variants, under the motion: each direction of known stiffness.
fn frames(project: &Project, file: &Path, options: &Motion, quiet: bool) -> Result<Vec<FrameSimulation>> {
    let mut found = Vec::new();
    for (version, variant) in versions(project) {
        let Structure::Frame(part) = &version.structure else {
            continue;
        };
        if part
            .directions
            .iter()
            .all(|direction| direction.stiffness.is_none())
        {
            continue;
        }
        let motion = motion::motion(options, version, file)?;
        let wish = simulate_frame::Wish {
            direction: None,
            variant,
            duration_s: None,
            output_step_s: REPORT_STEP_S,
        };
        let shown = file.display().to_string();
        found.extend(simulate_frame::simulations(
            (version, part),
            &shown,
            &motion,
            &wish,
            quiet,
        )?);
    }
    Ok(found)
}

/// The chain, as it is and in its variants, under the motion: each whose joints are known.
fn chains(project: &Project, file: &Path, options: &Motion, quiet: bool) -> Result<Vec<ChainSimulation>> {
    let mut found = Vec::new();
    for (version, variant) in versions(project) {
        let Structure::Chain(part) = &version.structure else {
            continue;
        };
        if part.joints.is_none() {
            continue;
        }
        let motion = motion::motion(options, version, file)?;
        let wish = simulate_chain::Wish {
            variant,
            push_rad: 0.0,
            rotations: ChainRotations::Large,
            duration_s: None,
            output_step_s: REPORT_STEP_S,
        };
        let shown = file.display().to_string();
        found.push(simulate_chain::simulation(
            (version, part),
            &shown,
            Some(motion),
            &wish,
            quiet,
        )?);
    }
    Ok(found)
}

/// The building, as it is and in its variants, under the motion: each that stands.
fn buildings(project: &Project, file: &Path, options: &Motion) -> Result<Vec<BuildingSimulation>> {
    let mut found = Vec::new();
    for (version, variant) in versions(project) {
        let Structure::Building(part) = &version.structure else {
            continue;
        };
        let motion = motion::motion(options, version, file)?;
        let wish = simulate_building::Wish {
            variant,
            duration_s: None,
            step_s: REPORT_STEP_S,
            compare: true,
            keep: true,
        };
        let shown = file.display().to_string();
        found.extend(simulate_building::simulation(
            (version, part),
            &shown,
            &motion,
            &wish,
        )?);
    }
    Ok(found)
}

/// A version of a project: as it is, or a variant with its name and title.
type Version<'a> = (&'a Project, Option<(&'a str, Option<Names>)>);

/// The project as it is, then its variants.
fn versions(project: &Project) -> impl Iterator<Item = Version<'_>> {
    let variants = project
        .variants
        .iter()
        .map(|v| (&v.project, Some((v.name.as_str(), v.title.clone()))));
    [(project, None)].into_iter().chain(variants)
}

pub(crate) fn run(options: &Report, quiet: bool) -> Result<Outcome> {
    let sampling = (options.samples > 0).then_some(Sampling {
        samples: options.samples as usize,
        seed: options.seed,
    });
    if !motion::is_given(&options.motion) && motion::is_changed(&options.motion) {
        bail!(
            "--scale, --peak and the like change a motion, but none is given: add --motion or --motion-file"
        );
    }
    let (mut answers, mut others, mut faults) = (Vec::new(), Vec::new(), Vec::new());
    for path in &options.projects {
        let is_output = files::project_file(path).is_ok_and(|file| {
            file.canonicalize().ok() == options.output.canonicalize().ok() && options.output.exists()
        });
        if is_output {
            bail!(
                "{} is the project file itself: write the report elsewhere",
                options.output.display()
            );
        }
        match whole(path, sampling, Some(&options.motion), quiet) {
            Ok(answer) => answers.push(answer),
            Err(fault) if options.projects.len() == 1 => return Err(fault),
            Err(fault) => {
                tools::complain(&fault);
                others.push(NotReported {
                    file: path.display().to_string(),
                    why: format!("{fault:#}"),
                });
                faults.push(fault);
            }
        }
    }
    if answers.is_empty() {
        bail!(
            "no report is written: none of the {} projects can be reported on",
            others.len()
        );
    }
    let page = html(
        &answers,
        &others,
        language(options.language),
        &imprint(options.date.clone()),
    );
    files::write(&options.output, page.as_bytes())?;
    if !quiet {
        println!("{}", options.output.display());
    }
    if let Some(first) = faults.first() {
        note!(
            "{} of {} projects left out of the report",
            faults.len(),
            options.projects.len()
        );
        return Ok(Outcome::Partial(tools::exit_status(first)));
    }
    Ok(if answers.iter().any(Answer::falls) {
        Outcome::Falls
    } else {
        Outcome::Stands
    })
}

pub(crate) fn demo(options: &Demo, quiet: bool) -> Result<Outcome> {
    let folder = free_folder(&options.directory)?;
    let mut answers = Vec::new();
    for example in new::DEMO {
        let directory = folder.join(example);
        new::copy_example(example, &directory)?;
        let sampling = Some(Sampling {
            samples: DEMO_SAMPLES,
            seed: DEMO_SEED,
        });
        let answer = whole(&directory, sampling, None, quiet)?;
        if !quiet {
            println!("{}: {}", answer.project.name.english(), summary(&answer));
        }
        answers.push(answer);
    }
    let report = folder.join("report.html");
    files::write(
        &report,
        html(&answers, &[], language(options.language), &imprint(None)).as_bytes(),
    )?;
    if !quiet {
        print!("The report on all of them: ");
    }
    println!("{}", report.display());
    Ok(Outcome::Stands)
}

/// The folder asked for if it is free, else the first of "NAME-2", "NAME-3"… that is: nothing is overwritten.
fn free_folder(wanted: &Path) -> Result<PathBuf> {
    let name = wanted
        .file_name()
        .map(|n| n.to_string_lossy().into_owned())
        .unwrap_or_default();
    let mut folder = wanted.to_owned();
    let mut number = 1;
    while folder.exists() {
        number += 1;
        folder = wanted.with_file_name(format!("{name}-{number}"));
    }
    files::fresh_folder(&folder)?;
    Ok(folder)
}

/// One line on a project.
fn summary(answer: &Answer) -> String {
    let mut parts = Vec::new();
    if let Some(state) = &answer.state {
        parts.push(format!("as it is {}", state.verdict().word()));
    }
    for variant in &answer.variants {
        parts.push(format!("{} {}", variant.name, variant.state.verdict().word()));
    }
    for survey in &answer.surveys {
        if let Some(record) = &survey.records {
            let found: Vec<String> = record
                .analysis
                .modes
                .modes
                .iter()
                .map(|mode| format!("{:.3}", mode.frequency_hz))
                .collect();
            parts.push(format!("modes at {} Hz", found.join(", ")));
        }
        for stiffness in &survey.stiffness {
            let convention = match stiffness.convention {
                Some(Convention::Drift) => " (drift)",
                Some(Convention::Grounded) => " (grounded)",
                None => "",
            };
            let found = &stiffness.solutions;
            let what = match found.choice {
                Choice::One => "one stiffness explains".to_owned(),
                Choice::Bounded => "one stiffness, known only between bounds, explains".to_owned(),
                Choice::Indistinguishable => format!("{} stiffnesses explain", found.solutions.len()),
                Choice::Underdetermined => "too few data for the stiffness of".to_owned(),
                Choice::Impossible => "no stiffness explains".to_owned(),
            };
            parts.push(format!("{what} direction {}{convention}", stiffness.direction));
        }
    }
    parts.join("; ")
}
