//! Why a stack cannot be built.

use super::part::StackPart;
use crate::quantity::Quantity;
use dolmen::structure::stack::{BED_GAP_M, Body, Solid, Stack, StackError};

/// Why a stack cannot be built, and where in the file.
#[derive(Clone, Debug, PartialEq)]
pub enum StackFault {
    /// A stone, or its position.
    Part {
        /// Path in the file: `blocks[2]`.
        path: String,
        /// The error of the library.
        why: Box<StackError>,
    },
    /// One block stands on another by the file, but the two do not touch.
    Apart {
        /// Path in the file: `blocks[2]`.
        path: String,
        /// The upper block.
        upper: String,
        /// The block below.
        lower: String,
        /// Distances from the block below to the upper one along x, y and z, m, positive if the upper one lies on the positive side.
        apart_m: [f64; 3],
        /// The allowed distance, m.
        allowed_m: f64,
    },
    /// The stones are loose: until they have settled, there are no joints.
    Loose,
    /// One joint is given twice.
    Twice {
        /// Path in the file: `contacts[2]`.
        path: String,
        /// The upper block.
        upper: String,
        /// The block below.
        lower: String,
        /// The contact that gave it first, from 1.
        first: usize,
    },
}

impl StackFault {
    pub(super) fn part(path: String, why: StackError) -> Self {
        let why = Box::new(why);
        StackFault::Part { path, why }
    }

    /// One block stands on another, but the two do not touch.
    pub(super) fn not_on(path: String, stack: &Stack, upper: usize, lower: Body) -> Self {
        let apart_m = stack.blocks()[upper].solid.above_m(solid(stack, lower));
        StackFault::apart(path, stack, [lower, Body::Block(upper)], apart_m)
    }

    /// Two blocks touch on any side by the file, but do not.
    pub(super) fn not_beside(path: String, stack: &Stack, upper: usize, lower: Body) -> Self {
        let own = &stack.blocks()[upper].solid;
        let apart_m = solid(stack, lower).map_or_else(|| own.above_m(None), |lower| own.apart_m(lower));
        StackFault::apart(path, stack, [lower, Body::Block(upper)], apart_m)
    }

    fn apart(path: String, stack: &Stack, [lower, upper]: [Body; 2], apart_m: [f64; 3]) -> Self {
        StackFault::Apart {
            path,
            upper: stack.name(upper).to_owned(),
            lower: stack.name(lower).to_owned(),
            apart_m,
            allowed_m: BED_GAP_M,
        }
    }

    /// Where in the file.
    pub fn path(&self) -> &str {
        match self {
            StackFault::Part { path, .. }
            | StackFault::Apart { path, .. }
            | StackFault::Twice { path, .. } => path,
            StackFault::Loose => "loose",
        }
    }
}

/// The stone; `None` for the ground.
fn solid(stack: &Stack, body: Body) -> Option<&Solid> {
    match body {
        Body::Ground => None,
        Body::Block(block) => Some(&stack.blocks()[block].solid),
    }
}

impl StackPart {
    /// The tilt of a block that overlaps another or the ground.
    pub(crate) fn tilt_that_overlaps(&self, why: &StackFault) -> Option<&Quantity> {
        let StackFault::Part { why, .. } = why else {
            return None;
        };
        let StackError::Overlap { first, second, .. } = why.as_ref() else {
            return None;
        };
        let mut both = self
            .blocks
            .iter()
            .filter(|block| [first, second].contains(&&block.name));
        both.find_map(|block| block.tilt.iter().flatten().find(|tilt| tilt.value != 0.0))
    }
}
