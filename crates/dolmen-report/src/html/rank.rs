//! A ranked portfolio as a page.

use super::imprint::Imprint;
use super::page::whole;
use crate::document::{Numbers, document_html};
use crate::rank::sections;
use dolmen_words::Language;
use dolmen_work::portfolio::PortfolioAnswer;
use maud::html;

/// The ranking as a self-contained page.
pub fn ranking_html(answer: &PortfolioAnswer, language: Language, imprint: &Imprint) -> String {
    let title = language.pick("Which structure first", "우선순위 평가");
    let body = html! {
        article {
            header {
                p.kicker { (language.pick("Ranking of structures", "구조물 우선순위")) }
                h1 { (title) }
                p.sub { (answer.source) }
                p.sub { @if let Some(date) = &imprint.date { (date) " · " } (imprint.program) }
            }
            (document_html(&sections(answer), language, &mut Numbers::alone()))
        }
    };
    whole(title, language, &body)
}
