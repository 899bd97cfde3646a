//! Names in one or two languages.

use super::file_names::NamesRaw;

/// A name in one or both languages; at least one is given.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Names {
    /// English.
    pub en: Option<String>,
    /// Korean.
    pub ko: Option<String>,
}

impl Names {
    /// The English name, or the Korean one if there is no other.
    pub fn english(&self) -> &str {
        let names = self.en.as_deref().or(self.ko.as_deref());
        names.unwrap_or_default()
    }

    /// The Korean name, or the English one if there is no other.
    pub fn korean(&self) -> &str {
        let names = self.ko.as_deref().or(self.en.as_deref());
        names.unwrap_or_default()
    }
}

/// Text alone is the English name, or the Korean one if it is written in Hangul.
pub(super) fn names(raw: NamesRaw) -> Names {
    match raw {
        NamesRaw::One(name) if name.chars().any(|c| ('가'..='힣').contains(&c)) => Names {
            en: None,
            ko: Some(name),
        },
        NamesRaw::One(name) => Names {
            en: Some(name),
            ko: None,
        },
        NamesRaw::Table(table) => Names {
            en: table.en,
            ko: table.ko,
        },
    }
}
