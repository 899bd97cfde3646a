//! Formulas as trees: each renderer writes them in its own notation.

use dolmen_words::Sentence;

/// A formula on its own line, and the meaning of its symbols.
#[derive(Clone, Debug)]
pub(crate) struct Equation {
    pub(crate) formula: Vec<Math>,
    pub(crate) meaning: Sentence,
}

/// A piece of a formula.
#[derive(Clone, Debug)]
pub(crate) enum Math {
    /// A symbol with a value: "λ".
    Symbol(&'static str),
    /// A matrix or vector: "K".
    Matrix(&'static str),
    /// A name or a number: "det", "0".
    Word(&'static str),
    /// An operator between two terms: "=", "−".
    Sign(&'static str),
    /// A term with a subscript.
    Index(Box<Math>, Box<Math>),
    /// A term with an exponent.
    Power(Box<Math>, Box<Math>),
    /// A numerator over a denominator.
    Fraction(Vec<Math>, Vec<Math>),
    /// Terms between a left and a right bracket.
    Fenced([&'static str; 2], Vec<Math>),
}

impl Math {
    pub(crate) fn index(self, foot: Math) -> Math {
        Math::Index(Box::new(self), Box::new(foot))
    }

    pub(crate) fn power(self, head: Math) -> Math {
        Math::Power(Box::new(self), Box::new(head))
    }

    pub(crate) fn round(inside: Vec<Math>) -> Math {
        Math::Fenced(["(", ")"], inside)
    }
}

/// The formula on one line of plain characters: "det(K − λ G) = 0".
pub(crate) fn linear(formula: &[Math]) -> String {
    let mut line = String::new();
    for (at, piece) in formula.iter().enumerate() {
        let is_call = matches!(piece, Math::Fenced(..));
        let after_word = at.checked_sub(1).and_then(|before| formula.get(before));
        if at > 0 && !(is_call && matches!(after_word, Some(Math::Word(_)))) {
            line.push(' ');
        }
        line += &linear_piece(piece);
    }
    line
}

fn linear_piece(piece: &Math) -> String {
    match piece {
        Math::Symbol(text) | Math::Matrix(text) | Math::Word(text) | Math::Sign(text) => (*text).to_owned(),
        Math::Index(base, foot) => format!("{}_{}", linear_piece(base), linear_piece(foot)),
        Math::Power(base, head) => match linear_piece(head).as_str() {
            "2" => format!("{}²", linear_piece(base)),
            head => format!("{}^{head}", linear_piece(base)),
        },
        Math::Fraction(above, below) => format!("{}/{}", grouped(above), grouped(below)),
        Math::Fenced([left, right], inside) => format!("{left}{}{right}", linear(inside)),
    }
}

fn grouped(pieces: &[Math]) -> String {
    match pieces {
        [one] => linear_piece(one),
        several => format!("({})", linear(several)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_a_formula_on_one_line() {
        let two = || Math::Word("2");
        let inside = vec![Math::Matrix("K"), Math::Sign("−"), Math::Symbol("λ").index(two())];
        let of = [
            Math::Word("det"),
            Math::round(inside),
            Math::Sign("="),
            Math::Fraction(
                vec![Math::Symbol("a"), Math::Symbol("b")],
                vec![Math::Symbol("c").power(two())],
            ),
        ];
        assert_eq!(linear(&of), "det(K − λ_2) = (a b)/c²");
    }
}
