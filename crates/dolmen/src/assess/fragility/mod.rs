//! Lognormal fragility curves: the probability that a structure reaches a state, from its results under shaking of known size.

mod bootstrap;
mod bound;
mod crossed;
mod curve;
mod fit;
mod fitted_curve;
mod likelihood;
mod moments;
mod observation;
mod scatter;

pub use bootstrap::{FragilityBand, bootstrap_fragility, bootstrap_fragility_of_motions};
pub use bound::FragilityBound;
pub use curve::{Crossing, Fragility, crossing};
pub use fit::{fit_fragility, fit_fragility_of_motions};
pub use fitted_curve::{FragilityFit, OfSamples};
pub use moments::{fit_fragility_by_moments, motions_needed};
pub use observation::Observation;
pub use scatter::{ScatterSplit, scatter_split};
