//! A document as a part of a page.

use super::blocks::{Block, Cell, Document, Figure, Table};
use super::finding::{Finding, Tone};
use dolmen_words::{Language, Sentence};
use maud::{Markup, PreEscaped, html};

/// Tables of so many rows stay on one page in print.
const WHOLE_ROWS: usize = 8;

/// The blocks, in a language.
pub(crate) fn document_html(document: &Document<'_>, language: Language) -> Markup {
    html! { @for block in &document.blocks { (block_html(block, language)) } }
}

/// Findings as a list, each marked by its tone.
pub(crate) fn findings_html(findings: &[Finding], language: Language) -> Markup {
    html! {
        ul.findings { @for finding in findings {
            li class=(class(finding.tone)) { (finding.sentence.text(language)) }
        } }
    }
}

fn class(tone: Tone) -> &'static str {
    match tone {
        Tone::Good => "good",
        Tone::Warn => "warn",
        Tone::Bad => "bad",
        Tone::Plain => "plain",
        Tone::Unknown => "unknown",
    }
}

fn block_html(block: &Block<'_>, language: Language) -> Markup {
    match block {
        Block::Heading(head) => html! { h2 { (head.text(language)) } },
        Block::Subheading(head) => html! { h3 { (head.text(language)) } },
        Block::Paragraph(sentences) => html! { p { (joined(sentences, language)) } },
        Block::Warning(sentence) => html! { div.wrong { p { (sentence.text(language)) } } },
        Block::Note(sentence) => html! { p.note { (sentence.text(language)) } },
        Block::List(points) => html! { ul { @for point in points { li { (point.text(language)) } } } },
        Block::KeyValues(rows) => html! { div.scroll.short { table { tbody { @for (key, cell) in rows { tr {
            th.t scope="row" { (key.text(language)) }
            td class=[cell.is_bad().then_some("bad-number")] { (cell.whole(language)) }
        } } } } } },
        Block::Table(table) => table_html(table, language),
        Block::Figures(figures) => match figures.as_slice() {
            [one] => figure_html(one, language),
            several => html! { div.pair { @for one in several { (figure_html(one, language)) } } },
        },
    }
}

fn joined(sentences: &[Sentence], language: Language) -> String {
    let each: Vec<String> = sentences.iter().map(|sentence| sentence.text(language)).collect();
    each.join(" ")
}

/// The first sentence stands out: it says what is to be seen.
fn caption_html(sentences: &[Sentence], language: Language) -> Markup {
    match sentences {
        [] => html! {},
        [lead] => html! { b { (lead.text(language)) } },
        [lead, rest @ ..] => html! { b { (lead.text(language)) } " " (joined(rest, language)) },
    }
}

fn figure_html(figure: &Figure<'_>, language: Language) -> Markup {
    // the texts of a figure are escaped where it is drawn
    let svg = PreEscaped((figure.draw)(language));
    html! { figure { (svg) figcaption { (caption_html(&figure.caption, language)) } } }
}

fn table_html(table: &Table, language: Language) -> Markup {
    let class = |column: usize, cell: Option<&Cell>| {
        let words = table.columns.get(column).is_some_and(|column| column.is_words);
        match (words, cell.is_some_and(Cell::is_bad)) {
            (true, true) => Some("t bad-number"),
            (true, false) => Some("t"),
            (false, true) => Some("bad-number"),
            (false, false) => None,
        }
    };
    html! {
        div class=(if table.rows.len() <= WHOLE_ROWS { "scroll short" } else { "scroll" }) { table {
            caption { (caption_html(&table.caption, language)) }
            thead { tr { @for (i, column) in table.columns.iter().enumerate() {
                th class=[class(i, None)] scope="col" { (column.text(language)) }
            } } }
            tbody { @for row in &table.rows { tr { @for (i, cell) in row.iter().enumerate() {
                td class=[class(i, Some(cell))] { (cell.text(language)) }
            } } } }
        } }
    }
}
