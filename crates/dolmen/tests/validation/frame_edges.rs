// SOURCE     closed forms; a plain time-stepping solution written here; Park and Min (2010) for the signs of P-delta.
// GOAL       Frames in extreme cases: P-delta with sliders, no slip force, falling frames, limits reached between steps, few
//            samples.
// PARAMETERS in each test.
// AGREES     Runge–Kutta steps of 1e-5 s, with a check of the sliders after each.
// TOLERANCE  time stepping changes a slider up to a step late, so its error is proportional to the step: 2e-6 of the largest
//            displacement at 2e-6 s, 1e-6 at 1e-6 s; required 5e-5 at 1e-5 s.

use dolmen::dynamics::{
    FrameLoad, FrameOutcome, FrameRun, FrictionActsOn, FrictionFrame, StoreyFriction, TimeFunction,
    ViscousDamping, harmonic_map, simulate_frame,
};
use dolmen::numeric::Random;
use dolmen::structure::{Convention, Frame, Storey};
use std::f64::consts::TAU;

fn frame(rows: &[(f64, f64, f64)], convention: Convention) -> Frame {
    let storey = |&(mass_kg, height_m, axial_n): &(f64, f64, f64)| Storey {
        mass_kg,
        height_m,
        axial_n,
    };
    Frame::new(rows.iter().map(storey).collect(), convention).unwrap()
}

fn shaking(random: &mut Random, samples: usize, time_step_s: f64) -> TimeFunction {
    TimeFunction::Sampled {
        time_step_s,
        values: (0..samples).map(|_| 6.0 * (random.uniform() - 0.5)).collect(),
    }
}

const MASS: [f64; 3] = [1.1, 0.9, 1.6];
const HEIGHT: [f64; 3] = [3.0, 2.5, 2.0];
const AXIAL: [f64; 3] = [30.0, 21.0, 12.0];
const SPRING: [f64; 3] = [90.0, 140.0, 70.0];
const STUCK: [f64; 3] = [300.0, 200.0, 400.0];
const KINETIC: [f64; 3] = [1.6, 1.2, 0.8];

/// Jenkins elements under P-delta, step by step.
fn stepped(
    load: &TimeFunction,
    static_ratio: f64,
    convention: Convention,
    on: FrictionActsOn,
) -> Vec<[f64; 3]> {
    let TimeFunction::Sampled { time_step_s, values } = load else {
        unreachable!()
    };
    let h = 1e-5;
    let below = |x: &[f64; 3], i: usize| if i > 0 { x[i - 1] } else { 0.0 };
    let across = |x: &[f64; 3], i: usize| match on {
        FrictionActsOn::Drift => x[i] - below(x, i),
        FrictionActsOn::Displacement => x[i],
    };
    let (mut y, mut v, mut offset, mut slips) = ([0.0; 3], [0.0; 3], [0.0; 3], [0.0; 3]);
    let mut found = Vec::new();
    for step in 0..=400_000_usize {
        if step % 1000 == 0 {
            found.push(y);
        }
        let acceleration = |part: f64, y: &[f64; 3], offset: &[f64; 3], slips: &[f64; 3]| {
            // inside the step, so that a jump of the load at its end belongs to the next step
            let t = (step as f64 + 1e-6 + part * (1.0 - 2e-6)) * h / time_step_s;
            let i = t.floor() as usize;
            let ground = match (values.get(i), values.get(i + 1)) {
                (Some(a), Some(b)) => a + (b - a) * (t - i as f64),
                _ => 0.0,
            };
            let mut force = [0.0; 3];
            for i in 0..3 {
                let drift = y[i] - below(y, i);
                let leaning = -AXIAL[i] / HEIGHT[i] * drift;
                let (spring, grounded) = match convention {
                    Convention::Drift => (SPRING[i] * drift, 0.0),
                    Convention::Grounded => (0.0, SPRING[i] * y[i]),
                };
                let slider = if slips[i] == 0.0 {
                    STUCK[i] * (across(y, i) - offset[i])
                } else {
                    slips[i] * KINETIC[i]
                };
                force[i] -= leaning + spring + grounded + slider;
                if i > 0 {
                    force[i - 1] += leaning + spring;
                    if on == FrictionActsOn::Drift {
                        force[i - 1] += slider;
                    }
                }
            }
            std::array::from_fn::<f64, 3, _>(|i| force[i] / MASS[i] - ground)
        };
        let on_by = |x: &[f64; 3], dx: &[f64; 3], h: f64| std::array::from_fn(|i| x[i] + h * dx[i]);
        let a1 = acceleration(0.0, &y, &offset, &slips);
        let (y2, v2): ([f64; 3], [f64; 3]) = (on_by(&y, &v, 0.5 * h), on_by(&v, &a1, 0.5 * h));
        let a2 = acceleration(0.5, &y2, &offset, &slips);
        let (y3, v3): ([f64; 3], [f64; 3]) = (on_by(&y, &v2, 0.5 * h), on_by(&v, &a2, 0.5 * h));
        let a3 = acceleration(0.5, &y3, &offset, &slips);
        let (y4, v4): ([f64; 3], [f64; 3]) = (on_by(&y, &v3, h), on_by(&v, &a3, h));
        let a4 = acceleration(1.0, &y4, &offset, &slips);
        for i in 0..3 {
            y[i] += h / 6.0 * (v[i] + 2.0 * (v2[i] + v3[i]) + v4[i]);
            v[i] += h / 6.0 * (a1[i] + 2.0 * (a2[i] + a3[i]) + a4[i]);
        }
        for i in 0..3 {
            let force = STUCK[i] * (across(&y, i) - offset[i]);
            if slips[i] == 0.0 {
                if force.abs() >= static_ratio * KINETIC[i] {
                    slips[i] = force.signum();
                }
            } else if across(&v, i) * slips[i] <= 0.0 {
                offset[i] = across(&y, i) - slips[i] * KINETIC[i] / STUCK[i];
                slips[i] = 0.0;
            }
        }
    }
    found
}

