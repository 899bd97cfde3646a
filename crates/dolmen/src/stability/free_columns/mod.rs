//! Free-standing columns on foot stones: resistance of their weight to drift.

mod beside_joints;
mod column;
mod foot;
mod swing;

pub use beside_joints::ColumnsBesideJoints;
pub use column::{ColumnPoint, ColumnStanding, FreeColumns};
pub use foot::{FootPressure, FootSection};
