//! Records with earthquakes: their detection, and the structure before, during, between and after them.

mod detection;
mod features;
mod lasting;
mod lasting_change;
mod levels;
mod losses;
mod made;
mod mode_pairs;
mod part;
mod parts;
mod peaks;
mod shaking;
mod strong_motion;
mod track;
mod wind;

pub use detection::{earthquake_in, earthquakes_in};
pub(super) use lasting::between_parts;
pub use lasting_change::LastingChange;
pub use losses::{AtLeast, Losses};
pub use made::MadeEarthquake;
pub use part::Part;
pub use parts::{DrivenPart, During, is_of_one_state};
pub use peaks::StrongChannel;
pub use shaking::{Shaking, ShakingKind};
pub use strong_motion::{StrongEvent, StrongMotion, strong_motion};
pub use track::{TrackPoint, Tracked};
