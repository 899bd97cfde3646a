//! Ground motions: requested, prepared, measured, matched, made.

mod acting;
mod answer;
mod demand;
mod doubt;
mod error;
mod measured;
mod measured_response;
mod of_survey;
mod prepare;
mod request;
mod sequence;
mod suite;
mod wanted_file;

pub use acting::{MotionAnswer, TakenOff, base_line_drifts};
pub use answer::{MatchAnswer, MotionReport, MotionSeries};
pub use demand::{Demand, RANGE_S, range_of_structure};
pub use doubt::MotionDoubt;
pub use error::MotionRequestError;
pub use measured::{MadeMotion, MotionOptions, MotionShape, motion};
pub use measured_response::{MeasuredChannel, MeasuredResponse};
pub use prepare::is_built_in_motion;
pub(crate) use prepare::prepared;
pub use request::{GivenFile, MotionRequest};
pub(crate) use sequence::{in_sequence, refuse_other_components};
pub use suite::{NotTaken, SuiteAnswer, SuiteMember, SuiteOptions, suite};
