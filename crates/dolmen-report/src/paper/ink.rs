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

/// Symbols whose second part is a subscript, as on the page.
pub(super) const LOWERED: [&str; 8] = ["k_cr", "k_min", "K_n", "K_s", "a_z", "I_u", "d_SLV", "T_SLV"];

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

/// A stretch of words.
pub(crate) struct Stretch {
    pub(crate) words: String,
    /// Whether it is a subscript.
    pub(crate) is_lowered: bool,
}

/// Text as spans on the line.
pub(crate) fn stretches_of(text: &str) -> Vec<Stretch> {
    let mut stretches = Vec::new();
    let mut add = |words: String, is_lowered| {
        if !words.is_empty() {
            stretches.push(Stretch { words, is_lowered });
        }
    };
    let mut rest = text;
    while let Some((at, symbol)) = first_symbol(rest) {
        let (before, behind) = rest.split_at(at);
        let (letter, index) = symbol.split_once('_').unwrap_or((symbol, ""));
        add(format!("{before}{letter}"), false);
        add(index.to_owned(), true);
        rest = behind.strip_prefix(symbol).unwrap_or_default();
    }
    add(rest.to_owned(), false);
    stretches
}

fn first_symbol(text: &str) -> Option<(usize, &'static str)> {
    let found = LOWERED
        .iter()
        .filter_map(|symbol| Some((text.find(symbol)?, *symbol)));
    found.min()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_the_second_part_of_a_symbol_stands_lower() {
        let stretches = stretches_of("M > k_cr; k_min.");
        let joined: String = stretches.iter().map(|of| of.words.as_str()).collect();
        assert_eq!(joined, "M > kcr; kmin.");
        let low: Vec<&str> = stretches
            .iter()
            .filter(|of| of.is_lowered)
            .map(|of| of.words.as_str())
            .collect();
        assert_eq!(low, ["cr", "min"]);
    }
}
