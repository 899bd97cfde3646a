//! Static loads and combinations from what is written.

use super::file::{CombinationRaw, LoadRaw};
use super::part::{CombinationPart, LoadPart, LoadsPart, WindPart};
use super::parts::{Parts, on_part, part_of, parts};
use super::read_wind::wind;
use crate::content::Structure;
use crate::error::Fault;
use crate::file::FileRaw;
use crate::file_number::At;
use crate::measure::{Bound, Measure};
use crate::needed::listed;
use crate::reader::Reader;
use crate::written::short;
use crate::wrong::{Common, WrongLoads};

/// Largest factor of a combination, our choice: codes have 1.7 at the most.
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
    let Some(parts) = parts(structure) else {
        for (key, span) in keys {
            if let Some(span) = span {
                let fault = Fault::new(span, key, WrongLoads::IsNotReadFor { key: key.to_string() });
                reader.fault(
                    fault
                        .allowed(Common::NoMeaningHere)
                        .help(WrongLoads::TakeItOutWind),
                );
            }
        }
        return LoadsPart::none();
    };
    let wind = match &raw.wind {
        None => WindPart::NotSaid,
        Some(raw) => wind(reader, raw, &parts).unwrap_or(WindPart::NotSaid),
    };
    let list = raw.loads.as_ref().map(|list| list.value.as_slice());
    let loads = listed(reader, list, "loads", |reader, raw, path| {
        load(reader, raw, path, &parts)
    });
    let mut combinations = Vec::new();
    let mut written: Vec<_> = raw.combination.iter().flatten().collect();
    written.sort_by_key(|(_, raw)| raw.span.start);
    for (name, raw) in written {
        combinations.extend(combination(reader, name, raw));
    }
    let missing = [
        ("wind", raw.wind.is_none(), WrongLoads::WriteWindSpeedMeans),
        ("loads", raw.loads.is_none(), WrongLoads::WriteLoadsNameAt),
    ];
    for (name, raw) in raw.combination.iter().flatten() {
        for ((key, is_missing, help), factor) in missing.iter().zip([&raw.value.wind, &raw.value.loads]) {
            if let Some(factor) = factor.as_ref().filter(|factor| *is_missing && factor.value > 0.0) {
                let path = format!("combination.{name}.{key}");
                let message = WrongLoads::ButFileHasNo {
                    path: path.to_string(),
                    factor: short(factor.value),
                    key: key.to_string(),
                };
                reader.fault(
                    Fault::new(factor.span.clone(), &path, message).help(WrongLoads::OrTakeItOut {
                        help: help.clone().into(),
                    }),
                );
            }
        }
    }
    let answer = LoadsPart {
        wind,
        loads: loads.unwrap_or_default(),
        combinations,
    };
    match (answer.is_empty(), answer.combinations.is_empty()) {
        (false, true) => LoadsPart {
            combinations: vec![CombinationPart {
                name: None,
                weight: 1.0,
                wind: 1.0,
                loads: 1.0,
            }],
            ..answer
        },
        _ => answer,
    }
}

fn load(reader: &mut Reader, raw: &At<LoadRaw>, path: &str, parts: &Parts<'_>) -> Option<LoadPart> {
    let of = &raw.value;
    let at = of.at.as_ref()?;
    let part = part_of(reader, at, &format!("{path}.at"), parts);
    let mut read =
        |raw, key: &str, measure, bound| reader.quantity(raw, &format!("{path}.{key}"), measure, bound);
    let height = read(of.height.as_ref(), "height", Measure::Length, Bound::NotNegative);
    let force = read(of.force.as_ref(), "force", Measure::Force, Bound::Any);
    let weight = read(of.weight.as_ref(), "weight", Measure::Force, Bound::NotNegative);
    let moment = read(of.moment.as_ref(), "moment", Measure::Moment, Bound::Any);
    if of.force.is_none() && of.weight.is_none() && of.moment.is_none() {
        let fault = Fault::new(
            raw.span.clone(),
            path,
            WrongLoads::HasNoForceWeight {
                path: path.to_string(),
            },
        );
        reader.fault(fault.help(WrongLoads::GiveForceFromSide));
        return None;
    }
    if let Some(height) = &height {
        on_part(reader, height, part?, parts)?;
    }
    Some(LoadPart {
        name: of.name.as_ref()?.value.clone(),
        part: part?,
        height,
        force,
        weight,
        moment,
    })
}

fn combination(reader: &mut Reader, name: &str, raw: &At<CombinationRaw>) -> Option<CombinationPart> {
    let path = format!("combination.{name}");
    let of = &raw.value;
    let mut factor = |raw: &Option<At<f64>>, key: &str, otherwise: f64| match raw {
        None => Some(otherwise),
        Some(_) => reader.within(raw.as_ref(), &format!("{path}.{key}"), 0.0, FACTOR_MOST),
    };
    let part = CombinationPart {
        name: Some(name.to_owned()),
        weight: factor(&of.weight, "weight", 1.0)?,
        wind: factor(&of.wind, "wind", 0.0)?,
        loads: factor(&of.loads, "loads", 0.0)?,
    };
    if part.weight > 0.0 {
        return Some(part);
    }
    let fault = Fault::new(
        raw.span.clone(),
        &path,
        WrongLoads::WeightLeavesNoWeight {
            path: path.to_string(),
        },
    );
    reader.fault(fault.help(WrongLoads::StonesWithoutWeightHold));
    None
}
