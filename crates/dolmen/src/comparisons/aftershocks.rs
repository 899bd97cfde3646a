//! A second motion after a first: both motions in one run, and a run that restarts where the first came to rest.

use super::{Case, ValidationError};
use crate::dynamics::{
    FrameHistory, FrameLoad, FrameRun, FrictionFrame, StoreyFriction, TimeFunction, simulate_frame,
};
use crate::signal::{Component, GroundMotion, Noise, motion_sequence, noise_motion};
use crate::structure::{Convention, Frame, Storey};

/// Tolerance between both motions in one run and the restarted run: the same equations with the same samples at other
/// times.
const SAME: f64 = 1e-9;
/// Time in which dry friction brings the frame to rest, s.
const REST_S: f64 = 10.0;

const RESTART: &str = "One storey of 1000 kg on 100 kN/m with dry friction of 1 kN, noise of seeds 1 and 2 at 2 m/s². Published: the second motion alone, from \
                       the displacement at which the first left the storey sticking.";

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let noise = Noise {
        peak_acceleration_m_s2: 2.0,
        ..Noise::default()
    };
    let [first, second] = [noise_motion(&noise, 1)?, noise_motion(&noise, 2)?];
    let alone = run(&first, 0.0)?;
    let left_m = alone.residual_m.first().copied().unwrap_or(f64::NAN);
    let restarted = run(&second, left_m)?;
    let both = run(&motion_sequence(&first, REST_S, &second)?.motion, 0.0)?;
    let residual = |history: &FrameHistory| 1e3 * history.residual_m.first().copied().unwrap_or(f64::NAN);
    let row = |what: &str, published: f64, computed: f64| Case {
        source: "Second methods",
        what: what.to_owned(),
        unit: "mm",
        published,
        computed,
        tolerance: SAME,
        corrected: None,
        note: RESTART,
    };
    let slipped = |history: &FrameHistory| 1e3 * history.slipped_way_m(0);
    Ok(vec![
        row(
            "displacement left by two motions, the storey at rest between them",
            residual(&restarted),
            residual(&both),
        ),
        row(
            "way slipped in the second of them",
            slipped(&restarted),
            slipped(&both) - slipped(&alone),
        ),
    ])
}

fn run(motion: &GroundMotion, start_m: f64) -> Result<FrameHistory, ValidationError> {
    let storey = Storey {
        mass_kg: 1e3,
        height_m: 1e3, // so high that drifts of any size are small
        axial_n: 0.0,
    };
    let frame = Frame::new(vec![storey], Convention::Drift)?;
    let frame = FrictionFrame::new(frame, vec![1e5], vec![StoreyFriction::coulomb(1e3)])?;
    let load = FrameLoad::of_ground(TimeFunction::of_motion(motion, Component::X));
    let options = FrameRun {
        duration_s: Some(motion.duration_s() + REST_S),
        start_displacement_m: vec![start_m],
        ..FrameRun::default()
    };
    Ok(simulate_frame(&frame, &load, &options, &mut |_| true)?)
}
