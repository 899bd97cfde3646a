//! Answers as text for a terminal: plain characters, columns that line up, units in the heads.

mod building;
mod building_simulation;
mod chain_simulation;
mod check;
mod demand;
mod fragility;
mod frame_simulation;
mod identify;
mod motion;
mod project;
mod rank;
mod score;
mod simulation;
mod stack;
mod study;
mod table;
mod tune;
mod validate;
mod versions;

pub(crate) use building_simulation::GROWN;
pub use building_simulation::{building_outcome_text, building_simulation_text};
pub use chain_simulation::{chain_outcome_text, chain_simulation_text};
pub use check::check_text;
pub(crate) use demand::{STANDARD_GRAVITY_M_S2, ground_word, type_word};
pub use frame_simulation::{frame_outcome_text, frame_simulation_text, friction_words};
pub use identify::identification_text;
pub use motion::motion_report_text;
pub use project::{heading_text, warnings_text};
pub use rank::rank_text;
pub use score::{score_quality_text, score_text};
pub use simulation::{outcome_text, points_a_side, simulation_inputs_text, simulation_text};
pub use study::study_text;
pub use table::Table;
pub use tune::{choice_words, findings, goal_words, together_text, together_words, tune_text};
pub use validate::validation_text;
