// SOURCE     closed forms of a mass between springs with a gap (known/gap_spring.rs); a separate fixed-step integration written here.
// GOAL       Tenons with slack make contact, crush, pinch and soften according to their law, and create no energy.
// PARAMETERS in each test.
// TOLERANCE  closed forms 1e-11 of the value (events are located to 1e-12 s); the energy balance 1e-9 of the input, as for frames without
//            tenons; the fixed step of 4 µs 2e-4 of the largest drift, the error of its contacts.

use dolmen::dynamics::{
    FrameHistory, FrameLoad, FrameOutcome, FrameRun, FrictionFrame, Sliders, StoreyFriction, Tenon,
    TimeFunction, ViscousDamping, simulate_frame,
};
use dolmen::known::gap_spring::{crushed_m, period_s};
use dolmen::numeric::Random;
use dolmen::structure::{Convention, Frame, Storey};

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

const LOOSE: Tenon = Tenon {
    slack_m: 0.5,
    stiffness_n_m: 4.0,
    crushing_force_n: None,
    half_stiffness_depth_m: None,
};

/// A mass of 1 kg.
fn mass(within_n_m: f64, friction_n: f64, tenon: Tenon) -> FrictionFrame {
    let friction = vec![StoreyFriction::coulomb(friction_n)];
    let built = FrictionFrame::new(frame(&[1.0]), vec![within_n_m], friction).unwrap();
    built.with_tenons(vec![Some(tenon)]).unwrap()
}

#[test]
fn exact_a_spring_with_slack_swings_slower_the_smaller_it_swings() {
    let mut before_s = 0.0;
    for within in [0.0, 0.3] {
        for amplitude in [3.0, 1.5, 0.7, 0.51] {
            let options = FrameRun {
                duration_s: Some(240.0),
                start_displacement_m: vec![amplitude],
                ..FrameRun::default()
            };
            let history = run(&mass(within, 0.0, LOOSE), &FrameLoad::none(), &options);
            let period = period_s([within, 4.0], 1.0, 0.5, amplitude).unwrap();
            assert!(history.turns.len() >= 2, "{amplitude}");
            for (i, turn) in history.turns.iter().enumerate() {
                let at_s = 0.5 * period * (i + 1) as f64;
                assert!(
                    (turn.at_s / at_s - 1.0).abs() < 1e-11,
                    "{within} {amplitude}: {} {at_s}",
                    turn.at_s
                );
                assert!((turn.displacement_m.abs() / amplitude - 1.0).abs() < 1e-11);
            }
            assert!(amplitude == 3.0 || period > before_s);
            before_s = period;
        }
    }
    // within the slack only the parallel spring acts
    let options = FrameRun {
        duration_s: Some(60.0),
        start_displacement_m: vec![0.4],
        ..FrameRun::default()
    };
    let history = run(&mass(0.3, 0.0, LOOSE), &FrameLoad::none(), &options);
    let half_s = 0.5 * period_s([0.3, 4.0], 1.0, 0.5, 0.4).unwrap();
    assert!((history.turns[0].at_s / half_s - 1.0).abs() < 1e-11);
}

/// Within the slack only the dashpot acts, u = (v0/β) (1 − exp(−β t)) with β = 2 ζ √(k_t/m); in contact the ratio is ζ.
#[test]
fn exact_dashpots_brake_within_a_slack_in_which_nothing_else_holds() {
    let (ratio, speed) = (0.1, 0.1);
    let damped = |within| {
        let frame = mass(within, 0.0, LOOSE);
        frame.with_damping(ViscousDamping::Modal(ratio)).unwrap()
    };
    let options = FrameRun {
        duration_s: Some(5.0),
        start_velocity_m_s: vec![speed],
        ..FrameRun::default()
    };
    let free = damped(0.0);
    let history = run(&free, &FrameLoad::none(), &options);
    let rate = 2.0 * ratio * 2.0;
    let times = history.time_s.iter().zip(&history.displacement_m[0]);
    for (t, u) in times.skip(1) {
        let exact = speed / rate * (1.0 - (-rate * t).exp());
        assert!((u / exact - 1.0).abs() < 1e-11, "{t}: {u} {exact}");
    }
    assert!(history.energy_left_over_ratio() < 1e-12);
    let bearing = free.damping_ratios_bearing().unwrap();
    assert!((bearing[0].unwrap() / ratio - 1.0).abs() < 1e-12, "{bearing:?}");
    // a spring that acts within the slack has a mode there: ζ is its ratio, and ζ √(k/(k + k_t)) in contact
    let sprung = damped(0.5);
    let within = sprung.damping_ratios(Sliders::Stuck).unwrap();
    assert!((within[0].unwrap() / ratio - 1.0).abs() < 1e-12);
    let bearing = sprung.damping_ratios_bearing().unwrap()[0].unwrap();
    assert!((bearing / (ratio * (0.5_f64 / 4.5).sqrt()) - 1.0).abs() < 1e-12);
}

