//! Why a stack cannot be built.

use dolmen::structure::stack::StackError;

/// Why a stack cannot be built, and where in the file.
#[derive(Clone, Debug, PartialEq)]
pub enum StackFault {
    /// A stone, or where it stands.
    Part {
        /// Where in the file: `blocks[2]`.
        path: String,
        /// What the science says.
        why: Box<StackError>,
    },
    /// Two blocks that the file puts on each other do not touch.
    Apart {
        /// Where in the file: `blocks[2]`.
        path: String,
        /// The upper block.
        upper: String,
        /// What it should stand on.
        lower: String,
        /// What is allowed, m.
        allowed_m: f64,
    },
    /// One joint is given twice.
    Twice {
        /// Where in the file: `contacts[2]`.
        path: String,
        /// The upper block.
        upper: String,
        /// What it stands on.
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

    /// Where in the file.
    pub fn path(&self) -> &str {
        match self {
            StackFault::Part { path, .. }
            | StackFault::Apart { path, .. }
            | StackFault::Twice { path, .. } => path,
        }
    }
}
