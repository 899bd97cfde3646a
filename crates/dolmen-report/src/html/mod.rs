//! One self-contained HTML page, English or Korean, that an engineer hands over.

pub(crate) mod front;
pub(crate) mod fronted;
pub(crate) mod given;
mod imprint;
pub(crate) mod method;
mod page;
mod rank;
mod score;
mod style;
mod table;
pub(crate) mod words;

#[cfg(test)]
pub(crate) mod tests;

pub(crate) use front::{has_headline, headline_line, project_name};
pub(crate) use imprint::day;
pub use imprint::{Imprint, NotReported};
pub use page::html;
pub use rank::ranking_html;
pub use score::score_form_html;
