//! One self-contained HTML page, English or Korean, that an engineer hands over.

mod finding;
mod findings;
mod given;
mod page;
mod rank;
mod style;
mod table;
pub(crate) mod words;

#[cfg(test)]
mod tests;

pub use page::{Imprint, NotReported, html};
pub use rank::ranking_html;
