//! Dry friction of frames from what is written.

use super::file::{FrictionActsOnRaw, FrictionLawRaw, FrictionRaw};
use super::part::{FrictionPart, SlipForces};
use crate::error::Fault;
use crate::file_number::{At, QuantityRaw};
use crate::measure::{Bound, Measure};
use crate::needed::one_each;
use crate::quantity::Quantity;
use crate::ratio::below;
use crate::reader::Reader;
use dolmen::dynamics::FrictionActsOn;

/// Largest coefficient of friction: timber and stone, dry, reach 0.8. Chosen here.
const COEFFICIENT_MOST: f64 = 2.0;

/// `stiffness` is that of the storeys while everything sticks, if known.
pub(super) fn friction(
    reader: &mut Reader,
    raw: &At<FrictionRaw>,
    path: &str,
    (storeys, stiffness): (usize, Option<&[Quantity]>),
) -> Option<FrictionPart> {
    reader.mark(path, &raw.span);
    let given = &raw.value;
    let slip = slip(reader, raw, path, storeys)?;
    let law = given
        .law
        .as_ref()
        .map_or(FrictionLawRaw::Coulomb, |law| law.value);
    let slipping_path = format!("{path}.slipping_stiffness");
    let slipping_stiffness = match (law, &given.slipping_stiffness) {
        (FrictionLawRaw::Coulomb, None) => None,
        (FrictionLawRaw::Jenkins, Some(list)) => Some(each(
            reader,
            list,
            &slipping_path,
            (Measure::StoreyStiffness, Bound::NotNegative),
            storeys,
        )?),
        (FrictionLawRaw::Jenkins, None) => {
            let fault = Fault::new(
                raw.span.clone(),
                &slipping_path,
                format!("{path} has law = \"jenkins\", but no slipping_stiffness"),
            );
            reader.fault(
                fault.help(
                    "give what is left of each storey's stiffness while its joints slip; 0 for nothing",
                ),
            );
            return None;
        }
        (FrictionLawRaw::Coulomb, Some(list)) => {
            let fault = Fault::new(
                list.span.clone(),
                &slipping_path,
                format!(
                    "{slipping_path} is given, but the law is \"coulomb\": its slider stands beside the whole spring"
                ),
            );
            reader.fault(fault.help("write law = \"jenkins\", or take slipping_stiffness out"));
            return None;
        }
    };
    for (i, (slipping, whole)) in slipping_stiffness
        .iter()
        .flatten()
        .zip(stiffness.unwrap_or(&[]))
        .enumerate()
    {
        if slipping.value >= whole.value {
            let path = format!("{slipping_path}[{}]", i + 1);
            let message = format!(
                "{path} = {} is not below {} = {}",
                slipping.written, whole.path, whole.written
            );
            let span = reader.place(&path);
            let fault = Fault::new(span, &path, message);
            reader.fault(fault.help(
                "stiffness is what vibration measures, with all joints stuck; slipping joints leave less",
            ));
            return None;
        }
    }
    Some(FrictionPart {
        slip,
        slipping_stiffness,
        acts_on: match given.acts_on.as_ref().map(|acts_on| acts_on.value) {
            None | Some(FrictionActsOnRaw::Drift) => FrictionActsOn::Drift,
            Some(FrictionActsOnRaw::Displacement) => FrictionActsOn::Displacement,
        },
    })
}

fn slip(reader: &mut Reader, raw: &At<FrictionRaw>, path: &str, storeys: usize) -> Option<SlipForces> {
    let given = &raw.value;
    match (&given.coefficient, &given.force) {
        (Some(coefficient), None) => {
            let help = "it is slip force over axial force; for forces write force = [ … ]";
            let kinetic_path = format!("{path}.coefficient");
            let kinetic = reader.quantity(
                Some(coefficient),
                &kinetic_path,
                Measure::Ratio,
                Bound::NotNegative,
            )?;
            let kinetic = below(reader, kinetic, Some(coefficient), COEFFICIENT_MOST, help)?;
            let fixed_path = format!("{path}.static_coefficient");
            let fixed = match &given.static_coefficient {
                None => None,
                Some(fixed) => {
                    let read =
                        reader.quantity(Some(fixed), &fixed_path, Measure::Ratio, Bound::NotNegative)?;
                    Some(below(reader, read, Some(fixed), COEFFICIENT_MOST, help)?)
                }
            };
            if let Some(fixed) = fixed.as_ref().filter(|fixed| fixed.value < kinetic.value) {
                let span = given
                    .static_coefficient
                    .as_ref()
                    .map_or(0..0, |raw| raw.span.clone());
                let message = format!(
                    "{fixed_path} = {} is below coefficient = {}",
                    fixed.written, kinetic.written
                );
                let fault = Fault::new(span, &fixed_path, message);
                reader.fault(fault.allowed("must be at least the coefficient while slipping"));
                return None;
            }
            Some(SlipForces::Coefficient {
                kinetic: Box::new(kinetic),
                fixed: fixed.map(Box::new),
            })
        }
        (None, Some(list)) => {
            if let Some(fixed) = &given.static_coefficient {
                let fault = Fault::new(
                    fixed.span.clone(),
                    &format!("{path}.static_coefficient"),
                    format!("{path} has both force and static_coefficient"),
                );
                reader.fault(fault.help("give coefficient and static_coefficient, or force alone"));
                return None;
            }
            let forces_path = format!("{path}.force");
            let forces = each(
                reader,
                list,
                &forces_path,
                (Measure::Force, Bound::NotNegative),
                storeys,
            )?;
            Some(SlipForces::Forces(forces))
        }
        (Some(_), Some(force)) => {
            let fault = Fault::new(
                force.span.clone(),
                path,
                format!("{path} has both coefficient and force"),
            );
            reader.fault(fault.help("keep one of them: force = coefficient × axial force"));
            None
        }
        (None, None) => {
            if !reader.is_reported(&format!("{path}.coefficient")) {
                let fault = Fault::new(
                    raw.span.clone(),
                    path,
                    format!("{path} has neither coefficient nor force"),
                );
                reader.fault(fault.help(
                    "write friction = { coefficient = 0.3 }, or force = [ … ] with one for each storey",
                ));
            }
            None
        }
    }
}

/// One quantity for each storey.
fn each(
    reader: &mut Reader,
    list: &At<Vec<At<QuantityRaw>>>,
    path: &str,
    (measure, bound): (Measure, Bound),
    storeys: usize,
) -> Option<Vec<Quantity>> {
    let sound = one_each(reader, &list.value, &list.span, path, ("storeys", storeys));
    let mut read = Vec::with_capacity(storeys);
    for (i, raw) in list.value.iter().enumerate() {
        read.push(reader.quantity(Some(raw), &format!("{path}[{}]", i + 1), measure, bound));
    }
    let read: Option<Vec<Quantity>> = read.into_iter().collect();
    read.filter(|_| sound)
}