#[test]
fn exact_faces_crush_by_what_the_energy_leaves() {
    let (gap, bearing, crushing, half) = (0.5, 4.0, 2.0, 0.7);
    let tenon = Tenon {
        slack_m: gap,
        stiffness_n_m: bearing,
        crushing_force_n: Some(crushing),
        half_stiffness_depth_m: Some(half),
    };
    for friction in [0.0, 0.15] {
        let options = FrameRun {
            duration_s: Some(12.0),
            output_step_s: 0.01,
            start_velocity_m_s: vec![3.0],
            ..FrameRun::default()
        };
        let history = run(&mass(0.0, friction, tenon), &FrameLoad::none(), &options);
        let crushed = crushed_m(4.5, gap, bearing, [crushing, friction]);
        assert!(crushed > 0.5, "{crushed}");
        let [right, left] = history.tenons[0].unwrap();
        assert!(
            (right.crushed_m / crushed - 1.0).abs() < 1e-11,
            "{right:?} {crushed}"
        );
        assert!((right.gap_m / (gap + crushed) - 1.0).abs() < 1e-11);
        assert!((right.stiffness_n_m / (bearing / (1.0 + crushed / half)) - 1.0).abs() < 1e-11);
        // the energy returned by the spring of one face loads the other face at most to its force
        assert!(
            left.crushed_m < 1e-11 && left.stiffness_n_m > bearing * (1.0 - 1e-10),
            "{left:?}"
        );
        let most = gap + crushing / bearing + crushed;
        assert!((history.turns[0].displacement_m / most - 1.0).abs() < 1e-11);
        let end = history.energy.last().unwrap();
        assert!(
            (end.crushing_j / (crushing * crushed) - 1.0).abs() < 1e-11,
            "{end:?}"
        );
        assert!(history.energy_left_over_ratio() < 1e-12);
    }
}

/// The area under force and drift, by the trapezoidal rule from accelerations and velocities only, compared with the energy of friction,
/// crushing and springs in the run.
#[test]
fn holds_the_area_of_a_pinched_loop_is_what_it_took() {
    let tenon = Tenon {
        crushing_force_n: Some(2.0),
        half_stiffness_depth_m: Some(0.7),
        ..LOOSE
    };
    let loaded = FrameLoad::of_ground(TimeFunction::Harmonic {
        amplitude: 4.0,
        frequency_hz: 0.2,
        phase_rad: 0.3,
    });
    let options = FrameRun {
        duration_s: Some(20.0),
        output_step_s: 1e-4,
        ..FrameRun::default()
    };
    let history = run(&mass(0.2, 0.3, tenon), &loaded, &options);
    let force = |i: usize| -history.acceleration_m_s2[0][i]; // of spring, slider and tenons together
    let power = |i: usize| force(i) * history.velocity_m_s[0][i];
    let work: f64 = (0..history.time_s.len() - 1)
        .map(|i| 0.5 * 1e-4 * (power(i) + power(i + 1)))
        .sum();
    let end = history.energy.last().unwrap();
    let taken = end.stored_j + end.friction_j + end.crushing_j;
    assert!(end.crushing_j > 1.0 && end.friction_j > 1.0, "{end:?}");
    // the force of a slider jumps within a sample; the error of the rule is half of that sample
    assert!((work / taken - 1.0).abs() < 1e-4, "{work} {taken}");
}

struct Drawn {
    frame: FrictionFrame,
    load: FrameLoad,
    /// Every 0.05 s.
    ground: Vec<f64>,
    stiffness: Vec<f64>,
    masses: Vec<f64>,
    tenons: Vec<Option<Tenon>>,
}

