//! The site of a structure: its hazard and ground motions.

mod file;
mod key;
mod motion;
mod part;
mod place;
mod read;
mod slips;

pub(crate) use file::{MotionRaw, SiteRaw};
pub(crate) use motion::motions;
pub use part::{HazardPart, HazardSource, MotionPart, MotionSize, MotionSource, Place, SitePart};
pub(crate) use place::place;
pub(crate) use read::site;
pub(crate) use slips::judge_korean_place;
