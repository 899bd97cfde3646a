//! Vibration records: bytes of files to [`Record`](dolmen::signal::Record)s.

mod csv;
mod cursor;
mod error;
mod gcf;
mod hdf5;
mod hdf5_data;
mod hdf5_objects;
mod layout;
mod mat;
mod mat_elements;
mod npy;
mod number;
mod options;
mod read;
mod saf;
mod seismic;
mod series;
mod stamps;
mod stations;
mod tdms;
mod uff;
mod uff_text;
mod unit;
mod wav;

pub use csv::read_csv;
pub use error::RecordError;
pub use layout::{CsvLayout, Decimal, Delimiter};
pub use npy::{Axis, NpyLayout, read_npy};
pub use number::parse_number;
pub use options::{Column, Header, Pick, RecordFormat, RecordOptions, TimeColumn};
pub use read::{Layout, Reading, read_record};
pub use series::{ChannelsLayout, FileUnit, FoundChannel};
pub use stamps::RateSource;
pub use stations::{Station, join_stations};
pub use unit::Unit;
