//! Damping and tuned masses of a building, from what is written.

use super::building::DampingPart;
use super::building_damper::{DamperFrequency, DamperMass, DamperPart, Tuning};
use super::error::Fault;
use super::file_building::{DamperKindRaw, DamperRaw, DampingRaw, TuningRaw};
use super::file_number::{At, QuantityRaw};
use super::measure::{Bound, Measure};
use super::quantity::Quantity;
use super::read_building::floor_number;
use super::read_friction::damping_ratio;
use super::read_stack::lengths;
use super::reader::Reader;
use super::units::parse_angle_rad;
use dolmen::structure::building::PlanDirection;
use std::collections::BTreeMap;

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
        let message = "damping needs one of ratio, ratios, rayleigh and caughey";
        let fault = Fault::new(raw.span.clone(), "damping", message);
        reader.fault(fault.help("write damping = { ratio = 0.05 } for 5 % in every mode"));
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
            let message = format!("damping.rayleigh has {found} frequencies");
            let fault = Fault::new(anchors.span.clone(), "damping.rayleigh", message);
            reader.fault(fault.allowed("must be 2: mass and stiffness are two numbers"));
            None
        }
    }
}

fn ratios(reader: &mut Reader, list: &At<Vec<At<QuantityRaw>>>, path: &str) -> Option<Vec<Quantity>> {
    if list.value.is_empty() {
        let fault = Fault::new(list.span.clone(), path, format!("{path} is empty"));
        reader.fault(fault.allowed("needs a damping ratio"));
        return None;
    }
    let each = list.value.iter().enumerate();
    each.map(|(i, raw)| damping_ratio(reader, Some(raw), &format!("{path}[{}]", i + 1)))
        .collect()
}

/// The dampers in the order of the file.
pub(super) fn dampers(
    reader: &mut Reader,
    raw: Option<&BTreeMap<String, At<DamperRaw>>>,
    floors: usize,
) -> Vec<DamperPart> {
    let mut listed: Vec<_> = raw.into_iter().flatten().collect();
    listed.sort_by_key(|(_, raw)| raw.span.start);
    let each = listed
        .into_iter()
        .filter_map(|(name, raw)| damper(reader, name, raw, floors));
    each.collect()
}

fn damper(reader: &mut Reader, name: &str, raw: &At<DamperRaw>, floors: usize) -> Option<DamperPart> {
    let path = format!("damper.{name}");
    reader.mark(&path, &raw.span);
    let before = reader.faults.len();
    let given = &raw.value;
    let DamperKindRaw::Tmd = given.kind.as_ref()?.value;
    let floor = floor_number(reader, given.floor.as_ref(), &format!("{path}.floor"), floors);
    let place = given
        .place
        .as_ref()
        .and_then(|raw| lengths(reader, raw, &format!("{path}.place"), "[x, y]"));
    let direction = direction(reader, given.direction.as_ref(), &format!("{path}.direction"));
    let mode = match &given.mode {
        None => Some(1),
        Some(mode) => reader.count(Some(mode), &format!("{path}.mode"), 1, 3 * floors),
    };
    let mut of = |raw: &Option<At<QuantityRaw>>, key: &str, measure| {
        reader.quantity(raw.as_ref(), &format!("{path}.{key}"), measure, Bound::Positive)
    };
    let mass = of(&given.mass, "mass", Measure::Mass);
    let mass_ratio = of(&given.mass_ratio, "mass_ratio", Measure::Ratio);
    let frequency = of(&given.frequency, "frequency", Measure::Frequency);
    let frequency_ratio = of(&given.frequency_ratio, "frequency_ratio", Measure::Ratio);
    let damping_path = format!("{path}.damping_ratio");
    let ratio = reader.quantity(
        given.damping_ratio.as_ref(),
        &damping_path,
        Measure::Ratio,
        Bound::NotNegative,
    );
    let tuning = given.tuning.as_ref().map(|tuning| match tuning.value {
        TuningRaw::DenHartog => Tuning::DenHartog,
        TuningRaw::WarburtonForce => Tuning::WarburtonForce,
        TuningRaw::WarburtonBase => Tuning::WarburtonBase,
    });
    (reader.faults.len() == before).then_some(())?;
    let mut refuse = |message: String, help: &str| -> Option<DamperPart> {
        reader.fault(Fault::new(raw.span.clone(), &path, message).help(help));
        None
    };
    let mass = match (mass, mass_ratio) {
        (Some(mass), None) => DamperMass::Mass(mass),
        (None, Some(ratio)) if ratio.value > 1.0 => {
            let message = format!(
                "{} = {}, but a damper is lighter than what it damps",
                ratio.path, ratio.written
            );
            return refuse(
                message,
                "a mass ratio is 0.01 to 0.1, as a rule: write 5 % as 0.05 or \"5 %\"",
            );
        }
        (None, Some(ratio)) => DamperMass::Ratio(ratio),
        (Some(_), Some(_)) => {
            return refuse(format!("{path} has both mass and mass_ratio"), "keep one of them");
        }
        (None, None) => {
            return refuse(
                format!("{path} has neither mass nor mass_ratio"),
                "give mass = …, or mass_ratio = … of the modal mass of its mode",
            );
        }
    };
    let frequency = match (frequency, frequency_ratio, tuning) {
        (Some(frequency), None, _) => DamperFrequency::Frequency(frequency),
        (None, Some(ratio), _) => DamperFrequency::Ratio(ratio),
        (None, None, Some(_)) => DamperFrequency::Tuned,
        (Some(_), Some(_), _) => {
            return refuse(
                format!("{path} has both frequency and frequency_ratio"),
                "keep one of them",
            );
        }
        (None, None, None) => {
            return refuse(
                format!("{path} has no frequency"),
                "give frequency = …, frequency_ratio = … of its mode's, or tuning = \"den_hartog\"",
            );
        }
    };
    if ratio.is_none() && tuning.is_none() {
        return refuse(
            format!("{path} has no damping_ratio"),
            "give damping_ratio = … on its own frequency, or tuning = \"den_hartog\"",
        );
    }
    if tuning.is_some() && ratio.is_some() && !matches!(frequency, DamperFrequency::Tuned) {
        return refuse(
            format!("{path} names a tuning, but gives its frequency and damping_ratio"),
            "take tuning out, or what it is to give",
        );
    }
    Some(DamperPart {
        name: name.to_owned(),
        floor: floor?,
        place: Box::new(place?),
        direction: direction?,
        mass,
        mode: mode?,
        frequency,
        damping_ratio: ratio,
        tuning,
    })
}

fn direction(reader: &mut Reader, raw: Option<&At<String>>, path: &str) -> Option<PlanDirection> {
    let raw = raw?;
    match raw.value.trim() {
        "x" => return Some(PlanDirection::X),
        "y" => return Some(PlanDirection::Y),
        _ => {}
    }
    match parse_angle_rad(&raw.value) {
        Ok(angle) => Some(PlanDirection::Degrees(angle.to_degrees())),
        Err(_) => {
            let message = format!("{path} = \"{}\" is no direction", raw.value);
            let fault = Fault::new(raw.span.clone(), path, message);
            reader.fault(
                fault.allowed("must be \"x\", \"y\", or an angle from x, counterclockwise (\"30 deg\")"),
            );
            None
        }
    }
}
