//! One finding, and how it is marked.

use dolmen::stability::Verdict;
use dolmen_words::Sentence;

/// How a finding is marked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Tone {
    Good,
    Warn,
    Bad,
    Plain,
    Unknown,
}

impl Tone {
    /// As a verdict is marked.
    pub(crate) fn of(verdict: Verdict) -> Self {
        match verdict {
            Verdict::Stable => Tone::Good,
            Verdict::Marginal => Tone::Warn,
            Verdict::Unstable => Tone::Bad,
            Verdict::Unknown => Tone::Unknown,
        }
    }
}

/// One finding.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Finding {
    pub(crate) tone: Tone,
    pub(crate) sentence: Sentence,
}

impl Finding {
    pub(crate) fn new(tone: Tone, sentence: impl Into<Sentence>) -> Self {
        Finding {
            tone,
            sentence: sentence.into(),
        }
    }
}
