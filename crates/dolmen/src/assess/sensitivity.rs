//! Effect of a change of one input on the result.

/// Effect of a lower centroid of one link: the published criterion and the exact result (Choi 2021, Table 3).
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct CentroidEffect {
    /// Link, from 1 at the bottom.
    pub link: usize,
    /// Relative change of its centroid height: −0.2 is 20 % lower.
    pub change: f64,
    /// Published k_cr with the change, N m/rad, lowest joint first. Some values rise as the
    /// centroid falls: an artefact of the published criterion.
    pub published_critical_n_m_rad: Vec<f64>,
    /// Exact limits M_i with the change, N m/rad: none rises.
    pub necessary_n_m_rad: Vec<f64>,
    /// Exact stiffness that equal joints need with the change, N m/rad; it never rises.
    pub equal_joints_n_m_rad: f64,
    /// Load factor with the change; `None` if the joints' stiffness is unknown.
    pub load_factor: Option<f64>,
}

/// Sensitivity of a result to one input: d ln(result) / d ln(input), by central difference.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Sensitivity {
    /// Path of the input in the project file, `links[1].weight`.
    pub input: String,
    /// Value of the input, SI.
    pub value: f64,
    /// Elasticity: per cent of change of the result for one per cent of the input.
    pub elasticity: Option<f64>,
    /// Why it has no elasticity.
    pub unknown: Option<NoElasticity>,
    /// Coefficient of variation of the input, if given.
    pub cov: Option<f64>,
}

/// Why an input has no elasticity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
pub enum NoElasticity {
    /// The input is 0: a relative change of 0 is no change.
    Zero,
    /// The result is undefined when this input alone changes.
    NoResult,
}

/// Relative step h. Truncation error: h²/6 times the third derivative of ln r with respect to ln x, about 2e-7 of it; rounding
/// error: that of the result, about 1e-13, over h: 1e-10.
const STEP: f64 = 1e-3;

/// d ln(result) / d ln(input) at `value`, by central difference; one-sided if the result is undefined on one side (a
/// centre of mass already at the top of its link).
///
/// ```text
/// e = [ln r(x(1+h)) − ln r(x(1−h))] / [ln(1+h) − ln(1−h)],  h = 1e-3
/// ```
///
/// # Errors
/// The error of `result` below `value` if it fails on both sides.
///
/// # Limits
/// Exact for powers of the input. NaN if the results on the two sides have different signs or one of them is 0 beside 0, or if `value` is 0.
/// Two negative results give the elasticity of their magnitude.
///
/// # Example
/// ```
/// use dolmen::assess::elasticity;
/// let e = elasticity(2.0, |x| Ok::<_, std::convert::Infallible>(3.0 * x.powi(-2)));
/// assert!((e.unwrap_or(f64::NAN) + 2.0).abs() < 1e-10);
/// ```
pub fn elasticity<E>(value: f64, mut result: impl FnMut(f64) -> Result<f64, E>) -> Result<f64, E> {
    let (up, down) = (value * (1.0 + STEP), value * (1.0 - STEP));
    let (high, low) = match (result(up), result(down)) {
        (Ok(above), Ok(below)) => ((above, up), (below, down)),
        (Err(_), Ok(below)) => ((result(value)?, value), (below, down)),
        (Ok(above), Err(_)) => ((above, up), (result(value)?, value)),
        (Err(_), Err(fault)) => return Err(fault),
    };
    Ok((high.0 / low.0).ln() / (high.1 / low.1).ln())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_elasticity_of_a_power_and_at_an_edge() {
        let cubed = |x: f64| {
            if x <= 2.0 {
                Ok(x.powi(3))
            } else {
                Err("beyond the edge")
            }
        };
        assert!((elasticity(1.0, cubed).unwrap() - 3.0).abs() < 1e-11);
        assert!((elasticity(2.0, cubed).unwrap() - 3.0).abs() < 1e-11);
        assert_eq!(elasticity(3.0, cubed), Err("beyond the edge"));
    }
}
