//! Vibration records and ground motions: what was measured, where, and what has been done to it since.

mod cut;
mod decimate;
mod detrend;
mod error;
mod faults;
mod filter;
mod ground_motion;
mod leave_out;
mod record;
mod response_spectrum;
mod sections;
mod spectra;

pub use cut::cut;
pub use decimate::decimate;
pub use detrend::{Trend, detrend};
pub use error::SignalError;
pub use faults::{ChannelFault, inspect};
pub use filter::{band_pass, low_pass};
pub use ground_motion::{Component, GroundMotion};
pub use leave_out::leave_out;
pub use record::{Channel, Processing, Quantity, Record};
pub use response_spectrum::{SpectralOrdinate, response_spectrum};
pub use spectra::{CrossSpectra, Welch, cross_spectra};
