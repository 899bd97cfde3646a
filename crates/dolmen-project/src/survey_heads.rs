//! Heads of a table of surveys: the contents of each column.

/// The contents of a column of surveys.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Held {
    Date,
    Temperature,
    /// A frequency of a direction, by its number in it.
    Frequency(String, u32),
    /// Its standard deviation.
    FrequencySd(String, u32),
    /// A tilt along a direction.
    Tilt(String),
    /// The width of a crack, by its name and the part in which it is.
    Crack(String, String),
    Datum,
    Note,
}

/// A word of a head.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Word {
    Date,
    Temperature,
    Frequency,
    Mode,
    Sd,
    Tilt,
    Datum,
    Note,
    Along(&'static str),
    /// No further information: "방향" of "X방향".
    Beside,
}

/// The direction of a frequency without a direction in its head.
const OTHER: &str = "other";
/// Largest number of a mode, our choice.
const MODE_MOST: u32 = 40;

const WORDS: [(&str, Word); 46] = [
    ("date", Word::Date),
    ("survey", Word::Date),
    ("날짜", Word::Date),
    ("일자", Word::Date),
    ("조사", Word::Date),
    ("조사일", Word::Date),
    ("조사일자", Word::Date),
    ("측정일", Word::Date),
    ("측정일자", Word::Date),
    ("계측일", Word::Date),
    ("계측일자", Word::Date),
    ("점검일", Word::Date),
    ("점검일자", Word::Date),
    ("temperature", Word::Temperature),
    ("temp", Word::Temperature),
    ("기온", Word::Temperature),
    ("온도", Word::Temperature),
    ("frequency", Word::Frequency),
    ("freq", Word::Frequency),
    ("f", Word::Frequency),
    ("진동수", Word::Frequency),
    ("고유진동수", Word::Frequency),
    ("주파수", Word::Frequency),
    ("고유주파수", Word::Frequency),
    ("mode", Word::Mode),
    ("모드", Word::Mode),
    ("sd", Word::Sd),
    ("std", Word::Sd),
    ("σ", Word::Sd),
    ("표준편차", Word::Sd),
    ("tilt", Word::Tilt),
    ("기울기", Word::Tilt),
    ("경사", Word::Tilt),
    ("datum", Word::Datum),
    ("기준점", Word::Datum),
    ("note", Word::Note),
    ("notes", Word::Note),
    ("비고", Word::Note),
    ("메모", Word::Note),
    ("x", Word::Along("x")),
    ("y", Word::Along("y")),
    ("torsion", Word::Along("torsion")),
    ("비틀림", Word::Along("torsion")),
    ("방향", Word::Beside),
    ("차", Word::Beside),
    ("hz", Word::Beside),
];

/// A head without its unit, and the unit: "X 진동수 (Hz)".
pub(super) fn with_unit(head: &str) -> (&str, Option<&str>) {
    let head = head.trim();
    let inner = head.strip_suffix([')', ']', '）']);
    let split = inner.and_then(|inner| inner.rsplit_once(['(', '[', '（']));
    match split {
        Some((name, unit)) => (name.trim(), Some(unit.trim()).filter(|unit| !unit.is_empty())),
        None => (head, None),
    }
}

/// The meaning of a head, without its unit; `None` if it is not one of surveys.
pub(super) fn held(name: &str) -> Option<Held> {
    let lower = name.trim().to_lowercase();
    if ["crack", "균열"].iter().any(|word| lower.starts_with(word)) {
        let (crack, part) = name.trim().split_once('@')?;
        let after = |text: &'_ str, words: &[&str]| -> String {
            let word = words.iter().find(|word| text.to_lowercase().starts_with(**word));
            text[word.map_or(0, |word| word.len())..].trim().to_owned()
        };
        let crack = after(&after(crack, &["crack", "균열"]), &["width", "폭"]);
        let part = part.trim();
        return (!crack.is_empty() && !part.is_empty()).then(|| Held::Crack(crack, part.to_owned()));
    }
    let (words, number) = words(&lower)?;
    let along = words.iter().find_map(|word| match word {
        Word::Along(direction) => Some(*direction),
        _ => None,
    });
    let has = |of: Word| words.contains(&of);
    let others = words
        .iter()
        .filter(|word| !matches!(word, Word::Beside | Word::Along(_)));
    let mut others: Vec<Word> = others.copied().collect();
    let direction = || along.unwrap_or(OTHER).to_owned();
    if has(Word::Frequency) || has(Word::Mode) {
        let is_sd = has(Word::Sd);
        others.retain(|word| !matches!(word, Word::Frequency | Word::Mode | Word::Sd));
        let number = number.unwrap_or(1);
        return others.is_empty().then(|| match is_sd {
            true => Held::FrequencySd(direction(), number),
            false => Held::Frequency(direction(), number),
        });
    }
    match (others.as_slice(), along, number) {
        ([Word::Date], None, None) => Some(Held::Date),
        ([Word::Temperature], None, None) => Some(Held::Temperature),
        ([Word::Tilt], Some(direction), None) => Some(Held::Tilt(direction.to_owned())),
        ([Word::Datum], None, None) => Some(Held::Datum),
        ([Word::Note], None, None) => Some(Held::Note),
        _ => None,
    }
}

