//! Park & Min (2010): the gate Heunginjimun.

use super::{Case, ValidationError};
use crate::known::park_min_2010 as paper;
use crate::structure::{
    Convention, Frame, Storey, stiffness_from_frequencies, stiffness_range, storey_axial_forces_n,
};

const SOURCE: &str = "Park & Min (2010)";
const KILO: f64 = 1e3;
const N_M_A_KN_MM: f64 = 1e6;
/// Index of the pair of stiffnesses in the source: the one with the larger k1.
const PRINTED_ROOT: usize = 1;

const ROUNDED: &str = "The source prints frequencies to 0.1 Hz and says stiffness to three digits: it needs 1.0889 and \
                       4.1802 Hz. The tolerance is what ±0.05 Hz makes of the stiffness. It gives one pair; eq. 8 has \
                       another with the same frequencies, 15.79 and 219.07 kN/mm. Corrected: eq. 7 without counting \
                       P2 twice, its printed P1 being the sum of both levels already.";
const FORWARD: &str = "From the stiffness printed; the source measured this frequency to 0.1 Hz.";

/// The gate Heunginjimun of Park & Min (2010), with the axial forces as the source intends: P1 already includes P2.
///
/// # Errors
/// No error occurs, because the numbers are fixed.
pub fn heunginjimun_gate(convention: Convention) -> Result<Frame, ValidationError> {
    gate(convention, paper::AXIAL_KN.map(|p| p * KILO).to_vec())
}

/// The gate with P2 counted twice in the lower storey, as in the printed eq. 7.
///
/// # Errors
/// No error occurs, because the numbers are fixed.
pub fn heunginjimun_gate_as_printed(convention: Convention) -> Result<Frame, ValidationError> {
    gate(
        convention,
        storey_axial_forces_n(&paper::AXIAL_KN.map(|p| p * KILO)),
    )
}

fn gate(convention: Convention, axial_n: Vec<f64>) -> Result<Frame, ValidationError> {
    let storeys = axial_n.into_iter().enumerate().map(|(i, axial_n)| Storey {
        mass_kg: paper::MASS_T[i] * KILO,
        height_m: paper::HEIGHT_M[i],
        axial_n,
    });
    Ok(Frame::new(storeys.collect(), convention)?)
}

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let printed = heunginjimun_gate_as_printed(Convention::Grounded)?;
    let root = &stiffness_from_frequencies(&printed, &paper::WEAK_HZ)?.stiffness[PRINTED_ROOT];
    let range = stiffness_range(&printed, &paper::WEAK_HZ, &[paper::ROUNDING_HZ; 2], root)?;
    let right = heunginjimun_gate(Convention::Grounded)?;
    let corrected = &stiffness_from_frequencies(&right, &paper::WEAK_HZ)?.stiffness[PRINTED_ROOT];
    let mut cases = Vec::new();
    for i in 0..2 {
        cases.push(Case {
            source: SOURCE,
            what: format!("section 3.2: k{} from 1.1 and 4.2 Hz by eq. 8", i + 1),
            unit: "kN/mm",
            published: paper::STIFFNESS_KN_MM[i],
            computed: root[i] / N_M_A_KN_MM,
            tolerance: 0.5 * (range.upper[i] - range.lower[i]) / N_M_A_KN_MM,
            corrected: Some(corrected[i] / N_M_A_KN_MM),
            note: ROUNDED,
        });
    }
    let modes = printed.natural_modes(&paper::STIFFNESS_KN_MM.map(|k| k * N_M_A_KN_MM))?;
    for (mode, published) in modes.iter().zip(paper::WEAK_HZ) {
        cases.push(Case {
            source: SOURCE,
            what: format!("frequency with k = 202, 15.1 kN/mm by eq. 8, measured {published} Hz"),
            unit: "Hz",
            published,
            computed: mode.frequency_hz,
            tolerance: paper::ROUNDING_HZ,
            corrected: None,
            note: FORWARD,
        });
    }
    Ok(cases)
}
