//! All errors of this crate.

use super::damage::Damage;
use super::mesh_place::OfMesh;
use super::more::More;
use super::pieces::{DiffersFromATable, Piece};
use super::remark::Remark;
use super::station::{OfStation, Turned};
use super::unread::{Expected, Unread};
use crate::meshes::{MeshError, PoseError};
use crate::motions::MotionError;
use crate::records::{NotATable, RecordError, SeismicError};
use crate::{FileError, LimitError, LogError, PhotoError, ScoreFormError, SheetError};
use dolmen_words::message::Argument;
use dolmen_words::{Template, sayable};
use std::error::Error;

/// All sentences of the errors of this crate.
pub const ERRORS: [&[Template]; 21] = [
    Piece::TEMPLATES,
    Remark::TEMPLATES,
    More::TEMPLATES,
    DiffersFromATable::TEMPLATES,
    RecordError::TEMPLATES,
    MotionError::TEMPLATES,
    SeismicError::TEMPLATES,
    MeshError::TEMPLATES,
    PoseError::TEMPLATES,
    SheetError::TEMPLATES,
    PhotoError::TEMPLATES,
    ScoreFormError::TEMPLATES,
    FileError::TEMPLATES,
    LimitError::TEMPLATES,
    LogError::TEMPLATES,
    Damage::TEMPLATES,
    Unread::TEMPLATES,
    Expected::TEMPLATES,
    OfStation::TEMPLATES,
    Turned::TEMPLATES,
    OfMesh::TEMPLATES,
];

/// An error of this crate as a text in both languages; `None` for any other.
pub fn of_records<'e>(error: &'e (dyn Error + 'static)) -> Option<&'e dyn Argument> {
    sayable!(
        error,
        RecordError,
        MotionError,
        SeismicError,
        NotATable,
        MeshError,
        PoseError,
        SheetError,
        PhotoError,
        ScoreFormError,
        FileError,
        LimitError,
        LogError,
    )
}