/// The words of a head and its number, joined in any way; `None` if any part of it is not a known word, or it has two numbers.
fn words(name: &str) -> Option<(Vec<Word>, Option<u32>)> {
    let (mut words, mut number) = (Vec::new(), None);
    let mut rest = name;
    while let Some(sign) = rest.chars().next() {
        if sign.is_whitespace() || "_-.,:·".contains(sign) {
            rest = &rest[sign.len_utf8()..];
            continue;
        }
        let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
        if digits > 0 {
            let own = rest[..digits]
                .parse::<u32>()
                .ok()
                .filter(|own| (1..=MODE_MOST).contains(own))?;
            if number.replace(own).is_some() {
                return None;
            }
            rest = &rest[digits..];
            continue;
        }
        let letters = rest.bytes().take_while(u8::is_ascii_lowercase).count();
        let fits = |word: &&(&str, Word)| match letters {
            // a word of another script may be followed by others
            0 => rest.starts_with(word.0),
            _ => rest[..letters] == *word.0,
        };
        // "fx", "fy"
        let joined = ["fx", "fy"].contains(&&rest[..letters]);
        let (used, word) = match joined {
            true => (1, Word::Frequency),
            false => {
                let found = WORDS.iter().filter(fits).max_by_key(|word| word.0.len())?;
                (found.0.len(), found.1)
            }
        };
        words.push(word);
        rest = &rest[used..];
    }
    (!words.is_empty()).then_some((words, number))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_heads_in_both_languages() {
        let frequency = |direction: &str, number| Some(Held::Frequency(direction.to_owned(), number));
        for (head, expected) in [
            ("조사일", Some(Held::Date)),
            ("Date", Some(Held::Date)),
            ("기온(℃)", Some(Held::Temperature)),
            ("X 진동수(Hz)", frequency("x", 1)),
            ("x방향 2차 고유진동수 (Hz)", frequency("x", 2)),
            ("Y진동수", frequency("y", 1)),
            ("fx1", frequency("x", 1)),
            ("f2 (Hz)", frequency("other", 2)),
            ("mode 3", frequency("other", 3)),
            ("frequency_torsion", frequency("torsion", 1)),
            ("비틀림 모드 진동수", frequency("torsion", 1)),
            ("frequency x 1 sd", Some(Held::FrequencySd("x".to_owned(), 1))),
            ("X 진동수 표준편차", Some(Held::FrequencySd("x".to_owned(), 1))),
            ("기울기 X(mm/m)", Some(Held::Tilt("x".to_owned()))),
            (
                "균열 C1 @ 3층 탑신 (mm)",
                Some(Held::Crack("C1".to_owned(), "3층 탑신".to_owned())),
            ),
            (
                "Crack width c2 @ Shaft 2 [mm]",
                Some(Held::Crack("c2".to_owned(), "Shaft 2".to_owned())),
            ),
            ("비고", Some(Held::Note)),
            ("조사자", None),
            ("날씨", None),
            ("기울기", None),
            ("fault", None),
            ("진동수 x 1 2", None),
            ("", None),
        ] {
            assert_eq!(held(with_unit(head).0), expected, "{head}");
        }
        assert_eq!(with_unit("기울기 X(mm/m)"), ("기울기 X", Some("mm/m")));
    }
}
