//! One judgement: the fixed words and colours of every verdict, and the exit status, in one place.

mod as_of;
mod basis;
mod colour;
mod earthquake;
mod evidence;
mod exit;
mod grown_damage;
mod held_against;
mod in_doubt;
mod judge;
mod measured_frequency;
mod mode_pairs;
mod modes_along;
mod runs;
mod said;
mod severe_damage;
mod tilt_limit;
mod version;
mod weight;
mod wind;

pub use basis::{AssumedInputs, Basis};
pub use colour::Colour;
pub use earthquake::{DecidedBy, Earthquake, EarthquakeFinding};
pub use evidence::{Evidence, lowest_measured};
pub use exit::{Verb, exit_status, first_status};
pub use grown_damage::{GrownDamage, Growth};
pub(crate) use held_against::superseded_by;
pub use held_against::{first_sway, latest_frequencies, measured_frequencies, missed_modes};
pub(crate) use in_doubt::SurveyDoubts;
pub use in_doubt::{InDoubt, MissedMode, OtherStiffness, PairedMode, Unexplained};
pub use judge::{
    Alarming, ChangedSince, Judgement, judge, judge_check, judge_run, judge_simulation, judge_stack_run,
};
pub(crate) use measured_frequency::contradict;
pub use measured_frequency::{FrequencyAndDeviation, MeasuredFrequency, RecordFrequency};
pub(crate) use runs::is_worse_stack_run;
pub use said::SAID;
pub use severe_damage::SevereDamage;
pub(crate) use tilt_limit::is_tilt_beyond;
pub use tilt_limit::{TiltAgainstLimit, drift_left, last_tilt, tilt_against_limit, tilt_beyond_limit};
pub(crate) use version::governing;
pub use version::{AfterMotion, Leaning, Solution, VersionJudgement};
pub use weight::Weight;
pub use wind::{MovedBy, WindFinding, WindLimit, WindWord};
