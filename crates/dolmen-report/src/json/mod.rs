//! Answers as JSON: keys are the fields' names with the unit last, values in SI, `null` for what is not known.

mod building;
mod chain_simulation;
mod change;
mod check;
mod demand;
mod fragility;
mod frame_simulation;
mod identify;
mod judgement;
mod loads;
mod local_mechanisms;
mod motion;
mod rank;
mod score;
mod simulation;
mod stack;
mod study;
mod study_state;
mod tune;
mod watch;
mod with;

pub use building::building_simulation_json;
pub use chain_simulation::chain_simulation_json;
pub use change::change_json;
pub use check::check_json;
pub use frame_simulation::frame_simulation_json;
pub use identify::identification_json;
pub use motion::motion_report_json;
pub use rank::rank_json;
pub use score::{score_json, score_quality_json};
pub use simulation::{simulation_json, stack_runs_json};
pub use study::study_json;
pub use study_state::{missing_json, shard_json};
pub use tune::{together_json, tune_json};
pub use watch::watch_json;
