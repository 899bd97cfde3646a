// SOURCE     Yalla & Kareem (2000) J. Struct. Eng. 126(8):906-915: optimum liquid columns under white noise; statistical linearisation
//            of head loss; the exact first integral of a free column.
// GOAL       The closed form is the optimum of the assembled matrices; the time history of a column with head loss has the correct
//            turning points and, under white noise, the deviations of its linear equivalent.
//
//        | |            | |   w, down here, up there
//        | |____________| |
//         ‾‾‾‾‾ α L ‾‾‾‾‾    ẅ + (ξ/2L)|ẇ|ẇ + ω_d² w = −α z̈₀
//
// PARAMETERS mass 1 on a spring of 1, μ .01 to .1, α .5 to 1; head loss ξ = .7, 10 runs of 2000 periods.
// TOLERANCE  closed form: no step of 1 % is better and the gradient vanishes to 1e-6; free turns 1e-8 (Runge-Kutta, 0.05 rad a step);
//            standard deviations in time: structure 2 %, liquid 1 to 5 % above its stand-in.

use dolmen::damper::{
    AttachedDamper, ColumnRun, DampedSystem, DamperKind, HeadLossColumn, equivalent_column, simulate_column,
};
use dolmen::dynamics::{LinearSystem, RandomInput, RandomLoad, ResponseRow, Spectrum, rms_by_lyapunov};
use dolmen::known::liquid_column::{least_variance_under_force, next_turn_m};
use dolmen::numeric::Random;
use dolmen_linalg::Matrix;
use std::f64::consts::TAU;

fn oscillator(mass: f64, damping_ratio: f64) -> LinearSystem {
    let one = |x: f64| Matrix::from_rows(&[[x]]);
    LinearSystem::new(one(mass), one(2.0 * damping_ratio * mass), one(mass)).unwrap()
}

fn white() -> RandomLoad {
    RandomLoad {
        input: RandomInput::Force(vec![1.0]),
        spectrum: Spectrum::unit_white(),
    }
}

#[test]
fn published_optimum_of_yalla_and_kareem() {
    for (mu, alpha) in [(0.01, 0.9), (0.05, 0.7), (0.1, 0.5), (0.05, 1.0)] {
        let variance = |f: f64, zeta: f64| {
            let column = AttachedDamper {
                kind: DamperKind::LiquidColumn {
                    liquid_mass_kg: mu,
                    length_ratio: alpha,
                    frequency_hz: f / TAU,
                    damping_ratio: zeta,
                },
                row: vec![1.0],
            };
            let damped = DampedSystem::new(&oscillator(1.0, 0.0), &[column]).unwrap();
            let row = damped.response(&ResponseRow::displacement(vec![1.0]));
            rms_by_lyapunov(&damped.system, &[damped.load(&white())], &[row]).unwrap()[0].powi(2)
        };
        let [f, zeta] = least_variance_under_force(mu, alpha);
        let least = variance(f, zeta);
        for (df, dz) in [(1.01, 1.0), (0.99, 1.0), (1.0, 1.01), (1.0, 0.99)] {
            assert!(variance(f * df, zeta * dz) > least, "{mu} {alpha} {df} {dz}");
        }
        let h = 1e-4;
        let slope = (variance(f * (1.0 + h), zeta) - variance(f * (1.0 - h), zeta)) / (2.0 * h * least);
        let bend =
            (variance(f * (1.0 + h), zeta) + variance(f * (1.0 - h), zeta) - 2.0 * least) / (h * h * least);
        assert!((slope / bend).abs() < 1e-6, "{mu} {alpha} {slope} {bend}");
        let slope = (variance(f, zeta * (1.0 + h)) - variance(f, zeta * (1.0 - h))) / (2.0 * h * least);
        assert!(slope.abs() < 1e-6, "{mu} {alpha} {slope}");
    }
}

#[test]
fn exact_turns_of_a_free_column_with_head_loss() {
    // the structure is so heavy that it does not move
    let column = HeadLossColumn {
        liquid_mass_kg: 1e-9,
        length_ratio: 0.7,
        length_m: 2.0 * 9.81, // ω_d = 1 rad/s
        head_loss: 8.0,
        gravity_m_s2: 9.81,
        row: vec![1.0],
    };
    let run = ColumnRun {
        force_row: vec![1.0],
        force_n: vec![0.0; 2000],
        time_step_s: 0.01,
        substeps: 1,
        start_m: 3.0,
    };
    let history = simulate_column(&oscillator(1.0, 0.0), &column, &run).unwrap();
    let mut expected = 3.0;
    let mut turns = 0;
    let w = &history.liquid_m;
    for i in 1..w.len() - 1 {
        if (w[i] - w[i - 1]) * (w[i + 1] - w[i]) < 0.0 {
            expected = next_turn_m(expected, 8.0, 2.0 * 9.81);
            // peak of the parabola through three samples
            let bend = w[i + 1] - 2.0 * w[i] + w[i - 1];
            let top = w[i] - (w[i + 1] - w[i - 1]).powi(2) / (8.0 * bend);
            assert!((top.abs() - expected).abs() < 1e-7, "{turns}: {top} {expected}");
            turns += 1;
        }
    }
    assert!(turns >= 5, "{turns}");
}

#[test]
fn agrees_head_loss_in_time_with_its_linear_stand_in() {
    let structure = oscillator(1.0, 0.01);
    let column = HeadLossColumn {
        liquid_mass_kg: 0.02,
        length_ratio: 0.8,
        length_m: 2.0 * 9.81 * 1.02,
        head_loss: 0.7,
        gravity_m_s2: 9.81,
        row: vec![1.0],
    };
    let loads = [white()];
    let equivalent = equivalent_column(&structure, &loads, &column).unwrap();
    let damped = DampedSystem::new(&structure, std::slice::from_ref(&equivalent.damper)).unwrap();
    let rows = [
        damped.response(&ResponseRow::displacement(vec![1.0])),
        ResponseRow::displacement(damped.stroke_row(0).unwrap()),
    ];
    let linear = rms_by_lyapunov(&damped.system, &[damped.load(&white())], &rows).unwrap();
    let (dt, steps) = (0.1_f64, 126_000);
    let mut random = Random::new(7, 0);
    let mut sums = [0.0; 2];
    let mut count = 0.0;
    for _ in 0..10 {
        // straight lines between values at each dt: their density at low frequency is that of white noise of intensity 1
        let force_n: Vec<f64> = (0..steps).map(|_| random.normal() / dt.sqrt()).collect();
        let run = ColumnRun {
            force_row: vec![1.0],
            force_n,
            time_step_s: dt,
            substeps: 1,
            start_m: 0.0,
        };
        let history = simulate_column(&structure, &column, &run).unwrap();
        for i in 5000..steps as usize {
            sums[0] += history.displacement[i][0].powi(2);
            sums[1] += history.liquid_m[i].powi(2);
            count += 1.0;
        }
    }
    let in_time = sums.map(|sum| (sum / count).sqrt());
    // the linear equivalent assumes Gaussian velocities; for a single oscillator its error is √(.32973/.31563) − 1 = 2.2 % by
    // stochastic averaging
    assert!(
        (in_time[0] / linear[0] - 1.0).abs() < 0.02,
        "{linear:?} {in_time:?}"
    );
    assert!(
        (in_time[1] / linear[1] - 1.03).abs() < 0.02,
        "{linear:?} {in_time:?}"
    );
}
