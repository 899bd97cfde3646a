//! The stone of a chain, for the pole without joints.

use super::file::StoneRaw;
use super::part::{ChainPart, StonePart};
use crate::error::Fault;
use crate::file_number::{At, QuantityRaw};
use crate::measure::{Bound, Measure};
use crate::ratio::below;
use crate::reader::Reader;
use crate::usual::{rounded, within};
use crate::wrong::WrongChain;
use dolmen::structure::SHAFTS_MOST;

/// Largest Poisson's ratio of a solid with resistance to volume change.
const POISSON_RATIO_MOST: f64 = 0.5;
/// Height of the centre of mass of a uniformly tapering shaft over its length: for a cone upright and upside down.
const CENTROID_SHARE: (f64, f64) = (0.25, 0.75);
/// Young's modulus, Pa: from weathered tuff to steel, each with a margin.
const MODULUS_PA: (f64, f64) = (0.5e9, 250e9);
/// Density, kg/m³: from timber to iron, with a margin.
const DENSITY_KG_M3: (f64, f64) = (300.0, 9000.0);

pub(super) fn stone(reader: &mut Reader, raw: Option<&At<StoneRaw>>) -> Option<StonePart> {
    let raw = raw?;
    reader.mark("stone", &raw.span);
    let keys = &raw.value;
    let of = |reader: &mut Reader, raw: &Option<At<QuantityRaw>>, key: &str, measure, bound| {
        let path = format!("stone.{key}");
        let found = reader.quantity(raw.as_ref(), &path, measure, bound);
        if raw.is_none() {
            let message = WrongChain::StoneNeeds(path.clone());
            let fault = Fault::new(reader.place("stone"), &path, message);
            reader.fault(fault.help(WrongChain::StoneKeys));
        }
        found
    };
    let elastic_modulus = of(
        reader,
        &keys.elastic_modulus,
        "elastic_modulus",
        Measure::Stress,
        Bound::Positive,
    );
    let poisson_ratio = of(
        reader,
        &keys.poisson_ratio,
        "poisson_ratio",
        Measure::Ratio,
        Bound::NotNegative,
    );
    let density = of(
        reader,
        &keys.density,
        "density",
        Measure::Density,
        Bound::Positive,
    );
    let poisson_ratio = poisson_ratio.and_then(|ratio| {
        let raw = keys.poisson_ratio.as_ref();
        below(reader, ratio, raw, POISSON_RATIO_MOST, WrongChain::PoissonOfStone)
    });
    Some(StonePart {
        elastic_modulus: elastic_modulus?,
        poisson_ratio: poisson_ratio?,
        density: density?,
    })
}

/// Rejects a stone for links that are not shafts.
pub(super) fn shafts_are_shafts(reader: &mut Reader, part: &ChainPart) {
    if part.stone.is_none() {
        return;
    }
    if part.links.len() > SHAFTS_MOST {
        let message = WrongChain::StoneOfTooMany(part.links.len());
        let fault = Fault::new(reader.place("stone"), "stone", message);
        reader.fault(
            fault
                .allowed(WrongChain::StoneOfAtMost(SHAFTS_MOST))
                .help(WrongChain::LeaveStoneOut),
        );
    }
    for link in &part.links {
        let share = link.centroid.value / link.length.value;
        if (CENTROID_SHARE.0..CENTROID_SHARE.1).contains(&share) {
            continue;
        }
        let path = &link.centroid.path;
        let message = WrongChain::StoneHasNoSuchShaft {
            path: path.clone(),
            written: link.centroid.written.clone(),
            share: rounded(share),
        };
        let fault = Fault::new(reader.place(path), path, message);
        reader.fault(
            fault
                .allowed(WrongChain::CentroidOfShaft)
                .help(WrongChain::LeaveStoneOut),
        );
    }
}

/// Probable slips of its numbers.
pub(super) fn judge_stone(reader: &mut Reader, stone: &StonePart) {
    let modulus = &stone.elastic_modulus;
    if !within(modulus.value, MODULUS_PA) {
        let message = WrongChain::ModulusOfNoStone {
            path: modulus.path.clone(),
            written: modulus.written.clone(),
        };
        reader.slip(&modulus.path, message, WrongChain::ModulusInPa);
    }
    let density = &stone.density;
    if !within(density.value, DENSITY_KG_M3) {
        let message = WrongChain::DensityOfNoStone {
            path: density.path.clone(),
            written: density.written.clone(),
        };
        reader.slip(&density.path, message, WrongChain::DensityInKg);
    }
}
