//! Run under its own weight of a stack that stands by friction: equilibrium is necessary, but only the run shows that the stack stays.

use super::stack::{StackCheck, by_margins, with_movement};
use super::stack_notes::{SettleRun, StackNote};
use crate::blocks::{BlocksError, Outcome, Pose, Springs, StackHistory, simulate_springs};
use crate::stability::Verdict;
use crate::structure::stack::Stack;
use glam::{DVec3, DVec4};

/// Length of the run after settlement on the joint springs, s. Our choice: a slipping stone falls a metre in half of it.
const LENGTH_S: f64 = 1.0;
/// Length of the run if nothing moves by more than [`STAYS_M`] nor turns by more than [`STAYS_RAD`] in it, s, and these limits, m and rad. Our
/// choice: a stone that a constant force accelerates by less would have gone 0.1 µm at the end of the whole run, and one that topples at ten
/// times a second 8 µm: the whole run ends alike.
const SHORT_S: f64 = 0.1;
const STAYS_M: f64 = 1e-9;
const STAYS_RAD: f64 = 1e-9;

/// The check with a run of the stack under its own weight on joint springs, if friction carries stones that share their load; otherwise the check
/// unchanged.
///
/// A stack that stood has the verdict of its margins; one that fell is unstable; otherwise the verdict is unknown.
///
/// # Limits
/// The run starts from the position of rest that Newton steps find. It does not include static loads.
pub fn with_settle_run(stack: &Stack, check: StackCheck) -> StackCheck {
    let Some(carries) = check
        .notes
        .iter()
        .position(|note| *note == StackNote::FrictionCarries)
    else {
        return check;
    };
    let found = settle_run(stack);
    let (note, verdict) = match &found {
        SettleRun::Stood { .. } => (StackNote::FrictionStood, by_margins(&check)),
        SettleRun::Fell { block } => (StackNote::FrictionFell { block: *block }, Verdict::Unstable),
        SettleRun::NoRest { .. } => (StackNote::FrictionNoRest, Verdict::Unknown),
        SettleRun::TooMany { stones } => {
            let most = SettleRun::STONES_MOST;
            (
                StackNote::FrictionNotRun {
                    stones: *stones,
                    most,
                },
                Verdict::Unknown,
            )
        }
    };
    let mut check = check;
    check.notes[carries] = note;
    check.verdict = with_movement(verdict, check.supports.as_ref());
    check.settle_run = Some(found);
    check
}

fn settle_run(stack: &Stack) -> SettleRun {
    let stones = stack.blocks().len();
    if stones > SettleRun::STONES_MOST {
        return SettleRun::TooMany { stones };
    }
    match run(stack, SHORT_S) {
        Ok(short) if stays(&short) => SettleRun::Stood {
            settlement_m: short.settlement_m,
            length_s: SHORT_S,
        },
        Ok(_) => run(stack, LENGTH_S).map_or_else(no_rest, ended),
        Err(why) => no_rest(why),
    }
}

fn no_rest(why: BlocksError) -> SettleRun {
    SettleRun::NoRest { why: Some(why) }
}

fn run(stack: &Stack, duration_s: f64) -> Result<StackHistory, BlocksError> {
    let options = Springs {
        duration_s: Some(duration_s),
        ..Springs::default()
    };
    simulate_springs(stack, None, &options, &mut |_| true)
}

/// Whether no stone moved or turned from its place at the start, in any sample.
fn stays(history: &StackHistory) -> bool {
    let is_near = |start: Pose, now: Pose| {
        let way = DVec3::from(start.centroid_m).distance(now.centroid_m.into());
        let [from, to] = [start, now].map(|pose| DVec4::from(pose.rotation));
        // two opposite quaternions are one rotation
        let turn = 2.0 * from.distance(to).min(from.distance(-to));
        way <= STAYS_M && turn <= STAYS_RAD
    };
    history.outcome == Outcome::Stood
        && (0..history.blocks).all(|block| {
            let start = history.pose(0, block);
            (1..history.time_s.len()).all(|sample| is_near(start, history.pose(sample, block)))
        })
}

fn ended(history: StackHistory) -> SettleRun {
    match history.outcome {
        Outcome::Stood | Outcome::Uplifted { .. } => SettleRun::Stood {
            settlement_m: history.settlement_m,
            length_s: LENGTH_S,
        },
        Outcome::Fell { block, .. } => SettleRun::Fell { block },
        Outcome::Slid { .. }
        | Outcome::StillMoving { .. }
        | Outcome::Stopped { .. }
        | Outcome::NotConverged { .. }
        | Outcome::Diverged { .. } => SettleRun::NoRest { why: None },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blocks::Start;
    use crate::structure::stack::{ArchFactors, JointMaterial, arch};

    #[test]
    fn holds_a_short_run_in_which_nothing_moves_ends_as_the_whole_one() {
        let blocks = arch(&ArchFactors {
            span_m: 1.8,
            rise_m: 0.9,
            thickness_m: 0.2,
            depth_m: 0.5,
            voussoirs: 15,
            springing_height_m: 0.0,
            abutment_m: 0.2,
            density_kg_m3: 2400.0,
        });
        let stack = Stack::new(blocks.unwrap(), JointMaterial::with_friction(0.7), 9.81).unwrap();
        let SettleRun::Stood {
            settlement_m,
            length_s,
        } = settle_run(&stack)
        else {
            panic!("it stands")
        };
        assert_eq!(length_s, SHORT_S);
        let whole = run(&stack, LENGTH_S).unwrap();
        assert!(stays(&whole) && whole.settlement_m == settlement_m);
        // its keystone goes up at 1 µm/s, or turns about the arch's plane at 1 µrad/s
        for (velocity_m_s, spin_rad_s) in [([0.0, 0.0, 1e-6], [0.0; 3]), ([0.0; 3], [0.0, 1e-6, 0.0])] {
            let push = Start {
                block: 7,
                pivot_m: [0.0; 3],
                turn_rad: [0.0; 3],
                shift_m: [0.0; 3],
                velocity_m_s,
                spin_rad_s,
            };
            let options = Springs {
                duration_s: Some(SHORT_S),
                starts: vec![push],
                ..Springs::default()
            };
            let pushed = simulate_springs(&stack, None, &options, &mut |_| true).unwrap();
            assert!(!stays(&pushed), "{velocity_m_s:?} {spin_rad_s:?}");
        }
    }
}
