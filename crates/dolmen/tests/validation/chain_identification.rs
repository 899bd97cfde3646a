// SOURCE     theory of the chain: K is linear in the stiffness of the joints; Bézout bounds the number of solutions.
// GOAL       Modes computed with a known stiffness give this stiffness back if they determine it; otherwise every
//            solution is found, and the answer calls it as good as the true one.
//
//        |5| o  sensors: u(z) = Σ c_j(z) θ_j
//        (k5
//        ...    modes f_j, u_j(z_p)  →  k_1 … k_5
//        (k1
//      ///////
//
// PARAMETERS Flagpole of Naju (Choi 2021, Table 1) with several stiffnesses; random chains.
// PUBLISHED  Nothing: "future work" of the source. At most n! solutions; 1 from one exact mode with its full shape.
// TOLERANCE  exact data 1e-9 relative in k or f (rounding times the condition of the Jacobian, below 1e3 here); sampled
//            scatter 12 %: the sd of an sd from 400 samples is 3.5 %.

use crate::choi_2021::{naju, twice_the_least};
use crate::draws::Draws;
use dolmen::structure::{
    Chain, ChainStiffness, Choice, Inertia, Link, MeasuredMode, ShapePoint, SideSupport, StiffnessSolutions,
    chain_stiffness,
};

/// The lowest `count` modes of a chain as exact measurements at some heights.
fn measured(chain: &Chain, k: &[f64], count: usize, heights_m: &[f64]) -> Vec<MeasuredMode> {
    let modes = chain.natural_modes(k).unwrap();
    let point = |coordinates: &[f64], height_m: f64| ShapePoint {
        height_m,
        displacement: chain.displacement_at(coordinates, height_m).unwrap(),
        displacement_sd: 0.0,
    };
    let modes = modes.iter().take(count).map(|mode| MeasuredMode {
        frequency_hz: mode.frequency_hz,
        frequency_sd_hz: 0.0,
        frequency_changes_hz: Vec::new(),
        shape: heights_m.iter().map(|&z| point(&mode.coordinates, z)).collect(),
    });
    modes.collect()
}

fn tops(chain: &Chain) -> Vec<f64> {
    let mut heights = chain.joint_heights_m();
    heights.remove(0);
    heights.push(chain.height_m());
    heights
}

fn identify(chain: &Chain, modes: &[MeasuredMode]) -> StiffnessSolutions {
    chain_stiffness(chain, modes, &ChainStiffness::default()).unwrap()
}

fn assert_stiffness(found: &[f64], truth: &[f64], tolerance: f64) {
    for (i, (a, b)) in found.iter().zip(truth).enumerate() {
        assert!(
            (a / b - 1.0).abs() < tolerance,
            "joint {}: {a} found, {b} true",
            i + 1
        );
    }
}

/// Checks that every listed solution reproduces every frequency to 1e-9 and is stable.
fn assert_all_explain(found: &StiffnessSolutions, modes: &[MeasuredMode]) {
    for solution in &found.solutions {
        assert!(
            solution.stands && solution.misfit < 1e-9,
            "misfit {}",
            solution.misfit
        );
        for (computed, measured) in solution.modes.iter().zip(modes) {
            assert!((computed.frequency_hz / measured.frequency_hz - 1.0).abs() < 1e-9);
        }
    }
}

#[test]
fn exact_one_mode_with_its_full_shape_gives_every_joint() {
    let chain = naju();
    let k = twice_the_least(&chain);
    let mut modes = measured(&chain, &k, 1, &tops(&chain));
    let found = identify(&chain, &modes);
    // without standard deviations each point has an assumed error of 5 %: although the points are exact, the joints are
    // only bounded
    assert_eq!(found.choice, Choice::Bounded, "{:?}", found.notes);
    assert_stiffness(&found.solutions[0].stiffness, &k, 1e-9);
    assert_eq!(found.visibility.unwrap().free_directions, 0);
    let bounds = found.solutions[0].stiffness_bounds.as_ref().unwrap();
    for (bound, k) in bounds.iter().zip(&k) {
        assert!(
            bound.lower.is_some_and(|lower| lower < *k) && bound.upper.is_none_or(|upper| upper > *k),
            "{bounds:?}"
        );
    }
    modes[0].frequency_sd_hz = 1e-6;
    modes[0]
        .shape
        .iter_mut()
        .for_each(|point| point.displacement_sd = 1e-6);
    let found = identify(&chain, &modes);
    assert_eq!(found.choice, Choice::One, "{:?}", found.notes);
    assert_stiffness(&found.solutions[0].stiffness, &k, 1e-9);
}

