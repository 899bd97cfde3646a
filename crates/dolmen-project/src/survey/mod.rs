//! Surveys: what was measured, and the records of it.

mod doubts;
mod file;
mod part;
mod read;
mod read_conditioning;
mod read_records;
mod records;

pub(crate) use doubts::doubt_surveys;
pub(crate) use file::{ChangeRaw, SurveyRaw};
pub use part::{ChangePart, Merge, ModeKind, Survey, SurveyMode, TemperaturePart, Tilt};
pub(crate) use read::{change, surveys};
pub use records::{
    BandPass, ChannelSource, Column, Conditioning, Cut, LowPass, ModalChoice, RecordFormat, RecordSource,
};
