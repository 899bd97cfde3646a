//! Reads static loads and combinations.

use super::file::{CombinationRaw, LoadRaw};
use super::file_force::ForceRaw;
use super::part::{CombinationPart, LoadPart, LoadsPart, WindPart};
use super::parts::{Parts, on_part, part_of, parts};
use super::read_on_floor::floor_load;
use super::read_wind::wind;
use crate::content::Structure;
use crate::error::Fault;
use crate::file::FileRaw;
use crate::file_number::{At, QuantityRaw};
use crate::measure::{Bound, Measure};
use crate::needed::{lengths, listed, numbers};
use crate::quantity::Quantity;
use crate::reader::Reader;
use crate::written::short;
use crate::wrong::{Common, WrongLoads};
use dolmen::signal::Component;

/// Largest factor of a combination, our choice: codes have at most 1.7.
const FACTOR_MOST: f64 = 10.0;

/// Wind, static loads and combinations.
pub(crate) fn loads(reader: &mut Reader, raw: &FileRaw, structure: Option<&Structure>) -> LoadsPart {
    let keys = [
        ("wind", raw.wind.as_ref().map(|at| at.span.clone())),
        ("loads", raw.loads.as_ref().map(|at| at.span.clone())),
        (
            "combination",
            raw.combination
                .as_ref()
                .and_then(|all| Some(all.values().next()?.span.clone())),
        ),
    ];
    let Some(structure) = structure else {
        return LoadsPart::none();
    };
    let parts = parts(structure);
    let foreign = keys
        .iter()
        .filter(|_| parts.is_none())
        .filter_map(|(key, span)| Some((key, span.clone()?)));
    for (key, span) in foreign {
        let fault = Fault::new(span, key, WrongLoads::IsNotReadFor((*key).to_owned()));
        reader.fault(
            fault
                .allowed(Common::NoMeaningHere)
                .help(WrongLoads::TakeItOutWind),
        );
    }
    let Some(parts) = parts else {
        return LoadsPart::none();
    };
    let wind = match &raw.wind {
        None => WindPart::NotSaid,
        Some(raw) => wind(reader, raw, &parts).unwrap_or(WindPart::NotSaid),
    };
    let list = raw.loads.as_ref().map(|list| list.value.as_slice());
    let loads = listed(reader, list, "loads", |reader, raw, path| match structure {
        Structure::Building(building) => floor_load(reader, raw, path, (&parts, building)),
        _ => load(reader, raw, path, &parts),
    });
    let mut combinations = Vec::new();
    let mut written: Vec<_> = raw.combination.iter().flatten().collect();
    written.sort_by_key(|(_, raw)| raw.span.start);
    for (name, raw) in written {
        combinations.extend(combination(reader, name, raw, &parts));
    }
    judge_factors(reader, raw);
    let answer = LoadsPart {
        wind,
        loads: loads.unwrap_or_default(),
        combinations,
    };
    // the wind on a building alone is judged without a combination
    let is_alone = parts.are_floors && answer.loads.is_empty();
    match (answer.is_empty() || is_alone, answer.combinations.is_empty()) {
        (false, true) => LoadsPart {
            combinations: vec![CombinationPart {
                name: None,
                weight: 1.0,
                wind: if parts.are_floors && answer.wind().is_none() {
                    0.0
                } else {
                    1.0
                },
                loads: 1.0,
                earthquake: 0.0,
            }],
            ..answer
        },
        _ => answer,
    }
}

/// Rejects a factor on a load that the file does not have.
fn judge_factors(reader: &mut Reader, raw: &FileRaw) {
    let missing = [
        ("wind", raw.wind.is_none(), WrongLoads::WriteWindSpeedMeans),
        ("loads", raw.loads.is_none(), WrongLoads::WriteLoadsNameAt),
        ("site", raw.site.is_none(), WrongLoads::WriteSite),
    ];
    for (name, raw) in raw.combination.iter().flatten() {
        let factors = [&raw.value.wind, &raw.value.loads, &raw.value.earthquake];
        for ((key, is_missing, help), factor) in missing.iter().zip(factors) {
            if let Some(factor) = factor.as_ref().filter(|factor| *is_missing && factor.value > 0.0) {
                let path = match *key {
                    "site" => format!("combination.{name}.earthquake"),
                    key => format!("combination.{name}.{key}"),
                };
                let message = WrongLoads::ButFileHasNo {
                    path: path.to_string(),
                    factor: short(factor.value),
                    key: key.to_string(),
                };
                reader.fault(
                    Fault::new(factor.span.clone(), &path, message)
                        .help(WrongLoads::OrTakeItOut(help.clone().into())),
                );
            }
        }
    }
}

