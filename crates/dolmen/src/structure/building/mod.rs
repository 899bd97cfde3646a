//! Buildings: rigid floors on storeys of walls and columns that sway and twist.

mod accidental;
mod building_of_floors;
mod damping;
mod elements;
mod error;
mod floor_loads;
mod floor_motion;
mod floors;
mod matrices;
mod modes;
mod outline;
mod plan_bounds;
mod plan_direction;
mod plan_double_root;
mod plan_roots;
mod plan_scatter;
mod plan_stiffness;
mod plan_storey;
mod stability;

pub use building_of_floors::{Building, PDelta};
pub use damping::{BuildingDamping, DampingAnchor};
pub use elements::{Element, StoreyStiffness};
pub use error::BuildingError;
pub use floor_loads::FloorLoad;
pub use floor_motion::{FloorMode, FloorModes, FloorPlace, floor_modes};
pub use floors::{Floor, Storey};
pub use modes::{BuildingMode, BuildingModes, ModeCentre};
pub use outline::Outline;
pub(crate) use outline::{nearest_on_floor, nearest_on_side};
pub use plan_bounds::{PlanBounds, plan_bounds};
pub use plan_direction::PlanDirection;
pub use plan_stiffness::{
    MovesOtherwise, PlanSolution, PlanStiffness, ShapeOtherwise, SingleStiffness, plan_stiffness,
};
pub use plan_storey::{EccentricityFrom, PlanMode, PlanMotion, PlanStiffnessError, PlanStorey, Twist};
pub use stability::{StoreyFall, StoreyMotion, storey_falls};
