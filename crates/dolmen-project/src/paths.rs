//! Paths of values of a file.

/// The parts of `links[2].weight`: links, 2, weight; `None` if it is not a path.
pub(super) fn keys(path: &str) -> Option<Vec<&str>> {
    let mut keys = Vec::new();
    for part in path.split('.') {
        let (name, mut rest) = part.split_at(part.find('[').unwrap_or(part.len()));
        let is_word = |c: char| c.is_alphanumeric() || matches!(c, '_' | '-');
        if name.is_empty() || !name.chars().all(is_word) {
            return None;
        }
        keys.push(name);
        while !rest.is_empty() {
            let (number, behind) = rest.strip_prefix('[')?.split_once(']')?;
            if number.is_empty() || !number.bytes().all(|b| b.is_ascii_digit()) {
                return None;
            }
            keys.push(number);
            rest = behind;
        }
    }
    Some(keys)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_paths() {
        assert_eq!(keys("links[2].weight").unwrap(), ["links", "2", "weight"]);
        assert_eq!(
            keys("direction.weak.stiffness[1]").unwrap(),
            ["direction", "weak", "stiffness", "1"]
        );
        for wrong in ["", ".a", "a.", "a[", "a[x]", "a[]b", "a b", "a[1]b"] {
            assert!(keys(wrong).is_none(), "{wrong}");
        }
    }
}
