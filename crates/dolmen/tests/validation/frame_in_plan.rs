// SOURCE     Coulomb's law in the plane: Moreau (1988); closed forms; the exact solution of one direction, event by event.
// GOAL       Under two components a frame moves as two separate runs if nothing couples its directions; joints with friction in both directions share
//            one slip force.
//
//            y |    / motion at 45°: the slip force is f, not √2 f
//              |   /
//              |  o - - x
//
// PARAMETERS in each test.
// AGREES     with `simulate_frame`, whose events are exact, along any line; the two storeys of the theory page in El Centro.
// TOLERANCE  linear: 1e-9 of the amplitude at the samples. Shared friction uses time steps of first order: 0.5 % of the largest drift, at which the
//            halving of steps ends, and closed forms within it.

use dolmen::dynamics::{
    FrameInPlan, FrameLoad, FrameOutcome, FrameRun, FrictionActsOn, FrictionFrame, StoreyFriction,
    TimeFunction, ViscousDamping, resultant_drifts, simulate_frame, simulate_frame_in_plan,
};
use dolmen::known::dry_friction::circle_radius;
use dolmen::structure::{Convention, Frame, Storey};
use std::f64::consts::{FRAC_1_SQRT_2, TAU};

fn el_centro(factor: f64) -> TimeFunction {
    let text = include_str!("../../../../data/el_centro_1940_ns/el_centro_1940_ns.csv");
    let samples = text.lines().skip(1);
    let samples = samples.map(|line| factor * 9.81 * line.split_once(',').unwrap().1.parse::<f64>().unwrap());
    TimeFunction::Sampled {
        time_step_s: 0.02,
        values: samples.collect(),
    }
}

fn gate(stiffness_n_m: [f64; 2], friction: [StoreyFriction; 2]) -> FrictionFrame {
    let storeys = [(290e3, 5.84, 5919e3), (314e3, 7.69, 3077e3)].map(|(mass_kg, height_m, axial_n)| Storey {
        mass_kg,
        height_m,
        axial_n,
    });
    let frame = Frame::new(storeys.to_vec(), Convention::Drift).unwrap();
    let frame = FrictionFrame::new(frame, stiffness_n_m.to_vec(), friction.to_vec()).unwrap();
    frame.with_damping(ViscousDamping::Modal(0.02)).unwrap()
}

const NONE: [StoreyFriction; 2] = [StoreyFriction::None; 2];
const SOFT_BELOW: [f64; 2] = [32.65e6, 96.14e6];
const SOFT_ABOVE: [f64; 2] = [185.18e6, 16.85e6];

fn options(duration_s: f64) -> FrameRun {
    FrameRun {
        duration_s: Some(duration_s),
        drift_ratio_most: 0.5,
        ..FrameRun::default()
    }
}

fn together(frames: [&FrictionFrame; 2], grounds: [TimeFunction; 2], run: &FrameRun) -> FrameInPlan {
    let [x, y] = grounds.map(FrameLoad::of_ground);
    let moved = simulate_frame_in_plan(frames, [&x, &y], [run; 2], &mut |_| true).unwrap();
    assert!(
        moved
            .histories
            .iter()
            .all(|of| of.outcome == FrameOutcome::Finished)
    );
    moved
}

/// Friction in one direction only does not couple the directions.
#[test]
fn exact_directions_without_shared_friction_are_two_runs() {
    let coulomb = [StoreyFriction::coulomb(177e3), StoreyFriction::coulomb(92e3)];
    let run = options(30.0);
    for friction in [NONE, coulomb] {
        let frames = [gate(SOFT_BELOW, friction), gate(SOFT_ABOVE, NONE)];
        let moved = together([&frames[0], &frames[1]], [el_centro(1.0), el_centro(-0.6)], &run);
        assert_eq!(moved.shared, None);
        for ((frame, factor), history) in frames.iter().zip([1.0, -0.6]).zip(&moved.histories) {
            let alone = simulate_frame(frame, &FrameLoad::of_ground(el_centro(factor)), &run, &mut |_| {
                true
            });
            assert_eq!(alone.unwrap(), *history);
        }
    }
}

