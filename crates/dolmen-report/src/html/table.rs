//! Tables and figures of the page.

use maud::{Markup, html};

/// Tables of at most this many rows stay on one page in print.
const WHOLE_ROWS: usize = 8;

/// One cell.
#[derive(Clone, Debug, Default)]
pub(super) struct Cell {
    text: String,
    class: &'static str,
}

impl Cell {
    /// A cell that depends on an assumed value.
    pub(super) fn assumed(text: impl Into<String>) -> Self {
        Cell {
            text: text.into(),
            class: "assumed",
        }
    }

    /// Words or a list too long for one line.
    pub(super) fn wrapping(text: impl Into<String>) -> Self {
        Cell {
            text: text.into(),
            class: "wrap",
        }
    }
}

impl<T: Into<String>> From<T> for Cell {
    fn from(text: T) -> Self {
        Cell {
            text: text.into(),
            class: "",
        }
    }
}

/// A table whose first `words` columns contain words, the others numbers.
pub(super) fn table(
    anchor: &str,
    label: &str,
    caption: &str,
    words: usize,
    head: &[String],
    rows: &[Vec<Cell>],
) -> Markup {
    let side = |column: usize| if column < words { "t" } else { "" };
    html! {
        @let whole = rows.len() <= WHOLE_ROWS;
        div class=(if whole { "scroll short" } else { "scroll" }) { table id=(anchor) {
            caption { span.no { (label) } " " (strong_lead(caption)) }
            thead { tr { @for (i, name) in head.iter().enumerate() { th class=[filled(side(i))] scope="col" { (name) } } } }
            tbody { @for row in rows { tr {
                @for (i, cell) in row.iter().enumerate() {
                    td class=[filled(&classes(side(i), cell.class))] { (cell.text) }
                }
            } } }
        } }
    }
}

/// Emphasises the first sentence, which gives the main point.
fn strong_lead(text: &str) -> Markup {
    match text.split_once(". ") {
        Some((lead, rest)) => html! { b { (lead) "." } " " (rest) },
        None => html! { b { (text) } },
    }
}

fn classes(side: &str, own: &str) -> String {
    format!("{side} {own}").trim().to_string()
}

fn filled(class: &str) -> Option<String> {
    (!class.is_empty()).then(|| class.to_string())
}
