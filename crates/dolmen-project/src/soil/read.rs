//! The soil below a chain or a stack.

use super::file::HalfSpaceRaw;
use super::part::{FootingPart, SoilBelowPart, SoilPart};
use crate::error::Fault;
use crate::file_number::{At, QuantityRaw};
use crate::measure::{Bound, Measure};
use crate::quantity::Quantity;
use crate::ratio::below;
use crate::reader::Reader;
use crate::usual::within;
use crate::wrong::WrongChain;

/// Largest Poisson's ratio: that of water-saturated clay.
const POISSON_RATIO_MOST: f64 = 0.5;
/// Least side of a footing over the width of the bed on it: a stone may overhang a little. Our choice.
const FOOTING_OF_BED_LEAST: f64 = 0.8;
/// Largest side of a footing, m: that of a tower or a chimney, with a margin.
const FOOTING_MOST_M: f64 = 40.0;
/// Shear modulus, Pa: from peat to sound rock, with a margin.
const SHEAR_MODULUS_PA: (f64, f64) = (0.3e6, 40e9);

/// The soil under a footing, which the file must give.
pub(crate) fn soil_under_footing(reader: &mut Reader, raw: Option<&At<HalfSpaceRaw>>) -> Option<SoilPart> {
    let keys = &raw?.value;
    let is_given = keys.diameter.is_some() || keys.along.is_some() || keys.across.is_some();
    let soil = soil_below(reader, raw);
    if !is_given {
        without_footing(reader);
    }
    let soil = soil?;
    Some(SoilPart {
        shear_modulus: soil.shear_modulus,
        poisson_ratio: soil.poisson_ratio,
        footing: soil.footing?,
    })
}

fn without_footing(reader: &mut Reader) {
    let fault = Fault::new(reader.place("soil"), "soil", WrongChain::SoilNeedsFooting);
    reader.fault(fault.help(WrongChain::SoilKeys));
}

/// The soil under a stack, and its footing unless that is the bed of the lowest block.
pub(crate) fn soil_below(reader: &mut Reader, raw: Option<&At<HalfSpaceRaw>>) -> Option<SoilBelowPart> {
    let raw = raw?;
    reader.mark("soil", &raw.span);
    let keys = &raw.value;
    let of = |reader: &mut Reader, raw: &Option<At<QuantityRaw>>, key: &str, measure| {
        reader.quantity(raw.as_ref(), &format!("soil.{key}"), measure, Bound::Positive)
    };
    let shear_modulus = of(reader, &keys.shear_modulus, "shear_modulus", Measure::Stress);
    let poisson_ratio = of(reader, &keys.poisson_ratio, "poisson_ratio", Measure::Ratio);
    let poisson_ratio = poisson_ratio.and_then(|ratio| {
        let raw = keys.poisson_ratio.as_ref();
        below(reader, ratio, raw, POISSON_RATIO_MOST, WrongChain::PoissonOfSoil)
    });
    let diameter = of(reader, &keys.diameter, "diameter", Measure::Length);
    let along = of(reader, &keys.along, "along", Measure::Length);
    let across = of(reader, &keys.across, "across", Measure::Length);
    let are_given = [&keys.diameter, &keys.along, &keys.across].map(Option::is_some);
    let footing = match are_given {
        [false, false, false] => None,
        [true, false, false] => Some(FootingPart::Circle(diameter?)),
        [false, true, true] => Some(FootingPart::Rectangle([along?, across?])),
        _ => {
            without_footing(reader);
            return None;
        }
    };
    Some(SoilBelowPart {
        shear_modulus: shear_modulus?,
        poisson_ratio: poisson_ratio?,
        footing,
    })
}

/// A footing supports the bed above it, and is at most as large as that of a pole.
fn judge_side(reader: &mut Reader, side: &Quantity, bed: Option<&Quantity>) {
    let (path, written) = (side.path.clone(), side.written.clone());
    match bed {
        Some(bed) if side.value < FOOTING_OF_BED_LEAST * bed.value => {
            let (bed_path, bed) = (bed.path.clone(), bed.written.clone());
            let message = WrongChain::FootingBelowBed {
                path,
                written,
                bed_path,
                bed,
            };
            reader.slip(&side.path, message, WrongChain::FootingBelowStones);
        }
        _ if side.value > FOOTING_MOST_M => {
            let message = WrongChain::FootingOfNoPole { path, written };
            reader.slip(&side.path, message, WrongChain::FootingInUnits);
        }
        _ => {}
    }
}

/// Probable slips of its numbers.
pub(crate) fn judge_soil(
    reader: &mut Reader,
    modulus: &Quantity,
    footing: Option<&FootingPart>,
    bed: Option<&Quantity>,
) {
    for side in footing.into_iter().flat_map(FootingPart::sides) {
        judge_side(reader, side, bed);
    }
    if !within(modulus.value, SHEAR_MODULUS_PA) {
        let message = WrongChain::ModulusOfNoSoil {
            path: modulus.path.clone(),
            written: modulus.written.clone(),
        };
        reader.slip(&modulus.path, message, WrongChain::SoilModulusInPa);
    }
}
