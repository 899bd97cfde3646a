//! Dry friction and damping of frames and chains from what is written.

use super::chain::{JointFrictionPart, JointPart};
use super::error::Fault;
use super::file::{FrictionActsOnRaw, FrictionLawRaw, FrictionRaw, JointRaw};
use super::file_number::{At, QuantityRaw};
use super::frame::{FrictionPart, SlipForces};
use super::measure::{Bound, Measure};
use super::quantity::Quantity;
use super::read_structure::one_each;
use super::reader::Reader;
use dolmen::dynamics::FrictionActsOn;

/// Largest coefficient of friction: timber and stone, dry, reach 0.8. Chosen here.
const COEFFICIENT_MOST: f64 = 2.0;
/// Largest damping ratio of a mode. Chosen here: above it a percentage was meant.
const DAMPING_RATIO_MOST: f64 = 0.5;

pub(super) fn damping_ratio(
    reader: &mut Reader,
    raw: Option<&At<QuantityRaw>>,
    path: &str,
) -> Option<Quantity> {
    let ratio = reader.quantity(raw, path, Measure::Ratio, Bound::NotNegative)?;
    below(
        reader,
        ratio,
        raw,
        DAMPING_RATIO_MOST,
        "write 2 % as 0.02 or \"2 %\"",
    )
}

/// Damping of a whole chain, beside that of its joints: one of the two.
pub(super) fn chain_damping(
    reader: &mut Reader,
    raw: Option<&At<QuantityRaw>>,
    joints: Option<&[JointPart]>,
) -> Option<Quantity> {
    let ratio = damping_ratio(reader, raw, "damping_ratio")?;
    if let Some(own) = joints
        .into_iter()
        .flatten()
        .find_map(|joint| joint.damping.as_ref())
    {
        let message = format!("damping_ratio and {} both damp the joints", own.path);
        let fault = Fault::new(reader.place("damping_ratio"), "damping_ratio", message);
        reader.fault(fault.help("keep one of them: damping_ratio makes a dashpot of every joint"));
        return None;
    }
    Some(ratio)
}

/// Dry friction of a joint of a chain.
pub(super) fn joint_friction(reader: &mut Reader, raw: &JointRaw, path: &str) -> Option<JointFrictionPart> {
    let kinetic = reader.quantity(
        raw.friction_moment.as_ref(),
        &format!("{path}.friction_moment"),
        Measure::Moment,
        Bound::NotNegative,
    );
    let fixed = reader.quantity(
        raw.static_friction_moment.as_ref(),
        &format!("{path}.static_friction_moment"),
        Measure::Moment,
        Bound::NotNegative,
    );
    let (kinetic, fixed) = match (kinetic, fixed) {
        (Some(kinetic), fixed) => (kinetic, fixed),
        (None, Some(fixed)) if raw.friction_moment.is_none() => {
            let message = format!("{} stands without friction_moment", fixed.path);
            let fault = Fault::new(reader.place(&fixed.path), &fixed.path, message);
            reader.fault(fault.help("give friction_moment too: the moment while the joint turns"));
            return None;
        }
        _ => return None,
    };
    if let Some(fixed) = fixed.as_ref().filter(|fixed| fixed.value < kinetic.value) {
        let message = format!(
            "{} = {} is below {} = {}",
            fixed.path, fixed.written, kinetic.path, kinetic.written
        );
        let fault = Fault::new(reader.place(&fixed.path), &fixed.path, message);
        reader.fault(fault.help("a joint that stands holds at least what one that turns does"));
        return None;
    }
    Some(JointFrictionPart { kinetic, fixed })
}

/// A ratio that must not be above a bound.
fn below(
    reader: &mut Reader,
    ratio: Quantity,
    raw: Option<&At<QuantityRaw>>,
    most: f64,
    help: &str,
) -> Option<Quantity> {
    if ratio.value <= most {
        return Some(ratio);
    }
    let span = raw.map_or(0..0, |raw| raw.span.clone());
    let message = format!("{} = {}", ratio.path, ratio.written);
    let fault = Fault::new(span, &ratio.path, message);
    reader.fault(fault.allowed(format!("must be 0 to {most}")).help(help));
    None
}

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
