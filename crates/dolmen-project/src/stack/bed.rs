//! Reads the properties of a joint of a stack.

use super::file::BedRaw;
use super::part::BedPart;
use crate::content::WarningKind;
use crate::error::Fault;
use crate::file_number::{At, QuantityRaw};
use crate::measure::{Bound, Measure};
use crate::reader::Reader;
use crate::warned::Warned;
use crate::wrong::WrongStack;

pub(super) fn bed(reader: &mut Reader, raw: Option<&At<BedRaw>>, path: &str) -> Option<BedPart> {
    let Some(raw) = raw else {
        return Some(BedPart::default());
    };
    reader.mark(path, &raw.span);
    let before = reader.faults.len();
    if let (Some(_), Some(also)) = (&raw.value.normal_restitution, &raw.value.restitution) {
        let message = WrongStack::RestitutionTwice {
            path: path.to_owned(),
        };
        let fault = Fault::new(also.span.clone(), &format!("{path}.restitution"), message);
        reader.fault(fault.help(WrongStack::KeepNormalRestitution));
        return None;
    }
    if let Some(earlier) = &raw.value.restitution {
        let key = format!("{path}.restitution");
        reader.mark(&key, &earlier.span);
        reader.warn(
            WarningKind::EarlierName,
            &key,
            Warned::RestitutionOfFalls { path: key.clone() },
        );
    }
    let mut of = |raw: &Option<At<QuantityRaw>>, key: &str, measure, bound| {
        reader.quantity(raw.as_ref(), &format!("{path}.{key}"), measure, bound)
    };
    let (zero, above) = (Bound::NotNegative, Bound::Positive);
    let bed = &raw.value;
    let read = BedPart {
        friction: of(&bed.friction, "friction", Measure::Ratio, zero),
        friction_kinetic: of(&bed.friction_kinetic, "friction_kinetic", Measure::Ratio, zero),
        cohesion: of(&bed.cohesion, "cohesion", Measure::Stress, zero),
        tension: of(&bed.tension, "tension", Measure::Stress, zero),
        strength: of(&bed.strength, "strength", Measure::Stress, above),
        normal_stiffness: of(
            &bed.normal_stiffness,
            "normal_stiffness",
            Measure::BedStiffness,
            above,
        ),
        shear_stiffness: of(
            &bed.shear_stiffness,
            "shear_stiffness",
            Measure::BedStiffness,
            above,
        ),
        damping_ratio: of(&bed.damping_ratio, "damping_ratio", Measure::Ratio, zero),
        normal_restitution: match &bed.restitution {
            Some(_) => of(&bed.restitution, "restitution", Measure::Ratio, zero),
            None => of(
                &bed.normal_restitution,
                "normal_restitution",
                Measure::Ratio,
                zero,
            ),
        },
        rocking_restitution: of(
            &bed.rocking_restitution,
            "rocking_restitution",
            Measure::Ratio,
            above,
        ),
    };
    (reader.faults.len() == before).then_some(read)
}
