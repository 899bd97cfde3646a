//! Ground motions: bytes of strong-motion files to [`GroundMotion`](dolmen::signal::GroundMotion)s, and back.

mod at2;
mod channel;
mod cosmos;
mod csmip;
mod error;
mod esm;
mod knet;
mod lines;
mod miniseed;
mod options;
mod orientation;
mod oriented;
mod plausible;
mod read;
mod sac;
mod start;
mod steim;
mod text;
mod units;
mod write;

pub(crate) use channel::raw_channels;
pub use channel::{ComponentReading, read_channels, read_component};
pub use error::MotionError;
pub use options::{Lengths, MotionOptions, StatedPeak};
pub use orientation::Orientation;
pub use oriented::read_oriented;
pub(crate) use read::Raw as RawChannel;
pub use read::{MotionFormat, read_motion};
pub use start::start_of_text;
pub(crate) use start::{time_of, time_text};
pub use write::{motion_at2, motion_csv};
