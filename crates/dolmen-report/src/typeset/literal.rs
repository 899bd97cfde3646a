//! Text as Typst strings, so that none of it is markup.

/// A string literal; control characters become spaces.
pub(super) fn literal(text: &str) -> String {
    let mut said = String::with_capacity(text.len() + 2);
    said.push('"');
    for character in text.chars() {
        match character {
            '"' | '\\' => said.extend(['\\', character]),
            // the fonts lack this cross
            '✕' => said.push('×'),
            control if control.is_control() => said.push(' '),
            other => said.push(other),
        }
    }
    said.push('"');
    said
}

/// An array literal; also correct for one element.
pub(super) fn array(each: impl IntoIterator<Item = String>) -> String {
    let mut said = String::from("(");
    for one in each {
        said.push_str(&one);
        said.push_str(", ");
    }
    said.push(')');
    said
}
