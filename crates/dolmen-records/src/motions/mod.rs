//! Ground motions: bytes of strong-motion files to [`GroundMotion`](dolmen::signal::GroundMotion)s, and back.

mod channel;
mod error;
mod options;
mod oriented;
mod origin;
mod plausible;
mod read;
mod spike;
mod text;
mod write;

pub use crate::seismic::{MotionFormat, Orientation, Response, SeismicError, responses};
pub use crate::start::start_of_text;
pub use channel::{ComponentReading, read_channels, read_component};
pub use error::MotionError;
pub use options::{Lengths, MotionOptions, ReadFor, StatedPeak};
pub use oriented::read_oriented;
pub use origin::{Origin, origin};
pub use read::{ComponentSource, read_columns_as, read_motion};
pub use write::{motion_at2, motion_csv};
