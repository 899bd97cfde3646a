// SOURCE     Den Hartog (1931); Jenkins (1962); Park and Min (2010) with El Centro 1940 NS.
// GOAL       A frame with dry friction moves exactly by Coulomb's law: decay, steady states, loops, earthquakes.
// PARAMETERS in each test.
// AGREES     the two-storey run with an event-by-event solution of another program (1e-12 s events): peaks, residuals and
//            number of events as on the theory page of the project.
// TOLERANCE  closed forms 1e-12 of the amplitude; steady-state amplitudes 1e-9 after the transient; printed numbers half
//            a unit of their last digit.

use approx::assert_relative_eq;
use dolmen::dynamics::{
    FrameHistory, FrameLoad, FrameOutcome, FrameRun, FrictionActsOn, FrictionFrame, StoreyFriction,
    TimeFunction, ViscousDamping, amplitude_dependence, harmonic_map, simulate_frame,
};
use dolmen::known::dry_friction::{forced_amplitude, free_decay_turns_m, jenkins_loop_energy_j};
use dolmen::numeric::Random;
use dolmen::structure::{Convention, Frame, Storey};
use std::f64::consts::TAU;

fn frame(masses_kg: &[f64]) -> Frame {
    let storey = |&mass_kg: &f64| Storey {
        mass_kg,
        height_m: 1e6, // drifts of any size are small
        axial_n: 0.0,
    };
    Frame::new(masses_kg.iter().map(storey).collect(), Convention::Drift).unwrap()
}

fn run(frame: &FrictionFrame, load: &FrameLoad, options: &FrameRun) -> FrameHistory {
    let history = simulate_frame(frame, load, options, &mut |_| true).unwrap();
    assert_eq!(history.outcome, FrameOutcome::Finished);
    history
}

/// m = k = 1, f = 1.
fn oscillator(slip_force_n: f64) -> FrictionFrame {
    FrictionFrame::new(
        frame(&[1.0]),
        vec![1.0],
        vec![StoreyFriction::coulomb(slip_force_n)],
    )
    .unwrap()
}

fn released(displacement_m: f64, duration_s: f64) -> FrameRun {
    FrameRun {
        duration_s: Some(duration_s),
        output_step_s: 0.1,
        start_displacement_m: vec![displacement_m],
        ..FrameRun::default()
    }
}

#[test]
fn exact_free_decay_loses_four_slips_a_cycle() {
    for start in [10.0, 9.3, -7.7, 0.99] {
        let history = run(&oscillator(1.0), &FrameLoad::none(), &released(start, 30.0));
        let turns = free_decay_turns_m(start, 1.0, 1.0);
        // one slip per half cycle, each from one turning point to the next
        assert_eq!(history.slips.len(), turns.len() - 1, "from {start}");
        for (slip, pair) in history.slips.iter().zip(turns.windows(2)) {
            assert!(
                (slip.slip_m - (pair[1] - pair[0])).abs() < 1e-12,
                "{slip:?} for {pair:?}"
            );
            assert!((slip.to_s - slip.from_s - 0.5 * TAU).abs() < 1e-12);
        }
        assert!((history.residual_m[0] - turns.last().unwrap()).abs() < 1e-12);
        assert!(history.at_rest);
        assert!(history.energy_left_over_ratio() < 1e-13);
    }
}

#[test]
fn exact_static_friction_holds_until_its_own_force() {
    // k = 1, f_k = 1, f_s = 2.5: from 3 it moves to −1 and stays there, since 1 < 2.5
    let friction = StoreyFriction::Coulomb {
        static_force_n: 2.5,
        kinetic_force_n: 1.0,
    };
    let sticky = FrictionFrame::new(frame(&[1.0]), vec![1.0], vec![friction]).unwrap();
    let history = run(&sticky, &FrameLoad::none(), &released(3.0, 20.0));
    assert!((history.residual_m[0] + 1.0).abs() < 1e-13);
    assert_eq!(history.slips.len(), 1);
    // from 2.4 it does not move at all
    let history = run(&sticky, &FrameLoad::none(), &released(2.4, 20.0));
    assert_eq!((history.residual_m[0], history.events), (2.4, 0));
}

