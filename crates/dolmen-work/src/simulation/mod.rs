//! Simulated motions of stacks, frames, chains and buildings with everything that their text, JSON, tables, figures and films need.

mod answer;
mod building_answer;
mod building_tables;
mod chain_answer;
mod chain_tables;
mod film;
mod frame_answer;
mod frame_tables;
mod tables;

pub use answer::base_line_drifts;
pub use answer::{MotionAnswer, Simulation};
pub use building_answer::{Against, BeyondRoom, BuildingSimulation, LargestDrift, WatchedPoint};
pub use building_tables::{building_histories_csv, building_peaks_csv};
pub use chain_answer::ChainSimulation;
pub use chain_tables::{chain_energy_csv, chain_histories_csv, chain_slips_csv, chain_uplifts_csv};
pub use film::{FILM_STEP_S, stack_film};
pub use frame_answer::FrameSimulation;
pub use frame_tables::{frame_energy_csv, frame_histories_csv, frame_slips_csv};
pub use tables::{energy_csv, joints_csv, poses_csv};
