//! What the errors of the science say in Korean; in English they say it themselves.

mod assess;
mod faults;
mod forces;
mod fragility;
mod list;
mod modal;
mod motion;
mod numbers;
mod phrase;
mod phrases_of_stacks;
mod signal;
mod stack;
mod structure;

pub use list::of_the_science;
