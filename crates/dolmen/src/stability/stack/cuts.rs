//! Finds the parts of a stack that can move as one rigid body: cuts through joints in one plane.

use crate::structure::stack::{BED_GAP_M, Body, Joint, Stack};
use glam::DVec3;

/// Least sine of the inclination of a joint from the vertical for which the joint carries load (about 6°); a steeper joint is only a side
/// contact. Our choice: an upright face may lean by 5°.
const CARRIES_LEAST: f64 = 0.1;
/// Cosine of 1°, the largest angle between joints in one plane. Our choice.
const PARALLEL: f64 = 0.999_847_7;

/// A part of the stack that can tip or slide on the rest as one rigid body.
#[derive(Clone, Debug, PartialEq)]
pub struct Cut {
    /// Indices of the blocks above the cut, ascending.
    pub blocks: Vec<usize>,
    /// Indices of the joints that carry them, all in one plane, ascending.
    pub joints: Vec<usize>,
}

/// All cuts of a stack.
#[derive(Clone, Debug, PartialEq)]
pub struct Cuts {
    /// The cuts, from the lowest joint up.
    pub cuts: Vec<Cut>,
    /// Groups of blocks that would move together but rest on joints in different planes, or have side contacts. Their equilibrium is statically
    /// indeterminate, so they need a limit analysis.
    pub undecided: Vec<Vec<usize>>,
    /// Whether every block rests on one joint and has no side contact. Equilibrium alone then gives the force in each joint, and the cuts
    /// include all mechanisms.
    pub statically_determinate: bool,
}

/// Whether each stone rests on exactly one load-carrying joint, so that statics alone gives the force in every joint.
pub(crate) fn is_statically_determinate(stack: &Stack) -> bool {
    stack.joints().len() == stack.blocks().len() && stack.joints().iter().all(carries)
}

/// Finds the cuts of a stack.
///
/// ```text
/// carried(A) = A and all blocks that stand on A, directly or through others
/// cuts: connected parts of carried({upper block of j}) for each joint j that carries,
///       and of carried({upper blocks of all joints in the plane of j}); each once
/// kept if all joints between the part and the other blocks lie in one plane below it (1°, 5 mm)
/// ```
///
/// # Limits
/// If each block rests on one other block, the cuts are complete. If stones share their load (a storey of several stones, an arch), other
/// mechanisms exist, and every cut is an upper bound of the true limit. A part with a joint missing from its equilibrium would give neither an
/// upper nor a lower bound: it is undecided.
pub fn cuts(stack: &Stack) -> Cuts {
    let joints = stack.joints();
    let carrying: Vec<usize> = (0..joints.len())
        .filter(|&joint| carries(&joints[joint]))
        .collect();
    let mut found = Cuts {
        cuts: Vec::new(),
        undecided: Vec::new(),
        statically_determinate: is_statically_determinate(stack),
    };
    let carriers = SupportRelation::of(stack);
    let mut parts: Vec<Vec<usize>> = Vec::new();
    for &joint in &carrying {
        let level = carrying
            .iter()
            .filter(|&&other| same_plane(&joints[joint], &joints[other]));
        let together: Vec<usize> = level.map(|&other| joints[other].upper).collect();
        for start in [vec![joints[joint].upper], together] {
            for part in carriers.connected(&carriers.carried(start)) {
                if !parts.contains(&part) {
                    parts.push(part);
                }
            }
        }
    }
    for blocks in parts {
        let mut cut = Cut {
            blocks,
            joints: Vec::new(),
        };
        let mut leans = false;
        let mut within = vec![false; stack.blocks().len()];
        for &block in &cut.blocks {
            within[block] = true;
        }
        for (index, joint) in joints.iter().enumerate() {
            let above = within[joint.upper];
            let below = !matches!(joint.lower, Body::Block(block) if within[block]);
            if carries(joint) && above && below {
                cut.joints.push(index);
            } else if !carries(joint) && above == below {
                leans = true;
            }
        }
        let planar = cut
            .joints
            .iter()
            .all(|&joint| same_plane(&joints[cut.joints[0]], &joints[joint]));
        if planar && !leans {
            found.cuts.push(cut);
        } else {
            found.undecided.push(cut.blocks);
        }
    }
    let height = |cut: &Cut| joints[cut.joints[0]].origin_m[2];
    found.cuts.sort_by(|a, b| {
        height(a)
            .total_cmp(&height(b))
            .then(b.blocks.len().cmp(&a.blocks.len()))
    });
    found
}

pub(super) fn carries(joint: &Joint) -> bool {
    joint.axes[2][2] > CARRIES_LEAST
}

fn same_plane(a: &Joint, b: &Joint) -> bool {
    let (normal, other) = (DVec3::from(a.axes[2]), DVec3::from(b.axes[2]));
    let between = DVec3::from(b.origin_m) - DVec3::from(a.origin_m);
    normal.dot(other) >= PARALLEL && normal.dot(between).abs() <= BED_GAP_M
}

/// The pairs of blocks that rest on each other.
pub(super) struct SupportRelation {
    /// The blocks on each block.
    on: Vec<Vec<usize>>,
    /// The blocks under each block.
    under: Vec<Vec<usize>>,
}

impl SupportRelation {
    pub(super) fn of(stack: &Stack) -> Self {
        let none = vec![Vec::new(); stack.blocks().len()];
        let mut carriers = SupportRelation {
            on: none.clone(),
            under: none,
        };
        for joint in stack.joints().iter().filter(|joint| carries(joint)) {
            if let Body::Block(lower) = joint.lower {
                carriers.on[lower].push(joint.upper);
                carriers.under[joint.upper].push(lower);
            }
        }
        carriers
    }

    /// These blocks and all blocks above them, ascending.
    pub(super) fn carried(&self, start: Vec<usize>) -> Vec<usize> {
        let mut above = vec![false; self.on.len()];
        let mut next = start;
        while let Some(block) = next.pop() {
            if !std::mem::replace(&mut above[block], true) {
                next.extend(&self.on[block]);
            }
        }
        (0..above.len()).filter(|&block| above[block]).collect()
    }

    /// The groups of these blocks that joints connect, each ascending.
    fn connected(&self, blocks: &[usize]) -> Vec<Vec<usize>> {
        let mut left = vec![false; self.on.len()];
        for &block in blocks {
            left[block] = true;
        }
        let mut parts = Vec::new();
        for &first in blocks {
            let (mut part, mut next) = (Vec::new(), vec![first]);
            while let Some(block) = next.pop() {
                if std::mem::replace(&mut left[block], false) {
                    part.push(block);
                    next.extend(self.on[block].iter().chain(&self.under[block]));
                }
            }
            if !part.is_empty() {
                part.sort_unstable();
                parts.push(part);
            }
        }
        parts.sort();
        parts
    }
}
