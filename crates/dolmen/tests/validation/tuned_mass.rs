// SOURCE     Den Hartog (1956) Mechanical Vibrations, sec. 3.3; Warburton (1982) EESD 10(3):381-401; Nishihara & Asami
//            (2002) J. Vib. Acoust. 124(4):576-582; Sadek et al. (1997) EESD 26(6):617-635; Villaverde (1985).
// GOAL       The closed forms are the stated optima, and the search finds them and the optimum of a damped structure.
//
//   F(t) or ground
//      |      k = 1          k_d = μ f²
//     ###---/\/\/---[ m = 1 ]---/\/\/---[ m_d = μ ]
//     ###---|]---       x       ---|]--      y
//
// PARAMETERS μ = 0.05 and others; damping of the structure 0 and 2 %.
// PUBLISHED  peak of Den Hartog √(1 + 2/μ) at the fixed points; tunings to seven digits, computed independently of this
//            crate.
// TOLERANCE  half a unit of the last digit; 1e-6 of the closed forms for the search; 1e-9 for integrals by quadrature.

use dolmen::damper::{Aim, SingleMode, Tuning, TuningRule, optimal_tuning, rule_tuning};
use dolmen::known::tuned_mass::{Acts, TunedMass, least_peak_under_force, response, variance};

const MU: f64 = 0.05;
/// Half a unit of seven decimals.
const SEVEN: f64 = 5.1e-8;

fn undamped(mass_ratio: f64) -> SingleMode {
    SingleMode {
        mass_ratio,
        structure_damping_ratio: 0.0,
    }
}

fn close(given: f64, expected: f64, tolerance: f64) {
    assert!((given - expected).abs() <= tolerance, "{given} {expected}");
}

#[test]
fn published_tunings_to_seven_digits() {
    for (rule, f, zeta, aim, cost, digits) in [
        (
            TuningRule::DenHartog,
            0.952_381_0,
            0.133_630_6,
            Aim::ForceHarmonic,
            6.408_443,
            5.1e-7,
        ),
        (
            TuningRule::NishiharaAsami,
            0.952_372_0,
            0.133_937_7,
            Aim::ForceHarmonic,
            6.407_921,
            5.1e-7,
        ),
        (
            TuningRule::WarburtonForce,
            0.964_212_2,
            0.109_772_2,
            Aim::ForceRandom,
            4.445_436_4,
            SEVEN,
        ),
        (
            TuningRule::WarburtonBase,
            0.940_400_8,
            0.109_806_1,
            Aim::BaseRandom,
            4.781_536_8,
            SEVEN,
        ),
        (
            TuningRule::WarburtonBaseHarmonic,
            0.940_400_8,
            0.135_333_0,
            Aim::BaseHarmonic,
            6.646_274,
            5.1e-7,
        ),
    ] {
        let tuning = rule_tuning(rule, MU, 0.0).unwrap();
        close(tuning.frequency_ratio, f, SEVEN);
        close(tuning.damping_ratio, zeta, SEVEN);
        close(undamped(MU).cost(&tuning, aim).unwrap(), cost, digits);
    }
}

#[test]
fn published_search_finds_the_optimum_of_a_damped_structure() {
    let damped = SingleMode {
        mass_ratio: MU,
        structure_damping_ratio: 0.02,
    };
    let best = optimal_tuning(&damped, Aim::ForceRandom).unwrap();
    close(best.tuning.frequency_ratio, 0.962_178, 5.1e-7);
    close(best.tuning.damping_ratio, 0.109_772, 5.1e-7);
    close((best.cost * 4.0 * 0.02).sqrt(), 0.528_351, 5.1e-7); // σ² without a damper: 1/4ζ
}

#[test]
fn exact_search_finds_the_closed_forms() {
    for mu in [0.005, 0.02, 0.05, 0.1, 0.3, 1.0] {
        for (aim, rule) in [
            (Aim::ForceRandom, TuningRule::WarburtonForce),
            (Aim::BaseRandom, TuningRule::WarburtonBase),
            (Aim::ForceHarmonic, TuningRule::NishiharaAsami),
        ] {
            let found = optimal_tuning(&undamped(mu), aim).unwrap();
            let exact = rule_tuning(rule, mu, 0.0).unwrap();
            close(found.tuning.frequency_ratio, exact.frequency_ratio, 1e-6);
            close(found.tuning.damping_ratio, exact.damping_ratio, 1e-6);
        }
        let [_, _, peak] = least_peak_under_force(mu);
        close(
            optimal_tuning(&undamped(mu), Aim::ForceHarmonic).unwrap().cost,
            peak,
            1e-9 * peak,
        );
    }
}