fn load(reader: &mut Reader, raw: &At<LoadRaw>, path: &str, parts: &Parts) -> Option<LoadPart> {
    let of = &raw.value;
    let at = of.at.as_ref()?;
    let part = part_of(reader, at, &format!("{path}.at"), parts);
    let before = reader.faults.len();
    foreign(reader, of, path, parts);
    let (force, components) = forces(reader, of, path, parts);
    let [force, force_across] = force.map_or([None, None], |force| force);
    let position = of.position.as_ref().and_then(|raw| {
        let path = format!("{path}.position");
        lengths(reader, raw, &path, "[x, y, z]")
    });
    let mut read =
        |raw, key: &str, measure, bound| reader.quantity(raw, &format!("{path}.{key}"), measure, bound);
    let height = read(of.height.as_ref(), "height", Measure::Length, Bound::NotNegative);
    let weight = read(of.weight.as_ref(), "weight", Measure::Force, Bound::NotNegative);
    let moment = read(of.moment.as_ref(), "moment", Measure::Moment, Bound::Any);
    (reader.faults.len() == before).then_some(())?;
    if of.force.is_none() && of.weight.is_none() && of.moment.is_none() {
        let message = match parts.are_stones {
            true => WrongLoads::HasNoForce(path.to_string()),
            false => WrongLoads::HasNoForceWeight(path.to_string()),
        };
        let help = match parts.are_stones {
            true => WrongLoads::GiveForceOfThree,
            false if parts.directions.is_some() => WrongLoads::GiveForceOrWeight,
            false => WrongLoads::GiveForceFromSide,
        };
        reader.fault(Fault::new(raw.span.clone(), path, message).help(help));
        return None;
    }
    if let Some(height) = &height {
        on_part(reader, height, (part?, 0.0), parts)?;
    }
    Some(LoadPart {
        name: of.name.as_ref()?.value.clone(),
        part: part?,
        height,
        position,
        place: None,
        force,
        force_across,
        components,
        weight,
        moment,
        torque: None,
    })
}

/// The horizontal force, along and across, or the three components of a force on a stone.
fn forces(
    reader: &mut Reader,
    of: &LoadRaw,
    path: &str,
    parts: &Parts,
) -> (Option<[Option<Quantity>; 2]>, Option<[Quantity; 3]>) {
    let Some(raw) = &of.force else {
        return (None, None);
    };
    let path = format!("{path}.force");
    let refuse = |reader: &mut Reader, message: WrongLoads, help: WrongLoads| {
        reader.fault(Fault::new(raw.span.clone(), &path, message).help(help));
        (None, None)
    };
    match (&raw.value, parts.are_stones) {
        (ForceRaw::Along(_), false) if parts.directions.is_some() && parts.have_two_axes => {
            let message = WrongLoads::ForceOnFrameNeedsDirection(path.clone());
            refuse(reader, message, WrongLoads::GiveForceOfTwo)
        }
        (ForceRaw::Along(value), false) => {
            let along = reader.quantity_at((value, &raw.span), &path, Measure::Force, Bound::Any);
            (Some([along, None]), None)
        }
        (ForceRaw::Components(list), false) if list.len() == 2 && parts.have_two_axes => {
            let mut of = |axis: usize| {
                let (path, at) = (format!("{path}[{}]", axis + 1), &list[axis]);
                reader.quantity_at((&at.value, &at.span), &path, Measure::Force, Bound::Any)
            };
            let both = [of(0), of(1)];
            directed(reader, &both, parts);
            (Some(both), None)
        }
        (ForceRaw::Components(list), true) => (
            None,
            numbers(reader, (list, &raw.span), (&path, Measure::Force), "[x, y, z]"),
        ),
        (ForceRaw::Along(_), true) => {
            let message = WrongLoads::ForceOnStoneNeedsDirection(path.clone());
            refuse(reader, message, WrongLoads::GiveForceOfThree)
        }
        (ForceRaw::Components(_), false) if parts.directions.is_some() => {
            let message = WrongLoads::ForceOnFrame(path.clone());
            let help = match parts.have_two_axes {
                true => WrongLoads::GiveForceOfTwo,
                false => WrongLoads::GiveForceAlongOne,
            };
            refuse(reader, message, help)
        }
        (ForceRaw::Components(_), false) => {
            let message = WrongLoads::ForceIsFromSide(path.clone());
            refuse(reader, message, WrongLoads::GiveForceFromSide)
        }
    }
}

