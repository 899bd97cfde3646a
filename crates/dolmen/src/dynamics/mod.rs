//! Time histories that are exact between events: frames with dry friction, chains up to collapse, one rocking block. Columns on
//! compliant beds in steps.

mod building;
mod chain_friction;
mod chain_friction_state;
mod chain_growth;
mod chain_history;
mod chain_model;
mod chain_motion;
mod chain_moving;
mod chain_props;
mod chain_rest;
mod chain_rigid;
mod chain_rotations;
mod chain_run;
mod chain_series;
mod chain_studies;
mod column_run;
mod columns_on_beds;
mod columns_steps;
mod error;
mod excitation;
mod frame_events;
mod frame_friction;
mod frame_history;
mod frame_in_plan;
mod frame_law;
mod frame_lean;
mod frame_model;
mod frame_motion;
mod frame_plan_record;
mod frame_plan_steps;
mod frame_record;
mod frame_rest;
mod frame_resultant;
mod frame_run;
mod frame_series;
mod frame_studies;
mod frame_tenon;
mod frame_tenon_events;
mod frame_work;
mod harmonic_map;
mod linear_system;
mod random_load;
mod random_vibration;
mod rocking_block;
mod rocking_run;

pub(crate) use building::{BaseDriven, ExponentialSteps, shaken};
pub use building::{
    BuildingHistory, BuildingPeaks, BuildingRun, DirectionalCombination, FloorPeak, Histories, HistoryMethod,
    LeastFavourable, ModalCombination, Peak, ResultantDrift, SpectralAnalysis, SpectralMode, StoreyPeak,
    TunedMass, VibratingBuilding, WatchedHistory, building_history, correlation_coefficient,
    spectral_analysis,
};
pub use chain_growth::{ChainGrowth, MeasuredGrowth, chain_growth};
pub use chain_history::{
    ChainEnergy, ChainHistory, ChainOutcome, ChainPeak, ChainSlip, ChainSupportPeak, ChainTouch, ChainUplift,
};
pub use chain_model::{ChainJoint, ChainModel, JointFriction, JointOpening};
pub use chain_motion::simulate_chain;
pub use chain_rest::chain_at_rest;
pub use chain_rigid::{ChainRigidJoint, lowest_turning_joint};
pub use chain_rotations::ChainRotations;
pub use chain_run::ChainRun;
pub use chain_studies::chain_harmonic_map;
pub use column_run::{ColumnDashpots, ColumnEnergy, ColumnHistory, ColumnOutcome, ColumnRun};
pub use columns_on_beds::rock_on_beds;
pub use error::DynamicsError;
pub use excitation::{FrameLoad, TimeFunction};
pub use frame_friction::{
    FrictionActsOn, FrictionFrame, Sliders, StoreyFriction, ViscousDamping, slip_forces_n,
};
pub use frame_history::{FrameEnergy, FrameHistory, FrameOutcome, FramePeak, Slip, Turn};
pub use frame_in_plan::{FrameInPlan, SharedFriction, simulate_frame_in_plan, storeys_that_rub_both_ways};
pub use frame_lean::FrameLeaning;
pub use frame_motion::simulate_frame;
pub use frame_resultant::{FrameResultant, resultant_drifts};
pub use frame_run::FrameRun;
pub use frame_studies::{
    AtAmplitude, HarmonicStart, amplitude_dependence, harmonic_map, harmonic_map_of_leaning,
};
pub use frame_tenon::{Tenon, TenonFace};
pub use harmonic_map::HarmonicPoint;
pub use linear_system::{LinearSystem, Pole, SystemModes};
pub use random_load::{RandomInput, RandomLoad, SpectralMatrix, Spectrum};
pub use random_vibration::{
    FrequencyIntegral, Motion, ResponseRow, rms_by_integral, rms_by_lyapunov, rms_by_spectral_matrix,
};
pub use rocking_block::{
    Rocking, RockingBlock, RockingEquation, RockingHistory, RockingImpact, RockingOutcome,
};
pub use rocking_run::rock_block;
