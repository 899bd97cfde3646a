//! Vibration records and ground motions: what was measured, where, and what has been done to it since.

mod at_rest;
mod baseline;
mod cut;
mod decimate;
mod detrend;
mod error;
mod faults;
mod filter;
mod ground_motion;
mod leave_out;
mod measures;
mod noise;
mod pulse;
mod record;
mod response_spectrum;
mod sections;
mod spectra;
mod spectrum_match;

pub use baseline::Baseline;
pub use cut::cut;
pub use decimate::decimate;
pub use detrend::{Trend, detrend};
pub use error::SignalError;
pub use faults::{ChannelFault, inspect};
pub use filter::{band_pass, low_pass};
pub use ground_motion::{Component, GroundMotion};
pub use leave_out::leave_out;
pub use measures::{IntensityMeasures, intensity_measures};
pub use noise::{Noise, NoiseFilter, noise_motion};
pub use pulse::{PulseShape, pulse};
pub use record::{Channel, Processing, Quantity, Record};
pub use response_spectrum::{SpectralOrdinate, response_spectrum};
pub use spectra::{CrossSpectra, Welch, cross_spectra};
pub use spectrum_match::{MatchedMotion, SpectrumMatch, SpectrumMisfit, match_spectrum};
