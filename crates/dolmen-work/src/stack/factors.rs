//! Factors on the springs of a stack's joints from the modes of a survey.

use super::factors_answer::FactorsAnswer;
use super::frequencies::RULE;
use crate::error::WorkError;
use crate::surveyed::{SurveyAnswer, WithoutStiffness};
use dolmen::blocks::{
    BesideInSmallMotion, JointFactorsOptions, MeasuredStackMode, StackMotion, beside_in_small_motion,
    joint_factors,
};
use dolmen::structure::{LeftOut, directional_modes};
use dolmen_project::{ModeKind, Quantity, StackPart, Survey};

/// Result of a survey of a stack.
pub(crate) enum FromModes {
    /// Factors.
    Factors(Box<FactorsAnswer>),
    /// Why no factors are computed.
    Without(WithoutStiffness),
}

/// Factors on the springs from the modes that the survey states, and from those of its records in directions without stated modes.
pub(crate) fn factors(
    part: &StackPart,
    survey: &Survey,
    found: &SurveyAnswer,
) -> Result<FromModes, WorkError> {
    let (mut measured, mut left_out, mut other_directions) = (Vec::new(), Vec::new(), Vec::new());
    for (direction, modes) in &survey.modes {
        for mode in modes {
            match motion(direction, mode.kind) {
                Some(motion) => measured.push(MeasuredStackMode {
                    motion,
                    mode: mode.measured(&mut Quantity::nominal),
                }),
                None if !other_directions.contains(direction) => other_directions.push(direction.clone()),
                None => {}
            }
        }
    }
    let stated = measured.len();
    if let Some((modes, _)) = found.modes() {
        let doubtful = found
            .setups
            .as_ref()
            .map_or_else(Vec::new, |setups| setups.doubtful_hz());
        for (direction, motion, vector) in [
            ("x", StackMotion::X, [1.0, 0.0, 0.0]),
            ("y", StackMotion::Y, [0.0, 1.0, 0.0]),
        ] {
            if survey.modes.contains_key(direction) {
                continue;
            }
            let mut along = directional_modes(modes, vector);
            along.end_before(&doubtful);
            if along.channels_along > 0 {
                left_out.extend(along.left_out);
            }
            let each = along.modes.into_iter();
            measured.extend(each.map(|mode| MeasuredStackMode { motion, mode }));
        }
    }
    if measured.is_empty() {
        return Ok(FromModes::Without(match other_directions.is_empty() {
            true => WithoutStiffness::NoStackModes {
                has_record: survey.records.is_some() || !survey.setups.is_empty(),
            },
            false => WithoutStiffness::OtherDirections {
                directions: other_directions,
            },
        }));
    }
    let stack = part.build(&mut Quantity::nominal)?;
    let beside = beside_in_small_motion(&stack, RULE)?;
    if let Some(at) = beside.iter().position(|of| *of == BesideInSmallMotion::OneWay) {
        let stone = stack.blocks()[stack.side_supports()[at].block].name.clone();
        let number = at + 1;
        return Ok(FromModes::Without(WithoutStiffness::SideSupportOneWay {
            number,
            stone,
        }));
    }
    Ok(
        match joint_factors(&stack, &measured, &JointFactorsOptions::default()) {
            Ok(factors) => FromModes::Factors(Box::new(FactorsAnswer {
                stack,
                found: factors,
                beside,
                left_out: once(left_out),
                other_directions,
                is_from_record: measured.len() > stated,
            })),
            Err(why) => FromModes::Without(WithoutStiffness::Stack(Box::new(why))),
        },
    )
}

/// Direction of a mode in a survey; `None` for a direction without sway of a stack.
fn motion(direction: &str, kind: ModeKind) -> Option<StackMotion> {
    match (kind, direction) {
        (ModeKind::Torsion, _) | (_, "torsion") => Some(StackMotion::Torsion),
        (ModeKind::Translation, "x") => Some(StackMotion::X),
        (ModeKind::Translation, "y") => Some(StackMotion::Y),
        (ModeKind::Translation, _) => None,
    }
}

/// Modes in a direction other than x and y, which are left out of both.
fn once(left_out: Vec<LeftOut>) -> Vec<LeftOut> {
    let mut kept: Vec<LeftOut> = Vec::new();
    for (at, one) in left_out.iter().enumerate() {
        let said = match one {
            // a mode along y has no information about x
            LeftOut::OtherDirection { frequency_hz, .. } => left_out[..at].iter().any(
                |other| matches!(other, LeftOut::OtherDirection { frequency_hz: hz, .. } if hz == frequency_hz),
            ),
            LeftOut::Twists { .. }
            | LeftOut::Doubtful { .. }
            | LeftOut::Turns { .. }
            | LeftOut::Beyond { .. } => true,
        };
        if said && !kept.contains(one) {
            kept.push(one.clone());
        }
    }
    kept
}
