//! Reads a pagoda from its six factors.

use super::file::PagodaRaw;
use super::part::{PagodaPart, PagodaSlendernessPart};
use crate::error::Fault;
use crate::file_number::At;
use crate::measure::{Bound, Measure};
use crate::quantity::Quantity;
use crate::reader::Reader;
use crate::wrong::WrongStack;
use crate::wrong::said;
use dolmen::structure::stack::StackError;

/// Most storeys: as in the library.
const STOREYS_MOST: usize = 13;
/// A density to try the factors with, kg/m³: names and sizes do not depend on it.
const ANY_DENSITY_KG_M3: f64 = 2600.0;

/// The factors with the names of the stones; impossible factors are rejected here.
pub(super) fn pagoda(reader: &mut Reader, raw: &At<PagodaRaw>) -> Option<(PagodaPart, Vec<String>)> {
    reader.mark("pagoda", &raw.span);
    let before = reader.faults.len();
    let given = &raw.value;
    let storeys = reader.count(given.storeys.as_ref(), "pagoda.storeys", 1, STOREYS_MOST);
    let mut of =
        |raw, key: &str, measure, bound| reader.quantity(raw, &format!("pagoda.{key}"), measure, bound);
    let above = Bound::Positive;
    let body_height = of(given.body_height.as_ref(), "body_height", Measure::Length, above);
    let body = of(
        given.body_slenderness.as_ref(),
        "body_slenderness",
        Measure::Ratio,
        above,
    );
    let angle = of(
        given.slenderness_angle.as_ref(),
        "slenderness_angle",
        Measure::Tilt,
        above,
    );
    let taper = of(given.taper.as_ref(), "taper", Measure::Angle, Bound::NotNegative);
    let ratio = given.body_base_height_ratio.as_ref();
    let body_base_height_ratio = of(ratio, "body_base_height_ratio", Measure::Ratio, above);
    let slenderness = match (body, angle) {
        (Some(_), Some(angle)) => {
            let message = WrongStack::PagodaHasBothBody;
            let fault = Fault::new(reader.place(&angle.path), &angle.path, message);
            reader.fault(fault.help(WrongStack::KeepOneOfThem));
            None
        }
        (Some(body), None) => Some(PagodaSlendernessPart::Body(body)),
        (None, Some(angle)) => Some(PagodaSlendernessPart::Angle(angle)),
        (None, None) => None,
    };
    (reader.faults.len() == before).then_some(())?;
    let part = PagodaPart {
        storeys: storeys.and_then(|storeys| u32::try_from(storeys).ok())?,
        body_height: body_height?,
        slenderness,
        taper,
        body_base_height_ratio,
    };
    match part.made(ANY_DENSITY_KG_M3, &mut Quantity::nominal) {
        Ok(made) => {
            let names = made.blocks.into_iter().map(|block| block.name).collect();
            Some((part, names))
        }
        Err(why) => {
            let key = match &why {
                StackError::Pagoda { quantity, .. } | StackError::Dimension { quantity, .. } => {
                    quantity.trim_end_matches("_m").trim_end_matches("_rad")
                }
                _ => "storeys",
            };
            let path = format!("pagoda.{key}");
            let place = match reader.place(&path) {
                none if none.is_empty() => raw.span.clone(), // a default that does not go with the others
                place => place,
            };
            reader.fault(Fault::new(place, &path, WrongStack::Pagoda { why: said(&why) }));
            None
        }
    }
}