#[test]
fn agrees_jenkins_under_p_delta_with_time_stepping() {
    let rows: Vec<(f64, f64, f64)> = (0..3).map(|i| (MASS[i], HEIGHT[i], AXIAL[i])).collect();
    let mut random = Random::new(7, 0);
    for (static_ratio, convention, on) in [
        (1.0, Convention::Drift, FrictionActsOn::Drift),
        (1.3, Convention::Drift, FrictionActsOn::Displacement),
        (1.2, Convention::Grounded, FrictionActsOn::Drift),
    ] {
        // its last sample is not 0: there the ground acceleration jumps
        let load = shaking(&mut random, 61, 0.05);
        let friction = |i: usize| StoreyFriction::Jenkins {
            stuck_stiffness_n_m: STUCK[i],
            static_force_n: static_ratio * KINETIC[i],
            kinetic_force_n: KINETIC[i],
        };
        let sliders = (0..3).map(friction).collect();
        let moved = FrictionFrame::new(frame(&rows, convention), SPRING.to_vec(), sliders)
            .unwrap()
            .acting_on(on);
        let options = FrameRun {
            duration_s: Some(4.0),
            output_step_s: 0.01,
            drift_ratio_most: 1e9,
            ..FrameRun::default()
        };
        let wanted = stepped(&load, static_ratio, convention, on);
        let history = simulate_frame(&moved, &FrameLoad::of_ground(load), &options, &mut |_| true).unwrap();
        assert!(history.slips.len() > 10, "{} slips", history.slips.len());
        assert_eq!(history.time_s.len(), wanted.len());
        let largest = history
            .displacement_peaks
            .iter()
            .fold(0.0_f64, |m, p| m.max(p.value_m.abs()));
        for (j, wanted) in wanted.iter().enumerate() {
            for (i, wanted) in wanted.iter().enumerate() {
                let off = (history.displacement_m[i][j] - wanted).abs() / largest;
                assert!(off < 5e-5, "level {i} at sample {j}: {off:e} of the largest");
            }
        }
    }
}

