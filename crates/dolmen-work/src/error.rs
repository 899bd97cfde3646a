//! Why a verb cannot answer.

use crate::change_fault::ChangeFault;
use crate::known::known_beside;
use crate::motion::MotionRequestError;
use crate::portfolio::PortfolioError;
use crate::score::ScoreDesignsError;
use crate::study::{JournalError, StudyError};
use dolmen::assess::AssessError;
use dolmen::blocks::BlocksError;
use dolmen::damper::DamperError;
use dolmen::dynamics::DynamicsError;
use dolmen::modal::ModalError;
use dolmen::numeric::NumericError;
use dolmen::signal::SignalError;
use dolmen::stability::StabilityError;
use dolmen::structure::StructureError;
use dolmen::structure::building::BuildingError;
use dolmen::structure::stack::StackError;
use dolmen::validation::ValidationError;
use dolmen_project::{AngleError, DamperFault, ProjectError, StackFault};
use dolmen_records::motions::MotionError;
use dolmen_records::records::RecordError;
use dolmen_records::{FileError, PhotoError};
use std::error::Error;

/// Why a verb cannot answer: what the science, the readers or the project file refuse, each with its place, or what was asked for.
#[derive(Debug, thiserror::Error)]
pub enum WorkError {
    /// Where the cause lies: a file, a survey, an option.
    #[error("{place}")]
    Within {
        /// The place.
        place: String,
        /// What is wrong there.
        #[source]
        cause: Box<WorkError>,
    },
    /// A file cannot be had.
    #[error(transparent)]
    File(Box<FileError>),
    /// The project file is refused.
    #[error(transparent)]
    Project(Box<ProjectError>),
    /// A record is refused.
    #[error(transparent)]
    Record(Box<RecordError>),
    /// A file of a ground motion is refused.
    #[error(transparent)]
    Motion(Box<MotionError>),
    /// A photograph is refused.
    #[error(transparent)]
    Photo(Box<PhotoError>),
    /// The photographs of a report are too large together.
    #[error(
        "the photographs of one report hold more than {most} MiB together: save them smaller (3000 pixels across fill a page), or leave some out"
    )]
    TooManyPhotos {
        /// The limit, MiB.
        most: u64,
    },
    /// An angle is refused.
    #[error(transparent)]
    Angle(Box<AngleError>),
    /// A stack cannot be built.
    #[error(transparent)]
    StackPart(Box<StackFault>),
    /// A damper cannot be built.
    #[error(transparent)]
    DamperPart(Box<DamperFault>),
    /// Surveys cannot be compared.
    #[error(transparent)]
    Change(Box<ChangeFault>),
    /// A table of structures is refused.
    #[error(transparent)]
    Portfolio(Box<PortfolioError>),
    /// A table of designs is refused.
    #[error(transparent)]
    Designs(Box<ScoreDesignsError>),
    /// A journal cannot be read.
    #[error(transparent)]
    Journal(Box<JournalError>),
    /// From the science.
    #[error(transparent)]
    Assess(Box<AssessError>),
    /// From the science.
    #[error(transparent)]
    Blocks(Box<BlocksError>),
    /// From the science.
    #[error(transparent)]
    Building(Box<BuildingError>),
    /// From the science.
    #[error(transparent)]
    Damper(Box<DamperError>),
    /// From the science.
    #[error(transparent)]
    Dynamics(Box<DynamicsError>),
    /// From the science.
    #[error(transparent)]
    Modal(Box<ModalError>),
    /// From the science.
    #[error(transparent)]
    Numeric(Box<NumericError>),
    /// From the science.
    #[error(transparent)]
    Signal(Box<SignalError>),
    /// From the science.
    #[error(transparent)]
    Stability(Box<StabilityError>),
    /// From the science.
    #[error(transparent)]
    Stack(Box<StackError>),
    /// From the science.
    #[error(transparent)]
    Structure(Box<StructureError>),
    /// From the science.
    #[error(transparent)]
    Validation(Box<ValidationError>),
    /// A motion that is asked for cannot be had.
    #[error(transparent)]
    MotionRequest(Box<MotionRequestError>),
    /// A study cannot be run, or its runs cannot be used.
    #[error(transparent)]
    Study(Box<StudyError>),
    /// The caller could not open, read or keep what was asked of it.
    #[error("{why}")]
    Outside {
        /// Why.
        why: String,
    },

    /// Samples are asked of a stack.
    #[error(
        "--samples cannot draw for a stack yet: its verdict is without shaking; take --sensitivity for what moves it"
    )]
    SamplesOfStack,
    /// The load factor of a sample is not a number.
    #[error("the load factor of a sample is not a number: it must not be counted as standing")]
    SampleNotANumber,
    /// There is no such variant.
    #[error("there is no variant \"{name}\": the file has {}", known_beside(name, known))]
    NoSuchVariant {
        /// The name.
        name: String,
        /// Those there are.
        known: String,
    },
    /// There is no such survey.
    #[error("there is no survey \"{name}\": the file has {}", known_beside(name, known))]
    NoSuchSurvey {
        /// The name.
        name: String,
        /// Those there are.
        known: String,
    },
    /// A reference channel has a name that no channel has.
    #[error("modal.references names {name:?}, but the channels used are {known}")]
    NoSuchReference {
        /// The name.
        name: String,
        /// The channels.
        known: String,
    },

    /// A run that needs a motion was prepared without one.
    #[error("the run was prepared without a motion")]
    NoMotionPrepared,
    /// A motion shakes along x and y what moves in a plane.
    #[error(
        "{what} moves in one direction, but the motion has the components x and y: give one file, or turn the motion and give the component \
         that you mean as x"
    )]
    TwoHorizontal {
        /// What moves: "a chain".
        what: &'static str,
    },
    /// A motion shakes only upwards what moves in a plane.
    #[error("{what} moves horizontally, but the motion has neither x nor y")]
    NoHorizontal {
        /// What moves: "a chain".
        what: &'static str,
    },
    /// A motion of a study has no horizontal component.
    #[error("motion \"{name}\" has no horizontal component")]
    NoHorizontalOf {
        /// The motion.
        name: String,
    },

    /// A survey cannot be simulated.
    #[error("only stacks, frames, chains and buildings can be simulated: the file has kind = \"survey\"")]
    SurveySimulated,
    /// A motion was given to report on a survey.
    #[error("{file}: only stacks, frames and chains can be simulated; leave the motion out")]
    SurveyReported {
        /// The project file.
        file: String,
    },
    /// What is no chain is pushed.
    #[error("--push lets a chain lean at the start: the file has another kind")]
    PushOfOther,
    /// A chain is pushed too far.
    #[error("--push is {push_rad} rad, but must be at most {most_rad} rad in size")]
    PushTooLarge {
        /// The push, rad.
        push_rad: f64,
        /// The largest allowed, rad.
        most_rad: f64,
    },
    /// Neither a motion nor a push is given.
    #[error(
        "nothing moves the chain: give --motion or --motion-file, or let it lean at the start with --push \"1e-4 rad\""
    )]
    NothingMovesChain,
    /// The joints of a chain are unknown.
    #[error(
        "the joints are unknown: `dolmen identify` finds stiffness that measured modes allow; write it into joints or into a variant, and \
         simulate that with --variant"
    )]
    JointsUnknown,
    /// The stiffness of a direction is unknown.
    #[error(
        "the stiffness of direction \"{direction}\" is unknown: `dolmen identify` finds those that its frequencies allow; write one of them \
         into [direction.{direction}] or into a variant, and simulate that"
    )]
    DirectionUnknown {
        /// The direction.
        direction: String,
    },
    /// There is no such direction.
    #[error(
        "there is no direction \"{direction}\": the file has {}",
        known_beside(direction, known)
    )]
    NoSuchDirection {
        /// The name.
        direction: String,
        /// Those there are.
        known: String,
    },
    /// The stiffness of no direction is known.
    #[error(
        "the stiffness of no direction is known ({directions}): `dolmen identify` finds those that measured frequencies allow; write one of \
         them into [direction.NAME] or into a variant, and simulate that with --variant"
    )]
    NoDirectionKnown {
        /// The directions of the file.
        directions: String,
    },
    /// A building falls, so that nothing can be simulated.
    #[error(
        "the building falls under its own weight, so that nothing was simulated: `dolmen check` says where"
    )]
    BuildingFalls,
    /// A point of a building was lost.
    #[error("a point of the file was not watched")]
    PointNotWatched,

    /// The inputs of a case are refused.
    #[error("{why}")]
    CaseRefused {
        /// Why.
        why: String,
    },

    /// There is no such damper that can be tuned.
    #[error(
        "there is no damper \"{name}\" in {file} that stands at a place to be found: \"tmd\" and \"tlcd\" do, \"tlcmd\" and \"link\" are tuned \
         with the others, without --damper"
    )]
    NoSuchDamper {
        /// The name.
        name: String,
        /// The project file.
        file: String,
    },
    /// There is no damper.
    #[error(
        "{file} has no damper to tune: write a table such as [damper.roof] with kind = \"tmd\", floor, place, direction, mass_ratio and \
         tuning, in the file or in a variant"
    )]
    NoDamper {
        /// The project file.
        file: String,
    },
    /// Dampers of what is no building.
    #[error(
        "only buildings have dampers to tune: the file has another kind; start one with kind = \"building\""
    )]
    TuneOfOther,
    /// The building falls by itself.
    #[error("the building falls under its own weight: `dolmen check` says where")]
    BuildingFallsItself,
    /// A damper is tuned to no mode.
    #[error("it is tuned to no mode")]
    TunedToNoMode,
    /// A floor has no outline.
    #[error(
        "floor {floor} has no outline, so that places on it are not known: give sides or outline in its table"
    )]
    FloorWithoutOutline {
        /// The floor, from 1.
        floor: usize,
    },

    /// The score does not know such a pagoda.
    #[error(
        "the score does not know such a pagoda: {how}. Simulate it with dolmen study, or force the score with --extrapolate"
    )]
    PagodaUnlike {
        /// How it differs.
        how: String,
    },
    /// A project has no pagoda of six factors.
    #[error(
        "{file} has no pagoda of six factors: write pagoda = {{ storeys = 5, body_height = 6.0, … }} in a stack, or simulate its blocks with \
         dolmen study"
    )]
    NoPagoda {
        /// The project file.
        file: String,
    },
    /// Too few designs for a score.
    #[error("{designs} designs are too few for a score: 50 and more with a curve are needed")]
    TooFewDesigns {
        /// How many there are.
        designs: usize,
    },
    /// Too few designs for the score of the state ranked by.
    #[error("the score has too few designs of this state")]
    TooFewDesignsOfState,
    /// No structure can be ranked.
    #[error("none of {structures} structures can be ranked:{reasons}")]
    NoneRanked {
        /// How many there are.
        structures: usize,
        /// Why, a line a structure.
        reasons: String,
    },
    /// A project has nothing to be ranked by.
    #[error("it has neither results of a study nor a pagoda of six factors: run dolmen study {file} first")]
    NothingToRankBy {
        /// The project file.
        file: String,
    },
    /// The project of Palisaden has no record, or none with a mode.
    #[error("palisaden has no record")]
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
    Angle: AngleError,
    StackPart: StackFault,
    DamperPart: DamperFault,
    Change: ChangeFault,
    Portfolio: PortfolioError,
    Designs: ScoreDesignsError,
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
            WorkError::File(why) => why.as_ref(),
            WorkError::Project(why) => why.as_ref(),
            WorkError::Record(why) => why.as_ref(),
            WorkError::Motion(why) => why.as_ref(),
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
    fn within(self, place: impl FnOnce() -> String) -> Result<T, WorkError>;
}

impl<T, E: Into<WorkError>> Within<T> for Result<T, E> {
    fn within(self, place: impl FnOnce() -> String) -> Result<T, WorkError> {
        self.map_err(|cause| WorkError::Within {
            place: place(),
            cause: Box::new(cause.into()),
        })
    }
}
