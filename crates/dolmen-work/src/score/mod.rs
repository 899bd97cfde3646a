//! The six-factor score: simulated designs as a table, and what the score says of a pagoda.

mod answer;
mod designs;

pub use answer::{ScoreAnswer, ScoreQuality, StateScore, unlike_words};
pub use designs::{SCORE_STATES, ScoreDesign, ScoreDesigns, ScoreDesignsError};
