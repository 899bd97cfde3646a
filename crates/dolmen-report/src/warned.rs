//! Notes on the file in documents: with the names of inputs instead of lines and paths of the file, which the reader does not see.

use crate::html::words::input_words;
use dolmen_project::{Project, Warning};
use dolmen_words::message::Both;
use dolmen_words::{Sentence, messages};

messages! {
    /// A note on the file in a document.
    pub(crate) enum Noted in "warned" {
        Said(words: Both) => { en: "{words}", ko: "{words}" },
        Slip(words: Both) => { en: "! PROBABLY A SLIP: {words}", ko: "! 입력 오류 의심: {words}" },
    }
}

/// A note with names of the inputs instead of their paths.
pub(crate) fn warned(project: &Project, warning: &Warning) -> Sentence {
    Noted::Said(in_words(project, warning)).into()
}

/// The same for a probable slip.
pub(crate) fn slip(project: &Project, warning: &Warning) -> Sentence {
    Noted::Slip(in_words(project, warning)).into()
}

fn in_words(project: &Project, warning: &Warning) -> Both {
    let inputs = project.inputs();
    let bare: Vec<&str> = inputs
        .iter()
        .map(|input| input.path.as_str())
        .filter(|path| !path.contains(['[', '.']))
        .collect();
    Both::of(|language| {
        let words = |path: &str| input_words(project, path, language);
        let said = paths_in_words(&warning.message.text(language), words);
        bare.iter()
            .fold(said, |said, path| with_item(&said, path, &words(path)))
    })
}

/// A list ("inputs: density, links[1].weight") with the item `path` replaced: a bare key may also be a word of the sentence.
fn with_item(list: &str, path: &str, words: &str) -> String {
    let items = list.split(", ").map(|item| match item.strip_suffix(path) {
        Some(head) if head.is_empty() || head.ends_with(": ") => format!("{head}{words}"),
        _ => item.to_owned(),
    });
    items.collect::<Vec<_>>().join(", ")
}

/// A sentence with its whole paths in words. A variant may have paths that the structure as given has not, such as `contacts[1].joint.friction`.
fn paths_in_words(said: &str, words: impl Fn(&str) -> String) -> String {
    let is_of_path = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '.' | '[' | ']' | '-');
    let mut found = String::with_capacity(said.len());
    let mut rest = said;
    while !rest.is_empty() {
        let end = rest.find(|c: char| !is_of_path(c)).unwrap_or(rest.len());
        let (token, after) = rest.split_at(end);
        let path = token.trim_end_matches(['.', '-']);
        match path.contains(['[', '.']) {
            true => found.push_str(&words(path)),
            false => found.push_str(path),
        }
        found.push_str(&token[path.len()..]);
        let others = after.find(is_of_path).unwrap_or(after.len());
        found.push_str(&after[..others]);
        rest = &after[others..];
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::html::words::path_words;
    use dolmen_words::Language;

    #[test]
    fn exact_a_path_of_a_variant_is_in_words_as_a_whole() {
        let said = "in variant iso: contacts[1].joint.friction is 0.100 of p.toml: raise joint.friction.";
        assert_eq!(
            paths_in_words(said, |path| path_words(path, Language::English)),
            "in variant iso: contact 1 joint friction coefficient is 0.100 of p.toml: raise all joints: friction coefficient."
        );
    }
}
