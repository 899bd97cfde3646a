// SOURCE     Equilibrium of a storey in its leaning shape; a column on two Winkler beds, as in the theory of loads.
// GOAL       Drift and largest force of the storeys of a frame under forces at its levels.
// PARAMETERS two storeys of a gate; a column N 200 kN, b = B = 0.5 m, h 4 m; 200 random frames from a seed, one to six storeys, both
//            conventions.
// PUBLISHED  by hand: δ = (V + N τ)/(k − N/l); N b/h for a rigid column.
// TOLERANCE  1e-12 closed forms; 1e-9 against iterated P-delta; 1e-6 against a grid of rotations, whose maximum is flat.

use dolmen::numeric::Random;
use dolmen::stability::{
    FootSection, FramePush, FrameUnderLoads, FreeColumns, StoreyEnd, Verdict, frame_under_loads,
};
use dolmen::structure::{Convention, Frame, Storey};

const MOST: f64 = 0.1;

fn frame(storeys: &[[f64; 2]], convention: Convention) -> Frame {
    let storeys = storeys.iter().map(|[height_m, axial_n]| Storey {
        mass_kg: 3e4,
        height_m: *height_m,
        axial_n: *axial_n,
    });
    Frame::new(storeys.collect(), convention).unwrap()
}

fn pushed(frame: &Frame, stiffness: &[f64], forces_n: &[f64], tilt: f64) -> FrameUnderLoads {
    let columns = vec![None; forces_n.len()];
    let push = FramePush {
        forces_n,
        columns: &columns,
        tilt,
        drift_ratio_most: MOST,
    };
    frame_under_loads(frame, stiffness, &push).unwrap()
}

#[test]
fn exact_two_storeys_with_p_delta_and_a_lean() {
    // N/l 100 and 50 kN/m; V 30 and 20 kN; lean 1/100
    let gate = frame(&[[5.0, 500e3], [4.0, 200e3]], Convention::Drift);
    let of = pushed(&gate, &[1100e3, 850e3], &[10e3, 20e3], 0.01);
    let [low, high] = [&of.storeys[0], &of.storeys[1]];
    assert!((low.drift_m.unwrap() / (30e3 / 1000e3) - 1.0).abs() < 1e-12);
    assert!((high.drift_m.unwrap() / (20e3 / 800e3) - 1.0).abs() < 1e-12);
    // at rest: τ k/(k − N/l)
    assert!((low.lean_at_rest.unwrap() / (0.01 * 1100.0 / 1000.0) - 1.0).abs() < 1e-12);
    assert!((high.lean_at_rest.unwrap() / (0.01 * 850.0 / 800.0) - 1.0).abs() < 1e-12);
    // at 10 % of the height minus the lean: κ (0.1 − 0.01) l − N τ, over V
    assert!((low.factor / ((1000e3 * 0.09 * 5.0 - 5e3) / 30e3) - 1.0).abs() < 1e-12);
    assert!((high.factor / ((800e3 * 0.09 * 4.0 - 2e3) / 20e3) - 1.0).abs() < 1e-12);
    assert_eq!(
        (of.governing_storey, low.end, of.verdict()),
        (2, StoreyEnd::Drift, Verdict::Stable)
    );
    // a storey that falls under its weight has no capacity
    let soft = pushed(&gate, &[90e3, 850e3], &[10e3, 20e3], 0.0);
    assert_eq!((soft.factor, soft.storeys[0].drift_m), (0.0, None));
    assert_eq!(soft.verdict(), Verdict::Unstable);
    // the same in the opposite direction, and without a push
    let back = pushed(&gate, &[1100e3, 850e3], &[-10e3, -20e3], 0.01);
    assert_eq!((back.factor, back.storeys[0].shear_n), (of.factor, -30e3));
    let still = pushed(&gate, &[1100e3, 850e3], &[0.0, 0.0], 0.01);
    assert_eq!((still.factor, still.verdict()), (f64::INFINITY, Verdict::Stable));
    // a lean larger than the drift of a fallen storey
    let over = pushed(&gate, &[1100e3, 850e3], &[10e3, 20e3], 0.1);
    assert_eq!((over.factor, over.storeys[1].lean_at_rest), (0.0, None));
}

#[test]
fn exact_springs_on_displacement_by_cramers_rule() {
    let gate = frame(&[[5.0, 500e3], [4.0, 200e3]], Convention::Grounded);
    let (k1, k2, g1, g2) = (900e3, 700e3, 100e3, 50e3);
    let of = pushed(&gate, &[k1, k2], &[10e3, 20e3], 0.0);
    // [k1 − g1 − g2, g2; g2, k2 − g2] Y = F
    let (a, d) = (k1 - g1 - g2, k2 - g2);
    let det = a * d - g2 * g2;
    let [y1, y2] = [(10e3 * d - g2 * 20e3) / det, (a * 20e3 - g2 * 10e3) / det];
    for (storey, drift_m) in of.storeys.iter().zip([y1, y2 - y1]) {
        assert!((storey.drift_m.unwrap() / drift_m.abs() - 1.0).abs() < 1e-12);
    }
    assert!((of.storeys[0].factor / (0.5 / y1) - 1.0).abs() < 1e-12);
    assert_eq!(of.storeys[0].greatest_n, None);
}

