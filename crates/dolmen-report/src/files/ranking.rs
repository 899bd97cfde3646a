//! A ranking as files.

use super::named::NamedFile;
use crate::figures::ranking;
use crate::html::{Imprint, ranking_html};
use crate::json::rank_json;
use dolmen_words::{Language, keeping_names};
use dolmen_work::portfolio::{PortfolioAnswer, ranking_columns};
use dolmen_work::study::table_csv;

/// Table, JSON, figure and page of a ranking.
pub fn ranking_files(answer: &PortfolioAnswer, language: Language, imprint: &Imprint) -> Vec<NamedFile> {
    vec![
        NamedFile::new("ranking.csv", table_csv(&ranking_columns(answer))),
        NamedFile::json("ranking.json", &keeping_names(|| rank_json(answer))),
        NamedFile::svg("ranking", &ranking(answer, language)),
        NamedFile::new("ranking.html", ranking_html(answer, language, imprint)),
    ]
}
