//! A damper of a building on other floors: where it would stand best.

use super::tune_answer::TunedFloors;
use super::tune_room::room_check;
use super::tuned::{TuneFloors, site};
use crate::error::WorkError;
use dolmen::damper::{Comparison, ComparisonOptions, FloorSite, Plan, compare_floors};
use dolmen::structure::Building;
use dolmen_project::{BuildingPart, BuiltDamper, Project};
use dolmen_records::Files;

/// Number of floors beside `own` on which a damper may stand.
pub(super) fn other_floors(building: &Building, own: usize) -> usize {
    let floors = building.floors().iter().zip(1..);
    floors
        .filter(|(floor, number)| *number != own && floor.outline.is_some())
        .count()
}

/// The lowest and the highest floor to compare; `None` if none was asked for.
pub(super) fn asked(floors: TuneFloors, building: &Building) -> Result<Option<[usize; 2]>, WorkError> {
    let count = building.floors().len();
    match floors {
        TuneFloors::Own => Ok(None),
        TuneFloors::All => Ok(Some([1, count])),
        TuneFloors::Range { from, to } if from < 1 || from > to || to > count => {
            Err(WorkError::NoSuchFloors { from, to, count })
        }
        TuneFloors::Range { from, to } => Ok(Some([from, to])),
    }
}

/// The damper on the floors from one to another, and on that of the file.
pub(super) fn floors_of(
    (project, part, building): (&Project, &BuildingPart, &Building),
    files: &dyn Files,
    damper: &BuiltDamper,
    [from, to]: [usize; 2],
    (plan, comparison, how): (&Plan, &Comparison, &ComparisonOptions),
) -> Result<TunedFloors, WorkError> {
    let mut sites = Vec::new();
    let mut without_outline = Vec::new();
    let numbered = building.floors().iter().zip(1..);
    for (own, floor) in numbered.filter(|(_, floor)| (from..=to).contains(floor) || *floor == damper.floor) {
        match own.outline {
            None => without_outline.push(floor),
            Some(_) => sites.push(FloorSite {
                floor,
                site: site(building, floor)?,
            }),
        }
    }
    let compared = compare_floors(plan, (damper.floor, comparison), &sites, how)?;
    let best = compared.best().filter(|best| best.floor != damper.floor);
    let mut rows = Vec::new();
    if let Some(best) = best {
        let there = [site(building, best.floor)?];
        let attached = best.damper.attached(&there, building.coordinates())?;
        rows.push(vec![BuiltDamper {
            floor: best.floor,
            place_m: best.damper.place_m,
            kind: attached.kind,
            row: attached.row,
            ..damper.clone()
        }]);
    }
    Ok(TunedFloors {
        room: room_check((project, part), files, &rows)?,
        comparison: compared,
        without_outline,
    })
}
