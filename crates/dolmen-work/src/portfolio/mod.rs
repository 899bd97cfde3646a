//! Rankings of many structures, and their table.

mod answer;
mod apart;
mod columns;
mod heads;
mod rank;
mod state_words;
mod table;
mod words;

pub use answer::{Basis, LeftOut, PortfolioAnswer, PortfolioEntry, of_score, of_study};
pub use apart::{FallsApart, falls_first, hazards_replaced, misjudged, without_hazard};
pub use columns::ranking_columns;
pub(crate) use heads::columns_said;
pub use rank::{FoundProject, Projects, RankOptions, rank};
pub use state_words::state_words;
pub use table::{
    PortfolioError, PortfolioRow, PortfolioTable, RowSource, read_portfolio, read_portfolio_sheet,
};
pub use words::{
    BasisSaid, basis_words, capacity_words, factor_words, known_word, probability_in_years, reason_words,
    unlike_words,
};