/// A frame and a ground, at random.
fn drawn(random: &mut Random, rubs: bool) -> Drawn {
    let n = 1 + (4.0 * random.uniform()) as usize;
    let masses: Vec<f64> = (0..n).map(|_| 0.5 + random.uniform()).collect();
    let stiffness: Vec<f64> = (0..n).map(|_| 20.0 + 200.0 * random.uniform()).collect();
    let tenons: Vec<Option<Tenon>> = (0..n)
        .map(|i| {
            let stiffness_n_m = 50.0 + 800.0 * random.uniform();
            let slack_m = if random.uniform() < 0.2 {
                0.0
            } else {
                0.05 * random.uniform()
            };
            let crushes = random.uniform() < 0.8;
            let softens = random.uniform() < 0.7;
            let depth_m = 0.01 + 0.1 * random.uniform();
            let force_n = stiffness_n_m * 0.05 * random.uniform() + 0.1;
            (i == 0 || random.uniform() < 0.8).then_some(Tenon {
                slack_m,
                stiffness_n_m,
                crushing_force_n: crushes.then_some(force_n),
                half_stiffness_depth_m: (crushes && softens).then_some(depth_m),
            })
        })
        .collect();
    let friction = (0..n).map(|_| {
        let force_n = 0.2 + 3.0 * random.uniform();
        match (rubs, (3.0 * random.uniform()) as usize) {
            (true, 0) => StoreyFriction::coulomb(force_n),
            (true, 1) => StoreyFriction::jenkins(100.0, force_n),
            _ => StoreyFriction::None,
        }
    });
    let friction: Vec<StoreyFriction> = friction.collect();
    let damping = match rubs && random.uniform() < 0.5 {
        true => ViscousDamping::Modal(0.05 * random.uniform()),
        false => ViscousDamping::None,
    };
    let built = FrictionFrame::new(frame(&masses), stiffness.clone(), friction).unwrap();
    let frame = built
        .with_tenons(tenons.clone())
        .unwrap()
        .with_damping(damping)
        .unwrap();
    let ground: Vec<f64> = (0..80).map(|_| 8.0 * random.normal()).collect();
    let load = FrameLoad::of_ground(TimeFunction::Sampled {
        time_step_s: 0.05,
        values: ground.clone(),
    });
    Drawn {
        frame,
        load,
        ground,
        stiffness,
        masses,
        tenons,
    }
}

#[test]
fn holds_no_energy_is_made_in_200_random_frames() {
    let mut random = Random::new(20261127, 0);
    let (mut crushed, mut softened) = (0, 0);
    for case in 0..200 {
        let of = drawn(&mut random, true);
        let options = FrameRun {
            duration_s: Some(8.0),
            ..FrameRun::default()
        };
        let history = run(&of.frame, &of.load, &options);
        let left = history.energy_left_over_ratio();
        assert!(left < 1e-9, "case {case}: {left}");
        for pair in history.energy.windows(2) {
            let most = 1e-12 * pair[1].input_j.abs().max(1e-9);
            assert!(pair[1].crushing_j >= pair[0].crushing_j - most, "case {case}");
            assert!(pair[1].friction_j >= pair[0].friction_j - most, "case {case}");
        }
        for (faces, built) in history.tenons.iter().zip(&of.tenons) {
            let (Some(faces), Some(built)) = (faces, built) else {
                continue;
            };
            for face in faces {
                assert!((face.gap_m - built.slack_m - face.crushed_m).abs() < 1e-12);
                crushed += usize::from(face.crushed_m > 0.0);
                softened += usize::from(face.stiffness_n_m < built.stiffness_n_m);
            }
        }
    }
    assert!(crushed > 200 && softened > 100, "{crushed} {softened}");
}

/// The tenons of one storey in a fixed step: gaps, stiffness and crushed depths of the faces, and which face was in contact in the last step.
struct Stepped {
    law: Tenon,
    gap: [f64; 2],
    stiffness: [f64; 2],
    crushed: [f64; 2],
    bore: [bool; 2],
}

impl Stepped {
    /// Force at a drift: each face separately, as a one-sided elastic-plastic spring.
    fn force(&mut self, drift: f64) -> f64 {
        let mut force = 0.0;
        for (side, sign) in [(0, 1.0), (1, -1.0)] {
            let pressed = sign * drift - self.gap[side];
            if pressed <= 0.0 {
                if self.bore[side] {
                    let half = self.law.half_stiffness_depth_m.unwrap_or(f64::INFINITY);
                    self.stiffness[side] = self.law.stiffness_n_m / (1.0 + self.crushed[side] / half);
                }
                self.bore[side] = false;
                continue;
            }
            self.bore[side] = true;
            let most = self.law.crushing_force_n.unwrap_or(f64::INFINITY);
            let over = pressed - most / self.stiffness[side];
            if over > 0.0 {
                self.gap[side] += over;
                self.crushed[side] += over;
            }
            force += sign * self.stiffness[side] * (pressed - over.max(0.0));
        }
        force
    }
}

