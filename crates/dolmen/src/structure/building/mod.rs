//! Buildings: rigid floors on storeys of walls and columns that sway and twist.

mod damping;
mod elements;
mod error;
mod floors;
mod matrices;
mod modes;
mod outline;
mod stability;

pub use damping::{BuildingDamping, DampingAnchor};
pub use elements::{Element, StoreyStiffness};
pub use error::BuildingError;
pub use floors::{Building, Floor, PDelta, Storey};
pub use matrices::PlanDirection;
pub use modes::{BuildingMode, BuildingModes, ModeCentre};
pub use outline::Outline;
pub(crate) use outline::{nearest_on_floor, nearest_on_side};
pub use stability::{StoreyFall, storey_falls};
