// SOURCE     Closed forms of one floor; the forward modes of `Building`; Newton's method on the invariants of K, written here.
// GOAL       Every stiffness (and eccentricity) of one storey in plan with three measured frequencies, and their standard deviations.
// PARAMETERS 200 floors drawn at random: 10 to 1000 t, ρ 2 to 12 m, centre of rigidity up to ρ/2 off, frequencies 0.5 to 5 Hz, half of
//            them with P-delta.
// TOLERANCE  roots 1e-8, the accuracy of a root for frequencies with errors of 2e-10 and amplifications up to 50; closed forms 1e-12;
//            Monte Carlo 8 %, which is four standard errors for 1500 draws plus the nonlinearity at 0.5 %.

use dolmen::numeric::Random;
use dolmen::structure::Building;
use dolmen::structure::building::{
    EccentricityFrom, Floor, PDelta, PlanMode, PlanMotion, PlanSolution, PlanStiffness, PlanStiffnessError,
    PlanStorey, Storey, StoreyStiffness, Twist, plan_stiffness,
};
use std::f64::consts::TAU;

const GRAVITY: f64 = 9.81;

struct Drawn {
    storey: PlanStorey,
    stiffness: [f64; 3],
    height_m: Option<f64>,
}

fn within(random: &mut Random, low: f64, high: f64) -> f64 {
    low + (high - low) * random.uniform()
}

fn drawn(random: &mut Random) -> Drawn {
    let mass_kg = 1e4 * 100.0_f64.powf(random.uniform());
    let gyration_m = within(random, 2.0, 12.0);
    let height_m = (random.uniform() < 0.5).then(|| within(random, 3.0, 8.0));
    let weight_takes_n_m = height_m.map_or(0.0, |h| mass_kg * GRAVITY / h);
    let mut k = || mass_kg * (TAU * within(random, 0.5, 5.0)).powi(2) + weight_takes_n_m;
    let stiffness = [k(), k(), k() * gyration_m * gyration_m];
    let eccentricity_m = [0, 1].map(|_| gyration_m * within(random, -0.5, 0.5));
    Drawn {
        storey: PlanStorey {
            mass_kg,
            gyration_m,
            weight_takes_n_m,
            eccentricity_m,
        },
        stiffness,
        height_m,
    }
}

/// Frequencies, Hz, and shapes u, v, ρθ of energy 1, by the forward model.
fn forward(
    storey: &PlanStorey,
    height_m: Option<f64>,
    k: [f64; 3],
    e: [f64; 2],
) -> ([f64; 3], [[f64; 3]; 3]) {
    let floor = Floor {
        mass_kg: storey.mass_kg,
        centre_m: [3.0, -2.0],
        gyration_m: storey.gyration_m,
        outline: None,
    };
    let below = Storey {
        height_m: height_m.unwrap_or(4.0),
        stiffness: StoreyStiffness::at_centre(k[0], k[1], k[2], [3.0 + e[0], e[1] - 2.0]),
    };
    let p_delta = match height_m {
        Some(_) => PDelta::Weights {
            gravity_m_s2: GRAVITY,
        },
        None => PDelta::LeftOut,
    };
    let modes = Building::new(vec![floor], vec![below], p_delta)
        .unwrap()
        .modes()
        .unwrap()
        .modes;
    let root = storey.mass_kg.sqrt();
    let shape =
        |j: usize| [0, 1, 2].map(|i| modes[j].shape[i] * root * if i == 2 { storey.gyration_m } else { 1.0 });
    ([0, 1, 2].map(|j| modes[j].frequency_hz), [0, 1, 2].map(shape))
}

fn unlabelled(frequencies_hz: [f64; 3]) -> [PlanMode; 3] {
    frequencies_hz.map(|frequency_hz| PlanMode {
        frequency_hz,
        frequency_sd_hz: 0.0,
        motion: None,
        twist: None,
        shape: None,
    })
}

