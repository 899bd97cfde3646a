//! Buildings with torsion under ground motion, with or without tuned masses: time histories that are exact between samples,
//! and response spectra.

mod between_steps;
mod building_peaks;
mod complex_modes;
mod exponential;
mod history;
mod peak_tracking;
mod peaks;
mod secular;
mod spectrum_analysis;
mod stepping;
mod vibrating;

pub use building_peaks::{BuildingPeaks, FloorPeak, Peak, ResultantDrift, StoreyPeak};
pub(crate) use exponential::{BaseDriven, ExponentialSteps};
pub(crate) use history::shaken;
pub use history::{BuildingHistory, BuildingRun, Histories, HistoryMethod, WatchedHistory, building_history};
pub use spectrum_analysis::{
    DirectionalCombination, LeastFavourable, ModalCombination, SpectralAnalysis, SpectralMode,
    correlation_coefficient, spectral_analysis,
};
pub use vibrating::{TunedMass, VibratingBuilding};
