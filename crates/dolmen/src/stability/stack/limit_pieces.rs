//! The balance of a stack in pieces that know nothing of each other: a linear programme each.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | t | `most` | horizontal acceleration over gravity | – |
//! | x | – | shares of the forces, each over the weight on its block | – |

use super::cuts::{carried, carries};
use super::loads::{Load, together};
use crate::numeric::{Reach, SparseColumn, reach};
use crate::stability::StabilityError;
use crate::structure::stack::{Body, Stack};
use glam::DVec3;

/// Coefficients (of order 1) below this are rounding and left out. Chosen here.
const ROUNDING: f64 = 1e-13;

/// One unknown: a force on a block and its opposite on what is below.
pub(super) struct Force {
    /// Which link it acts in: a joint, or after all joints a tie.
    pub(super) link: usize,
    pub(super) at: DVec3,
    pub(super) way: DVec3,
    /// A bound on the sum of all forces that name the same one, N.
    pub(super) bound: Option<(usize, f64)>,
}

/// Two bodies that push, rub or pull.
#[derive(Clone, Copy)]
struct Link {
    lower: Option<usize>,
    upper: usize,
}

impl Link {
    fn new(lower: Body, upper: usize) -> Self {
        let lower = match lower {
            Body::Ground => None,
            Body::Block(block) => Some(block),
        };
        Link { lower, upper }
    }
}

/// What is balanced as one: three forces, three moments.
struct Balance {
    load: Load,
    /// The point of its moments.
    about: DVec3,
    /// All the weight that its block carries, N.
    weight: f64,
}

/// Blocks and forces that depend on each other, as a linear programme.
#[derive(Default)]
pub(super) struct Piece {
    columns: Vec<SparseColumn>,
    right: Vec<f64>,
    along: Vec<f64>,
}

/// How far one piece can be balanced.
pub(super) struct Balanced {
    pub(super) stands: bool,
    /// Largest acceleration over gravity; may be infinite.
    pub(super) most: f64,
    /// Largest balance or bound missed, over weight and size, with and without that acceleration.
    pub(super) residual: f64,
}

/// A stack in pieces.
///
/// ```text
/// a joint that alone links all it carries to the rest: its forces balance the sum of what it carries    [6 equations]
/// all other blocks, with the sum of what stands so on each as their load; linked ones in one piece      [6 a block]
/// ```
///
/// Together they say the same as the balance of every block.
pub(super) fn pieces(
    stack: &Stack,
    loads: &[Load],
    forces: &[Force],
    direction: [f64; 2],
    ties: bool,
) -> Vec<Piece> {
    let mut links: Vec<Link> = stack
        .joints()
        .iter()
        .map(|joint| Link::new(joint.lower, joint.upper))
        .collect();
    if ties {
        links.extend(stack.ties().iter().map(|tie| Link::new(tie.lower, tie.upper)));
    }
    let groups: Vec<Vec<usize>> = (0..loads.len())
        .map(|block| carried(stack, vec![block]))
        .collect();
    let alone: Vec<Option<usize>> = (0..loads.len())
        .map(|block| alone(stack, &links, block, &groups[block]))
        .collect();
    let single = |link: usize| alone[links[link].upper] == Some(link);
    // the blocks a link takes part in the balance of
    let ends = |link: usize| -> Vec<(usize, f64)> {
        let Link { lower, upper } = links[link];
        let both = [(Some(upper), 1.0), (lower.filter(|_| !single(link)), -1.0)];
        let taken = both.into_iter().filter_map(|(block, sign)| Some((block?, sign)));
        taken
            .filter(|&(block, _)| single(link) || alone[block].is_none())
            .collect()
    };
    let mut piece_of: Vec<usize> = (0..loads.len()).collect();
    for link in 0..links.len() {
        if let [(a, _), (b, _)] = ends(link)[..] {
            let (kept, gone) = (piece_of[a], piece_of[b]);
            for piece in &mut piece_of {
                if *piece == gone {
                    *piece = kept;
                }
            }
        }
    }
    let gravity = stack.gravity_m_s2();
    let balances: Vec<Balance> = (0..loads.len())
        .map(|block| {
            let mut blocks = vec![block];
            if alone[block].is_some() {
                blocks.clone_from(&groups[block]);
            } else {
                let on_it = (0..loads.len())
                    .filter(|&above| alone[above].is_some_and(|link| links[link].lower == Some(block)));
                blocks.extend(on_it.flat_map(|above| &groups[above]));
            }
            Balance {
                load: together(loads, &blocks),
                about: loads[block].centroid(),
                weight: together(loads, &groups[block]).mass * gravity,
            }
        })
        .collect();
    let scale = Scale {
        way: DVec3::new(direction[0], direction[1], 0.0),
        gravity,
        length: stack.height_m(),
    };
    let found = (0..loads.len()).filter(|&piece| piece_of.contains(&piece));
    found
        .map(|piece| {
            let within: Vec<usize> = (0..loads.len())
                .filter(|&block| piece_of[block] == piece)
                .collect();
            let mut made = Piece::default();
            for &block in &within {
                made.balance(&balances[block], &scale);
            }
            let row_of = |block: usize| within.binary_search(&block).ok().map(|at| 6 * at);
            let mut bounds = Vec::new();
            for force in forces {
                let ends = ends(force.link);
                let Some(&(first, _)) = ends.first().filter(|end| piece_of[end.0] == piece) else {
                    continue;
                };
                let unit = balances[first].weight;
                let mut column = SparseColumn::new();
                for (block, sign) in ends {
                    if let Some(row) = row_of(block) {
                        let balance = &balances[block];
                        let push = force.way * (sign * unit);
                        let six = scale.six(balance, push, force.at.cross(push));
                        let parts = six
                            .into_iter()
                            .enumerate()
                            .filter(|(_, part)| part.abs() > ROUNDING);
                        column.extend(parts.map(|(at, part)| (row + at, part)));
                    }
                }
                if let Some((bound, most_n)) = force.bound {
                    let row = bounds
                        .iter()
                        .position(|&other| other == bound)
                        .unwrap_or_else(|| {
                            bounds.push(bound);
                            bounds.len() - 1
                        });
                    let row = 6 * within.len() + row;
                    if row == made.right.len() {
                        made.right.push(most_n / unit);
                        made.along.push(0.0);
                        made.columns.push(vec![(row, 1.0)]);
                    }
                    column.push((row, 1.0));
                }
                made.columns.push(column);
            }
            made
        })
        .collect()
}

