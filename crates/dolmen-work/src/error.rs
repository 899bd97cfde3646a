//! Why a verb cannot answer.

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

/// Why a verb cannot answer: what the science, the readers or the project file refuse, each with its place, or what was asked for.
#[derive(Debug)]
pub enum WorkError {
    /// Where the cause lies: a file, a survey, an option.
    Within {
        /// The place.
        place: Both,
        /// What is wrong there.
        cause: Box<WorkError>,
    },
    /// A file cannot be had.
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
    /// The file of a logger states another unit than the project.
    LogUnit {
        /// What the file states.
        stated: String,
        /// What the project says.
        unit: String,
    },
    /// No survey determines the stiffness that the file could hold.
    NothingToWrite,
    /// Several surveys determine it.
    SeveralToWrite {
        /// Their names.
        surveys: Vec<String>,
    },
    /// A value stands in a table beside the project file.
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
    /// From the science.
    Assess(Box<AssessError>),
    /// From the science.
    Blocks(Box<BlocksError>),
    /// From the science.
    Building(Box<BuildingError>),
    /// From the science.
    Damper(Box<DamperError>),
    /// From the science.
    Dynamics(Box<DynamicsError>),
    /// From the science.
    Modal(Box<ModalError>),
    /// From the science.
    Numeric(Box<NumericError>),
    /// From the science.
    Signal(Box<SignalError>),
    /// From the science.
    Stability(Box<StabilityError>),
    /// From the science.
    Stack(Box<StackError>),
    /// From the science.
    Structure(Box<StructureError>),
    /// From the science.
    Validation(Box<ValidationError>),
    /// A motion that is asked for cannot be had.
    MotionRequest(Box<MotionRequestError>),
    /// A study cannot be run, or its runs cannot be used.
    Study(Box<StudyError>),
    /// The caller could not open, read or keep what was asked of it.
    Outside {
        /// Why.
        why: Both,
    },

    /// Samples are asked of a stack.
    SamplesOfStack,
    /// The load factor of a sample is not a number.
    SampleNotANumber,
    /// There is no such variant.
    NoSuchVariant {
        /// The name.
        name: String,
        /// Those there are.
        known: String,
    },
    /// There is no such survey.
    NoSuchSurvey {
        /// The name.
        name: String,
        /// Those there are.
        known: String,
    },
    /// An input channel has a name that no channel has.
    NoSuchInput {
        /// The name.
        name: String,
        /// The channels.
        known: String,
    },
    /// A record is wanted of a project without any.
    NoRecord,
    /// One record is wanted, and there is none or more than one of that description.
    WhichRecord {
        /// How many there are.
        meant: usize,
        /// All that the project has.
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

    /// No survey of a project has its record in one file, as those that come by themselves have theirs.
    NoneToFollow,

    /// A run that needs a motion was prepared without one.
    NoMotionPrepared,
    /// A motion shakes along x and y what moves in a plane.
    TwoHorizontal {
        /// What moves: "a chain".
        what: Both,
    },
    /// A motion shakes along x and y a frame that has one direction.
    FrameOfOneDirection {
        /// The direction.
        direction: String,
    },
    /// A motion shakes along x and y a frame of which the file does not say which direction lies along which.
    DirectionsNotAlong {
        /// Its directions.
        directions: String,
    },
    /// One direction of a frame is wanted under a motion along x and y.
    DirectionOfBoth {
        /// The direction.
        direction: String,
    },
    /// A motion shakes a chain along x and y, and friction acts against the turn of both together.
    OnePlaneFriction {
        /// The joint, from 1 at the bottom.
        joint: usize,
    },
    /// A motion shakes a chain along x and y, and a bed that crushes bears less towards its corners.
    OnePlaneStrength {
        /// The joint, from 1 at the bottom.
        joint: usize,
    },
    /// A motion shakes a chain along x and y, and the depth of a bed that opens is not known.
    OnePlaneNoDepth {
        /// The joint, from 1 at the bottom.
        joint: usize,
    },
    /// A motion shakes only upwards what moves in a plane.
    NoHorizontal {
        /// What moves: "a chain".
        what: Both,
    },
    /// A motion of a study has no horizontal component.
    NoHorizontalOf {
        /// The motion.
        name: String,
    },

    /// A survey cannot be simulated.
    SurveySimulated,
    /// A motion was given to report on a survey.
    SurveyReported {
        /// The project file.
        file: String,
    },
    /// What is no chain is pushed.
    PushOfOther,
    /// The sliding model has no supports that move.
    SlidingOfSupports,
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
        /// Those there are.
        known: String,
    },
    /// The stiffness of no direction is known.
    NoDirectionKnown {
        /// The directions of the file.
        directions: String,
    },
    /// A building falls, so that nothing can be simulated.
    BuildingFalls,
    /// The wind shall blow, and the file gives none.
    NoWindGiven,
    /// Both wind and a motion of the ground are asked for.
    WindAndMotion,
    /// A second motion is to act, and there is no first.
    ThenWithoutMotion,
    /// A length is given to a run of two motions.
    ThenAndDuration,
    /// Two motions of what moves in planes have other horizontal components.
    ThenComponents {
        /// The first motion.
        first: String,
        /// The second.
        second: String,
    },
    /// A seed or repeats of a building are given without the wind.
    NoWindAsked {
        /// The flag.
        flag: &'static str,
    },
    /// Histories of the wind are written at their own steps.
    OutputStepOfWind,
    /// The step of histories of the wind cuts the resonance off.
    WindStepTooLong {
        /// Given, s.
        step_s: f64,
        /// The most that is allowed, s.
        most_s: f64,
        /// The frequency of a mode that it would leave out, Hz.
        mode_hz: f64,
    },
    /// A point of a building was lost.
    PointNotWatched,

    /// The inputs of a case are refused.
    CaseRefused {
        /// Why.
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
    /// Dampers of what is no building.
    TuneOfOther,
    /// The wind of the file is to act, and it gives none.
    TuneWithoutWind,
    /// The building falls by itself.
    BuildingFallsItself,
    /// A damper is tuned to no mode.
    TunedToNoMode,
    /// A floor has no outline.
    FloorWithoutOutline {
        /// The floor, from 1.
        floor: usize,
    },

    /// The score does not know such a pagoda.
    PagodaUnlike {
        /// How it differs.
        how: Both,
    },
    /// A project has no pagoda of six factors.
    NoPagoda {
        /// The project file.
        file: String,
    },
    /// Too few designs for a score.
    TooFewDesigns {
        /// How many there are.
        designs: usize,
    },
    /// Too few designs for the score of the state ranked by.
    TooFewDesignsOfState,
    /// No structure can be ranked.
    NoneRanked {
        /// How many there are.
        structures: usize,
        /// Why, a line a structure.
        reasons: Both,
    },
    /// A project has nothing to be ranked by.
    NothingToRankBy {
        /// The project file.
        file: String,
    },
    /// The project of Palisaden has no record, or none with a mode.
    PalisadenWithoutRecord,
}

/// Lets an error of another crate be handed on as it is.
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
    /// The error that is handed on as it is; `None` of one of its own.
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
