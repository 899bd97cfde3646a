// SOURCE     Lagrange's equations of n rigid links (Choi 2021, eqs 3–28), and linear algebra.
// GOAL       Matrices are those of kinetic and potential energy; every stability number has its defined
//            meaning.
//
//          /θ_i        x_i = Σ_{j<i} L_j θ_j + l_i θ_i        T = Σ ½ m_i x_i'² + ½ J_i θ_i'²
//         /            z_i = const − ½ (Σ_{j<i} L_j θ_j² + l_i θ_i²)
//        o             V = Σ w_i z_i + Σ ½ k_i (θ_i − θ_{i−1})²
//
// PARAMETERS Random chains of 1 to 8 links, seeds below; one link where a closed form exists.
// PUBLISHED  Nothing: laws.
// TOLERANCE  1e-12 relative (rounding of sums of up to 100 terms), 1e-9 where a matrix is inverted.

use crate::draws::Draws;
use dolmen::stability::{Verdict, chain_limits, chain_stability, failing_joint};
use dolmen::structure::{Chain, Inertia, Link, SideSupport};
use dolmen_linalg::{Matrix, solve, symmetric_eigenvalues};

fn close(a: f64, b: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance * (1.0 + a.abs().max(b.abs()))
}

/// Stiffness at which a chain is stable with a load factor of `load_factor`; the joints scatter.
fn standing(chain: &Chain, draw: &mut Draws, load_factor: f64) -> Vec<f64> {
    let scattered: Vec<f64> = chain
        .necessary_n_m_rad()
        .iter()
        .map(|m| m * draw.between(0.5, 4.0))
        .collect();
    let now = chain_stability(chain, &scattered).unwrap().load_factor;
    scattered.iter().map(|k| k * load_factor / now).collect()
}

#[test]
fn exact_matrices_are_those_of_the_energies() {
    let mut draw = Draws::new(1);
    for n in 1..=8 {
        let chain = draw.chain(n);
        let k: Vec<f64> = (0..n).map(|_| draw.between(1e4, 1e6)).collect();
        let theta: Vec<f64> = (0..n).map(|_| draw.between(-1.0, 1.0)).collect();
        let (mut kinetic, mut potential, mut momentum) = (0.0, 0.0, 0.0);
        let (mut x, mut drop, mut before) = (0.0, 0.0, 0.0);
        for (i, link) in chain.links().iter().enumerate() {
            let t = theta[i];
            let speed = x + link.centroid_m * t;
            kinetic += 0.5 * link.mass_kg * speed * speed + 0.5 * link.inertia_kg_m2() * t * t;
            momentum += link.mass_kg * speed;
            potential -= link.mass_kg * 9.81 * (drop + 0.5 * link.centroid_m * t * t);
            potential += 0.5 * k[i] * (t - before).powi(2);
            (x, drop, before) = (x + link.length_m * t, drop + 0.5 * link.length_m * t * t, t);
        }
        assert!(close(
            0.5 * chain.mass_matrix().form(&theta, &theta),
            kinetic,
            1e-12
        ));
        let stiffness = chain.stiffness_matrix(&k).unwrap();
        assert!(close(0.5 * stiffness.form(&theta, &theta), potential, 1e-12));
        let gamma = chain.base_influence_kg_m();
        assert!(close(
            gamma.iter().zip(&theta).map(|(g, t)| g * t).sum(),
            momentum,
            1e-12
        ));
        assert!(close(
            chain.displacement_at(&theta, chain.height_m()).unwrap(),
            x,
            1e-12
        ));
        let damping = chain.damping_matrix(&k).unwrap();
        assert_eq!(
            damping,
            chain.elastic_stiffness_matrix(&k).unwrap(),
            "the same joints"
        );
    }
}

#[test]
fn holds_modes_are_orthogonal_and_scaled_to_their_largest_displacement() {
    let mut draw = Draws::new(2);
    let chain = draw.chain(6);
    let k = standing(&chain, &mut draw, 3.0);
    let modes = chain.natural_modes(&k).unwrap();
    let mass = chain.mass_matrix();
    for (i, a) in modes.iter().enumerate() {
        let most = a.displacement.iter().fold(0.0_f64, |most, u| most.max(u.abs()));
        assert!((most - 1.0).abs() < 1e-15 && a.displacement.contains(&1.0));
        for (z, u) in chain.joint_heights_m().iter().skip(1).zip(&a.displacement) {
            assert!(close(
                chain.displacement_at(&a.coordinates, *z).unwrap(),
                *u,
                1e-12
            ));
        }
        for b in &modes[..i] {
            let own = (mass.form(&a.coordinates, &a.coordinates) * mass.form(&b.coordinates, &b.coordinates))
                .sqrt();
            assert!(mass.form(&a.coordinates, &b.coordinates).abs() < 1e-10 * own);
        }
    }
}

