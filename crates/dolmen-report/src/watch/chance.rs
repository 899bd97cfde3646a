//! A probability by chance in words.

use super::numbers::plain;
use dolmen_words::message::Sentence;
use dolmen_words::{Quantity, messages};

messages! {
    /// A probability by chance.
    pub(crate) enum Chance in "watch.chance" {
        Is { p: Quantity } => { en: "p = {p}", ko: "p = {p}" },
        Below => { en: "p < 0.001", ko: "p < 0.001" },
    }
}

pub(super) fn chance(p: f64) -> Sentence {
    match p < 0.001 {
        true => Chance::Below.into(),
        false => Chance::Is { p: plain(p, 3) }.into(),
    }
}