#[test]
fn exact_steady_amplitudes_of_den_hartog() {
    for (g, r) in [(0.6, 0.3), (0.9, 0.5), (1.5, 0.5), (3.0, 0.4)] {
        // P = 1, k = 1, m = 1: ω_n = 1. First as a force on the mass, then as a moving base
        let sine = |amplitude| TimeFunction::Harmonic {
            amplitude,
            frequency_hz: g / TAU,
            phase_rad: 0.0,
        };
        let force = FrameLoad {
            ground_acceleration_m_s2: TimeFunction::Zero,
            forces_n: vec![sine(1.0)],
        };
        for load in [force, FrameLoad::of_ground(sine(-1.0))] {
            // only friction damps the transient
            let cycles = 400.0;
            let options = FrameRun {
                duration_s: Some(cycles * TAU / g),
                output_step_s: TAU / g,
                ..FrameRun::default()
            };
            let history = run(&oscillator(r), &load, &options);
            // a slip between turning points is twice the amplitude
            let last: Vec<f64> = history
                .slips
                .iter()
                .rev()
                .skip(1)
                .take(4)
                .map(|s| 0.5 * s.slip_m.abs())
                .collect();
            for amplitude in last {
                assert_relative_eq!(amplitude, forced_amplitude(g, r).unwrap(), max_relative = 1e-9);
            }
            assert!(history.energy_left_over_ratio() < 1e-9);
        }
    }
}

#[test]
fn exact_loop_of_a_jenkins_element() {
    // no parallel spring, and an inertia that moves the slider through ±1.5: force = k_s = 2, f = 1
    let element = StoreyFriction::jenkins(2.0, 1.0);
    // a heavy mass on its own stiff spring oscillates at 1 rad/s with 1.5, hardly slowed by the element
    let mass = 1e12;
    let heavy = FrictionFrame::new(frame(&[mass]), vec![mass], vec![element]).unwrap();
    let history = run(&heavy, &FrameLoad::none(), &released(1.5, 19.0));
    let mut taken = Vec::new();
    for cycle in 1..3 {
        let at = |t: f64| history.energy[(t * TAU / 0.1).ceil() as usize].friction_j;
        taken.push(at(cycle as f64 + 1.0) - at(cycle as f64));
    }
    for taken in taken {
        // the samples are up to 0.03 s from the reversal, during which the slider sticks
        assert!(
            (taken - jenkins_loop_energy_j(1.5, 2.0, 1.0)).abs() < 1e-8,
            "{taken}"
        );
    }
}

#[test]
fn exact_jenkins_beside_a_spring_changes_its_frequency() {
    // for forces below that of the slider: √((k + k_s)/m); far above it: √(k/m)
    let frame =
        FrictionFrame::new(frame(&[1.0]), vec![1.0], vec![StoreyFriction::jenkins(3.0, 1.0)]).unwrap();
    let turns = |start: f64| {
        let history = run(&frame, &FrameLoad::none(), &released(start, 4.0 * TAU));
        let v = &history.velocity_m_s[0];
        v.windows(2).filter(|w| w[0] < 0.0 && w[1] >= 0.0).count()
    };
    assert_eq!(turns(0.33), 8); // 2 rad/s
    assert_eq!(turns(1000.0), 4); // 1 rad/s
}

fn el_centro(gravity: f64) -> TimeFunction {
    let text = include_str!("../../../../data/el_centro_1940_ns/el_centro_1940_ns.csv");
    let samples = text
        .lines()
        .skip(1)
        .map(|line| gravity * line.split_once(',').unwrap().1.parse::<f64>().unwrap());
    TimeFunction::Sampled {
        time_step_s: 0.02,
        values: samples.collect(),
    }
}

