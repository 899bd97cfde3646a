//! Names of the damage states.

use dolmen_words::Language;

/// Name of a damage state, 0 to 3.
pub fn state_words(state: usize, language: Language) -> &'static str {
    match state {
        0 => "DS1",
        1 => "DS2",
        2 => "DS3",
        _ => language.pick("falls", "낙하·전도"),
    }
}
