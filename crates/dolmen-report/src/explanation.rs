//! One code with its explanation.

/// One code with its explanation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Explanation {
    /// The code, as printed in brackets: "unsafe-criterion".
    pub code: &'static str,
    /// One line.
    pub title: &'static str,
    /// A few plain paragraphs: meaning, reason, and remedy.
    pub text: &'static str,
}
