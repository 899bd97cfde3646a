//! What changed between two surveys of one structure.

mod difference;
mod notes;
mod surveys;
mod swapped;
mod temperature;

pub use difference::{Difference, Evidence};
pub use notes::ChangeNote;
pub use surveys::{
    ModeChange, NotCompared, SurveyChange, SurveyChangeOptions, Surveyed, TemperatureKnowledge, survey_change,
};
pub use swapped::{SwappedChannels, TurnedChannel};
pub use temperature::{FittedTemperature, TEMPERATURE_SURVEYS_LEAST, TemperatureEffect};
