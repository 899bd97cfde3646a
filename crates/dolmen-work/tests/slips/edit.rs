//! A mistake as an edit of the text of a project file.

/// A row of `data/slips.csv`.
pub(crate) struct Slip {
    /// Kind of mistake.
    pub(crate) class: String,
    /// The project file.
    pub(crate) file: String,
    /// replace (the first), all, scale (every number of a key), reverse (a list), mirror (centroids from the top), swap, flag.
    pub(crate) edit: String,
    /// The text to find; for a flag, the motion.
    pub(crate) find: String,
    /// Its replacement; for a flag, its value.
    pub(crate) replace: String,
    /// Required part of the error or warning.
    pub(crate) says: String,
}

/// The text with the mistake.
pub(crate) fn edited(text: &str, slip: &Slip) -> String {
    let (find, replace) = (slip.find.as_str(), slip.replace.as_str());
    let changed = match slip.edit.as_str() {
        "replace" => text.replacen(find, replace, 1),
        "all" => text.replace(find, replace),
        "scale" => scaled(text, find, replace.parse().unwrap()),
        "reverse" => reversed(text, find),
        "mirror" => mirrored(text),
        "swap" => {
            let kept = text.replace(find, "\u{1}").replace(replace, find);
            kept.replace('\u{1}', replace)
        }
        "flag" => return text.to_owned(),
        other => panic!("edit {other}"),
    };
    assert_ne!(changed, text, "{}: {find} is not there", slip.file);
    changed
}

/// The end of a number that begins at a byte.
fn end_of_number(text: &str, from: usize) -> usize {
    let is_number = |c: char| c.is_ascii_digit() || c == '.';
    text[from..]
        .find(|c| !is_number(c))
        .map_or(text.len(), |length| from + length)
}

/// Multiplies every number of a key, bare, in a list or with its evidence, by a factor.
fn scaled(text: &str, key: &str, factor: f64) -> String {
    let mut out = String::new();
    let mut rest = text;
    let head = format!("{key} = ");
    while let Some(at) = rest.find(&head) {
        let before = rest[..at].chars().next_back();
        let mut from = at + head.len();
        for opening in ["{ value = ", "["] {
            if rest[from..].starts_with(opening) {
                from += opening.len();
            }
        }
        let end = end_of_number(rest, from);
        out += &rest[..from];
        match rest[from..end].parse::<f64>() {
            Ok(value) if !before.is_some_and(|c| c.is_alphanumeric() || c == '_') => {
                out += &format!("{}", value * factor);
            }
            _ => out += &rest[from..end],
        }
        rest = &rest[end..];
        // the second number of a list
        if out.ends_with(|c: char| c.is_ascii_digit())
            && rest.starts_with(", ")
            && rest[2..].starts_with(|c: char| c.is_ascii_digit())
        {
            let end = end_of_number(rest, 2);
            let second: f64 = rest[2..end].parse().unwrap();
            out += &format!(", {}", second * factor);
            rest = &rest[end..];
        }
    }
    out + rest
}

/// Reverses every list of a key with one entry per line.
fn reversed(text: &str, key: &str) -> String {
    let mut out: Vec<&str> = Vec::new();
    let mut list: Option<Vec<&str>> = None;
    for line in text.lines() {
        match &mut list {
            Some(entries) if line == "]" => {
                out.extend(entries.iter().rev());
                out.push(line);
                list = None;
            }
            Some(entries) => entries.push(line),
            None => {
                out.push(line);
                if line == format!("{key} = [") {
                    list = Some(Vec::new());
                }
            }
        }
    }
    out.join("\n") + "\n"
}

/// Centres of mass of links measured from their tops.
fn mirrored(text: &str) -> String {
    let number = |line: &str, key: &str| -> Option<(usize, usize, f64)> {
        let from = line.find(key)? + key.len();
        let end = end_of_number(line, from);
        Some((from, end, line[from..end].parse().ok()?))
    };
    let of = |line: &str| {
        let (_, _, length) = number(line, "length = ")?;
        let (from, end, centroid) = number(line, "centroid = ")?;
        Some(format!(
            "{}{:.4}{}",
            &line[..from],
            length - centroid,
            &line[end..]
        ))
    };
    let each = text
        .lines()
        .map(|line| of(line).unwrap_or_else(|| line.to_owned()));
    each.collect::<Vec<_>>().join("\n") + "\n"
}
