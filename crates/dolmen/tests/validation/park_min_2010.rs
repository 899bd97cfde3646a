// SOURCE     Park, S.-A. & Min, K.-W. (2010) Simple structural model of Heunginjimun with Coulomb friction.
// GOAL       Eq. 7 as printed; every pair of stiffnesses with the measured frequencies; the load that the paper's P1
//            counts twice; and what a shape can decide but frequencies alone cannot.
//
//      m2 ===== Y2     P2 = 3077 kN
//         |   |
//      k2 |   | l2 = 7.69 m        drift: k2 acts on Y2 − Y1; grounded (eq. 7 as printed): on Y2
//      m1 ===== Y1     P1 = 5919 kN, which holds P2 already: P1 − P2 = 290 t · g
//      k1 |   | l1 = 5.84 m
//      ///////////
//
// PARAMETERS m = 290, 314 t; weak axis 1.1, 4.2 Hz (1.3 Hz twists and is kept out).
// PUBLISHED  k = 202, 15.1 kN/mm. The rest (exact_): computed independently of this code, or by known::park_min_2010.
// TOLERANCE  half a unit of the last printed digit; published stiffness: the effect of ±0.05 Hz.

use super::published::of;
use dolmen::comparisons::{heunginjimun_gate, heunginjimun_gate_as_printed};
use dolmen::known::park_min_2010 as paper;
use dolmen::structure::{
    Choice, Convention, Frame, FrameStiffness, MeasuredMode, ShapePoint, StiffnessSolutions, Storey,
    frame_stiffness, stiffness_from_frequencies, stiffness_from_shape, stiffness_range,
};

const MN: f64 = 1e6;

fn roots(frame: &Frame, frequencies_hz: &[f64]) -> Vec<Vec<f64>> {
    stiffness_from_frequencies(frame, frequencies_hz)
        .unwrap()
        .stiffness
}

fn frequency(frequency_hz: f64, frequency_sd_hz: f64) -> MeasuredMode {
    MeasuredMode {
        frequency_hz,
        frequency_sd_hz,
        frequency_changes_hz: Vec::new(),
        shape: vec![],
    }
}

fn with_shape(mode: MeasuredMode, points: &[(f64, f64)], displacement_sd: f64) -> MeasuredMode {
    let shape = points.iter().map(|&(height_m, displacement)| ShapePoint {
        height_m,
        displacement,
        displacement_sd,
    });
    MeasuredMode {
        shape: shape.collect(),
        ..mode
    }
}

fn found(frame: &Frame, modes: &[MeasuredMode]) -> StiffnessSolutions {
    frame_stiffness(frame, modes, &FrameStiffness::default()).unwrap()
}

#[track_caller]
fn assert_written(computed: &[f64], written: &[f64], digit: f64) {
    assert_eq!(computed.len(), written.len());
    for (c, w) in computed.iter().zip(written) {
        assert!(
            (c / MN - w).abs() <= 0.5 * digit,
            "{} computed, {w} written",
            c / MN
        );
    }
}

#[test]
fn published_eq_7_is_the_grounded_matrix_with_p2_counted_twice() {
    let gate = heunginjimun_gate_as_printed(Convention::Grounded).unwrap();
    let k = gate.stiffness_matrix(&[202.0 * MN, 15.1 * MN]).unwrap();
    let printed = paper::matrix_kn_m(paper::STIFFNESS_KN_MM);
    for (i, row) in printed.iter().enumerate() {
        for (j, entry) in row.iter().enumerate() {
            assert!(
                (k[(i, j)] / (1e3 * entry) - 1.0).abs() < 1e-14,
                "row {i}, column {j}"
            );
        }
    }
}

#[test]
fn published_stiffness_lies_within_the_rounding_of_the_frequencies() {
    let gate = heunginjimun_gate_as_printed(Convention::Grounded).unwrap();
    let root = &roots(&gate, &paper::WEAK_HZ)[1];
    let range = stiffness_range(&gate, &paper::WEAK_HZ, &[paper::ROUNDING_HZ; 2], root).unwrap();
    assert!(range.exists_throughout);
    assert_written(&[range.lower[0], range.upper[0]], &[199.0, 209.0], 1.0);
    assert_written(&[range.lower[1], range.upper[1]], &[14.1, 16.8], 0.1);
    for i in 0..2 {
        let published = paper::STIFFNESS_KN_MM[i] * MN;
        assert!(
            range.lower[i] < published && published < range.upper[i],
            "k{}",
            i + 1
        );
    }
    // The printed stiffness needs these frequencies, which are 1.1 and 4.2 Hz rounded.
    let modes = gate
        .natural_modes(&paper::STIFFNESS_KN_MM.map(|k| k * MN))
        .unwrap();
    for ((mode, closed), written) in modes
        .iter()
        .zip(paper::frequencies_hz([202.0, 15.1]))
        .zip([1.0889, 4.1802])
    {
        assert!(
            (mode.frequency_hz - written).abs() < 5e-5,
            "{}",
            mode.frequency_hz
        );
        assert!((mode.frequency_hz / closed - 1.0).abs() < 1e-13);
    }
}

