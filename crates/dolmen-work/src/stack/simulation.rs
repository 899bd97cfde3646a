//! The simulation of a stack, with its input.

use crate::motion::MotionAnswer;
use crate::tilt_left_out::TiltLeftOut;
use dolmen::assess::{DamageState, DamageThresholds, JointDamage, StackDamage};
use dolmen::blocks::{ContactLaw, Outcome, Pose, StackHistory};
use dolmen::signal::Component;
use dolmen::stability::stack::StackLimitStates;
use dolmen::structure::stack::{Body, Stack, WidestGap};
use dolmen_project::{Names, SurveyedLean};

/// Gaps in the joints of a stack as drawn, and their state in the run.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnGaps {
    /// The widest, and their number.
    pub gap: WidestGap,
    /// Whether the gaps that carry no stone are open in the run.
    pub are_open: bool,
}

/// A simulation of a stack and its inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct StackSimulation {
    /// The project file, as the user named it.
    pub file: String,
    /// Name of the structure.
    pub name: Names,
    /// The variant of the file; `None` for the structure as given.
    pub variant: Option<String>,
    /// The stack.
    pub stack: Stack,
    /// Its measured lean.
    pub lean: Option<SurveyedLean>,
    /// Stones whose beds have lost stiffness, from inspections.
    pub loosened: Vec<String>,
    /// The latest survey with a measured sway frequency, which could determine the stiffness of the joints; `None` without one.
    pub measured_by: Option<String>,
    /// Whether the file gives a wind, which is not applied during a motion.
    pub without_wind: bool,
    /// A measured tilt that is not in the start of the runs.
    pub tilt_left_out: Option<TiltLeftOut>,
    /// Joints with a gap as drawn.
    pub gaps: Option<DrawnGaps>,
    /// The motion of its base.
    pub motion: MotionAnswer,
    /// The law of contact, with the options of the run.
    pub law: ContactLaw,
    /// The history.
    pub history: StackHistory,
    /// The acceleration at which it begins to move.
    pub limits: StackLimitStates,
    /// The state of damage, by the usual thresholds.
    pub damage: StackDamage,
}

/// Whether the stones are at rest, or one fell.
pub(super) fn came_to_its_end(outcome: &Outcome) -> bool {
    !matches!(
        outcome,
        Outcome::Stopped { .. }
            | Outcome::Diverged { .. }
            | Outcome::NotConverged { .. }
            | Outcome::StillMoving { .. }
    )
}

/// Share of the threshold of motion from which a motion counts as near it: shaking upwards lowers the threshold. Our choice.
const NEARLY: f64 = 0.8;

impl StackSimulation {
    /// Whether the ground reaches [`NEARLY`] of the acceleration at which a joint moves, or more.
    pub(super) fn nearly_moves(&self) -> bool {
        let limits = [&self.limits.uplift, &self.limits.sliding];
        let each = limits.into_iter().flatten();
        let least_g = each
            .map(|limit| limit.threshold.acceleration_g)
            .fold(f64::INFINITY, f64::min);
        NEARLY * least_g <= self.peak_horizontal_g()
    }

    /// End of the run, s, if it is before that of the motion and no stone fell: there is no verdict.
    pub fn ended_before_the_motion_s(&self) -> Option<f64> {
        let motion_s = self.motion.motion.duration_s();
        let end_s = self.law.run_length_s(motion_s);
        let is_open = matches!(
            self.history.outcome,
            Outcome::Stood | Outcome::Uplifted { .. } | Outcome::Slid { .. }
        );
        self.motion.cut_at_s(end_s).filter(|_| is_open)
    }

    /// The joint with the largest residual slip over its width, if that is at least the offset of DS2.
    pub fn shifted(&self) -> Option<(usize, &JointDamage)> {
        let DamageThresholds {
            offset_ratio,
            offset_m,
            ..
        } = DamageThresholds::default();
        let each = self.damage.joints.iter().enumerate();
        let shifted =
            each.filter(|(_, of)| of.residual_slip_ratio >= offset_ratio || of.residual_slip_m >= offset_m);
        shifted.max_by(|(_, a), (_, b)| a.residual_slip_ratio.total_cmp(&b.residual_slip_ratio))
    }

