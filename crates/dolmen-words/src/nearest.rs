//! What a misspelt name probably means.

/// Similarity from which a name is offered (Jaro-Winkler, 1 for the same). Chosen here.
const SIMILARITY_LEAST: f64 = 0.8;

/// The most similar of the known names, if any is similar enough.
///
/// # Example
/// ```
/// use dolmen_words::nearest;
/// assert_eq!(nearest("wegded", ["loose", "wedged"]), Some("wedged"));
/// assert_eq!(nearest("other", ["loose", "wedged"]), None);
/// ```
pub fn nearest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let scored = known
        .into_iter()
        .map(|known| (strsim::jaro_winkler(name, known), known));
    let near = scored.filter(|(score, known)| *score >= SIMILARITY_LEAST && *known != name);
    near.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, known)| known)
}
