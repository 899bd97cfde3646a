//! Structures in time: exact between events, with the events located.

mod error;
mod excitation;
mod frame_events;
mod frame_friction;
mod frame_history;
mod frame_law;
mod frame_motion;
mod frame_record;
mod frame_series;
mod frame_studies;

pub use error::DynamicsError;
pub use excitation::{FrameLoad, TimeFunction};
pub use frame_friction::{
    FrictionActsOn, FrictionFrame, Sliders, StoreyFriction, ViscousDamping, slip_forces_n,
};
pub use frame_history::{FrameEnergy, FrameHistory, FrameOutcome, FramePeak, Slip, Turn};
pub use frame_motion::{FrameRun, simulate_frame};
pub use frame_studies::{AtAmplitude, HarmonicPoint, amplitude_dependence, harmonic_map};
