//! Oscillators with dry friction: Den Hartog (1931), Lorenz (1924), Jenkins (1962).

use super::{Case, ValidationError};
use crate::dynamics::{
    FrameHistory, FrameLoad, FrameRun, FrictionFrame, StoreyFriction, TimeFunction, ViscousDamping,
    simulate_frame, simulate_frame_in_plan,
};
use crate::known::dry_friction::{
    circle_radius, forced_amplitude, free_decay_turns_m, jenkins_loop_energy_j,
};
use crate::structure::{Convention, Frame, Storey};
use std::f64::consts::TAU;

/// Tolerance for rounding alone, in amplitudes of about 1.
const ROUNDING: f64 = 1e-9;
/// Number of cycles before the steady state is measured; by then, friction alone has damped the
/// initial motion.
const CYCLES: f64 = 400.0;
/// A mass so heavy that a Jenkins element hardly affects it.
const HEAVY: f64 = 1e9;

const STEADY: &str = "Read after 400 cycles from rest.";

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let mut cases = Vec::new();
    for (g, r) in [(0.6, 0.3), (0.9, 0.5), (1.5, 0.5), (3.0, 0.4)] {
        cases.push(Case {
            source: "Den Hartog (1931)",
            what: format!("steady amplitude, x0 k/P, ω/ω_n = {g}, f/P = {r}"),
            unit: "",
            published: forced_amplitude(g, r).unwrap_or(f64::NAN),
            computed: steady_amplitude(g, r)?,
            tolerance: ROUNDING,
            corrected: None,
            note: STEADY,
        });
    }
    let free = run(StoreyFriction::coulomb(1.0), 1.0, &FrameLoad::none(), (9.3, 30.0))?;
    cases.push(Case {
        source: "Lorenz (1924)",
        what: "where a free oscillator comes to rest, from 9.3 f/k".to_owned(),
        unit: "f/k",
        published: free_decay_turns_m(9.3, 1.0, 1.0)
            .last()
            .copied()
            .unwrap_or(f64::NAN),
        computed: free.residual_m.first().copied().unwrap_or(f64::NAN),
        tolerance: ROUNDING,
        corrected: None,
        note: "",
    });
    let swing = run(
        StoreyFriction::jenkins(2.0, 1.0),
        HEAVY,
        &FrameLoad::none(),
        (1.5, 2.0 * TAU + 0.1),
    )?;
    let taken = |history: &FrameHistory| history.energy.last().map_or(f64::NAN, |e| e.friction_j);
    let first = run(
        StoreyFriction::jenkins(2.0, 1.0),
        HEAVY,
        &FrameLoad::none(),
        (1.5, TAU + 0.1),
    )?;
    cases.push(Case {
        source: "Jenkins (1962)",
        what: "energy taken in a cycle, k = 2, f = 1, X = 1.5".to_owned(),
        unit: "J",
        published: jenkins_loop_energy_j(1.5, 2.0, 1.0),
        computed: taken(&swing) - taken(&first),
        tolerance: 1e-7, // the element slows the mass by about 1e-8 of its amplitude
        corrected: None,
        note: "",
    });
    for (g, r, zeta) in CIRCLES {
        cases.push(Case {
            source: "Closed form",
            what: format!("radius of a mass that circles with friction in the plane, x0 k/P, ω/ω_n = {g}, f/P = {r}, ζ = {zeta}"),
            unit: "",
            published: circle_radius(g, r, zeta).unwrap_or(f64::NAN),
            computed: circling(g, r, zeta)?,
            tolerance: 1e-4, // first order in a step of 1/5000 of a radian
            corrected: None,
            note: "Read after 30 cycles from rest; both directions share one slip force.",
        });
    }
    Ok(cases)
}

/// Frequency ratio, friction ratio and damping ratio of masses that move in circles.
const CIRCLES: [(f64, f64, f64); 2] = [(0.6, 0.3, 0.05), (1.5, 0.5, 0.05)];

/// Radius at the end of a run on a ground that moves in circles.
fn circling(g: f64, r: f64, damping_ratio: f64) -> Result<f64, ValidationError> {
    let storey = Storey {
        mass_kg: 1.0,
        height_m: 1e6,
        axial_n: 0.0,
    };
    let frame = Frame::new(vec![storey], Convention::Drift)?;
    let frame = FrictionFrame::new(frame, vec![1.0], vec![StoreyFriction::coulomb(r)])?
        .with_damping(ViscousDamping::Modal(damping_ratio))?;
    let load = |phase_rad| {
        FrameLoad::of_ground(TimeFunction::Harmonic {
            amplitude: 1.0,
            frequency_hz: g / TAU,
            phase_rad,
        })
    };
    let options = FrameRun {
        duration_s: Some(30.0 * TAU / g),
        output_step_s: 0.1,
        ..FrameRun::default()
    };
    let (x, y) = (load(0.0), load(0.25 * TAU));
    let moved = simulate_frame_in_plan([&frame; 2], [&x, &y], [&options; 2], &mut |_| true)?;
    let [x, y] = moved
        .histories
        .map(|of| of.displacement_m[0].last().copied().unwrap_or(f64::NAN));
    Ok(x.hypot(y))
}

/// A mass on a spring of the same number, with a Jenkins element, released or driven, for a given
/// time.
fn run(
    element: StoreyFriction,
    mass: f64,
    load: &FrameLoad,
    (start_m, duration_s): (f64, f64),
) -> Result<FrameHistory, ValidationError> {
    let storey = Storey {
        mass_kg: mass,
        height_m: 1e6,
        axial_n: 0.0,
    };
    let frame = Frame::new(vec![storey], Convention::Drift)?;
    let frame = FrictionFrame::new(frame, vec![mass], vec![element])?;
    let options = FrameRun {
        duration_s: Some(duration_s),
        output_step_s: duration_s,
        start_displacement_m: vec![start_m],
        ..FrameRun::default()
    };
    Ok(simulate_frame(&frame, load, &options, &mut |_| true)?)
}

fn steady_amplitude(g: f64, r: f64) -> Result<f64, ValidationError> {
    let load = FrameLoad::of_ground(TimeFunction::Harmonic {
        amplitude: 1.0,
        frequency_hz: g / TAU,
        phase_rad: 0.0,
    });
    let history = run(StoreyFriction::coulomb(r), 1.0, &load, (0.0, CYCLES * TAU / g))?;
    // the last slip but one is complete: from turning point to turning point, twice the amplitude
    let slip = history
        .slips
        .iter()
        .rev()
        .nth(1)
        .map_or(f64::NAN, |slip| slip.slip_m);
    Ok(0.5 * slip.abs())
}
