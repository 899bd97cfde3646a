//! Surveys: measurements and their records.

mod as_surveyed;
mod doubts;
mod file;
mod inspection;
mod limit_slips;
mod part;
mod read;
mod read_conditioning;
mod read_inspections;
mod read_logs;
mod read_records;
mod read_watch;
mod records;
mod watch;
mod watch_file;

pub(crate) use as_surveyed::as_surveyed;
pub(crate) use doubts::doubt_surveys;
pub(crate) use file::{ChangeRaw, SurveyRaw};
pub use inspection::{DamageKind, Inspection, OtherDamage, Severity};
pub use part::{ChangePart, EarthquakePart, Merge, ModeKind, Survey, SurveyMode, TemperaturePart, Tilt};
pub(crate) use read::{add_inspections, change, surveys};
pub(crate) use read_watch::watch;
pub use records::{
    BandPass, ChannelSource, Column, Conditioning, Cut, LowPass, ModalChoice, RecordFormat, RecordSource,
};
pub use watch::{LogKind, LogPart, WatchPart, WorkKind, WorkPart, date_of};
pub(crate) use watch_file::WatchRaw;
