//! A simulated motion of a stack with everything that its text, JSON, tables, figures and films need.

mod answer;
mod film;
mod tables;

pub use answer::{MotionAnswer, Simulation};
pub use film::{FILM_STEP_S, stack_film};
pub use tables::{energy_csv, joints_csv, poses_csv};
