//! Modes from the spectrum: from its peaks and the lines near them, and from matrix fractions fitted to half
//! spectra.

mod buried;
mod efdd;
mod fdd;
mod fraction_deviation;
mod fraction_fit;
mod half_spectra;
mod level_peaks;
mod plscf;
mod plscf_options;
mod reference_channels;
mod spectral_matrices;

pub(super) use buried::BuriedPeak;
pub use efdd::{Efdd, efdd};
pub(super) use fdd::peaks_of;
pub use fdd::{Fdd, FddResult, SingularSpectrum, fdd};
pub(super) use fraction_deviation::FractionScatter;
pub(super) use level_peaks::{decibel, peaks};
pub use plscf::{MatrixFraction, plscf};
pub use plscf_options::Plscf;
pub(super) use reference_channels::{REFERENCES_LEAST, keeping_most, least_of_wide};
pub(super) use spectral_matrices::{SpectralMatrices, parzen};
