//! Reads wind.

use super::file::{MeansRaw, TerrainRaw, WindAreaRaw, WindCodeRaw, WindOrShelteredRaw, WindRaw};
use super::part::{WindArea, WindGiven, WindPart, WindSpeed};
use super::parts::{Parts, on_part, part_of};
use super::read_in_time::in_time;
use crate::error::Fault;
use crate::exact::exact;
use crate::file_number::{At, QuantityRaw};
use crate::measure::{Bound, Measure};
use crate::needed::listed;
use crate::reader::Reader;
use crate::wrong::{Common, WrongLoads};
use dolmen::structure::wind::{EUROCODE_AIR_KG_M3, EurocodeTerrain, KDS_41_AIR_KG_M3, Kds41Exposure};
use dolmen_words::message::Both;
use std::ops::Range;

/// Factor for importance, our choice: codes reach about 2.
const FACTOR: (f64, f64) = (0.5, 3.0);
/// Factor on the speed for hills: c_o and K_zt are never below 1 (EN 1991-1-4:2005, A.3; KDS 41 12 00, K_zt = 1 on level ground).
const TOPOGRAPHY: (f64, f64) = (1.0, FACTOR.1);

pub(super) fn wind(reader: &mut Reader, raw: &At<WindOrShelteredRaw>, parts: &Parts) -> Option<WindPart> {
    reader.mark("wind", &raw.span);
    let of = match &raw.value {
        WindOrShelteredRaw::Sheltered => return Some(WindPart::Sheltered),
        WindOrShelteredRaw::Wind(of) => of,
    };
    let speed = speed(reader, of, &raw.span);
    let density = reader.quantity(
        of.density.as_ref(),
        "wind.density",
        Measure::Density,
        Bound::Positive,
    );
    let density = exact(reader, density, of.density.as_ref());
    let force_coefficient = reader.quantity(
        of.force_coefficient.as_ref(),
        "wind.force_coefficient",
        Measure::Ratio,
        Bound::Positive,
    );
    let in_time = in_time(reader, of, &raw.span, parts);
    let areas = match parts.are_floors {
        true => Vec::new(),
        false => {
            let areas = listed(reader, of.areas.as_deref(), "wind.areas", |reader, raw, path| {
                area(reader, raw, path, parts)
            });
            let areas = areas?;
            widths_known(reader, &areas, parts);
            areas
        }
    };
    let speed = speed?;
    let of_code = match &speed {
        WindSpeed::Kds41 { .. } => KDS_41_AIR_KG_M3,
        WindSpeed::Pressure(_) | WindSpeed::Gust(_) | WindSpeed::Eurocode { .. } => EUROCODE_AIR_KG_M3,
    };
    Some(WindPart::Given(Box::new(WindGiven {
        speed,
        air_density_kg_m3: density.map_or(of_code, |density| density.value),
        force_coefficient: force_coefficient?,
        areas,
        in_time: in_time?,
        source: of.source.clone(),
    })))
}

/// Reports parts exposed to wind without a width.
fn widths_known(reader: &mut Reader, areas: &[WindArea], parts: &Parts) {
    let ways = parts.directions.as_ref().map_or(1, Vec::len);
    let is_given =
        |part: usize| (0..ways).all(|direction| areas.iter().any(|area| area.replaces(part, direction)));
    let unknown: Vec<String> = (0..parts.has_width.len())
        .filter(|part| !parts.has_width[*part] && !is_given(*part))
        .map(|part| format!("{}[{}]", parts.list, part + 1))
        .collect();
    if let Some(first) = unknown.first() {
        let unknown = unknown.join(", ");
        let first = first.clone();
        let (message, help) = match parts.directions {
            None => (
                WrongLoads::WindWidthOfIs(unknown),
                WrongLoads::GiveBreadthOrBed(first),
            ),
            Some(_) => (
                WrongLoads::WindAreaOfIs(unknown),
                WrongLoads::GiveAreaOfStorey(first),
            ),
        };
        reader.fault(Fault::new(reader.place("wind"), "wind", message).help(help));
    }
}

fn refuse(reader: &mut Reader, span: Range<usize>, path: &str, message: WrongLoads, help: WrongLoads) {
    reader.fault(Fault::new(span, path, message).help(help));
}

