//! Buildings: rigid floors on walls that sway and twist, and their dampers.

mod built_damper;
mod damper;
mod doubts;
mod file;
mod floor_number;
mod moving_part;
mod part;
mod place_damper;
mod read;
mod read_damper;
mod read_damping;
mod slips;
mod slips_damper;

pub use built_damper::{BuiltDamper, Stroke, TunedTo, strokes_of};
pub use damper::{DamperBody, DamperFault, DamperFrequency, DamperMass, DamperPart, MassPart, MovingPart};
pub(crate) use doubts::doubt_building;
pub(crate) use file::{DamperRaw, DampingRaw, FloorRaw, WatchedRaw};
pub use part::{
    BuildingPart, DampingPart, FloorPart, GyrationPart, StoreyStiffnessPart, WallPart, WatchedPart,
};
pub(crate) use read::{buildable, building};
pub(crate) use slips::judge_building;