#[test]
fn exact_random_chains_from_all_modes_with_two_sensors() {
    let mut draw = Draws::new(11);
    for n in 2..=6 {
        let chain = draw.chain(n);
        let k: Vec<f64> = chain
            .necessary_n_m_rad()
            .iter()
            .map(|m| m * n as f64 * draw.between(1.5, 6.0))
            .collect();
        let heights = [0.45 * chain.height_m(), chain.height_m()];
        let found = identify(&chain, &measured(&chain, &k, n, &heights));
        assert_eq!(found.choice, Choice::One, "n = {n}: {:?}", found.notes);
        assert_stiffness(&found.solutions[0].stiffness, &k, 1e-8);
    }
}

#[test]
fn exact_two_frequencies_of_two_joints_are_the_roots_of_a_quadratic() {
    // det(K − λM) = k1 k2 − a2 k1 − s k2 + p, a_i = G_i + λ M_ii, b = λ M_12, s = a1 + a2 + 2 b, p = a1 a2 − b²;
    // its difference at the two λ is linear in k, so k2 solves a quadratic
    let mut draw = Draws::new(5);
    for _ in 0..20 {
        let chain = draw.chain(2);
        let truth: Vec<f64> = chain
            .necessary_n_m_rad()
            .iter()
            .map(|m| m * draw.between(2.5, 30.0))
            .collect();
        let modes = measured(&chain, &truth, 2, &[]);
        let (g, mass) = (chain.gravity_moments_n_m_rad(), chain.mass_matrix());
        let coefficients = |mode: &MeasuredMode| {
            let lambda = (std::f64::consts::TAU * mode.frequency_hz).powi(2);
            let (a1, a2) = (g[0] + lambda * mass[(0, 0)], g[1] + lambda * mass[(1, 1)]);
            let b = lambda * mass[(0, 1)];
            [a2, a1 + a2 + 2.0 * b, a1 * a2 - b * b]
        };
        let (low, high) = (coefficients(&modes[0]), coefficients(&modes[1]));
        let [da, ds, dp] = [high[0] - low[0], high[1] - low[1], high[2] - low[2]];
        // k1 = (dp − ds k2)/da into k1 k2 − a2 k1 − s k2 + p = 0
        let (qa, qb, qc) = (
            -ds / da,
            (dp + low[0] * ds) / da - low[1],
            low[2] - low[0] * dp / da,
        );
        let root = (qb * qb - 4.0 * qa * qc).sqrt();
        let mut roots: Vec<f64> = [-root, root]
            .iter()
            .map(|r| (dp - ds * (r - qb) / (2.0 * qa)) / da)
            .collect();
        roots.sort_by(f64::total_cmp);
        let found = identify(&chain, &modes);
        assert_eq!(found.solutions.len(), 2, "{roots:?}, true {truth:?}");
        assert_eq!(found.choice, Choice::Indistinguishable);
        for (solution, k1) in found.solutions.iter().zip(&roots) {
            // the quadratic itself loses digits for close roots
            assert!(
                (solution.stiffness[0] / k1 - 1.0).abs() < 1e-6,
                "{} {k1}",
                solution.stiffness[0]
            );
        }
        assert_all_explain(&found, &modes);
    }
}

#[test]
fn holds_five_frequencies_leave_at_least_16_stiffnesses() {
    let chain = naju();
    let equal = dolmen::stability::chain_limits(&chain)
        .unwrap()
        .equal_joints_n_m_rad;
    let truth = vec![2.0 * equal; 5];
    let modes = measured(&chain, &truth, 5, &[]);
    let found = identify(&chain, &modes);
    assert!(found.solutions.len() >= 16, "{} found", found.solutions.len());
    assert_eq!(found.solutions.len(), 40, "as many as 10,000 starts find");
    assert_eq!(found.choice, Choice::Indistinguishable);
    assert_all_explain(&found, &modes);
    assert!(
        found
            .solutions
            .is_sorted_by(|a, b| a.stiffness[0] < b.stiffness[0])
    );
    let is_true = |k: &[f64]| k.iter().all(|k| (k / (2.0 * equal) - 1.0).abs() < 1e-9);
    assert_eq!(
        found.solutions.iter().filter(|s| is_true(&s.stiffness)).count(),
        1
    );
    assert!(
        found.notes[0]
            .to_string()
            .starts_with("40 sets of joint stiffness explain the data equally well")
    );
    assert_eq!(identify(&chain, &modes), found, "same input, same bits");
}

