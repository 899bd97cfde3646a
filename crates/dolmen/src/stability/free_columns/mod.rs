//! Free-standing columns on foot stones: their resistance to drift by their weight.

mod column;
mod foot;
mod swing;

pub use column::{ColumnPoint, ColumnStanding, FreeColumns};
pub use foot::{FootPressure, FootSection};