/// Solves A x = b by Gaussian elimination with pivoting.
fn solved(mut a: [[f64; 4]; 3]) -> Option<[f64; 3]> {
    for p in 0..3 {
        let best = (p..3).max_by(|&i, &j| a[i][p].abs().total_cmp(&a[j][p].abs()))?;
        a.swap(p, best);
        if a[p][p] == 0.0 {
            return None;
        }
        for i in 0..3 {
            if i != p {
                let (factor, pivot) = (a[i][p] / a[p][p], a[p]);
                for (of, by) in a[i].iter_mut().zip(pivot) {
                    *of -= factor * by;
                }
            }
        }
    }
    Some([0, 1, 2].map(|i| a[i][3] / a[i][i]))
}

/// Newton in ln k on trace, second invariant and determinant of K/m + w/m I = Σ k_i b_i b_iᵀ in u, v, ρθ:
/// Σ k_i |b_i|², Σ k_i k_j (|b_i|²|b_j|² − (b_i·b_j)²), k_x k_y k_θ.
fn newton(storey: &PlanStorey, frequencies_hz: [f64; 3], start: [f64; 3]) -> Option<[f64; 3]> {
    let [e_x, e_y] = storey.eccentricity_m.map(|e| e / storey.gyration_m);
    let square = [1.0 + e_y * e_y, 1.0 + e_x * e_x, 1.0];
    let product = [-e_x * e_y, -e_y, e_x]; // xy, xθ, yθ
    let pair = [(0, 1), (0, 2), (1, 2)];
    let minor = [0, 1, 2].map(|i| square[pair[i].0] * square[pair[i].1] - product[i] * product[i]);
    let l = frequencies_hz.map(|f| (TAU * f).powi(2) + storey.weight_takes_n_m / storey.mass_kg);
    let wanted = [
        l[0] + l[1] + l[2],
        l[0] * l[1] + l[0] * l[2] + l[1] * l[2],
        l[0] * l[1] * l[2],
    ];
    let mut k = start;
    for _ in 0..200 {
        let mut rows = [[0.0; 4]; 3];
        let mut have = [0.0, 0.0, k[0] * k[1] * k[2]];
        for i in 0..3 {
            have[0] += k[i] * square[i];
            rows[0][i] = k[i] * square[i];
            rows[2][i] = have[2];
        }
        for (i, (p, q)) in pair.into_iter().enumerate() {
            let term = k[p] * k[q] * minor[i];
            have[1] += term;
            rows[1][p] += term;
            rows[1][q] += term;
        }
        for i in 0..3 {
            rows[i].iter_mut().for_each(|of| *of /= wanted[i]);
            rows[i][3] = 1.0 - have[i] / wanted[i];
        }
        let step = solved(rows)?;
        let longest = step.iter().fold(0.0_f64, |most, s| most.max(s.abs()));
        let shorter = (0.7 / longest).min(1.0);
        for i in 0..3 {
            k[i] *= (shorter * step[i]).exp();
        }
        if longest < 1e-13 {
            break;
        }
        if !longest.is_finite() || longest > 1e6 {
            return None;
        }
        if longest < 1e-11 && rows.iter().all(|row| row[3].abs() < 1e-13) {
            break;
        }
    }
    let m = storey.mass_kg;
    let found = [m * k[0], m * k[1], m * k[2] * storey.gyration_m.powi(2)];
    found.iter().all(|k| k.is_finite()).then_some(found)
}

fn apart(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a.iter()
        .zip(b)
        .fold(0.0, |most, (a, b)| most.max((a / b - 1.0).abs()))
}

