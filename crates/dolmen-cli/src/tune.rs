//! `dolmen tune`: the dampers of a building beside the rule and the best, where and how tuned.

use crate::cli_tune::{Tune as Options, TuneGoal, TuneLoad as Load};
use crate::simulate::language;
use crate::tune_room::room_check;
use crate::tune_together::of_all;
use crate::{Outcome, files, open};
use anyhow::{Context as _, Result, bail};
use dolmen::damper::{
    Comparison, ComparisonOptions, DamperKind, DamperProblem, DamperSite, Goal, PlacedDamper, Plan,
    PlanOptions, compare,
};
use dolmen::dynamics::{LinearSystem, RandomInput, RandomLoad, Spectrum, VibratingBuilding};
use dolmen::structure::building::{Building, PlanDirection};
use dolmen_project::{BuildingPart, BuiltDamper, Project, Quantity, Structure};
use dolmen_report::figures::tune_figures;
use dolmen_report::json::{together_json, tune_json};
use dolmen_report::text::{together_text, tune_text};
use dolmen_work::tune::{RoomCheck, TogetherAnswer, TuneAnswer, TuneLoad, TunePoint};
use std::f64::consts::TAU;
use std::path::Path;

/// Density of what acts, two-sided, unit² s/rad: only ratios are shown.
const DENSITY: f64 = 1.0;
/// Damping of the soil and of the second filter, and its frequency over the soil's: Clough & Penzien (1975), sec. 28-4.
const GROUND_DAMPING_RATIO: f64 = 0.6;
const FILTER_PART: f64 = 0.1;

pub(crate) fn run(options: &Options, as_json: bool, quiet: bool) -> Result<Outcome> {
    let open::Opened { project, file } = open::project(&options.project)?;
    let shown = file.display().to_string();
    let (mut answers, mut together) = (Vec::new(), Vec::new());
    for (version, variant) in versions(&project, options.variant.as_deref())? {
        answers.extend(answers_of(version, variant.clone(), &shown, options)?);
        if options.damper.is_none() {
            together.extend(of_all((version, variant), &shown, options)?);
        }
    }
    if answers.is_empty() && together.is_empty() {
        match &options.damper {
            Some(name) => bail!(
                "there is no damper \"{name}\" in {shown} that stands at a place to be found: \"tmd\" and \"tlcd\" do, \"tlcmd\" and \"link\" are \
                 tuned with the others, without --damper"
            ),
            None => bail!(
                "{shown} has no damper to tune: write a table such as [damper.roof] with kind = \"tmd\", floor, place, direction, mass_ratio \
                 and tuning, in the file or in a variant"
            ),
        }
    }
    if as_json {
        let all: Vec<_> = answers.iter().map(tune_json).collect();
        let of_all: Vec<_> = together.iter().map(together_json).collect();
        let json = serde_json::json!({ "dampers": all, "together": of_all });
        files::say(&format!("{json:#}\n"))?;
    } else {
        for answer in &answers {
            files::say(&tune_text(answer))?;
        }
        for answer in &together {
            files::say(&together_text(answer))?;
        }
    }
    if let Some(folder) = &options.output {
        for answer in &answers {
            write(answer, &folder.join(&answer.damper), options)?;
        }
        for answer in &together {
            let json = format!("{:#}\n", together_json(answer));
            let name = match &answer.variant {
                None => "together.json".to_owned(),
                Some(variant) => format!("together-{variant}.json"),
            };
            files::write(&folder.join(name), json.as_bytes())?;
        }
        if !quiet {
            note!("results and figures are in {}", folder.display());
        }
    }
    let beyond = answers.iter().any(TuneAnswer::is_beyond_room);
    Ok(
        match beyond || together.iter().any(TogetherAnswer::is_beyond_room) {
            true => Outcome::Falls,
            false => Outcome::Stands,
        },
    )
}

/// The dampers that a report shows, each under a white-noise force along it.
pub(crate) fn of_report(project: &Project, file: &Path) -> Result<(Vec<TuneAnswer>, Vec<TogetherAnswer>)> {
    let options = Options::of_report(file);
    let shown = file.display().to_string();
    let (mut answers, mut together) = (Vec::new(), Vec::new());
    if matches!(project.structure, Structure::Building(_)) {
        for (version, variant) in versions(project, None)? {
            answers.extend(answers_of(version, variant.clone(), &shown, &options)?);
            together.extend(of_all((version, variant), &shown, &options)?);
        }
    }
    Ok((answers, together))
}