#[test]
fn exact_both_roots_of_the_printed_case() {
    let gate = heunginjimun_gate_as_printed(Convention::Grounded).unwrap();
    let roots = roots(&gate, &paper::WEAK_HZ);
    assert_eq!(roots.len(), 2);
    assert_written(&roots[0], &[15.7943, 219.0687], 1e-4);
    assert_written(&roots[1], &[203.8955, 15.4004], 1e-4);
    for (root, closed) in roots.iter().zip(paper::stiffness_kn_mm(paper::WEAK_HZ).unwrap()) {
        for (k, closed) in root.iter().zip(closed) {
            assert!((k / (closed * MN) - 1.0).abs() < 1e-12);
        }
    }
}

#[test]
fn exact_without_counting_p2_twice_k1_is_203_4() {
    let gate = heunginjimun_gate(Convention::Grounded).unwrap();
    let roots = roots(&gate, &paper::WEAK_HZ);
    assert_written(&[roots[1][0]], &[203.4], 0.1);
    // the difference is P2/l1, only in k1
    let twice = stiffness_from_frequencies(
        &heunginjimun_gate_as_printed(Convention::Grounded).unwrap(),
        &paper::WEAK_HZ,
    )
    .unwrap();
    assert!((twice.stiffness[1][0] - roots[1][0] - 3077e3 / 5.84).abs() < 1e-3);
    assert!((twice.stiffness[1][1] - roots[1][1]).abs() < 1e-3);
}

#[test]
fn exact_both_roots_of_storeys_on_drift_and_their_shapes() {
    let gate = heunginjimun_gate(Convention::Drift).unwrap();
    let roots = roots(&gate, &paper::WEAK_HZ);
    assert_eq!(roots.len(), 2);
    assert_written(&roots[0], &[32.65, 96.14], 1e-2);
    assert_written(&roots[1], &[185.18, 16.85], 1e-2);
    for (root, ratio) in roots.iter().zip([0.843, 0.088]) {
        let modes = gate.natural_modes(root).unwrap();
        for (mode, f) in modes.iter().zip(paper::WEAK_HZ) {
            assert!((mode.frequency_hz / f - 1.0).abs() < 1e-12);
        }
        let shape = &modes[0].displacement;
        assert!((shape[0] / shape[1] - ratio).abs() < 5e-4, "{shape:?}");
    }
}

#[test]
fn exact_two_storeys_on_drift_need_frequencies_far_enough_apart() {
    // r + 1/r ≥ 2√(1 + m2/m1): r ≥ √(1 + m2/m1) + √(m2/m1)
    let gate = heunginjimun_gate(Convention::Drift).unwrap();
    let quotient: f64 = 314.0 / 290.0;
    let least = (1.0 + quotient).sqrt() + quotient.sqrt();
    assert_eq!(roots(&gate, &[1.0, least * (1.0 + 1e-9)]).len(), 2);
    let none = stiffness_from_frequencies(&gate, &[1.0, least * (1.0 - 1e-9)]).unwrap();
    assert!(none.stiffness.is_empty() && none.complete);
    let none = found(&gate, &[frequency(1.1, 0.0), frequency(2.0, 0.0)]);
    assert_eq!((none.choice, none.solutions.len()), (Choice::Impossible, 0));
    assert!(
        none.notes[0].to_string().starts_with(
            "No stiffness gives these two frequencies: their ratio r = f2/f1 is 1.8182, so r + 1/r is 2.3682, but two \
             storeys on springs between them need r + 1/r ≥ 2√(1 + m2/m1) = 2.8864, a ratio of 2.4837 at least."
        ),
        "{}",
        none.notes[0]
    );
}

