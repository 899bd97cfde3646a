//! Growth rate of the motion of an unstable chain, compared with its linear equations.

use super::DynamicsError;
use super::chain_history::ChainHistory;
use super::chain_model::ChainModel;
use dolmen_linalg::generalized_symmetric_eigen;

/// The measurement begins when the motion is this many times its initial value: cosh then is an exponential within 1/200.
const FROM_TIMES: f64 = 10.0;
/// The measurement ends when the motion is this many times its initial value.
const TO_TIMES: f64 = 100.0;
/// Largest rotation for the measurement, rad: the linear equations are then accurate to 1/1000.
const SMALL_RAD: f64 = 0.05;

/// Growth rate of the fastest growing shape of a chain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainGrowth {
    /// λ of the linear equations, K φ = −λ² M φ: the shape grows as e^(λ t), 1/s.
    pub linear_rate_per_s: f64,
    /// Growth measured while the motion was small; `None` if the run was too short.
    pub measured: Option<MeasuredGrowth>,
}

/// Growth measured in a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuredGrowth {
    /// Natural logarithm of the growth, divided by its duration, 1/s.
    pub rate_per_s: f64,
    /// Start, s.
    pub from_s: f64,
    /// End, s.
    pub to_s: f64,
}

/// Growth of the motion of an unstable chain after a small push; `None` for a chain that stands.
///
/// ```text
/// q = φᵀ M θ,  rate = ln(q(to)/q(from)) / (to − from)          q(from) = 10 q(0), q(to) = 100 q(0)
/// ```
/// The shape φ is orthogonal to all others, so q grows as cosh(λ t) from a push at rest: from 10 to 100 times the push its rate is 0.1 % below
/// λ.
///
/// # Errors
/// [`DynamicsError::Structure`], [`DynamicsError::Linalg`] if the range of values exceeds the precision of the numbers.
///
/// # Limits
/// Stuck friction, open joints and a moving ground change the rate: λ is that of the springs alone. Times between samples are interpolated
/// linearly in the logarithm.
pub fn chain_growth(
    model: &ChainModel,
    history: &ChainHistory,
) -> Result<Option<ChainGrowth>, DynamicsError> {
    let stiffness: Vec<f64> = model.joints().iter().map(|j| j.stiffness_n_m_rad).collect();
    let mass = model.chain().mass_matrix();
    let eigen = generalized_symmetric_eigen(&model.chain().stiffness_matrix(&stiffness)?, &mass)?;
    let Some(&fastest) = eigen.values.first().filter(|value| **value < 0.0) else {
        return Ok(None);
    };
    let shape = eigen.vectors.column(0);
    let n = shape.len();
    let amplitude = |sample: usize| -> f64 {
        let theta: Vec<f64> = (0..n).map(|i| history.rotation_rad[i][sample]).collect();
        mass.form(shape, &theta).abs()
    };
    let push = amplitude(0);
    let samples = history.times_s.len();
    let small = |sample: &usize| (0..n).all(|i| history.rotation_rad[i][*sample].abs() <= SMALL_RAD);
    // the first time at which the motion is this many times the initial push
    let reaches = |times: f64| -> Option<f64> {
        let sample = (1..samples)
            .take_while(small)
            .find(|sample| amplitude(*sample) >= times * push)?;
        let (low, high) = (amplitude(sample - 1).ln(), amplitude(sample).ln());
        let step_s = history.times_s[sample] - history.times_s[sample - 1];
        Some(history.times_s[sample - 1] + step_s * ((times * push).ln() - low) / (high - low))
    };
    // a leaning chain starts from its lean, not from the vertical
    let from_to = (push > 0.0 && model.lean_rad() == 0.0)
        .then(|| reaches(FROM_TIMES).zip(reaches(TO_TIMES)))
        .flatten();
    Ok(Some(ChainGrowth {
        linear_rate_per_s: (-fastest).sqrt(),
        measured: from_to.map(|(from_s, to_s)| MeasuredGrowth {
            rate_per_s: (TO_TIMES / FROM_TIMES).ln() / (to_s - from_s),
            from_s,
            to_s,
        }),
    }))
}
