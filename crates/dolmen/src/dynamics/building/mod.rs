//! Buildings that twist under moving ground: exact between the samples, with or without tuned masses; and by response spectra.

mod complex_modes;
mod exponential;
mod history;
mod secular;
mod spectrum_analysis;
mod vibrating;

pub use history::{
    BuildingHistory, BuildingPeaks, BuildingRun, FloorPeak, HistoryMethod, Peak, StoreyPeak, building_history,
};
pub use spectrum_analysis::{
    DirectionalCombination, ModalCombination, SpectralAnalysis, SpectralMode, correlation_coefficient,
    spectral_analysis,
};
pub use vibrating::{TunedMass, VibratingBuilding};
