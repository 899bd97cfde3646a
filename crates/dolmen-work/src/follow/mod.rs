//! Records of a structure as they come: when each was taken, the survey that is made of it, and what the history says of it.

mod alarms;
mod taken;
mod verdict;
mod when;

pub use alarms::{AlarmSort, OpenAlarm, open_alarms};
pub use taken::{Pattern, RecordFile, Taken, TakenSurvey};
pub use verdict::{Verdict, sensor_change, verdict};
pub use when::{RecordTime, TimeSource, moment_of, record_time};
