//! Project files: one TOML per structure, with its surveys, variants and the source of each number.

mod bounds;
mod buildable;
mod building;
mod chain;
mod check;
mod combine;
mod content;
mod damage;
mod date_slips;
mod direction_slips;
mod direction_vector;
mod doubted;
mod doubts;
mod error;
mod exact;
mod file;
mod file_names;
mod file_number;
mod file_way;
mod foreign;
mod frame;
mod heaviness;
mod identified;
mod inspected;
mod leaves;
mod length_slips;
mod limits;
mod loads;
mod measure;
mod merge;
mod named_order;
mod names;
mod needed;
mod paths;
mod placed;
mod printed;
mod quantity;
mod ratio;
mod read;
mod reader;
mod report;
mod safe_text;
mod schema;
mod schema_tree;
mod sensor_slips;
mod site;
mod slips;
mod soil;
mod sought;
mod stack;
mod study;
mod survey;
mod survey_heads;
mod survey_like;
mod syntax;
mod syntax_slips;
mod tabled;
mod tabled_heads;
mod tabled_modes;
mod tabled_surveys;
mod totals;
mod type_words;
mod unchecked;
mod unit_help;
mod units;
mod unknown_variants;
mod unread_columns;
mod usual;
mod usual_numbers;
mod warned;
mod write_back;
mod written;
mod written_at;
mod wrong;

pub use building::{
    BuildingPart, BuiltDamper, DamperBody, DamperFault, DamperFrequency, DamperMass, DamperPart, DampingPart,
    FloorPart, GyrationPart, MassPart, MovingPart, StoreyStiffnessPart, Stroke, TunedTo, WallPart,
    WatchedPart, strokes_of,
};
pub use chain::{
    Cap, ChainAxis, ChainLean, ChainPart, ChainSupportPart, JointFrictionPart, JointPart, LinkPart,
    StonePart, tilt_of_axes,
};
pub use combine::{canonical_text, parse_combination};
pub use content::{EarlierModel, Project, Structure, Variant, Warning, WarningKind};
pub use damage::{InModel, ModelDamage, Side};
pub use dolmen_records::{FileError, Files, MemoryFiles, NoFiles};
pub use doubted::Doubted;
pub use doubts::{likely, looks_like_radians};
pub use error::{Problem, ProjectError, headed};
pub use frame::{
    Axial, ColumnsPart, DirectionPart, FootPart, FrameLean, FramePart, FrictionPart, SlipForces, StoreyPart,
    TenonsPart,
};
pub use heaviness::Heaviness;
pub use leaves::{Leaf, is_key, meaning_of};
pub use loads::{
    CombinationPart, LoadPart, LoadsPart, WIND_ECCENTRICITY, WindArea, WindGiven, WindInTime, WindPart,
    WindSpeed,
};
pub use names::Names;
pub use quantity::{Evidence, Pick, Quantity};
pub use read::{parse_project, parse_project_with};
pub use report::{
    Author, Grade, GradeScale, Location, MaterialMethod, MaterialTest, PeriodicGrade, PhotoPart, ReportPart,
    SensorPart, calendar_day, is_day,
};
pub use safe_text::texts;
pub use schema::json_schema;
pub use site::{HazardPart, HazardSource, MotionPart, MotionSize, MotionSource, Place, SitePart};
pub use soil::{FootingPart, SoilBelowPart, SoilPart};
pub use sought::{FromSurvey, FromSurveys, Sought, WhyNotIdentified};
pub use stack::{
    ArchPart, BedPart, BlockPart, BondPart, ContactPart, CornicePart, DomePart, DomePiecePart, JointDefaults,
    LoosenedBedPart, LostBedPart, MadePart, MastPart, MeshPart, OpeningPart, PagodaPart,
    PagodaSlendernessPart, PointsFrame, ShapePart, SideSupportPart, StackFault, StackPart, StoneWallPart,
    SupportMovementPart, SurveyedLean, TiePart, TopPart, TowerPart, TowerPlanPart, TrilithonPart, VaultPart,
    WallOpeningPart,
};
pub use study::{
    AfterPart, ArtificialPart, Axis, DRIFT_LIMITS, ExpectedTrend, HarmonicPart, LawPart, Override, Scan,
    StudyPart,
};
pub use survey::{
    BandPass, ChangePart, ChannelSource, Column, Conditioning, Cut, DamageKind, EarthquakePart, Inspection,
    LogKind, LogPart, LowPass, Merge, ModalChoice, ModeKind, OtherDamage, RecordFormat, RecordSource,
    Severity, Survey, SurveyMode, TemperaturePart, Tilt, WatchPart, WorkKind, WorkPart, date_of,
};
pub use survey_like::{LikeSurvey, survey_like};
pub use unchecked::StiffnessFit;
pub use units::{AngleError, parse_angle_rad};
pub use warned::Warned;
pub use write_back::{IdentifiedNumber, NewValue, with_values, with_values_on_their_lines};
pub use wrong::ERRORS;
