//! What codes demand of a site: design spectra. One code a file, its tables as data.

mod eurocode;
mod korea;
mod spectrum;

pub use eurocode::{EurocodeGround, EurocodeType, eurocode_8};
pub use korea::{Kds41, KoreanSite, KoreanZone, kds_17, kds_17_effective_acceleration_g, kds_41};
pub use spectrum::{DesignSpectrum, VerticalRatio};
