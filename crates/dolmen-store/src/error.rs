//! Why a store cannot answer.

use dolmen_work::kept::StoreFault;

/// Why a store cannot answer.
#[derive(Debug, thiserror::Error)]
pub enum StoreError {
    /// What a user can be told.
    #[error(transparent)]
    Fault(#[from] StoreFault),
    /// A value is not of the kind of its column: another program wrote it.
    #[error("{table}.{column} holds a value of another kind")]
    WrongValue {
        /// The table.
        table: &'static str,
        /// The column.
        column: &'static str,
    },
    /// What was given row by row could not be used.
    #[error("{0}")]
    Reader(String),
}

impl StoreError {
    /// The fault as users read it.
    pub fn fault(self) -> StoreFault {
        match self {
            StoreError::Fault(fault) => fault,
            StoreError::WrongValue { .. } => StoreFault::Damaged {
                why: self.to_string(),
            },
            StoreError::Reader(why) => StoreFault::Failed { why },
        }
    }
}
