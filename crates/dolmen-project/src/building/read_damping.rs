//! Reads the damping of a building.

use super::file::DampingRaw;
use super::part::DampingPart;
use crate::error::Fault;
use crate::file_number::{At, QuantityRaw};
use crate::measure::{Bound, Measure};
use crate::quantity::Quantity;
use crate::ratio::damping_ratio;
use crate::reader::Reader;
use crate::wrong::{Common, WrongDamper};

pub(super) fn damping(reader: &mut Reader, raw: Option<&At<DampingRaw>>) -> Option<DampingPart> {
    let raw = raw?;
    reader.mark("damping", &raw.span);
    let given = &raw.value;
    let count = [
        given.ratio.is_some(),
        given.ratios.is_some(),
        given.rayleigh.is_some(),
        given.caughey.is_some(),
    ];
    if count.iter().filter(|given| **given).count() != 1 {
        let message = WrongDamper::DampingNeedsOneOf;
        let fault = Fault::new(raw.span.clone(), "damping", message);
        reader.fault(fault.help(WrongDamper::WriteDampingRatioFor));
        return None;
    }
    if let Some(ratio) = &given.ratio {
        return Some(DampingPart::Modal(vec![damping_ratio(
            reader,
            Some(ratio),
            "damping.ratio",
        )?]));
    }
    if let Some(list) = &given.ratios {
        return Some(DampingPart::Modal(ratios(reader, list, "damping.ratios")?));
    }
    if let Some(list) = &given.caughey {
        return Some(DampingPart::Caughey(ratios(reader, list, "damping.caughey")?));
    }
    let anchors = given.rayleigh.as_ref()?;
    let mut all = Vec::with_capacity(2);
    for (i, anchor) in anchors.value.iter().enumerate() {
        let path = format!("damping.rayleigh[{}]", i + 1);
        let frequency_path = format!("{path}.frequency");
        let frequency = anchor.value.frequency.as_ref();
        let frequency = reader.quantity(frequency, &frequency_path, Measure::Frequency, Bound::Positive);
        let ratio = damping_ratio(reader, anchor.value.ratio.as_ref(), &format!("{path}.ratio"));
        all.push([frequency?, ratio?]);
    }
    let found = all.len();
    match <[[Quantity; 2]; 2]>::try_from(all) {
        Ok(anchors) => Some(DampingPart::Rayleigh(Box::new(anchors))),
        Err(_) => {
            let message = WrongDamper::DampingRayleighHasFrequencies {
                found: found.to_string(),
            };
            let fault = Fault::new(anchors.span.clone(), "damping.rayleigh", message);
            reader.fault(fault.allowed(WrongDamper::MustBeMassAnd));
            None
        }
    }
}

fn ratios(reader: &mut Reader, list: &At<Vec<At<QuantityRaw>>>, path: &str) -> Option<Vec<Quantity>> {
    if list.value.is_empty() {
        let fault = Fault::new(list.span.clone(), path, Common::IsEmpty(path.to_string()));
        reader.fault(fault.allowed(WrongDamper::NeedsDampingRatio));
        return None;
    }
    let each = list.value.iter().enumerate();
    each.map(|(i, raw)| damping_ratio(reader, Some(raw), &format!("{path}[{}]", i + 1)))
        .collect()
}