#[test]
fn holds_equal_directions_under_one_motion_turned_have_its_resultant() {
    let frame = gate(SOFT_BELOW, NONE);
    let run = options(30.0);
    let alone = simulate_frame(&frame, &FrameLoad::of_ground(el_centro(1.0)), &run, &mut |_| true).unwrap();
    let moved = together(
        [&frame; 2],
        [el_centro(FRAC_1_SQRT_2), el_centro(FRAC_1_SQRT_2)],
        &run,
    );
    let [x, y] = &moved.histories;
    for storey in [0, 1] {
        let peak_m = alone.drift_peaks[storey].value_m.abs();
        for ((x, y), alone) in x
            .drift_m(storey)
            .iter()
            .zip(y.drift_m(storey))
            .zip(alone.drift_m(storey))
        {
            assert!(
                (x.hypot(y) - alone.abs()).abs() < 1e-9 * peak_m,
                "{x} {y} {alone}"
            );
        }
        let found = resultant_drifts([x, y])[storey];
        assert!((found.drift_m / peak_m - 1.0).abs() < 1e-4, "{found:?} {peak_m}");
        assert!(found.drift_m > x.drift_peaks[storey].value_m.abs());
    }
}

/// The exact engine runs along the line; the time stepping runs on both axes of the plane independently.
#[test]
fn agrees_shared_friction_along_a_line_at_45_degrees_with_the_exact_events() {
    let run = options(35.0);
    let jenkins = [(16e6, 592e3), (48e6, 308e3)].map(|(k, f)| StoreyFriction::jenkins(k, f));
    let coulomb = [0.03 * 5919e3, 0.03 * 3077e3].map(StoreyFriction::coulomb);
    for (stiffness, friction) in [([16.65e6, 48.14e6], jenkins), (SOFT_ABOVE, coulomb)] {
        let frame = gate(stiffness, friction);
        let alone =
            simulate_frame(&frame, &FrameLoad::of_ground(el_centro(1.0)), &run, &mut |_| true).unwrap();
        let moved = together(
            [&frame; 2],
            [el_centro(FRAC_1_SQRT_2), el_centro(FRAC_1_SQRT_2)],
            &run,
        );
        let shared = moved.shared.unwrap();
        assert!(shared.change <= 0.005, "{shared:?}");
        let [x, y] = &moved.histories;
        let largest_m = alone
            .drift_peaks
            .iter()
            .map(|peak| peak.value_m.abs())
            .fold(0.0, f64::max);
        for (storey, of) in resultant_drifts([x, y]).iter().enumerate() {
            let peak_m = alone.drift_peaks[storey].value_m.abs();
            assert!((of.drift_m - peak_m).abs() < 0.005 * largest_m, "{of:?} {peak_m}");
            let way_m = alone.slipped_way_m(storey);
            let ways = x.slipped_way_m(storey).hypot(y.slipped_way_m(storey));
            assert!((ways / way_m - 1.0).abs() < 0.01, "{ways} {way_m}");
            assert!((x.slipping_share(storey) - alone.slipping_share(storey)).abs() < 0.01);
        }
        for (level, rest_m) in alone.rest_m.iter().enumerate() {
            let rests = x.rest_m[level].hypot(y.rest_m[level]);
            assert!(
                (rests - rest_m.abs()).abs() < 0.005 * largest_m,
                "{rests} {rest_m}"
            );
        }
        for history in &moved.histories {
            let left = history.energy_left_over_ratio();
            assert!(left < 1e-9, "{left}");
        }
        // separate sliders in each direction would carry √2 as much
        let each = gate(stiffness, friction);
        let box_of = simulate_frame(
            &each,
            &FrameLoad::of_ground(el_centro(FRAC_1_SQRT_2)),
            &run,
            &mut |_| true,
        );
        let apart_m = box_of.unwrap().drift_peaks[1].value_m.abs() * 2.0_f64.sqrt();
        let shared_m = resultant_drifts([x, y])[1].drift_m;
        assert!((apart_m / shared_m - 1.0).abs() > 0.02, "{apart_m} {shared_m}");
    }
}

