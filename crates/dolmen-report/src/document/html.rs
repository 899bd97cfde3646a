//! A document as a part of a page.

use super::blocks::{Block, Cell, Document, Figure, Table};
use super::finding::Finding;
use super::formula::{Equation, Math};
use super::numbers::{Numbers, figure_label, table_label};
use super::photos::{Photo, Signatory};
use super::text::joined;
use super::words::Framed;
use base64::Engine as _;
use dolmen_words::{Language, Sentence};
use maud::{Markup, PreEscaped, html};

/// Tables of at most this many rows stay on one page in print.
const WHOLE_ROWS: usize = 8;

/// The blocks, in a language, numbered from `numbers`.
pub(crate) fn document_html(document: &Document<'_>, language: Language, numbers: &mut Numbers) -> Markup {
    html! { @for block in &document.blocks { (block_html(block, language, numbers)) } }
}

/// A number before the heading of a section.
pub(crate) fn numbered(number: &str, head: &str) -> Markup {
    html! { span.no { (number) } " " (head) }
}

/// Findings as a list, each marked by its tone.
pub(crate) fn findings_html(findings: &[Finding], language: Language) -> Markup {
    html! {
        ul.findings { @for finding in findings {
            li class=(finding.tone.class()) { (finding.sentence.text(language)) }
        } }
    }
}

/// One block, in a language.
pub(crate) fn block_html(block: &Block<'_>, language: Language, numbers: &mut Numbers) -> Markup {
    match block {
        Block::Heading(head) => {
            html! { h2 id=(numbers.anchor(head)) { (numbered(&numbers.section(), &head.text(language))) } }
        }
        Block::Subheading(head) => {
            html! { h3 id=(numbers.anchor(head)) { (numbered(&numbers.part(), &head.text(language))) } }
        }
        Block::Paragraph(sentences) => html! { p { (joined(sentences, language)) } },
        Block::Warning(sentence) => html! { div.wrong { p { (sentence.text(language)) } } },
        Block::Note(sentence) => html! { p.note { (sentence.text(language)) } },
        Block::List(points) => html! { ul { @for point in points { li { (point.text(language)) } } } },
        Block::KeyValues(rows) => html! { div.scroll.short { table { tbody { @for (key, cell) in rows { tr {
            th.t scope="row" { (key.text(language)) }
            td class=[cell.is_bad().then_some("bad-number")] { (cell.whole(language)) }
        } } } } } },
        Block::Table(table) => table_html(table, language, numbers),
        Block::Equation(of) => equation_html(of, language),
        Block::Figures(figures) => match figures.as_slice() {
            [one] => figure_html(one, language, numbers),
            several => html! { div.pair { @for one in several { (figure_html(one, language, numbers)) } } },
        },
        Block::Photos(photos) => {
            html! { div.pair { @for photo in photos { (photo_html(photo, language, numbers)) } } }
        }
        Block::Signatures(rows) => signatures_html(rows, language),
        Block::Answers(answers) => html! { div.answers { @for answer in answers {
            div class=(answer.tone.class()) {
                p.question { (answer.question.text(language)) }
                p.word { (answer.tone.sign()) " " (answer.word.text(language)) }
            }
        } } },
    }
}

/// MathML, which browsers draw by themselves.
fn equation_html(of: &Equation, language: Language) -> Markup {
    html! { div.equation {
        math display="block" { (pieces_html(&of.formula)) }
        p.note { (of.meaning.text(language)) }
    } }
}

fn pieces_html(pieces: &[Math]) -> Markup {
    html! { mrow { @for piece in pieces { (piece_html(piece)) } } }
}

fn piece_html(piece: &Math) -> Markup {
    html! { @match piece {
        Math::Symbol(text) => mi { (text) },
        Math::Matrix(text) => mi mathvariant="normal" style="font-weight:bold" { (text) },
        Math::Word(text) => mtext { (text) },
        Math::Sign(text) => mo { (text) },
        Math::Index(base, foot) => msub { (piece_html(base)) (piece_html(foot)) },
        Math::Power(base, head) => msup { (piece_html(base)) (piece_html(head)) },
        Math::Fraction(above, below) => mfrac { (pieces_html(above)) (pieces_html(below)) },
        Math::Fenced([left, right], inside) => mrow { mo { (left) } (pieces_html(inside)) mo { (right) } },
    } }
}

/// The image is embedded in the page; its name if it was not read.
fn photo_html(photo: &Photo<'_>, language: Language, numbers: &mut Numbers) -> Markup {
    let label = photo.image.map(|_| figure_label(&numbers.figure(), language));
    let anchor = photo.caption.first().map(|lead| numbers.anchor(lead));
    html! { figure.photo id=[anchor] {
        @match photo.image {
            Some(image) => {
                @let data = base64::engine::general_purpose::STANDARD.encode(&image.bytes);
                img src=(format!("data:{};base64,{data}", image.format.media_type())) alt=(photo.text(language));
            }
            None => p { code { (photo.file) } }
        }
        figcaption { (caption_html(&label.unwrap_or_default(), &photo.caption, language)) }
    } }
}

fn signatures_html(rows: &[Signatory], language: Language) -> Markup {
    let heads = [Framed::Role, Framed::Name, Framed::Licence, Framed::Signature];
    html! { div.scroll.short { table.signatures {
        thead { tr { @for head in heads { th.t scope="col" { (Sentence::from(head).text(language)) } } } }
        tbody { @for row in rows { tr {
            @for words in [&row.role, &row.name, &row.licence] { td.t { (words.text(language)) } }
            td {}
        } } }
    } } }
}

/// Emphasises the first sentence, which gives the main point.
fn caption_html(label: &str, sentences: &[Sentence], language: Language) -> Markup {
    html! {
        span.no { (label) }
        @if let [lead, rest @ ..] = sentences {
            " " b { (lead.text(language)) }
            @if !rest.is_empty() { " " (joined(rest, language)) }
        }
    }
}

fn figure_html(figure: &Figure<'_>, language: Language, numbers: &mut Numbers) -> Markup {
    let label = figure_label(&numbers.figure(), language);
    // the texts of a figure are escaped when drawn
    let svg = PreEscaped((figure.draw)(language));
    let anchor = figure.caption.first().map(|lead| numbers.anchor(lead));
    html! { figure id=[anchor] { (svg) figcaption { (caption_html(&label, &figure.caption, language)) } } }
}

fn table_html(table: &Table, language: Language, numbers: &mut Numbers) -> Markup {
    let label = table_label(&numbers.table(), language);
    let anchor = table.caption.first().map(|lead| numbers.anchor(lead));
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
        div class=(if table.rows.len() <= WHOLE_ROWS { "scroll short" } else { "scroll" }) { table id=[anchor] {
            caption { (caption_html(&label, &table.caption, language)) }
            thead { tr { @for (i, column) in table.columns.iter().enumerate() {
                th class=[class(i, None)] scope="col" { (column.text(language)) }
            } } }
            tbody { @for row in &table.rows { tr { @for (i, cell) in row.iter().enumerate() {
                td class=[class(i, Some(cell))] { (cell.text(language)) }
            } } } }
        } }
    }
}