#[test]
fn holds_all_120_solutions_of_a_pole_stiffest_at_its_top() {
    let chain = naju();
    let upside_down = chain.necessary_n_m_rad().into_iter().rev();
    let truth: Vec<f64> = upside_down.map(|m| 600.0 * m).collect();
    let modes = measured(&chain, &truth, 5, &[]);
    let options = ChainStiffness {
        solutions_most: 200,
        ..Default::default()
    };
    let found = chain_stiffness(&chain, &modes, &options).unwrap();
    assert_eq!(found.solutions.len(), 120, "5! is the most that Bézout allows");
    assert_all_explain(&found, &modes);
}

#[test]
fn holds_two_frequencies_for_five_springs_are_an_honest_answer() {
    let chain = naju();
    let k = twice_the_least(&chain);
    let modes = measured(&chain, &k, 2, &[]);
    let found = identify(&chain, &modes);
    assert_eq!(found.choice, Choice::Underdetermined);
    assert_eq!(found.solutions.len(), 1);
    assert_all_explain(&found, &modes);
    assert_stiffness(&found.solutions[0].stiffness, &k, 1e-6); // k ∝ M is what is assumed, and true here
    assert_eq!(found.solutions[0].stiffness_sd, None);
    assert_eq!(found.visibility.as_ref().unwrap().free_directions, 3);
    assert_eq!(
        found.notes[0].to_string(),
        "2 frequencies give 2 independent data for 5 joint stiffnesses: they cannot be determined. The set shown fits \
         the data and is the nearest to stiffness in proportion to the weight moment above each joint, an assumption \
         and not a measurement. Measure more modes, or shapes at several heights."
    );
    assert_eq!(
        found
            .notes
            .iter()
            .filter(|note| note.to_string().starts_with("Free: changes of ln k"))
            .count(),
        3
    );
}

#[test]
fn holds_sensors_on_the_lowest_link_alone_add_nothing() {
    let chain = naju();
    let k = twice_the_least(&chain);
    let found = identify(&chain, &measured(&chain, &k, 1, &[0.5, 1.0, 1.5, 2.0, 2.5, 3.0]));
    assert_eq!(found.choice, Choice::Underdetermined);
    assert_eq!(found.visibility.unwrap().free_directions, 4);
    assert!(
        found.notes[0]
            .to_string()
            .starts_with("1 frequency with shape points gives 1 independent datum")
    );
}

#[test]
fn holds_a_nearly_rigid_joint_is_not_seen() {
    let chain = naju();
    let mut k = twice_the_least(&chain);
    k[2] *= 1e5;
    let found = identify(&chain, &measured(&chain, &k, 2, &tops(&chain)));
    let seen = found.visibility.unwrap().seen;
    assert!(seen[2] < 0.1, "{seen:?}");
    assert!(
        seen.iter().enumerate().all(|(i, &s)| i == 2 || s > 0.9),
        "{seen:?}"
    );
    assert!(
        found
            .notes
            .iter()
            .any(|note| note.to_string().starts_with("The sensors hardly see joint 3:")),
        "{:?}",
        found.notes
    );
}

#[test]
fn holds_data_that_some_stiffness_fits_are_never_called_impossible() {
    // the prior is far from equal joints: a search from the prior alone does not reach the data
    let chain = naju();
    let equal = dolmen::stability::chain_limits(&chain)
        .unwrap()
        .equal_joints_n_m_rad;
    for modes in 1..=3 {
        for heights in [vec![], vec![5.0, 10.83], vec![2.0, 4.0, 6.0, 8.0, 10.83]] {
            let mut data = measured(&chain, &[2.0 * equal; 5], modes, &heights);
            for (j, mode) in data.iter_mut().enumerate() {
                mode.frequency_hz *= if j % 2 == 0 { 1.004 } else { 0.997 };
                mode.shape.iter_mut().for_each(|point| point.displacement += 0.01);
            }
            let found = identify(&chain, &data);
            assert_ne!(found.choice, Choice::Impossible, "{:?}", found.notes);
            assert!(found.choice != Choice::Underdetermined || found.solutions.len() == 1);
        }
    }
}

