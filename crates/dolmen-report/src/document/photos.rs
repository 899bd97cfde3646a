//! Blocks for photographs, signatures, and the three answers of a report.

use super::finding::Tone;
use dolmen_words::{Language, Sentence};

/// A photograph or drawing.
#[derive(Clone, Debug)]
pub(crate) struct Photo<'a> {
    /// Caption; its first sentence is emphasised.
    pub(crate) caption: Vec<Sentence>,
    /// File name in the project.
    pub(crate) file: &'a str,
    /// Its bytes; `None` if only text is needed.
    pub(crate) image: Option<&'a dolmen_records::Photo>,
}

/// A row for a signature; missing data are empty.
#[derive(Clone, Debug)]
pub(crate) struct Signatory {
    pub(crate) role: Sentence,
    /// Name of the person.
    pub(crate) name: Sentence,
    /// Qualification and number of the licence.
    pub(crate) licence: Sentence,
}

/// One of the three questions, with its word.
#[derive(Clone, Debug)]
pub(crate) struct Answered {
    pub(crate) question: Sentence,
    pub(crate) tone: Tone,
    pub(crate) word: Sentence,
}

impl Photo<'_> {
    /// Its caption in one line.
    pub(crate) fn text(&self, language: Language) -> String {
        let each: Vec<String> = self.caption.iter().map(|one| one.text(language)).collect();
        each.join(" ")
    }
}
