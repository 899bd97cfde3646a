//! `dolmen simulate`: a stack under a ground motion; frames and chains have files of their own.

use crate::cli::{Language as Chosen, Law, Points, Simulate as Options};
use crate::{Outcome, files, motion, open, simulate_building, simulate_chain, simulate_frame};
use anyhow::{Result, bail};
use dolmen::assess::{DamageThresholds, stack_damage};
use dolmen::blocks::{
    AfterFall, ContactLaw, ContactRule, Pose, Rigid, Springs, StackHistory, simulate_stack,
};
use dolmen::signal::GroundMotion;
use dolmen::stability::stack::{StackLimitStates, StackLimits, stack_limits};
use dolmen::structure::stack::Stack;
use dolmen_project::{Names, Project, Quantity, Structure};
use dolmen_records::meshes::{
    BlockPose, SeriesFile, series_pvd, stack_3dec, stack_json, stack_obj, stack_vtu,
};
use dolmen_report::figures;
use dolmen_report::json::simulation_json;
use dolmen_report::text::{simulation_inputs_text, simulation_text};
use dolmen_words::Language;
use dolmen_work::simulation::{MotionAnswer, Simulation, energy_csv, joints_csv, poses_csv, stack_film};
use indicatif::{ProgressBar, ProgressStyle};
use std::path::Path;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};

/// Ctrl-C was pressed: the run ends at its next sample and keeps what is done.
static STOP: AtomicBool = AtomicBool::new(false);
/// The handler of Ctrl-C is set once a process.
static HANDLER: OnceLock<bool> = OnceLock::new();
/// Exit status of a process that Ctrl-C ends, as shells have it.
const INTERRUPTED: i32 = 130;
/// Time between the files of a series for ParaView, s: 20 a second. Chosen here.
const PARAVIEW_STEP_S: f64 = 0.05;

pub(crate) fn run(options: &Options, as_json: bool, quiet: bool) -> Result<Outcome> {
    let open::Opened { project, file } = open::project(&options.project)?;
    let (chosen, title) = variant(&project, options.variant.as_deref())?;
    let shown = file.display().to_string();
    if let Structure::Chain(part) = &chosen.structure {
        let motion = match motion::is_given(&options.motion) {
            true => Some(motion::motion(&options.motion, chosen, &file)?),
            false => None,
        };
        if !as_json {
            let inputs = simulation_inputs_text(chosen, &shown, options.variant.as_deref(), motion.as_ref());
            files::say(&inputs)?;
        }
        let output = (as_json, quiet);
        return simulate_chain::run(options, (chosen, part), (&shown, title), motion, output);
    }
    if options.push.is_some() {
        bail!("--push lets a chain lean at the start: the file has another kind");
    }
    let motion = motion::motion(&options.motion, chosen, &file)?;
    if !as_json {
        let inputs = simulation_inputs_text(chosen, &shown, options.variant.as_deref(), Some(&motion));
        files::say(&inputs)?;
    }
    if let Structure::Frame(part) = &chosen.structure {
        let output = (as_json, quiet);
        return simulate_frame::run(options, (chosen, part), (&shown, title), &motion, output);
    }
    if let Structure::Building(part) = &chosen.structure {
        let output = (as_json, quiet);
        return simulate_building::run(options, (chosen, part), (&shown, title), &motion, output);
    }
    let stack = stack_of(chosen)?;
    let limits = stack_limits(&stack, &StackLimits::default())?;
    if !limits.standing.stands() {
        files::say(&unstable(&shown, &limits.standing.to_string(), as_json))?;
        return Ok(Outcome::Falls);
    }
    let law = law(options, &stack);
    let history = simulated(&stack, &motion.motion, &law, quiet)?;
    let simulation = Simulation {
        damage: stack_damage(&stack, &limits, &history, &DamageThresholds::default()),
        file: shown,
        name: chosen.name.clone(),
        variant: options.variant.clone(),
        stack,
        motion,
        law,
        history,
    };
    if as_json {
        files::say(&format!("{:#}\n", simulation_json(&simulation)))?;
    } else {
        files::say(&simulation_text(&simulation))?;
    }
    if let Some(folder) = &options.output {
        write(&simulation, &limits, folder, language(options.language))?;
        if !quiet {
            note!("histories, figures, film and exports are in {}", folder.display());
        }
    }
    Ok(match (simulation.falls(), simulation.is_whole()) {
        (true, _) => Outcome::Falls,
        (false, true) => Outcome::Stands,
        (false, false) => Outcome::Unfinished,
    })
}

