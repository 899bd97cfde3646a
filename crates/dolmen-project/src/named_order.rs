//! Lists of parts that begin with the top, by the names of the parts.

/// Beginnings of words, and Korean words, of the lowest part of a structure.
const FEET: [&str; 12] = [
    "base",
    "foundation",
    "footing",
    "plinth",
    "pedestal",
    "기단",
    "지대석",
    "기초",
    "초석",
    "하대석",
    "대좌",
    "지복석",
];
/// The same of the highest part.
const TOPS: [&str; 15] = [
    "roof", "cap", "capstone", "finial", "spire", "crown", "pinnacle", "top", "옥개", "상륜", "보주", "지붕",
    "보륜", "노반", "복발",
];

/// Whether names say that a list begins with the top: a roof first and a base last, or storeys that only count down.
pub(crate) fn begins_with_top(names: &[&str]) -> bool {
    let [first, .., last] = names else { return false };
    let is_only = |name: &str, of: &[&str], not: &[&str]| has(name, of) && !has(name, not);
    if is_only(first, &TOPS, &FEET) && is_only(last, &FEET, &TOPS) {
        return true;
    }
    let storeys: Vec<u32> = names.iter().filter_map(|name| storey(name)).collect();
    let counts_down = storeys.windows(2).all(|pair| pair[0] >= pair[1]);
    storeys.len() == names.len() && counts_down && storeys.first() > storeys.last()
}

/// Beginnings of words, and Korean words, of the upper and of the lower storeys of a frame.
const UPPER: [&str; 5] = ["upper", "roof", "상층", "상부", "지붕"];
const LOWER: [&str; 6] = ["lower", "ground", "bottom", "하층", "하부", "지층"];

/// The same for the storeys of a frame, which are also called the upper and the lower one.
pub(crate) fn storeys_begin_with_top(names: &[&str]) -> bool {
    let [first, .., last] = names else { return false };
    let is_lower = |name: &str| has(name, &LOWER);
    let is_upper = |name: &str| has(name, &UPPER) && !is_lower(name);
    begins_with_top(names) || is_upper(first) && is_lower(last)
}

/// Whether a name has one of the words: English ones whole, with an optional "-stone" or plural behind, Korean ones anywhere.
fn has(name: &str, words: &[&str]) -> bool {
    let name = name.to_lowercase();
    let own: Vec<&str> = name.split(|sign: char| !sign.is_alphanumeric()).collect();
    words.iter().any(|word| match word.is_ascii() {
        true => own.iter().any(|own| {
            let rest = own.strip_prefix(word);
            rest.is_some_and(|rest| ["", "s", "stone"].contains(&rest) || rest.parse::<u32>().is_ok())
        }),
        false => name.contains(word),
    })
}

/// The storey in a name: "2층 탑신", "storey 2".
fn storey(name: &str) -> Option<u32> {
    let name = name.to_lowercase();
    let before = name.split_once('층').map(|(before, _)| before.trim_end());
    if let Some(before) = before {
        let start = before.trim_end_matches(|sign: char| sign.is_ascii_digit()).len();
        return before[start..].parse().ok();
    }
    let words: Vec<&str> = name.split_whitespace().collect();
    let pair = words
        .windows(2)
        .find(|pair| ["storey", "story", "floor", "level", "tier"].contains(&pair[0]))?;
    pair[1].parse().ok()
}

#[cfg(test)]
mod tests {
    use super::{begins_with_top, storeys_begin_with_top};

    #[test]
    fn holds_names_tell_a_list_that_begins_with_the_top() {
        for (names, says) in [
            (vec!["roof", "body", "base"], true),
            (vec!["1층 옥개석", "1층 탑신", "기단"], true),
            (vec!["상륜", "탑신", "기단"], true),
            (vec!["Capstone 1", "shaft", "foundation"], true),
            (vec!["3층 탑신", "2층 탑신", "1층 탑신"], true),
            (vec!["storey 2", "storey 1"], true),
            (vec!["base", "body", "roof"], false),
            (vec!["기단", "1층 탑신", "1층 옥개석"], false),
            (vec!["top of the base", "shaft", "base"], false),
            (vec!["3층 탑신", "비신", "1층 탑신"], false),
            (vec!["capital", "shaft", "base"], false),
            (vec!["1층 탑신", "1층 탑신 2"], false),
            (vec!["roof"], false),
        ] {
            assert_eq!(begins_with_top(&names), says, "{names:?}");
        }
    }
    #[test]
    fn holds_names_of_storeys_tell_a_list_that_begins_with_the_top() {
        for (names, says) in [
            (vec!["2층", "1층"], true),
            (vec!["상층", "하층"], true),
            (vec!["upper storey", "lower storey"], true),
            (vec!["upper roof", "lower roof"], true),
            (vec!["roof", "mezzanine", "ground floor"], true),
            (vec!["1층", "2층"], false),
            (vec!["하층", "상층"], false),
            (vec!["lower roof", "upper roof"], false),
            (vec!["1", "2"], false),
            (vec!["gate", "pavilion"], false),
            (vec!["상층"], false),
        ] {
            assert_eq!(storeys_begin_with_top(&names), says, "{names:?}");
        }
    }
}
