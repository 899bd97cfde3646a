// SOURCE     Energy of springs, and of weights that descend as columns lean; linear algebra.
// GOAL       The matrices are those of the energies; a stiffness identified from frequencies reproduces them, and the
//            true one is always among those found.
//
//       δ_i = Y_i − Y_{i−1}        V = Σ ½ k_i e_i² + Σ ½ k_ab (Y_b − Y_a)² − Σ ½ (N_i/l_i) δ_i²
//       column i leans by δ_i/l_i  e_i = δ_i (drift) or Y_i (grounded); Y_0 = 0
//
// PARAMETERS Random frames of 1 to 4 storeys, with and without a tie.
// PUBLISHED  Nothing: laws.
// TOLERANCE  1e-12 relative to the sum of the absolute terms (rounding); frequencies of a solution 1e-9; the true
//            stiffness 1e-6, the distance at which two solutions are merged.

use dolmen::stability::frame_stability;
use dolmen::structure::{Convention, Frame, Storey, Tie, stiffness_from_frequencies};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// A frame, stiffnesses for which it is stable, and displacements.
#[derive(Clone, Debug)]
struct Drawn {
    frame: Frame,
    stiffness: Vec<f64>,
    displacement: Vec<f64>,
}

/// Mass, height, axial force before sorting, stiffness, displacement of one storey.
type Part = (f64, f64, f64, f64, f64);

fn drawn(storeys: std::ops::RangeInclusive<usize>) -> impl Strategy<Value = Drawn> {
    let storey = (5e4..5e5, 2.5..8.0, 0.0..6e6, 0.2..6.0, -1.0..1.0);
    let convention = prop_oneof![Just(Convention::Drift), Just(Convention::Grounded)];
    let tie = prop::option::of((0.0..1.0, 1e5..2e7));
    let parts = (
        prop::collection::vec(storey, storeys),
        convention,
        tie,
        1.05..20.0,
    );
    parts.prop_map(|(parts, convention, tie, load_factor): (Vec<Part>, _, _, f64)| {
        let mut axial: Vec<f64> = parts.iter().map(|p| p.2).collect();
        axial.sort_by(|a, b| b.total_cmp(a));
        let storeys = parts.iter().zip(axial).map(|(p, axial_n)| Storey {
            mass_kg: p.0,
            height_m: p.1,
            axial_n,
        });
        let mut frame = Frame::new(storeys.collect(), convention).unwrap();
        let n = parts.len();
        if let Some((place, stiffness_n_m)) = tie {
            let lower = (place * n as f64) as usize;
            let ties = vec![Tie {
                lower,
                upper: n,
                stiffness_n_m,
            }];
            frame = frame.with_ties(ties).unwrap();
        }
        // stiffer springs never lower the load factor: double them until it suffices
        let mut stiffness: Vec<f64> = parts.iter().map(|p| p.3 * 1e6).collect();
        while frame_stability(&frame, &stiffness).unwrap().load_factor < load_factor {
            stiffness.iter_mut().for_each(|k| *k *= 2.0);
        }
        Drawn {
            frame,
            stiffness,
            displacement: parts.iter().map(|p| p.4).collect(),
        }
    })
}

/// The same cases in every run.
fn config(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(1),
        ..ProptestConfig::default()
    }
}

fn frequencies(frame: &Frame, stiffness: &[f64]) -> Vec<f64> {
    let modes = frame.natural_modes(stiffness).unwrap();
    modes.iter().map(|mode| mode.frequency_hz).collect()
}