#[test]
fn exact_least_stiffness_of_a_joint_makes_the_chain_just_stand() {
    let mut draw = Draws::new(3);
    for n in 1..=8 {
        for load_factor in [0.95, 1.05, 3.0] {
            let chain = draw.chain(n);
            let k = standing(&chain, &mut draw, load_factor);
            let joints = chain_stability(&chain, &k).unwrap().joints;
            for (i, joint) in joints.iter().enumerate() {
                let Some(least) = joint.stiffness_least_n_m_rad else {
                    let mut rigid = k.clone();
                    rigid[i] = 1e15;
                    assert!(failing_joint(&chain, &rigid).unwrap().is_some());
                    continue;
                };
                assert!(close(joint.margin.unwrap(), k[i] / least, 1e-15));
                for (factor, stands) in [(1.0 - 1e-9, false), (1.0 + 1e-9, true)] {
                    let mut changed = k.clone();
                    changed[i] = least * factor;
                    assert_eq!(
                        failing_joint(&chain, &changed).unwrap().is_none(),
                        stands,
                        "n = {n}, joint {i}"
                    );
                }
            }
        }
    }
}

#[test]
fn exact_least_stiffness_is_k_minus_one_over_the_flexibility() {
    let mut draw = Draws::new(4);
    for n in 1..=8 {
        let chain = draw.chain(n);
        let k = standing(&chain, &mut draw, 1.3);
        let matrix = chain.stiffness_matrix(&k).unwrap();
        for (i, joint) in chain_stability(&chain, &k).unwrap().joints.iter().enumerate() {
            let b: Vec<f64> = (0..n)
                .map(|j| f64::from(u8::from(j == i)) - f64::from(u8::from(j + 1 == i)))
                .collect();
            let flexibility: f64 = {
                let x = solve(&matrix, &Matrix::from_column(&b)).unwrap();
                x.column(0).iter().zip(&b).map(|(x, b)| x * b).sum()
            };
            let least = k[i] - 1.0 / flexibility;
            assert!(close(joint.stiffness_least_n_m_rad.unwrap(), least, 1e-9));
        }
    }
}

#[test]
fn holds_load_factor_margins_and_brackets_agree() {
    let mut draw = Draws::new(5);
    for trial in 0..2000 {
        let n = 1 + trial % 12;
        let chain = draw.chain(n);
        let wanted = draw.between(0.5, 3.0);
        let k = standing(&chain, &mut draw, wanted);
        let stability = chain_stability(&chain, &k).unwrap();
        let factor = stability.stiffness_factor;
        assert!(close(stability.load_factor, wanted, 1e-12));
        assert!(stability.stiffness_factor_least <= factor * (1.0 + 1e-12));
        assert!(factor <= stability.stiffness_factor_most * (1.0 + 1e-12));
        let dunkerley: f64 = chain.necessary_n_m_rad().iter().zip(&k).map(|(m, k)| m / k).sum();
        assert!(close(stability.stiffness_factor_most, dunkerley, 1e-12));
        assert_eq!(stability.failing_joint.is_none(), wanted > 1.0);
        assert_eq!(stability.verdict == Verdict::Unstable, wanted < 1.0);
        let times = |by: f64| -> Vec<f64> { k.iter().map(|k| k * by * factor).collect() };
        assert!(failing_joint(&chain, &times(1.0 - 1e-10)).unwrap().is_some());
        assert!(failing_joint(&chain, &times(1.0 + 1e-10)).unwrap().is_none());
        if wanted > 1.0 {
            // a single joint can lose more than all joints together
            let margins = stability.joints.iter().map(|joint| joint.margin.unwrap());
            assert!(margins.fold(f64::INFINITY, f64::min) >= stability.load_factor * (1.0 - 1e-9));
        }
    }
}

#[test]
fn exact_lean_of_one_link_and_balance_of_many() {
    let mut draw = Draws::new(6);
    let chain = draw.chain(1);
    let k = standing(&chain, &mut draw, 4.0);
    let stability = chain_stability(&chain, &k).unwrap();
    assert!(close(stability.lean_amplification[0], 1.0 / (1.0 - 0.25), 1e-13));

    let chain = draw.chain(5);
    let k = standing(&chain, &mut draw, 1.7);
    let stability = chain_stability(&chain, &k).unwrap();
    let theta = &stability.lean_amplification;
    let g = chain.gravity_moments_n_m_rad();
    for (i, joint) in stability.joints.iter().enumerate() {
        // moment of the total weight above the joint, by statics
        let moment: f64 = g[i..].iter().zip(&theta[i..]).map(|(g, t)| g * t).sum();
        assert!(close(joint.lean_moment_n_m_rad.unwrap(), moment, 1e-11));
        let weight: f64 = chain.links()[i..].iter().map(|link| link.mass_kg * 9.81).sum();
        let limit = 0.5 * weight * chain.links()[i].bed_width_m.unwrap();
        assert!(close(joint.uplift_moment_n_m.unwrap(), limit, 1e-13));
        assert!(close(joint.uplift_tilt_rad.unwrap(), limit / moment, 1e-11));
    }
}

