//! One self-contained HTML page, English or Korean, that an engineer hands over.

mod chain;
mod findings;
mod frame;
mod given;
mod identification;
mod page;
mod samples;
mod style;
mod table;
mod variants;
mod words;

#[cfg(test)]
mod tests;

pub use page::{Imprint, html};
