//! Modes from ambient vibration: frequency, damping ratio and shape, each with its standard deviation.

mod clusters;
mod correlations;
mod error;
mod fdd;
mod identify;
mod indicators;
mod modes;
mod notes;
mod ssi_cov;
mod stabilization;
mod synthetic;
mod uncertainty;

pub use clusters::{Cluster, Clustering, Fate, clusters};
pub use error::ModalError;
pub use fdd::{Fdd, FddResult, SingularSpectrum, fdd};
pub use identify::{Identify, ModalAnalysis, Settings, identify};
pub use indicators::{assurance, phase_collinearity, phase_deviation};
pub use modes::{Method, Mode, Modes};
pub use notes::Note;
pub use ssi_cov::{Pole, SsiCov, Subspace, ssi_cov};
pub use stabilization::{Criteria, JudgedPole, Stability, Stabilization, stabilize};
pub use synthetic::{MadeMode, MadeRecord, ReferenceCase};
pub use uncertainty::{PoleDeviation, Propagation};
