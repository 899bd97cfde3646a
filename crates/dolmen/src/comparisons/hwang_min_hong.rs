//! Hwang, Min & Hong: a floor with torsion.

use super::{Case, ValidationError, twisting_floor};
use crate::known::hwang_min_hong as paper;
use crate::structure::building::{PlanMode, PlanMotion, PlanStorey, Twist, plan_stiffness};

const SOURCE: &str = "Hwang, Min & Hong";
const RECOVERED: &str = "The drawing of the example is lost; its floor and stiffness are found again from Table 1 itself: 10 × 8 m, \
                         k_x = 2.2821² m, k_y = 0.7 k_x, centre of rigidity 1.5 m left of the middle. The tolerance is one unit of the \
                         last digit printed.";
const CENTRE: &str = "Mode 2 moves along x alone, without a centre. r_1 r_3 = −ρ², 13.6667 m², holds for the computed pair to round-off and for \
                      the printed one to 0.02 %.";
const INVERSE: &str = "From the three frequencies and the centre of mode 1 as Table 1 prints them, and from nothing else: the stiffness and the centre \
                       of rigidity of the floor whose modes these are. The tolerance is what one unit of the last digit of each printed number moves.";

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
    cases.extend(inverse()?);
    Ok(cases)
}

/// The storey from the printed modes: t = ρθ/v of mode 1 is −ρ/r_x.
fn inverse() -> Result<Vec<Case>, ValidationError> {
    let gyration_m = paper::GYRATION_SQUARED_M2.sqrt();
    let storey = PlanStorey {
        mass_kg: 1.0,
        gyration_m,
        weight_takes_n_m: 0.0,
        eccentricity_m: [0.0; 2],
    };
    let motions = [PlanMotion::Y, PlanMotion::X, PlanMotion::Torsion];
    let twists = [Some(-gyration_m / paper::RADIUS_M[0]), Some(0.0), None];
    let modes = [0, 1, 2].map(|j| PlanMode {
        frequency_hz: paper::OMEGA_RAD_S[j] / std::f64::consts::TAU,
        frequency_sd_hz: 0.0,
        motion: Some(motions[j]),
        twist: twists[j].map(|ratio| Twist { ratio, sd: 0.0 }),
        shape: None,
    });
    let found = plan_stiffness(&storey, &modes)?;
    let one = found.accepted().next();
    let case = |what: &str, unit: &'static str, published, computed: Option<f64>, tolerance| Case {
        source: SOURCE,
        what: format!("stiffness from the modes of Table 1: {what}"),
        unit,
        published,
        computed: computed.unwrap_or(f64::NAN),
        tolerance,
        corrected: None,
        note: INVERSE,
    };
    let about_rigidity = paper::rotation() - paper::STIFFNESS[1] * paper::RIGIDITY_X_M.powi(2);
    Ok(vec![
        case(
            "k_y over the mass",
            "1/s²",
            paper::STIFFNESS[1],
            one.map(|one| one.stiffness[1]),
            4e-4,
        ),
        case(
            "k_θ over the mass",
            "m²/s²",
            about_rigidity,
            one.map(|one| one.stiffness[2]),
            1.1e-2,
        ),
        case(
            "centre of rigidity",
            "m",
            paper::RIGIDITY_X_M,
            one.map(|one| one.eccentricity_m[0]),
            3.7e-4,
        ),
    ])
}
