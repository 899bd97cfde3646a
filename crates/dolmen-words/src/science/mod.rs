//! Korean texts for errors of the library, which have English texts of their own.

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
