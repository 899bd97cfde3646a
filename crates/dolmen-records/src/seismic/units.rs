//! Spellings of units of acceleration in headers of motion files.

use crate::unit::Unit;

/// Each spelling, in capitals.
const SPELLINGS: [(&str, Unit); 18] = [
    ("G", Unit::Gravity),
    ("GAL", Unit::Gal),
    ("GALS", Unit::Gal),
    ("CM/S2", Unit::Gal),
    ("CM/S^2", Unit::Gal),
    ("CM/S**2", Unit::Gal),
    ("CM/S/S", Unit::Gal),
    ("CM/SEC2", Unit::Gal),
    ("CM/SEC^2", Unit::Gal),
    ("CM/SEC/SEC", Unit::Gal),
    ("M/S2", Unit::MetrePerSecondSquared),
    ("M/S^2", Unit::MetrePerSecondSquared),
    ("M/S**2", Unit::MetrePerSecondSquared),
    ("M/S/S", Unit::MetrePerSecondSquared),
    ("M/SEC2", Unit::MetrePerSecondSquared),
    ("M/SEC/SEC", Unit::MetrePerSecondSquared),
    ("MM/S2", Unit::MillimetrePerSecondSquared),
    ("MG", Unit::MilliGravity),
];

/// The unit of acceleration for a word in a header; full stops and commas after it are ignored.
pub(super) fn acceleration_unit(word: &str) -> Option<Unit> {
    let word = word.trim().trim_end_matches(['.', ',']).to_uppercase();
    let found = SPELLINGS.iter().find(|(spelling, _)| *spelling == word);
    found.map(|(_, unit)| *unit)
}
