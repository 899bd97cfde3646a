//! The two languages that people read the results in.

/// A language of reports and figures. Both pieces of a text stand side by side where it is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Language {
    /// English.
    #[default]
    English,
    /// 한국어.
    Korean,
}

impl Language {
    /// The piece in this language.
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
