//! Hwang, Min & Hong: a floor that twists.

use super::{Case, ValidationError, twisting_floor};
use crate::known::hwang_min_hong as paper;

const SOURCE: &str = "Hwang, Min & Hong";
const RECOVERED: &str = "The drawing of the example is lost; its floor and stiffness are found again from Table 1 itself: 10 × 8 m, \
                         k_x = 2.2821² m, k_y = 0.7 k_x, centre of rigidity 1.5 m left of the middle. The tolerance is one unit of the \
                         last digit printed.";
const CENTRE: &str = "Mode 2 moves along x alone, without a centre. r_1 r_3 = −ρ², 13.6667 m², holds for the computed pair to round-off and for \
                      the printed one to 0.02 %.";

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let modes = twisting_floor(1.0)?.modes()?.modes;
    let mut cases = Vec::new();
    for (j, published) in paper::OMEGA_RAD_S.into_iter().enumerate() {
        cases.push(Case {
            source: SOURCE,
            what: format!("Table 1: circular frequency of mode {}", j + 1),
            unit: "rad/s",
            published,
            computed: modes[j].omega_rad_s,
            tolerance: 1e-4,
            corrected: None,
            note: RECOVERED,
        });
    }
    for ((mode, published), tolerance) in [0, 2].into_iter().zip(paper::RADIUS_M).zip([1e-3, 1e-4]) {
        cases.push(Case {
            source: SOURCE,
            what: format!("Table 1, eq. 12: centre of mode {}, r_x", mode + 1),
            unit: "m",
            published,
            computed: modes[mode].centres[0].map_or(f64::NAN, |centre| centre.r_x_m),
            tolerance,
            corrected: None,
            note: CENTRE,
        });
    }
    Ok(cases)
}
