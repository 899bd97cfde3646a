//! Reads dry friction and damping of chains.

use super::file::JointRaw;
use super::part::{JointFrictionPart, JointPart};
use crate::error::Fault;
use crate::file_number::{At, QuantityRaw};
use crate::measure::{Bound, Measure};
use crate::quantity::Quantity;
use crate::ratio::damping_ratio;
use crate::reader::Reader;
use crate::wrong::WrongChain;

/// Damping of a whole chain instead of that of its joints.
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
        let message = WrongChain::DampingRatioAndBoth(own.path.to_string());
        let fault = Fault::new(reader.place("damping_ratio"), "damping_ratio", message);
        reader.fault(fault.help(WrongChain::KeepOneOfThem));
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
            let message = WrongChain::StandsWithoutFrictionMoment(fixed.path.to_string());
            let fault = Fault::new(reader.place(&fixed.path), &fixed.path, message);
            reader.fault(fault.help(WrongChain::GiveFrictionMomentToo));
            return None;
        }
        _ => return None,
    };
    if let Some(fixed) = fixed.as_ref().filter(|fixed| fixed.value < kinetic.value) {
        let message = WrongChain::IsBelow {
            path: fixed.path.to_string(),
            written: fixed.written.to_string(),
            other: kinetic.path.to_string(),
            other_written: kinetic.written.to_string(),
        };
        let fault = Fault::new(reader.place(&fixed.path), &fixed.path, message);
        reader.fault(fault.help(WrongChain::JointThatStandsHolds));
        return None;
    }
    Some(JointFrictionPart { kinetic, fixed })
}
