//! Wind from what is written.

use super::file::{MeansRaw, TerrainRaw, WindAreaRaw, WindCodeRaw, WindOrShelteredRaw, WindRaw};
use super::part::{WindArea, WindGiven, WindPart, WindSpeed};
use super::parts::{Parts, on_part, part_of};
use crate::error::Fault;
use crate::file_number::{At, QuantityRaw};
use crate::measure::{Bound, Measure};
use crate::needed::listed;
use crate::reader::Reader;
use dolmen::structure::wind::{EUROCODE_AIR_KG_M3, EurocodeTerrain, KDS_41_AIR_KG_M3, Kds41Exposure};
use std::ops::Range;

/// Factors for hills and importance, our choice: codes end at 2 or so.
const FACTOR: (f64, f64) = (0.5, 3.0);
/// What to write where a speed says not what it is.
const WRITE_MEANS: &str = "write means = \"gust\" for a gust of some 3 s, or means = \"10 min\" with code = \"EN 1991-1-4\" or \"KDS 41 12 00\" for \
    the mean that weather stations and maps of codes give: the force differs by a factor of 2 to 3";

pub(super) fn wind(reader: &mut Reader, raw: &At<WindOrShelteredRaw>, parts: &Parts<'_>) -> Option<WindPart> {
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
    let force_coefficient = reader.quantity(
        of.force_coefficient.as_ref(),
        "wind.force_coefficient",
        Measure::Ratio,
        Bound::Positive,
    );
    let areas = listed(reader, of.areas.as_deref(), "wind.areas", |reader, raw, path| {
        area(reader, raw, path, parts)
    });
    let areas = areas?;
    widths_known(reader, &areas, parts);
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
        source: of.source.clone(),
    })))
}

/// Parts that the wind meets and whose width nobody gave.
fn widths_known(reader: &mut Reader, areas: &[WindArea], parts: &Parts<'_>) {
    let is_given = |part: usize| {
        areas
            .iter()
            .any(|area| area.part == part && area.height.is_none())
    };
    let unknown: Vec<String> = (0..parts.has_width.len())
        .filter(|part| !parts.has_width[*part] && !is_given(*part))
        .map(|part| format!("{}[{}]", parts.list, part + 1))
        .collect();
    if let Some(first) = unknown.first() {
        let message = format!("wind: the width of {} is not known", unknown.join(", "));
        let help = format!(
            "give {first}.breadth or bed_width, or wind.areas = [{{ part = \"{first}\", area = … }}]"
        );
        reader.fault(Fault::new(reader.place("wind"), "wind", message).help(help));
    }
}

fn refuse(reader: &mut Reader, span: Range<usize>, path: &str, message: &str, help: &str) {
    reader.fault(Fault::new(span, path, message).help(help));
}

/// The speed or pressure: one of them, with what it is, and the code for a mean.
fn speed(reader: &mut Reader, of: &WindRaw, span: &Range<usize>) -> Option<WindSpeed> {
    let before = reader.faults.len();
    match (&of.speed, &of.pressure) {
        (Some(_), Some(pressure)) => refuse(
            reader,
            pressure.span.clone(),
            "wind",
            "wind has both speed and pressure",
            "keep one of them: pressure = ½ ρ speed²",
        ),
        (None, None) => refuse(
            reader,
            span.clone(),
            "wind",
            "wind has neither speed nor pressure",
            "give speed = \"30 m/s\" or pressure = \"0.6 kPa\", with means = \"gust\" or \"10 min\"",
        ),
        _ => {}
    }
    let Some(means) = &of.means else {
        if !reader.is_reported("wind.means") {
            refuse(
                reader,
                span.clone(),
                "wind",
                "wind does not say whether it is a gust or a mean",
                WRITE_MEANS,
            );
        }
        return None;
    };
    match (means.value, &of.code, &of.pressure) {
        (MeansRaw::Gust, Some(code), _) => refuse(
            reader,
            code.span.clone(),
            "wind.code",
            "wind has a code, but means = \"gust\": a code makes the gust from a 10-minute mean",
            "write means = \"10 min\" if speed is the basic wind speed of the code, else take code and terrain out",
        ),
        (MeansRaw::TenMinutes, _, Some(pressure)) => refuse(
            reader,
            pressure.span.clone(),
            "wind.pressure",
            "wind.pressure is the mean of 10 minutes, which says nothing of gusts",
            "give speed with a code, or the pressure of the gust with means = \"gust\"",
        ),
        (MeansRaw::TenMinutes, None, None) => refuse(
            reader,
            means.span.clone(),
            "wind.means",
            "wind.means = \"10 min\", but no code makes the gust of it",
            "write code = \"EN 1991-1-4\" or code = \"KDS 41 12 00\" with its terrain, or give the speed of the gust",
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
        (&of.topography, "wind.topography"),
        (&of.importance_factor, "wind.importance_factor"),
    ]
    .map(|(raw, path)| match raw {
        None => Some(1.0),
        Some(_) => reader.within(raw.as_ref(), path, FACTOR.0, FACTOR.1),
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

/// Keys that need a code, or another one.
fn foreign(reader: &mut Reader, of: &WindRaw) {
    let code = of.code.as_ref().map(|code| code.value);
    let is_kds = code == Some(WindCodeRaw::Kds41);
    let keys = [
        (
            "wind.terrain",
            of.terrain.as_ref().map(|at| &at.span),
            code.is_some(),
            "a code",
        ),
        (
            "wind.topography",
            of.topography.as_ref().map(|at| &at.span),
            code.is_some(),
            "a code",
        ),
        (
            "wind.importance_factor",
            of.importance_factor.as_ref().map(|at| &at.span),
            is_kds,
            "code = \"KDS 41 12 00\"",
        ),
        (
            "wind.density",
            of.density.as_ref().map(|at| &at.span),
            of.pressure.is_none(),
            "a speed",
        ),
    ];
    for (path, span, fits, needs) in keys {
        if let (Some(span), false) = (span, fits) {
            let fault = Fault::new(
                span.clone(),
                path,
                format!("{path} has no meaning without {needs}"),
            );
            reader.fault(fault.help("take it out"));
        }
    }
}

enum Ground {
    Eurocode(EurocodeTerrain),
    Kds41(Kds41Exposure),
}

fn terrain(reader: &mut Reader, of: &WindRaw, code: WindCodeRaw, span: &Range<usize>) -> Option<Ground> {
    let allowed = match code {
        WindCodeRaw::Eurocode => {
            "code = \"EN 1991-1-4\" has terrain \"0\" (sea), \"I\", \"II\", \"III\" (suburb, forest) or \"IV\" (town)"
        }
        WindCodeRaw::Kds41 => {
            "code = \"KDS 41 12 00\" has terrain \"A\" (large town), \"B\", \"C\" (open country) or \"D\" (coast)"
        }
    };
    let Some(terrain) = &of.terrain else {
        if !reader.is_reported("wind.terrain") {
            refuse(
                reader,
                span.clone(),
                "wind",
                "wind has a code, but no terrain",
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
                "wind.terrain is one of another code",
                allowed,
            );
            return None;
        }
    };
    Some(ground)
}

fn area(reader: &mut Reader, raw: &At<WindAreaRaw>, path: &str, parts: &Parts<'_>) -> Option<WindArea> {
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
        on_part(reader, height, part?, parts)?;
    }
    Some(WindArea {
        part: part?,
        area: area?,
        height,
        force_coefficient,
    })
}
