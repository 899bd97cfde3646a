//! Simulated motions of stacks and frames with everything that their text, JSON, tables, figures and films need.

mod answer;
mod film;
mod frame_answer;
mod frame_tables;
mod tables;

pub use answer::{MotionAnswer, Simulation};
pub use film::{FILM_STEP_S, stack_film};
pub use frame_answer::FrameSimulation;
pub use frame_tables::{frame_energy_csv, frame_histories_csv, frame_slips_csv};
pub use tables::{energy_csv, joints_csv, poses_csv};
