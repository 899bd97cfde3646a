//! Student's t distribution, for testing a difference by its estimated standard deviation.

use super::statistics::beta_probability;
use super::{Bracketing, NumericError, bracketed_root, normal_probability, normal_quantile};

/// P(|t| ≥ |statistic|) of Student's distribution; for infinite degrees of freedom, of the normal distribution.
///
/// ```text
/// p = I_x(ν/2, 1/2),   x = ν/(ν + t²)
/// ```
///
/// # Errors
/// [`NumericError::Range`] unless the statistic is a number and the degrees of freedom are above 0.
///
/// # Source
/// DLMF 8.17; Abramowitz & Stegun 26.7.1.
///
/// # Example
/// ```
/// use dolmen::numeric::student_two_sided;
/// assert!((student_two_sided(1.0, 1.0)? - 0.5).abs() < 1e-14); // Cauchy: quartiles at ±1
/// # Ok::<(), dolmen::numeric::NumericError>(())
/// ```
pub fn student_two_sided(statistic: f64, degrees_of_freedom: f64) -> Result<f64, NumericError> {
    if statistic.is_nan() {
        return Err(NumericError::Range {
            quantity: "statistic",
            given: statistic,
            allowed: "a number",
        });
    }
    if degrees_of_freedom.is_nan() || degrees_of_freedom <= 0.0 {
        return Err(NumericError::Range {
            quantity: "degrees_of_freedom",
            given: degrees_of_freedom,
            allowed: "above 0 (infinite for a deviation that is known)",
        });
    }
    if degrees_of_freedom > NORMAL_FROM || statistic.is_infinite() {
        return Ok(2.0 * normal_probability(-statistic.abs()));
    }
    let nu = degrees_of_freedom;
    Ok(beta_probability(nu / (nu + statistic * statistic), 0.5 * nu, 0.5))
}

/// Number of degrees of freedom from which Student's distribution equals the normal one within 1e-7 of its probability, up to |t| = 8.
const NORMAL_FROM: f64 = 1e10;

/// The t > 0 that |t| of Student's distribution exceeds with a probability.
///
/// # Errors
/// [`NumericError::Range`] unless 0 < probability < 1 and the degrees of freedom are above 0; [`NumericError::Evaluations`] if t is above
/// 1e15.
///
/// # Example
/// ```
/// use dolmen::numeric::student_two_sided_quantile;
/// assert!((student_two_sided_quantile(0.05, 10.0)? - 2.228138851986274).abs() < 1e-9);
/// # Ok::<(), dolmen::numeric::NumericError>(())
/// ```
pub fn student_two_sided_quantile(probability: f64, degrees_of_freedom: f64) -> Result<f64, NumericError> {
    let normal = -normal_quantile(0.5 * probability)?;
    if degrees_of_freedom > NORMAL_FROM {
        return Ok(normal);
    }
    let beyond = |t: f64| student_two_sided(t, degrees_of_freedom).map(|p| p.ln() - probability.ln());
    let mut most = normal.max(1.0);
    while beyond(most)? > 0.0 {
        most *= 2.0;
        if most > 1e15 {
            return Err(NumericError::Evaluations { most: 50 });
        }
    }
    let off = |t: f64| beyond(t).unwrap_or(f64::NAN);
    bracketed_root(off, 0.0, most, &Bracketing::default())
}

/// Variance of a sum and its degrees of freedom, from (variance, degrees of freedom) of each part.
///
/// ```text
/// v = Σ v_i,   ν = v² / Σ (v_i² / ν_i)
/// ```
///
/// # Source
/// Welch (1947) Biometrika 34:28-35; Satterthwaite (1946) Biom. Bull. 2:110-114.
pub(crate) fn welch(parts: &[(f64, f64)]) -> (f64, f64) {
    let sum: f64 = parts.iter().map(|(v, _)| v).sum();
    let below: f64 = parts.iter().map(|(v, nu)| v * v / nu).sum();
    (
        sum,
        if below > 0.0 {
            sum * sum / below
        } else {
            f64::INFINITY
        },
    )
}

