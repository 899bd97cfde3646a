//! Errors of the verbs.

use crate::change_fault::ChangeFault;
use crate::motion::MotionRequestError;
use crate::portfolio::PortfolioError;
use crate::scanned::ScanError;
use crate::score::ScoreDesignsError;
use crate::sensors::SensorsError;
use crate::study::{JournalError, StudyError};
use dolmen::assess::AssessError;
use dolmen::blocks::BlocksError;
use dolmen::comparisons::ValidationError;
use dolmen::damper::DamperError;
use dolmen::dynamics::DynamicsError;
use dolmen::modal::ModalError;
use dolmen::numeric::NumericError;
use dolmen::signal::SignalError;
use dolmen::stability::StabilityError;
use dolmen::structure::StructureError;
use dolmen::structure::building::BuildingError;
use dolmen::structure::stack::StackError;
use dolmen_project::{AngleError, DamperFault, ProjectError, StackFault};
use dolmen_records::motions::MotionError;
use dolmen_records::records::RecordError;
use dolmen_records::{FileError, LogError, PhotoError};
use dolmen_words::message::Both;
use std::error::Error;

/// Why a verb fails: an error of the library, the readers or the project file, with its place, or a refused request.
#[derive(Debug)]
pub enum WorkError {
    /// Where the cause lies: a file, a survey, an option.
    Within {
        /// The place.
        place: Both,
        /// The underlying error.
        cause: Box<WorkError>,
    },
    /// A file cannot be read.
    File(Box<FileError>),
    /// The project file is refused.
    Project(Box<ProjectError>),
    /// A record is refused.
    Record(Box<RecordError>),
    /// A file of a ground motion is refused.
    Motion(Box<MotionError>),
    /// A photograph is refused.
    Photo(Box<PhotoError>),
    /// A file of a logger is refused.
    Log(Box<LogError>),
    /// The unit in the file of a logger differs from that in the project.
    LogUnit {
        /// The unit in the file of the logger.
        stated: String,
        /// The unit in the project.
        unit: String,
    },
    /// No survey determines the stiffness that the file could hold.
    NothingToWrite,
    /// The springs of a stack are not written by the program.
    SpringsToType {
        /// The survey.
        survey: String,
        /// The factor on all springs that fits its modes.
        factor: String,
        /// Keys and values to type if all joints are alike, otherwise only the keys.
        keys: String,
    },
    /// Several surveys determine the stiffness.
    SeveralToWrite {
        /// Their names.
        surveys: Vec<String>,
    },
    /// The value is in a table, not in the project file.
    NotInTheFile {
        /// Its path.
        path: String,
    },
    /// The photographs of a report are too large together.
    TooManyPhotos {
        /// The limit, MiB.
        most: u64,
    },
    /// An angle is refused.
    Angle(Box<AngleError>),
    /// A stack cannot be built.
    StackPart(Box<StackFault>),
    /// A damper cannot be built.
    DamperPart(Box<DamperFault>),
    /// Surveys cannot be compared.
    Change(Box<ChangeFault>),
    /// A table of structures is refused.
    Portfolio(Box<PortfolioError>),
    /// A table of designs is refused.
    Designs(Box<ScoreDesignsError>),
    /// A scan gives no stones.
    Scan(Box<ScanError>),
    /// Sensors cannot be planned.
    Sensors(Box<SensorsError>),
    /// A journal cannot be read.
    Journal(Box<JournalError>),
    /// From the library.
    Assess(Box<AssessError>),
    /// From the library.
    Blocks(Box<BlocksError>),
    /// From the library.
    Building(Box<BuildingError>),
    /// From the library.
    Damper(Box<DamperError>),
    /// From the library.
    Dynamics(Box<DynamicsError>),
    /// From the library.
    Modal(Box<ModalError>),
    /// From the library.
    Numeric(Box<NumericError>),
    /// From the library.
    Signal(Box<SignalError>),
    /// From the library.
    Stability(Box<StabilityError>),
    /// From the library.
    Stack(Box<StackError>),
    /// From the library.
    Structure(Box<StructureError>),
    /// From the library.
    Validation(Box<ValidationError>),
    /// A requested motion is not available.
    MotionRequest(Box<MotionRequestError>),
    /// A study cannot be run, or its runs cannot be used.
    Study(Box<StudyError>),
    /// The caller could not open, read or store something.
    Outside {
        /// Reason.
        why: Both,
    },

