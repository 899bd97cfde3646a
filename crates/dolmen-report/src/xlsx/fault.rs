//! A workbook that could not be written.

use rust_xlsxwriter::XlsxError;

/// A workbook that could not be written.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the workbook could not be made: {0}")]
pub struct WorkbookFault(String);

impl From<XlsxError> for WorkbookFault {
    fn from(fault: XlsxError) -> Self {
        WorkbookFault(fault.to_string())
    }
}
