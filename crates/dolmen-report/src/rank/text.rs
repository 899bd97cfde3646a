//! `dolmen rank` on a terminal.

use super::{remarks, sections::sections, table};
use crate::brief_rows::BriefText;
use crate::document::{Block, TextStyle, document_text, heading_text};
use dolmen_words::{Sentence, messages};
use dolmen_work::portfolio::PortfolioAnswer;

/// Largest number of lines of a short answer after which a remark is still shown, so that the head of the table and some rows have room.
const REMARKS_MOST: usize = 6;
/// Number of table rows in a brief answer.
const ROWS_MOST: usize = 5;

messages! {
    /// The title of a ranking.
    pub(crate) enum Title in "rank.title" {
        Title => { en: "Which structure first", ko: "우선순위 평가" },
    }
}

/// The ranking with its intervals, its basis, and unranked structures.
pub fn rank_text(answer: &PortfolioAnswer, style: TextStyle) -> String {
    let head = heading_text(&Sentence::from(Title::Title).text(style.language));
    match style.is_full {
        true => head + &document_text(&sections(answer), style),
        false => head + &brief(answer, style),
    }
}

/// The warnings and the first ranks.
fn brief(answer: &PortfolioAnswer, style: TextStyle) -> String {
    let mut brief = BriefText::new(style);
    brief.block(remarks::lead(answer));
    brief.blocks(remarks::rate_warning(answer));
    brief.blocks(remarks::severe_damage(answer));
    brief.blocks(remarks::only_at_most(answer));
    if !answer.left_out.is_empty() {
        brief.block(Block::Warning(remarks::left_out_head(answer)));
    }
    for remark in remarks::other_versions(answer)
        .into_iter()
        .chain(remarks::fall_alone(answer))
        .chain(remarks::apart(answer))
        .chain(remarks::columns_left_out(answer))
    {
        brief.block_within(Block::List(vec![remark]), REMARKS_MOST);
    }
    // the first ranks are shown even if the remarks on unranked structures are long
    brief.table(&table::table(answer, true), ROWS_MOST);
    for one in &answer.left_out {
        brief.block(Block::List(vec![remarks::left_out_words(one)]));
    }
    brief.finish()
}
