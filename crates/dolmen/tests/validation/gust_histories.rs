// SOURCE     Shinozuka & Deodatis (1991); Davenport (1964); the mean square of `gust_motion`; Runge and Kutta's fourth order.
// GOAL       Histories of a turbulent wind have the cross spectra of the face, give the same motion of a structure and its dampers as time
//            stepping, and have the variances of the integral and Davenport's peaks.
// PARAMETERS one mass, one strip; a twisting floor with a damper of every kind under two strips.
// TOLERANCE  time stepping: 2e-5 of the largest value, the error of its steps of 10 ms. Variances: 2 %, three times their scatter over the
//            simulated length. Peaks: 3 %, the error of Davenport's limit for a process with about 300 crossings.

use dolmen::damper::{
    AttachedDamper, DampedSystem, DamperError, DamperKind, GustQuantity, GustRow, gust_history, gust_motion,
    gust_times,
};
use dolmen::dynamics::LinearSystem;
use dolmen::structure::wind::{
    COHERENCE_DECAY, GustDraw, GustFace, GustStrip, GustTimes, Turbulence, TurbulenceSpectrum,
};
use dolmen_linalg::{Matrix, solve};
use std::f64::consts::TAU;

const TEN_MINUTES_S: f64 = 600.0;

fn face(heights_m: &[[f64; 2]]) -> GustFace {
    let strip = |&[bottom_m, top_m]: &[f64; 2]| GustStrip {
        bottom_m,
        top_m,
        breadth_m: 12.0,
        force_coefficient: 1.3,
        wind: Turbulence {
            mean_speed_m_s: 20.0 + 0.3 * top_m,
            intensity: 0.18,
            length_m: 90.0,
        },
    };
    GustFace {
        strips: heights_m.iter().map(strip).collect(),
        air_density_kg_m3: 1.25,
        spectrum: TurbulenceSpectrum::Kaimal,
        coherence_decay: COHERENCE_DECAY,
    }
}

fn draws(count: u64) -> Vec<GustDraw> {
    (1..=count).map(|seed| GustDraw { seed, stream: 0 }).collect()
}

fn mass(kg: f64, hz: f64, zeta: f64) -> LinearSystem {
    let omega = TAU * hz;
    let one = |x: f64| Matrix::from_diagonal(&[x]);
    LinearSystem::new(one(kg), one(2.0 * zeta * omega * kg), one(kg * omega * omega)).unwrap()
}

fn of_mass(quantity: GustQuantity) -> GustRow {
    GustRow {
        case: 0,
        row: vec![1.0],
        quantity,
    }
}

fn twisting() -> LinearSystem {
    let (m, inertia) = (2e5, 2e5 * 14.0);
    let k = Matrix::from_rows(&[[4e6, 0.0, 6e5], [0.0, 3e6, -2e6], [6e5, -2e6, 6e7]]);
    let mass = Matrix::from_diagonal(&[m, m, inertia]);
    LinearSystem::new(mass.clone(), k.scaled(0.02), k).unwrap()
}

fn dampers() -> Vec<AttachedDamper> {
    let row = |x: f64, y: f64, angle: f64| vec![angle.cos(), angle.sin(), x * angle.sin() - y * angle.cos()];
    let kinds = [
        DamperKind::TunedMass {
            mass_kg: 4e3,
            frequency_hz: 0.63,
            damping_ratio: 0.1,
        },
        DamperKind::LiquidColumn {
            liquid_mass_kg: 3e3,
            length_ratio: 0.7,
            frequency_hz: 0.7,
            damping_ratio: 0.08,
        },
        DamperKind::LiquidColumnMass {
            container_mass_kg: 1e3,
            liquid_mass_kg: 2e3,
            length_ratio: 0.6,
            frequency_hz: 0.6,
            damping_ratio: 0.1,
            liquid_frequency_hz: 0.8,
            liquid_damping_ratio: 0.07,
        },
        DamperKind::Viscous {
            coefficient_n_s_m: 2e4,
        },
    ];
    let rows = [
        row(3.0, 1.0, 1.2),
        row(-2.0, 2.0, 0.2),
        row(1.0, -3.0, 1.5),
        row(4.0, 0.0, 1.57),
    ];
    let pairs = kinds.into_iter().zip(rows);
    pairs.map(|(kind, row)| AttachedDamper { kind, row }).collect()
}

