//! Damage states of a stack after a motion: a pagoda that loses no stone may still be badly damaged.

use crate::blocks::{Outcome, Pose, StackHistory};
use crate::stability::stack::StackLimitStates;
use crate::structure::stack::{Joint, Stack};

/// Thresholds of damage states.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DamageThresholds {
    /// DS1: slip at which sliding begins, m, positive. Default 0.5 mm, our choice: larger than the elastic shear of a joint (0.15 mm at 100 kPa,
    /// friction 0.6, 4e8 Pa/m).
    pub slip_begun_m: f64,
    /// DS2: residual offset over the width of the joint, –, positive. Default 0.005.
    pub offset_ratio: f64,
    /// DS2: residual offset, m, positive. Default 10 mm.
    pub offset_m: f64,
    /// DS3: residual offset over the width of the joint, –, not below that of DS2. Default 0.02.
    pub severe_offset_ratio: f64,
    /// DS3: rocking of a joint over the slenderness angle of the part above, –, positive. Default 0.35.
    pub severe_rocking_ratio: f64,
}

impl Default for DamageThresholds {
    fn default() -> Self {
        DamageThresholds {
            slip_begun_m: 5e-4,
            offset_ratio: 0.005,
            offset_m: 0.010,
            severe_offset_ratio: 0.02,
            severe_rocking_ratio: 0.35,
        }
    }
}

/// Damage state of a stack.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum DamageState {
    /// Nothing moved.
    None,
    /// DS1: a joint opened by [`StackHistory::UPLIFT_LEAST_M`], or slipped by [`DamageThresholds::slip_begun_m`].
    Begun,
    /// DS2: the residual offset is at least 0.5 % of the joint's width, or 10 mm (defaults).
    Offset,
    /// DS3: the residual offset is at least 2 % of the joint's width, a joint rocked to 0.35 of its slenderness angle (defaults), or a stone lies on
    /// the brink.
    Severe,
    /// DS4: a stone fell.
    Fallen,
}

impl DamageState {
    /// 0 to 4.
    pub fn number(self) -> u8 {
        match self {
            DamageState::None => 0,
            DamageState::Begun => 1,
            DamageState::Offset => 2,
            DamageState::Severe => 3,
            DamageState::Fallen => 4,
        }
    }
}

/// Effect of a motion on one joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointDamage {
    /// The state. Only the joint that gave way is [`DamageState::Fallen`]. Joints below a stone on the brink are [`DamageState::Severe`].
    pub state: DamageState,
    /// Largest opening, m.
    pub peak_uplift_m: f64,
    /// Largest slip, m.
    pub peak_slip_m: f64,
    /// Residual slip, m.
    pub residual_slip_m: f64,
    /// Residual slip over the width of the joint in that direction, –.
    pub residual_slip_ratio: f64,
    /// Rocking (opening over the least width) over the slenderness angle of the part above, –; 0 if that part has none.
    pub peak_rocking_ratio: f64,
    /// Largest rotation about the vertical of the stone above relative to the stone below, rad.
    pub peak_yaw_rad: f64,
}

/// Effect of a motion on a stack, in the quantities that define damage states.
#[derive(Clone, Debug, PartialEq)]
pub struct StackDamage {
    /// The state: that of the worst joint.
    pub state: DamageState,
    /// Damage of each joint, in the order of the stack's joints.
    pub joints: Vec<JointDamage>,
    /// Largest tilt of a stone at a sample, rad.
    pub peak_tilt_rad: f64,
    /// Largest tilt of a stone at the end, rad.
    pub residual_tilt_rad: f64,
}

impl StackDamage {
    /// The largest of a quantity over the joints; 0 without joints.
    pub fn largest(&self, of: impl Fn(&JointDamage) -> f64) -> f64 {
        self.joints.iter().map(of).fold(0.0, f64::max)
    }
}

