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
    /// The sign that stands before it, for those who see no colours.
    pub(crate) fn sign(self) -> char {
        match self {
            Tone::Good => '●',
            Tone::Warn => '◆',
            Tone::Bad => '✕',
            Tone::Plain => '-',
            Tone::Unknown => '○',
        }
    }

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
    /// How it is marked.
    pub(crate) tone: Tone,
    /// Whether a brief answer holds it: what decides, how sure it is, what to do next.
    pub(crate) is_key: bool,
    /// The code that `dolmen explain` knows, if there is a longer answer.
    pub(crate) code: Option<&'static str>,
    /// What the finding says.
    pub(crate) sentence: Sentence,
}

impl Finding {
    /// A finding of the full answer.
    pub(crate) fn new(tone: Tone, sentence: impl Into<Sentence>) -> Self {
        Finding {
            tone,
            is_key: false,
            code: None,
            sentence: sentence.into(),
        }
    }

    /// A finding that a brief answer holds too.
    pub(crate) fn key(tone: Tone, sentence: impl Into<Sentence>) -> Self {
        Finding {
            is_key: true,
            ..Self::new(tone, sentence)
        }
    }

    /// The same with the code of a longer answer.
    pub(crate) fn with_code(self, code: &'static str) -> Self {
        Finding {
            code: Some(code),
            ..self
        }
    }
}
