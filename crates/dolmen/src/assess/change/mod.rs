//! Changes between two surveys of one structure.

mod difference;
mod directions;
mod history;
mod mode_change;
mod notes;
mod slips;
mod surveys;
mod swapped;
mod temperature;
mod which_part;

pub use difference::{Difference, Evidence};
pub use directions::ExchangedDirections;
pub use history::HistoryEffect;
pub use mode_change::{ModeChange, NotCompared, SurveyChange, TemperatureKnowledge};
pub use notes::ChangeNote;
pub use surveys::{SurveyChangeOptions, Surveyed, survey_change};
pub use swapped::{SwappedChannels, TurnedChannel};
pub use temperature::{FittedTemperature, TEMPERATURE_SURVEYS_LEAST, TemperatureEffect};
pub use which_part::{FACTOR_SOUGHT, FrequencyChange, PartFit, WhichPart, which_part};
