//! What the damage states are called.

use dolmen_words::Language;

/// What a damage state is called, 0 to 3.
pub fn state_words(state: usize, language: Language) -> &'static str {
    match state {
        0 => "DS1",
        1 => "DS2",
        2 => "DS3",
        _ => language.pick("falls", "낙하·전도"),
    }
}