#[test]
fn agrees_with_stepping_in_time_for_dampers_of_every_kind() {
    let (structure, dampers) = (twisting(), dampers());
    let face = face(&[[3.0, 6.0], [6.0, 11.0]]);
    let columns = vec![vec![vec![1.0, 0.0, -0.8], vec![1.0, 0.2, 0.5]]];
    // a period of two minutes: the transient from rest is then 1e-8 of the largest value
    let times = GustTimes {
        time_step_s: 0.02,
        samples: 6000,
        looked_at: 6000,
    };
    let gusts = &face.histories(&times, &draws(1)).unwrap()[0];
    let rows: Vec<GustRow> = [GustQuantity::Displacement, GustQuantity::Acceleration]
        .into_iter()
        .map(|quantity| GustRow {
            case: 0,
            row: vec![0.3, 1.0, 2.0],
            quantity,
        })
        .collect();
    let history = gust_history(&structure, &dampers, &columns, &rows, gusts).unwrap();
    let damped = DampedSystem::new(&structure, &dampers).unwrap();
    let system = &damped.system;
    let n = system.degrees_of_freedom();
    let inverse = |of: &Matrix| solve(system.mass(), of).unwrap();
    let (stiffness, damping) = (inverse(system.stiffness()), inverse(system.damping()));
    let loads: Vec<Vec<f64>> = columns[0]
        .iter()
        .map(|column| {
            inverse(&Matrix::from_column(&damped.row(column)))
                .column(0)
                .to_vec()
        })
        .collect();
    // forces twice a step, one period
    let (step_s, steps) = (0.01, 12_000);
    let forces: Vec<Vec<f64>> = (0..2 * steps)
        .map(|k| gusts.at_n(0.5 * step_s * k as f64))
        .collect();
    let rate = |state: &[f64], forces: &[f64]| -> Vec<f64> {
        let (x, v) = state.split_at(n);
        let (pulled, slowed) = (stiffness.times(x), damping.times(v));
        let pushed = (0..n).map(|i| {
            let load: f64 = forces
                .iter()
                .zip(&loads)
                .map(|(force, load)| force * load[i])
                .sum();
            load - pulled[i] - slowed[i]
        });
        v.iter().copied().chain(pushed).collect()
    };
    let moved = |state: &[f64], by: f64, rate: &[f64]| -> Vec<f64> {
        state.iter().zip(rate).map(|(x, r)| x + by * r).collect()
    };
    let stroke_rows = damped.stroke_rows();
    let row = damped.row(&rows[0].row);
    let along = |row: &[f64], x: &[f64]| -> f64 { row.iter().zip(x).map(|(a, x)| a * x).sum() };
    let mut state = vec![0.0; 2 * n];
    let mut apart = vec![0.0_f64; 2 + stroke_rows.len()];
    for k in 0..2 * steps {
        let force = |half: usize| &forces[(2 * k + half) % (2 * steps)];
        let first = rate(&state, force(0));
        if k >= steps && k % 2 == 0 {
            let sample = (k - steps) / 2;
            let mut found = vec![along(&row, &state[..n]), along(&row, &first[n..])];
            found.extend(stroke_rows.iter().map(|row| along(row, &state[..n])));
            let expected = history.values.iter().chain(&history.strokes[0]);
            for ((apart, found), expected) in apart.iter_mut().zip(found).zip(expected) {
                *apart = apart.max((found - expected[sample]).abs());
            }
        }
        let second = rate(&moved(&state, 0.5 * step_s, &first), force(1));
        let third = rate(&moved(&state, 0.5 * step_s, &second), force(1));
        let fourth = rate(&moved(&state, step_s, &third), force(2));
        for i in 0..2 * n {
            state[i] += step_s / 6.0 * (first[i] + 2.0 * second[i] + 2.0 * third[i] + fourth[i]);
        }
    }
    assert_eq!(history.strokes[0].len(), 5);
    let all = history.values.iter().chain(&history.strokes[0]);
    for (k, (values, apart)) in all.zip(&apart).enumerate() {
        let most = values.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        assert!(apart / most < 2e-5, "{k}: {apart} of {most}");
    }
}

#[test]
fn agrees_with_the_integral_in_a_long_history() {
    // 100 hours: variances scatter by 0.6 %
    let face = face(&[[4.0, 9.0]]);
    let columns = vec![vec![vec![1.0]]];
    let rows = [GustQuantity::Displacement, GustQuantity::Acceleration].map(of_mass);
    let times = GustTimes {
        time_step_s: 0.1,
        samples: 900_000,
        looked_at: 900_000,
    };
    let all = face.histories(&times, &draws(4)).unwrap();
    for (hz, zeta) in [(0.5, 0.02), (0.2, 0.05)] {
        let structure = mass(2e5, hz, zeta);
        let motion = &gust_motion(&structure, &[], &face, &columns, TEN_MINUTES_S).unwrap()[0];
        let mut variances = [0.0; 2];
        for gusts in &all {
            let history = gust_history(&structure, &[], &columns, &rows, gusts).unwrap();
            for ((sum, values), row) in variances.iter_mut().zip(&history.values).zip(&rows) {
                let mean = motion.of(row).mean;
                let squares: f64 = values.iter().map(|x| (x - mean).powi(2)).sum();
                *sum += squares / (values.len() * all.len()) as f64;
            }
        }
        for (variance, row) in variances.iter().zip(&rows) {
            let ratio = variance / motion.of(row).rms.powi(2);
            assert!((ratio - 1.0).abs() < 0.02, "{hz} {:?}: {ratio}", row.quantity);
        }
    }
}

