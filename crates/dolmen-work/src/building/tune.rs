//! `dolmen tune`: compares the dampers of a building with the rule and the optimum.

use super::tune_answer::{RoomCheck, TuneAnswer};
use super::tune_floors::{asked, floors_of, other_floors};
use super::tune_room::room_check;
use super::tune_together::of_all;
use super::tuned::{
    TuneFloors, TuneOptions, degrees, part_of, placed, points, random_loads, site, standing, structure,
};
use crate::answer::TuneAnswers;
use crate::error::{Within as _, WorkError};
use crate::opened::Opened;
use crate::version::no_such_variant;
use dolmen::damper::{
    Comparison, ComparisonOptions, DamperProblem, PlacedDamper, Plan, PlanOptions, compare,
};
use dolmen::dynamics::VibratingBuilding;
use dolmen::structure::building::PlanDirection;
use dolmen_project::{BuildingPart, BuiltDamper, Project, Quantity, Structure};
use dolmen_records::Files;

/// Compares every damper with the rule and the optimum, and tunes all of a version together.
///
/// # Errors
/// A project without a building or dampers that can be tuned, an unknown damper or variant, a building that falls.
pub fn tune(opened: &Opened, options: &TuneOptions, files: &dyn Files) -> Result<TuneAnswers, WorkError> {
    let (mut tunings, mut together) = (Vec::new(), Vec::new());
    for (version, variant) in versions(&opened.project, options.variant.as_deref())? {
        tunings.extend(answers_of(
            version,
            variant.clone(),
            (&opened.file, files),
            options,
        )?);
        if options.damper.is_none() {
            together.extend(of_all((version, variant), (&opened.file, files), options)?);
        }
    }
    if tunings.is_empty() && together.is_empty() {
        return Err(match &options.damper {
            Some(name) => WorkError::NoSuchDamper {
                name: name.clone(),
                file: opened.file.clone(),
            },
            None => WorkError::NoDamper {
                file: opened.file.clone(),
            },
        });
    }
    Ok(TuneAnswers { tunings, together })
}

/// The dampers that a report shows; none if the structure is not a building.
pub(crate) fn of_report(opened: &Opened, files: &dyn Files) -> Result<TuneAnswers, WorkError> {
    let (mut tunings, mut together) = (Vec::new(), Vec::new());
    if matches!(opened.project.structure, Structure::Building(_)) {
        for (version, variant) in versions(&opened.project, None)? {
            let options = TuneOptions {
                floors: floors_in_report(part_of(version)?),
                ..TuneOptions::default()
            };
            tunings.extend(answers_of(
                version,
                variant.clone(),
                (&opened.file, files),
                &options,
            )?);
            together.extend(of_all((version, variant), (&opened.file, files), &options)?);
        }
    }
    Ok(TuneAnswers { tunings, together })
}

/// Largest number of dampers times floors that a report compares; each takes some tenths of a second. Our choice.
const REPORTED_MOST: usize = 24;

/// All floors, if they are few.
fn floors_in_report(part: &BuildingPart) -> TuneFloors {
    let floors = part.as_written().map_or(0, |of| of.building().floors().len());
    match floors * part.dampers.len() <= REPORTED_MOST {
        true => TuneFloors::All,
        false => TuneFloors::Own,
    }
}