#[test]
fn exact_a_slider_of_no_force_is_none() {
    let rows = [(1.0, 3.0, 0.0), (2.0, 3.0, 0.0), (0.5, 3.0, 0.0)];
    let load = FrameLoad::of_ground(shaking(&mut Random::new(3, 0), 80, 0.02));
    let options = FrameRun {
        duration_s: Some(5.0),
        ..FrameRun::default()
    };
    let moved = |friction: [StoreyFriction; 3]| {
        let storeys = frame(&rows, Convention::Drift);
        let frame = FrictionFrame::new(storeys, vec![400.0, 300.0, 200.0], friction.to_vec()).unwrap();
        simulate_frame(&frame, &load, &options, &mut |_| true).unwrap()
    };
    let free = moved([StoreyFriction::None; 3]);
    assert!(free.displacement_peaks[2].value_m.abs() > 1e-3);
    let none = [StoreyFriction::coulomb(0.0), StoreyFriction::jenkins(500.0, 0.0)];
    for friction in [[none[0]; 3], [none[1]; 3], [none[1], none[0], none[1]]] {
        assert_eq!(moved(friction), free);
    }
    // next to a slider with a force
    let one = moved([StoreyFriction::coulomb(0.5), none[0], none[1]]);
    assert_eq!(
        one,
        moved([
            StoreyFriction::coulomb(0.5),
            StoreyFriction::None,
            StoreyFriction::None
        ])
    );
    assert!(!one.slips.is_empty());
}

#[test]
fn refuses_rayleigh_damping_that_drives_a_falling_frame() {
    // springs in series with their sliders only: during slip K = −N/l, ω² = −4 1/s²
    let falling = |damping| {
        let storeys = frame(&[(1.0, 1.0, 4.0)], Convention::Drift);
        FrictionFrame::new(storeys, vec![0.0], vec![StoreyFriction::jenkins(10.0, 1.0)])
            .unwrap()
            .with_damping(damping)
    };
    let rayleigh = |mass_per_s, stiffness_s| ViscousDamping::Rayleigh {
        mass_per_s,
        stiffness_s,
    };
    let error = falling(rayleigh(0.03, 0.01)).unwrap_err().to_string();
    assert!(
        error.starts_with("stiffness_s is 0.01, but must be so small that"),
        "{error}"
    );
    assert!(falling(rayleigh(0.05, 0.01)).is_ok());
    assert!(falling(ViscousDamping::Modal(0.05)).is_ok());
}

#[test]
fn exact_a_drift_beyond_its_limit_between_steps_ends_the_run() {
    // y = sin t, peak 1 at π/2 s: at the ends of one-second steps y is 0.84, 0.91, 0.14; the run ends at y = 0.999, inside a step
    let storeys = frame(&[(1.0, 1.0, 0.0)], Convention::Drift);
    let free = FrictionFrame::new(storeys, vec![1.0], vec![StoreyFriction::None]).unwrap();
    let history = |drift_ratio_most| {
        let options = FrameRun {
            duration_s: Some(6.0),
            start_velocity_m_s: vec![1.0],
            drift_ratio_most,
            ..FrameRun::default()
        };
        simulate_frame(&free, &FrameLoad::none(), &options, &mut |_| true).unwrap()
    };
    for limit in [0.3, 0.999] {
        let ended = history(limit);
        let FrameOutcome::DriftLimit { storey: 0, at_s } = ended.outcome else {
            panic!("{:?}", ended.outcome)
        };
        let wanted = f64::asin(limit);
        assert!((at_s - wanted).abs() < 1e-12, "{at_s} {wanted}");
        assert!((ended.residual_m[0] - limit).abs() < 1e-14 && ended.duration_s == at_s);
        assert!((ended.drift_peaks[0].value_m - limit).abs() < 1e-14);
        assert!(ended.time_s.iter().all(|t| *t <= at_s));
    }
    assert_eq!(history(1.001).outcome, FrameOutcome::Finished);
}

