//! Columns that stand free on foot stones: what their weight holds against drift.

mod column;
mod foot;
mod swing;

pub use column::{ColumnPoint, ColumnStanding, FreeColumns};
pub use foot::{FootPressure, FootSection};
