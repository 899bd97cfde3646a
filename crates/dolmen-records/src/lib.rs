//! Bytes to vibration records, ground motions and meshes, and back. Opens no file.

mod breaks;
mod files;
mod limits;
mod log;
mod log_order;
mod log_times;
pub mod meshes;
pub mod motions;
mod number;
mod photo;
mod quoted;
pub mod records;
mod score_form;
mod seismic;
mod sheet;
mod sheet_error;
mod sheet_heads;
mod sheet_limits;
mod start;
mod text_code;
mod unit;
mod workbook;
mod wrong;

pub use files::{
    FileError, Files, JOURNAL_BYTES_MOST, MESH_BYTES_MOST, MOTION_BYTES_MOST, MemoryFiles, NoFiles,
    PROJECT_BYTES_MOST, RECORD_BYTES_MOST, TABLE_BYTES_MOST, stays_within,
};
pub use limits::LimitError;
pub use log::{Log, LogError, read_log};
pub use photo::{PHOTO_BYTES_MOST, PHOTO_PIXELS_MOST, Photo, PhotoError, PhotoFormat, read_photo};
pub use score_form::{FormFactor, ScoreForm, ScoreFormError, read_score_form};
pub use sheet::{SHEET_BYTES_MOST, SheetCell, SheetValue, read_dated_sheet, read_sheet};
pub use sheet_error::SheetError;
pub use sheet_heads::is_misspelt;
pub use start::{start_of_text, time_text};
pub use text_code::utf8;
pub use wrong::{ERRORS, of_records};