/// The speed or pressure: exactly one, with its definition, and the code for a mean.
fn speed(reader: &mut Reader, of: &WindRaw, span: &Range<usize>) -> Option<WindSpeed> {
    let before = reader.faults.len();
    match (&of.speed, &of.pressure) {
        (Some(_), Some(pressure)) => refuse(
            reader,
            pressure.span.clone(),
            "wind",
            WrongLoads::WindHasBothSpeed,
            WrongLoads::KeepOneOfThem,
        ),
        (None, None) => refuse(
            reader,
            span.clone(),
            "wind",
            WrongLoads::WindHasNeitherSpeed,
            WrongLoads::GiveSpeedMS,
        ),
        _ => {}
    }
    let Some(means) = &of.means else {
        if !reader.is_reported("wind.means") {
            refuse(
                reader,
                span.clone(),
                "wind",
                WrongLoads::WindDoesNotSay,
                WrongLoads::WriteMeansGustFor,
            );
        }
        return None;
    };
    match (means.value, &of.code, &of.pressure) {
        (MeansRaw::Gust, Some(code), _) => refuse(
            reader,
            code.span.clone(),
            "wind.code",
            WrongLoads::WindHasCodeBut,
            WrongLoads::WriteMeansMinIf,
        ),
        (MeansRaw::TenMinutes, _, Some(pressure)) => refuse(
            reader,
            pressure.span.clone(),
            "wind.pressure",
            WrongLoads::WindPressureIsMean,
            WrongLoads::GiveSpeedWithCode,
        ),
        (MeansRaw::TenMinutes, None, None) => refuse(
            reader,
            means.span.clone(),
            "wind.means",
            WrongLoads::WindMeansMinBut,
            WrongLoads::WriteCodeEnOr,
        ),
        _ => {}
    }
    foreign(reader, of);
    let read = |reader: &mut Reader, raw: &Option<At<QuantityRaw>>, path: &str, measure| {
        reader.quantity(raw.as_ref(), path, measure, Bound::Positive)
    };
    let quantity = match &of.pressure {
        Some(_) => read(reader, &of.pressure, "wind.pressure", Measure::Stress),
        None => read(reader, &of.speed, "wind.speed", Measure::Velocity),
    };
    let factors = [
        (&of.topography, "wind.topography", TOPOGRAPHY),
        (&of.importance_factor, "wind.importance_factor", FACTOR),
    ]
    .map(|(raw, path, (least, most))| match raw {
        None => Some(1.0),
        Some(_) => reader.within(raw.as_ref(), path, least, most),
    });
    let code = of.code.as_ref().map(|code| code.value);
    let terrain = code.and_then(|code| terrain(reader, of, code, span));
    if reader.faults.len() > before {
        return None;
    }
    let (quantity, [topography, importance]) = (quantity?, factors);
    Some(match (code, of.pressure.is_some()) {
        (None, true) => WindSpeed::Pressure(quantity),
        (None, false) => WindSpeed::Gust(quantity),
        (Some(_), _) => match terrain? {
            Ground::Eurocode(terrain) => WindSpeed::Eurocode {
                speed: quantity,
                terrain,
                orography: topography?,
            },
            Ground::Kds41(exposure) => WindSpeed::Kds41 {
                speed: quantity,
                exposure,
                topography: topography?,
                importance: importance?,
            },
        },
    })
}

/// Keys that need a code, or another code.
fn foreign(reader: &mut Reader, of: &WindRaw) {
    let code = of.code.as_ref().map(|code| code.value);
    let is_kds = code == Some(WindCodeRaw::Kds41);
    let keys = [
        (
            "wind.terrain",
            of.terrain.as_ref().map(|at| &at.span),
            code.is_some(),
            WrongLoads::Code.into(),
        ),
        (
            "wind.topography",
            of.topography.as_ref().map(|at| &at.span),
            code.is_some(),
            WrongLoads::Code.into(),
        ),
        (
            "wind.importance_factor",
            of.importance_factor.as_ref().map(|at| &at.span),
            is_kds,
            Both::from("code = \"KDS 41 12 00\""),
        ),
        (
            "wind.density",
            of.density.as_ref().map(|at| &at.span),
            of.pressure.is_none(),
            WrongLoads::Speed.into(),
        ),
    ];
    for (path, span, fits, needs) in keys {
        if let (Some(span), false) = (span, fits) {
            let fault = Fault::new(
                span.clone(),
                path,
                WrongLoads::HasNoMeaningWithout {
                    path: path.to_string(),
                    needs,
                },
            );
            reader.fault(fault.help(Common::TakeItOut));
        }
    }
}

