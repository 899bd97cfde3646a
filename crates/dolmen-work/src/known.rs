//! Lists the known names in the error for an unknown one.

use crate::wrong::KnownNames;
use dolmen_words::message::Both;
use dolmen_words::nearest;

/// "none", "loose, wedged", "loose, wedged (did you mean \"wedged\"?)".
pub(crate) fn known_beside(name: &str, known: &str) -> Both {
    match nearest(name, known.split(", ")) {
        _ if known.is_empty() || known == "none" => KnownNames::None.into(),
        Some(near) => KnownNames::DidYouMean {
            known: known.to_owned(),
            near: near.to_owned(),
        }
        .into(),
        None => known.into(),
    }
}