/// The two storeys of the theory page: κ is the stiffness after P-delta, so the axial forces enter only the friction.
fn two_storeys(friction_coefficient: f64) -> FrictionFrame {
    let friction = [5919e3, 3077e3]
        .map(|n| StoreyFriction::coulomb(friction_coefficient * n))
        .to_vec();
    let kappa = vec![184_170_010.214_826_73, 16_447_964.437_896_422];
    FrictionFrame::new(frame(&[290e3, 314e3]), kappa, friction).unwrap()
}

#[test]
fn agrees_two_storeys_in_el_centro() {
    let options = FrameRun {
        duration_s: Some(40.0),
        ..FrameRun::default()
    };
    let history = run(
        &two_storeys(0.03),
        &FrameLoad::of_ground(el_centro(9.81)),
        &options,
    );
    let peak = |p: f64, wanted_mm: f64, half_unit_mm: f64| {
        assert!(
            (1e3 * p.abs() - wanted_mm).abs() < half_unit_mm,
            "{} for {wanted_mm}",
            1e3 * p
        );
    };
    peak(history.displacement_peaks[1].value_m, 131.8980, 0.5e-4);
    peak(history.displacement_peaks[1].at_samples_m, 131.88788603, 1e-8);
    peak(history.drift_peaks[0].value_m, 13.63166081, 1e-8);
    peak(history.drift_peaks[1].value_m, 118.49225195, 1e-8);
    assert!((1e3 * history.residual_m[0] + 0.02959318).abs() < 1e-8);
    assert!((1e3 * history.residual_m[1] + 1.12483637).abs() < 1e-8);
    assert!((1e3 * (history.residual_m[1] - history.residual_m[0]) + 1.09524319).abs() < 1e-8);
    assert_eq!(history.events, 390);
    assert!(history.at_rest);
    assert!(
        history.energy_left_over_ratio() < 1e-9,
        "{}",
        history.energy_left_over_ratio()
    );
}

#[test]
fn holds_stuck_from_rest_while_the_shaking_is_small() {
    // Σ_{j≥i} m_j a ≤ f_i in both storeys
    let frame = two_storeys(0.5);
    let history = run(
        &frame,
        &FrameLoad::of_ground(el_centro(9.81)),
        &FrameRun::default(),
    );
    assert_eq!(history.events, 0);
    assert!(history.displacement_m.iter().flatten().all(|y| *y == 0.0));
}

#[test]
fn holds_eq_11_rubs_on_the_displacement() {
    // with sliders between levels and to the ground the two definitions differ, except for one storey
    let load = FrameLoad::of_ground(el_centro(9.81));
    let on_drift = run(&two_storeys(0.03), &load, &FrameRun::default());
    let on_displacement = run(
        &two_storeys(0.03).acting_on(FrictionActsOn::Displacement),
        &load,
        &FrameRun::default(),
    );
    assert!(on_displacement.energy_left_over_ratio() < 1e-9);
    let peaks = [&on_drift, &on_displacement].map(|h| h.displacement_peaks[1].value_m.abs());
    assert!((peaks[0] - peaks[1]).abs() > 1e-3, "{peaks:?}");
    let one = |acts_on| {
        let frame =
            FrictionFrame::new(frame(&[290e3]), vec![2e7], vec![StoreyFriction::coulomb(1e5)]).unwrap();
        run(&frame.acting_on(acts_on), &load, &FrameRun::default())
    };
    assert_eq!(one(FrictionActsOn::Drift), one(FrictionActsOn::Displacement));
}

#[test]
fn holds_twenty_storeys_balance_their_energy() {
    let n = 20;
    let frame = FrictionFrame::new(
        frame(&vec![200e3; n]),
        (0..n).map(|i| 3e8 - 1e7 * i as f64).collect(),
        (0..n)
            .map(|i| StoreyFriction::coulomb(3e3 * (n - i) as f64))
            .collect(),
    )
    .unwrap();
    for damping in [ViscousDamping::None, ViscousDamping::Modal(0.02)] {
        let frame = frame.clone().with_damping(damping).unwrap();
        let options = FrameRun {
            duration_s: Some(40.0),
            ..FrameRun::default()
        };
        let history = run(&frame, &FrameLoad::of_ground(el_centro(9.81)), &options);
        assert!(history.events > 500, "{}", history.events);
        assert!(
            history.energy_left_over_ratio() < 1e-9,
            "{}",
            history.energy_left_over_ratio()
        );
    }
}

