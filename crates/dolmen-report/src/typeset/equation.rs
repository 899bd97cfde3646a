//! Formulas as Typst writes them.

use super::literal::literal;
use crate::document::{Math, linear};

/// A formula on its own line, with a text for readers who cannot see it.
pub(super) fn equation(formula: &[Math]) -> String {
    let alt = literal(&linear(formula));
    format!("math.equation(block: true, alt: {alt}, $ {} $)", pieces(formula))
}

fn pieces(all: &[Math]) -> String {
    all.iter().map(piece).collect::<Vec<_>>().join(" ")
}

fn piece(of: &Math) -> String {
    match of {
        Math::Symbol(text) | Math::Sign(text) => (*text).to_owned(),
        Math::Matrix(text) => format!("bold(upright({text}))"),
        Math::Word(text) => literal(text),
        Math::Index(base, foot) => format!("attach({}, b: {})", piece(base), piece(foot)),
        Math::Power(base, head) => format!("attach({}, tr: {})", piece(base), piece(head)),
        Math::Fraction(above, below) => format!("frac({}, {})", pieces(above), pieces(below)),
        Math::Fenced([left, right], inside) => format!("lr({left} {} {right})", pieces(inside)),
    }
}
