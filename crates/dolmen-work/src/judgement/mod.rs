//! One judgement: the fixed words and colours of every verdict, and the exit status, in one place.

mod colour;
mod earthquake;
mod evidence;
mod exit;
mod judge;
mod runs;
mod weight;
mod wind;

pub use colour::Colour;
pub use earthquake::{DecidedBy, Earthquake, EarthquakeFinding};
pub use evidence::{Evidence, MeasuredFrequency, first_sway, lowest_measured, measured_frequencies};
pub use exit::{Verb, exit_status, first_status};
pub use judge::{
    AssumedInputs, Judgement, VersionJudgement, judge, judge_building_run, judge_chain_run, judge_check,
    judge_frame_run, judge_simulation, judge_stack_run, judge_stack_runs,
};
pub(crate) use runs::is_worse_stack_run;
pub use weight::Weight;
pub use wind::{WindFinding, WindLimit, WindWord};