/// Moreau's time stepping of the same equations, first order in its step: a second method without events.
fn stepped(frame: &FrictionFrame, slip_n: &[f64], load: &TimeFunction, duration_s: f64, h: f64) -> Vec<f64> {
    let n = slip_n.len();
    let masses: Vec<f64> = frame.frame().storeys().iter().map(|s| s.mass_kg).collect();
    let k = frame.frame().stiffness_matrix(frame.stiffness_n_m()).unwrap();
    let TimeFunction::Sampled { time_step_s, values } = load else {
        panic!()
    };
    let ground = |t: f64| {
        let i = (t / time_step_s) as usize;
        let part = t / time_step_s - i as f64;
        let value = |i| values.get(i).copied().unwrap_or(0.0);
        value(i) + part * (value(i + 1) - value(i))
    };
    let (mut y, mut v, mut q) = (vec![0.0; n], vec![0.0; n], vec![0.0; n]);
    for step in 0..(duration_s / h).round() as usize {
        let middle: Vec<f64> = y.iter().zip(&v).map(|(y, v)| y + 0.5 * h * v).collect();
        let a = ground((step as f64 + 0.5) * h);
        let free: Vec<f64> = (0..n)
            .map(|i| {
                let spring: f64 = (0..n).map(|j| k[(i, j)] * middle[j]).sum();
                v[i] - h * (a + spring / masses[i])
            })
            .collect();
        // impulses of friction: projected Gauss and Seidel on v = free − h M⁻¹ Bᵀ q
        for _ in 0..200 {
            let mut change = 0.0_f64;
            for i in 0..n {
                let at = |l: usize| {
                    let above = if l + 1 < n { q[l + 1] } else { 0.0 };
                    free[l] - h * (q[l] - above) / masses[l]
                };
                let drift = at(i) - if i > 0 { at(i - 1) } else { 0.0 };
                let flexibility = 1.0 / masses[i] + if i > 0 { 1.0 / masses[i - 1] } else { 0.0 };
                let next = (q[i] + drift / (h * flexibility)).clamp(-slip_n[i], slip_n[i]);
                change = change.max((next - q[i]).abs() / slip_n[i]);
                q[i] = next;
            }
            if change < 1e-10 {
                break;
            }
        }
        for i in 0..n {
            let above = if i + 1 < n { q[i + 1] } else { 0.0 };
            v[i] = free[i] - h * (q[i] - above) / masses[i];
            y[i] += h * 0.5 * (v[i] + (middle[i] - y[i]) / (0.5 * h));
        }
    }
    y
}

#[test]
fn agrees_five_storeys_with_time_stepping() {
    let masses = [40e3, 35e3, 30e3, 20e3, 10e3];
    let stiffness = vec![9e6, 8e6, 9e6, 5e6, 3e6];
    // its own weight times one coefficient: all storeys reach their limits together
    let above = |i: usize| masses[i..].iter().sum::<f64>();
    let slip: Vec<f64> = (0..5).map(|i| 0.05 * 9.81 * above(i)).collect();
    let friction = slip.iter().map(|f| StoreyFriction::coulomb(*f)).collect();
    let frame = FrictionFrame::new(frame(&masses), stiffness, friction).unwrap();
    let ground = el_centro(9.81);
    let options = FrameRun {
        duration_s: Some(6.0),
        ..FrameRun::default()
    };
    let exact = run(&frame, &FrameLoad::of_ground(ground.clone()), &options).residual_m;
    let error = |h: f64| {
        let found = stepped(&frame, &slip, &ground, 6.0, h);
        let most = exact.iter().fold(0.0_f64, |m, y| m.max(y.abs()));
        found
            .iter()
            .zip(&exact)
            .map(|(a, b)| (a - b).abs())
            .fold(0.0, f64::max)
            / most
    };
    let (coarse, fine) = (error(2e-4), error(2.5e-5));
    assert!(fine < 1e-3, "{coarse} {fine}");
    assert!(fine < 0.3 * coarse, "{coarse} {fine}");
}

