//! Calibrates the joint springs of a stack to its measured frequencies.

use super::contact_points::ContactRule;
use super::error::BlocksError;
use super::frequencies::{StackMode, lowest_stack_modes, stack_modes};
use crate::structure::stack::Stack;

/// Tolerance of the calibration, in ln of the factor. Our choice: far below the measurement error.
const FOUND: f64 = 1e-10;
/// Largest number of iterations: each reduces the correction to about 1e-4 of the last one, unless joints open or close in between.
const ROUNDS: usize = 10;
/// Smallest energy share of the joints that is used to enlarge a step, and longest step, in ln of the factor. Our choice.
const SHARE_LEAST: f64 = 0.05;
const STEP_MOST: f64 = 2.0;

/// A measured frequency and the frequency with the calibrated springs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MatchedFrequency {
    /// Measured frequency, Hz.
    pub measured_hz: f64,
    /// Frequency of the same mode with the calibrated springs, Hz.
    pub computed_hz: f64,
}

/// A stack with springs that fit measured frequencies.
#[derive(Clone, Debug, PartialEq)]
pub struct SpringCalibration {
    /// The stack with all its springs multiplied by `factor`.
    pub stack: Stack,
    /// Factor on the stiffness of every joint.
    pub factor: f64,
    /// The frequencies, in the order given.
    pub frequencies: Vec<MatchedFrequency>,
}

/// Multiplies the springs of all joints by one factor, so that a stack has the measured frequencies.
///
/// `measured` contains pairs of a mode (0 is the lowest) and its frequency. With several pairs, the factor minimises the sum of squares of the
/// logarithms; the result contains the remaining differences. `drawn` are the modes of the stack before calibration, by the same rule, if they are
/// known; otherwise they are computed.
///
/// ```text
/// if the same points touch, ω² ∝ k:   ln factor = mean of 2 ln(measured / computed)
/// ```
///
/// Stiffer springs settle less, so the stones are a little higher and ω²/k changes (by 1e-4 for a pagoda that settles 0.65 mm of 6.5 m). The rule
/// is therefore repeated with the new springs until the correction vanishes. If joints open or close with the springs, so that ω²/k jumps, it is
/// repeated until there is no improvement. The frequencies in the result show the remaining difference. Ties and side supports keep their
/// stiffness; with them the joints contribute only a part of ω², which each iteration estimates from the last.
///
/// # Errors
/// [`BlocksError`] without frequencies, for one that is not positive or a mode that the stack does not have, and for a stack without rest.
///
/// # Limits
/// One factor for all joints: one frequency determines neither the distribution of stiffness over the joints nor k_s / k_n, which does not change.
/// Measured frequencies are for small motion, so the springs are those of closed joints.
///
/// # Example
/// ```
/// use dolmen::blocks::{ContactRule, calibrate_springs, stack_modes};
/// use dolmen::structure::stack::JointMaterial;
/// let stack = dolmen::comparisons::p10(JointMaterial::default(), 9.81)?;
/// let drawn = stack_modes(&stack, ContactRule::Four)?[0].frequency_hz;
/// let found = calibrate_springs(&stack, ContactRule::Four, &[(0, 6.0)], None)?;
/// let first = &stack_modes(&found.stack, ContactRule::Four)?[0];
/// assert!((first.frequency_hz - 6.0).abs() < 1e-9);
/// assert!((found.factor / (6.0 / drawn).powi(2) - 1.0).abs() < 1e-4); // stiffer springs settle less than those drawn
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn calibrate_springs(
    stack: &Stack,
    contact_rule: ContactRule,
    measured: &[(usize, f64)],
    drawn: Option<&[StackMode]>,
) -> Result<SpringCalibration, BlocksError> {
    let refuse = |option, given, allowed| {
        Err(BlocksError::Option {
            option,
            given,
            allowed,
        })
    };
    if measured.is_empty() {
        return refuse("number of measured frequencies", 0.0, "at least 1");
    }
    let mut modes = match drawn {
        Some(modes) => modes.to_vec(),
        None => stack_modes(stack, contact_rule)?,
    };
    for &(mode, frequency_hz) in measured {
        if !(frequency_hz > 0.0 && frequency_hz.is_finite()) {
            return refuse("frequency_hz", frequency_hz, "a positive number");
        }
        if modes
            .get(mode)
            .is_none_or(|computed| computed.frequency_hz <= 0.0)
        {
            return refuse(
                "mode",
                mode as f64,
                "one of the stack's modes, six a block, 0 the lowest",
            );
        }
    }
    // remaining correction in ln of the factor
    let left = |modes: &[StackMode]| {
        let each = measured
            .iter()
            .map(|&(mode, frequency_hz)| 2.0 * (frequency_hz / modes[mode].frequency_hz).ln());
        each.sum::<f64>() / measured.len() as f64
    };
    let (mut factor, mut scaled) = (1.0, stack.clone());
    let mut correction = left(&modes);
    // d ln ω²/d ln k: 1 if only joints hold the stones, smaller with ties and side supports
    let is_held = !(stack.side_supports().is_empty() && stack.ties().is_empty());
    let mut share = 1.0;
    for _ in 0..ROUNDS {
        let step = match is_held {
            true => (correction / share).clamp(-STEP_MOST, STEP_MOST),
            false => correction,
        };
        let next = factor * step.exp();
        let with_next = multiplied(stack, next)?;
        let next_modes = lowest_stack_modes(&with_next, contact_rule, modes.len())?;
        let next_correction = left(&next_modes);
        if next_correction.abs() >= correction.abs() {
            break; // joints open or close between two factors: no factor is better
        }
        (factor, scaled, modes) = (next, with_next, next_modes);
        let slow = !is_held && next_correction.abs() > 0.1 * correction.abs();
        if is_held {
            share = ((correction - next_correction) / step).clamp(SHARE_LEAST, 1.0);
        }
        correction = next_correction;
        if slow || correction.abs() < FOUND {
            break;
        }
    }
    let frequencies = measured.iter().map(|&(mode, measured_hz)| MatchedFrequency {
        measured_hz,
        computed_hz: modes[mode].frequency_hz,
    });
    Ok(SpringCalibration {
        factor,
        frequencies: frequencies.collect(),
        stack: scaled,
    })
}

/// The stack with the springs of all joints multiplied.
fn multiplied(stack: &Stack, factor: f64) -> Result<Stack, BlocksError> {
    let mut scaled = stack.clone();
    for joint in 0..stack.joints().len() {
        let mut material = stack.joints()[joint].material;
        material.normal_stiffness_pa_m *= factor;
        material.shear_stiffness_pa_m *= factor;
        scaled = scaled.with_material(joint, material)?;
    }
    Ok(scaled)
}
