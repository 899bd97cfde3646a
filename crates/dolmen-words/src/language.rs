//! The two languages of results.

/// A language of reports and figures. The English and Korean of a text stand side by side in the
/// code.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Language {
    /// English.
    #[default]
    English,
    /// 한국어.
    Korean,
}

impl Language {
    /// The argument in this language.
    ///
    /// ```
    /// use dolmen_words::Language;
    /// assert_eq!(Language::Korean.pick("stable", "안정"), "안정");
    /// ```
    pub fn pick<T>(self, english: T, korean: T) -> T {
        match self {
            Language::English => english,
            Language::Korean => korean,
        }
    }

    /// The code of the language in HTML: "en", "ko".
    pub fn code(self) -> &'static str {
        self.pick("en", "ko")
    }
}
