//! All sentences as they are written, for who reviews the Korean.

use crate::chain;
use crate::load_factor::LoadFactor;
use dolmen_words::Template;

/// Every sentence of this crate that is a message, in the order of the groups.
pub fn sentences() -> Vec<Template> {
    let mut groups = vec![LoadFactor::TEMPLATES];
    groups.extend(chain::TEMPLATES);
    groups.into_iter().flatten().copied().collect()
}

/// The sentences as a table: its identifier, English, Korean. It begins with the mark by which Excel knows UTF-8.
pub fn sentences_csv() -> String {
    let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
    let mut csv = "\u{feff}sentence,english,korean\r\n".to_owned();
    for template in sentences() {
        let cells = [&template.id(), template.english, template.korean].map(quoted);
        csv += &(cells.join(",") + "\r\n");
    }
    csv
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_no_korean_sentence_is_left_in_english() {
        // symbols, numbers and arguments are the same in both languages
        let is_symbol = |text: &str| {
            text.chars()
                .all(|c| !c.is_ascii_alphabetic() || "kcrPHMNbdit".contains(c))
        };
        for template in sentences() {
            let bare: String = template
                .korean
                .split('{')
                .map(|part| part.split_once('}').map_or(part, |p| p.1))
                .collect();
            let is_korean = bare.chars().any(|c| ('가'..='힣').contains(&c));
            assert!(
                is_korean || is_symbol(&bare),
                "{}: {}",
                template.id(),
                template.korean
            );
        }
    }
}
