//! Text of a file in errors: short, and without control characters.

use crate::wrong::and_more;
use dolmen_words::message::Both;

/// Longest quotation, in characters. Our choice: two lines of a terminal.
const CHARACTERS_MOST: usize = 200;
/// Longest list of names. Our choice: nobody reads more to find the right one.
const NAMES_MOST: usize = 20;

/// A text with its control characters escaped, cut with "…" if it is too long for an error. Applying it twice changes nothing more.
pub(crate) fn shown(text: &str) -> String {
    let mut out = String::new();
    let (mut written, mut room) = (0, 0);
    for c in text.chars() {
        let width = if is_obeyed(c) {
            c.escape_unicode().count()
        } else {
            1
        };
        written += width;
        if written > CHARACTERS_MOST {
            out.truncate(room);
            out.push('…');
            break;
        }
        if width > 1 {
            out.extend(c.escape_unicode());
        } else {
            out.push(c);
        }
        if written < CHARACTERS_MOST {
            room = out.len();
        }
    }
    out
}

/// The first names of a list as quotations, and the number of others.
pub(crate) fn listed<T: AsRef<str>>(names: &[T]) -> Both {
    let first: Vec<String> = names
        .iter()
        .take(NAMES_MOST)
        .map(|name| shown(name.as_ref()))
        .collect();
    match names.len().saturating_sub(NAMES_MOST) {
        0 => first.join(", ").into(),
        more => and_more(first.join(", "), more),
    }
}

/// Control characters, and marks that change the direction of a line or end it.
fn is_obeyed(c: char) -> bool {
    let turns = matches!(c, '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    c.is_control() || turns
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_a_quotation_is_short_and_harmless() {
        assert_eq!(shown("roof x [m/s²]"), "roof x [m/s²]");
        assert_eq!(shown("a\u{1b}[2Jb\nc\u{202e}"), "a\\u{1b}[2Jb\\u{a}c\\u{202e}");
        let exact = "é".repeat(200);
        assert_eq!(shown(&exact), exact);
        let long = shown(&"é".repeat(201));
        assert_eq!((long.chars().count(), long.ends_with('…')), (200, true));
        for text in ["\u{1b}".repeat(1000), format!("{}\u{1b}", "a".repeat(197))] {
            let cut = shown(&text);
            assert!(cut.chars().count() <= 200 && cut.ends_with('…'), "{cut}");
            assert_eq!(shown(&cut), cut);
        }
    }

    #[test]
    fn holds_a_list_names_twenty() {
        let names: Vec<String> = (1..=23).map(|n| format!("ch{n}")).collect();
        assert_eq!(listed(&names[..2]), Both::from("ch1, ch2"));
        assert!(listed(&names[..20]).english.ends_with("ch19, ch20"));
        let more = listed(&names);
        assert!(
            more.english.ends_with("ch19, ch20 and 3 more") && more.korean.ends_with("ch19, ch20 외 3개")
        );
    }
}
