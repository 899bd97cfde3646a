//! Rankings of many structures, and their table.

mod answer;
mod apart;
mod columns;
mod rank;
mod state_words;
mod table;
mod words;

pub use answer::{Basis, LeftOut, PortfolioAnswer, PortfolioEntry, of_score, of_study};
pub use apart::{FallsApart, falls_first, hazards_replaced, misjudged, without_hazard};
pub use columns::ranking_columns;
pub use rank::{FoundProject, Projects, RankOptions, rank};
pub use state_words::state_words;
pub(crate) use table::COLUMNS;
pub use table::{PortfolioError, PortfolioRow, PortfolioTable, RowSource, read_portfolio};
pub use words::{
    basis_words, capacity_words, factor_words, known_word, probability_in_years, reason_words, unlike_words,
};
