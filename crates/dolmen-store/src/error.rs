//! Errors of a store.

use dolmen_work::kept::StoreFault;

/// Why a store fails.
#[derive(Debug, thiserror::Error)]
pub enum StoreError {
    /// A fault with a message for the user.
    #[error(transparent)]
    Fault(#[from] StoreFault),
    /// A value has another type than its column: another program wrote it.
    #[error("{table}.{column} holds a value of another kind")]
    WrongValue {
        /// The table.
        table: &'static str,
        /// The column.
        column: &'static str,
    },
    /// The closure that received the rows failed.
    #[error("{0}")]
    Reader(String),
}

impl StoreError {
    /// The fault as the user reads it.
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
