//! Blocks of what an engineer hands over: photographs, rows to sign in, and what the answers come to.

use super::finding::Tone;
use dolmen_words::{Language, Sentence};

/// A photograph or drawing.
#[derive(Clone, Debug)]
pub(crate) struct Photo<'a> {
    /// What it shows; its first sentence stands out.
    pub(crate) caption: Vec<Sentence>,
    /// The file, as the project names it.
    pub(crate) file: &'a str,
    /// Its bytes; `None` where only text is wanted.
    pub(crate) image: Option<&'a dolmen_records::Photo>,
}

/// A row to sign in; what is not given is empty.
#[derive(Clone, Debug)]
pub(crate) struct Signatory {
    /// What for.
    pub(crate) role: Sentence,
    /// Who.
    pub(crate) name: Sentence,
    /// Qualification and number of the licence.
    pub(crate) licence: Sentence,
}

/// One of the three questions, with its word.
#[derive(Clone, Debug)]
pub(crate) struct Answered {
    /// The question.
    pub(crate) question: Sentence,
    /// How it is marked.
    pub(crate) tone: Tone,
    /// The word.
    pub(crate) word: Sentence,
}

impl Photo<'_> {
    /// What it shows, in one line.
    pub(crate) fn text(&self, language: Language) -> String {
        let each: Vec<String> = self.caption.iter().map(|one| one.text(language)).collect();
        each.join(" ")
    }
}
