//! All errors of this crate, and of those below it.

use super::flag::FlagWords;
use super::pieces::{
    CaseRefused, DesignNeeds, FileRemark, JournalDiffers, KnownNames, NoPlace, NotHeld, OfRuns, Place,
    RowLacks, RowNeeds, RunEnded,
};
use crate::change_fault::ChangeFault;
use crate::error::WorkError;
use crate::flags::ForeignFlag;
use crate::kept::StoreFault;
use crate::motion::MotionRequestError;
use crate::portfolio::PortfolioError;
use crate::scanned::ScanError;
use crate::score::ScoreDesignsError;
use crate::sensors::SensorsError;
use crate::study::{JournalError, StudyError};
use dolmen_project::{AngleError, DamperFault, ProjectError, StackFault};
use dolmen_records::of_records;
use dolmen_words::message::Argument;
use dolmen_words::science::of_the_science;
use dolmen_words::{Template, sayable};
use std::error::Error;

/// All sentences of the errors of this crate.
pub const ERRORS: [&[Template]; 23] = [
    WorkError::TEMPLATES,
    ChangeFault::TEMPLATES,
    MotionRequestError::TEMPLATES,
    StudyError::TEMPLATES,
    JournalError::TEMPLATES,
    ScoreDesignsError::TEMPLATES,
    PortfolioError::TEMPLATES,
    ScanError::TEMPLATES,
    SensorsError::TEMPLATES,
    StoreFault::TEMPLATES,
    FlagWords::TEMPLATES,
    KnownNames::TEMPLATES,
    Place::TEMPLATES,
    CaseRefused::TEMPLATES,
    OfRuns::TEMPLATES,
    JournalDiffers::TEMPLATES,
    NoPlace::TEMPLATES,
    NotHeld::TEMPLATES,
    RunEnded::TEMPLATES,
    FileRemark::TEMPLATES,
    RowLacks::TEMPLATES,
    RowNeeds::TEMPLATES,
    DesignNeeds::TEMPLATES,
];

/// An error of this crate, of a reader, a project file or the library, as a text in both languages; `None` for any other.
pub(crate) fn of_work<'e>(error: &'e (dyn Error + 'static)) -> Option<&'e dyn Argument> {
    sayable!(
        error,
        WorkError,
        Box<WorkError>,
        ChangeFault,
        MotionRequestError,
        StudyError,
        JournalError,
        ScoreDesignsError,
        PortfolioError,
        ScanError,
        SensorsError,
        ForeignFlag,
        StoreFault,
        ProjectError,
        AngleError,
        StackFault,
        DamperFault,
    )
    .or_else(|| of_records(error))
    .or_else(|| of_the_science(error))
}
