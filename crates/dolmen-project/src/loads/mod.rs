//! Loads on a structure besides its own weight: wind, static loads, and their combinations.

mod file;
mod file_force;
mod part;
mod parts;
mod read;
mod read_in_time;
mod read_on_floor;
mod read_wind;
mod slips;

pub(crate) use file::{CombinationRaw, LoadRaw, WindOrShelteredRaw};
pub use part::{
    CombinationPart, LoadPart, LoadsPart, WIND_ECCENTRICITY, WindArea, WindGiven, WindInTime, WindPart,
    WindSpeed,
};
pub(crate) use read::loads;
pub(crate) use slips::judge_loads;
