//! Output files of the verbs, as names and bytes.

mod drawing;
mod figures;
mod modes;
mod motion;
mod named;
mod nrml;
mod paraview;
mod ranking;
mod sensors;
mod simulation;
mod study;
mod suite;
mod survey;
mod tune;

pub use crate::mark::is_marked;
pub use drawing::drawing_file;
pub use figures::{NotDrawn, figure_files};
pub use motion::motion_files;
pub use named::NamedFile;
pub use ranking::ranking_files;
pub use sensors::sensors_files;
pub use simulation::{simulate_answer_value, simulation_files};
pub use study::{StudyFilesError, study_files};
pub use suite::suite_files;
pub use survey::{change_files, identification_files, watch_files};
pub use tune::tune_files;
