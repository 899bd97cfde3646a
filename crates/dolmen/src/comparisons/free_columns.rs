//! Free-standing columns on foot stones.

use super::{Case, ValidationError};
use crate::dynamics::RockingBlock;
use crate::stability::{FootSection, FreeColumns};

const SQUARE: FootSection = FootSection::Rectangle {
    width_m: 0.5,
    breadth_m: 0.5,
};
const SOURCE: &str = "Column on two Winkler beds";

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let mut cases = Vec::new();
    let (height_m, axial_n) = (4.0, 200e3);
    for (bed, published) in [(1e8, 0.542), (3e8, 0.779), (1e9, 0.887), (3e9, 0.936)] {
        let columns = FreeColumns::new(1, SQUARE, height_m, axial_n, Some(bed))?;
        let standing = columns.standing()?;
        cases.push(Case {
            source: SOURCE,
            what: format!("rotation of fall over b/h, k_w {bed:.0e} N/m³, N 200 kN, b 0.5 m, h 4 m"),
            unit: "",
            published,
            computed: standing.map_or(f64::NAN, |at| at.falls.rotation_rad.tan() * height_m / SQUARE.width_m()),
            tolerance: 1e-3,
            corrected: None,
            note: "By hand for small angles, b/h − (2/3h) √(2N/(k_w B θ)) = θ; computed is tan θ at finite rotation.",
        });
    }
    let bed = 1e9;
    let columns = FreeColumns::new(1, SQUARE, height_m, axial_n, Some(bed))?;
    let rotation_rad = (2.0 * axial_n / (9.0 * bed * 0.5 * height_m * height_m)).cbrt();
    cases.push(Case {
        source: SOURCE,
        what: "greatest force over N, k_w 1e9 N/m³".to_owned(),
        unit: "",
        published: 0.5 / height_m - 3.0 * rotation_rad,
        computed: columns
            .standing()?
            .map_or(f64::NAN, |at| at.greatest.force_n / axial_n),
        tolerance: 2e-4,
        corrected: None,
        note: "b/h − 3 θ*, θ* = (2N/(9 k_w B h²))^⅓, for small angles: it leaves out 1 + tan ψ tan θ, 1.6e-3 of the force.",
    });
    let rigid = FreeColumns::new(1, SQUARE, height_m, axial_n, None)?;
    let (alpha, gravity_m_s2) = (0.5_f64.atan2(height_m), 9.81);
    let pull = gravity_m_s2 / height_m.hypot(0.5);
    cases.push(Case {
        source: "By hand: a rigid beam on rigid columns (Housner 1963)",
        what: "frequency of a rigid beam on rigid columns at θ = α/2".to_owned(),
        unit: "Hz",
        published: 0.25 * pull.sqrt() / f64::acosh(2.0),
        computed: rigid.swing_frequency_hz(axial_n / gravity_m_s2, 0.0, 0.5 * alpha),
        tolerance: 1e-3,
        corrected: None,
        note: "T = (4/p) acosh 1/(1 − θ/α) for small angles, with p² = g/d, d the diagonal of a column.",
    });
    for (beam_to_columns, published) in [
        (1.0, 0.866_03),
        (5.0, 0.829_16),
        (10.0, 0.823_05),
        (f64::INFINITY, 0.816_50),
    ] {
        let column = RockingBlock::rectangle(0.5, height_m, gravity_m_s2)?;
        let frame = RockingBlock::frame_on_columns(0.5, height_m, beam_to_columns, gravity_m_s2)?;
        cases.push(Case {
            source: "Makris, Vassiliou (2013)",
            what: format!(
                "p of a rocking frame over that of its column, beam {beam_to_columns} times its columns"
            ),
            unit: "",
            published,
            computed: frame.frequency_parameter_rad_s / column.frequency_parameter_rad_s,
            tolerance: 0.5e-5,
            corrected: None,
            note: "√((1 + 2γ)/(1 + 3γ)), to five digits.",
        });
    }
    Ok(cases)
}
