//! The verbs of Dolmen as functions of values. Opens no file, prints nothing.
//!
//! ```text
//! Opened (project, text) ─ kinds ─→ check · identify · compare · simulate · study · tune · score · rank · report
//! ```
//!
//! Files that a project names come through [`Files`](dolmen_records::Files); progress goes through [`Progress`], and the runs of a study to a
//! [`Journal`](study::Journal).

mod air;
pub mod answer;
mod asked_modes;
mod at_rest;
pub mod beside_file;
pub mod building;
pub mod chain;
mod change_fault;
pub mod changed_part;
#[cfg(test)]
mod changed_part_cases;
mod check;
pub mod compare;
pub mod compared_history;
pub mod compared_readings;
mod days;
mod demand;
mod doubted;
mod error;
pub mod events_between;
pub mod felt;
mod fingerprint;
pub mod flags;
pub mod follow;
pub mod frame;
mod from_surveys;
mod held_beside_file;
mod history_behind;
mod identify;
mod in_runs;
pub mod inspected;
pub mod inventory;
pub mod judgement;
pub mod kept;
mod kinds;
mod known;
pub mod last_off;
mod left_out;
pub mod loads;
pub mod logs;
mod loosened;
mod lowest_of_records;
pub mod mode_heights;
pub mod model_modes;
mod modes_of_survey;
mod more_modes;
pub mod motion;
mod opened;
pub mod part_limit;
mod photos;
pub mod portfolio;
mod progress;
mod rate_slip;
mod record;
pub mod record_seen;
mod report;
mod same_record;
pub mod scanned;
mod scattered_inputs;
pub mod score;
pub mod sensor_alarms;
pub mod sensors;
mod simulate;
pub mod simulation;
mod solutions;
pub mod stack;
pub mod state;
mod station_clocks;
mod stiffness;
pub mod study;
mod survey_dates;
mod survey_direction;
mod survey_doubts;
pub mod surveyed;
mod tilt_left_out;
mod told;
mod undamped;
mod unreadable_motions;
mod used_record;
mod validate;
mod version;
pub mod watch;
pub mod watched;
pub mod watched_log;
mod write_back;
mod wrong;
pub mod years_parts;

pub use change_fault::ChangeFault;
pub use check::{CheckOptions, Sampling, check};
pub use error::{Within, WorkError};
pub use flags::{FlagVerb, ForeignFlag, Kind};
pub use from_surveys::with_stiffness_of_surveys;
pub use identify::{IdentifyOptions, SurveyModes, identify, survey_modes};
pub use opened::Opened;
pub use photos::Photos;
pub use progress::{Progress, Silent, Stage};
pub use report::{ReportOptions, report};
pub use simulate::{PreparedSimulation, SimulateOptions, WindAsked, evidence_of, is_loose, prepare, settle};
pub use solutions::{SolvedSimulations, simulate_solutions};
pub use station_clocks::ClockDoubt;
pub use survey_dates::{date as survey_date, date_text, day_of_a_record};
pub use tilt_left_out::TiltLeftOut;
pub use told::{Sayable, complaint, did_not_converge, told, told_both, told_by, told_in};
pub use undamped::{IdentifiedDamping, Undamped};
pub use unreadable_motions::unreadable_motions;
pub use used_record::{UsedRecord, WhichRecord, used_record};
pub use validate::validate;
pub use write_back::{WrittenBack, can_be_written, would_be_unchecked, write_back};
pub use wrong::ERRORS;
