//! Headings of tables: detects misspelt known columns, so that they are not ignored as unknown ones.

/// Latin words with at least this many letters may differ in two, and with at least the next number in one. Our choice.
const LETTERS_OF_TWO: usize = 7;
const LETTERS_OF_ONE: usize = 4;
/// Korean words with at least this many syllables may differ in one: words of two are too similar (높이, 깊이). Our choice.
const SYLLABLES_OF_ONE: usize = 3;
/// Units at the end of a heading: "width_mm".
const UNITS: [&str; 11] = ["m", "mm", "cm", "kn", "n", "kg", "t", "deg", "g", "rad", "kn/m3"];

/// Whether a heading probably means the known column: it differs in some letters, is its beginning, or has a unit at its end.
pub fn is_misspelt(head: &str, known: &str) -> bool {
    let plain = |text: &str| -> Vec<char> {
        let text = text.to_lowercase();
        text.chars()
            .filter(|sign| !sign.is_whitespace() && !"_-./".contains(*sign))
            .collect()
    };
    let (written, meant) = (plain(head), plain(known));
    if written == meant {
        return true;
    }
    let is_latin = meant.iter().chain(&written).all(char::is_ascii);
    let shorter = written.len().min(meant.len());
    let most = match is_latin {
        true if shorter >= LETTERS_OF_TWO => 2,
        true => usize::from(shorter >= LETTERS_OF_ONE),
        false => usize::from(shorter >= SYLLABLES_OF_ONE),
    };
    if apart(&written, &meant) <= most {
        return true;
    }
    let lower = head.trim().to_lowercase();
    let with_unit = lower
        .rsplit_once(['_', ' '])
        .is_some_and(|(name, unit)| UNITS.contains(&unit) && plain(name) == meant);
    with_unit || (is_latin && shorter >= LETTERS_OF_ONE && meant.starts_with(&written))
}

/// Number of letters to change, insert, remove or swap with their neighbour.
///
/// # Source
/// Damerau, F. J. (1964) CACM 7(3):171–176; Wagner and Fischer (1974) JACM 21(1):168–173.
fn apart(a: &[char], b: &[char]) -> usize {
    let mut before: Vec<usize> = Vec::new();
    let mut above: Vec<usize> = (0..=b.len()).collect();
    for (i, one) in a.iter().enumerate() {
        let mut row = vec![i + 1];
        for (j, other) in b.iter().enumerate() {
            let mut least = (above[j] + usize::from(one != other))
                .min(above[j + 1] + 1)
                .min(row[j] + 1);
            if i > 0 && j > 0 && a[i - 1] == *other && *one == b[j - 1] {
                least = least.min(before[j - 1] + 1);
            }
            row.push(least);
        }
        before = std::mem::replace(&mut above, row);
    }
    above.last().copied().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn published_distances_of_words() {
        let of = |a: &str, b: &str| apart(&a.chars().collect::<Vec<_>>(), &b.chars().collect::<Vec<_>>());
        // Wikipedia, Levenshtein distance: kitten and sitting 3; Damerau: a swap of neighbours is 1
        assert_eq!(of("kitten", "sitting"), 3);
        assert_eq!(of("saturday", "sunday"), 3);
        assert_eq!((of("hieght", "height"), of("", "abc"), of("abc", "")), (1, 3, 3));
    }

    #[test]
    fn holds_misspelt_heads_are_told_from_columns_of_other_things() {
        for (head, known) in [
            ("densty", "density"),
            ("Hieght", "height"),
            ("stories", "storeys"),
            ("width_mm", "width"),
            ("zone", "zone_factor_g"),
            ("body_height", "body_height_m"),
            ("체감률", "체감각"),
            ("상부 폭", "상부폭"),
        ] {
            assert!(is_misspelt(head, known), "{head}, {known}");
        }
        for (head, known) in [
            ("비고", "밀도"),
            ("번호", "변수"),
            ("지역", "지역계수"),
            ("높이", "깊이"),
            ("note", "name"),
            ("No.", "name"),
            ("color", "soil"),
            ("material", "name"),
            ("위도", "밀도"),
            ("name_en", "name"),
        ] {
            assert!(!is_misspelt(head, known), "{head}, {known}");
        }
    }
}
