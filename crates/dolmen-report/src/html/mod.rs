//! One self-contained HTML page, English or Korean, that an engineer hands over.

mod building;
mod building_simulation;
mod chain_simulation;
mod change;
mod decay;
mod demand;
mod finding;
mod findings;
mod fragility;
mod frame;
mod frame_simulation;
mod given;
mod identification;
mod measured;
mod modal;
mod notes;
mod page;
mod rank;
mod record_words;
mod samples;
mod setups;
mod simulation;
mod stack;
mod stack_notes;
mod study;
mod style;
mod table;
mod tune;
mod variants;
mod words;

#[cfg(test)]
mod tests;

pub use page::{Imprint, NotReported, html};
pub use rank::ranking_html;
