//! Stacks in motion: blocks that rock, slide, twist and jump on contact springs.

mod assembly;
mod block_skyline;
mod bodies;
mod calibrate;
mod contact_points;
mod ensemble;
mod error;
mod faces;
mod frequencies;
mod history;
mod hulls;
mod links;
mod matrices;
mod observe;
mod outline;
mod patch;
mod rest;
mod rigid;
mod rigid_faces;
mod rigid_rest;
mod rigid_run;
mod rigid_solve;
mod springs;
mod standing;
mod support;

pub use calibrate::{MatchedFrequency, SpringCalibration, calibrate_springs};
pub use contact_points::{ContactPoint, ContactRule, contact_points};
pub use ensemble::{StackRun, simulate_springs_many};
pub use error::BlocksError;
pub use frequencies::{StackMode, first_sway, stack_modes};
pub use history::{Energy, JointHistory, Outcome, Pose, RigidEvidence, StackHistory};
pub use rigid::{Rigid, simulate_rigid};
pub use springs::{AfterFall, Springs, Start, simulate_springs};
