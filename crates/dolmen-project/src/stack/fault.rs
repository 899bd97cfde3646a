//! Why a stack cannot be built.

use crate::wrong::WrongStack;
use dolmen::structure::stack::StackError;
use dolmen_words::message::Both;

/// Why a stack cannot be built, and where in the file.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum StackFault {
    /// A stone, or where it stands.
    #[error("{path}: {why}")]
    Part {
        /// Where in the file: `blocks[2]`.
        path: String,
        /// What the science says.
        why: Box<StackError>,
    },
    /// Two blocks that the file puts on each other do not touch.
    #[error(
        "'{upper}' is said to stand on '{lower}', but they do not touch: a bed there must lie within {allowed_m} m of it and \
         be level with it to 5°"
    )]
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
    #[error(
        "{path} gives the joint of '{upper}' on '{lower}' a second time, after contacts[{first}]: keep one of them"
    )]
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

    /// What is wrong; what the science says is English in both languages.
    pub(crate) fn said(&self) -> Both {
        match self {
            StackFault::Part { .. } => Both::from(self.to_string()),
            StackFault::Apart {
                upper,
                lower,
                allowed_m,
                ..
            } => Both::from(WrongStack::Apart {
                upper: upper.clone(),
                lower: lower.clone(),
                allowed_m: allowed_m.to_string(),
            }),
            StackFault::Twice {
                path,
                upper,
                lower,
                first,
            } => Both::from(WrongStack::GivenTwice {
                path: path.clone(),
                upper: upper.clone(),
                lower: lower.clone(),
                first: first.to_string(),
            }),
        }
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
