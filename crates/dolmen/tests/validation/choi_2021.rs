// SOURCE     Choi, J.-S. (2021) A study on dynamic analysis model and stability of stone cultural properties of
//            inverted pendulum type with 5 joints. J. Korea Inst. Struct. Maint. Insp.
// GOAL       Its tables to their last digit, and the correct results: when the pole is stable, and its
//            frequencies.
//
//        |5|          w [kN]  38.95 15.13 6.78 4.51 2.93
//        (k5          L [m]    3.68  2.61 1.63 1.54 1.37
//        |4|          l [m]    1.64  1.18 0.78 0.69 0.66
//        (k4
//        ...          K θ = K_springs θ − diag(G) θ,  G_i = w_i l_i + L_i Σ_{j>i} w_j
//        |1|
//        (k1
//      ///////
//
// PARAMETERS Table 1; thin rods where inertia matters; g = 9.81 and 9.80665 m/s².
// PUBLISHED  Tables 1 and 3, text below Table 2. The rest (exact_): computed independently of this code.
// TOLERANCE  half a unit of the last printed digit; a whole unit in Table 3, which truncates some digits.

use super::published::of;
use dolmen::comparisons::naju_flagpole;
use dolmen::known::choi_2021 as paper;
use dolmen::stability::{Verdict, chain_limits, chain_stability, failing_joint};
use dolmen::structure::Chain;
use dolmen_linalg::symmetric_eigenvalues;

pub(crate) fn naju() -> Chain {
    naju_flagpole(9.81).unwrap()
}

/// Asserts numbers written in units of `scale` with a tolerance of half of `digit`.
fn assert_written(computed: &[f64], scale: f64, written: &[f64], digit: f64) {
    assert_eq!(computed.len(), written.len());
    for (i, (c, w)) in computed.iter().zip(written).enumerate() {
        // rounding of the printed number, and a small margin for the last bit of c / scale
        assert!(
            (c / scale - w).abs() <= 0.5000001 * digit,
            "number {}: {} computed, {w} written",
            i + 1,
            c / scale
        );
    }
}

#[test]
fn published_every_case_agrees() {
    let cases = of("Choi (2021)");
    assert_eq!(cases.len(), 27);
    for case in cases {
        assert!(
            case.note.len() > 20,
            "{}: a number of an unsafe criterion needs its note",
            case.what
        );
    }
}

#[test]
fn published_critical_stiffness_is_the_printed_formula() {
    let limits = chain_limits(&naju()).unwrap();
    let printed = paper::critical_stiffness(&paper::WEIGHT_KN, &paper::LENGTH_M, &paper::CENTROID_M);
    assert_written(&limits.published_critical_n_m_rad, 1e3, &printed, 1e-10);
}

#[test]
fn exact_limits_of_the_flagpole() {
    let limits = chain_limits(&naju()).unwrap();
    let g = [171.8860, 54.9676, 17.4156, 7.6241, 1.9338];
    let k_cr = [128.6437, 43.2423, 11.7253, 5.6903, 1.9338];
    let m = [253.8271, 81.9411, 26.9735, 9.5579, 1.9338];
    let ph = [739.6890, 209.8525, 64.5588, 21.6504, 4.0141];
    let eigenvalues = [-44.8290, -5.8192, 0.0, 5.8192, 44.8290];
    assert_written(&limits.gravity_moment_n_m_rad, 1e3, &g, 1e-4);
    assert_written(&limits.published_critical_n_m_rad, 1e3, &k_cr, 1e-4);
    assert_written(&limits.necessary_n_m_rad, 1e3, &m, 1e-4);
    assert_written(&limits.published_buckling_n_m_rad, 1e3, &ph, 1e-4);
    assert_written(
        &limits.published_ratio,
        1.0,
        &[5.75, 4.85, 5.51, 3.80, 2.08],
        1e-2,
    );
    assert_written(&limits.published_eigenvalues_n_m_rad, 1e3, &eigenvalues, 1e-4);
    let factors = [
        limits.published_critical_factor.unwrap(),
        limits.necessary_factor,
        limits.published_buckling_factor,
    ];
    assert_written(&factors, 1.0, &[4.735605, 2.476536, 1.026526], 1e-6);
    assert_written(&[limits.equal_joints_n_m_rad], 1e3, &[291.9841], 1e-4);
}

#[test]
fn exact_the_published_stiffness_does_not_stand() {
    let chain = naju();
    let limits = chain_limits(&chain).unwrap();
    let stability = chain_stability(&chain, &limits.published_critical_n_m_rad).unwrap();
    assert_eq!(stability.verdict, Verdict::Unstable);
    assert_eq!(stability.failing_joint, Some(5));
    assert!(stability.lean_amplification.is_empty());
    assert_written(&[stability.stiffness_factor], 1.0, &[4.735605], 1e-6);
}

