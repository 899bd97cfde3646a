//! One self-contained HTML page, English or Korean, that an engineer hands over.

mod given;
mod page;
mod rank;
mod style;
mod table;
pub(crate) mod words;

#[cfg(test)]
mod tests;

pub use page::{Imprint, NotReported, html};
pub(crate) use page::{headline_line, project_name};
pub use rank::ranking_html;