    /// The joint that slipped farthest, if sliding began.
    pub fn slipped(&self) -> Option<(usize, &JointDamage)> {
        let begun = DamageThresholds::default().slip_begun_m;
        let each = self.damage.joints.iter().enumerate();
        let slipped = each.filter(|(_, of)| of.peak_slip_m >= begun);
        slipped.max_by(|(_, a), (_, b)| a.peak_slip_m.total_cmp(&b.peak_slip_m))
    }

    /// Largest horizontal acceleration of the ground, resultant of x and y, in g of the stack.
    pub fn peak_horizontal_g(&self) -> f64 {
        let motion = &self.motion.motion;
        let [x, y] = [Component::X, Component::Y].map(|component| motion.acceleration_m_s2(component));
        let both = x.iter().zip(y).map(|(x, y)| x.hypot(*y));
        both.fold(0.0, f64::max) / self.stack.gravity_m_s2()
    }

    /// Whether stone crushes at an edge or a corner of a joint.
    pub fn crushes(&self) -> bool {
        let mut peaks = self.history.joints.iter().filter_map(|joint| joint.bearing);
        peaks.any(|peak| peak.crushes())
    }

    /// Whether a stone fell.
    pub fn falls(&self) -> bool {
        matches!(self.history.outcome, Outcome::Fell { .. })
    }

    /// Whether the run is complete, at rest or by a fall.
    pub fn is_whole(&self) -> bool {
        self.ended_before_the_motion_s().is_none() && came_to_its_end(&self.history.outcome)
    }

    /// The state of damage. Residual slip is known only at the end, but rocking at any time.
    pub fn counted_damage(&self) -> DamageState {
        let severe = DamageThresholds::default().severe_rocking_ratio;
        let mut joints = self.damage.joints.iter();
        let is_known =
            self.falls() || self.is_whole() || joints.any(|joint| joint.peak_rocking_ratio >= severe);
        match is_known {
            true => self.damage.state,
            false => self.damage.state.min(DamageState::Offset),
        }
    }

    /// Names of the two bodies of a joint, the upper first.
    pub fn joint_names(&self, joint: usize) -> [&str; 2] {
        match self.stack.joints().get(joint) {
            Some(joint) => [
                self.stack.name(Body::Block(joint.upper)),
                self.stack.name(joint.lower),
            ],
            None => ["", ""],
        }
    }

    /// Number of samples of the history.
    pub fn samples(&self) -> usize {
        self.history.time_s.len()
    }

    /// Poses of all blocks at a sample; the first sample is the stack at rest. Empty beyond the last.
    pub fn poses(&self, sample: usize) -> &[Pose] {
        let blocks = self.history.blocks;
        let poses = &self.history.poses;
        poses.get(sample * blocks..(sample + 1) * blocks).unwrap_or(&[])
    }

    /// The block with the highest centroid, as drawn.
    pub fn highest_block(&self) -> usize {
        let heights = self
            .stack
            .blocks()
            .iter()
            .map(|block| block.solid.centroid_m()[2]);
        let highest = heights.enumerate().max_by(|a, b| a.1.total_cmp(&b.1));
        highest.map_or(0, |(block, _)| block)
    }

    /// Displacement of a block's centroid from the stack at rest, in the frame of the ground, m, at each sample.
    pub fn displacement_m(&self, block: usize) -> Vec<[f64; 3]> {
        let at = |sample: usize| self.poses(sample).get(block).map_or([0.0; 3], |p| p.centroid_m);
        let rest = at(0);
        let each = (0..self.samples()).map(at);
        each.map(|now| std::array::from_fn(|axis| now[axis] - rest[axis]))
            .collect()
    }
}
