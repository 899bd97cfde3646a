//! Any record file: the format is found out from its first bytes.

use super::{CsvLayout, NpyLayout, RecordError, RecordOptions, read_csv, read_npy};
use dolmen::signal::Record;

/// A record, with what was found out about its file.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// The record, in SI; its history begins with [`Read`](dolmen::signal::Processing::Read).
    pub record: Record,
    /// How the file was laid out.
    pub layout: Layout,
}

/// How a file was laid out.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Layout {
    /// Text in columns.
    Csv(CsvLayout),
    /// A NumPy array.
    Npy(NpyLayout),
}

/// A record from the bytes of a CSV or NPY file.
///
/// # Errors
/// [`RecordError`], which says where in the file and what to do.
///
/// # Example
/// ```
/// use dolmen_formats::records::{RecordOptions, Unit, read_record};
/// let text = "Time (s);roof x;roof y\n0,00;1,5;-2\n0,01;2,5;0\n0,02;1,0;3\n";
/// let options = RecordOptions { unit: Unit::MilliGravity, ..Default::default() };
/// let record = read_record(text.as_bytes(), &options)?.record;
/// assert_eq!(record.sampling_rate_hz(), 100.0);
/// assert_eq!(record.channels()[0].name, "roof x");
/// assert!((record.samples(0)[1] - 2.5e-3 * 9.80665).abs() < 1e-15);
/// # Ok::<(), dolmen_formats::records::RecordError>(())
/// ```
pub fn read_record(bytes: &[u8], options: &RecordOptions) -> Result<Reading, RecordError> {
    if bytes.starts_with(super::npy::MAGIC) {
        read_npy(bytes, options)
    } else {
        read_csv(bytes, options)
    }
}
