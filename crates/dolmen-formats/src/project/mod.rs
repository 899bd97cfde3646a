//! Project files: one TOML a structure, with its surveys, variants and the evidence of each number.

mod chain;
mod content;
mod error;
mod frame;
mod quantity;
mod read;
mod records;
mod survey;

pub use chain::{Cap, ChainPart, Heaviness, JointPart, LinkPart};
pub use content::{Names, Project, Structure, Variant, Warning, WarningKind};
pub use error::{Problem, ProjectError};
pub use frame::{Axial, DirectionPart, FramePart, StoreyPart};
pub use quantity::{Evidence, Pick, Quantity};
pub use read::parse_project;
pub use records::{
    BandPass, ChannelSource, Column, Conditioning, Cut, LowPass, ModalChoice, RecordFormat, RecordSource,
};
pub use survey::{ModeKind, Survey, SurveyMode, Tilt};