/// The simulation that a report shows: the stack as it is, or a variant of this name, on springs as they are by default.
pub(crate) fn of_report(
    (project, variant): (&Project, Option<&str>),
    file: &Path,
    motion: MotionAnswer,
    quiet: bool,
) -> Result<Simulation> {
    let (stack, law) = (stack_of(project)?, ContactLaw::Springs(Springs::default()));
    let history = simulated(&stack, &motion.motion, &law, quiet)?;
    let limits = stack_limits(&stack, &StackLimits::default())?;
    Ok(Simulation {
        damage: stack_damage(&stack, &limits, &history, &DamageThresholds::default()),
        file: file.display().to_string(),
        name: project.name.clone(),
        variant: variant.map(str::to_owned),
        stack,
        motion,
        law,
        history,
    })
}

/// What is said of a stack that falls by itself.
fn unstable(file: &str, why: &str, as_json: bool) -> String {
    if as_json {
        let outcome = serde_json::json!({ "kind": "does_not_stand", "why": why });
        format!("{:#}\n", serde_json::json!({ "file": file, "outcome": outcome }))
    } else {
        format!("\nDOES NOT STAND without any shaking, so that nothing was simulated: {why}\n")
    }
}

pub(crate) fn language(chosen: Chosen) -> Language {
    match chosen {
        Chosen::En => Language::English,
        Chosen::Ko => Language::Korean,
    }
}

/// The project, or its variant of this name with its title.
fn variant<'p>(project: &'p Project, name: Option<&str>) -> Result<(&'p Project, Option<Names>)> {
    let Some(name) = name else {
        return Ok((project, None));
    };
    match project.variants.iter().find(|variant| variant.name == name) {
        Some(variant) => Ok((&variant.project, variant.title.clone())),
        None => {
            let names: Vec<&str> = project.variants.iter().map(|v| v.name.as_str()).collect();
            let known = if names.is_empty() {
                "none".to_owned()
            } else {
                names.join(", ")
            };
            bail!("there is no variant \"{name}\": the file has {known}")
        }
    }
}

fn stack_of(project: &Project) -> Result<Stack> {
    match &project.structure {
        Structure::Stack(part) => Ok(part.build(&mut Quantity::nominal)?),
        _ => bail!(
            "only stacks, frames, chains and buildings can be simulated: the file has kind = \"survey\""
        ),
    }
}

fn law(options: &Options, stack: &Stack) -> ContactLaw {
    let contact_rule = match options.points {
        Points::P4 => ContactRule::Corners,
        Points::P9 => ContactRule::Three,
        Points::P16 => ContactRule::Four,
        Points::P36 => ContactRule::Six,
    };
    let (duration_s, output_step_s) = (options.duration, options.output_step);
    let after_fall = match options.to_the_end {
        true => AfterFall::Continue,
        false => AfterFall::Stop,
    };
    match options.law {
        Law::Springs => ContactLaw::Springs(Springs {
            contact_rule,
            time_step_s: options.step,
            duration_s,
            output_step_s,
            after_fall,
            ..Springs::default()
        }),
        Law::Rigid => ContactLaw::Rigid(Rigid {
            contact_rule,
            time_step_s: options.step.unwrap_or_else(|| Rigid::usual_step_s(stack)),
            duration_s,
            output_step_s,
            after_fall,
            ..Rigid::default()
        }),
    }
}

/// The run itself.
fn simulated(stack: &Stack, motion: &GroundMotion, law: &ContactLaw, quiet: bool) -> Result<StackHistory> {
    let whole_s = law.run_length_s(motion.duration_s());
    let history = with_progress(whole_s, quiet, |progress| {
        simulate_stack(stack, Some(motion), law, progress)
    })?;
    Ok(history)
}

/// From now on Ctrl-C asks to end and keep what is done; a second one ends the process.
pub(crate) fn watch_interrupts() {
    HANDLER.get_or_init(|| {
        let pressed = || {
            if STOP.swap(true, Ordering::SeqCst) {
                std::process::exit(INTERRUPTED);
            }
        };
        ctrlc::set_handler(pressed).is_ok()
    });
}

/// Whether Ctrl-C was pressed.
pub(crate) fn interrupted() -> bool {
    STOP.load(Ordering::SeqCst)
}

/// Takes the simulated time, and says whether to go on.
pub(crate) type Progress<'a> = &'a mut dyn FnMut(f64) -> bool;