#[test]
fn exact_table_3_in_full_digits() {
    let written = [
        (3, [127.5860, 44.3000, 10.6676, 5.6903, 1.9338]),
        (5, [128.2569, 43.6291, 11.3385, 6.0771, 1.5470]),
    ];
    for (link, k_cr) in written {
        let effect = dolmen::assess::centroid_effect(&naju(), link, -0.2, None).unwrap();
        assert_written(&effect.published_critical_n_m_rad, 1e3, &k_cr, 1e-4);
    }
}

#[test]
fn holds_lowering_a_centroid_never_hurts() {
    let chain = naju();
    let limits = chain_limits(&chain).unwrap();
    let k: Vec<f64> = limits.necessary_n_m_rad.iter().map(|m| 3.0 * m).collect();
    let before = chain_stability(&chain, &k).unwrap().load_factor;
    let check = dolmen::assess::check_chain(&chain, Some(&k)).unwrap();
    assert_eq!(check.centroids.len(), 5);
    for effect in check.centroids {
        assert!(effect.load_factor.unwrap() > before);
        assert!(effect.equal_joints_n_m_rad < limits.equal_joints_n_m_rad);
        for (with, without) in effect.necessary_n_m_rad.iter().zip(&limits.necessary_n_m_rad) {
            assert!(with <= without);
        }
    }
}

#[test]
fn exact_margins_at_1_03_of_published_buckling() {
    let chain = naju();
    let limits = chain_limits(&chain).unwrap();
    let k: Vec<f64> = limits
        .published_buckling_n_m_rad
        .iter()
        .map(|ph| 1.03 * ph)
        .collect();
    let stability = chain_stability(&chain, &k).unwrap();
    let margins: Vec<f64> = stability
        .joints
        .iter()
        .map(|joint| joint.margin.unwrap())
        .collect();
    assert_written(&margins, 1.0, &[1.0347, 1.0166, 1.0121, 1.0125, 1.0220], 1e-4);
    assert_written(&[stability.load_factor], 1.0, &[1.0034], 1e-4);
    assert_eq!(stability.failing_joint, None);
    assert_eq!(stability.verdict, Verdict::Marginal);
}

#[test]
fn exact_frequencies_of_thin_rods_at_twice_the_least_stiffness() {
    let written = [
        (9.81, [0.222203, 0.693567, 1.571105, 2.778993, 4.949456]),
        (9.80665, [0.222165, 0.693448, 1.570837, 2.778518, 4.948610]),
    ];
    for (gravity, frequencies) in written {
        let chain = naju_flagpole(gravity).unwrap();
        let k: Vec<f64> = twice_the_least(&chain);
        let modes = chain.natural_modes(&k).unwrap();
        let computed: Vec<f64> = modes.iter().map(|mode| mode.frequency_hz).collect();
        assert_written(&computed, 1.0, &frequencies, 1e-6);
    }
}

/// k = 2 · 2.476536 · M, with all digits of the factor.
pub(crate) fn twice_the_least(chain: &Chain) -> Vec<f64> {
    let limits = chain_limits(chain).unwrap();
    let scale = 2.0 * limits.necessary_factor;
    limits.necessary_n_m_rad.iter().map(|m| scale * m).collect()
}

#[test]
fn holds_the_recursion_never_disagrees_with_the_eigenvalues() {
    // 100,000 chains of 1 to 12 links, each joint near the limit so that both answers are common
    let mut draw = crate::draws::Draws::new(2021);
    let (mut stood, mut ties) = (0, 0);
    const CHAINS: usize = 100_000;
    for _ in 0..CHAINS {
        let n = 1 + (draw.unit() * 12.0) as usize;
        let chain = draw.chain(n);
        let mut above = 0.0;
        let mut k: Vec<f64> = chain
            .gravity_moments_n_m_rad()
            .into_iter()
            .rev()
            .map(|g| {
                above += g;
                above * draw.between(0.2, 2.0 + n as f64)
            })
            .collect();
        k.reverse();
        let recursion = failing_joint(&chain, &k).unwrap().is_none();
        let matrix = chain.stiffness_matrix(&k).unwrap();
        let eigenvalues = symmetric_eigenvalues(&matrix).unwrap();
        let (least, most) = (eigenvalues[0], eigenvalues[n - 1].abs().max(eigenvalues[0].abs()));
        if least.abs() < 1e-13 * most * n as f64 {
            ties += 1; // its sign is rounding: neither answer can be said to be right
            continue;
        }
        assert_eq!(
            recursion,
            least > 0.0,
            "n = {n}, least eigenvalue {least}, stiffness {k:?}"
        );
        stood += usize::from(recursion);
    }
    assert!(ties <= 2, "{ties} ties");
    assert!(
        stood > CHAINS / 4 && stood < CHAINS * 3 / 4,
        "{stood} stood: both answers must be common"
    );
}
