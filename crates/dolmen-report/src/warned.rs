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
    Both::of(|language| {
        let mut said = warning.message.text(language);
        for path in &paths {
            if !said.contains(path) {
                continue;
            }
            let words = input_words(&project.structure, path, language);
            said = match path.contains(['[', '.']) {
                true => said.replace(path, &words),
                false => with_item(&said, path, &words),
            };
        }
        said
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