#[test]
fn agrees_with_davenport_in_the_mean_of_many_peaks() {
    // 600 times ten minutes, peaks to one side, as Davenport counts them
    let face = face(&[[4.0, 9.0]]);
    // an acceleration at 10 %: lightly damped motion comes in groups, and slow motion has fewer independent peaks than crossings
    let structure = mass(2e5, 0.5, 0.1);
    let columns = vec![vec![vec![1.0]]];
    let rows = [GustQuantity::Acceleration].map(of_mass);
    let motion = &gust_motion(&structure, &[], &face, &columns, TEN_MINUTES_S).unwrap()[0];
    let times = GustTimes {
        time_step_s: 0.05,
        samples: 1_200_000,
        looked_at: 1_200_000,
    };
    let all = face.histories(&times, &draws(6)).unwrap();
    for (k, row) in rows.iter().enumerate() {
        let peak = motion.of(row);
        let mut factors = Vec::new();
        for gusts in &all {
            let history = gust_history(&structure, &[], &columns, &rows, gusts).unwrap();
            for window in history.values[k].chunks_exact(12_000) {
                let most = window.iter().copied().fold(f64::MIN, f64::max);
                factors.push((most - peak.mean) / peak.rms);
            }
        }
        let mean = factors.iter().sum::<f64>() / factors.len() as f64;
        let ratio = mean / peak.peak_factor;
        assert!(
            (ratio - 1.0).abs() < 0.03,
            "{:?}: {mean} {}",
            row.quantity,
            peak.peak_factor
        );
    }
}

#[test]
fn holds_two_strips_vary_together_as_their_cross_spectra_say() {
    let face = face(&[[3.0, 6.0], [20.0, 24.0]]);
    let times = GustTimes {
        time_step_s: 0.25,
        samples: 240_000,
        looked_at: 1,
    };
    // over the lines in the history, so that nothing is truncated
    let (mut expected, mut found) = ([0.0; 3], [0.0; 3]);
    let pairs = [(0, 0), (1, 1), (0, 1)];
    for gusts in face.histories(&times, &draws(4)).unwrap() {
        for line in 1..times.lines() {
            let c = gusts.line_n(line);
            for (sum, (i, j)) in found.iter_mut().zip(pairs) {
                *sum += 0.5 * (c[i] * c[j].conj()).re / 4.0;
            }
        }
    }
    for line in 1..times.lines() {
        let density = face.force_density_n2_hz(times.frequency_hz(line));
        for (sum, (i, j)) in expected.iter_mut().zip(pairs) {
            *sum += density[(i, j)] * times.spacing_hz();
        }
    }
    let coherence = expected[2] / (expected[0] * expected[1]).sqrt();
    assert!((0.3..0.95).contains(&coherence), "{coherence}");
    for (found, expected) in found.iter().zip(&expected) {
        assert!((found / expected - 1.0).abs() < 0.02, "{found} {expected}");
    }
}

#[test]
fn holds_the_same_seed_gives_the_same_gusts_and_another_others() {
    let face = face(&[[3.0, 6.0], [6.0, 11.0]]);
    let times = GustTimes::new(60.0, 0.05, 100.0);
    // 2000 samples are rounded up to a multiple of 1200
    assert_eq!((times.samples, times.looked_at), (2400, 1201));
    let of = |seed, stream| face.histories(&times, &[GustDraw { seed, stream }]).unwrap();
    assert_eq!(of(3, 0), of(3, 0));
    for other in [of(4, 0), of(3, 1)] {
        assert_ne!(of(3, 0)[0].at_n(1.0), other[0].at_n(1.0));
    }
    // the same values one period later
    let gusts = &of(3, 0)[0];
    for (a, b) in gusts.at_n(7.0).iter().zip(gusts.at_n(7.0 + times.period_s())) {
        assert!((a - b).abs() < 1e-6 * a.abs(), "{a} {b}");
    }
}

#[test]
fn refuses_what_has_no_damping_and_histories_without_end() {
    let argument = |answer: Result<GustTimes, DamperError>| match answer.unwrap_err() {
        DamperError::Argument { argument, given, .. } => (argument, given),
        other => panic!("{other}"),
    };
    let undamped = mass(1e5, 0.5, 0.0);
    let refused = argument(gust_times(&undamped, &[], 600.0, 0.02));
    assert_eq!(refused, ("damping_ratio", 0.0));
    let light = mass(1e5, 0.5, 1e-5);
    // 1.5/(0.5 · 1e-5) s
    let (what, samples) = argument(gust_times(&light, &[], 600.0, 0.02));
    assert_eq!(what, "samples of the history");
    assert!((samples - 1.5e7).abs() < 1.0, "{samples}");
    let refused = argument(gust_times(&light, &[], 600.0, f64::NAN));
    assert_eq!(refused.0, "time_step_s");
    let good = gust_times(&mass(1e5, 0.1, 0.005), &[], 600.0, 0.02).unwrap();
    assert!((good.period_s() - 3000.0).abs() < 24.0, "{}", good.period_s());
}