    /// Samples are requested for a stack.
    SamplesOfStack,
    /// The load factor of a sample is not a number.
    SampleNotANumber,
    /// An input cannot stay below another one, as it must, with the scatter of both.
    ScatterCrosses {
        /// Path of the smaller one.
        smaller: String,
        /// Its coefficient of variation.
        smaller_cov: f64,
        /// Path of the larger one.
        larger: String,
        /// Its coefficient of variation.
        larger_cov: f64,
    },
    /// There is no such variant.
    NoSuchVariant {
        /// The name.
        name: String,
        /// Names of the known ones.
        known: String,
    },
    /// There is no such survey.
    NoSuchSurvey {
        /// The name.
        name: String,
        /// Names of the known ones.
        known: String,
    },
    /// An input channel has a name that no channel has.
    NoSuchInput {
        /// The name.
        name: String,
        /// The channels.
        known: String,
    },
    /// A record was requested of a project without any.
    NoRecord,
    /// One record was requested, and none or several match.
    WhichRecord {
        /// Number of matching records.
        meant: usize,
        /// All records of the project.
        known: String,
    },
    /// The channel whose spectrogram is wanted has a name that no channel has.
    NoSuchSpectrogram {
        /// The name.
        name: String,
        /// The channels.
        known: String,
    },
    /// A reference channel has a name that no channel has.
    NoSuchReference {
        /// The name.
        name: String,
        /// The channels.
        known: String,
    },

    /// No survey of a project has its record in one file, as records of a watched folder need.
    NoneToFollow,

    /// A run that needs a motion was prepared without one.
    NoMotionPrepared,
    /// A motion along x and y for a structure that moves in a plane.
    TwoHorizontal {
        /// The kind of structure: "a chain".
        what: Both,
    },
    /// A motion along x and y for a frame with one direction.
    FrameOfOneDirection {
        /// The direction.
        direction: String,
    },
    /// A motion along x and y is given for a frame whose file does not name these directions.
    DirectionsNotAlong {
        /// Its directions.
        directions: String,
    },
    /// One direction of a frame was requested under a motion along x and y.
    DirectionOfBoth {
        /// The direction.
        direction: String,
    },
    /// A motion along x and y for a chain with friction, which couples both directions.
    OnePlaneFriction {
        /// The joint, from 1 at the bottom.
        joint: usize,
    },
    /// A motion along x and y for a chain with a bed that crushes, whose limit falls towards its corners.
    OnePlaneStrength {
        /// The joint, from 1 at the bottom.
        joint: usize,
    },
    /// A motion along x and y for a chain with an opening bed of unknown depth.
    OnePlaneNoDepth {
        /// The joint, from 1 at the bottom.
        joint: usize,
    },
    /// A purely vertical motion for a structure that moves in a plane.
    NoHorizontal {
        /// The kind of structure: "a chain".
        what: Both,
    },
    /// A motion of a study has no horizontal component.
    NoHorizontalOf {
        /// The motion.
        name: String,
    },

