//! One finding in plain words, and how it is marked.

use dolmen::stability::Verdict;

/// How a finding is marked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Tone {
    Good,
    Warn,
    Bad,
    Plain,
    Unknown,
}

/// One finding.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Finding {
    pub(super) tone: Tone,
    pub(super) text: String,
}

impl Finding {
    pub(super) fn new(tone: Tone, text: impl Into<String>) -> Self {
        Finding {
            tone,
            text: text.into(),
        }
    }

    /// Marked as the verdict is.
    pub(super) fn of(verdict: Verdict, text: impl Into<String>) -> Self {
        let tone = match verdict {
            Verdict::Stable => Tone::Good,
            Verdict::Marginal => Tone::Warn,
            Verdict::Unstable => Tone::Bad,
            Verdict::Unknown => Tone::Unknown,
        };
        Self::new(tone, text)
    }
}
