//! The stress blocks of each joint, and the discs of its held friction, that a conic programme includes.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | v | `mechanism` | velocities of the blocks in a mechanism |
//! | c | `rate` | rate of crushing of a joint in it |
//! | n, t | `parts` | columns of a stress block: its normal, and friction times the directions across |
//! | s | `share` | fraction of the capacity of the joint per unit of force |

use super::held_friction::HeldDisc;
use super::limit_pushes::{Column, Push, ToePush};
use std::collections::BTreeMap;

/// Number of stress blocks of a joint in the first programme: the whole patch, and the force that is expected in the joint, at each edge. Our
/// choice.
const FIRST: usize = 17;
/// Largest number of stress blocks that a joint adds at a time. Our choice.
const MORE: usize = 6;
/// Largest number of discs of the held friction of a joint. Our choice: fewer than ten are usual.
const DISCS_MOST: usize = 60;

/// The stress blocks and discs of each link in programmes that were solved: with them the next programme of nearly the same stack needs few others.
#[derive(Default)]
pub(super) struct UsedToes {
    toes: BTreeMap<usize, Vec<usize>>,
    discs: BTreeMap<usize, Vec<HeldDisc>>,
}

impl UsedToes {
    /// Keeps those of a piece, whose pushes belong to these links.
    pub(super) fn keep(&mut self, links: &[usize], chosen: ChosenToes) {
        for (link, toes) in links.iter().zip(chosen.of_pushes) {
            if !toes.is_empty() {
                self.toes.insert(*link, toes);
            }
        }
        for (link, discs) in links.iter().zip(chosen.discs_of_pushes) {
            if !discs.is_empty() {
                self.discs.insert(*link, discs);
            }
        }
    }
}

/// For each push of a piece, its stress blocks and discs in the programme.
pub(super) struct ChosenToes {
    of_pushes: Vec<Vec<usize>>,
    discs_of_pushes: Vec<Vec<HeldDisc>>,
}

impl ChosenToes {
    /// A few of each joint.
    pub(super) fn first(pushes: &[Push]) -> Self {
        let first = |push: &Push| (0..count(push).min(FIRST)).collect();
        let discs = |push: &Push| match push {
            Push::Held(held) => vec![held.even()],
            _ => Vec::new(),
        };
        ChosenToes {
            of_pushes: pushes.iter().map(first).collect(),
            discs_of_pushes: pushes.iter().map(discs).collect(),
        }
    }

    /// Those of earlier programmes, as far as there are any.
    pub(super) fn used(pushes: &[Push], links: &[usize], used: &UsedToes) -> Self {
        let mut chosen = ChosenToes::first(pushes);
        for (at, (push, link)) in pushes.iter().zip(links).enumerate() {
            match (push, used.toes.get(link), used.discs.get(link)) {
                (Push::Toes(toes), Some(earlier), _) if earlier.iter().all(|toe| *toe < toes.len()) => {
                    chosen.of_pushes[at].clone_from(earlier);
                }
                (Push::Held(_), _, Some(earlier)) => chosen.discs_of_pushes[at].clone_from(earlier),
                _ => {}
            }
        }
        chosen
    }

    /// The chosen ones of each push; none for a push without stress blocks or discs.
    pub(super) fn of_pushes(&self) -> impl Iterator<Item = (&[usize], &[HeldDisc])> {
        let each = self.of_pushes.iter().zip(&self.discs_of_pushes);
        each.map(|(toes, discs)| (toes.as_slice(), discs.as_slice()))
    }

    /// Number of stress blocks that are not chosen.
    pub(super) fn left_out(&self, pushes: &[Push]) -> usize {
        let each = pushes.iter().zip(&self.of_pushes);
        each.map(|(push, chosen)| count(push) - chosen.len()).sum()
    }

    /// Number of unknown forces that are not included: those of stress blocks, and of the points whose friction is in a few discs.
    pub(super) fn unknowns_left_out(&self, pushes: &[Push]) -> usize {
        let each = pushes.iter().zip(&self.discs_of_pushes);
        let points = each.map(|(push, discs)| match push {
            Push::Held(held) => held.points.len().saturating_sub(discs.len()),
            _ => 0,
        });
        3 * (self.left_out(pushes) + points.sum::<usize>())
    }

    /// Chooses all. Whether there were more.
    pub(super) fn all(&mut self, pushes: &[Push]) -> bool {
        let is_more = self.left_out(pushes) > 0;
        for (push, chosen) in pushes.iter().zip(&mut self.of_pushes) {
            *chosen = (0..count(push)).collect();
        }
        is_more
    }

    /// Chooses those that a mechanism overloads by more than `most`, the worst of each joint, and a disc of each held friction that resists it by more.
    /// Whether there are any.
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
        let chosen = self.of_pushes.iter_mut().zip(&mut self.discs_of_pushes);
        for (push, (chosen, discs)) in pushes.iter().zip(chosen) {
            if !push.is_bounded() {
                continue;
            }
            let rate = rates.next().copied().unwrap_or_default();
            if let Push::Held(held) = push
                && let Some(disc) = held.disc_against(mechanism, rate + most)
                && discs.len() < DISCS_MOST
            {
                discs.push(disc);
                is_any = true;
            }
            let Push::Toes(toes) = push else {
                continue;
            };
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
