//! `dolmen simulate` of a building.

use crate::cli::Simulate as Options;
use crate::simulate::language;
use crate::{Outcome, files};
use anyhow::{Result, bail};
use dolmen::dynamics::{BuildingRun, building_history};
use dolmen::structure::building::{BuildingError, PlanDirection};
use dolmen_formats::Language;
use dolmen_formats::figures::building_histories;
use dolmen_formats::json::building_simulation_json;
use dolmen_formats::project::{BuildingPart, Names, Project, Quantity};
use dolmen_formats::simulation::{
    BuildingSimulation, MotionAnswer, WatchedPoint, building_histories_csv, building_peaks_csv,
};
use dolmen_formats::text::building_simulation_text;
use std::path::Path;

/// The wish of a user, as far as it concerns buildings.
pub(crate) struct Wish<'a> {
    pub(crate) variant: Option<(&'a str, Option<Names>)>,
    pub(crate) duration_s: Option<f64>,
    /// Longest step, s.
    pub(crate) step_s: f64,
    /// Whether it is also run without its dampers.
    pub(crate) compare: bool,
}

pub(crate) fn run(
    options: &Options,
    (project, part): (&Project, &BuildingPart),
    (file, title): (&str, Option<Names>),
    motion: &MotionAnswer,
    (as_json, quiet): (bool, bool),
) -> Result<Outcome> {
    let wish = Wish {
        variant: options.variant.as_deref().map(|name| (name, title)),
        duration_s: options.duration,
        step_s: options.step.unwrap_or(options.output_step),
        compare: options.output.is_some(),
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
            eprintln!("histories and figures are in {}", folder.display());
        }
    }
    Ok(Outcome::Stands)
}

/// The building under a motion; `None` if it falls under its own weight.
pub(crate) fn simulation(
    (project, part): (&Project, &BuildingPart),
    file: &str,
    motion: &MotionAnswer,
    wish: &Wish<'_>,
) -> Result<Option<BuildingSimulation>> {
    let pick = &mut Quantity::nominal;
    let building = match part.build(pick) {
        Ok(building) => building,
        Err(BuildingError::Falls { .. }) => return Ok(None),
        Err(why) => return Err(why.into()),
    };
    let alone = part.vibrating(building, &[], pick)?;
    let dampers = part.dampers(alone.building(), alone.modes(), pick)?;
    let sample_s = motion.motion.time_step_s();
    let run = BuildingRun {
        steps_per_sample: (sample_s / wish.step_s * (1.0 - 1e-9)).ceil().max(1.0) as usize,
        end_s: wish.duration_s,
    };
    let without_dampers = match !dampers.is_empty() && wish.compare {
        true => Some(Box::new(building_history(&alone, &motion.motion, &run)?)),
        false => None,
    };
    let tuned = dampers.iter().map(|damper| damper.tuned.clone()).collect();
    let vibrating = alone.with_tuned_masses(tuned)?;
    let history = building_history(&vibrating, &motion.motion, &run)?;
    let mut points = Vec::with_capacity(part.points.len());
    for point in &part.points {
        let place_m = [point.place[0].value, point.place[1].value];
        let along = |direction| -> Result<Vec<f64>> {
            let row = vibrating
                .building()
                .point_row(point.floor, place_m[0], place_m[1], direction)?;
            Ok(history.along(&row))
        };
        points.push(WatchedPoint {
            name: point.name.clone(),
            floor: point.floor,
            place_m,
            displacement_m: [along(PlanDirection::X)?, along(PlanDirection::Y)?],
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
