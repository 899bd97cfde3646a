//! Reads the wind on a building in time.

use super::file::{MeansRaw, SpectrumRaw, WindRaw};
use super::part::{WIND_ECCENTRICITY, WindInTime};
use super::parts::Parts;
use crate::error::Fault;
use crate::file_number::{At, NumberRaw};
use crate::measure::{Bound, Measure};
use crate::reader::Reader;
use crate::written::short;
use crate::wrong::{Common, WrongLoads};
use dolmen::structure::wind::TurbulenceSpectrum;
use std::ops::Range;

/// Eccentricity over the breadth: at the edge it is a half.
const ECCENTRICITY: (f64, f64) = (0.0, 0.5);
/// Allowable drift over the height in the wind: tighter than any, and ten times what codes and guides allow, 1/200 to 1/500.
const DRIFT: (f64, f64) = (1e-5, 0.05);

/// The keys of a building; another check rejects them for other kinds.
pub(super) fn in_time(
    reader: &mut Reader,
    of: &WindRaw,
    span: &Range<usize>,
    parts: &Parts,
) -> Option<WindInTime> {
    let before = reader.faults.len();
    if !parts.are_floors {
        foreign(reader, of);
        return (reader.faults.len() == before).then(WindInTime::default);
    }
    let mut refuse = |span: Range<usize>, path: &str, message: WrongLoads, help: WrongLoads| {
        reader.fault(Fault::new(span, path, message).help(help));
    };
    if let Some(pressure) = &of.pressure {
        refuse(
            pressure.span.clone(),
            "wind.pressure",
            WrongLoads::PressureOnBuilding,
            WrongLoads::GiveMeanOfCode,
        );
    }
    if let Some(means) = of.means.as_ref().filter(|means| means.value == MeansRaw::Gust) {
        refuse(
            means.span.clone(),
            "wind.means",
            WrongLoads::GustOnBuilding,
            WrongLoads::GiveMeanOfCode,
        );
    }
    if let Some(areas) = of.areas.as_ref().and_then(|areas| areas.first()) {
        refuse(
            areas.span.clone(),
            "wind.areas",
            WrongLoads::AreasOnBuilding,
            WrongLoads::BreadthOfFloors,
        );
    }
    if let Some(floor) = parts.has_width.iter().position(|known| !known) {
        let floor = (floor + 1).to_string();
        refuse(
            span.clone(),
            "wind",
            WrongLoads::BreadthUnknown(floor.clone()),
            WrongLoads::GiveSidesOf(floor),
        );
    }
    let eccentricity = match &of.eccentricity {
        None => Some(WIND_ECCENTRICITY),
        Some(_) => reader.within(
            of.eccentricity.as_ref(),
            "wind.eccentricity",
            ECCENTRICITY.0,
            ECCENTRICITY.1,
        ),
    };
    let acceleration_limit = reader.quantity(
        of.acceleration_limit.as_ref(),
        "wind.acceleration_limit",
        Measure::GroundAcceleration,
        Bound::Positive,
    );
    let drift_limit = drift_limit(reader, of.drift_limit.as_ref());
    (reader.faults.len() == before).then_some(())?;
    Some(WindInTime {
        spectrum: of.spectrum.as_ref().map(|spectrum| match spectrum.value {
            SpectrumRaw::Kaimal => TurbulenceSpectrum::Kaimal,
            SpectrumRaw::VonKarman => TurbulenceSpectrum::VonKarman,
        }),
        eccentricity: eccentricity?,
        acceleration_limit,
        drift_limit,
    })
}

/// The allowable drift of a storey, over its height.
fn drift_limit(reader: &mut Reader, raw: Option<&At<NumberRaw>>) -> Option<f64> {
    const AT: &str = "wind.drift_limit";
    let ratio = reader.plain(raw, AT, Measure::Tilt, Bound::Positive)?;
    let (least, most) = DRIFT;
    if (least..=most).contains(&ratio) {
        return Some(ratio);
    }
    let span = raw.map_or(0..0, |raw| raw.span.clone());
    let fault = Fault::new(span, AT, WrongLoads::DriftOfHeight(short(ratio)));
    let allowed = WrongLoads::DriftWithin {
        least: short(least),
        most: short(most),
    };
    reader.fault(fault.allowed(allowed).help(WrongLoads::DriftPerCent));
    None
}

/// Keys of a building alone.
fn foreign(reader: &mut Reader, of: &WindRaw) {
    let keys = [
        ("wind.spectrum", of.spectrum.as_ref().map(|at| &at.span)),
        ("wind.eccentricity", of.eccentricity.as_ref().map(|at| &at.span)),
        (
            "wind.acceleration_limit",
            of.acceleration_limit.as_ref().map(|at| &at.span),
        ),
        ("wind.drift_limit", of.drift_limit.as_ref().map(|at| &at.span)),
    ];
    for (path, span) in keys {
        if let Some(span) = span {
            let message = WrongLoads::HasNoMeaningWithout {
                path: path.to_string(),
                needs: "kind = \"building\"".into(),
            };
            reader.fault(Fault::new(span.clone(), path, message).help(Common::TakeItOut));
        }
    }
}
