//! Symbols whose second part is a subscript: k_cr, S_DS.

/// The symbols, as they stand in sentences.
pub(crate) const LOWERED: [&str; 12] = [
    "k_cr", "k_min", "K_n", "K_s", "a_z", "I_u", "d_SLV", "T_SLV", "S_DS", "S_D1", "S_a", "S_v",
];

/// A stretch of words.
pub(crate) struct Stretch {
    pub(crate) words: String,
    /// Whether it is a subscript.
    pub(crate) is_lowered: bool,
}

/// Text as spans on the line.
pub(crate) fn stretches_of(text: &str) -> Vec<Stretch> {
    let mut stretches = Vec::new();
    let mut add = |words: String, is_lowered| {
        if !words.is_empty() {
            stretches.push(Stretch { words, is_lowered });
        }
    };
    let mut rest = text;
    while let Some((at, symbol)) = first_symbol(rest) {
        let (before, behind) = rest.split_at(at);
        let (letter, index) = symbol.split_once('_').unwrap_or((symbol, ""));
        add(format!("{before}{letter}"), false);
        add(index.to_owned(), true);
        rest = behind.strip_prefix(symbol).unwrap_or_default();
    }
    add(rest.to_owned(), false);
    stretches
}

/// Text or markup with its symbols lowered by `set`.
pub(crate) fn with_lowered(text: &str, set: impl Fn(&str) -> String) -> String {
    let each = stretches_of(text).into_iter().map(|of| match of.is_lowered {
        true => set(&of.words),
        false => of.words,
    });
    each.collect()
}

/// The first symbol that is a word of its own: a user's name may contain its letters.
fn first_symbol(text: &str) -> Option<(usize, &'static str)> {
    let is_of_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let stands = |at: usize, symbol: &str| {
        let (before, behind) = (&text[..at], &text[at + symbol.len()..]);
        !before.ends_with(is_of_word) && !behind.starts_with(is_of_word)
    };
    let found = LOWERED.iter().filter_map(|symbol| {
        let mut places = text.match_indices(symbol);
        let (at, _) = places.find(|(at, _)| stands(*at, symbol))?;
        Some((at, *symbol))
    });
    found.min()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_the_second_part_of_a_symbol_stands_lower() {
        let low = |text: &str| with_lowered(text, |index| format!("[{index}]"));
        assert_eq!(low("M > k_cr; k_min."), "M > k[cr]; k[min].");
        assert_eq!(low("S_DS, S_D1 and S_a(T)"), "S[DS], S[D1] and S[a](T)");
        assert_eq!(low("channel S_axis, K_north"), "channel S_axis, K_north");
    }
}
