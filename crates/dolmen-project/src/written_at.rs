//! The place of a key in the text of a project file.

use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The place of the value at a path such as `survey.2026-03-10.tilt.x` or `blocks[4].height`; `None` if the text has no such value. Keys
/// may contain dots: of two matching keys, the longer one counts.
pub(super) fn written_at(text: &str, path: &str) -> Option<Range<usize>> {
    let (root, _) = DeTable::parse_recoverable(text);
    in_table(root.get_ref(), path)
}

fn in_table(table: &DeTable<'_>, path: &str) -> Option<Range<usize>> {
    let mut fitting: Vec<(&str, &Spanned<DeValue<'_>>)> = table
        .iter()
        .filter(|(key, _)| rest_behind(path, key.get_ref()).is_some())
        .map(|(key, value)| (key.get_ref().as_ref(), value))
        .collect();
    fitting.sort_by_key(|(key, _)| std::cmp::Reverse(key.len()));
    fitting
        .into_iter()
        .find_map(|(key, value)| in_value(value, rest_behind(path, key)?))
}

fn in_value(value: &Spanned<DeValue<'_>>, rest: &str) -> Option<Range<usize>> {
    if rest.is_empty() {
        return Some(value.span());
    }
    match value.get_ref() {
        DeValue::Table(table) => in_table(table, rest.strip_prefix('.')?),
        DeValue::Array(list) => {
            let (number, rest) = rest.strip_prefix('[')?.split_once(']')?;
            let at = number.parse::<usize>().ok()?.checked_sub(1)?; // counted from 1
            in_value(list.get(at)?, rest)
        }
        _ => None,
    }
}

/// The rest of a path after a key.
fn rest_behind<'p>(path: &'p str, key: &str) -> Option<&'p str> {
    let rest = path.strip_prefix(key)?;
    (rest.is_empty() || rest.starts_with(['.', '['])).then_some(rest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_places_of_keys_with_points_of_lists_and_of_tables_in_a_line() {
        let text = "a = 1\nblocks = [\n  { h = 2 },\n  { h = 3, at = [4, 5] },\n]\n[survey.\"x.y\"]\ntilt = { x = \"6 deg\" }\n[survey.x]\ny = { z = 7 }\n";
        let of = |path| written_at(text, path).map(|span| &text[span]);
        assert_eq!(of("a"), Some("1"));
        assert_eq!(of("blocks[2].h"), Some("3"));
        assert_eq!(of("blocks[2].at[2]"), Some("5"));
        assert_eq!(of("survey.x.y.tilt.x"), Some("\"6 deg\""));
        assert_eq!(of("survey.x.y.z"), Some("7"));
        for absent in [
            "b",
            "blocks[0].h",
            "blocks[3].h",
            "blocks[x]",
            "a.b",
            "survey.x.y.w",
            "",
        ] {
            assert_eq!(of(absent), None, "{absent}");
        }
    }
}