#[test]
fn holds_the_share_of_slipping_is_one_of_the_whole_run() {
    // pushed from rest, it slips from 0 to 0.3 s without a stop
    let storeys = frame(&[(1.0, 1e6, 0.0)], Convention::Drift);
    let slider = FrictionFrame::new(storeys, vec![1.0], vec![StoreyFriction::coulomb(1.0)]).unwrap();
    let load = FrameLoad::of_ground(TimeFunction::Sampled {
        time_step_s: 0.1,
        values: vec![3.0; 4],
    });
    for output_step_s in [0.5, 0.2, 0.07, 0.001] {
        let options = FrameRun {
            output_step_s,
            ..FrameRun::default()
        };
        let history = simulate_frame(&slider, &load, &options, &mut |_| true).unwrap();
        assert!((history.duration_s - 0.3).abs() < 1e-12);
        assert!(
            (history.slipping_share(0) - 1.0).abs() < 1e-9,
            "{} at {output_step_s}",
            history.slipping_share(0)
        );
    }
}

#[test]
fn exact_drift_of_a_map_is_that_between_the_samples() {
    // linear, damped: a/(ω² √((1 − g²)² + (2 ζ g)²))
    let storeys = frame(&[(1.0, 1e6, 0.0)], Convention::Drift);
    let (omega, zeta) = (TAU, 0.2);
    let linear = FrictionFrame::new(storeys, vec![omega * omega], vec![StoreyFriction::None])
        .unwrap()
        .with_damping(ViscousDamping::Modal(zeta))
        .unwrap();
    let frequencies_hz = [0.5, 0.7, 0.77, 1.0, 1.3, 2.1];
    let map = harmonic_map(&linear, &frequencies_hz, &[2.0], &mut |_| true).unwrap();
    for (point, g) in map.iter().zip(frequencies_hz) {
        let wanted = 2.0 / (omega * omega * (1.0 - g * g).hypot(2.0 * zeta * g));
        let off = (point.deformation[0] / wanted - 1.0).abs();
        assert!(off < 3e-6, "{off:e} at {g} Hz");
        assert!(point.steady && point.moving_share[0].is_sign_positive());
    }
}

#[test]
fn exact_how_far_a_steady_point_is_from_the_steady_state() {
    // the same closed form over frequencies and damping, as a map states it
    for (zeta, most) in [
        (0.005, 0.34),
        (0.01, 0.1),
        (0.02, 0.02),
        (0.05, 1e-4),
        (0.1, 1e-4),
    ] {
        let storeys = frame(&[(1.0, 1e6, 0.0)], Convention::Drift);
        let omega = TAU;
        let linear = FrictionFrame::new(storeys, vec![omega * omega], vec![StoreyFriction::None])
            .unwrap()
            .with_damping(ViscousDamping::Modal(zeta))
            .unwrap();
        let wide = (0..24).map(|i| 0.1 * 100_f64.powf(f64::from(i) / 23.0));
        let near = (0..40).map(|i| 0.9 + 0.005 * f64::from(i));
        let frequencies_hz: Vec<f64> = wide.chain(near).collect();
        let map = harmonic_map(&linear, &frequencies_hz, &[2.0], &mut |_| true).unwrap();
        let mut steady = 0;
        for point in map.iter().filter(|point| point.steady) {
            let g = point.frequency_hz;
            let wanted = 2.0 / (omega * omega * (1.0 - g * g).hypot(2.0 * zeta * g));
            let off = (point.deformation[0] / wanted - 1.0).abs();
            assert!(off < most, "{off:e} at {g} Hz, damping {zeta}");
            steady += 1;
        }
        assert!(steady > 0 && (zeta < 0.05 || steady == 64), "{steady} at {zeta}");
    }
}

#[test]
fn refuses_more_samples_than_memory_holds() {
    let storeys = frame(&[(1.0, 1.0, 0.0)], Convention::Drift);
    let free = FrictionFrame::new(storeys, vec![1.0], vec![StoreyFriction::None]).unwrap();
    let options = FrameRun {
        duration_s: Some(10.0),
        output_step_s: 1e-300,
        ..FrameRun::default()
    };
    let error = simulate_frame(&free, &FrameLoad::none(), &options, &mut |_| true).unwrap_err();
    assert!(error.to_string().contains("ten million samples"), "{error}");
}
