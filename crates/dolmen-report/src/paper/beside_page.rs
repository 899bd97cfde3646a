//! Compares the paragraphs of a document with the page of the same answer, for tests of every format.

use crate::document::{Numbers, document_html};
use crate::lowered::with_lowered;
use crate::typeset::tests::inside;
use crate::whole::whole_document;
use dolmen_words::Language;
use dolmen_work::answer::ProjectReport;

/// Checks that every heading, paragraph, cell and caption of the page is among the paragraphs.
pub(crate) fn holds_the_page(there: &[String], answer: &ProjectReport, language: Language) {
    let page = document_html(&whole_document(answer), language, &mut Numbers::alone()).into_string();
    let said = ["td", "th", "h2", "h3", "p", "li"]
        .map(|tag| inside(&page, tag))
        .concat();
    assert!(said.len() > 10, "{} of the page", said.len());
    for words in said {
        let words = lowered(&words);
        assert!(there.contains(&words), "not in the document: {words}");
    }
    let captions = ["caption", "figcaption"].map(|tag| inside(&page, tag)).concat();
    assert!(!captions.is_empty());
    for caption in captions {
        let bare = lowered(&caption.replace("<b>", "").replace("</b>", ""));
        let ends = |said: &String| said.ends_with(&bare) && said.len() > bare.len();
        assert!(there.iter().any(ends), "no such caption: {bare}");
    }
}

/// The text with its symbols as on paper, the second part lowered.
fn lowered(words: &str) -> String {
    with_lowered(words, str::to_owned)
}
