//! User text is plain text to Typst, never code.

use super::literal::{array, literal};
use super::{document_date, typeset};
use crate::document::{Numbers, document_html};
use crate::html::Imprint;
use crate::html::tests::{gate, pole, survey};
use crate::whole::whole_document;
use dolmen_words::Language;

/// The text between tags of a kind, unescaped.
pub(crate) fn inside(page: &str, tag: &str) -> Vec<String> {
    let (open, close) = (format!("<{tag}"), format!("</{tag}>"));
    let each = page.split(&open).skip(1).filter_map(|rest| {
        let (attributes, inside) = rest.split_once('>')?;
        let is_tag = attributes.is_empty() || attributes.starts_with(' ');
        is_tag.then(|| inside.split(&close).next().unwrap_or_default().to_owned())
    });
    let plain = |text: String| {
        let text = text
            .replace("&lt;", "<")
            .replace("&gt;", ">")
            .replace("&quot;", "\"");
        text.replace("&#39;", "'").replace("&amp;", "&")
    };
    // Typst sets numbers by itself
    let bare = |text: String| match text.strip_prefix("<span class=\"no\">") {
        Some(rest) => rest
            .split_once("</span> ")
            .map_or(String::new(), |(_, bare)| bare.to_owned()),
        None => text,
    };
    each.filter(|text| !text.is_empty())
        .map(bare)
        .map(plain)
        .collect()
}

#[test]
fn holds_what_the_page_says_is_printed() {
    let imprint = Imprint {
        program: "dolmen".into(),
        date: None,
    };
    for answer in [pole("\"unknown\""), gate(), survey()] {
        for language in [Language::English, Language::Korean] {
            let main = typeset(std::slice::from_ref(&answer), &[], language, &imprint).main;
            let page = document_html(&whole_document(&answer), language, &mut Numbers::alone()).into_string();
            let said = ["td", "h2", "h3", "p"].map(|tag| inside(&page, tag)).concat();
            assert!(said.len() > 10, "{} of the page", said.len());
            for words in said {
                assert!(main.contains(&literal(&words)), "not printed: {words}");
            }
        }
    }
}

#[test]
fn quotes_and_markup_stay_words() {
    assert_eq!(
        literal("a \"b\" \\ #c [d] $e$"),
        "\"a \\\"b\\\" \\\\ #c [d] $e$\""
    );
    assert_eq!(literal("한글\n줄\u{7}"), "\"한글 줄 \"");
}

#[test]
fn an_array_of_one_is_an_array() {
    assert_eq!(array(["1".to_owned()]), "(1, )");
    assert_eq!(array([]), "()");
}

#[test]
fn only_days_of_the_calendar_are_dates() {
    let kept = "datetime(year: 2024, month: 2, day: 29)";
    assert_eq!(document_date(Some("2024-02-29")), kept);
    for other in [
        "2023-02-29",
        "2026-04-31",
        "2026-13-01",
        "2026-00-01",
        "May 2026",
        "2026-05-00",
        "2026-5-12",
    ] {
        assert_eq!(document_date(Some(other)), "none", "{other}");
    }
    assert_eq!(document_date(None), "none");
}
