//! `dolmen tune`: the dampers of a building beside the rule and the best, where and how tuned.

use crate::cli::{Tune as Options, TuneGoal, TuneLoad as Load};
use crate::simulate::language;
use crate::{Outcome, files, open};
use anyhow::{Context as _, Result, bail};
use dolmen::damper::{
    ComparisonOptions, DamperProblem, DamperSite, Goal, PlacedDamper, Plan, PlanOptions, compare,
};
use dolmen::dynamics::{LinearSystem, RandomInput, RandomLoad, Spectrum};
use dolmen::structure::building::{Building, PlanDirection};
use dolmen_formats::figures::tune_figures;
use dolmen_formats::json::tune_json;
use dolmen_formats::project::{BuildingPart, BuiltDamper, Project, Quantity, Structure};
use dolmen_formats::text::tune_text;
use dolmen_formats::tune::{TuneAnswer, TuneLoad, TunePoint};
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
    let mut answers = Vec::new();
    for (version, variant) in versions(&project, options.variant.as_deref())? {
        answers.extend(answers_of(version, variant, &shown, options)?);
    }
    if answers.is_empty() {
        match &options.damper {
            Some(name) => bail!("there is no damper \"{name}\" in {shown}"),
            None => bail!(
                "{shown} has no damper to tune: write a table such as [damper.roof] with kind = \"tmd\", floor, place, direction, mass_ratio \
                 and tuning, in the file or in a variant"
            ),
        }
    }
    if as_json {
        let all: Vec<_> = answers.iter().map(tune_json).collect();
        files::say(&format!("{:#}\n", serde_json::json!({ "dampers": all })))?;
    } else {
        for answer in &answers {
            files::say(&tune_text(answer))?;
        }
    }
    if let Some(folder) = &options.output {
        for answer in &answers {
            write(answer, &folder.join(&answer.damper), options)?;
        }
        if !quiet {
            eprintln!("results and figures are in {}", folder.display());
        }
    }
    Ok(Outcome::Stands)
}

/// The dampers that a report shows, each under a white-noise force along it.
pub(crate) fn of_report(project: &Project, file: &Path) -> Result<Vec<TuneAnswer>> {
    let options = Options::of_report(file);
    let mut answers = Vec::new();
    if matches!(project.structure, Structure::Building(_)) {
        for (version, variant) in versions(project, None)? {
            answers.extend(answers_of(
                version,
                variant,
                &file.display().to_string(),
                &options,
            )?);
        }
    }
    Ok(answers)
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

fn part_of(project: &Project) -> Result<&BuildingPart> {
    match &project.structure {
        Structure::Building(part) => Ok(part),
        _ => bail!(
            "only buildings have dampers to tune: the file has another kind; start one with kind = \"building\""
        ),
    }
}

fn answers_of(
    project: &Project,
    variant: Option<String>,
    file: &str,
    options: &Options,
) -> Result<Vec<TuneAnswer>> {
    let part = part_of(project)?;
    let building = part.build(&mut Quantity::nominal)?;
    let modes = building.modes()?;
    let dampers = part.dampers(&building, &modes, &mut Quantity::nominal)?;
    let wished = dampers
        .iter()
        .filter(|damper| options.damper.as_ref().is_none_or(|name| *name == damper.name));
    wished
        .map(|damper| {
            let of = Of {
                project,
                part,
                building: &building,
                variant: variant.clone(),
                file,
                options,
            };
            of.answer(damper, &modes)
                .with_context(|| format!("damper.{}", damper.name))
        })
        .collect()
}

/// Everything around one damper.
struct Of<'a> {
    project: &'a Project,
    part: &'a BuildingPart,
    building: &'a Building,
    variant: Option<String>,
    file: &'a str,
    options: &'a Options,
}

fn degrees(direction: PlanDirection) -> f64 {
    match direction {
        PlanDirection::X => 0.0,
        PlanDirection::Y => 90.0,
        PlanDirection::Degrees(degrees) => degrees,
    }
}

