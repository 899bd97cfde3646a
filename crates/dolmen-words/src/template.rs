//! Sentences before their arguments are filled in: places in braces, and marks around what only a screen says.

use crate::Language;
use std::borrow::Cow;

/// What a sentence is read on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Medium {
    /// A screen, beside which commands and keys of the file can be typed.
    Screen,
    /// Paper.
    Paper,
}

/// Begin and end of what only a screen says; words for paper stand behind [`OR`].
const OPENS: char = '«';
const CLOSES: char = '»';
const OR: char = '|';

/// A sentence before its arguments are filled in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Template {
    /// The group of its message, such as "chain.stability".
    pub group: &'static str,
    /// The name of its message, such as "Contradicted".
    pub message: &'static str,
    /// English, its arguments in braces, what only a screen says in marks.
    pub english: &'static str,
    /// 한국어.
    pub korean: &'static str,
}

impl Template {
    /// "chain.stability/contradicted", as in [`Sentence::id`](crate::Sentence::id).
    pub fn id(&self) -> String {
        message_id(self.group, self.message)
    }

    /// Its text in a language and on a medium.
    pub fn on(&self, language: Language, medium: Medium) -> Cow<'static, str> {
        on_medium(language.pick(self.english, self.korean), medium)
    }

    /// Whether it says something else on paper.
    pub(crate) fn has_marks(&self) -> bool {
        self.english.contains(OPENS) || self.korean.contains(OPENS)
    }
}

/// The text of a template for a medium: `«on a screen»`, `«on a screen|on paper»`.
fn on_medium(template: &str, medium: Medium) -> Cow<'_, str> {
    if !template.contains(OPENS) {
        return Cow::Borrowed(template);
    }
    let mut said = String::with_capacity(template.len());
    let mut rest = template;
    while let Some((before, behind)) = rest.split_once(OPENS) {
        let (marked, after) = behind.split_once(CLOSES).unwrap_or((behind, "")); // refused at compile time
        let (screen, paper) = marked.split_once(OR).unwrap_or((marked, ""));
        said.push_str(before);
        said.push_str(match medium {
            Medium::Screen => screen,
            Medium::Paper => paper,
        });
        rest = after;
    }
    Cow::Owned(said + rest)
}

/// Whether marks are paired, none within another, with one bar at most in each; runs at compile time.
pub const fn marks_well(sentence: &str) -> bool {
    // « is C2 AB and » C2 BB; no other character holds these bytes in this order
    const FIRST: u8 = 0xC2;
    let sentence = sentence.as_bytes();
    let (mut at, mut is_open, mut bars) = (0, false, 0);
    while at < sentence.len() {
        if sentence[at] == FIRST && at + 1 < sentence.len() {
            let (opens, closes) = (sentence[at + 1] == 0xAB, sentence[at + 1] == 0xBB);
            if (opens && is_open) || (closes && !is_open) || bars > 1 {
                return false;
            }
            if opens || closes {
                (is_open, bars) = (opens, 0);
            }
        }
        if sentence[at] == b'|' && is_open {
            bars += 1;
        }
        at += 1;
    }
    !is_open
}

/// `chain.stability` and `ModelContradicted` make `chain.stability/model-contradicted`.
pub fn message_id(group: &str, variant: &str) -> String {
    let words = variant.char_indices().map(|(at, sign)| match sign {
        upper if upper.is_uppercase() && at > 0 => format!("-{}", upper.to_lowercase()),
        other => other.to_lowercase().to_string(),
    });
    format!("{group}/{}", words.collect::<String>())
}

/// Whether a sentence has a placeholder `{argument}`; runs at compile time.
pub const fn holds(sentence: &str, argument: &str) -> bool {
    let (sentence, argument) = (sentence.as_bytes(), argument.as_bytes());
    let mut at = 0;
    while at + argument.len() + 1 < sentence.len() {
        let mut same = 0;
        while same < argument.len() && sentence[at + 1 + same] == argument[same] {
            same += 1;
        }
        if sentence[at] == b'{' && same == argument.len() && sentence[at + 1 + same] == b'}' {
            return true;
        }
        at += 1;
    }
    false
}

/// Whether every placeholder of a sentence is a known argument; runs at compile time.
pub const fn knows(sentence: &str, names: &[&str]) -> bool {
    let sentence = sentence.as_bytes();
    let mut at = 0;
    while at < sentence.len() {
        let is_brace = sentence[at] == b'{' || sentence[at] == b'}';
        if is_brace && at + 1 < sentence.len() && sentence[at + 1] == sentence[at] {
            at += 2;
        } else if is_brace {
            let mut end = at + 1;
            while end < sentence.len() && sentence[end] != b'}' {
                end += 1;
            }
            if sentence[at] == b'}' || end == sentence.len() || !is_one_of(sentence, at + 1, end, names) {
                return false;
            }
            at = end + 1;
        } else {
            at += 1;
        }
    }
    true
}

/// Whether the bytes from `start` to `end` are one of the names.
const fn is_one_of(sentence: &[u8], start: usize, end: usize, names: &[&str]) -> bool {
    let mut number = 0;
    while number < names.len() {
        let name = names[number].as_bytes();
        let mut same = 0;
        while same < name.len() && start + same < end && sentence[start + same] == name[same] {
            same += 1;
        }
        if same == name.len() && start + same == end {
            return true;
        }
        number += 1;
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_places_and_ids() {
        assert!(knows("{a} {{b}} {c}", &["a", "c"]) && knows("한 {a}", &["a"]) && !knows("{ab}", &["a"]));
        assert!(!knows("{a", &["a"]) && !knows("a}", &["a"]) && !knows("{a}", &["ab"]));
        assert!(holds("{a} b", "a") && holds("b {ab}", "ab") && !holds("{ab} a", "a") && !holds("{a", "a"));
        assert_eq!(
            message_id("chain", "ModelContradicted"),
            "chain/model-contradicted"
        );
    }

    #[test]
    fn exact_marks() {
        let said = |text, medium| on_medium(text, medium).into_owned();
        let text = "a« b»c«d|e» {f}";
        assert_eq!(said(text, Medium::Screen), "a bcd {f}");
        assert_eq!(said(text, Medium::Paper), "ace {f}");
        assert_eq!(said("«|a»b", Medium::Screen), "b");
        assert_eq!(said("plain | text", Medium::Paper), "plain | text");
        assert!(marks_well(text) && marks_well("") && marks_well("a | b | c") && marks_well("±«가|나»"));
        for wrong in ["«a", "a»", "«a«b»»", "»a«", "«a|b|c»"] {
            assert!(!marks_well(wrong), "{wrong}");
        }
    }
}
