//! The six-factor score: simulated designs as a table, and the score of a pagoda.

mod answer;
mod designs;
mod designs_error;
mod given;
mod softer;
mod verb;

pub use answer::{ScoreAnswer, ScoreQuality, StateScore, unlike_words};
pub use designs::{SCORE_STATES, ScoreDesign, ScoreDesigns};
pub use designs_error::ScoreDesignsError;
pub use given::{GIVEN_PEAKS_G, GivenAnswer, GivenFrequency, GivenState, MODEL_LN_SD, score_given};
pub(crate) use verb::{check_alike, factors};
pub use verb::{score, score_quality};
