//! Finds the name that a misspelt one probably means.

use crate::composed;

/// Least similarity for a suggestion (Jaro-Winkler, 1 for equal names). Our choice.
const SIMILARITY_LEAST: f64 = 0.8;

/// The most similar of the known names, if any is similar enough. Unicode normalization (NFC, NFD) makes no difference.
///
/// # Example
/// ```
/// use dolmen_words::nearest;
/// assert_eq!(nearest("wegded", ["loose", "wedged"]), Some("wedged"));
/// assert_eq!(nearest("other", ["loose", "wedged"]), None);
/// let parts = "\u{1100}\u{1175}\u{1105}\u{1169}\u{11a8}.npy"; // 기록.npy as macOS writes it
/// assert_eq!(nearest("기륵.npy", [parts]), Some(parts));
/// ```
pub fn nearest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let whole = composed(name);
    let scored = known
        .into_iter()
        .map(|known| (strsim::jaro_winkler(&whole, &composed(known)), known));
    let near = scored.filter(|(score, known)| *score >= SIMILARITY_LEAST && *known != name);
    near.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, known)| known)
}