#[test]
fn exact_side_support_of_one_link() {
    // k_min = m g l − s z²,  λ m g l = k + s z²,  I ω² = k + s z² − m g l
    let link = Link {
        mass_kg: 800.0,
        length_m: 4.0,
        centroid_m: 2.0,
        inertia: Inertia::Box { breadth_m: 0.6 },
        bed_width_m: None,
    };
    let bare = Chain::new(vec![link], 10.0).unwrap();
    let support = |gap_m: f64| SideSupport {
        height_m: 3.0,
        stiffness_n_m: 1000.0,
        gap_m,
    };
    let held = bare.clone().with_side_support(support(0.0)).unwrap();
    let stability = chain_stability(&held, &[20_000.0]).unwrap();
    assert!(stability.side_support_counted);
    assert!(close(stability.load_factor, 29_000.0 / 16_000.0, 1e-13));
    assert!(close(
        stability.joints[0].stiffness_least_n_m_rad.unwrap(),
        7_000.0,
        1e-12
    ));
    let inertia = 800.0 * (4.0 + (0.36 + 16.0) / 12.0);
    let modes = held.natural_modes(&[20_000.0]).unwrap();
    assert!(close(modes[0].omega_squared, 13_000.0 / inertia, 1e-13));

    let loose = bare.clone().with_side_support(support(0.002)).unwrap();
    let (without, with_gap) = (
        chain_stability(&bare, &[20_000.0]),
        chain_stability(&loose, &[20_000.0]),
    );
    assert_eq!(without.unwrap(), with_gap.unwrap(), "with a gap it is left out");

    let strong = SideSupport {
        stiffness_n_m: 1e5,
        ..support(0.0)
    };
    let joint = &chain_stability(&bare.with_side_support(strong).unwrap(), &[10.0])
        .unwrap()
        .joints[0];
    assert_eq!(
        (joint.stiffness_least_n_m_rad, joint.margin),
        (Some(0.0), Some(f64::INFINITY))
    );
}

#[test]
fn holds_pivots_agree_with_eigenvalues_where_a_side_support_counts() {
    let mut draw = Draws::new(7);
    let mut stood = 0;
    for trial in 0..2000 {
        let n = 1 + trial % 8;
        let chain = draw.chain(n);
        let support = SideSupport {
            height_m: chain.height_m() * draw.between(0.1, 1.0),
            stiffness_n_m: 10_f64.powf(draw.between(2.0, 5.0)),
            gap_m: 0.0,
        };
        let chain = chain.with_side_support(support).unwrap();
        let k: Vec<f64> = chain
            .necessary_n_m_rad()
            .iter()
            .map(|m| m * draw.between(0.1, 4.0))
            .collect();
        let least = symmetric_eigenvalues(&chain.stiffness_matrix(&k).unwrap()).unwrap()[0];
        let stands = failing_joint(&chain, &k).unwrap().is_none();
        assert_eq!(stands, least > 0.0, "least eigenvalue {least}");
        let stability = chain_stability(&chain, &k).unwrap();
        assert_eq!(stands, stability.load_factor > 1.0);
        assert!(stability.stiffness_factor_least <= stability.stiffness_factor * (1.0 + 1e-12));
        assert!(stability.stiffness_factor <= stability.stiffness_factor_most * (1.0 + 1e-12));
        stood += usize::from(stands);
    }
    assert!(
        stood > 500 && stood < 1500,
        "{stood} stood: both answers must be common"
    );
}

#[test]
fn holds_the_single_mass_bounds_the_chain() {
    let mut draw = Draws::new(8);
    for n in 1..=6 {
        let chain = draw.chain(n);
        let k = standing(&chain, &mut draw, 2.0);
        let simple = chain.as_single_mass();
        let first = chain.natural_modes(&k).unwrap()[0].frequency_hz;
        let bound = simple.frequency_hz(k[0]).unwrap();
        assert!(close(
            simple.critical_stiffness_n_m_rad(),
            chain.necessary_n_m_rad()[0],
            1e-13
        ));
        assert!(if n == 1 {
            close(first, bound, 1e-12)
        } else {
            first < bound
        });
        assert!(simple.stiffness_n_m_rad(first).unwrap() <= k[0] * (1.0 + 1e-12));
        assert!(close(simple.stiffness_n_m_rad(bound).unwrap(), k[0], 1e-12));
    }
    let fault = draw
        .chain(2)
        .as_single_mass()
        .frequency_hz(f64::NAN)
        .unwrap_err()
        .to_string();
    assert_eq!(
        fault,
        "joint 1: stiffness_n_m_rad is NaN, but must be a positive number"
    );
}

