//! Colours, fonts and strokes of all figures: distinguishable for colour-blind readers, and by shape in grey print.
//!
//! # Source
//! The palette of Okabe and Ito (2008), *Color Universal Design*.

use dolmen::stability::Verdict;
use dolmen_words::printed_label;

pub(crate) const BLACK: &str = "#000000";
pub(crate) const TEXT: &str = "#1f2328";
pub(crate) const GREY: &str = "#767b81";
pub(crate) const LIGHT: &str = "#e3e6e9";
pub(crate) const WHITE: &str = "#ffffff";
pub(crate) const STONE: &str = "#f1efea";
pub(crate) const ORANGE: &str = "#e69f00";
pub(crate) const SKY: &str = "#56b4e9";
pub(crate) const GREEN: &str = "#009e73";
pub(crate) const BLUE: &str = "#0072b2";
pub(crate) const PURPLE: &str = "#cc79a7";
pub(crate) const VERMILLION: &str = "#d55e00";

/// Colours of series; the first ones differ most.
pub(crate) const SERIES: [&str; 6] = [BLUE, VERMILLION, GREEN, PURPLE, SKY, ORANGE];

/// Fonts with Hangul on every system, the most common first.
pub(crate) const FONTS: &str = "'Noto Sans CJK KR','Noto Sans KR','Malgun Gothic','Apple SD Gothic Neo','Helvetica Neue',Arial,sans-serif";

/// Text size in figures, px at the design width.
pub(crate) const TEXT_PX: f64 = 12.5;

pub(crate) fn verdict_colour(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Stable => GREEN,
        Verdict::Marginal => ORANGE,
        Verdict::Unstable => VERMILLION,
        Verdict::Unknown => GREY,
    }
}

/// The shape that shows the verdict without colours.
pub(crate) fn verdict_shape(verdict: Verdict) -> Shape {
    match verdict {
        Verdict::Stable => Shape::Circle,
        Verdict::Marginal => Shape::Diamond,
        Verdict::Unstable => Shape::Cross,
        Verdict::Unknown => Shape::Ring,
    }
}

/// A marker.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shape {
    Circle,
    Ring,
    Square,
    Diamond,
    Triangle,
    Cross,
    /// An upright line: a limit.
    Bar,
}

/// Style of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Line {
    pub(crate) colour: &'static str,
    pub(crate) width: f64,
    pub(crate) dashed: bool,
    pub(crate) opacity: f64,
}

impl Line {
    pub(crate) const fn new(colour: &'static str, width: f64) -> Self {
        Line {
            colour,
            width,
            dashed: false,
            opacity: 1.0,
        }
    }

    pub(crate) const fn faint(self, opacity: f64) -> Self {
        Line { opacity, ..self }
    }

    pub(crate) const fn dashed(self) -> Self {
        Line { dashed: true, ..self }
    }
}

/// Alignment of a text at its point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

/// A text and its alignment.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Label {
    pub(crate) text: String,
    pub(crate) anchor: Anchor,
    pub(crate) colour: &'static str,
    pub(crate) size: f64,
    pub(crate) bold: bool,
}

impl Label {
    pub(crate) fn new(text: impl Into<String>, anchor: Anchor) -> Self {
        Label {
            text: text.into(),
            anchor,
            colour: TEXT,
            size: TEXT_PX,
            bold: false,
        }
    }

    pub(crate) fn bold(self) -> Self {
        Label { bold: true, ..self }
    }

    pub(crate) fn coloured(self, colour: &'static str) -> Self {
        Label { colour, ..self }
    }

    pub(crate) fn small(self) -> Self {
        Label {
            size: TEXT_PX - 0.5,
            ..self
        }
    }

    /// Estimated width, px, without reading a font. Hangul and other wide letters fill a square.
    pub(crate) fn width(&self) -> f64 {
        text_width(&self.text, self.size)
    }
}

/// Estimated width of a text as it is printed, px, from its letters.
pub(crate) fn text_width(text: &str, size: f64) -> f64 {
    let ems: f64 = printed_label(text)
        .chars()
        .map(|c| match c {
            ' ' | '\u{202f}' | '.' | ',' | ':' | 'i' | 'l' | '|' | '\'' | '(' | ')' => 0.3,
            '\u{1100}'.. => 0.95,
            'A'..='Z' | 'm' | 'w' | '±' | '×' => 0.68,
            _ => 0.56,
        })
        .sum();
    ems * size
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen_words::{Language, PrintedName, print_names};

    /// The width of a legend uses the printed name, which may be longer than that in the file.
    #[test]
    fn exact_a_label_is_as_wide_as_what_it_prints() {
        let printed = PrintedName {
            name: "roof".into(),
            language: Language::Korean,
            printed: "1층 탑신 옥개석".into(),
        };
        let wide = text_width("1층 탑신 옥개석 / ground", 12.0);
        assert!(text_width("roof / ground", 12.0) < wide);
        print_names(&[printed], Language::Korean);
        assert_eq!(text_width("roof / ground", 12.0), wide);
    }
}