    /// A survey cannot be simulated.
    SurveySimulated,
    /// A motion was given for the report of a survey.
    SurveyReported {
        /// The project file.
        file: String,
    },
    /// A push on a structure that is not a chain.
    PushOfOther,
    /// The sliding model has no supports that move.
    SlidingOfSupports,
    /// The sliding model has no loose stones.
    SlidingOfLoose,
    /// No mode stands out of the spectrum of a record with single samples far from their neighbours.
    SpikesHideModes {
        /// The channel.
        channel: String,
        /// Number of these samples.
        count: usize,
        /// Time of the first one, s from the start.
        first_s: f64,
    },
    /// A variant of loose stones has placed ones.
    PlacedVariant {
        /// The variant.
        variant: String,
    },
    /// A chain is pushed too far.
    PushTooLarge {
        /// The push, rad.
        push_rad: f64,
        /// The largest allowed, rad.
        most_rad: f64,
    },
    /// Neither a motion nor a push is given.
    NothingMovesChain,
    /// The joints of a chain are unknown.
    JointsUnknown,
    /// The stiffness of a direction is unknown.
    DirectionUnknown {
        /// The direction.
        direction: String,
    },
    /// There is no such direction.
    NoSuchDirection {
        /// The name.
        direction: String,
        /// Names of the known ones.
        known: String,
    },
    /// The stiffness of no direction is known.
    NoDirectionKnown {
        /// The directions of the file.
        directions: String,
    },
    /// The building falls, so it cannot be simulated.
    BuildingFalls,
    /// Wind was requested, and the file gives none.
    NoWindGiven,
    /// Both wind and a motion of the ground were requested.
    WindAndMotion,
    /// A second motion without a first.
    ThenWithoutMotion,
    /// A duration for a run of two motions.
    ThenAndDuration,
    /// Two motions with different horizontal components, for a structure that moves in planes.
    ThenComponents {
        /// The first motion.
        first: String,
        /// The second.
        second: String,
    },
    /// A seed or repeats for a building without wind.
    NoWindAsked {
        /// The flag.
        flag: &'static str,
    },
    /// Histories of the wind are written at their own steps.
    OutputStepOfWind,
    /// The step of wind histories is too long for the resonance.
    WindStepTooLong {
        /// The given step, s.
        step_s: f64,
        /// Longest allowed step, s.
        most_s: f64,
        /// The frequency of a mode that this step cannot resolve, Hz.
        mode_hz: f64,
    },
    /// A point of a building is missing.
    PointNotWatched,

    /// The inputs of a case are refused.
    CaseRefused {
        /// Reason.
        why: Both,
    },

    /// There is no such damper that can be tuned.
    NoSuchDamper {
        /// The name.
        name: String,
        /// The project file.
        file: String,
    },
    /// There is no damper.
    NoDamper {
        /// The project file.
        file: String,
    },
    /// Dampers were requested for a structure that is not a building.
    TuneOfOther,
    /// Wind was requested as the load, and the file gives none.
    TuneWithoutWind,
    /// The building falls under its own weight.
    BuildingFallsItself,
    /// A damper is tuned to no mode.
    TunedToNoMode,
    /// A floor has no outline.
    FloorWithoutOutline {
        /// The floor, from 1.
        floor: usize,
    },
    /// Floors were requested that the building does not have.
    NoSuchFloors {
        /// The lowest one requested, from 1.
        from: usize,
        /// The highest one.
        to: usize,
        /// Number of floors of the building.
        count: usize,
    },

    /// The score does not apply to such a pagoda.
    PagodaUnlike {
        /// The difference.
        how: Both,
    },
    /// A project without a pagoda for the six-factor score.
    NoPagoda {
        /// The project file.
        file: String,
    },
    /// A survey without a measured sway frequency, which the score needs.
    SurveyTellsNoFrequency {
        /// The survey.
        survey: String,
    },
    /// A measured frequency that needs joints beyond those of the designs.
    FrequencyBeyondDesigns {
        /// Measured frequency, Hz.
        measured_hz: f64,
        /// Lowest allowed frequency, Hz.
        least_hz: f64,
        /// Highest allowed frequency, Hz.
        most_hz: f64,
    },
    /// Too few draws of the stiffness come near the measured frequency.
    TooFewDrawsNear {
        /// Effective number.
        effective: f64,
        /// Smallest number.
        least: usize,
    },
    /// Too few designs for a score.
    TooFewDesigns {
        /// Number of designs.
        designs: usize,
    },
    /// Too few designs for the score of the state of the ranking.
    TooFewDesignsOfState,
    /// No structure can be ranked.
    NoneRanked {
        /// Number of structures.
        structures: usize,
        /// Reasons, one line per structure.
        reasons: Both,
    },
    /// A project without anything to rank it by.
    SurveyToRank,
    /// A project without a study or a score.
    NoStudyToRankBy {
        /// Its file.
        file: String,
    },
    /// Neither results nor a score.
    NothingToRankBy {
        /// The project file.
        file: String,
    },
    /// The project of Palisaden has no record, or none with a mode.
    PalisadenWithoutRecord,
}

