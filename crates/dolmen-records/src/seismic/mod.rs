//! Files of seismic stations, used for vibration records and ground motions: bytes to the numbers of each channel.

mod at2;
mod cosmos;
mod csmip;
mod error;
mod esm;
mod knet;
mod lines;
mod miniseed;
mod orientation;
mod raw;
mod read;
mod response;
mod sac;
mod steim;
mod units;

pub use error::SeismicError;
pub use orientation::Orientation;
pub use raw::MotionFormat;
pub(crate) use raw::Raw;
pub(crate) use read::{motion_channels, raw_channels};
pub use response::{Response, responses};