#[test]
fn holds_no_neighbour_is_better() {
    for own in [0.0, 0.01, 0.05, 0.1] {
        let mode = SingleMode {
            mass_ratio: 0.03,
            structure_damping_ratio: own,
        };
        for aim in Aim::ALL {
            let best = optimal_tuning(&mode, aim).unwrap();
            for (df, dz) in [
                (0.999, 1.0),
                (1.001, 1.0),
                (1.0, 0.99),
                (1.0, 1.01),
                (1.001, 1.01),
                (0.999, 1.01),
            ] {
                let other = Tuning {
                    frequency_ratio: best.tuning.frequency_ratio * df,
                    damping_ratio: best.tuning.damping_ratio * dz,
                };
                let cost = mode.cost(&other, aim).unwrap();
                assert!(
                    cost > best.cost * (1.0 + 1e-8),
                    "{own} {aim:?} {df} {dz}: {cost} {}",
                    best.cost
                );
            }
        }
    }
}

#[test]
fn exact_fixed_points_of_den_hartog() {
    // at its two fixed points |H| is √(1 + 2/μ) for any damping
    let f = 1.0 / (1.0 + MU);
    let inner = (MU / (2.0 + MU)).sqrt();
    for r2 in [(1.0 - inner) / (1.0 + MU), (1.0 + inner) / (1.0 + MU)] {
        for damping_ratio in [0.01, 0.1, 0.5] {
            let of = TunedMass {
                mass_ratio: MU,
                frequency_ratio: f,
                damping_ratio,
                structure_damping_ratio: 0.0,
            };
            close(
                response(of, Acts::Force, r2.sqrt()).norm(),
                (1.0 + 2.0 / MU).sqrt(),
                1e-12,
            );
        }
    }
}

#[test]
fn exact_variance_by_quadrature() {
    // ∫ over all r with r = tan(s): smooth and periodic, so that equal steps converge beyond any power
    for acts in [Acts::Force, Acts::Base] {
        let of = TunedMass {
            mass_ratio: 0.07,
            frequency_ratio: 0.9,
            damping_ratio: 0.2,
            structure_damping_ratio: 0.04,
        };
        let n = 20_000;
        let sum: f64 = (0..n)
            .map(|i| (f64::from(i) + 0.5) / f64::from(n) * std::f64::consts::PI - std::f64::consts::FRAC_PI_2)
            .map(|s| response(of, acts, s.tan()).norm_sqr() / s.cos().powi(2))
            .sum();
        let integral = 0.5 * sum / f64::from(n); // (1/2π) π/n
        close(variance(of, acts) / integral, 1.0, 1e-9);
    }
}

#[test]
fn exact_sadek_makes_two_modes_of_one_frequency_and_damping() {
    // undamped structure: the characteristic polynomial is a square, (s² + ζ s + f)²
    for mu in [0.01, 0.05, 0.2] {
        let t = rule_tuning(TuningRule::Sadek, mu, 0.0).unwrap();
        let (f, link) = (t.frequency_ratio, 2.0 * t.damping_ratio * t.frequency_ratio);
        let polynomial = [f * f, link, 1.0 + f * f * (1.0 + mu), link * (1.0 + mu)];
        let (a, b) = (t.damping_ratio, f);
        for (given, expected) in polynomial
            .into_iter()
            .zip([b * b, 2.0 * a * b, a * a + 2.0 * b, 2.0 * a])
        {
            close(given, expected, 1e-15);
        }
    }
}

#[test]
fn exact_villaverde_gives_both_modes_the_mean_damping() {
    let published = rule_tuning(TuningRule::Villaverde, 0.05, 0.02).unwrap();
    close(published.frequency_ratio, 1.0, 0.0);
    close(published.damping_ratio, 0.243_606_8, SEVEN);
    // in resonance and with ζ = β + √μ both roots have the mean damping to first order in √μ
    let (mu, beta) = (1e-6, 0.02);
    let t = rule_tuning(TuningRule::Villaverde, mu, beta).unwrap();
    let of = TunedMass {
        mass_ratio: mu,
        frequency_ratio: t.frequency_ratio,
        damping_ratio: t.damping_ratio,
        structure_damping_ratio: beta,
    };
    // both poles together: |H| for the double root −(β+ζ)/2 ± i
    let mean = 0.5 * (beta + t.damping_ratio);
    let double = 1.0 / (4.0 * mean * mean); // of |H/H_tuned mass alone|²: one pole each
    let at_one = response(of, Acts::Force, 1.0).norm();
    let own = 2.0 * t.damping_ratio; // |s² + 2ζs + 1| at s = i
    close(at_one / (own * double), 1.0, 2e-3);
}

#[test]
fn published_two_normalisations_of_hwang_min_and_hong() {
    let meant = rule_tuning(TuningRule::DenHartog, MU, 0.0).unwrap();
    let literal = rule_tuning(TuningRule::HwangMinHongLiteral, MU, 0.0).unwrap();
    close(meant.damping_ratio_on_structure(), literal.damping_ratio, 1e-16);
    close(literal.damping_ratio, 0.1273, 5e-5);
    let back = Tuning::from_damping_on_structure(meant.frequency_ratio, literal.damping_ratio);
    close(back.damping_ratio, meant.damping_ratio, 1e-16);
}