#[test]
fn holds_a_published_stiffness_that_is_not_positive_has_no_factor() {
    // a short link under a tall one: k_cr,1 = G_1 − k_cr,2 < 0
    let link = |mass_kg: f64, length_m: f64, centroid_m: f64| Link {
        mass_kg,
        length_m,
        centroid_m,
        inertia: Inertia::ThinRod,
        bed_width_m: None,
    };
    let chain = Chain::new(vec![link(10.0, 0.1, 0.05), link(1000.0, 4.0, 2.0)], 9.81).unwrap();
    let limits = chain_limits(&chain).unwrap();
    assert!(limits.published_critical_n_m_rad[0] < 0.0);
    assert_eq!(limits.published_critical_factor, None);
    assert!(limits.necessary_factor > 1.0);
}

#[test]
fn refuses_impossible_chains_and_says_why() {
    let good = Link {
        mass_kg: 100.0,
        length_m: 2.0,
        centroid_m: 1.0,
        inertia: Inertia::ThinRod,
        bed_width_m: None,
    };
    let with = |change: fn(&mut Link)| {
        let mut link = good.clone();
        change(&mut link);
        Chain::new(vec![good.clone(), link], 9.81)
            .unwrap_err()
            .to_string()
    };
    let positive = "but must be a positive number";
    assert_eq!(
        with(|l| l.mass_kg = 0.0),
        format!("link 2: mass_kg is 0, {positive}")
    );
    assert_eq!(
        with(|l| l.length_m = f64::NAN),
        format!("link 2: length_m is NaN, {positive}")
    );
    assert_eq!(
        with(|l| l.bed_width_m = Some(-1.0)),
        format!("link 2: bed_width_m is -1, {positive}")
    );
    assert_eq!(
        with(|l| l.inertia = Inertia::Given(0.0)),
        format!("link 2: inertia_kg_m2 is 0, {positive}")
    );
    assert_eq!(
        with(|l| l.centroid_m = 2.5),
        "link 2: centroid_m is 2.5, but must lie between 0 and the link's length_m, 2"
    );
    assert_eq!(
        Chain::new(vec![], 9.81).unwrap_err().to_string(),
        "the chain has no links, but needs at least 1"
    );
    assert_eq!(
        Chain::new(vec![good.clone()], f64::NAN).unwrap_err().to_string(),
        "gravity_m_s2 is NaN, but must be a positive number (9.81 on Earth)"
    );
    let chain = Chain::new(vec![good.clone(), good.clone()], 9.81).unwrap();
    for (k, message) in [
        (
            vec![1.0],
            "stiffness_n_m_rad has 1 values, but the chain has 2 joints",
        ),
        (
            vec![1.0, 0.0],
            "joint 2: stiffness_n_m_rad is 0, but must be a positive number",
        ),
        (
            vec![f64::NAN, 1.0],
            "joint 1: stiffness_n_m_rad is NaN, but must be a positive number",
        ),
    ] {
        assert_eq!(chain_stability(&chain, &k).unwrap_err().to_string(), message);
        assert_eq!(failing_joint(&chain, &k).unwrap_err().to_string(), message);
        assert_eq!(chain.natural_modes(&k).unwrap_err().to_string(), message);
    }
    assert_eq!(
        chain.damping_matrix(&[1.0, -1.0]).unwrap_err().to_string(),
        "joint 2: damping_n_m_s_rad is -1, but must be 0 or a positive number"
    );
    assert_eq!(
        chain.with_centroid_changed(3, -0.2).unwrap_err().to_string(),
        "link 3 was asked for, but they are numbered from 1 at the bottom to 2"
    );
    let support = |height_m: f64, stiffness_n_m: f64, gap_m: f64| {
        let support = SideSupport {
            height_m,
            stiffness_n_m,
            gap_m,
        };
        chain.clone().with_side_support(support).unwrap_err().to_string()
    };
    assert_eq!(
        support(4.5, 1.0, 0.0),
        "height_m of the side support is 4.5, but must lie on the structure: between 0 and its top at 4.000 m"
    );
    assert_eq!(
        support(3.0, 0.0, 0.0),
        format!("side support 1: stiffness_n_m is 0, {positive}")
    );
    assert_eq!(
        support(3.0, 1.0, -0.1),
        "side support 1: gap_m is -0.1, but must be 0 or a positive number"
    );
}