enum Ground {
    Eurocode(EurocodeTerrain),
    Kds41(Kds41Exposure),
}

fn terrain(reader: &mut Reader, of: &WindRaw, code: WindCodeRaw, span: &Range<usize>) -> Option<Ground> {
    let allowed = match code {
        WindCodeRaw::Eurocode => WrongLoads::CodeEnHasTerrain,
        WindCodeRaw::Kds41 => WrongLoads::CodeKdsHasTerrain,
    };
    let Some(terrain) = &of.terrain else {
        if !reader.is_reported("wind.terrain") {
            refuse(
                reader,
                span.clone(),
                "wind",
                WrongLoads::WindHasCodeButNo,
                allowed,
            );
        }
        return None;
    };
    let ground = match (code, terrain.value) {
        (WindCodeRaw::Eurocode, TerrainRaw::Zero) => Ground::Eurocode(EurocodeTerrain::Zero),
        (WindCodeRaw::Eurocode, TerrainRaw::I) => Ground::Eurocode(EurocodeTerrain::I),
        (WindCodeRaw::Eurocode, TerrainRaw::Ii) => Ground::Eurocode(EurocodeTerrain::Ii),
        (WindCodeRaw::Eurocode, TerrainRaw::Iii) => Ground::Eurocode(EurocodeTerrain::Iii),
        (WindCodeRaw::Eurocode, TerrainRaw::Iv) => Ground::Eurocode(EurocodeTerrain::Iv),
        (WindCodeRaw::Kds41, TerrainRaw::A) => Ground::Kds41(Kds41Exposure::A),
        (WindCodeRaw::Kds41, TerrainRaw::B) => Ground::Kds41(Kds41Exposure::B),
        (WindCodeRaw::Kds41, TerrainRaw::C) => Ground::Kds41(Kds41Exposure::C),
        (WindCodeRaw::Kds41, TerrainRaw::D) => Ground::Kds41(Kds41Exposure::D),
        _ => {
            refuse(
                reader,
                terrain.span.clone(),
                "wind.terrain",
                WrongLoads::WindTerrainIsOne,
                allowed,
            );
            return None;
        }
    };
    Some(ground)
}

fn area(reader: &mut Reader, raw: &At<WindAreaRaw>, path: &str, parts: &Parts) -> Option<WindArea> {
    let of = &raw.value;
    let part = of
        .part
        .as_ref()
        .and_then(|part| part_of(reader, part, &format!("{path}.part"), parts));
    let mut read =
        |raw, key: &str, measure, bound| reader.quantity(raw, &format!("{path}.{key}"), measure, bound);
    let area = read(of.area.as_ref(), "area", Measure::Area, Bound::NotNegative);
    let height = read(of.height.as_ref(), "height", Measure::Length, Bound::NotNegative);
    let force_coefficient = read(
        of.force_coefficient.as_ref(),
        "force_coefficient",
        Measure::Ratio,
        Bound::Positive,
    );
    if let Some(height) = &height {
        on_part(reader, height, (part?, parts.above_m), parts)?;
    }
    let before = reader.faults.len();
    let direction = of
        .direction
        .as_ref()
        .and_then(|raw| direction(reader, raw, &format!("{path}.direction"), parts));
    (reader.faults.len() == before).then_some(())?;
    Some(WindArea {
        part: part?,
        area: area?,
        height,
        force_coefficient,
        direction,
    })
}

/// The direction of a frame along which the wind blows; rejected for other kinds.
fn direction(reader: &mut Reader, raw: &At<String>, path: &str, parts: &Parts) -> Option<usize> {
    let Some(directions) = &parts.directions else {
        let message = WrongLoads::HasNoMeaningWithout {
            path: path.to_owned(),
            needs: "kind = \"frame\"".into(),
        };
        reader.fault(Fault::new(raw.span.clone(), path, message).help(Common::TakeItOut));
        return None;
    };
    let found = directions.iter().position(|(name, _)| *name == raw.value);
    if found.is_none() {
        let names: Vec<&str> = directions.iter().map(|(name, _)| name.as_str()).collect();
        let message = WrongLoads::ThereIsNoDirection {
            path: path.to_owned(),
            written: raw.value.clone(),
        };
        let help = WrongLoads::DirectionsAre(names.join(", "));
        reader.fault(Fault::new(raw.span.clone(), path, message).help(help));
    }
    found
}