/// The requested variant; otherwise the file as it is if it has dampers; otherwise its variants that do.
fn versions<'p>(
    project: &'p Project,
    variant: Option<&str>,
) -> Result<Vec<(&'p Project, Option<String>)>, WorkError> {
    if let Some(name) = variant {
        let found = project.variants.iter().find(|variant| variant.name == name);
        let Some(found) = found else {
            return Err(no_such_variant(project, name));
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

fn answers_of(
    project: &Project,
    variant: Option<String>,
    (file, files): (&str, &dyn Files),
    options: &TuneOptions,
) -> Result<Vec<TuneAnswer>, WorkError> {
    let part = part_of(project)?;
    let building = standing(part)?;
    let dampers = part.dampers(building, &mut Quantity::nominal)?;
    let wished = dampers
        .iter()
        .filter(|damper| options.damper.as_ref().is_none_or(|name| *name == damper.name));
    let mut answers = Vec::new();
    for damper in wished {
        let of = TunedDamper {
            project,
            part,
            building,
            variant: variant.clone(),
            file,
            files,
            options,
        };
        let Some(given) = placed(damper, 0) else { continue };
        let answer = of.answer(damper, given);
        let mut answer = answer.within(|| format!("damper.{}", damper.name))?;
        answer.others = dampers.len() - 1;
        answers.push(answer);
    }
    Ok(answers)
}

/// The data of one damper.
struct TunedDamper<'a> {
    project: &'a Project,
    part: &'a BuildingPart,
    building: &'a VibratingBuilding,
    variant: Option<String>,
    file: &'a str,
    files: &'a dyn Files,
    options: &'a TuneOptions,
}

impl TunedDamper<'_> {
    fn answer(&self, damper: &BuiltDamper, given: PlacedDamper) -> Result<TuneAnswer, WorkError> {
        let (building, options) = (self.building.building(), self.options);
        let asked = asked(options.floors, building)?;
        let site = site(building, damper.floor)?;
        let corners_m = site.corners_m.clone();
        let Some(aim) = damper.tuned_to else {
            return Err(WorkError::TunedToNoMode);
        };
        let points = points(self.part, damper.floor, &corners_m);
        let rows = points.iter().map(|point| {
            building.point_row(point.floor, point.place_m[0], point.place_m[1], damper.direction)
        });
        let load_direction = options
            .load_direction_degrees
            .map_or(damper.direction, PlanDirection::Degrees);
        let load = options.load;
        let problem = DamperProblem {
            structure: structure(building, self.part)?,
            loads: random_loads((self.project, self.part), load, load_direction)?,
            points: rows.collect::<Result<_, _>>()?,
            sites: vec![site],
            fixed: Vec::new(),
        };
        let plan = Plan::new(problem, &[given], &PlanOptions::default())?;
        let mode = &self.building.modes().modes[aim.mode - 1];
        let ratios = self.building.damping_ratios();
        let goal = options.goal;
        let how = ComparisonOptions {
            mode: aim.mode - 1,
            structure_damping_ratio: ratios[aim.mode - 1],
            base: load.is_base(),
            goal,
            map_places: [options.map; 2],
            stroke_most: options.stroke_most,
            off_by: options.off_by,
            ..ComparisonOptions::default()
        };
        let comparison = compare(&plan, &given, &how)?;
        let floors = asked.map(|asked| {
            let of = (self.project, self.part, building);
            floors_of(of, self.files, damper, asked, (&plan, &comparison, &how))
        });
        Ok(TuneAnswer {
            file: self.file.to_owned(),
            name: self.project.name.clone(),
            variant: self.variant.clone(),
            damper: damper.name.clone(),
            others: 0,
            stroke_most: options.stroke_most,
            off_by: options.off_by,
            floor: damper.floor,
            corners_m,
            mode: aim.mode,
            mode_frequency_hz: mode.frequency_hz,
            mode_damping_ratio: ratios[aim.mode - 1],
            mode_centre_m: mode.centres[damper.floor - 1].map(|centre| [centre.x_m, centre.y_m]),
            load,
            load_direction_degrees: degrees(load_direction),
            points,
            points_are_corners: self.part.points.is_empty(),
            direction_degrees: degrees(damper.direction),
            goal,
            room: self.room(damper, &comparison)?,
            comparison,
            floors: floors.transpose()?,
            other_floors: other_floors(building, damper.floor),
        })
    }

    /// The damper of each row under the motions of the file.
    fn room(&self, damper: &BuiltDamper, comparison: &Comparison) -> Result<RoomCheck, WorkError> {
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
        let rows: Vec<Vec<BuiltDamper>> = each.collect::<Result<_, WorkError>>()?;
        room_check((self.project, self.part), self.files, &rows)
    }
}
