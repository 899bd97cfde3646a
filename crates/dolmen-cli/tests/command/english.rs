//! English sentences within Korean ones.

/// The first three consecutive English words outside quotes; the first of them may begin a sentence.
pub(crate) fn english_in(text: &str) -> Option<String> {
    const UNITS: [&str; 5] = ["mm", "mrad", "rad", "kg", "deg"];
    let is_word =
        |word: &str| word.len() > 1 && word.bytes().all(|b| b.is_ascii_lowercase()) && !UNITS.contains(&word);
    let begins =
        |word: &str| is_word(&word.to_ascii_lowercase()) && (word.len() < 2 || is_word(&word[1..].repeat(2)));
    let mut quoted = false;
    let words: Vec<&str> = text
        .split_whitespace()
        .map(|word| {
            let own = quoted || word.contains(['‘', '“', '`', '"']);
            quoted ^= word.chars().filter(|c| "‘’“”`\"".contains(*c)).count() % 2 == 1;
            let bare = word.trim_matches([',', '.', ';', ':', '(', ')']);
            if own { "" } else { bare }
        })
        .collect();
    let three = |three: &&[&str]| begins(three[0]) && three[1..].iter().all(|word| is_word(word));
    words.windows(3).find(three).map(|three| three.join(" "))
}
