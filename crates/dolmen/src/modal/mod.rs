//! Modes from ambient vibration: frequency, damping ratio and shape, each with its standard deviation.

mod accept;
mod candidate;
mod correlations;
mod decay;
mod driven;
mod error;
mod halves;
mod identify;
mod indicators;
mod likelihood;
mod modal_analysis;
mod modes;
mod noted;
mod notes;
mod options;
mod products;
mod quality;
mod refusal;
mod sensor_placement;
mod sensors;
mod settings;
mod setups;
mod shared_steps;
mod spectrum;
mod streaming_sums;
mod strong;
mod subspace;
mod synthetic;
mod unkind;

pub use decay::{
    AtAmplitude, Decay, DecaysInRecord, Decrement, Era, FreeDecay, ModeDecay, Overtone, decrement, era,
};
pub use driven::{
    Driven, DrivenMode, FrequencyResponse, FrequencyResponses, MadeOnGround, MadeOneMass, OffGround,
    frequency_responses,
};
pub use error::ModalError;
pub use identify::identify;
pub use indicators::{assurance, phase_collinearity, phase_deviation};
pub use modal_analysis::ModalAnalysis;
pub use modes::{Method, Mode, Modes};
pub use noted::{LateClock, ShapeQuantity, Tone, ToneOnMode};
pub use notes::Note;
pub use options::{Harmonics, Identify};
pub use quality::{FromClipping, InSpells, Kurtosis, Wander, band_kurtosis};
pub use refusal::{Accepted, Refusal, RefusedPeak};
pub use sensor_placement::{PlacedSensors, SensorPlacement};
pub use sensors::{SensorDoubt, doubt_sensors};
pub use settings::Settings;
pub(crate) use setups::shared;
pub use setups::{
    Agreement, JointSetups, MergeSetups, MergedMode, MergedSetups, ModePair, MovedFurther, ObservedMode,
    ObservedPoint, PairedModes, Pairing, PartialMode, ReferenceFault, SuspectReference, joint_setups,
    merge_setups, pair_modes,
};
pub use spectrum::{Efdd, Fdd, FddResult, MatrixFraction, Plscf, SingularSpectrum, efdd, fdd, plscf};
pub use strong::{
    AtLeast, DrivenPart, During, LastingChange, Losses, MadeEarthquake, Part, Shaking, ShakingKind,
    StrongChannel, StrongEvent, StrongMotion, TrackPoint, Tracked, earthquake_in, earthquakes_in,
    is_of_one_state, strong_motion,
};
pub use subspace::{
    Cluster, Clustering, Criteria, Fate, JudgedPole, Pole, PoleDeviation, Propagation, Ssi, Stability,
    Stabilization, Subspace, clusters, ssi_cov, ssi_data,
};
pub use synthetic::{MadeMode, MadeRecord, ReferenceCase};
pub use unkind::{UnkindMode, UnkindPlan, UnkindRecord, UnkindTone};
