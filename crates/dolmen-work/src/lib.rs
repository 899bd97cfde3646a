//! What Dolmen answers about a project. Opens no file, prints nothing.

pub mod answer;
pub mod building;
pub mod change;
pub mod motion;
pub mod portfolio;
pub mod score;
pub mod simulation;
pub mod study;
pub mod tune;
mod without_stiffness;