/// N 200 kN, b = B = 0.5 m, h 4 m: V at a rotation, by the theory of loads.
fn by_theory_n(bed: f64, theta: f64) -> f64 {
    let (n, b, h) = (200e3, 0.5_f64, 4.0);
    let lifts = 2.0 * n / (bed * b * b * b);
    let moment = match theta <= lifts {
        true => bed * b * b.powi(3) * theta / 12.0,
        false => n * (b / 2.0 - (2.0 * n / (bed * b * theta)).sqrt() / 3.0),
    };
    n * ((2.0 * moment / (n * h)).atan() - theta).tan()
}

/// Drift at a rotation: h sin θ + 2 ∫ (M/N) sin θ dθ, trapezoids on a grid.
fn by_theory_m(bed: f64, theta: f64) -> f64 {
    let steps = 400;
    let at = |i: usize| theta * i as f64 / steps as f64;
    // M/N from V: tan ψ = 2M/(N h)
    let eccentric = |t: f64| 2.0 * ((by_theory_n(bed, t) / 200e3).atan() + t).tan();
    let f = |t: f64| 2.0 * eccentric(t) * t.sin();
    let sum: f64 = (0..steps).map(|i| 0.5 * (f(at(i)) + f(at(i + 1)))).sum();
    4.0 * theta.sin() + sum * theta / steps as f64
}

fn column(bed: Option<f64>) -> FreeColumns {
    let section = FootSection::Rectangle {
        width_m: 0.5,
        breadth_m: 0.5,
    };
    FreeColumns::new(1, section, 4.0, 200e3, bed).unwrap()
}

fn on_column(stiffness: f64, bed: Option<f64>, force_n: f64, tilt: f64) -> FrameUnderLoads {
    let gate = frame(&[[4.0, 200e3]], Convention::Drift);
    let push = FramePush {
        forces_n: &[force_n],
        columns: &[Some(column(bed))],
        tilt,
        drift_ratio_most: MOST,
    };
    frame_under_loads(&gate, &[stiffness], &push).unwrap()
}

#[test]
fn exact_rigid_columns_alone_hold_n_b_over_h() {
    let of = on_column(0.0, None, 10e3, 0.0);
    let storey = &of.storeys[0];
    assert!((storey.greatest_n.unwrap() / 25e3 - 1.0).abs() < 1e-12);
    assert!((of.factor / 2.5 - 1.0).abs() < 1e-12);
    assert_eq!((storey.drift_m, storey.end), (Some(0.0), StoreyEnd::Force));
    // a lean reduces the capacity by N τ
    let leaning = on_column(0.0, None, 10e3, 0.02);
    assert!((leaning.factor / 2.1 - 1.0).abs() < 1e-12);
    let over = on_column(0.0, None, 30e3, 0.0);
    assert_eq!(
        (over.storeys[0].drift_m, over.verdict()),
        (None, Verdict::Unstable)
    );
    // rigid columns in a storey of known stiffness: the whole stiffness is attributed to the beds, so the columns carry less
    let whole = on_column(500e3, None, 10e3, 0.0);
    assert!(whole.factor < of.factor && whole.factor > 1.0);
}

#[test]
fn agrees_columns_on_beds_with_a_grid_of_rotations() {
    for (bed, springs, force_n, tilt) in [
        (1e9, 0.0, 8e3, 0.0),
        (3e8, 0.0, 5e3, 0.01),
        (1e9, 30e3, 12e3, 0.005),
        (1e9, 200e3, 20e3, 0.0),
    ] {
        let beds_n_m = 2.0 * bed * 0.5 * 0.125 / 12.0 / 16.0;
        let of = on_column(beds_n_m + springs, Some(bed), force_n, tilt);
        let storey = &of.storeys[0];
        let resists = |theta: f64| by_theory_n(bed, theta) + springs * by_theory_m(bed, theta);
        let lean_n = 200e3 * tilt;
        // up to 10 % of the height, or the fall of the columns, minus the lean
        let grid: Vec<f64> = (0..=2000).map(|i| 0.13 * f64::from(i) / 2000.0).collect();
        let falls = grid
            .iter()
            .copied()
            .find(|t| *t > 1e-3 && by_theory_n(bed, *t) < 0.0);
        let most_m = 0.4_f64.min(by_theory_m(bed, falls.unwrap_or(0.13))) - 4.0 * tilt;
        let within = grid.iter().copied().filter(|t| by_theory_m(bed, *t) <= most_m);
        let top_n = within.map(resists).fold(0.0, f64::max);
        let what = format!("{bed:e} {springs}: {:?} {top_n}", storey.greatest_n);
        assert!((storey.greatest_n.unwrap() / top_n - 1.0).abs() < 2e-3, "{what}");
        assert!(
            (of.factor / ((top_n - lean_n) / force_n) - 1.0).abs() < 3e-3,
            "{what}"
        );
        // in equilibrium: by bisection until the drift is stationary
        let drift_at = |force_n: f64| {
            let (mut low, mut high) = (0.0, 0.03);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                match resists(middle) < force_n {
                    true => low = middle,
                    false => high = middle,
                }
            }
            by_theory_m(bed, low)
        };
        let drift_m = drift_at(lean_n + force_n) - drift_at(lean_n);
        assert!((storey.drift_m.unwrap() / drift_m - 1.0).abs() < 1e-6, "{what}");
        // before this point the curve is that of the theory
        for point in &storey.curve {
            assert!(
                point.force_n <= storey.greatest_n.unwrap() * (1.0 + 1e-9),
                "{what}"
            );
        }
        let force = match springs < 50e3 {
            true => StoreyEnd::Force,
            false => StoreyEnd::Drift,
        };
        assert_eq!(storey.end, force, "{what}");
    }
}

