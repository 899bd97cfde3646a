//! Modes from ambient vibration: frequency, damping ratio and shape, each with its standard deviation.

mod clusters;
mod correlations;
mod decomposed;
mod efdd;
mod error;
mod fdd;
mod hankel;
mod harmonics;
mod identify;
mod indicators;
mod modes;
mod notes;
mod pairing;
mod settings;
mod setups;
mod ssi;
mod stabilization;
mod synthetic;
mod uncertainty;

pub use clusters::{Cluster, Clustering, Fate, clusters};
pub use efdd::{Efdd, efdd};
pub use error::ModalError;
pub use fdd::{Fdd, FddResult, SingularSpectrum, fdd};
pub use harmonics::{Kurtosis, band_kurtosis};
pub use identify::{Harmonics, Identify, ModalAnalysis, identify};
pub use indicators::{assurance, phase_collinearity, phase_deviation};
pub use modes::{Method, Mode, Modes};
pub use notes::{Note, Tone};
pub use pairing::{ModePair, ObservedMode, ObservedPoint, PairedModes, Pairing, pair_modes};
pub use settings::Settings;
pub use setups::{Agreement, MergeSetups, MergedMode, MergedSetups, PartialMode, merge_setups};
pub use ssi::{Pole, Ssi, Subspace, ssi_cov, ssi_data};
pub use stabilization::{Criteria, JudgedPole, Stability, Stabilization, stabilize};
pub use synthetic::{MadeMode, MadeRecord, ReferenceCase};
pub use uncertainty::{PoleDeviation, Propagation};
