//! Records that hold an earthquake: told from ambient vibration, and what the structure did before, in and after it.

mod made;
mod parts;
mod peaks;
mod shaking;
mod strong_motion;
mod track;

pub use made::MadeEarthquake;
pub use parts::{During, DuringMode, LastingChange, Part};
pub use peaks::StrongChannel;
pub use shaking::{Shaking, earthquake_in};
pub use strong_motion::{StrongMotion, strong_motion};
pub use track::{TrackPoint, Tracked};
