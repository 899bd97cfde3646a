//! The least first motion over static loads that press on stones and may each be there or not.

use super::AssessError;
use super::least_motion::first_motion;
use crate::stability::stack::{StackLimits, Threshold, driving_shaken};
use crate::structure::stack::{Stack, StaticLoad};

/// Largest number of times that the loads are chosen by the mechanism. Our choice: usually none changes after the first.
pub(super) const TURNS: usize = 4;

/// Without which of its static loads a stack moves first, and when.
#[derive(Clone, Debug, PartialEq)]
pub struct LeastPressed {
    /// For each static load, whether it acts. At least one that presses does not.
    pub acts: Vec<bool>,
    /// Least acceleration at which it begins to move; `None` if it does not stand, or if nothing moves it.
    pub capacity: Option<Threshold>,
}

impl LeastPressed {
    /// The least of the descents from all loads and from none that presses; `with_all` is the capacity with all. `None` if no load presses.
    pub(super) fn of(
        stack: &Stack,
        limits: &StackLimits,
        with_all: Option<Threshold>,
    ) -> Result<Option<Self>, AssessError> {
        if !stack.is_pressed() {
            return Ok(None);
        }
        let loads = stack.static_loads();
        let presses = |load: &StaticLoad| load.force_n[2] < 0.0;
        let mut least = LeastPressed {
            acts: loads.iter().map(|load| !presses(load)).collect(),
            capacity: None,
        };
        least.capacity = first_motion(&stack.with_static_loads(&least.acts), limits)?;
        let all = (vec![true; loads.len()], with_all);
        for (mut acts, mut capacity) in [(least.acts.clone(), least.capacity), all] {
            for _ in 0..TURNS {
                let Some(threshold) = capacity else { break };
                let loaded = stack.with_static_loads(&acts);
                let drives = driving_shaken(&loaded, &limits.loads, threshold.direction, loads)?;
                let Some(drives) = drives else { break };
                let next: Vec<bool> = loads
                    .iter()
                    .zip(drives)
                    .map(|(load, drives)| drives || !presses(load))
                    .collect();
                if next == acts || next.iter().all(|acts| *acts) {
                    break;
                }
                acts = next;
                capacity = first_motion(&stack.with_static_loads(&acts), limits)?;
                if is_sooner(capacity, least.capacity) {
                    least = LeastPressed {
                        acts: acts.clone(),
                        capacity,
                    };
                }
            }
        }
        Ok(Some(least))
    }
}

/// Whether a stack moves sooner than another; one that does not stand moves at once.
fn is_sooner(one: Option<Threshold>, other: Option<Threshold>) -> bool {
    let at = |of: Option<Threshold>| of.map_or(0.0, |of| of.acceleration_g);
    at(one) < at(other)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::stack::{Block, JointMaterial, Solid};

    /// A pillar of 0.6 × 0.6 × 3 m with a bracket of 3 kN at x = 1.3 and snow of 6 kN at x = −0.3, about the edge at x = 0.3:
    /// a (W z) = W b/2 − 3 kN (1.3 − 0.3), W = 24.37 kN.
    #[test]
    fn exact_snow_that_holds_goes_and_a_bracket_that_drives_stays() {
        let (side, height) = (0.6, 3.0);
        let block = Block {
            name: "pillar".into(),
            solid: Solid::cuboid(side, side, height).unwrap(),
            density_kg_m3: 2300.0,
        };
        let load = |x: f64, z: f64, force: f64| StaticLoad {
            block: 0,
            position_m: [x, 0.0, z],
            force_n: [0.0, 0.0, -force],
        };
        let stack = Stack::new(vec![block], JointMaterial::with_friction(0.6), 9.81).unwrap();
        let stack = stack.with_static_load(load(1.3, 2.5, 3e3)).unwrap();
        let stack = stack.with_static_load(load(-0.3, 3.0, 6e3)).unwrap();
        let limits = StackLimits::default();
        let all = first_motion(&stack, &limits).unwrap();
        let least = LeastPressed::of(&stack, &limits, all).unwrap().unwrap();
        assert_eq!(least.acts, [true, false]);
        let weight = side * side * height * 2300.0 * 9.81;
        let exact = (weight * side / 2.0 - 3e3 * 1.0) / (weight * height / 2.0);
        let found = least.capacity.unwrap().acceleration_g;
        assert!((found - exact).abs() < 1e-8, "{found} {exact}");
        assert!(all.unwrap().acceleration_g > 1.5 * found);
    }
}