#[test]
fn holds_coulombs_law_in_random_frames() {
    let mut random = Random::new(11, 0);
    let mut events = 0;
    for _ in 0..60 {
        let n = 1 + (12.0 * random.uniform()) as usize;
        let masses: Vec<f64> = (0..n).map(|_| 10e3 * (1.0 + 9.0 * random.uniform())).collect();
        let above = |i: usize| masses[i..].iter().sum::<f64>();
        let stiffness: Vec<f64> = (0..n)
            .map(|i| above(i) * 10f64.powf(1.0 + 2.0 * random.uniform()))
            .collect();
        let mu = 0.2 * random.uniform();
        let kinetic = if random.uniform() < 0.5 { 1.0 } else { 0.8 };
        let friction: Vec<StoreyFriction> = (0..n)
            .map(|i| {
                let static_force_n = mu * 9.81 * above(i);
                let kinetic_force_n = kinetic * static_force_n;
                match (4.0 * random.uniform()) as usize {
                    0 => StoreyFriction::None,
                    1 => StoreyFriction::Jenkins {
                        stuck_stiffness_n_m: stiffness[i] * (0.2 + 5.0 * random.uniform()),
                        static_force_n,
                        kinetic_force_n,
                    },
                    _ => StoreyFriction::Coulomb {
                        static_force_n,
                        kinetic_force_n,
                    },
                }
            })
            .collect();
        let acts_on = if random.uniform() < 0.7 {
            FrictionActsOn::Drift
        } else {
            FrictionActsOn::Displacement
        };
        let damping = match (4.0 * random.uniform()) as usize {
            0 => ViscousDamping::Modal(0.1 * random.uniform()),
            1 => ViscousDamping::Rayleigh {
                mass_per_s: 0.2 * random.uniform(),
                stiffness_s: 0.01 * random.uniform(),
            },
            2 => ViscousDamping::Dashpots(stiffness.iter().map(|k| 0.005 * k).collect()),
            _ => ViscousDamping::None,
        };
        let frame = FrictionFrame::new(frame(&masses), stiffness, friction.clone())
            .unwrap()
            .acting_on(acts_on)
            .with_damping(damping)
            .unwrap();
        let options = FrameRun {
            duration_s: Some(8.0),
            ..FrameRun::default()
        };
        let history = run(&frame, &FrameLoad::of_ground(el_centro(9.81)), &options);
        events += history.events;
        assert!(
            history.energy_left_over_ratio() < 1e-9,
            "{}",
            history.energy_left_over_ratio()
        );
        for (i, friction) in friction.iter().enumerate() {
            let (StoreyFriction::Coulomb {
                static_force_n,
                kinetic_force_n,
            }
            | StoreyFriction::Jenkins {
                static_force_n,
                kinetic_force_n,
                ..
            }) = *friction
            else {
                continue;
            };
            let coulomb = matches!(friction, StoreyFriction::Coulomb { .. });
            for sample in 0..history.time_s.len() {
                let lower = if acts_on == FrictionActsOn::Drift && i > 0 {
                    history.velocity_m_s[i - 1][sample]
                } else {
                    0.0
                };
                let speed = history.velocity_m_s[i][sample] - lower;
                let force = history.friction_force_n[i][sample];
                assert!(force.abs() <= static_force_n * (1.0 + 1e-9));
                if coulomb && speed.abs() > 1e-9 {
                    assert!((force - kinetic_force_n * speed.signum()).abs() <= 1e-9 * kinetic_force_n);
                }
            }
        }
    }
    assert!(events > 5000, "{events}");
}