#[test]
fn exact_two_grounded_storeys_need_frequencies_apart_by_their_coupling() {
    // λ2 − λ1 ≥ 2 (N2/l2)/√(m1 m2)
    let gate = heunginjimun_gate(Convention::Grounded).unwrap();
    let apart = 2.0 * 3077.0 / 7.69 / (290.0_f64 * 314.0).sqrt();
    let second = |apart: f64| ((std::f64::consts::TAU).powi(2) + apart).sqrt() / std::f64::consts::TAU;
    assert_eq!(roots(&gate, &[1.0, second(apart * (1.0 + 1e-9))]).len(), 2);
    let none = stiffness_from_frequencies(&gate, &[1.0, second(apart * (1.0 - 1e-9))]).unwrap();
    assert!(none.stiffness.is_empty());
    assert!(
        none.notes[0].to_string().contains("ω2² − ω1² is 2.6520 (rad/s)²"),
        "{}",
        none.notes[0]
    );
}

#[test]
fn holds_frequencies_alone_never_choose() {
    for convention in [Convention::Drift, Convention::Grounded] {
        let gate = heunginjimun_gate(convention).unwrap();
        let sd = paper::ROUNDING_HZ / 3.0_f64.sqrt();
        let found = found(&gate, &paper::WEAK_HZ.map(|f| frequency(f, sd)));
        assert_eq!(
            (found.choice, found.solutions.len()),
            (Choice::Indistinguishable, 2)
        );
        for (solution, root) in found.solutions.iter().zip(roots(&gate, &paper::WEAK_HZ)) {
            assert!(solution.stands && solution.misfit < 1e-9);
            for (k, root) in solution.stiffness.iter().zip(&root) {
                assert!((k / root - 1.0).abs() < 1e-9);
            }
            // the range is that of rounding by ±0.05 Hz
            let range = solution.stiffness_range.as_ref().unwrap();
            let direct = stiffness_range(&gate, &paper::WEAK_HZ, &[paper::ROUNDING_HZ; 2], &root).unwrap();
            for i in 0..2 {
                assert!((range.lower[i] / direct.lower[i] - 1.0).abs() < 1e-9);
                assert!((range.upper[i] / direct.upper[i] - 1.0).abs() < 1e-9);
            }
        }
    }
}

#[test]
fn exact_standard_deviation_is_that_of_the_roots_slope() {
    // sd(k)² = Σ (∂k/∂f_j)² sd_j², slopes of the closed form by central difference
    let gate = heunginjimun_gate_as_printed(Convention::Grounded).unwrap();
    let sd = [0.01, 0.03];
    let modes = [frequency(1.1, sd[0]), frequency(4.2, sd[1])];
    let found = found(&gate, &modes);
    const STEP: f64 = 1e-4; // central difference of a smooth function: error of order STEP²
    for (which, solution) in found.solutions.iter().enumerate() {
        for i in 0..2 {
            let slope = |j: usize| {
                let moved = |by: f64| {
                    let mut f = paper::WEAK_HZ;
                    f[j] += by;
                    paper::stiffness_kn_mm(f).unwrap()[which][i] * MN
                };
                (moved(STEP) - moved(-STEP)) / (2.0 * STEP)
            };
            let exact = (slope(0) * sd[0]).hypot(slope(1) * sd[1]);
            let computed = solution.stiffness_sd.as_ref().unwrap()[i];
            assert!((computed / exact - 1.0).abs() < 1e-6, "{computed} {exact}");
        }
    }
}

#[test]
fn holds_a_measured_shape_chooses() {
    let gate = heunginjimun_gate(Convention::Drift).unwrap();
    for (ratio, which) in [(0.843, 0), (0.088, 1)] {
        let first = with_shape(frequency(1.1, 0.01), &[(5.84, ratio), (13.53, 1.0)], 0.03);
        let found = found(&gate, &[first, frequency(4.2, 0.01)]);
        assert_eq!((found.choice, found.solutions.len()), (Choice::One, 1));
        let root = &roots(&gate, &paper::WEAK_HZ)[which];
        for (k, root) in found.solutions[0].stiffness.iter().zip(root) {
            assert!((k / root - 1.0).abs() < 1e-3, "{k} {root}"); // the ratio is written to three digits
        }
    }
    // a sensor half-way up a storey has half of its drift
    let half = with_shape(
        frequency(1.1, 0.01),
        &[(2.92, 0.5 * 0.843), (9.685, 0.5 * 1.843)],
        0.01,
    );
    let found = found(&gate, &[half, frequency(4.2, 0.01)]);
    assert_eq!(found.choice, Choice::One);
    assert_written(&found.solutions[0].stiffness, &[32.65, 96.14], 0.2);
}