/// P-delta by iteration, as by hand: drifts give moments, and moments give drifts.
fn round_by_round(storeys: &[[f64; 2]], k: &[f64], forces: &[f64], convention: Convention) -> Vec<f64> {
    let n = k.len();
    let mut y = vec![0.0; n];
    for _ in 0..20_000 {
        let drift = |y: &[f64], i: usize| y[i] - if i == 0 { 0.0 } else { y[i - 1] };
        // horizontal force of the weight on each level due to its lean: N δ/l of its storey minus that of the storey above
        let push: Vec<f64> = (0..n)
            .map(|i| storeys[i][1] * drift(&y, i) / storeys[i][0])
            .collect();
        let level = |i: usize| forces[i] + push[i] - push.get(i + 1).copied().unwrap_or(0.0);
        let next: Vec<f64> = match convention {
            Convention::Grounded => (0..n).map(|i| level(i) / k[i]).collect(),
            Convention::Drift => {
                let mut at = 0.0;
                (0..n)
                    .map(|i| {
                        at += (i..n).map(level).sum::<f64>() / k[i];
                        at
                    })
                    .collect()
            }
        };
        y = next;
    }
    (0..n)
        .map(|i| y[i] - if i == 0 { 0.0 } else { y[i - 1] })
        .collect()
}

#[test]
fn agrees_200_frames_with_p_delta_round_by_round() {
    let mut random = Random::new(27, 0);
    let mut most: f64 = 0.0;
    for case in 0..200 {
        let n = 1 + case % 6;
        let convention = [Convention::Drift, Convention::Grounded][case / 6 % 2];
        let mut axial: Vec<f64> = (0..n).map(|_| 50e3 + 2e6 * random.uniform()).collect();
        axial.sort_by(|a, b| b.total_cmp(a));
        let storeys: Vec<[f64; 2]> = axial.iter().map(|n| [2.0 + 6.0 * random.uniform(), *n]).collect();
        let needed: f64 = storeys.iter().map(|[l, n]| n / l).fold(0.0, f64::max);
        let k: Vec<f64> = (0..n).map(|_| needed * (5.0 + 20.0 * random.uniform())).collect();
        let forces: Vec<f64> = (0..n).map(|_| 40e3 * (random.uniform() - 0.3)).collect();
        let of = pushed(&frame(&storeys, convention), &k, &forces, 0.0);
        let drifts = round_by_round(&storeys, &k, &forces, convention);
        for ((storey, drift), [l, _]) in of.storeys.iter().zip(&drifts).zip(&storeys) {
            let factor = MOST * l / drift.abs();
            most = most.max((storey.factor / factor - 1.0).abs());
            if factor > 1.0 {
                most = most.max((storey.drift_m.unwrap() / drift.abs() - 1.0).abs());
            }
        }
    }
    assert!(most < 1e-9, "{most:e}");
}

#[test]
fn refuses_what_does_not_fit_the_frame() {
    let gate = frame(&[[4.0, 200e3]], Convention::Drift);
    let said = |forces_n: &[f64], columns: &[Option<FreeColumns>], tilt: f64| {
        let push = FramePush {
            forces_n,
            columns,
            tilt,
            drift_ratio_most: MOST,
        };
        frame_under_loads(&gate, &[1e6], &push).unwrap_err().to_string()
    };
    assert_eq!(
        said(&[], &[None], 0.0),
        "forces_n has 0 values, but the frame has 1 storeys"
    );
    assert_eq!(
        said(&[1.0], &[], 0.0),
        "columns has 0 values, but the frame has 1 storeys"
    );
    assert_eq!(
        said(&[f64::NAN], &[None], 0.0),
        "forces_n is NaN, but must be finite numbers"
    );
    assert_eq!(
        said(&[1.0], &[None], f64::INFINITY),
        "tilt is inf, but must be finite numbers"
    );
}
