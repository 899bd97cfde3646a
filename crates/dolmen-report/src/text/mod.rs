//! Answers as text for a terminal: plain characters, aligned columns, units in the headings.

mod change;
mod grown;
mod project_line;
mod simulation;
mod study;
mod study_state;
mod table;
mod validate;
mod watch;

pub use crate::building_simulation::building_simulation_text;
pub use crate::chain::chain_simulation_text;
pub use crate::document::TextStyle;
pub use crate::frame_simulation::frame_simulations_text;
pub use crate::stack_simulation::{settled_text, simulation_text, supports_text};
pub use crate::tune::{together_text, tune_text};
pub use crate::wind_simulation::wind_simulation_text;
pub use change::change_text;
pub(crate) use grown::GROWN;
pub(crate) use project_line::TEMPLATES as PROJECT_LINE;
pub use project_line::project_line;
pub(crate) use simulation::TEMPLATES as SIMULATION_INPUTS;
pub use simulation::simulation_inputs_text;
pub use study::study_text;
pub use study_state::{missing_text, shard_text};
pub use table::Table;
pub use validate::validation_text;
pub use watch::watch_text;
