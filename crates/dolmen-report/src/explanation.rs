//! One code with its explanation, and a list of them: code, title and text of each.

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

/// Explanations, each written as `"code" "title" => "text"`.
macro_rules! explanations {
    ($($code:literal $title:literal => $text:literal),* $(,)?) => {
        &[$($crate::explanation::Explanation { code: $code, title: $title, text: $text }),*]
    };
}

pub(crate) use explanations;
