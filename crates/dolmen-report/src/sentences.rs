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
    use std::collections::BTreeSet;
    use std::path::Path;

    /// Names of the groups of messages in the files of a folder.
    fn groups(folder: &Path, found: &mut BTreeSet<String>) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                groups(&path, found);
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                let text = std::fs::read_to_string(path).unwrap();
                let lines = text
                    .lines()
                    .filter(|line| line.contains(" enum ") && line.ends_with('{'));
                let named = lines.filter_map(|line| line.split_once(" in \"")?.1.strip_suffix("\" {"));
                found.extend(named.map(str::to_owned));
            }
        }
    }

    #[test]
    fn holds_every_group_of_messages_is_in_the_table() {
        let mut written = BTreeSet::new();
        groups(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &mut written);
        let listed: BTreeSet<String> = sentences().iter().map(|of| of.group.to_owned()).collect();
        assert!(listed.len() > 5);
        assert_eq!(listed, written);
        let ids: BTreeSet<String> = sentences().iter().map(Template::id).collect();
        assert_eq!(ids.len(), sentences().len(), "identifiers are unlike");
    }

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
