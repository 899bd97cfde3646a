//! Heights without an independent meaning: those of stones that support one stone together.

use dolmen::structure::stack::{Body, Joint};
use dolmen_project::{Quantity, StackPart};
use std::collections::BTreeSet;

/// Smallest cosine of the normal of a bed: a steeper face is a side.
const BED_RISE: f64 = 0.7;

/// Paths of the heights of all stones that support a stone together with others: if only one of them becomes higher, the stone lifts off
/// the others.
pub(crate) fn heights_that_others_share(part: &StackPart) -> BTreeSet<String> {
    let Ok(stack) = part.build(&mut Quantity::nominal) else {
        return BTreeSet::new();
    };
    let mut paths = BTreeSet::new();
    for upper in 0..stack.blocks().len() {
        let lowers = lowers(stack.joints(), upper);
        if lowers.len() < 2 {
            continue;
        }
        let columns: Vec<BTreeSet<usize>> = lowers
            .iter()
            .map(|body| match body {
                Body::Block(block) => column(stack.joints(), *block),
                Body::Ground => BTreeSet::new(),
            })
            .collect();
        let is_of_all = |block: &usize| columns.iter().all(|column| column.contains(block));
        let own = columns.iter().flatten().filter(|block| !is_of_all(block));
        paths.extend(own.map(|block| format!("blocks[{}].height", block + 1)));
    }
    paths
}

/// The blocks under a block, without duplicates.
fn lowers(joints: &[Joint], upper: usize) -> Vec<Body> {
    let beds = joints.iter().filter(|joint| joint.axes[2][2].abs() > BED_RISE);
    let mut all: Vec<Body> = Vec::new();
    for joint in beds.filter(|joint| joint.upper == upper) {
        if !all.contains(&joint.lower) {
            all.push(joint.lower);
        }
    }
    all
}

/// A block and all blocks under it, down to the ground.
fn column(joints: &[Joint], top: usize) -> BTreeSet<usize> {
    let mut column = BTreeSet::new();
    let mut reached = vec![top];
    while let Some(block) = reached.pop() {
        if column.insert(block) {
            reached.extend(lowers(joints, block).into_iter().filter_map(|body| match body {
                Body::Block(lower) => Some(lower),
                Body::Ground => None,
            }));
        }
    }
    column
}