/// Passes on an error of another crate.
macro_rules! handed_on {
    ($($variant:ident: $error:ty),+ $(,)?) => {
        $(impl From<$error> for WorkError {
            fn from(why: $error) -> Self {
                WorkError::$variant(Box::new(why))
            }
        })+
    };
}

handed_on! {
    MotionRequest: MotionRequestError,
    Study: StudyError,
    File: FileError,
    Project: ProjectError,
    Record: RecordError,
    Motion: MotionError,
    Photo: PhotoError,
    Log: LogError,
    Angle: AngleError,
    StackPart: StackFault,
    DamperPart: DamperFault,
    Change: ChangeFault,
    Portfolio: PortfolioError,
    Designs: ScoreDesignsError,
    Scan: ScanError,
    Sensors: SensorsError,
    Journal: JournalError,
    Assess: AssessError,
    Blocks: BlocksError,
    Building: BuildingError,
    Damper: DamperError,
    Dynamics: DynamicsError,
    Modal: ModalError,
    Numeric: NumericError,
    Signal: SignalError,
    Stability: StabilityError,
    Stack: StackError,
    Structure: StructureError,
    Validation: ValidationError,
}

impl WorkError {
    /// The error that was passed on; `None` for one of this crate.
    pub(crate) fn handed_on(&self) -> Option<&(dyn Error + 'static)> {
        Some(match self {
            WorkError::MotionRequest(why) => why.as_ref(),
            WorkError::Study(why) => why.as_ref(),
            WorkError::Scan(why) => why.as_ref(),
            WorkError::Sensors(why) => why.as_ref(),
            WorkError::File(why) => why.as_ref(),
            WorkError::Project(why) => why.as_ref(),
            WorkError::Record(why) => why.as_ref(),
            WorkError::Motion(why) => why.as_ref(),
            WorkError::Photo(why) => why.as_ref(),
            WorkError::Log(why) => why.as_ref(),
            WorkError::Angle(why) => why.as_ref(),
            WorkError::StackPart(why) => why.as_ref(),
            WorkError::DamperPart(why) => why.as_ref(),
            WorkError::Change(why) => why.as_ref(),
            WorkError::Portfolio(why) => why.as_ref(),
            WorkError::Designs(why) => why.as_ref(),
            WorkError::Journal(why) => why.as_ref(),
            WorkError::Assess(why) => why.as_ref(),
            WorkError::Blocks(why) => why.as_ref(),
            WorkError::Building(why) => why.as_ref(),
            WorkError::Damper(why) => why.as_ref(),
            WorkError::Dynamics(why) => why.as_ref(),
            WorkError::Modal(why) => why.as_ref(),
            WorkError::Numeric(why) => why.as_ref(),
            WorkError::Signal(why) => why.as_ref(),
            WorkError::Stability(why) => why.as_ref(),
            WorkError::Stack(why) => why.as_ref(),
            WorkError::Structure(why) => why.as_ref(),
            WorkError::Validation(why) => why.as_ref(),
            _ => return None,
        })
    }
}

/// Says where a fault lies.
pub trait Within<T> {
    /// Adds the place to the error.
    ///
    /// # Errors
    /// That of `self`, within the place.
    fn within<P: Into<Both>>(self, place: impl FnOnce() -> P) -> Result<T, WorkError>;
}

impl<T, E: Into<WorkError>> Within<T> for Result<T, E> {
    fn within<P: Into<Both>>(self, place: impl FnOnce() -> P) -> Result<T, WorkError> {
        self.map_err(|cause| WorkError::Within {
            place: place().into(),
            cause: Box::new(cause.into()),
        })
    }
}
