//! Formulas in the script of Hangul's equation editor.

use super::picture::{margins, place, size};
use crate::document::{Math, linear};
use crate::paper::xml::Xml;

/// Size of the letters, hundredths of a point.
const LETTERS: f64 = 1100.0;
/// Widths and heights relative to the letter size: the box for the formula until the editor recomputes it. Our choice, on the large side.
const LETTER_WIDE: f64 = 0.65;
const SIGN_WIDE: f64 = 1.1;
const LINE_HIGH: f64 = 1.25;
/// Relative size of an index or exponent.
const SMALL: f64 = 0.7;

/// A formula within a line, like a letter.
pub(super) fn equation(xml: &mut Xml, formula: &[Math], number: usize) {
    let id = (3_000_000 + number).to_string();
    let [width, height] = room(formula).map(|side| format!("{:.0}", side * LETTERS));
    let letters = format!("{LETTERS:.0}");
    let attributes = [
        ("id", id.as_str()),
        ("zOrder", "0"),
        ("numberingType", "EQUATION"),
        ("textWrap", "TOP_AND_BOTTOM"),
        ("textFlow", "BOTH_SIDES"),
        ("lock", "0"),
        ("dropcapstyle", "None"),
        ("version", "Equation Version 60"),
        ("baseLine", "66"),
        ("textColor", "#000000"),
        ("baseUnit", letters.as_str()),
        ("lineMode", "CHAR"),
        ("font", "HYhwpEQ"),
    ];
    xml.element("hp:equation", &attributes, |xml| {
        size(xml, &width, &height);
        place(xml, true);
        xml.leaf("hp:outMargin", &margins("0"));
        xml.words("hp:shapeComment", &[], &linear(formula));
        xml.words("hp:script", &[], &script(formula));
    });
}

/// The formula in the editor's script.
fn script(formula: &[Math]) -> String {
    formula.iter().map(word).collect::<Vec<_>>().join(" ")
}

fn word(of: &Math) -> String {
    match of {
        Math::Symbol(text) => name(text).to_owned(),
        Math::Matrix(text) => format!("{{rm {{bold {{{}}}}} it}}", name(text)),
        // the editor prints functions upright
        Math::Word(text @ ("det" | "min")) => (*text).to_owned(),
        Math::Word(text) if text.bytes().all(|sign| sign.is_ascii_digit()) => (*text).to_owned(),
        Math::Word(text) => format!("{{rm \"{text}\" it}}"),
        Math::Sign("−") => "-".to_owned(),
        Math::Sign(text) => (*text).to_owned(),
        Math::Index(base, foot) => format!("{} _{{{}}}", word(base), word(foot)),
        Math::Power(base, head) => format!("{} ^{{{}}}", word(base), word(head)),
        Math::Fraction(above, below) => format!("{{{}}} over {{{}}}", script(above), script(below)),
        Math::Fenced([left, right], inside) => format!("LEFT {left} {} RIGHT {right}", script(inside)),
    }
}

/// The editor's name of a letter.
fn name(text: &str) -> &str {
    match text {
        "λ" => "lambda",
        "μ" => "mu",
        "φ" => "varphi",
        "ψ" => "psi",
        "ω" => "omega",
        text => text,
    }
}

/// Width and height.
fn room(formula: &[Math]) -> [f64; 2] {
    let each = formula.iter().map(piece_room);
    each.fold([0.0, LINE_HIGH], |[wide, high], [width, height]| {
        [wide + width, high.max(height)]
    })
}

fn piece_room(of: &Math) -> [f64; 2] {
    match of {
        Math::Symbol(text) | Math::Matrix(text) | Math::Word(text) => {
            [LETTER_WIDE * text.chars().count() as f64, LINE_HIGH]
        }
        Math::Sign(_) => [SIGN_WIDE, LINE_HIGH],
        Math::Index(base, small) | Math::Power(base, small) => {
            let ([wide, high], [small_wide, small_high]) = (piece_room(base), piece_room(small));
            [wide + SMALL * small_wide, high + 0.5 * SMALL * small_high]
        }
        Math::Fraction(above, below) => {
            let ([above, high], [below, low]) = (room(above), room(below));
            [above.max(below) + LETTER_WIDE, high + low]
        }
        Math::Fenced(_, inside) => {
            let [wide, high] = room(inside);
            [wide + LETTER_WIDE, high]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `latex_to_eqedit` of python-hwpx 6.9.0.
    #[test]
    fn agrees_with_the_script_of_python_hwpx() {
        let two = || Math::Word("2");
        for (formula, expected) in [
            (
                vec![
                    Math::Word("det"),
                    Math::round(vec![
                        Math::Matrix("S"),
                        Math::Sign("−"),
                        Math::Symbol("λ"),
                        Math::Matrix("G"),
                    ]),
                    Math::Sign("="),
                    Math::Word("0"),
                ],
                "det LEFT ( {rm {bold {S}} it} - lambda {rm {bold {G}} it} RIGHT ) = 0",
            ),
            (vec![Math::Word("MAC")], "{rm \"MAC\" it}"),
            (vec![Math::Symbol("ω").power(two())], "omega ^{2}"),
            (vec![Math::Symbol("k").index(Math::Word("min"))], "k _{min}"),
            (
                vec![Math::Fraction(
                    vec![Math::Symbol("a"), Math::Symbol("b")],
                    vec![Math::Symbol("c").power(two())],
                )],
                "{a b} over {c ^{2}}",
            ),
        ] {
            assert_eq!(script(&formula), expected);
        }
    }
}
