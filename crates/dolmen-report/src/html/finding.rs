//! One finding in plain words, and how it is marked.

pub(super) use crate::document::Tone;
use dolmen_words::Language;

/// One finding.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Finding {
    pub(super) tone: Tone,
    pub(super) text: String,
}

impl Finding {
    /// One of a document, in a language.
    pub(super) fn said(of: crate::document::Finding, language: Language) -> Self {
        Self::new(of.tone, of.sentence.text(language))
    }

    pub(super) fn new(tone: Tone, text: impl Into<String>) -> Self {
        Finding {
            tone,
            text: text.into(),
        }
    }
}
