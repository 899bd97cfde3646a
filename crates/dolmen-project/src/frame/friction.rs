//! Reads dry friction of frames.

use super::file::{FrictionActsOnRaw, FrictionLawRaw, FrictionRaw};
use super::part::{FrictionPart, SlipForces};
use crate::error::Fault;
use crate::file_number::{At, QuantityRaw};
use crate::measure::{Bound, Measure};
use crate::needed::one_each;
use crate::quantity::Quantity;
use crate::ratio::below;
use crate::reader::Reader;
use crate::wrong::WrongFrame;
use dolmen::dynamics::FrictionActsOn;

/// Largest coefficient of friction: timber and stone, dry, reach 0.8. Our choice.
const COEFFICIENT_MOST: f64 = 2.0;

/// `stiffness` is that of the storeys while all sliders stick, if known.
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
                WrongFrame::HasLawJenkinsBut(path.to_string()),
            );
            reader.fault(fault.help(WrongFrame::GiveWhatIsLeft));
            return None;
        }
        (FrictionLawRaw::Coulomb, Some(list)) => {
            let fault = Fault::new(
                list.span.clone(),
                &slipping_path,
                WrongFrame::IsGivenButLaw(slipping_path.to_string()),
            );
            reader.fault(fault.help(WrongFrame::WriteLawJenkinsOr));
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
            let message = WrongFrame::IsNotBelow {
                path: path.to_string(),
                written: slipping.written.to_string(),
                other: whole.path.to_string(),
                other_written: whole.written.to_string(),
            };
            let span = reader.place(&path);
            let fault = Fault::new(span, &path, message);
            reader.fault(fault.help(WrongFrame::StiffnessIsWhatVibration));
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
            let kinetic_path = format!("{path}.coefficient");
            let kinetic = reader.quantity(
                Some(coefficient),
                &kinetic_path,
                Measure::Ratio,
                Bound::NotNegative,
            )?;
            let kinetic = below(
                reader,
                kinetic,
                Some(coefficient),
                COEFFICIENT_MOST,
                WrongFrame::ItIsSlipForce,
            )?;
            let fixed_path = format!("{path}.static_coefficient");
            let fixed = match &given.static_coefficient {
                None => None,
                Some(fixed) => {
                    let read =
                        reader.quantity(Some(fixed), &fixed_path, Measure::Ratio, Bound::NotNegative)?;
                    Some(below(
                        reader,
                        read,
                        Some(fixed),
                        COEFFICIENT_MOST,
                        WrongFrame::ItIsSlipForce,
                    )?)
                }
            };
            if let Some(fixed) = fixed.as_ref().filter(|fixed| fixed.value < kinetic.value) {
                let span = given
                    .static_coefficient
                    .as_ref()
                    .map_or(0..0, |raw| raw.span.clone());
                let message = WrongFrame::IsBelowCoefficient {
                    fixed_path: fixed_path.to_string(),
                    written: fixed.written.to_string(),
                    other_written: kinetic.written.to_string(),
                };
                let fault = Fault::new(span, &fixed_path, message);
                reader.fault(fault.allowed(WrongFrame::MustBeAtLeast));
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
                    WrongFrame::HasBothForceAnd(path.to_string()),
                );
                reader.fault(fault.help(WrongFrame::GiveCoefficientAndStatic));
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
                WrongFrame::HasBothCoefficientAnd(path.to_string()),
            );
            reader.fault(fault.help(WrongFrame::KeepOneOfThem));
            None
        }
        (None, None) => {
            if !reader.is_reported(&format!("{path}.coefficient")) {
                let fault = Fault::new(
                    raw.span.clone(),
                    path,
                    WrongFrame::HasNeitherCoefficientNor(path.to_string()),
                );
                reader.fault(fault.help(WrongFrame::WriteFrictionCoefficientOr));
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
