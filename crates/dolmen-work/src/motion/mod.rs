//! Ground motions: asked for, prepared, measured, matched, made.

mod acting;
mod answer;
mod doubt;
mod error;
mod measured;
mod prepare;
mod request;

pub use acting::{MotionAnswer, base_line_drifts};
pub use answer::{MatchAnswer, MotionReport, MotionSeries};
pub use doubt::MotionDoubt;
pub use error::MotionRequestError;
pub use measured::{Demand, MadeMotion, MotionOptions, MotionShape, motion};
pub(crate) use prepare::prepared;
pub use request::{GivenFile, MotionRequest};
