//! A storey whose tenons have slack: closed forms.

use super::{Case, ValidationError};
use crate::dynamics::{
    FrameHistory, FrameLoad, FrameRun, FrictionFrame, StoreyFriction, Tenon, simulate_frame,
};
use crate::known::gap_spring::{crushed_m, period_s};
use crate::structure::{Convention, Frame, Storey};

/// Tolerance: events are located to 1e-12 s, and values are about 1.
const ROUNDING: f64 = 1e-9;
/// Slack, m, and stiffness of the tenons, N/m, for a mass of 1 kg.
const SLACK_M: f64 = 0.5;
const STIFFNESS_N_M: f64 = 4.0;
/// Crushing force of the tenons, and slip force in parallel, N.
const FORCES_N: [f64; 2] = [2.0, 0.15];
/// Crushed depth at which half of the stiffness remains, m.
const HALF_M: f64 = 0.7;

const SOURCE: &str = "Closed form";

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let mut cases = Vec::new();
    let loose = Tenon {
        slack_m: SLACK_M,
        stiffness_n_m: STIFFNESS_N_M,
        crushing_force_n: None,
        half_stiffness_depth_m: None,
    };
    for (within_n_m, amplitude_m) in [(0.0, 1.5), (0.3, 0.7)] {
        let options = FrameRun {
            duration_s: Some(40.0),
            start_displacement_m: vec![amplitude_m],
            ..FrameRun::default()
        };
        let swings = run((within_n_m, 0.0), loose, &options)?;
        let half = period_s([within_n_m, STIFFNESS_N_M], 1.0, SLACK_M, amplitude_m);
        cases.push(Case {
            source: SOURCE,
            what: format!(
                "period of a mass on tenons with slack, k = {within_n_m} within it, from {amplitude_m} m"
            ),
            unit: "s",
            published: half.unwrap_or(f64::NAN),
            computed: swings.turns.get(1).map_or(f64::NAN, |turn| turn.at_s),
            tolerance: ROUNDING,
            corrected: None,
            note: "",
        });
    }
    let crushing = Tenon {
        crushing_force_n: Some(FORCES_N[0]),
        half_stiffness_depth_m: Some(HALF_M),
        ..loose
    };
    let options = FrameRun {
        duration_s: Some(12.0),
        start_velocity_m_s: vec![3.0],
        ..FrameRun::default()
    };
    let thrown = run((0.0, FORCES_N[1]), crushing, &options)?;
    cases.push(Case {
        source: SOURCE,
        what: "crushed depth of a tenon that stops 1 kg at 3 m/s, friction beside it".to_owned(),
        unit: "m",
        published: crushed_m(4.5, SLACK_M, STIFFNESS_N_M, FORCES_N),
        computed: thrown
            .tenons
            .first()
            .copied()
            .flatten()
            .map_or(f64::NAN, |[face, _]| face.crushed_m),
        tolerance: ROUNDING,
        corrected: None,
        note: "",
    });
    Ok(cases)
}

fn run(
    (within_n_m, friction_n): (f64, f64),
    tenon: Tenon,
    options: &FrameRun,
) -> Result<FrameHistory, ValidationError> {
    let storey = Storey {
        mass_kg: 1.0,
        height_m: 1e6,
        axial_n: 0.0,
    };
    let frame = Frame::new(vec![storey], Convention::Drift)?;
    let friction = vec![StoreyFriction::coulomb(friction_n)];
    let frame = FrictionFrame::new(frame, vec![within_n_m], friction)?.with_tenons(vec![Some(tenon)])?;
    Ok(simulate_frame(&frame, &FrameLoad::none(), options, &mut |_| {
        true
    })?)
}