/// The peaks of the theory page, from the axes at 30°.
#[test]
fn agrees_the_two_storeys_of_the_theory_page_turned_by_30_degrees() {
    let storey = |mass_kg: f64| Storey {
        mass_kg,
        height_m: 1e6,
        axial_n: 0.0,
    };
    let frame = Frame::new(vec![storey(290e3), storey(314e3)], Convention::Drift).unwrap();
    let kappa = vec![184_170_010.214_826_73, 16_447_964.437_896_422];
    let friction = [5919e3, 3077e3].map(|n| StoreyFriction::coulomb(0.03 * n));
    let frame = FrictionFrame::new(frame, kappa, friction.to_vec()).unwrap();
    let (sin, cos) = (TAU / 12.0).sin_cos();
    let moved = together([&frame; 2], [el_centro(cos), el_centro(sin)], &options(40.0));
    let [x, y] = &moved.histories;
    let drifts = resultant_drifts([x, y]);
    for (of, wanted_mm) in drifts.iter().zip([13.63166081, 118.49225195]) {
        assert!(
            (1e3 * of.drift_m - wanted_mm).abs() < 0.005 * 118.5,
            "{of:?} for {wanted_mm}"
        );
    }
}

#[test]
fn exact_a_mass_circles_against_friction() {
    let storey = Storey {
        mass_kg: 1.0,
        height_m: 1e6,
        axial_n: 0.0,
    };
    let radius = |(g, r, zeta): (f64, f64, f64), output_step_s: f64| {
        let frame = Frame::new(vec![storey.clone()], Convention::Drift).unwrap();
        let frame = FrictionFrame::new(frame, vec![1.0], vec![StoreyFriction::coulomb(r)]).unwrap();
        let frame = frame.with_damping(ViscousDamping::Modal(zeta)).unwrap();
        let sine = |phase_rad| TimeFunction::Harmonic {
            amplitude: 1.0,
            frequency_hz: g / TAU,
            phase_rad,
        };
        let run = FrameRun {
            duration_s: Some(12.0 * TAU / g),
            output_step_s,
            ..FrameRun::default()
        };
        let moved = together([&frame; 2], [sine(0.0), sine(0.25 * TAU)], &run);
        let [x, y] = moved.histories.map(|of| *of.displacement_m[0].last().unwrap());
        x.hypot(y)
    };
    for case in [(0.6, 0.3, 0.3), (1.5, 0.5, 0.3), (0.9, 0.7, 0.3)] {
        let wanted = circle_radius(case.0, case.1, case.2).unwrap();
        let off = radius(case, 0.1) / wanted - 1.0;
        assert!(off.abs() < 1e-3, "{case:?}: {off}");
        // of first order: 0.4 times the step gives 0.4 times the error
        let finer = radius(case, 2e-4) / wanted - 1.0;
        assert!(finer.abs() < 0.5 * off.abs(), "{case:?}: {off} {finer}");
    }
}

/// A constant push of 1.2 f at 45°: two sliders would hold it, one does not.
#[test]
fn exact_one_slip_force_is_the_same_in_every_direction() {
    let storey = Storey {
        mass_kg: 1.0,
        height_m: 1e6,
        axial_n: 0.0,
    };
    let of = |slip_n: [f64; 2], push_n: [f64; 2]| {
        let frames = slip_n.map(|slip_n| {
            let frame = Frame::new(vec![storey.clone()], Convention::Drift).unwrap();
            FrictionFrame::new(frame, vec![1e-9], vec![StoreyFriction::coulomb(slip_n)]).unwrap()
        });
        let moved = together(
            [&frames[0], &frames[1]],
            push_n.map(|push| TimeFunction::Constant(-push)),
            &options(1.0),
        );
        moved.histories.map(|of| *of.displacement_m[0].last().unwrap())
    };
    let [x, y] = of([1.0, 1.0], [1.2 * FRAC_1_SQRT_2, 1.2 * FRAC_1_SQRT_2]);
    // (P − f) t²/2 along the push
    assert!(
        (x.hypot(y) / 0.1 - 1.0).abs() < 1e-3 && (x / y - 1.0).abs() < 1e-9,
        "{x} {y}"
    );
    assert_eq!(
        of([1.0, 1.0], [0.99 * FRAC_1_SQRT_2, 0.99 * FRAC_1_SQRT_2]),
        [0.0, 0.0]
    );
    // an ellipse: just inside it sticks, just outside it slips
    let on = [2.0 * 0.6, 1.0 * 0.8];
    assert_eq!(of([2.0, 1.0], on.map(|push| 0.999 * push)), [0.0, 0.0]);
    assert!(of([2.0, 1.0], on.map(|push| 1.01 * push))[1] > 0.0);
}

