//! Local mechanisms of a stack as codes require, in each direction.

use crate::state::LocalMechanismRow;
use dolmen::assess::StackCheck;
use dolmen::assess::demand::{CircolareFactors, circolare_capacity};
use dolmen::stability::Verdict;
use dolmen::stability::stack::local_mechanisms;
use dolmen::structure::stack::Stack;

/// Largest number of stones for which all directions are examined; with more, only that of the first motion. Our choice: a wall of 200
/// takes a second.
const STONES_MOST: usize = 400;
/// Directions are the same if the sine of the angle between them is below this. Our choice.
const SAME: f64 = 1e-3;

/// The mechanism of the first motion, then those along both senses of x and y; empty for a stack that does not stand, and under static loads
/// that press on it: the codes move what presses as masses, and these have none.
pub(crate) fn of(stack: &Stack, check: &StackCheck) -> Vec<LocalMechanismRow> {
    if check.verdict == Verdict::Unstable || stack.is_pressed() {
        return Vec::new();
    }
    let first = check.capacity.map(|capacity| capacity.direction);
    let axes = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]];
    let is_small = stack.blocks().len() <= STONES_MOST;
    let apart = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]) > SAME;
    let first = first.filter(|first| !is_small || axes.iter().all(|axis| apart(*first, *axis)));
    let axes = axes.into_iter().filter(|_| is_small);
    let ways: Vec<[f64; 2]> = first.into_iter().chain(axes).collect();
    let mut found = local_mechanisms(stack, &ways).unwrap_or_default().into_iter();
    let gravity = stack.gravity_m_s2();
    ways.into_iter()
        .map(|direction| LocalMechanismRow {
            direction,
            // if the linear programme has no solution, that direction is unknown; the verdict does not depend on it
            capacity: found
                .next()
                .and_then(|found| found.ok().flatten())
                .map(|mechanism| circolare_capacity(mechanism, gravity, &CircolareFactors::default())),
        })
        .collect()
}