/// The variant that is asked for; else the file as it is if it has dampers; else its variants that do.
fn versions<'p>(project: &'p Project, variant: Option<&str>) -> Result<Vec<(&'p Project, Option<String>)>> {
    if let Some(name) = variant {
        let found = project.variants.iter().find(|variant| variant.name == name);
        let Some(found) = found else {
            let names: Vec<&str> = project.variants.iter().map(|v| v.name.as_str()).collect();
            let known = if names.is_empty() {
                "none".to_owned()
            } else {
                names.join(", ")
            };
            bail!("there is no variant \"{name}\": the file has {known}");
        };
        return Ok(vec![(&found.project, Some(name.to_owned()))]);
    }
    if !part_of(project)?.dampers.is_empty() {
        return Ok(vec![(project, None)]);
    }
    let variants = project.variants.iter();
    Ok(variants
        .map(|variant| (&variant.project, Some(variant.name.clone())))
        .collect())
}

pub(crate) fn part_of(project: &Project) -> Result<&BuildingPart> {
    match &project.structure {
        Structure::Building(part) => Ok(part),
        _ => bail!(
            "only buildings have dampers to tune: the file has another kind; start one with kind = \"building\""
        ),
    }
}

/// The building as it is written, which must stand.
pub(crate) fn standing(part: &BuildingPart) -> Result<&VibratingBuilding> {
    let Some(building) = part.as_written() else {
        bail!("the building falls under its own weight: `dolmen check` says where");
    };
    Ok(building)
}

fn answers_of(
    project: &Project,
    variant: Option<String>,
    file: &str,
    options: &Options,
) -> Result<Vec<TuneAnswer>> {
    let part = part_of(project)?;
    let building = standing(part)?;
    let dampers = part.dampers(building, &mut Quantity::nominal)?;
    let wished = dampers
        .iter()
        .filter(|damper| options.damper.as_ref().is_none_or(|name| *name == damper.name));
    let mut answers = Vec::new();
    for damper in wished {
        let of = Of {
            project,
            part,
            building,
            variant: variant.clone(),
            file,
            options,
        };
        let Some(given) = placed(damper, 0) else { continue };
        let answer = of.answer(damper, given);
        let mut answer = answer.with_context(|| format!("damper.{}", damper.name))?;
        answer.others = dampers.len() - 1;
        answers.push(answer);
    }
    Ok(answers)
}

/// A damper as one whose place can be found: a mass or a liquid column.
pub(crate) fn placed(damper: &BuiltDamper, site: usize) -> Option<PlacedDamper> {
    let length_ratio = match damper.kind {
        DamperKind::TunedMass { .. } => 1.0,
        DamperKind::LiquidColumn { length_ratio, .. } => length_ratio,
        DamperKind::LiquidColumnMass { .. } | DamperKind::Viscous { .. } => return None,
    };
    let [frequency_hz, damping_ratio] = damper.own()?;
    Some(PlacedDamper {
        site,
        place_m: damper.place_m,
        direction_degrees: degrees(damper.direction),
        mass_kg: damper.kind.mass_kg(),
        frequency_hz,
        damping_ratio,
        length_ratio,
    })
}

/// Everything around one damper.
struct Of<'a> {
    project: &'a Project,
    part: &'a BuildingPart,
    building: &'a VibratingBuilding,
    variant: Option<String>,
    file: &'a str,
    options: &'a Options,
}

pub(crate) fn degrees(direction: PlanDirection) -> f64 {
    match direction {
        PlanDirection::X => 0.0,
        PlanDirection::Y => 90.0,
        PlanDirection::Degrees(degrees) => degrees,
    }
}

impl Of<'_> {
    fn answer(&self, damper: &BuiltDamper, given: PlacedDamper) -> Result<TuneAnswer> {
        let (building, options) = (self.building.building(), self.options);
        let site = site(building, damper.floor)?;
        let corners_m = site.corners_m.clone();
        let Some(aim) = damper.tuned_to else {
            bail!("it is tuned to no mode");
        };
        let points = points(self.part, damper.floor, &corners_m);
        let rows = points.iter().map(|point| {
            building.point_row(point.floor, point.place_m[0], point.place_m[1], damper.direction)
        });
        let load_direction = options
            .load_direction
            .map_or(damper.direction, PlanDirection::Degrees);
        let load = load(options);
        let problem = DamperProblem {
            structure: structure(building, self.part)?,
            loads: vec![random_load(building, load, load_direction)],
            points: rows.collect::<Result<_, _>>()?,
            sites: vec![site],
            fixed: Vec::new(),
        };
        let plan = Plan::new(problem, &[given], &PlanOptions::default())?;
        let mode = &self.building.modes().modes[aim.mode - 1];
        let ratios = self.building.damping_ratios();
        let goal = goal(options);
        let comparison = compare(
            &plan,
            &given,
            &ComparisonOptions {
                mode: aim.mode - 1,
                structure_damping_ratio: ratios[aim.mode - 1],
                base: load.is_base(),
                goal,
                map_places: [options.map; 2],
                stroke_most: options.stroke_most,
                off_by: options.off,
                ..ComparisonOptions::default()
            },
        )?;
        Ok(TuneAnswer {
            file: self.file.to_owned(),
            name: self.project.name.clone(),
            variant: self.variant.clone(),
            damper: damper.name.clone(),
            others: 0,
            stroke_most: options.stroke_most,
            off_by: options.off,
            floor: damper.floor,
            corners_m,
            mode: aim.mode,
            mode_frequency_hz: mode.frequency_hz,
            mode_damping_ratio: ratios[aim.mode - 1],
            mode_centre_m: mode.centres[damper.floor - 1].map(|centre| [centre.x_m, centre.y_m]),
            load,
            load_direction_degrees: degrees(load_direction),
            points,
            direction_degrees: degrees(damper.direction),
            goal,
            room: self.room(damper, &comparison)?,
            comparison,
        })
    }

    /// The damper of each row under the motions of the file.
    fn room(&self, damper: &BuiltDamper, comparison: &Comparison) -> Result<RoomCheck> {
        let building = self.building.building();
        let sites = [site(building, damper.floor)?];
        let each = comparison.rows.iter().map(|row| {
            let attached = row.damper.attached(&sites, building.coordinates())?;
            Ok(vec![BuiltDamper {
                place_m: row.damper.place_m,
                kind: attached.kind,
                row: attached.row,
                ..damper.clone()
            }])
        });
        let rows: Vec<Vec<BuiltDamper>> = each.collect::<Result<_>>()?;
        room_check((self.project, self.part), Path::new(self.file), &rows)
    }
}

