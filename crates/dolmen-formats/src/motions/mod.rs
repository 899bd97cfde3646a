//! Ground motions: bytes of strong-motion files to [`GroundMotion`](dolmen::signal::GroundMotion)s. One format a file.

mod at2;
mod error;
mod options;
mod plausible;
mod read;
mod text;

pub use error::MotionError;
pub use options::{Lengths, MotionOptions};
pub use read::{ComponentReading, MotionFormat, read_component, read_motion};
