//! A finding and its tone.

use dolmen::stability::Verdict;
use dolmen_words::Sentence;

/// Tone of a finding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Tone {
    Good,
    Warn,
    Bad,
    Plain,
    Unknown,
}

impl Tone {
    /// The sign before it, for readers who cannot see colours.
    pub(crate) fn sign(self) -> char {
        match self {
            Tone::Good => '●',
            Tone::Warn => '◆',
            Tone::Bad => '✕',
            Tone::Plain => '-',
            Tone::Unknown => '○',
        }
    }

    /// Its name in the style sheet of a page and in the prelude of a print.
    pub(crate) fn class(self) -> &'static str {
        match self {
            Tone::Good => "good",
            Tone::Warn => "warn",
            Tone::Bad => "bad",
            Tone::Plain => "plain",
            Tone::Unknown => "unknown",
        }
    }

    /// The tone of a verdict.
    pub(crate) fn of(verdict: Verdict) -> Self {
        match verdict {
            Verdict::Stable => Tone::Good,
            Verdict::Marginal => Tone::Warn,
            Verdict::Unstable => Tone::Bad,
            Verdict::Unknown => Tone::Unknown,
        }
    }
}

/// What a finding is to those beside it in a short answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    /// It answers a question of the file, and is shown before all others.
    Answer,
    /// It says how the answer before it has to be read, and is shown only with that.
    Qualifies,
    /// Neither.
    Alone,
}

/// One finding.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Finding {
    pub(crate) tone: Tone,
    pub(crate) role: Role,
    /// Whether it is part of a short answer: what decides, how certain it is, what to do next.
    pub(crate) is_key: bool,
    /// The code for `dolmen explain`, if there is a longer explanation.
    pub(crate) code: Option<&'static str>,
    /// Its text.
    pub(crate) sentence: Sentence,
}

impl Finding {
    /// A finding of the full answer.
    pub(crate) fn new(tone: Tone, sentence: impl Into<Sentence>) -> Self {
        Finding {
            tone,
            role: Role::Alone,
            is_key: false,
            code: None,
            sentence: sentence.into(),
        }
    }

    /// A finding that is part of a short answer too.
    pub(crate) fn key(tone: Tone, sentence: impl Into<Sentence>) -> Self {
        Finding {
            is_key: true,
            ..Self::new(tone, sentence)
        }
    }

    /// The answer to a question of the file.
    pub(crate) fn answer(tone: Tone, sentence: impl Into<Sentence>) -> Self {
        Finding {
            role: Role::Answer,
            ..Self::key(tone, sentence)
        }
    }

    /// How the answer before it has to be read.
    pub(crate) fn qualifies(tone: Tone, sentence: impl Into<Sentence>) -> Self {
        Finding {
            role: Role::Qualifies,
            ..Self::key(tone, sentence)
        }
    }

    /// The same with the code of a longer explanation.
    pub(crate) fn with_code(self, code: &'static str) -> Self {
        Finding {
            code: Some(code),
            ..self
        }
    }
}
