//! Wind on what stands free: pressures by height, of a gust as given or by a code.

mod air;
mod error;
mod eurocode;
mod given;
mod kds_41;
mod pressure;

pub use air::{EUROCODE_AIR_KG_M3, KDS_41_AIR_KG_M3};
pub use error::WindError;
pub use eurocode::{EurocodeTerrain, EurocodeWind};
pub use given::Wind;
pub use kds_41::{Kds41Exposure, Kds41Wind};
pub use pressure::{Resonance, WindBody, WindPressure, WindStrip};
