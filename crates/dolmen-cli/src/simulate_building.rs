//! `dolmen simulate` of a building.

use crate::cli::{Law, Points, Rotations, Simulate as Options};
use crate::simulate::language;
use crate::{Outcome, files};
use anyhow::{Result, bail};
use dolmen::damper::{AttachedDamper, damped_building_history};
use dolmen::dynamics::{
    BuildingHistory, BuildingRun, Histories, TunedMass, VibratingBuilding, building_history,
};
use dolmen::signal::GroundMotion;
use dolmen::structure::building::PlanDirection;
use dolmen_project::{BuildingPart, BuiltDamper, Names, Project, Quantity};
use dolmen_report::figures::building_histories;
use dolmen_report::json::building_simulation_json;
use dolmen_report::text::building_simulation_text;
use dolmen_words::Language;
use dolmen_work::simulation::{
    BuildingSimulation, MotionAnswer, WatchedPoint, building_histories_csv, building_peaks_csv,
};
use std::path::Path;

/// The wish of a user, as far as it concerns buildings.
pub(crate) struct Wish<'a> {
    pub(crate) variant: Option<(&'a str, Option<Names>)>,
    pub(crate) duration_s: Option<f64>,
    /// Longest step, s.
    pub(crate) step_s: f64,
    /// Whether it is also run without its dampers.
    pub(crate) compare: bool,
    /// Whether every history is kept.
    pub(crate) keep: bool,
}

pub(crate) fn run(
    options: &Options,
    (project, part): (&Project, &BuildingPart),
    (file, title): (&str, Option<Names>),
    motion: &MotionAnswer,
    (as_json, quiet): (bool, bool),
) -> Result<Outcome> {
    refuse_others(options)?;
    let wish = Wish {
        variant: options.variant.as_deref().map(|name| (name, title)),
        duration_s: options.duration,
        step_s: options.step.unwrap_or(options.output_step),
        // numbers alone are of one run
        compare: options.output.is_some() || !as_json,
        keep: options.output.is_some(),
    };
    let Some(simulation) = simulation((project, part), file, motion, &wish)? else {
        bail!(
            "the building falls under its own weight, so that nothing was simulated: `dolmen check` says where"
        );
    };
    if as_json {
        files::say(&format!("{:#}\n", building_simulation_json(&simulation)))?;
    } else {
        files::say(&building_simulation_text(&simulation))?;
    }
    if let Some(folder) = &options.output {
        write(&simulation, folder, language(options.language))?;
        if !quiet {
            note!("histories and figures are in {}", folder.display());
        }
    }
    Ok(match simulation.beyond_room().is_empty() {
        false => Outcome::Falls,
        true if simulation.ended_before_the_motion_s().is_some() => Outcome::Unfinished,
        true => Outcome::Stands,
    })
}

/// The building under a motion; `None` if it falls under its own weight.
pub(crate) fn simulation(
    (project, part): (&Project, &BuildingPart),
    file: &str,
    motion: &MotionAnswer,
    wish: &Wish<'_>,
) -> Result<Option<BuildingSimulation>> {
    let Some(alone) = part.as_written().cloned() else {
        return Ok(None);
    };
    let dampers = part.dampers(&alone, &mut Quantity::nominal)?;
    let run = BuildingRun {
        steps_per_sample: steps_per_sample(&motion.motion, wish.step_s),
        end_s: wish.duration_s,
        watched: watched(&alone, part)?,
        histories: match wish.keep {
            true => Histories::Kept,
            false => Histories::PeaksAlone,
        },
    };
    let without_dampers = match !dampers.is_empty() && wish.compare {
        true => Some(Box::new(building_history(&alone, &motion.motion, &run)?)),
        false => None,
    };
    let (vibrating, mut history) = moved(alone, &dampers, &motion.motion, &run)?;
    let mut along = std::mem::take(&mut history.watched).into_iter();
    let mut points = Vec::with_capacity(part.points.len());
    for point in &part.points {
        let (Some(x), Some(y)) = (along.next(), along.next()) else {
            bail!("a point of the file was not watched");
        };
        points.push(WatchedPoint {
            name: point.name.clone(),
            floor: point.floor,
            place_m: [point.place[0].value, point.place[1].value],
            along: [x, y],
        });
    }
    Ok(Some(BuildingSimulation {
        file: file.to_owned(),
        name: project.name.clone(),
        variant: wish.variant.as_ref().map(|(name, _)| (*name).to_owned()),
        variant_title: wish.variant.as_ref().and_then(|(_, title)| title.clone()),
        floors: part.floor_names(),
        building: vibrating,
        dampers,
        motion: motion.clone(),
        history,
        without_dampers,
        points,
    }))
}

/// Into how many steps no longer than `step_s` a sample of a motion is cut.
pub(crate) fn steps_per_sample(motion: &GroundMotion, step_s: f64) -> usize {
    (motion.time_step_s() / step_s * (1.0 - 1e-9)).ceil().max(1.0) as usize
}

/// Options that are of other kinds would be without effect.
fn refuse_others(options: &Options) -> Result<()> {
    let stack = "is for stacks: this file has a building";
    for (is_given, option, words) in [
        (options.law != Law::Springs, "--law", stack),
        (options.points != Points::P16, "--points", stack),
        (options.to_the_end, "--to-the-end", stack),
        (
            options.rotations != Rotations::Large,
            "--rotations",
            "is for chains: a building's displacements are small",
        ),
        (
            options.direction.is_some(),
            "--direction",
            "names a direction of a frame: a building moves in plan, --turn turns the motion",
        ),
    ] {
        if is_given {
            bail!("{option} {words}");
        }
    }
    Ok(())
}

/// Rows of the points of the file, along x and along y.
fn watched(building: &VibratingBuilding, part: &BuildingPart) -> Result<Vec<Vec<f64>>> {
    let mut rows = Vec::new();
    for point in &part.points {
        let (x, y) = (point.place[0].value, point.place[1].value);
        for direction in [PlanDirection::X, PlanDirection::Y] {
            rows.push(building.building().point_row(point.floor, x, y, direction)?);
        }
    }
    Ok(rows)
}

/// The building in time: mode by mode with tuned masses alone, else everything at once.
pub(crate) fn moved(
    building: VibratingBuilding,
    dampers: &[BuiltDamper],
    motion: &GroundMotion,
    run: &BuildingRun,
) -> Result<(VibratingBuilding, BuildingHistory)> {
    let masses: Option<Vec<TunedMass>> = dampers.iter().map(BuiltDamper::tuned_mass).collect();
    match masses {
        Some(masses) => {
            let with = building.with_tuned_masses(masses)?;
            let history = building_history(&with, motion, run)?;
            Ok((with, history))
        }
        None => {
            let attached: Vec<AttachedDamper> = dampers.iter().map(BuiltDamper::attached).collect();
            let history = damped_building_history(&building, &attached, motion, run)?;
            Ok((building, history))
        }
    }
}

fn write(simulation: &BuildingSimulation, folder: &Path, language: Language) -> Result<()> {
    let put = |name: &str, bytes: &[u8]| files::write(&folder.join(name), bytes);
    let json = format!("{:#}\n", building_simulation_json(simulation));
    put("simulation.json", json.as_bytes())?;
    put("histories.csv", building_histories_csv(simulation).as_bytes())?;
    put("peaks.csv", building_peaks_csv(simulation).as_bytes())?;
    for figure in building_histories(simulation, language) {
        put(&format!("{}.svg", figure.name), figure.svg.as_bytes())?;
    }
    Ok(())
}
