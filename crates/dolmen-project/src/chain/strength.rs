//! Strength of the beds of a chain: it needs their width, and must bear the weight above.

use super::part::ChainPart;
use crate::error::Fault;
use crate::measure::Measure;
use crate::quantity::Quantity;
use crate::reader::Reader;
use crate::usual::mass_kg;
use crate::wrong::WrongChain;

/// Rejects a strength without a bed, and a bed that crushes under the weight above it alone.
pub(super) fn beds_bear(reader: &mut Reader, part: &ChainPart) {
    let mut normal_n = 0.0;
    for (i, link) in part.links.iter().enumerate().rev() {
        normal_n += mass_kg(&link.heaviness, part.gravity_m_s2) * part.gravity_m_s2;
        let joint = part.joints.as_ref().and_then(|joints| joints.get(i));
        let Some(joint) = joint else { continue };
        let given = joint.strength.as_ref().or(joint.bed_depth.as_ref());
        let (Some(given), Some(bed)) = (given, part.bed(i, &mut Quantity::nominal)) else {
            if let Some(given) = given {
                let message = WrongChain::IsGivenButWidth(given.path.to_string());
                let fault = Fault::new(reader.place(&given.path), &given.path, message);
                reader.fault(fault.help(WrongChain::GiveBedWidthThereToo));
            }
            continue;
        };
        let pressure_pa = normal_n / (bed.width_m * bed.depth_or_width_m());
        if bed
            .strength_pa
            .is_some_and(|strength_pa| pressure_pa >= strength_pa)
        {
            let pressure = reader.echo(pressure_pa, Measure::Stress);
            let message = WrongChain::IsNotAboveWeight {
                path: given.path.to_string(),
                written: given.written.to_string(),
                pressure: pressure.to_string(),
            };
            let fault = Fault::new(reader.place(&given.path), &given.path, message);
            reader.fault(
                fault
                    .allowed(WrongChain::BedCrushesUnderWeight)
                    .help(WrongChain::IsItInPa),
            );
        }
    }
}
