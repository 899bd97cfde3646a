// SOURCE     Simulated capacities with a known dependence on the magnitude; separate normal equations below.
// GOAL       The slope of residuals over magnitude, its error and its probability by chance are right; without a slope, one case in twenty is
//            reported as one.
// PARAMETERS 22 motions of magnitude 5.5 to 7.6, scatter 0.3 of ln.
// TOLERANCE  1e-12 against the second solution; four deviations of counts over 2000 draws.

use dolmen::assess::sufficiency;
use dolmen::numeric::Random;

const MOTIONS: usize = 22;

fn magnitudes() -> Vec<f64> {
    (0..MOTIONS).map(|i| 5.5 + 0.1 * i as f64).collect()
}

fn made(slope: f64, seed: u64) -> Vec<f64> {
    let mut random = Random::new(seed, 0);
    let each = magnitudes().into_iter();
    each.map(|magnitude| slope * (magnitude - 6.5) + 0.3 * random.normal())
        .collect()
}

/// Slope and its standard error by the normal equations of a line with an intercept, 2 × 2 by Cramer's rule.
fn by_normal_equations(x: &[f64], y: &[f64]) -> [f64; 2] {
    let n = x.len() as f64;
    let sum = |of: &dyn Fn(usize) -> f64| (0..x.len()).map(of).sum::<f64>();
    let (sx, sy) = (sum(&|i| x[i]), sum(&|i| y[i]));
    let (sxx, sxy) = (sum(&|i| x[i] * x[i]), sum(&|i| x[i] * y[i]));
    let determinant = n * sxx - sx * sx;
    let slope = (n * sxy - sx * sy) / determinant;
    let intercept = (sxx * sy - sx * sxy) / determinant;
    let left = sum(&|i| (y[i] - intercept - slope * x[i]).powi(2));
    [slope, (left / (n - 2.0) * n / determinant).sqrt()]
}

#[test]
fn agrees_slope_and_error_with_normal_equations() {
    for seed in 1..=50 {
        let (x, y) = (magnitudes(), made(-0.4, seed));
        let found = sufficiency(&y, &x).unwrap();
        let [slope, error] = by_normal_equations(&x, &y);
        assert!(
            (found.slope - slope).abs() < 1e-12 && (found.slope_error - error).abs() < 1e-12,
            "{seed}"
        );
        assert_eq!(found.motions, MOTIONS);
    }
}

#[test]
fn holds_a_known_slope_is_found_and_none_is_called_one_in_twenty() {
    let draws = 2000_u32;
    let of = |slope: f64| {
        let each = 0..draws;
        each.map(move |seed| sufficiency(&made(slope, seed.into()), &magnitudes()).unwrap())
    };
    let mean = of(-0.4).map(|found| found.slope).sum::<f64>() / f64::from(draws);
    // Σ (x − x̄)² of n steps of 0.1 is 0.01 n (n² − 1)/12
    let n = MOTIONS as f64;
    let error = 0.3 / (0.01 * n * (n * n - 1.0) / 12.0).sqrt();
    assert!(
        (mean + 0.4).abs() < 4.0 * error / f64::from(draws).sqrt(),
        "{mean}"
    );
    let called = of(0.0).filter(|found| found.p_value < 0.05).count() as f64;
    let expected = 0.05 * f64::from(draws);
    assert!(
        (called - expected).abs() < 4.0 * (expected * 0.95).sqrt(),
        "{called}"
    );
    // 0.4 of ln per magnitude is nearly always detected
    let seen = of(-0.4).filter(|found| found.p_value < 0.05).count();
    assert!(seen > 1500, "{seen}");
}