#[test]
fn exact_interval_of_a_single_joint() {
    // k = I ω² + G: sd(k)/k = 2 sd(f)/f · I ω² / (I ω² + G)
    let link = Link {
        mass_kg: 1000.0,
        length_m: 3.0,
        centroid_m: 1.5,
        inertia: Inertia::ThinRod,
        bed_width_m: None,
    };
    for (gravity, rule_of_thumb) in [(9.81, false), (1e-12, true)] {
        let chain = Chain::new(vec![link.clone()], gravity).unwrap();
        let mode = MeasuredMode {
            frequency_hz: 2.0,
            frequency_sd_hz: 0.03,
            frequency_changes_hz: Vec::new(),
            shape: vec![],
        };
        let found = identify(&chain, &[mode]);
        let elastic = 3000.0 * (std::f64::consts::TAU * 2.0).powi(2);
        let k = elastic + 1500.0 * gravity;
        let solution = &found.solutions[0];
        let relative = solution.stiffness_sd.as_ref().unwrap()[0] / solution.stiffness[0];
        assert!((solution.stiffness[0] / k - 1.0).abs() < 1e-12);
        assert!((relative / (2.0 * 0.015 * elastic / k) - 1.0).abs() < 1e-12);
        assert!(!rule_of_thumb || (relative - 0.03).abs() < 1e-12, "dk/k = 2 df/f");
    }
}

#[test]
fn holds_intervals_cover_the_scatter_of_repeated_measurements() {
    let chain = naju();
    let k = twice_the_least(&chain);
    let mut exact = measured(&chain, &k, 3, &[3.0, 6.0, 9.0, 10.83]);
    for mode in &mut exact {
        mode.frequency_sd_hz = 0.002 * mode.frequency_hz;
        mode.shape
            .iter_mut()
            .for_each(|point| point.displacement_sd = 0.005);
    }
    let options = ChainStiffness {
        starts: 1, // the prior is near
        misfit_most: 10.0,
        ..Default::default()
    };
    let stated = chain_stiffness(&chain, &exact, &options).unwrap();
    assert_eq!(stated.choice, Choice::One);
    let sd = stated.solutions[0].stiffness_sd.clone().unwrap();
    let mut draw = Draws::new(77);
    const SAMPLES: usize = 400;
    let mut squares = [0.0; 5];
    for _ in 0..SAMPLES {
        let mut noisy = exact.clone();
        for mode in &mut noisy {
            mode.frequency_hz += mode.frequency_sd_hz * draw.normal();
            for point in &mut mode.shape {
                point.displacement += point.displacement_sd * draw.normal();
            }
        }
        let found = chain_stiffness(&chain, &noisy, &options).unwrap();
        let each = found.solutions[0].stiffness.iter().zip(&k);
        squares
            .iter_mut()
            .zip(each)
            .for_each(|(sum, (found, truth))| *sum += (found - truth).powi(2));
    }
    for i in 0..5 {
        let scatter = (squares[i] / SAMPLES as f64).sqrt();
        assert!(
            (scatter / sd[i] - 1.0).abs() < 0.12,
            "joint {}: {scatter} seen, {} stated",
            i + 1,
            sd[i]
        );
    }
}

#[test]
fn exact_the_side_support_is_part_of_the_model() {
    let support = SideSupport {
        height_m: 3.0,
        stiffness_n_m: 2e5,
        gap_m: 0.0,
    };
    let chain = naju().with_side_support(support).unwrap();
    let k = twice_the_least(&chain);
    let found = identify(&chain, &measured(&chain, &k, 2, &tops(&chain)));
    assert_stiffness(&found.solutions[0].stiffness, &k, 1e-8);
    assert!(found.notes.iter().any(|note| {
        note.to_string()
            .starts_with("Side supports without a gap are part of the model")
    }));
}