proptest! {
    #![proptest_config(config(300))]

    #[test]
    fn exact_matrices_are_those_of_the_energies(d in drawn(1..=6)) {
        let y = &d.displacement;
        let level = |i: usize| if i == 0 { 0.0 } else { y[i - 1] };
        let mut terms = Vec::new();
        for (i, storey) in d.frame.storeys().iter().enumerate() {
            let drift = level(i + 1) - level(i);
            let seen = match d.frame.convention() {
                Convention::Drift => drift,
                Convention::Grounded => level(i + 1),
            };
            terms.push(d.stiffness[i] * seen * seen);
            terms.push(-storey.axial_n / storey.height_m * drift * drift);
        }
        for tie in d.frame.ties() {
            terms.push(tie.stiffness_n_m * (level(tie.upper) - level(tie.lower)).powi(2));
        }
        let k = d.frame.stiffness_matrix(&d.stiffness).unwrap();
        let size: f64 = terms.iter().map(|t| t.abs()).sum();
        prop_assert!((k.form(y, y) - terms.iter().sum::<f64>()).abs() <= 1e-12 * size);
        prop_assert_eq!(&k, &k.transpose());
    }

    #[test]
    fn exact_a_frame_on_nothing_translates_freely(d in drawn(2..=6)) {
        // drift springs, no stiffness in storey 1 and no tie to the ground: moving all levels together needs no force
        let storeys = d.frame.storeys().to_vec();
        let ties = d.frame.ties().iter().copied().filter(|tie| tie.lower > 0).collect();
        let frame = Frame::new(storeys, Convention::Drift).unwrap().with_ties(ties).unwrap();
        let mut stiffness = d.stiffness.clone();
        stiffness[0] = 0.0;
        let force = frame.elastic_matrix(&stiffness).unwrap().times(&vec![1.0; stiffness.len()]);
        let size: f64 = d.stiffness.iter().sum::<f64>() + 2e7;
        prop_assert!(force.iter().all(|f| f.abs() <= 1e-14 * size), "{:?}", force);
        // and P-delta then acts on the lowest storey alone
        let lean = frame.geometric_matrix().times(&vec![1.0; stiffness.len()]);
        prop_assert!((lean[0] - frame.geometric_n_m()[0]).abs() <= 1e-12 * frame.geometric_n_m()[0]);
    }

    #[test]
    fn holds_more_stiffness_raises_and_more_weight_lowers_every_frequency(d in drawn(1..=6), which in 0..6_usize) {
        let before = frequencies(&d.frame, &d.stiffness);
        let mut stiffer = d.stiffness.clone();
        let which = which % stiffer.len();
        stiffer[which] *= 1.3;
        let after = frequencies(&d.frame, &stiffer);
        prop_assert!(before.iter().zip(&after).all(|(b, a)| *a >= b * (1.0 - 1e-12)));
        let mut lighter = d.frame.storeys().to_vec();
        lighter.iter_mut().for_each(|storey| storey.axial_n *= 0.5);
        let lighter = Frame::new(lighter, d.frame.convention()).unwrap().with_ties(d.frame.ties().to_vec()).unwrap();
        let after = frequencies(&lighter, &d.stiffness);
        prop_assert!(before.iter().zip(&after).all(|(b, a)| *a >= b * (1.0 - 1e-12)));
    }
}

proptest! {
    #![proptest_config(config(60))]

    #[test]
    fn holds_the_true_stiffness_is_among_the_roots_and_all_give_the_frequencies(d in drawn(2..=4)) {
        let f = frequencies(&d.frame, &d.stiffness);
        // two coinciding modes are a single measurement
        prop_assume!(f.windows(2).all(|pair| pair[1] > pair[0] * (1.0 + 1e-3)));
        let roots = stiffness_from_frequencies(&d.frame, &f).unwrap();
        prop_assert!(roots.complete, "{:?}", roots.notes);
        let true_one = |root: &&Vec<f64>| root.iter().zip(&d.stiffness).all(|(a, b)| (a / b - 1.0).abs() < 1e-6);
        prop_assert_eq!(roots.stiffness.iter().filter(true_one).count(), 1);
        for root in &roots.stiffness {
            for (computed, f) in frequencies(&d.frame, root).iter().zip(&f) {
                prop_assert!((computed / f - 1.0).abs() < 1e-9);
            }
        }
    }
}
