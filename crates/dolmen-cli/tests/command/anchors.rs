// SOURCE     Our own pages.
// GOAL       Each section, table and figure of a report has an identifier of its own, the same in both languages, so that a link to it keeps its aim.
// TOLERANCE  none: names.

use super::each_example::shown;
use std::collections::BTreeSet;

/// The tags of a page that begin so.
fn tags<'p>(page: &'p str, name: &'p str) -> impl Iterator<Item = &'p str> {
    let starts = page.split('<').skip(1);
    let tags = starts.filter_map(|piece| piece.split_once('>').map(|(tag, _)| tag));
    tags.filter(move |tag| tag.split([' ', '\n']).next() == Some(name))
}

/// The identifiers of a page in their order.
fn identifiers(page: &str) -> Vec<&str> {
    let starts = page.split('<').skip(1);
    let tags = starts.filter_map(|piece| piece.split_once('>').map(|(tag, _)| tag));
    tags.filter_map(|tag| tag.split_once(" id=\"")?.1.split('"').next())
        .collect()
}

#[test]
fn holds_each_block_of_a_report_has_an_identifier_of_its_own() {
    for [english, korean] in shown().as_chunks().0 {
        let (example, english, korean) = (&english.example, &english.page, &korean.page);
        let found = identifiers(english);
        let several: BTreeSet<&str> = found.iter().copied().collect();
        assert_eq!(found.len(), several.len(), "{example}: {found:?}");
        assert_eq!(found, identifiers(korean), "{example}");
        for name in ["h2", "h3", "figure", "caption"] {
            let within = match name {
                "caption" => "table", // a table without a caption is a list of values
                name => name,
            };
            let named = tags(english, within).filter(|tag| tag.contains(" id=\""));
            assert_eq!(named.count(), tags(english, name).count(), "{example}: {name}");
        }
    }
}
