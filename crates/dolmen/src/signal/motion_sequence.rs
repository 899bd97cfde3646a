//! Two ground motions one after the other, with still ground between them.

use super::{Component, GroundMotion, SignalError};

/// Largest number of common steps in one step of a motion. Our choice: steps of 0.01 and 0.0137 s have the common step 0.0001 s.
const PARTS_MOST: u32 = 200;
/// Relative error allowed for an integer number of common steps: the rounding in written files. Our choice.
const ROUNDING: f64 = 1e-9;

/// Two motions as one.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionSequence {
    /// Both motions at their common step, which keeps every sample of either motion.
    pub motion: GroundMotion,
    /// Time of still ground between them, s: the given time, rounded up to a whole number of samples.
    pub still_s: f64,
    /// Start of the second motion, s.
    pub second_from_s: f64,
}

/// The motion `first`, then still ground for at least `still_s` up to a whole number of samples, then `second`.
///
/// ```text
/// a(t) = a_first(t)             0 ≤ t ≤ T_first
///      = 0                      between
///      = a_second(t − t_2)      t ≥ t_2 = T_first + still
/// ```
///
/// Motions are linear between samples, so sampling at the largest common step changes neither. If one motion lacks a direction, that direction
/// stands still for the duration of this motion.
///
/// # Errors
/// [`SignalError::NoCommonStep`] without a common step, [`SignalError::Argument`] if the time is not a number from 0.
///
/// # Limits
/// If the first motion was cut and does not end at zero, it goes to zero within one sample here, whereas alone it stops with a jump. The same
/// applies to the start of the second motion.
///
/// # Example
/// ```
/// use dolmen::signal::{Component, GroundMotion, motion_sequence};
/// let first = GroundMotion::new("first", 0.02, vec![(Component::X, vec![0.0, 2.0, 0.0])])?;
/// let second = GroundMotion::new("second", 0.01, vec![(Component::X, vec![0.0, 1.0, 0.0])])?;
/// let both = motion_sequence(&first, 0.015, &second)?;
/// assert_eq!(both.motion.acceleration_m_s2(Component::X), [0.0, 1.0, 2.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
/// assert!((both.second_from_s - 0.06).abs() < 1e-15);
/// # Ok::<(), dolmen::signal::SignalError>(())
/// ```
pub fn motion_sequence(
    first: &GroundMotion,
    still_s: f64,
    second: &GroundMotion,
) -> Result<MotionSequence, SignalError> {
    // the comparison is false for NaN
    if !(still_s >= 0.0 && still_s.is_finite()) {
        return Err(SignalError::Argument {
            argument: "still_s",
            given: still_s,
            allowed: "0 or a positive number",
        });
    }
    let parts = common_parts(first.time_step_s(), second.time_step_s())?;
    let step_s = first.time_step_s() / f64::from(parts[0]);
    // at least one sample lies between the two motions
    let still = (still_s / step_s * (1.0 - ROUNDING)).ceil().max(2.0) as usize;
    let mut series = Vec::new();
    for component in Component::ALL {
        if !(first.has(component) || second.has(component)) {
            continue;
        }
        let mut samples = finer(first.acceleration_m_s2(component), parts[0]);
        samples.extend(std::iter::repeat_n(0.0, still - 1));
        samples.extend(finer(second.acceleration_m_s2(component), parts[1]));
        series.push((component, samples));
    }
    let name = format!("{} → {}", first.name(), second.name());
    let still_s = still as f64 * step_s;
    Ok(MotionSequence {
        motion: GroundMotion::new(name, step_s, series)?,
        still_s,
        second_from_s: first.duration_s() + still_s,
    })
}

/// Number of common steps in one step of each motion.
fn common_parts(first_s: f64, second_s: f64) -> Result<[u32; 2], SignalError> {
    let whole = (1..=PARTS_MOST).find_map(|parts| {
        let other = second_s / first_s * f64::from(parts);
        let near = other.round();
        let is_whole =
            (1.0..=f64::from(PARTS_MOST)).contains(&near) && (other - near).abs() <= ROUNDING * near;
        is_whole.then_some([parts, near as u32])
    });
    whole.ok_or(SignalError::NoCommonStep {
        first_s,
        second_s,
        most: PARTS_MOST,
    })
}

/// Linear interpolation: `parts` samples replace each sample.
fn finer(samples: &[f64], parts: u32) -> Vec<f64> {
    let mut found = Vec::with_capacity(samples.len() * parts as usize);
    for pair in samples.windows(2) {
        let each = (0..parts).map(|i| pair[0] + f64::from(i) / f64::from(parts) * (pair[1] - pair[0]));
        found.extend(each);
    }
    found.extend(samples.last());
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn motion(step_s: f64, component: Component, samples: Vec<f64>) -> GroundMotion {
        GroundMotion::new("made", step_s, vec![(component, samples)]).unwrap()
    }

    #[test]
    fn exact_each_motion_acts_as_it_does_alone() {
        let first = motion(0.02, Component::X, vec![0.0, 0.3, -0.7, 0.2, 0.0]);
        let second = motion(0.005, Component::Y, vec![0.0, 1.0, -2.0, 0.5, 0.0]);
        let both = motion_sequence(&first, 0.333, &second).unwrap();
        assert_eq!(both.motion.time_step_s(), 0.005);
        assert!(both.still_s >= 0.333 && both.still_s < 0.338 + 1e-12);
        for i in 0..=400 {
            let t = 0.001 * f64::from(i);
            let [x, y, _] = both.motion.acceleration_at_m_s2(t);
            let alone = [
                first.acceleration_at_m_s2(t)[0],
                second.acceleration_at_m_s2(t - both.second_from_s)[1],
            ];
            assert!((x - alone[0]).abs() < 1e-12 && (y - alone[1]).abs() < 1e-9, "{t}");
        }
        let end_s = both.second_from_s + second.duration_s();
        assert!((both.motion.duration_s() - end_s).abs() < 1e-12);
    }

    #[test]
    fn exact_steps_of_files_have_a_common_one() {
        for (first_s, second_s, parts) in [
            (0.01, 0.01, [1, 1]),
            (0.02, 0.005, [4, 1]),
            (0.01, 0.004, [5, 2]),
            (1.0 / 128.0, 1.0 / 200.0, [25, 16]),
        ] {
            assert_eq!(common_parts(first_s, second_s).unwrap(), parts);
        }
    }

    #[test]
    fn refuses_steps_without_a_common_one_and_times_that_are_none() {
        let (a, b) = (
            motion(0.01, Component::X, vec![0.0, 1.0]),
            motion(0.01 * std::f64::consts::SQRT_2, Component::X, vec![0.0, 1.0]),
        );
        let said = motion_sequence(&a, 1.0, &b).unwrap_err().to_string();
        assert!(said.contains("sample one of them anew"), "{said}");
        for still_s in [-1.0, f64::NAN, f64::INFINITY] {
            let said = motion_sequence(&a, still_s, &a).unwrap_err().to_string();
            assert!(said.contains("still_s is"), "{said}");
        }
    }
}
