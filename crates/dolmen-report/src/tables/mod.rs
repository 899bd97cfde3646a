//! Histories and tables as CSV and Parquet.

mod building;
mod chain;
mod frame;
#[cfg(feature = "parquet")]
mod parquet;
mod stack;
mod wind;

pub use building::{building_histories_csv, building_peaks_csv};
pub use chain::{chain_energy_csv, chain_histories_csv, chain_slips_csv, chain_uplifts_csv};
pub use frame::{frame_energy_csv, frame_histories_csv, frame_slips_csv};
#[cfg(feature = "parquet")]
pub use parquet::{TableError, parquet};
pub(crate) use stack::supports_csv;
pub use stack::{energy_csv, joints_csv, poses_csv};
pub use wind::{wind_histories_csv, wind_peaks_csv};
