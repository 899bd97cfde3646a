//! `dolmen rank` on a terminal.

use super::{remarks, sections::sections, table};
use crate::brief_rows::BriefText;
use crate::document::{Block, TextStyle, document_text, heading_text};
use dolmen_words::{Sentence, messages};
use dolmen_work::portfolio::PortfolioAnswer;

/// Lines of a brief answer that remarks take at most: below them stands the table.
const REMARKS_MOST: usize = 9;
/// Rows of the table of a brief answer.
const ROWS_MOST: usize = 5;

messages! {
    /// The title of a ranking.
    pub(crate) enum Title in "rank.title" {
        Title => { en: "Which structure first", ko: "우선순위 평가" },
    }
}

/// The order with its intervals, what it rests on, and what has no place.
pub fn rank_text(answer: &PortfolioAnswer, style: TextStyle) -> String {
    let head = heading_text(&Sentence::from(Title::Title).text(style.language));
    match style.is_full {
        true => head + &document_text(&sections(answer), style),
        false => head + &brief(answer, style),
    }
}

/// What must not be overlooked, and the first places.
fn brief(answer: &PortfolioAnswer, style: TextStyle) -> String {
    let mut brief = BriefText::new(style);
    brief.block(remarks::lead(answer));
    brief.blocks(remarks::rate_warning(answer));
    if !answer.left_out.is_empty() {
        brief.block(Block::Warning(remarks::left_out_head(answer)));
    }
    let left_out = answer.left_out.iter().map(remarks::left_out_words);
    let alone = remarks::fall_alone(answer).into_iter();
    for remark in alone.chain(left_out).chain(remarks::apart(answer)) {
        brief.block_within(Block::List(vec![remark]), REMARKS_MOST);
    }
    let places = table::table(answer, true);
    brief.table(&places, ROWS_MOST);
    brief.finish()
}
