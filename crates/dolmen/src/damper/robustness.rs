//! Robustness of a design against detuned dampers.

use super::{DamperError, Goal, PlacedDamper, Plan, goal_cost};

/// The detuned quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Detuned {
    /// Frequencies of the dampers (a change of their springs, or an inverse change of the structure's
    /// stiffness).
    Frequency,
    /// Damping ratios of the dampers.
    Damping,
}

/// One point of a robustness curve.
#[derive(Clone, Debug, PartialEq)]
pub struct RobustnessPoint {
    /// Factor on the quantity; 1 is the design.
    pub factor: f64,
    /// Value of the goal.
    pub cost: f64,
    /// Standard deviation of each point.
    pub point_rms: Vec<f64>,
    /// Standard deviation of each stroke, m.
    pub stroke_rms_m: Vec<f64>,
}

/// The goal, the points and the strokes if each factor multiplies the frequency or damping of every damper.
///
/// # Errors
/// [`DamperError`] if a damper is out of its range, or a factor is not positive.
pub fn robustness(
    plan: &Plan,
    dampers: &[PlacedDamper],
    goal: Goal,
    detuned: Detuned,
    factors: &[f64],
) -> Result<Vec<RobustnessPoint>, DamperError> {
    factors
        .iter()
        .map(|&factor| {
            if !(factor > 0.0 && factor.is_finite()) {
                return Err(DamperError::Argument {
                    argument: "factor",
                    given: factor,
                    allowed: "positive",
                });
            }
            let changed: Vec<PlacedDamper> = dampers
                .iter()
                .map(|damper| match detuned {
                    Detuned::Frequency => PlacedDamper {
                        frequency_hz: factor * damper.frequency_hz,
                        ..*damper
                    },
                    Detuned::Damping => PlacedDamper {
                        damping_ratio: factor * damper.damping_ratio,
                        ..*damper
                    },
                })
                .collect();
            let judged = plan.judge(&changed)?;
            Ok(RobustnessPoint {
                factor,
                cost: goal_cost(plan, &changed, goal)?,
                point_rms: judged.point_rms,
                stroke_rms_m: judged.stroke_rms_m,
            })
        })
        .collect()
}
