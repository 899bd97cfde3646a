//! Free-standing columns on foot stones: resistance of their weight to drift.

mod column;
mod foot;
mod swing;

pub use column::{ColumnPoint, ColumnStanding, FreeColumns};
pub use foot::{FootPressure, FootSection};
