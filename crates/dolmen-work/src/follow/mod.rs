//! Records of a watched folder: their time, the survey from each, and its place in the history.

mod alarms;
mod taken;
mod verdict;
mod when;

pub use alarms::{AlarmSort, OpenAlarm, open_alarms};
pub use taken::{Pattern, RecordFile, Taken, TakenSurvey};
pub use verdict::{Verdict, sensor_change, verdict};
pub use when::{RecordTime, TimeSource, moment_of, record_time};
