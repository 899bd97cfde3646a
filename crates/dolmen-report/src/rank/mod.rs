//! Answers about a ranked portfolio.

mod remarks;
mod sections;
mod table;
mod text;

pub(crate) use remarks::not_by_rate;
pub(crate) use sections::sections;
pub use text::rank_text;

use dolmen_words::Template;

/// Templates of the sentences on rankings.
pub(crate) const TEMPLATES: [&[Template]; 4] = [
    sections::Rank::TEMPLATES,
    remarks::Remarks::TEMPLATES,
    table::Ranking::TEMPLATES,
    text::Title::TEMPLATES,
];