/// Largest drifts, and crushed depths of both faces, of a frame without friction, by the semi-implicit Euler rule of step h with forces in the
/// middle (leapfrog).
fn stepped(of: &Drawn, duration_s: f64, h: f64) -> Vec<[f64; 3]> {
    let n = of.masses.len();
    let mut joints: Vec<Option<Stepped>> = of
        .tenons
        .iter()
        .map(|tenon| {
            tenon.map(|law| Stepped {
                law,
                gap: [law.slack_m; 2],
                stiffness: [law.stiffness_n_m; 2],
                crushed: [0.0; 2],
                bore: [false; 2],
            })
        })
        .collect();
    let (mut y, mut v, mut most) = (vec![0.0; n], vec![0.0; n], vec![0.0_f64; n]);
    let steps = (duration_s / h).round() as usize;
    for step in 0..steps {
        let place = (step as f64 + 0.5) * h / 0.05;
        let sample = place as usize;
        let share = place - sample as f64;
        let ground = (1.0 - share) * of.ground[sample] + share * of.ground[sample + 1];
        y.iter_mut().zip(&v).for_each(|(y, v)| *y += 0.5 * h * v);
        let mut forces = vec![0.0; n];
        for i in 0..n {
            let drift = y[i] - if i > 0 { y[i - 1] } else { 0.0 };
            let force = of.stiffness[i] * drift + joints[i].as_mut().map_or(0.0, |of| of.force(drift));
            forces[i] -= force;
            if i > 0 {
                forces[i - 1] += force;
            }
        }
        for i in 0..n {
            v[i] += h * (forces[i] / of.masses[i] - ground);
        }
        y.iter_mut().zip(&v).for_each(|(y, v)| *y += 0.5 * h * v);
        for i in 0..n {
            most[i] = most[i].max((y[i] - if i > 0 { y[i - 1] } else { 0.0 }).abs());
        }
    }
    let crushed = joints
        .iter()
        .map(|of| of.as_ref().map_or([0.0; 2], |of| of.crushed));
    most.into_iter()
        .zip(crushed)
        .map(|(most, [a, b])| [most, a, b])
        .collect()
}

#[test]
fn agrees_with_a_fixed_step_written_apart_in_30_random_frames() {
    let mut random = Random::new(33, 0);
    for case in 0..30 {
        let of = drawn(&mut random, false);
        let options = FrameRun {
            duration_s: Some(2.0),
            ..FrameRun::default()
        };
        let history = run(&of.frame, &of.load, &options);
        let apart = stepped(&of, 2.0, 4e-6);
        let largest = apart.iter().map(|of| of[0]).fold(0.0, f64::max);
        for (i, [most, right, left]) in apart.into_iter().enumerate() {
            let faces = history.tenons[i].map_or([0.0; 2], |faces| faces.map(|face| face.crushed_m));
            let found = [history.drift_peaks[i].value_m.abs(), faces[0], faces[1]];
            for (found, apart) in found.into_iter().zip([most, right, left]) {
                assert!(
                    (found - apart).abs() < 2e-4 * largest,
                    "case {case}, storey {i}: {found} {apart} of {largest}"
                );
            }
        }
    }
}

#[test]
fn exact_a_frame_rests_where_spring_and_tenon_hold_the_force() {
    let damped = |within, tenon| {
        mass(within, 0.0, tenon)
            .with_damping(ViscousDamping::Dashpots(vec![2.0]))
            .unwrap()
    };
    let pushed = |force_n| FrameLoad {
        forces_n: vec![TimeFunction::Constant(force_n)],
        ..FrameLoad::none()
    };
    let options = FrameRun {
        duration_s: Some(1.0),
        ..FrameRun::default()
    };
    // beyond the slack: k y + k_t (y − g) = F, on both sides; within it k y = F
    for (force, rest) in [(2.0, (2.0 + 2.0) / 5.0), (-2.0, -(2.0 + 2.0) / 5.0), (0.3, 0.3)] {
        let history = run(&damped(1.0, LOOSE), &pushed(force), &options);
        assert!(
            (history.rest_m[0] - rest).abs() < 1e-12,
            "{:?} {rest}",
            history.rest_m
        );
    }
}

#[test]
fn refuses_tenons_that_cannot_be() {
    let plain = FrictionFrame::new(frame(&[1.0]), vec![1.0], vec![StoreyFriction::None]).unwrap();
    let refused = |tenon: Tenon| {
        plain
            .clone()
            .with_tenons(vec![Some(tenon)])
            .unwrap_err()
            .to_string()
    };
    assert_eq!(
        refused(Tenon {
            slack_m: -0.1,
            ..LOOSE
        }),
        "storey 1: slack_m is -0.1, but must be 0 or a positive number"
    );
    assert_eq!(
        refused(Tenon {
            stiffness_n_m: 0.0,
            ..LOOSE
        }),
        "storey 1: stiffness_n_m is 0, but must be a positive number"
    );
    assert_eq!(
        refused(Tenon {
            crushing_force_n: Some(f64::NAN),
            ..LOOSE
        }),
        "storey 1: crushing_force_n is NaN, but must be a positive number"
    );
    let error = plain.with_tenons(Vec::new()).unwrap_err().to_string();
    assert_eq!(
        error,
        "tenons has 0 entries, but the frame has 1 storeys: give one for each"
    );
}
