//! Reads static loads on the floors of a building.

use super::file::LoadRaw;
use super::file_force::ForceRaw;
use super::part::LoadPart;
use super::parts::{Parts, part_of};
use crate::building::BuildingPart;
use crate::error::Fault;
use crate::file_number::At;
use crate::measure::{Bound, Measure};
use crate::needed::{lengths, numbers};
use crate::quantity::Quantity;
use crate::reader::Reader;
use crate::wrong::WrongLoads;

/// A force along x and y at a point of the floor, and a torque about the vertical.
pub(super) fn floor_load(
    reader: &mut Reader,
    raw: &At<LoadRaw>,
    path: &str,
    (parts, building): (&Parts, &BuildingPart),
) -> Option<LoadPart> {
    let of = &raw.value;
    let part = part_of(reader, of.at.as_ref()?, &format!("{path}.at"), parts);
    let before = reader.faults.len();
    not_on_floors(reader, of, path);
    let force: Option<[Quantity; 2]> = of.force.as_ref().and_then(|raw| {
        let path = format!("{path}.force");
        match &raw.value {
            ForceRaw::Components(list) => {
                numbers(reader, (list, &raw.span), (&path, Measure::Force), "[x, y]")
            }
            ForceRaw::Along(_) => {
                let message = WrongLoads::ForceOnFloorNeedsDirection(path.clone());
                let fault = Fault::new(raw.span.clone(), &path, message);
                reader.fault(fault.help(WrongLoads::GiveForceOfFloor));
                None
            }
        }
    });
    let place: Option<[Quantity; 2]> = of
        .position
        .as_ref()
        .and_then(|raw| lengths(reader, raw, &format!("{path}.position"), "[x, y]"));
    let torque = reader.quantity(
        of.torque.as_ref(),
        &format!("{path}.torque"),
        Measure::Moment,
        Bound::Any,
    );
    (reader.faults.len() == before).then_some(())?;
    if of.force.is_none() && of.torque.is_none() {
        let message = WrongLoads::HasNoForceTorque(path.to_owned());
        let fault = Fault::new(raw.span.clone(), path, message);
        reader.fault(fault.help(WrongLoads::GiveForceOfFloor));
        return None;
    }
    if let (Some(place), Some(raw), Some(floor)) = (&place, &of.position, part) {
        on_floor(reader, place, raw, path, (building, floor))?;
    }
    let [force, force_across] = force.map_or([None, None], |force| force.map(Some));
    Some(LoadPart {
        name: of.name.as_ref()?.value.clone(),
        part: part?,
        height: None,
        position: None,
        place,
        force,
        force_across,
        components: None,
        weight: None,
        moment: None,
        torque,
    })
}

/// Rejects a point beside its floor, as for dampers.
fn on_floor(
    reader: &mut Reader,
    place: &[Quantity; 2],
    raw: &At<Vec<At<crate::file_number::QuantityRaw>>>,
    path: &str,
    (building, floor): (&BuildingPart, usize),
) -> Option<()> {
    let part = &building.floors[building.part_of_floor(floor + 1) - 1];
    let outline = part.outline.as_ref();
    let beyond_m = outline.map_or(0.0, |outline| outline.beyond_m([place[0].value, place[1].value]));
    if beyond_m <= 0.0 {
        return Some(());
    }
    let path = format!("{path}.position");
    let message = WrongLoads::PlaceBesideFloor {
        path: path.clone(),
        beyond: reader.echo(beyond_m, Measure::Length),
        floor: (floor + 1).to_string(),
    };
    reader.fault(Fault::new(raw.span.clone(), &path, message).help(WrongLoads::GiveTorqueBeside));
    None
}

/// Keys that have no meaning on a floor.
fn not_on_floors(reader: &mut Reader, of: &LoadRaw, path: &str) {
    let keys = [
        ("height", &of.height, WrongLoads::HeightOfFloorIs),
        ("weight", &of.weight, WrongLoads::WeightOfFloorIs),
        ("moment", &of.moment, WrongLoads::MomentOfFloorIs),
    ];
    for (key, given, help) in keys {
        if let Some(given) = given {
            let path = format!("{path}.{key}");
            let message = WrongLoads::IsNotReadHere(path.clone());
            reader.fault(Fault::new(given.span.clone(), &path, message).help(help));
        }
    }
}
