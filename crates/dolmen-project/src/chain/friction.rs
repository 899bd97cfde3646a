//! Dry friction and damping of chains from what is written.

use super::file::JointRaw;
use super::part::{JointFrictionPart, JointPart};
use crate::error::Fault;
use crate::file_number::{At, QuantityRaw};
use crate::measure::{Bound, Measure};
use crate::quantity::Quantity;
use crate::ratio::damping_ratio;
use crate::reader::Reader;

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
