//! Stacks of stone: blocks, the joints between them, and what ties and holds them.

mod arch;
mod beds;
mod cut;
mod error;
mod hull;
mod hull_faces;
mod joint;
mod material;
mod mesh;
mod on_ground;
mod opening;
mod overlap;
mod pagoda;
mod perturbed;
mod polygon;
mod scan;
mod shapes;
mod solid;
mod stack_of_blocks;
mod support_movement;
mod wall;

pub use arch::{ArchFactors, arch};
pub use beds::BED_GAP_M;
pub use error::StackError;
pub use joint::{Body, Joint, ScannedJoint};
pub use material::JointMaterial;
pub use pagoda::{Pagoda, PagodaFactors, PagodaSlenderness, pagoda};
pub use perturbed::SmallDifferences;
pub use polygon::{Polygon, PolygonMoments};
pub use solid::{Placement, Scan, Solid};
pub use stack_of_blocks::{Block, SideSupport, Stack, Tie};
pub use support_movement::SupportMovement;
pub use wall::{WallFactors, wall};
