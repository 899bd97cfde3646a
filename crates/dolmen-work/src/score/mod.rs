//! The six-factor score: simulated designs as a table, and the score of a pagoda.

mod answer;
mod designs;
mod designs_error;
mod verb;

pub use answer::{ScoreAnswer, ScoreQuality, StateScore, unlike_words};
pub use designs::{SCORE_STATES, ScoreDesign, ScoreDesigns};
pub use designs_error::ScoreDesignsError;
pub(crate) use verb::{check_alike, factors};
pub use verb::{score, score_quality};
