//! The stress blocks of each joint that a conic programme includes.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | v | `mechanism` | velocities of the blocks in a mechanism |
//! | c | `rate` | rate of crushing of a joint in it |
//! | n, t | `parts` | columns of a stress block: its normal, and friction times the directions across |
//! | s | `share` | fraction of the capacity of the joint per unit of force |

use super::limit_pushes::{Column, Push, ToePush};

/// Number of stress blocks of a joint in the first programme: the whole patch, and the force that is expected in the joint, at each edge. Our
/// choice.
const FIRST: usize = 17;
/// Largest number of stress blocks that a joint adds at a time. Our choice.
const MORE: usize = 6;

/// For each push of a piece, its stress blocks in the programme.
pub(super) struct ChosenToes {
    of_pushes: Vec<Vec<usize>>,
}

impl ChosenToes {
    /// A few of each joint.
    pub(super) fn first(pushes: &[Push]) -> Self {
        let first = |push: &Push| (0..count(push).min(FIRST)).collect();
        ChosenToes {
            of_pushes: pushes.iter().map(first).collect(),
        }
    }

    /// The chosen ones of each push; none for a push without stress blocks.
    pub(super) fn of_pushes(&self) -> &[Vec<usize>] {
        &self.of_pushes
    }

    /// Number of stress blocks that are not chosen.
    pub(super) fn left_out(&self, pushes: &[Push]) -> usize {
        let each = pushes.iter().zip(&self.of_pushes);
        each.map(|(push, chosen)| count(push) - chosen.len()).sum()
    }

    /// Chooses all. Whether there were more.
    pub(super) fn all(&mut self, pushes: &[Push]) -> bool {
        let is_more = self.left_out(pushes) > 0;
        for (push, chosen) in pushes.iter().zip(&mut self.of_pushes) {
            *chosen = (0..count(push)).collect();
        }
        is_more
    }

    /// Chooses those that a mechanism overloads by more than `most`, the worst of each joint. Whether there are any.
    ///
    /// ```text
    /// overload    |t·v| − (n·v + s c) of each stress block: above 0, its force in the mechanism gains more than crushing costs
    /// ```
    ///
    /// The mechanism has the velocities first, and from `first_rate` on the slips and rates of crushing of the pushes that have a limit.
    pub(super) fn add_overloaded(
        &mut self,
        pushes: &[Push],
        mechanism: &[f64],
        first_rate: usize,
        most: f64,
    ) -> bool {
        let mut is_any = false;
        let mut rates = mechanism[first_rate..].iter();
        for (push, chosen) in pushes.iter().zip(&mut self.of_pushes) {
            let Push::Toes(toes) = push else {
                if push.is_bounded() {
                    rates.next();
                }
                continue;
            };
            let rate = rates.next().copied().unwrap_or_default();
            let left_out = (0..toes.len()).filter(|toe| !chosen.contains(toe));
            let mut overloaded: Vec<(usize, f64)> = left_out
                .map(|toe| (toe, overload(&toes[toe], mechanism, rate)))
                .filter(|(_, by)| *by > most)
                .collect();
            overloaded.sort_by(|one, other| other.1.total_cmp(&one.1));
            is_any |= !overloaded.is_empty();
            chosen.extend(overloaded.into_iter().take(MORE).map(|(toe, _)| toe));
        }
        is_any
    }
}

fn count(push: &Push) -> usize {
    match push {
        Push::Toes(toes) => toes.len(),
        _ => 0,
    }
}

fn overload(toe: &ToePush, velocities: &[f64], rate: f64) -> f64 {
    let along = |column: &Column| -> f64 { column.iter().map(|&(row, value)| value * velocities[row]).sum() };
    let [normal, first, second] = &toe.parts;
    along(first).hypot(along(second)) - (along(normal) + toe.share * rate)
}