/// Damage states of a stack from its history.
///
/// ```text
/// DS1  uplift or slip begins       DS2  u_left ≥ 0.005 b or 10 mm       DS3  u_left ≥ 0.02 b, or θ ≥ 0.35 α       DS4  a stone falls     by default
/// θ = opening / least width of the joint,   α = atan(a_uplift / g) of the part above it
/// ```
///
/// # Limits
/// If several joints carry one part, or no cut goes through a joint alone, α is that of the cut with this joint and the fewest blocks. If a run
/// ended early, only the time up to its end counts: after a stone has fallen, the result does not describe the other stones.
pub fn stack_damage(
    stack: &Stack,
    limits: &StackLimitStates,
    history: &StackHistory,
    thresholds: &DamageThresholds,
) -> StackDamage {
    let joints = stack.joints().iter().zip(&history.joints).enumerate();
    let joints = joints.map(|(index, (joint, moved))| {
        let left = moved.slip_m.last();
        let rocking = slenderness_angle_rad(limits, index)
            .map(|alpha| (moved.peak_opening_m / least_width(joint)).atan() / alpha);
        let mut found = JointDamage {
            state: DamageState::None,
            peak_uplift_m: moved.peak_opening_m,
            peak_slip_m: moved.peak_slip_m,
            residual_slip_m: moved.residual_slip_m(),
            residual_slip_ratio: left.map_or(0.0, |&left| moved.residual_slip_m() / width_along(joint, left)),
            peak_rocking_ratio: rocking.unwrap_or(0.0),
            peak_yaw_rad: moved.peak_yaw_rad,
        };
        let on_the_brink = match history.outcome {
            Outcome::Slid { block, .. } | Outcome::StillMoving { block, .. } => joint.upper == block,
            _ => false,
        };
        found.state = match history.outcome {
            Outcome::Fell { joint, .. } if joint == index => DamageState::Fallen,
            _ if on_the_brink => DamageState::Severe,
            _ => state(&found, thresholds),
        };
        found
    });
    let joints: Vec<JointDamage> = joints.collect();
    let worst = joints
        .iter()
        .map(|joint| joint.state)
        .max()
        .unwrap_or(DamageState::None);
    let mut found = StackDamage {
        state: match history.outcome {
            Outcome::Fell { .. } => DamageState::Fallen,
            Outcome::Slid { .. } | Outcome::StillMoving { .. } => DamageState::Severe.max(worst),
            _ => worst,
        },
        joints,
        peak_tilt_rad: 0.0,
        residual_tilt_rad: 0.0,
    };
    let first = history.poses.get(..history.blocks).unwrap_or_default();
    for (index, pose) in history.poses.iter().enumerate() {
        let Some(start) = first.get(index % history.blocks.max(1)) else {
            break;
        };
        found.peak_tilt_rad = found.peak_tilt_rad.max(lean(start, pose));
    }
    let last = history
        .poses
        .len()
        .checked_sub(history.blocks)
        .and_then(|from| history.poses.get(from..));
    for (start, pose) in first.iter().zip(last.unwrap_or_default()) {
        found.residual_tilt_rad = found.residual_tilt_rad.max(lean(start, pose));
    }
    found
}

impl JointDamage {
    /// Whether it rocked so far that it is [`DamageState::Severe`] for that alone.
    pub fn rocked_severely(&self, thresholds: &DamageThresholds) -> bool {
        self.peak_rocking_ratio >= thresholds.severe_rocking_ratio
    }

    /// The state by opening and slip, without rocking.
    pub fn state_by_offset(&self, from: &DamageThresholds) -> DamageState {
        if self.residual_slip_ratio >= from.severe_offset_ratio {
            DamageState::Severe
        } else if self.residual_slip_ratio >= from.offset_ratio || self.residual_slip_m >= from.offset_m {
            DamageState::Offset
        } else if self.peak_uplift_m > StackHistory::UPLIFT_LEAST_M || self.peak_slip_m > from.slip_begun_m {
            DamageState::Begun
        } else {
            DamageState::None
        }
    }
}

fn state(found: &JointDamage, from: &DamageThresholds) -> DamageState {
    match found.rocked_severely(from) {
        true => DamageState::Severe,
        false => found.state_by_offset(from),
    }
}

/// Slenderness angle α of the part above a joint, rad.
fn slenderness_angle_rad(limits: &StackLimitStates, joint: usize) -> Option<f64> {
    let cuts = limits.cuts.iter().filter(|cut| cut.cut.joints.contains(&joint));
    let smallest = cuts.min_by_key(|cut| cut.cut.blocks.len())?;
    let uplift = smallest.uplift?;
    (uplift.acceleration_g > 0.0).then(|| uplift.acceleration_g.atan())
}