#[test]
fn exact_one_shape_is_enough_without_the_second_frequency() {
    for convention in [Convention::Drift, Convention::Grounded] {
        let gate = heunginjimun_gate(convention).unwrap();
        for root in roots(&gate, &paper::WEAK_HZ) {
            let mode = &gate.natural_modes(&root).unwrap()[0];
            let direct = stiffness_from_shape(&gate, 1.1, &mode.displacement).unwrap();
            let points = [(5.84, mode.displacement[0]), (13.53, mode.displacement[1])];
            let fitted = found(&gate, &[with_shape(frequency(1.1, 1e-6), &points, 1e-6)]);
            for i in 0..2 {
                assert!((direct[i] / root[i] - 1.0).abs() < 1e-9);
                assert!((fitted.solutions[0].stiffness[i] / root[i] - 1.0).abs() < 1e-6);
            }
            assert_eq!(fitted.choice, Choice::One);
        }
    }
}

#[test]
fn holds_one_frequency_of_the_strong_axis_is_an_honest_answer() {
    let gate = heunginjimun_gate(Convention::Drift).unwrap();
    let found = found(&gate, &[frequency(paper::STRONG_HZ, 0.029)]);
    assert_eq!(
        (found.choice, found.solutions.len()),
        (Choice::Underdetermined, 1)
    );
    assert_eq!(found.visibility.as_ref().unwrap().free_directions, 1);
    assert_eq!(found.solutions[0].stiffness_sd, None);
    assert!((found.solutions[0].modes[0].frequency_hz / paper::STRONG_HZ - 1.0).abs() < 1e-9);
    assert!(
        found.notes[0]
            .to_string()
            .starts_with("1 frequency gives 1 independent datum for 2 storey stiffnesses: "),
        "{}",
        found.notes[0]
    );
}

#[test]
fn exact_grounded_storeys_without_p_delta_take_the_frequencies_in_any_order() {
    let masses = [1e5, 2e5, 3e5];
    let storeys = masses.map(|mass_kg| Storey {
        mass_kg,
        height_m: 3.0,
        axial_n: 0.0,
    });
    let frame = Frame::new(storeys.to_vec(), Convention::Grounded).unwrap();
    let f = [1.0, 2.0, 3.5];
    let roots = roots(&frame, &f);
    assert_eq!(roots.len(), 6);
    for order in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
        let exact = [0, 1, 2].map(|i| masses[i] * (std::f64::consts::TAU * f[order[i]]).powi(2));
        let is = |root: &&Vec<f64>| root.iter().zip(exact).all(|(k, e)| (k / e - 1.0).abs() < 1e-9);
        assert_eq!(roots.iter().filter(is).count(), 1, "{order:?}");
    }
}

#[test]
fn refuses_modes_that_no_gate_has() {
    let gate = heunginjimun_gate(Convention::Drift).unwrap();
    let message = |modes: &[MeasuredMode]| {
        frame_stiffness(&gate, modes, &FrameStiffness::default())
            .unwrap_err()
            .to_string()
    };
    assert_eq!(
        message(&[]),
        "no measured mode is given, but stiffness needs at least 1"
    );
    assert_eq!(
        message(&[1.1, 1.3, 4.2].map(|f| frequency(f, 0.0))),
        "3 measured modes are given, but a structure of 2 storeys has only 2: give the lowest 2"
    );
    assert_eq!(
        message(&[frequency(-1.1, 0.0)]),
        "mode 1: frequency_hz is -1.1, but must be a positive number"
    );
    assert!(
        message(&[4.2, 1.1].map(|f| frequency(f, 0.0))).starts_with("mode 2: frequency_hz is 1.1, not above")
    );
    assert_eq!(
        message(&[with_shape(frequency(1.1, 0.0), &[(5.84, 0.8), (14.0, 1.0)], 0.0)]),
        "height_m is 14, but must lie on the structure: between 0 and its top at 13.530 m"
    );
}

#[test]
fn published_cases_agree_within_their_tolerance() {
    assert_eq!(of("Park & Min (2010)").len(), 4);
}

/// Two equal storeys without axial force whose k1 is twice k2; the two solutions meet at 1.92602 and 4.64981 Hz.
fn double_root() -> Frame {
    let storey = Storey {
        mass_kg: 200e3,
        height_m: 4.0,
        axial_n: 0.0,
    };
    Frame::new(vec![storey; 2], Convention::Drift).unwrap()
}

