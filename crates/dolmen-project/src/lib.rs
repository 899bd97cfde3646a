//! Project files: one TOML a structure, with its surveys, variants and the evidence of each number.

mod building;
mod building_damper;
mod built_damper;
mod chain;
mod check;
mod combine;
mod content;
mod error;
mod file;
mod file_building;
mod file_number;
mod file_site;
mod file_stack;
mod file_study;
mod file_survey;
mod foreign;
mod frame;
mod measure;
mod merge;
mod quantity;
mod read;
mod read_block;
mod read_building;
mod read_conditioning;
mod read_damper;
mod read_friction;
mod read_motion;
mod read_pagoda;
mod read_records;
mod read_shape;
mod read_site;
mod read_stack;
mod read_structure;
mod read_study;
mod read_study_values;
mod read_survey;
mod reader;
mod records;
mod schema;
mod schema_tree;
mod site;
mod slips;
mod slips_building;
mod slips_chain;
mod slips_damper;
mod slips_frame;
mod slips_stack;
mod stack;
mod stack_build;
mod study;
mod survey;
mod units;
mod written;

pub use building::{
    BuildingPart, DampingPart, FloorPart, GyrationPart, StoreyStiffnessPart, WallPart, WatchedPart,
};
pub use building_damper::{
    DamperBody, DamperFault, DamperFrequency, DamperMass, DamperPart, MassPart, MovingPart,
};
pub use built_damper::{BuiltDamper, Stroke, TunedTo, strokes_of};
pub use chain::{Cap, ChainPart, Heaviness, JointFrictionPart, JointPart, LinkPart};
pub use combine::{canonical_text, parse_combination};
pub use content::{Names, Project, Structure, Variant, Warning, WarningKind};
pub use dolmen_records::{FileError, Files, MemoryFiles, NoFiles};
pub use error::{Problem, ProjectError};
pub use frame::{Axial, DirectionPart, FramePart, FrictionPart, SlipForces, StoreyPart};
pub use quantity::{Evidence, Pick, Quantity};
pub use read::{parse_project, parse_project_with};
pub use records::{
    BandPass, ChannelSource, Column, Conditioning, Cut, LowPass, ModalChoice, RecordFormat, RecordSource,
};
pub use schema::json_schema;
pub use site::{HazardPart, HazardSource, MotionPart, MotionSize, MotionSource, SitePart};
pub use stack::{
    BedPart, BlockPart, ContactPart, MeshPart, OpeningPart, PagodaPart, PagodaSlendernessPart, PointsFrame,
    ShapePart, SideSupportPart, StackPart, TiePart, TopPart,
};
pub use stack_build::StackFault;
pub use study::{
    ArtificialPart, Axis, DRIFT_LIMITS, ExpectedTrend, HarmonicPart, LawPart, Override, Scan, StudyPart,
};
pub use survey::{ChangePart, Merge, ModeKind, Survey, SurveyMode, TemperaturePart, Tilt};
pub use units::{AngleError, parse_angle_rad};