#[test]
fn agrees_with_newton_on_the_invariants_from_many_starts_in_200_storeys() {
    let mut random = Random::new(20261125, 1);
    let (mut roots, mut by_newton) = (0, 0);
    for case in 0..200 {
        let Drawn {
            storey,
            stiffness,
            height_m,
        } = drawn(&mut random);
        let (frequencies, _) = forward(&storey, height_m, stiffness, storey.eccentricity_m);
        let found = plan_stiffness(&storey, &unlabelled(frequencies)).unwrap();
        assert!(found.complete, "case {case}");
        assert_eq!(found.eccentricity_from, EccentricityFrom::Stated);
        let is_found = |k: &[f64; 3], tolerance: f64| {
            found
                .solutions
                .iter()
                .any(|one| apart(&one.stiffness, k) < tolerance * one.amplification.max(1.0))
        };
        assert!(
            is_found(&stiffness, 2e-9),
            "case {case}: {stiffness:?} among {:?}",
            found.solutions
        );
        for one in &found.solutions {
            let (again, _) = forward(&storey, height_m, one.stiffness, storey.eccentricity_m);
            assert!(
                apart(&again, &frequencies) < 1e-9,
                "case {case}: {again:?}, {frequencies:?}"
            );
            roots += 1;
        }
        let middle = (TAU * frequencies[1]).powi(2);
        for _ in 0..60 {
            let start = [0, 1, 2].map(|_| middle * 30.0_f64.powf(2.0 * random.uniform() - 1.0));
            let Some(k) = newton(&storey, frequencies, start) else {
                continue;
            };
            // an iteration that ends at a minimum of its own equations is not a root
            let stands = std::panic::catch_unwind(|| forward(&storey, height_m, k, storey.eccentricity_m));
            let Ok((again, _)) = stands else { continue };
            if apart(&again, &frequencies) < 1e-10 {
                by_newton += 1;
                assert!(
                    is_found(&k, 2e-9),
                    "case {case}: {k:?} is missed by {:?}",
                    found.solutions
                );
            }
        }
    }
    assert!(
        roots > 400 && by_newton > 4000,
        "{roots} roots, {by_newton} ends of Newton"
    );
}

#[test]
fn exact_without_eccentricity_each_stiffness_is_m_omega_squared() {
    let storey = PlanStorey {
        mass_kg: 604e3,
        gyration_m: 7.5,
        weight_takes_n_m: 1e6,
        eccentricity_m: [0.0; 2],
    };
    let mode = |frequency_hz, motion| PlanMode {
        frequency_hz,
        frequency_sd_hz: 0.01 * frequency_hz,
        motion: Some(motion),
        twist: None,
        shape: None,
    };
    // two equal frequencies belong to a square plan
    for [x, y, torsion] in [[1.5, 1.1, 1.3], [1.2, 1.2, 1.7]] {
        let modes = [
            mode(torsion, PlanMotion::Torsion),
            mode(x, PlanMotion::X),
            mode(y, PlanMotion::Y),
        ];
        let found = plan_stiffness(&storey, &modes).unwrap();
        assert_eq!(found.solutions.len(), 6);
        let accepted: Vec<_> = found.accepted().collect();
        assert_eq!(accepted.len(), 1);
        let own = |f: f64| 604e3 * (TAU * f).powi(2) + 1e6;
        let known = [own(x), own(y), 7.5 * 7.5 * own(torsion)];
        assert!(apart(&accepted[0].stiffness, &known) < 1e-12);
        let sd = accepted[0].stiffness_sd.unwrap();
        let known_sd = [
            0.02 * (own(x) - 1e6),
            0.02 * (own(y) - 1e6),
            7.5 * 7.5 * 0.02 * (own(torsion) - 1e6),
        ];
        assert!(apart(&sd, &known_sd) < 1e-12, "{sd:?} {known_sd:?}");
        let refused = found.solutions.iter().filter_map(|one| one.moves_otherwise);
        assert_eq!(refused.count(), 5);
    }
}

/// The three modes, each named after the larger part of its motion; `None` if two would have the same name.
fn labelled(frequencies: [f64; 3], shapes: &[[f64; 3]; 3]) -> Option<[PlanMode; 3]> {
    let motion = |shape: &[f64; 3]| {
        let most = (0..3)
            .max_by(|&a, &b| shape[a].abs().total_cmp(&shape[b].abs()))
            .unwrap();
        PlanMotion::ALL[most]
    };
    let motions = shapes.each_ref().map(motion);
    let is_whole = PlanMotion::ALL.iter().all(|own| motions.contains(own));
    is_whole.then(|| {
        [0, 1, 2].map(|j| PlanMode {
            frequency_hz: frequencies[j],
            frequency_sd_hz: 0.005 * frequencies[j],
            motion: Some(motions[j]),
            twist: (motions[j] != PlanMotion::Torsion).then(|| Twist {
                ratio: shapes[j][2] / shapes[j][motions[j].index()],
                sd: 0.002,
            }),
            shape: None,
        })
    })
}

