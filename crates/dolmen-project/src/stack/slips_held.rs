//! Probable slips in dowels, clamps, side supports and movements of supports.

use super::part::StackPart;
use crate::reader::Reader;
use crate::usual::{guess, unit_of, within};
use crate::wrong::StackSlip;

/// Stiffness of a dowel or clamp, N/m: from a wooden peg in loose holes to a bar of iron through a whole stone, with a margin. Our choice.
const TIE_STIFFNESS_N_M: (f64, f64) = (1e5, 1e11);
/// Its strength, N: from a thin nail to a bar of iron 0.4 m thick. Our choice.
const TIE_STRENGTH_N: (f64, f64) = (100.0, 5e7);
/// Stiffness of a side support, N/m: from a prop of timber to a rock face. Our choice.
const BESIDE_STIFFNESS_N_M: (f64, f64) = (1e4, 1e11);
/// Largest gap to it, m. Our choice.
const GAP_MOST_M: f64 = 2.0;
/// Largest movement of a support, m: the collapse of a large bridge arch takes less. Our choice.
const MOVEMENT_MOST_M: f64 = 2.0;

pub(super) fn judge_held(reader: &mut Reader, stack: &StackPart) {
    for tie in &stack.ties {
        for of in tie.axial_stiffness.iter().chain([&tie.shear_stiffness]) {
            if !within(of.value, TIE_STIFFNESS_N_M) {
                let (path, written) = (of.path.clone(), of.written.clone());
                reader.slip(
                    &of.path,
                    StackSlip::TieStiffness { path, written },
                    StackSlip::ForceUnits,
                );
            }
        }
        for of in tie.tension_strength.iter().chain([&tie.shear_strength]) {
            if !within(of.value, TIE_STRENGTH_N) {
                let (path, written) = (of.path.clone(), of.written.clone());
                reader.slip(
                    &of.path,
                    StackSlip::TieStrength { path, written },
                    StackSlip::ForceUnits,
                );
            }
        }
    }
    for beside in &stack.side_supports {
        let of = &beside.stiffness;
        if !within(of.value, BESIDE_STIFFNESS_N_M) {
            let (path, written) = (of.path.clone(), of.written.clone());
            reader.slip(
                &of.path,
                StackSlip::BesideStiffness { path, written },
                StackSlip::ForceUnits,
            );
        }
        if let Some(gap) = beside.gap.as_ref().filter(|gap| gap.value > GAP_MOST_M) {
            let (path, written) = (gap.path.clone(), gap.written.clone());
            let help = guess(1000.0, unit_of(gap));
            reader.slip(&gap.path, StackSlip::BesideGap { path, written }, help);
        }
    }
    let movements = stack
        .support_movement
        .iter()
        .flat_map(|of| of.movement.iter().flatten());
    for by in movements.filter(|by| by.value.abs() > MOVEMENT_MOST_M) {
        let (path, written) = (by.path.clone(), by.written.clone());
        let help = guess(1000.0, unit_of(by));
        reader.slip(&by.path, StackSlip::Movement { path, written }, help);
    }
}
