//! The form of the six-factor score as a page.

use super::imprint::Imprint;
use super::page::whole;
use crate::document::{Numbers, document_html};
use crate::score::{Form, form};
use dolmen_words::{Language, Sentence};
use maud::html;

/// The form as a self-contained page, for printing.
pub fn score_form_html(language: Language, imprint: &Imprint) -> String {
    let title = Sentence::from(Form::Title).text(language);
    let body = html! {
        article {
            header {
                h1 { (title) }
                p.sub { (imprint.program) }
            }
            (document_html(&form(), language, &mut Numbers::alone()))
        }
    };
    whole(&title, language, &body)
}
