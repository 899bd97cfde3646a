//! Rigid blocks that rock, slide and spin: Housner (1963), Newmark (1965), Farkas et al. (2003).

use super::Case;
use crate::known::{overturning, rocking, sliding, twisting};

/// Tolerance for rounding alone.
const ROUNDING: f64 = 1e-12;
/// The block of the cases: stone 0.4 × 2.0 m.
const HALF_WIDTH_M: f64 = 0.2;
const HALF_HEIGHT_M: f64 = 1.0;
const GRAVITY_M_S2: f64 = 9.81;
const MM: f64 = 1e-3;

const ENERGY: &str = "Housner's r is the ratio of the kinetic energies, and the velocities keep its root. Corrected: angular \
                      velocity after the impact / before it, the r of the later literature.";
const UNSAFE: &str = "Housner's √(1 + ω²/p²) is what a sine asks for that never ends; the end of the pulse helps the block \
                      over, so the formula is unsafe. Corrected: cos ψ + exp(−(π − ψ) p/ω) = (ω/p) sin ψ, A = 1/sin ψ.";
const FLANK: &str =
    "A record of straight lines ends the pulse in a flank of one step, 1 μs, which takes 0.0003 mm.";

pub(super) fn cases() -> Vec<Case> {
    let mut cases = vec![Case {
        source: "Housner (1963)",
        what: "r of a block of 0.4 × 2.0 m".to_owned(),
        unit: "",
        published: rocking::housner_energy_ratio(rocking::slenderness_rad(HALF_WIDTH_M, HALF_HEIGHT_M), 0.75),
        computed: angular_velocity_kept().powi(2),
        tolerance: ROUNDING,
        corrected: Some(angular_velocity_kept()),
        note: ENERGY,
    }];
    for q in [1.0, 2.0, 3.0, 4.0] {
        cases.push(Case {
            source: "Housner (1963)",
            what: format!("half sine that overturns a block, a/(α g), ω/p = {q}"),
            unit: "",
            published: overturning::housner_half_sine(q),
            computed: 1.0 / (1.0 / q).atan().sin(), // cos ψ = q sin ψ
            tolerance: ROUNDING,
            corrected: Some(overturning::linear_half_sine(q)),
            note: UNSAFE,
        });
    }
    cases.push(Case {
        source: "Newmark (1965)",
        what: "slip in a pulse of 0.5 g and 0.2 s, μ = 0.3".to_owned(),
        unit: "mm",
        published: sliding::rectangular_pulse_slip_m(0.5 * GRAVITY_M_S2, 0.2, 0.3, GRAVITY_M_S2) / MM,
        computed: rectangular_pulse_m() / MM,
        tolerance: 0.001,
        corrected: None,
        note: FLANK,
    });
    cases.push(Case {
        source: "Farkas et al. (2003)",
        what: "v/(ω R) of a disc as sliding and spinning die together".to_owned(),
        unit: "",
        published: 0.653,
        computed: twisting::disc_final_speed_ratio(),
        tolerance: 0.0005, // half a unit of the last printed digit
        corrected: None,
        note: "",
    });
    cases
}

/// Ratio of angular velocities at an impact: angular momentum about the new edge before it, divided by the
/// moment of inertia, both per mass.
fn angular_velocity_kept() -> f64 {
    let (b2, h2) = (HALF_WIDTH_M.powi(2), HALF_HEIGHT_M.powi(2));
    let about_the_centre = (b2 + h2) / 3.0;
    (about_the_centre + h2 - b2) / (about_the_centre + h2 + b2)
}

/// Slip under the pulse, given as a record of 200 000 steps of 1 μs, event by event.
fn rectangular_pulse_m() -> f64 {
    let base: Vec<f64> = (0..=200_001)
        .map(|i| if i < 200_000 { 0.5 * GRAVITY_M_S2 } else { 0.0 })
        .collect();
    let friction = sliding::Friction::single(0.3, GRAVITY_M_S2);
    sliding::record_slip(&base, 1e-6, &friction).map_or(f64::NAN, |slip| slip.peak_m)
}