impl Of<'_> {
    fn answer(
        &self,
        damper: &BuiltDamper,
        modes: &dolmen::structure::building::BuildingModes,
    ) -> Result<TuneAnswer> {
        let (tuned, building, options) = (&damper.tuned, self.building, self.options);
        let floor = &building.floors()[tuned.floor - 1];
        let Some(outline) = &floor.outline else {
            bail!(
                "floor {} has no outline, so that places on it are not known: give sides or outline in its table",
                tuned.floor
            );
        };
        let corners_m = outline.corners_m().to_vec();
        let damping = self.part.damping(&mut Quantity::nominal);
        let structure = LinearSystem::new(
            building.mass_matrix(),
            building.damping_matrix(&damping)?,
            building.stiffness_matrix(),
        )?;
        let points = self.points(tuned.floor, &corners_m)?;
        let rows = points.iter().map(|point| {
            building.point_row(point.floor, point.place_m[0], point.place_m[1], tuned.direction)
        });
        let load_direction = options
            .load_direction
            .map_or(tuned.direction, PlanDirection::Degrees);
        let load = load(options);
        let column = building.ground_column(load_direction);
        let problem = DamperProblem {
            structure,
            loads: vec![RandomLoad {
                input: match load.is_base() {
                    true => RandomInput::Base(column),
                    false => RandomInput::Force(column),
                },
                spectrum: spectrum(load),
            }],
            points: rows.collect::<Result<_, _>>()?,
            sites: vec![DamperSite {
                first_degree_of_freedom: 3 * (tuned.floor - 1),
                reference_m: floor.centre_m,
                corners_m: corners_m.clone(),
            }],
        };
        let given = PlacedDamper {
            site: 0,
            place_m: [tuned.x_m, tuned.y_m],
            direction_degrees: degrees(tuned.direction),
            mass_kg: tuned.mass_kg,
            frequency_hz: tuned.frequency_hz,
            damping_ratio: tuned.damping_ratio,
        };
        let plan = Plan::new(problem, &[given], &PlanOptions::default())?;
        let mode = &modes.modes[damper.mode - 1];
        let ratios = modes.damping_ratios(&damping)?;
        let goal = match options.goal {
            TuneGoal::LargestRms => Goal::LargestRms,
            TuneGoal::MeanSquare => Goal::MeanSquare,
            TuneGoal::LargestPeak => Goal::LargestPeak,
        };
        let comparison = compare(
            &plan,
            &given,
            &ComparisonOptions {
                mode: damper.mode - 1,
                structure_damping_ratio: ratios[damper.mode - 1],
                base: load.is_base(),
                goal,
                map_places: [options.map; 2],
                stroke_rms_most_m: None,
                ..ComparisonOptions::default()
            },
        )?;
        Ok(TuneAnswer {
            file: self.file.to_owned(),
            name: self.project.name.clone(),
            variant: self.variant.clone(),
            damper: damper.name.clone(),
            others: self.part.dampers.len() - 1,
            floor: tuned.floor,
            corners_m,
            mode: damper.mode,
            mode_frequency_hz: mode.frequency_hz,
            mode_damping_ratio: ratios[damper.mode - 1],
            mode_centre_m: mode.centres[tuned.floor - 1].map(|centre| [centre.x_m, centre.y_m]),
            load,
            load_direction_degrees: degrees(load_direction),
            points,
            direction_degrees: degrees(tuned.direction),
            goal,
            comparison,
        })
    }

    /// The points of the file, or the corners of the damper's floor.
    fn points(&self, floor: usize, corners_m: &[[f64; 2]]) -> Result<Vec<TunePoint>> {
        if self.part.points.is_empty() {
            let corners = corners_m.iter();
            return Ok(corners
                .map(|corner| TunePoint {
                    name: format!("({}, {})", corner[0], corner[1]),
                    floor,
                    place_m: *corner,
                })
                .collect());
        }
        let each = self.part.points.iter();
        Ok(each
            .map(|point| TunePoint {
                name: point.name.clone(),
                floor: point.floor,
                place_m: [point.place[0].value, point.place[1].value],
            })
            .collect())
    }
}

fn load(options: &Options) -> TuneLoad {
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