fn says(found: &StiffnessSolutions, words: &str) -> bool {
    found.notes.iter().any(|note| note.to_string().contains(words))
}

#[test]
fn holds_one_is_never_said_beside_another_accepted_solution() {
    let gate = heunginjimun_gate(Convention::Drift).unwrap();
    let first = |ratio: f64, sd: f64| {
        let mut first = with_shape(frequency(1.1, 0.01), &[(5.84, ratio), (13.53, 1.0)], sd);
        first.shape[1].displacement_sd = 0.0;
        first
    };
    let vague = found(&gate, &[first(0.19, 0.3), frequency(4.2, 0.01)]);
    assert_eq!(vague.solutions.len(), 2);
    assert_eq!(vague.choice, Choice::Indistinguishable);
    let sharp = found(&gate, &[first(0.19, 0.1), frequency(4.2, 0.01)]);
    assert_eq!((sharp.choice, sharp.solutions.len()), (Choice::One, 1));
}

#[test]
fn holds_a_shape_five_per_cent_off_is_no_impossibility() {
    let gate = heunginjimun_gate(Convention::Drift).unwrap();
    let first = with_shape(frequency(1.1, 0.0), &[(5.84, 0.843 - 0.05), (13.53, 1.0)], 0.0);
    let found = found(&gate, &[first, frequency(4.2, 0.0)]);
    assert_eq!((found.choice, found.solutions.len()), (Choice::One, 1));
    assert!((found.solutions[0].stiffness[0] / (32.65 * MN) - 1.0).abs() < 0.05);
    assert_eq!(found.solutions[0].stiffness_sd, None, "none was measured");
    assert!(
        says(&found, "The shape of mode 1, given without standard deviations"),
        "{:?}",
        found.notes
    );
}

#[test]
fn holds_rounded_frequencies_of_a_double_root_have_a_solution() {
    for sd in [0.0, 0.003] {
        let found = found(&double_root(), &[frequency(1.93, sd), frequency(4.65, sd)]);
        assert_eq!(found.choice, Choice::Indistinguishable, "{:?}", found.notes);
        assert_eq!(found.solutions.len(), 1);
        let k = &found.solutions[0].stiffness;
        assert!((k[0] / k[1] / 2.0 - 1.0).abs() < 0.1, "{k:?}");
        assert_eq!(found.solutions[0].stiffness_sd, None);
        assert!(says(&found, "Next to a double root"), "{:?}", found.notes);
    }
}

#[test]
fn holds_no_interval_is_stated_where_two_solutions_meet() {
    let modes = double_root().natural_modes(&[100.0 * MN, 50.0 * MN]).unwrap();
    for sd in [0.0, 0.01] {
        let exact: Vec<_> = modes
            .iter()
            .map(|mode| frequency(mode.frequency_hz, sd))
            .collect();
        let found = found(&double_root(), &exact);
        assert_eq!(found.choice, Choice::Indistinguishable);
        assert!(
            found
                .solutions
                .iter()
                .all(|solution| solution.stiffness_sd.is_none())
        );
        assert!(
            says(&found, "No linear interval exists. Measure a shape."),
            "{:?}",
            found.notes
        );
    }
}

#[test]
fn holds_a_solution_that_vanishes_within_its_range_is_said() {
    let gate = heunginjimun_gate(Convention::Drift).unwrap();
    let sd = paper::ROUNDING_HZ / 3.0_f64.sqrt();
    let near = found(&gate, &[1.7, 4.25].map(|f| frequency(f, sd)));
    let words = "not everywhere within that range do these frequencies have a solution";
    assert!(says(&near, words), "{:?}", near.notes);
    assert!(!says(
        &found(&gate, &paper::WEAK_HZ.map(|f| frequency(f, sd))),
        words
    ));
}

#[test]
fn holds_there_is_no_other_only_for_exactly_these_frequencies() {
    let gate = heunginjimun_gate(Convention::Drift).unwrap();
    let found = found(&gate, &paper::WEAK_HZ.map(|f| frequency(f, 0.0)));
    assert!(
        says(&found, "so for exactly these frequencies there is no other"),
        "{:?}",
        found.notes
    );
}

#[test]
fn holds_a_split_left_free_does_not_hide_its_storeys() {
    let gate = heunginjimun_gate(Convention::Drift).unwrap();
    let one = found(&gate, &[frequency(paper::STRONG_HZ, 0.029)]);
    assert!(!says(&one, "hardly see"), "{:?}", one.notes);
}