#[test]
fn holds_twists_give_back_stiffness_and_eccentricity_of_200_storeys() {
    let mut random = Random::new(20261125, 2);
    let (mut looked, mut alone, mut met) = (0, 0, 0);
    while looked < 200 {
        let Drawn {
            storey,
            stiffness,
            height_m,
        } = drawn(&mut random);
        let (frequencies, shapes) = forward(&storey, height_m, stiffness, storey.eccentricity_m);
        let Some(modes) = labelled(frequencies, &shapes) else {
            continue;
        };
        looked += 1;
        let unstated = PlanStorey {
            eccentricity_m: [0.0; 2],
            ..storey
        };
        let found = plan_stiffness(&unstated, &modes).unwrap();
        assert_eq!(found.eccentricity_from, EccentricityFrom::Twists);
        let far = |one: &[f64; 2]| {
            let of = |i: usize| (one[i] - storey.eccentricity_m[i]).abs() / storey.gyration_m;
            of(0).max(of(1))
        };
        // a solution that represents two coinciding ones has the true value in its interval
        let holds = |one: &PlanSolution| {
            let [Some(k_sd), Some(e_sd)] = [
                one.stiffness_sd.map(|sd| sd.to_vec()),
                one.eccentricity_sd_m.map(|sd| sd.to_vec()),
            ] else {
                return false;
            };
            let k = one.stiffness.iter().zip(&stiffness).zip(&k_sd);
            let e = one.eccentricity_m.iter().zip(&storey.eccentricity_m).zip(&e_sd);
            k.chain(e).all(|((a, b), sd)| (a - b).abs() <= 1.96 * sd)
        };
        let same = found.accepted().find(|one| match one.roots_meet {
            true => holds(one),
            false => {
                apart(&one.stiffness, &stiffness) < 1e-9 * one.amplification
                    && far(&one.eccentricity_m) < 1e-9 * one.amplification
            }
        });
        assert!(
            same.is_some(),
            "{stiffness:?} {:?} not in {found:?}",
            storey.eccentricity_m
        );
        met += usize::from(found.solutions.iter().any(|one| one.roots_meet));
        for one in found.solutions.iter().filter(|one| !one.roots_meet) {
            let (again, shapes) = forward(&storey, height_m, one.stiffness, one.eccentricity_m);
            assert!(apart(&again, &frequencies) < 1e-9);
            for (mode, shape) in modes.iter().zip(&shapes) {
                if let (Some(motion), Some(twist)) = (mode.motion, mode.twist) {
                    assert!(
                        (shape[2] / shape[motion.index()] - twist.ratio).abs()
                            < 1e-6 * (1.0 + twist.ratio.abs())
                    );
                }
            }
        }
        alone += usize::from(found.accepted().count() == 1);
    }
    assert!(alone > 150, "{alone} of 200 have one accepted solution");
    assert!(met <= 20, "{met} of 200 lie where two meet");
}

/// Largest relative difference of the linearised deviations from those of 1500 draws, with the solution nearest to the first.
fn against_draws(storey: &PlanStorey, modes: &[PlanMode; 3], found: &PlanStiffness) -> f64 {
    let one = found.accepted().next().unwrap();
    let mut random = Random::new(20261125, 3);
    const DRAWS: usize = 1500;
    let mut sums = [[0.0; 2]; 5];
    for _ in 0..DRAWS {
        let drawn = modes.map(|mode| PlanMode {
            frequency_hz: mode.frequency_hz + mode.frequency_sd_hz * random.normal(),
            twist: mode.twist.map(|twist| Twist {
                ratio: twist.ratio + twist.sd * random.normal(),
                ..twist
            }),
            ..mode
        });
        let again = plan_stiffness(storey, &drawn).unwrap();
        let nearest = again.solutions.iter().min_by(|a, b| {
            apart(&a.stiffness, &one.stiffness).total_cmp(&apart(&b.stiffness, &one.stiffness))
        });
        let nearest = nearest.unwrap();
        let [k_x, k_y, k_theta] = nearest.stiffness;
        let [e_x, e_y] = nearest.eccentricity_m;
        for (sum, value) in sums.iter_mut().zip([k_x, k_y, k_theta, e_x, e_y]) {
            sum[0] += value;
            sum[1] += value * value;
        }
    }
    let n = DRAWS as f64;
    let sd = sums.map(|[sum, squares]| ((squares - sum * sum / n) / (n - 1.0)).sqrt());
    let of_stiffness = one.stiffness_sd.unwrap();
    let mut worst = (0..3).fold(0.0_f64, |most, i| most.max((of_stiffness[i] / sd[i] - 1.0).abs()));
    if let Some(of_eccentricity) = one.eccentricity_sd_m {
        worst = (0..2).fold(worst, |most, i| {
            most.max((of_eccentricity[i] / sd[3 + i] - 1.0).abs())
        });
    }
    worst
}

