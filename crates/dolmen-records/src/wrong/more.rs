//! The rest of a list, in both languages.

use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// The rest of a list.
    pub(crate) enum More in "records.more" {
        AndMore { first: String, more: usize } => { en: "{first} and {more} more", ko: "{first} 외 {more}개" },
    }
}

/// The first names of a list, and the number of others.
pub(crate) fn and_more(first: String, more: usize) -> Both {
    More::AndMore { first, more }.into()
}