/// The building with its damping, as the dampers see it.
pub(crate) fn structure(building: &Building, part: &BuildingPart) -> Result<LinearSystem> {
    Ok(LinearSystem::new(
        building.mass_matrix(),
        building.damping_matrix(&part.damping(&mut Quantity::nominal))?,
        building.stiffness_matrix(),
    )?)
}

/// A floor as a place for dampers.
pub(crate) fn site(building: &Building, floor: usize) -> Result<DamperSite> {
    let own = &building.floors()[floor - 1];
    let Some(outline) = &own.outline else {
        bail!(
            "floor {floor} has no outline, so that places on it are not known: give sides or outline in its table"
        );
    };
    Ok(DamperSite {
        first_degree_of_freedom: 3 * (floor - 1),
        reference_m: own.centre_m,
        corners_m: outline.corners_m().to_vec(),
    })
}

pub(crate) fn random_load(building: &Building, load: TuneLoad, direction: PlanDirection) -> RandomLoad {
    let column = building.ground_column(direction);
    RandomLoad {
        input: match load.is_base() {
            true => RandomInput::Base(column),
            false => RandomInput::Force(column),
        },
        spectrum: spectrum(load),
    }
}

pub(crate) fn goal(options: &Options) -> Goal {
    match options.goal {
        TuneGoal::LargestRms => Goal::LargestRms,
        TuneGoal::MeanSquare => Goal::MeanSquare,
        TuneGoal::LargestPeak => Goal::LargestPeak,
    }
}

/// The points of the file, or the corners of a floor.
pub(crate) fn points(part: &BuildingPart, floor: usize, corners_m: &[[f64; 2]]) -> Vec<TunePoint> {
    if part.points.is_empty() {
        let corners = corners_m.iter();
        return corners
            .map(|corner| TunePoint {
                name: format!("({}, {})", corner[0], corner[1]),
                floor,
                place_m: *corner,
            })
            .collect();
    }
    let each = part.points.iter();
    each.map(|point| TunePoint {
        name: point.name.clone(),
        floor: point.floor,
        place_m: [point.place[0].value, point.place[1].value],
    })
    .collect()
}

pub(crate) fn load(options: &Options) -> TuneLoad {
    match options.load {
        Load::Force => TuneLoad::Force,
        Load::Wind => TuneLoad::Wind {
            corner_hz: options.corner,
        },
        Load::Base => TuneLoad::Base,
        Load::Ground => TuneLoad::Ground {
            ground_hz: options.ground,
        },
    }
}

fn spectrum(load: TuneLoad) -> Spectrum {
    match load {
        TuneLoad::Force | TuneLoad::Base => Spectrum::White { density: DENSITY },
        TuneLoad::Wind { corner_hz } => Spectrum::LowPass {
            density: DENSITY,
            corner_rad_s: TAU * corner_hz,
        },
        TuneLoad::Ground { ground_hz } => Spectrum::CloughPenzien {
            density: DENSITY,
            ground_rad_s: TAU * ground_hz,
            ground_damping_ratio: GROUND_DAMPING_RATIO,
            filter_rad_s: FILTER_PART * TAU * ground_hz,
            filter_damping_ratio: GROUND_DAMPING_RATIO,
        },
    }
}

fn write(answer: &TuneAnswer, folder: &Path, options: &Options) -> Result<()> {
    let put = |name: &str, bytes: &[u8]| files::write(&folder.join(name), bytes);
    put("tune.json", format!("{:#}\n", tune_json(answer)).as_bytes())?;
    for figure in tune_figures(answer, language(options.language)) {
        put(&format!("{}.svg", figure.name), figure.svg.as_bytes())?;
    }
    Ok(())
}
