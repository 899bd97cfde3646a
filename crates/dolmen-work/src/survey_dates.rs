//! When a survey was, as its name says.

/// The date that a survey's name begins with: "2019", "2019-04" or "2019-04-02", what is missing 0.
pub fn date(name: &str) -> Option<[u32; 3]> {
    let mut parts = name.splitn(3, '-');
    let year = parts.next().filter(|y| y.len() == 4)?.parse().ok()?;
    let mut part = |most: u32| {
        let text = parts.next()?;
        let digits: String = text.chars().take_while(char::is_ascii_digit).collect();
        digits
            .parse()
            .ok()
            .filter(|n| digits.len() == 2 && (1..=most).contains(n))
    };
    let month = part(12);
    let day = month.and_then(|_| part(31));
    Some([year, month.unwrap_or(0), day.unwrap_or(0)])
}