/// The shift, in standard deviations, that Student's two-sided test with a given significance finds with a given power.
///
/// ```text
/// P(T > t) = power,   T = (Z + δ)/√(χ²_ν/ν) of the noncentral distribution,   P(T > t) = ∫ Φ(δ − t s) f_ν(s) ds,   s = √(χ²_ν/ν)
/// ```
/// The other side is neglected: for powers above a half its contribution is less than the significance.
///
/// # Errors
/// [`NumericError::Range`] unless 0 < significance < 1, ½ ≤ power < 1 and there is at least one degree of freedom.
///
/// # Example
/// ```
/// use dolmen::numeric::student_detectable;
/// assert!((student_detectable(0.05, 0.8, f64::INFINITY)? - (1.959963984540054 + 0.8416212335729143)).abs() < 1e-9);
/// # Ok::<(), dolmen::numeric::NumericError>(())
/// ```
pub fn student_detectable(
    significance: f64,
    power: f64,
    degrees_of_freedom: f64,
) -> Result<f64, NumericError> {
    if degrees_of_freedom.is_nan() || degrees_of_freedom < 1.0 {
        return Err(NumericError::Range {
            quantity: "degrees_of_freedom",
            given: degrees_of_freedom,
            allowed: "1 or more (infinite for a deviation that is known)",
        });
    }
    if !(0.5..1.0).contains(&power) {
        return Err(NumericError::Range {
            quantity: "power",
            given: power,
            allowed: "0.5 to below 1",
        });
    }
    let t = student_two_sided_quantile(significance, degrees_of_freedom)?;
    let z = normal_quantile(power)?;
    let nu = degrees_of_freedom;
    if nu > NORMAL_SHIFT_FROM {
        return Ok(t + z);
    }
    // Simpson's rule over s, within twelve standard deviations of 1: the rest contributes less than 1e-16
    let wide = 12.0 / nu.sqrt();
    let (low, high) = ((1.0 - wide).max(0.0), 1.0 + wide);
    let h = (high - low) / PARTS as f64;
    let ln_front = 2.0_f64.ln() + 0.5 * nu * (0.5 * nu).ln() - libm::lgamma(0.5 * nu);
    let weights: Vec<[f64; 2]> = (0..=PARTS)
        .map(|i| {
            let s = low + h * i as f64;
            let of = match i {
                0 | PARTS => 1.0,
                i if i % 2 == 1 => 4.0,
                _ => 2.0,
            };
            let density = if s > 0.0 {
                (ln_front + (nu - 1.0) * s.ln() - 0.5 * nu * s * s).exp()
            } else if nu == 1.0 {
                ln_front.exp()
            } else {
                0.0
            };
            [s, of * h / 3.0 * density]
        })
        .collect();
    let lacks = |shift: f64| {
        let found = weights.iter().map(|[s, w]| w * normal_probability(shift - t * s));
        found.sum::<f64>() - power
    };
    let mut most = t + z + 1.0;
    while lacks(most) < 0.0 {
        most *= 2.0;
    }
    bracketed_root(lacks, 0.0, most, &Bracketing::default())
}

/// Number of degrees of freedom from which the shift equals the difference between the normal distribution and Student's t within 1e-5.
const NORMAL_SHIFT_FROM: f64 = 1e5;
/// Number of intervals of the integral.
const PARTS: usize = 2000;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_the_noncentral_distribution_of_scipy() {
        // scipy 1.17.1: the δ at which nct.sf(t.ppf(1 - alpha/2, nu), nu, δ) is the power
        for (alpha, power, nu, shift) in [
            (0.05, 0.8, 2.0, 5.653489266405565),
            (0.05, 0.8, 3.0, 4.255898820740008),
            (0.05 / 3.0, 0.8, 4.0, 5.124283403278252),
            (0.05 / 8.0, 0.8, 29.0, 3.8248948250975077),
            (0.05, 0.9, 1.0, 20.964473420099804),
            (0.05, 0.8, 58.3, 2.8488017548480453),
        ] {
            let found = student_detectable(alpha, power, nu).unwrap();
            assert!(
                (found / shift - 1.0).abs() < 1e-6,
                "{alpha} {power} {nu}: {found}"
            );
        }
        assert!(student_detectable(0.05, 0.3, 4.0).is_err());
    }

    #[test]
    fn exact_with_one_and_two_degrees_of_freedom() {
        for t in [0.0_f64, 0.3, 1.0, 4.7, 31.8] {
            let cauchy = 1.0 - 2.0 / std::f64::consts::PI * t.atan();
            assert!((student_two_sided(t, 1.0).unwrap() - cauchy).abs() < 1e-14);
            let two = 1.0 - t / (2.0 + t * t).sqrt();
            assert!((student_two_sided(-t, 2.0).unwrap() - two).abs() < 1e-14);
        }
    }

    #[test]
    fn agrees_with_scipy() {
        // scipy 1.17.1: 2*stats.t.sf(t, nu)
        for (t, nu, p) in SCIPY {
            let found = student_two_sided(t, nu).unwrap();
            assert!((found / p - 1.0).abs() < 1e-11, "{t} {nu}: {found:e}, {p:e}");
            let back = student_two_sided_quantile(p, nu).unwrap();
            assert!((back / t - 1.0).abs() < 1e-9, "{t} {nu}: {back}");
        }
        let normal = student_two_sided(1.959963984540054, f64::INFINITY).unwrap();
        assert!((normal - 0.05).abs() < 1e-15);
    }

    const SCIPY: [(f64, f64, f64); 4] = [
        (2.5, 3.7, 0.07182202291182678),
        (1.1, 29.0, 0.2803798137027988),
        (8.0, 58.0, 6.124691564238827e-11),
        (0.02, 1000.0, 0.9840473622871114),
    ];

    #[test]
    fn refuses_what_has_no_probability() {
        assert!(student_two_sided(f64::NAN, 3.0).is_err());
        let message = student_two_sided(1.0, 0.0).unwrap_err().to_string();
        assert!(
            message.starts_with("degrees_of_freedom is 0, but must be above 0"),
            "{message}"
        );
        assert!(student_two_sided_quantile(0.0, 3.0).is_err());
    }
}
