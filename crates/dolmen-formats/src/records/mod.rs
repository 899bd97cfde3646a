//! Vibration records: bytes of CSV and NPY files to [`Record`](dolmen::signal::Record)s.

mod csv;
mod error;
mod layout;
mod npy;
mod number;
mod options;
mod read;
mod stamps;
mod unit;

pub use csv::read_csv;
pub use error::RecordError;
pub use layout::{CsvLayout, Decimal, Delimiter};
pub use npy::{Axis, NpyLayout, read_npy};
pub use number::parse_number;
pub use options::{Column, Header, Pick, RecordOptions, TimeColumn};
pub use read::{Layout, Reading, read_record};
pub use stamps::RateSource;
pub use unit::Unit;