/// Angle between the verticals of a stone at two times, rad.
fn lean(start: &Pose, now: &Pose) -> f64 {
    let vertical = |[w, x, y, z]: [f64; 4]| {
        [
            2.0 * (x * z + w * y),
            2.0 * (y * z - w * x),
            1.0 - 2.0 * (x * x + y * y),
        ]
    };
    let (a, b) = (vertical(start.rotation), vertical(now.rotation));
    let apart = (a[0] - b[0]).hypot(a[1] - b[1]).hypot(a[2] - b[2]);
    2.0 * (0.5 * apart).min(1.0).asin()
}

fn width_along(joint: &Joint, direction: [f64; 2]) -> f64 {
    let length = direction[0].hypot(direction[1]);
    if length == 0.0 {
        return least_width(joint);
    }
    let [u, v] = [direction[0] / length, direction[1] / length];
    let places = joint
        .patch
        .corners_m
        .iter()
        .map(|corner| corner[0] * u + corner[1] * v);
    let (low, high) = places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), place| {
        (low.min(place), high.max(place))
    });
    high - low
}

/// Least width of a joint: across one of its edges, m.
fn least_width(joint: &Joint) -> f64 {
    let corners = &joint.patch.corners_m;
    let each = corners.iter().zip(corners.iter().cycle().skip(1));
    each.map(|(a, b)| {
        let across = [b[1] - a[1], a[0] - b[0]];
        if across[0].hypot(across[1]) > 0.0 {
            width_along(joint, across)
        } else {
            f64::INFINITY
        }
    })
    .fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blocks::{Springs, simulate_springs};
    use crate::signal::{Component, GroundMotion};
    use crate::stability::stack::{StackLimits, stack_limits};
    use crate::structure::stack::{Block, JointMaterial, Placement, Solid};
    use std::f64::consts::PI;

    fn stone() -> (Stack, StackLimitStates) {
        let block = Block {
            name: "stone".into(),
            solid: Solid::cuboid(0.4, 0.4, 2.0).unwrap(),
            density_kg_m3: 2600.0,
        };
        let material = JointMaterial {
            normal_stiffness_pa_m: 1e11,
            shear_stiffness_pa_m: 4e10,
            ..JointMaterial::with_friction(2.0)
        };
        let stack = Stack::new(vec![block], material, 9.81).unwrap();
        let limits = stack_limits(&stack, &StackLimits::default()).unwrap();
        (stack, limits)
    }

    /// The stone under a half sine of 0.4 s with this multiple of its uplift acceleration.
    fn pulse(stack: &Stack, times: f64) -> StackHistory {
        let samples = (0..=40).map(|i| times * 0.2 * 9.81 * (PI * f64::from(i) / 40.0).sin());
        let motion = GroundMotion::new("pulse", 0.01, vec![(Component::X, samples.collect())]).unwrap();
        simulate_springs(stack, Some(&motion), &Springs::default(), &mut |_| true).unwrap()
    }

    #[test]
    fn holds_rocking_of_a_joint_is_the_lean_of_its_stone_over_alpha() {
        let (stack, limits) = stone();
        let usual = DamageThresholds::default();
        let found = stack_damage(&stack, &limits, &pulse(&stack, 1.6), &usual);
        let alpha = 0.2_f64.atan();
        let by_lean = found.peak_tilt_rad / alpha;
        assert!(by_lean > 0.02, "{found:?}");
        assert!(
            (found.joints[0].peak_rocking_ratio / by_lean - 1.0).abs() < 0.02,
            "{found:?} {by_lean}"
        );
        assert!(found.state >= DamageState::Begun);
        let fallen = stack_damage(&stack, &limits, &pulse(&stack, 3.0), &usual);
        assert_eq!(fallen.state, DamageState::Fallen);
        let quiet = stack_damage(&stack, &limits, &pulse(&stack, 0.3), &usual);
        assert_eq!(quiet.state, DamageState::None, "{quiet:?}");
    }

    #[test]
    fn exact_states_begin_at_their_thresholds() {
        let (stack, limits) = stone();
        let still = pulse(&stack, 0.1);
        let alpha = 0.2_f64.atan();
        let of_thresholds = |from: DamageThresholds, slip_m: f64, left_m: f64, opening_m: f64| {
            let mut history = still.clone();
            history.joints[0].peak_slip_m = slip_m;
            history.joints[0].peak_opening_m = opening_m;
            *history.joints[0].slip_m.last_mut().unwrap() = [left_m, 0.0];
            stack_damage(&stack, &limits, &history, &from).state
        };
        let of = |slip, left, opening| of_thresholds(DamageThresholds::default(), slip, left, opening);
        assert_eq!(of(0.0, 0.0, 0.0), DamageState::None);
        assert_eq!(of(0.00051, 0.0, 0.0), DamageState::Begun);
        assert_eq!(of(0.0, 0.0, 0.00011), DamageState::Begun);
        assert_eq!(of(0.0019, 0.0019, 0.0), DamageState::Begun); // 0.5 % of 0.4 m is 2 mm
        assert_eq!(of(0.0021, 0.0021, 0.0), DamageState::Offset);
        assert_eq!(of(0.0081, 0.0081, 0.0), DamageState::Severe); // 2 % is 8 mm
        assert_eq!(of(0.0, 0.0, 0.4 * (0.349 * alpha).tan()), DamageState::Begun);
        assert_eq!(of(0.0, 0.0, 0.4 * (0.351 * alpha).tan()), DamageState::Severe);
        // each threshold moves only its own state
        let own = DamageThresholds {
            slip_begun_m: 2e-3,
            offset_ratio: 0.1,
            offset_m: 0.02,
            severe_offset_ratio: 0.2,
            severe_rocking_ratio: 0.6,
        };
        assert_eq!(of_thresholds(own, 0.0019, 0.0, 0.0), DamageState::None);
        assert_eq!(of_thresholds(own, 0.0021, 0.0, 0.0), DamageState::Begun);
        assert_eq!(of_thresholds(own, 0.0199, 0.0199, 0.0), DamageState::Begun); // 10 % of 0.4 m is 40 mm
        assert_eq!(of_thresholds(own, 0.0201, 0.0201, 0.0), DamageState::Offset);
        assert_eq!(of_thresholds(own, 0.0799, 0.0799, 0.0), DamageState::Offset);
        assert_eq!(of_thresholds(own, 0.0801, 0.0801, 0.0), DamageState::Severe);
        assert_eq!(
            of_thresholds(own, 0.0, 0.0, 0.4 * (0.599 * alpha).tan()),
            DamageState::Begun
        );
        assert_eq!(
            of_thresholds(own, 0.0, 0.0, 0.4 * (0.601 * alpha).tan()),
            DamageState::Severe
        );
    }

    /// Two stones: each joint has its own state, and the stack has the worst.
    #[test]
    fn exact_each_joint_has_its_own_state() {
        let block = |name: &str, x, from_m| Block {
            name: name.into(),
            solid: Solid::cuboid(x, x, 0.5).unwrap().placed(&Placement {
                position_m: [0.0, 0.0, from_m],
                ..Placement::default()
            }),
            density_kg_m3: 2600.0,
        };
        let blocks = vec![block("base", 1.0, 0.0), block("top", 0.5, 0.5)];
        let stack = Stack::new(blocks, JointMaterial::with_friction(0.7), 9.81).unwrap();
        let limits = stack_limits(&stack, &StackLimits::default()).unwrap();
        let motion = GroundMotion::new("still", 0.01, vec![(Component::X, vec![0.0; 5])]).unwrap();
        let mut history =
            simulate_springs(&stack, Some(&motion), &Springs::default(), &mut |_| true).unwrap();
        let of = |history: &StackHistory| {
            let found = stack_damage(&stack, &limits, history, &DamageThresholds::default());
            let each: Vec<u8> = found.joints.iter().map(|joint| joint.state.number()).collect();
            (each, found.state.number())
        };
        assert_eq!(of(&history), (vec![0, 0], 0));
        // the same 6 mm are .6 % of the wide joint and 1.2 % of the narrow one, 11 mm are 1.1 and 2.2 %
        for (left_m, wanted) in [(0.006, [2, 2]), (0.011, [2, 3])] {
            for (joint, state) in wanted.into_iter().enumerate() {
                let mut own = history.clone();
                *own.joints[joint].slip_m.last_mut().unwrap() = [0.0, left_m];
                let mut each = vec![0, 0];
                each[joint] = state;
                assert_eq!(of(&own), (each, state));
            }
        }
        history.outcome = Outcome::Slid {
            block: 1,
            slip_m: 0.3,
            margin_ratio: 0.1,
        };
        assert_eq!(of(&history), (vec![0, 3], 3));
        history.outcome = Outcome::Fell {
            block: 1,
            joint: 0,
            at_s: 1.0,
        };
        assert_eq!(of(&history), (vec![4, 0], 4));
    }
}
