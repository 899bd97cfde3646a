//! Studies: their runs, the journal that keeps them, and what they say together.

mod answer;
mod designs;
mod engine;
mod fitted;
mod fragility;
mod harmonic;
mod inputs;
mod joints;
mod journal;
mod maps;
mod method;
mod motions;
mod plan;
mod results;
mod run;
mod scans;
mod shaking;
mod table;

pub use answer::{CaseInputs, InputColumn, StudyAnswer, TrendAnswer, TrendVerdict};
pub use designs::{StudyDesigns, study_designs, trained};
pub use engine::{missing, run};
pub use fitted::Fitted;
pub use fragility::{CombinationFragility, MeasureFit, StateFragility, YEARS, fragility_columns};
pub use joints::{JointFragility, JointState, joint_columns};
pub use journal::{
    Journal, JournalError, JournalHeader, ReadJournal, fingerprint, header_line, read_journal, run_line,
};
pub use maps::{ResponseMaps, harmonic_columns, release_columns};
pub use method::{SWING_REST_S, input_words, part_of_step};
pub(crate) use motions::acting_component;
pub use plan::Plan;
pub use results::{JournalText, LeftOutStudy, StudyJournals, finish, merged, resumed, studies, studies_run};
pub use run::{Run, RunOutcome, StudyKind};
pub use scans::{CapacityOf, LevelRow, SCANS_OF_TAILS, ScanVerdict};
pub use shaking::{MeasureComparison, ShakingMeasure, ShakingScales};
pub use table::{Column, ColumnValues, capacity_columns, run_columns, table_csv};