/// Rejects a component along which a frame has no direction: no storey would resist it.
fn directed(reader: &mut Reader, both: &[Option<Quantity>; 2], parts: &Parts) {
    let Some(directions) = &parts.directions else {
        return;
    };
    for (force, component) in both.iter().zip([Component::X, Component::Y]) {
        let has_direction = directions.iter().any(|(_, along)| *along == Some(component));
        let Some(force) = force
            .as_ref()
            .filter(|force| force.value != 0.0 && !has_direction)
        else {
            continue;
        };
        let message = WrongLoads::NothingAlong {
            path: force.path.clone(),
            component: component.name().to_owned(),
        };
        let help = WrongLoads::WriteAlong(component.name().to_owned());
        reader.fault(Fault::new(reader.place(&force.path), &force.path, message).help(help));
    }
}

/// Keys of another kind of structure.
fn foreign(reader: &mut Reader, of: &LoadRaw, path: &str, parts: &Parts) {
    let span = |at: &Option<At<QuantityRaw>>| at.as_ref().map(|at| at.span.clone());
    let position = of.position.as_ref().map(|at| at.span.clone());
    let torque = span(&of.torque);
    let both = position.clone().filter(|_| of.height.is_some());
    let mut keys = match parts.are_stones {
        true => vec![
            ("weight", span(&of.weight), WrongLoads::WeightOfStoneIs),
            ("moment", span(&of.moment), WrongLoads::MomentOfStoneIs),
            ("position", both, WrongLoads::PositionHasHeight),
        ],
        false if parts.directions.is_some() => vec![
            ("moment", span(&of.moment), WrongLoads::MomentOfStoreyIs),
            ("position", position, WrongLoads::GiveHeightInstead),
        ],
        false => vec![("position", position, WrongLoads::GiveHeightInstead)],
    };
    keys.push(("torque", torque, WrongLoads::TorqueOfBuilding));
    for (key, span, help) in keys {
        if let Some(span) = span {
            let path = format!("{path}.{key}");
            let message = WrongLoads::IsNotReadHere(path.clone());
            reader.fault(Fault::new(span, &path, message).help(help));
        }
    }
}

fn combination(
    reader: &mut Reader,
    name: &str,
    raw: &At<CombinationRaw>,
    parts: &Parts,
) -> Option<CombinationPart> {
    let path = format!("combination.{name}");
    let of = &raw.value;
    if let Some(factor) = of.earthquake.as_ref().filter(|_| !parts.are_floors) {
        let path = format!("{path}.earthquake");
        let message = WrongLoads::IsNotReadHere(path.clone());
        let fault = Fault::new(factor.span.clone(), &path, message);
        reader.fault(fault.help(WrongLoads::EarthquakeOfBuilding));
        return None;
    }
    let mut factor = |raw: &Option<At<f64>>, key: &str, otherwise: f64| match raw {
        None => Some(otherwise),
        Some(_) => reader.within(raw.as_ref(), &format!("{path}.{key}"), 0.0, FACTOR_MOST),
    };
    let part = CombinationPart {
        name: Some(name.to_owned()),
        weight: factor(&of.weight, "weight", 1.0)?,
        wind: factor(&of.wind, "wind", 0.0)?,
        loads: factor(&of.loads, "loads", 0.0)?,
        earthquake: factor(&of.earthquake, "earthquake", 0.0)?,
    };
    if part.weight > 0.0 {
        return Some(part);
    }
    let fault = Fault::new(
        raw.span.clone(),
        &path,
        WrongLoads::WeightLeavesNoWeight(path.to_string()),
    );
    reader.fault(fault.help(WrongLoads::StonesWithoutWeightHold));
    None
}