#[test]
fn agrees_deviations_with_1500_draws() {
    let stiffness = [9e7, 5e7, 6e9];
    for height_m in [None, Some(5.0)] {
        let storey = PlanStorey {
            mass_kg: 5e5,
            gyration_m: 7.0,
            weight_takes_n_m: height_m.map_or(0.0, |h| 5e5 * GRAVITY / h),
            eccentricity_m: [1.2, -0.8],
        };
        let (frequencies, shapes) = forward(&storey, height_m, stiffness, storey.eccentricity_m);
        let with_twists = labelled(frequencies, &shapes).unwrap();
        let alone = with_twists.map(|mode| PlanMode { twist: None, ..mode });
        for modes in [alone, with_twists] {
            let found = plan_stiffness(&storey, &modes).unwrap();
            let worst = against_draws(&storey, &modes, &found);
            assert!(worst < 0.08, "{worst} with {modes:?}");
        }
    }
}

#[test]
fn refuses_more_than_three_twins_and_says_what_few_leave_free() {
    let storey = |eccentricity_m| PlanStorey {
        mass_kg: 1e5,
        gyration_m: 5.0,
        weight_takes_n_m: 0.0,
        eccentricity_m,
    };
    let mode = |frequency_hz, motion| PlanMode {
        frequency_hz,
        frequency_sd_hz: 0.0,
        motion,
        twist: None,
        shape: None,
    };
    let (x, y) = (Some(PlanMotion::X), Some(PlanMotion::Y));
    let off = storey([0.5, 0.0]);
    let all = [mode(1.0, x), mode(1.2, y), mode(1.4, None), mode(1.6, None)];
    assert_eq!(
        plan_stiffness(&off, &all),
        Err(PlanStiffnessError::Modes { given: 4 })
    );
    assert_eq!(
        plan_stiffness(&off, &[]),
        Err(PlanStiffnessError::Modes { given: 0 })
    );
    let twins = [mode(1.0, x), mode(1.0, y), mode(1.4, None)];
    assert_eq!(
        plan_stiffness(&off, &twins),
        Err(PlanStiffnessError::Repeated { frequency_hz: 1.0 })
    );
    let twice = [mode(1.0, x), mode(1.2, x)];
    assert_eq!(
        plan_stiffness(&off, &twice),
        Err(PlanStiffnessError::Twice {
            motion: PlanMotion::X
        })
    );
    let nan = PlanStorey {
        mass_kg: f64::NAN,
        ..off
    };
    assert!(matches!(
        plan_stiffness(&nan, &twins),
        Err(PlanStiffnessError::Argument {
            quantity: "mass_kg",
            ..
        })
    ));
    // along x the floor is uncoupled, because e_y is 0; y and torsion stay coupled and undetermined
    let few = plan_stiffness(&off, &all[..2]).unwrap();
    assert_eq!(few.free, [PlanMotion::Y, PlanMotion::Torsion]);
    assert_eq!(few.singles.len(), 1);
    assert!((few.singles[0].stiffness / (1e5 * TAU * TAU) - 1.0).abs() < 1e-12);
    assert!(few.solutions.is_empty());
    let few = plan_stiffness(&storey([0.5, 0.1]), &all[..2]).unwrap();
    assert_eq!((few.singles.len(), few.free.len()), (0, 3));
}