#[test]
fn exact_apparent_frequency_and_damping_of_a_release() {
    // Coulomb: each half cycle takes half the natural period and reduces the amplitude by 2 f/k
    let found = amplitude_dependence(&oscillator(0.1), 2.0).unwrap();
    assert!(found.len() > 5);
    for (j, at) in found.iter().enumerate() {
        let amplitude = 2.0 - 0.1 - 0.2 * j as f64;
        // the mean of the two half cycles before and after the loss: (2/π) f/(k A) there, to first order
        let mean = amplitude - 0.1;
        assert!((at.amplitude_m - mean).abs() < 1e-12, "{at:?}");
        let of_energy = 2.0 / std::f64::consts::PI * 0.1 / mean;
        assert!(
            (at.equivalent_damping_ratio / of_energy - 1.0).abs() < 0.4 * (0.2 / mean).powi(2) + 0.02,
            "{at:?}"
        );
        assert!((at.apparent_frequency_hz - 1.0 / TAU).abs() < 1e-12);
        let loss = (amplitude / (amplitude - 0.2)).ln();
        let ratio = loss / std::f64::consts::PI.hypot(loss);
        assert!((at.equivalent_damping_ratio - ratio).abs() < 1e-12);
    }
    // a Jenkins element parallel to a spring: from √k at large amplitude up to √(k + k_s)
    let jenkins =
        FrictionFrame::new(frame(&[1.0]), vec![1.0], vec![StoreyFriction::jenkins(3.0, 1.0)]).unwrap();
    let found = amplitude_dependence(&jenkins, 60.0).unwrap();
    assert!(
        (found[0].apparent_frequency_hz * TAU - 1.0).abs() < 0.01,
        "{:?}",
        found[0]
    );
    let frequencies: Vec<f64> = found.iter().map(|a| a.apparent_frequency_hz * TAU).collect();
    assert!(
        frequencies.windows(2).all(|w| w[1] > w[0] - 1e-9),
        "{frequencies:?}"
    );
    assert!(
        (frequencies.last().unwrap() - 2.0).abs() < 1e-9,
        "{frequencies:?}"
    );
}

#[test]
fn refuses_to_read_swings_of_a_frame_that_falls() {
    let falling = |own: f64, stuck: f64| {
        let storey = Storey {
            mass_kg: 1.0,
            height_m: 1.0,
            axial_n: 2.0,
        };
        let frame = Frame::new(vec![storey], Convention::Drift).unwrap();
        let friction = StoreyFriction::jenkins(stuck, 0.05);
        let frame = FrictionFrame::new(frame, vec![own], vec![friction]).unwrap();
        amplitude_dependence(&frame, 0.05).unwrap_err().to_string()
    };
    assert!(
        falling(0.5, 1.0).starts_with("the frame cannot be let go from 0.05 m: it falls as it stands"),
        "{}",
        falling(0.5, 1.0)
    );
    // it is stable while it sticks, and falls after the slider has slipped
    let said = falling(0.5, 2.0);
    assert!(
        said.starts_with("let go from 0.05 m, storey 1 of the frame leans beyond"),
        "{said}"
    );
}

#[test]
fn exact_map_of_sticking_and_slipping() {
    // one storey sticks while m a ≤ f, whatever the frequency; above, the amplitude is Den Hartog's
    let (f, g) = (0.3, 0.6);
    let map = harmonic_map(&oscillator(f), &[g / TAU, 1.5 / TAU], &[0.29, 1.0], &mut |_| true).unwrap();
    assert_eq!(map.len(), 4);
    for still in [&map[0], &map[2]] {
        assert_eq!((still.deformation[0], still.moving_share[0]), (0.0, 0.0));
    }
    assert!(map[1].steady && (map[1].moving_share[0] - 1.0).abs() < 1e-9);
    // 40 samples per cycle miss the peak by at most (π/40)²/2
    let wanted = forced_amplitude(g, f).unwrap();
    assert!(
        (map[1].deformation[0] / wanted - 1.0).abs() < 4e-3,
        "{:?}",
        map[1]
    );
}