/// The joint under a block, if nothing else links what the block carries to the rest.
fn alone(stack: &Stack, links: &[Link], block: usize, group: &[usize]) -> Option<usize> {
    let within = |block: usize| group.binary_search(&block).is_ok();
    let mut crossing =
        (0..links.len()).filter(|&link| within(links[link].upper) != links[link].lower.is_some_and(within));
    let only = crossing.next().filter(|_| crossing.next().is_none())?;
    let joint = stack.joints().get(only)?;
    (joint.upper == block && carries(joint)).then_some(only)
}

/// Makes forces and moments of order 1.
struct Scale {
    way: DVec3,
    gravity: f64,
    length: f64,
}

impl Scale {
    /// Force over the weight, moment (given about the origin) about the point of the balance over weight and length.
    fn six(&self, balance: &Balance, force: DVec3, moment: DVec3) -> [f64; 6] {
        let moment = (moment - balance.about.cross(force)) / (balance.weight * self.length);
        let force = force / balance.weight;
        [force.x, force.y, force.z, moment.x, moment.y, moment.z]
    }
}

impl Piece {
    /// Adds six equations.
    fn balance(&mut self, balance: &Balance, scale: &Scale) {
        let load = &balance.load;
        let shaking = scale.way * (load.mass * scale.gravity);
        let at_rest = scale.six(balance, load.force, load.moment);
        let along = scale.six(balance, shaking, load.centroid().cross(shaking));
        self.right.extend(at_rest.map(|part| -part));
        self.along.extend(along.map(|part| -part));
    }

    /// Unknowns: forces, slack of bounds, the acceleration.
    pub(super) fn variables(&self) -> usize {
        self.columns.len() + 1
    }

    pub(super) fn equations(&self) -> usize {
        self.right.len()
    }

    /// The largest acceleration for which it can be balanced, if it can without any.
    pub(super) fn solve(&self) -> Result<Balanced, StabilityError> {
        let reached = reach(&self.columns, &self.right, &self.along).map_err(|fault| {
            StabilityError::LinearProgramme {
                reason: fault.to_string(),
            }
        })?;
        Ok(match reached {
            Reach::To {
                most,
                at_start,
                at_most,
            } => Balanced {
                stands: true,
                most,
                residual: self.residual(0.0, &at_start).max(self.residual(most, &at_most)),
            },
            Reach::Endless { at_start } => Balanced {
                stands: true,
                most: f64::INFINITY,
                residual: self.residual(0.0, &at_start),
            },
            Reach::Nowhere { .. } => Balanced {
                stands: false,
                most: 0.0,
                residual: 0.0,
            },
        })
    }

    /// Largest balance or bound missed, or pull of a joint.
    fn residual(&self, most: f64, shares: &[f64]) -> f64 {
        let mut left: Vec<f64> = self
            .right
            .iter()
            .zip(&self.along)
            .map(|(right, along)| right + most * along)
            .collect();
        let mut residual = 0.0_f64;
        for (column, &share) in self.columns.iter().zip(shares) {
            residual = residual.max(-share);
            for &(row, value) in column {
                left[row] -= value * share;
            }
        }
        left.into_iter().fold(residual, |most, left| most.max(left.abs()))
    }
}
