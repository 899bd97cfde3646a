//! Wind on free-standing structures: pressures by height, for a given gust or by a code.

mod air;
mod error;
mod eurocode;
mod given;
mod gust_face;
mod gust_forces;
mod kds_41;
mod mean_wind;
mod pressure;
mod turbulence;

pub use air::{EUROCODE_AIR_KG_M3, KDS_41_AIR_KG_M3};
pub use error::WindError;
pub use eurocode::{EurocodeTerrain, EurocodeWind};
pub use given::Wind;
pub use gust_face::{COHERENCE_DECAY, GustFace, GustStrip};
pub use gust_forces::{GustDraw, GustForces, GustTimes};
pub use kds_41::{Kds41Exposure, Kds41Wind};
pub use pressure::{Resonance, WindBody, WindPressure, WindStrip};
pub use turbulence::{Turbulence, TurbulenceSpectrum};
