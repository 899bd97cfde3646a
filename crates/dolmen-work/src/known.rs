//! Names that there are, beside one that there is not.

use dolmen_words::nearest;

/// "none", "loose, wedged", "loose, wedged (did you mean \"wedged\"?)".
pub(crate) fn known_beside(name: &str, known: &str) -> String {
    match nearest(name, known.split(", ")) {
        _ if known.is_empty() || known == "none" => "none".to_owned(),
        Some(near) => format!("{known} (did you mean \"{near}\"?)"),
        None => known.to_owned(),
    }
}