/// A leaning frame at rest stays where its springs balance it; under shaking it moves about this position, because the springs are linear.
#[test]
fn exact_a_leaning_frame_moves_about_where_it_rests() {
    let frame = gate(SOFT_ABOVE, NONE);
    let leaning = frame.leaning(0.02).unwrap();
    // τ N/(k − N/l) for each storey
    let drifts = [(185.18e6, 5919e3, 5.84), (16.85e6, 3077e3, 7.69)]
        .map(|(k, n, l): (f64, f64, f64)| 0.02 * n / (k - n / l));
    let rest = [drifts[0], drifts[0] + drifts[1]];
    for (start, wanted) in leaning.start_displacement_m.iter().zip(rest) {
        assert!((start / wanted - 1.0).abs() < 1e-12, "{start} {wanted}");
    }
    let run = FrameRun {
        start_displacement_m: leaning.start_displacement_m.clone(),
        ..options(30.0)
    };
    let moved = |ground| {
        let load = FrameLoad {
            ground_acceleration_m_s2: ground,
            forces_n: leaning.forces_n.clone(),
        };
        simulate_frame(&frame, &load, &run, &mut |_| true).unwrap()
    };
    let still = moved(TimeFunction::Zero);
    let shaken = moved(el_centro(1.0));
    let upright = simulate_frame(
        &frame,
        &FrameLoad::of_ground(el_centro(1.0)),
        &options(30.0),
        &mut |_| true,
    )
    .unwrap();
    for level in [0, 1] {
        for y in &still.displacement_m[level] {
            assert!((y / rest[level] - 1.0).abs() < 1e-9, "{y}");
        }
        assert!(
            (shaken.rest_m[level] / rest[level] - 1.0).abs() < 1e-9,
            "{:?}",
            shaken.rest_m
        );
        for (y, upright) in shaken.displacement_m[level]
            .iter()
            .zip(&upright.displacement_m[level])
        {
            assert!((y - upright - rest[level]).abs() < 1e-10, "{y} {upright}");
        }
    }
    // a sticking frame does not start to move
    let sticky = gate(
        SOFT_ABOVE,
        [0.03 * 5919e3, 0.03 * 3077e3].map(StoreyFriction::coulomb),
    );
    assert!(
        sticky
            .leaning(0.02)
            .unwrap()
            .start_displacement_m
            .iter()
            .all(|y| y.abs() < 1e-15)
    );
}

#[test]
fn refuses_sliders_on_displacements_and_frames_of_other_storeys() {
    let coulomb = [1e5; 2].map(StoreyFriction::coulomb);
    let printed = gate(SOFT_ABOVE, coulomb).acting_on(FrictionActsOn::Displacement);
    let load = FrameLoad::of_ground(el_centro(1.0));
    let refused = |frames: [&FrictionFrame; 2]| {
        let run = options(1.0);
        simulate_frame_in_plan(frames, [&load; 2], [&run; 2], &mut |_| true)
            .unwrap_err()
            .to_string()
    };
    let said = refused([&printed, &printed]);
    assert!(said.contains("must be 0 where both directions rub"), "{said}");
    let storey = Storey {
        mass_kg: 1e5,
        height_m: 4.0,
        axial_n: 0.0,
    };
    let one = Frame::new(vec![storey], Convention::Drift).unwrap();
    let one = FrictionFrame::new(one, vec![1e7], vec![StoreyFriction::None]).unwrap();
    let said = refused([&gate(SOFT_ABOVE, NONE), &one]);
    assert!(
        said.contains("the second direction has 1 entries, but the frame has 2 storeys"),
        "{said}"
    );
}