#[test]
fn holds_frequencies_no_chain_has_are_said_to_be_impossible() {
    let modes: Vec<MeasuredMode> = [1.0, 1.001, 1.002, 1.003, 1.004]
        .iter()
        .map(|&frequency_hz| MeasuredMode {
            frequency_hz,
            frequency_sd_hz: 0.0,
            frequency_changes_hz: Vec::new(),
            shape: vec![],
        })
        .collect();
    let found = identify(&naju(), &modes);
    assert_eq!((found.choice, found.solutions.len()), (Choice::Impossible, 0));
    assert!(
        found
            .notes
            .iter()
            .any(|note| note.to_string().starts_with("No joint stiffness was found, from"))
    );
}

#[test]
fn refuses_bad_modes_and_says_which() {
    let chain = naju();
    let plain = |frequency_hz: f64| MeasuredMode {
        frequency_hz,
        frequency_sd_hz: 0.0,
        frequency_changes_hz: Vec::new(),
        shape: vec![],
    };
    let point = |height_m: f64, displacement: f64, displacement_sd: f64| ShapePoint {
        height_m,
        displacement,
        displacement_sd,
    };
    let with = |shape: Vec<ShapePoint>| vec![MeasuredMode { shape, ..plain(1.0) }];
    let cases: Vec<(Vec<MeasuredMode>, &str)> = vec![
        (
            vec![],
            "no measured mode is given, but stiffness needs at least 1",
        ),
        (
            (1..=6).map(|i| plain(f64::from(i))).collect(),
            "6 measured modes are given, but a structure of 5 links has only 5: give the lowest 5",
        ),
        (
            vec![plain(2.0), plain(1.5)],
            "mode 2: frequency_hz is 1.5, not above the 2 of the mode before it: give the modes in ascending order, \
             each once",
        ),
        (
            vec![plain(-1.0)],
            "mode 1: frequency_hz is -1, but must be a positive number",
        ),
        (
            vec![plain(f64::NAN)],
            "mode 1: frequency_hz is NaN, but must be a positive number",
        ),
        (
            vec![MeasuredMode {
                frequency_sd_hz: -0.1,
                frequency_changes_hz: Vec::new(),
                ..plain(1.0)
            }],
            "mode 1: frequency_sd_hz is -0.1, but must be 0 (exact) or a positive number",
        ),
        (
            with(vec![point(10.83, 1.0, 0.0), point(12.0, 1.0, 0.0)]),
            "height_m is 12, but must lie on the structure: between 0 and its top at 10.830 m",
        ),
        (
            with(vec![point(1.0, f64::INFINITY, 0.0)]),
            "mode 1: displacement of a shape point is inf, but must be a finite number",
        ),
        (
            with(vec![point(1.0, 0.0, 0.0), point(2.0, 0.0, 0.0)]),
            "mode 1: largest displacement of the shape is 0, but must be other than 0: leave the shape out",
        ),
    ];
    for (modes, message) in cases {
        let fault = chain_stiffness(&chain, &modes, &ChainStiffness::default()).unwrap_err();
        assert_eq!(fault.to_string(), message);
    }
    let options = ChainStiffness {
        misfit_most: f64::NAN,
        ..Default::default()
    };
    assert_eq!(
        chain_stiffness(&chain, &[plain(1.0)], &options)
            .unwrap_err()
            .to_string(),
        "misfit_most is NaN, but must be a positive number"
    );
    let options = ChainStiffness {
        starts: 0,
        ..Default::default()
    };
    assert_eq!(
        chain_stiffness(&chain, &[plain(1.0)], &options)
            .unwrap_err()
            .to_string(),
        "starts is 0, but must be at least 1"
    );
}

#[test]
fn holds_a_top_centred_on_its_joint_does_not_stop_the_search() {
    // no mass above causes rotation at the top joint: its share of the weight moments is 0
    let link = |centroid_m: f64| Link {
        mass_kg: 1000.0,
        length_m: 2.0,
        centroid_m,
        inertia: Inertia::ThinRod,
        bed_width_m: None,
    };
    let chain = Chain::new(vec![link(1.0), link(0.0)], 9.81).unwrap();
    let modes = measured(&chain, &[2e5, 1e5], 1, &[]);
    let found = identify(&chain, &modes);
    assert_eq!(found.choice, Choice::Underdetermined, "{:?}", found.notes);
}
