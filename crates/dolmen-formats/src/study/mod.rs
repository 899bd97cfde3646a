//! Studies: their runs, the journal that keeps them, and what they say together.

mod answer;
mod frame_maps;
mod journal;
mod parquet;
mod run;
mod table;

pub use answer::{
    CapacityOf, CaseInputs, InputColumn, LevelRow, StudyAnswer, TrendAnswer, TrendVerdict,
    quantile_of_capacities,
};
pub use frame_maps::{FrameMaps, harmonic_columns, release_columns};
pub use journal::{Journal, JournalError, JournalHeader, fingerprint, header_line, read_journal, run_line};
pub use parquet::{TableError, parquet};
pub use run::{Run, RunOutcome, StudyKind};
pub use table::{Column, ColumnValues, capacity_columns, run_columns, table_csv};
