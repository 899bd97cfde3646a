//! `dolmen simulate` of a frame: its directions of known stiffness under a ground motion.

use crate::cli::Simulate as Options;
use crate::simulate::{language, with_progress};
use crate::{Outcome, files};
use anyhow::{Result, bail};
use dolmen::dynamics::{FrameLoad, FrameRun, TimeFunction, simulate_frame};
use dolmen::signal::Component;
use dolmen_project::{FramePart, Names, Project, Quantity};
use dolmen_report::figures::frame_histories;
use dolmen_report::json::frame_simulation_json;
use dolmen_report::text::frame_simulation_text;
use dolmen_words::Language;
use dolmen_work::simulation::{
    FrameSimulation, MotionAnswer, frame_energy_csv, frame_histories_csv, frame_slips_csv,
};
use dolmen_work::study::SWING_REST_S;
use std::path::Path;

/// The wish of a user, as far as it concerns frames.
pub(crate) struct Wish<'a> {
    pub(crate) direction: Option<&'a str>,
    pub(crate) variant: Option<(&'a str, Option<Names>)>,
    pub(crate) duration_s: Option<f64>,
    pub(crate) output_step_s: f64,
}

pub(crate) fn run(
    options: &Options,
    (project, part): (&Project, &FramePart),
    (file, title): (&str, Option<Names>),
    motion: &MotionAnswer,
    (as_json, quiet): (bool, bool),
) -> Result<Outcome> {
    let wish = Wish {
        direction: options.direction.as_deref(),
        variant: options.variant.as_deref().map(|name| (name, title)),
        duration_s: options.duration,
        output_step_s: options.output_step,
    };
    let simulations = simulations((project, part), file, motion, &wish, quiet)?;
    if as_json {
        let all: Vec<_> = simulations.iter().map(frame_simulation_json).collect();
        files::say(&format!("{:#}\n", serde_json::json!({ "simulations": all })))?;
    } else {
        for simulation in &simulations {
            files::say(&frame_simulation_text(simulation))?;
        }
    }
    if let Some(folder) = &options.output {
        for simulation in &simulations {
            write(
                simulation,
                &folder.join(&simulation.direction),
                language(options.language),
            )?;
        }
        if !quiet {
            note!("histories and figures are in {}", folder.display());
        }
    }
    Ok(if simulations.iter().any(FrameSimulation::falls) {
        Outcome::Falls
    } else if simulations.iter().all(FrameSimulation::is_whole) {
        Outcome::Stands
    } else {
        Outcome::Unfinished
    })
}

/// Each direction of known stiffness, or the one that is wished.
pub(crate) fn simulations(
    (project, part): (&Project, &FramePart),
    file: &str,
    motion: &MotionAnswer,
    wish: &Wish<'_>,
    quiet: bool,
) -> Result<Vec<FrameSimulation>> {
    let known: Vec<&str> = part
        .directions
        .iter()
        .filter(|direction| direction.stiffness.is_some())
        .map(|direction| direction.name.as_str())
        .collect();
    let all: Vec<&str> = part
        .directions
        .iter()
        .map(|direction| direction.name.as_str())
        .collect();
    let chosen: Vec<&str> = match wish.direction {
        Some(name) if known.contains(&name) => vec![name],
        Some(name) if all.contains(&name) => bail!(
            "the stiffness of direction \"{name}\" is unknown: `dolmen identify` finds those that its frequencies allow; write one of \
             them into [direction.{name}] or into a variant, and simulate that"
        ),
        Some(name) => bail!(
            "there is no direction \"{name}\": the file has {}",
            all.join(", ")
        ),
        None if known.is_empty() => bail!(
            "the stiffness of no direction is known ({}): `dolmen identify` finds those that measured frequencies allow; write one of \
             them into [direction.NAME] or into a variant, and simulate that with --variant",
            all.join(", ")
        ),
        None => known,
    };
    let component = horizontal(motion, "a frame")?;
    let run_s = wish
        .duration_s
        .unwrap_or(motion.motion.duration_s() + SWING_REST_S);
    let mut found = Vec::new();
    for direction in chosen {
        let Some(frame) = part.with_friction(direction, &mut Quantity::nominal)? else {
            continue;
        };
        let load = FrameLoad::of_ground(TimeFunction::of_motion(&motion.motion, component));
        let options = FrameRun {
            duration_s: Some(run_s),
            output_step_s: wish.output_step_s,
            ..FrameRun::default()
        };
        let history = with_progress(run_s, quiet, |progress| {
            simulate_frame(&frame, &load, &options, progress)
        })?;
        found.push(FrameSimulation {
            file: file.to_owned(),
            name: project.name.clone(),
            variant: wish.variant.as_ref().map(|(name, _)| (*name).to_owned()),
            variant_title: wish.variant.as_ref().and_then(|(_, title)| title.clone()),
            direction: direction.to_owned(),
            storeys: storey_names(part),
            frame,
            motion: motion.clone(),
            component,
            options,
            history,
        });
    }
    Ok(found)
}

/// The horizontal component that acts: each direction of a frame, and a chain, is a plane of its own.
pub(crate) fn horizontal(motion: &MotionAnswer, what: &str) -> Result<Component> {
    match (motion.motion.has(Component::X), motion.motion.has(Component::Y)) {
        (true, true) => bail!(
            "{what} moves in one direction, but the motion has the components x and y: give one file, or turn the motion and give \
             the component that you mean as x"
        ),
        (true, false) => Ok(Component::X),
        (false, true) => Ok(Component::Y),
        (false, false) => bail!("{what} moves horizontally, but the motion has neither x nor y"),
    }
}

fn storey_names(part: &FramePart) -> Vec<String> {
    let each = part.storeys.iter().enumerate();
    each.map(|(i, storey)| storey.name.clone().unwrap_or_else(|| format!("storey {}", i + 1)))
        .collect()
}

fn write(simulation: &FrameSimulation, folder: &Path, language: Language) -> Result<()> {
    let put = |name: &str, bytes: &[u8]| files::write(&folder.join(name), bytes);
    put(
        "simulation.json",
        format!("{:#}\n", frame_simulation_json(simulation)).as_bytes(),
    )?;
    put("histories.csv", frame_histories_csv(simulation).as_bytes())?;
    put("slips.csv", frame_slips_csv(simulation).as_bytes())?;
    put("energy.csv", frame_energy_csv(simulation).as_bytes())?;
    for figure in frame_histories(simulation, language) {
        put(&format!("{}.svg", figure.name), figure.svg.as_bytes())?;
    }
    Ok(())
}