/// A run with its progress on a terminal; Ctrl-C ends it and keeps what is done, a second one ends the process.
pub(crate) fn with_progress<T>(whole_s: f64, quiet: bool, run: impl FnOnce(Progress<'_>) -> T) -> T {
    watch_interrupts();
    let bar = if quiet {
        ProgressBar::hidden()
    } else {
        ProgressBar::new((1e3 * whole_s) as u64)
    };
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {msg} {eta} left; Ctrl-C keeps what is done") {
        bar.set_style(style);
    }
    let mut progress = |time_s: f64| {
        bar.set_position((1e3 * time_s) as u64);
        bar.set_message(format!("{time_s:.1} of {whole_s:.1} s,"));
        !interrupted()
    };
    let done = run(&mut progress);
    bar.finish_and_clear();
    done
}

/// Everything of a simulation as files.
fn write(
    simulation: &Simulation,
    limits: &StackLimitStates,
    folder: &Path,
    language: Language,
) -> Result<()> {
    let put = |name: &str, bytes: &[u8]| files::write(&folder.join(name), bytes);
    put(
        "simulation.json",
        format!("{:#}\n", simulation_json(simulation)).as_bytes(),
    )?;
    put("joints.csv", joints_csv(simulation).as_bytes())?;
    put("poses.csv", poses_csv(simulation).as_bytes())?;
    put("energy.csv", energy_csv(simulation).as_bytes())?;
    put("film.glb", &stack_film(simulation))?;
    let stack = &simulation.stack;
    put("stack.obj", stack_obj(stack).as_bytes())?;
    put("stack.json", stack_json(stack).as_bytes())?;
    put("stack.3ddat", stack_3dec(stack).as_bytes())?;
    paraview(simulation, &put)?;
    put("after.svg", figures::stack_after(simulation, language).as_bytes())?;
    for figure in figures::stack_histories(simulation, language) {
        put(&format!("{}.svg", figure.name), figure.svg.as_bytes())?;
    }
    let peak_g = simulation.peak_horizontal_g();
    put(
        "governing.svg",
        figures::stack_governing(limits, Some(peak_g), language).as_bytes(),
    )?;
    put(
        "capacity.svg",
        figures::stack_capacity(limits, Some(peak_g), language).as_bytes(),
    )
}

/// A series for ParaView, each [`PARAVIEW_STEP_S`].
fn paraview(simulation: &Simulation, put: &dyn Fn(&str, &[u8]) -> Result<()>) -> Result<()> {
    let mut series: Vec<SeriesFile> = Vec::new();
    for (sample, &time_s) in simulation.history.time_s.iter().enumerate() {
        let due = series
            .last()
            .is_none_or(|last| time_s - last.time_s >= PARAVIEW_STEP_S * (1.0 - 1e-6));
        if !due && sample + 1 != simulation.samples() {
            continue;
        }
        let poses: Vec<BlockPose> = simulation.poses(sample).iter().map(block_pose).collect();
        let file = format!("paraview/{:05}.vtu", series.len());
        put(&file, stack_vtu(&simulation.stack, &poses)?.as_bytes())?;
        series.push(SeriesFile { time_s, file });
    }
    put("paraview.pvd", series_pvd(&series).as_bytes())
}

/// Rows of the rotation of a unit quaternion, scalar first.
fn block_pose(pose: &Pose) -> BlockPose {
    let [w, x, y, z] = pose.rotation;
    let rotation = [
        [
            1.0 - 2.0 * (y * y + z * z),
            2.0 * (x * y - w * z),
            2.0 * (x * z + w * y),
        ],
        [
            2.0 * (x * y + w * z),
            1.0 - 2.0 * (x * x + z * z),
            2.0 * (y * z - w * x),
        ],
        [
            2.0 * (x * z - w * y),
            2.0 * (y * z + w * x),
            1.0 - 2.0 * (x * x + y * y),
        ],
    ];
    BlockPose {
        centroid_m: pose.centroid_m,
        rotation,
        velocity_m_s: None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_a_quarter_turn_about_z_takes_x_to_y() {
        let half = 0.5_f64.sqrt();
        let pose = block_pose(&Pose {
            centroid_m: [0.0; 3],
            rotation: [half, 0.0, 0.0, half],
        });
        let x: Vec<f64> = pose.rotation.iter().map(|row| row[0]).collect();
        assert!(
            x[0].abs() < 1e-15 && (x[1] - 1.0).abs() < 1e-15 && x[2] == 0.0,
            "{x:?}"
        );
    }
}
