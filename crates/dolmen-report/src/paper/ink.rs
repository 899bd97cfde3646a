//! Sizes, colours and spans of text.

use crate::document::Tone;

/// Width of the text, twentieths of a point: A4 less its margins.
pub(crate) const TEXT_WIDTH: usize = 9298; // 11906 − 2 · 1304
/// Twentieths of a point in a point.
pub(crate) const TWIPS: f64 = 20.0;

pub(crate) const INK: &str = "1D2733";
pub(crate) const QUIET: &str = "5B6876";
pub(crate) const HAIR: &str = "D5DBE1";
pub(crate) const BAD: &str = "B3261E";
pub(crate) const BAD_WASH: &str = "FCEEED";

/// The colour of a tone, its fill, and its sign.
pub(crate) fn tone(tone: Tone) -> [&'static str; 3] {
    match tone {
        Tone::Good => ["0B6E4F", "EAF5F0", "●"],
        Tone::Warn => ["A15C00", "FDF3E3", "◆"],
        // Korean fonts lack this cross
        Tone::Bad => [BAD, BAD_WASH, "×"],
        Tone::Plain => ["8A96A3", "F4F6F8", "–"],
        Tone::Unknown => [QUIET, "F4F6F8", "○"],
    }
}

/// Emphasis of text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Ink {
    pub(crate) bold: bool,
    pub(crate) colour: Option<&'static str>,
}

impl Ink {
    pub(crate) const PLAIN: Ink = Ink {
        bold: false,
        colour: None,
    };
    pub(crate) const BOLD: Ink = Ink {
        bold: true,
        colour: None,
    };

    pub(crate) fn bold(colour: &'static str) -> Self {
        Ink {
            bold: true,
            colour: Some(colour),
        }
    }
}
