//! Removes passwords from printed text, wherever an address was typed by mistake.

use std::borrow::Cow;

/// Replacement for a password.
const HIDDEN: &str = "…";

/// A text without the passwords of addresses like postgresql://ROLE:PASSWORD@HOST and ?password=PASSWORD.
pub(crate) fn without_passwords(text: &str) -> Cow<'_, str> {
    if !text.contains("postgres") {
        return Cow::Borrowed(text);
    }
    let mut plain = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = ["postgresql:/", "postgres:/"]
        .iter()
        .filter_map(|scheme| rest.find(scheme))
        .min()
    {
        let (before, address) = rest.split_at(at);
        let end = address
            .find([' ', '\n', '\t', '"', '\''])
            .unwrap_or(address.len());
        let (address, behind) = address.split_at(end);
        plain.push_str(before);
        plain.push_str(&hidden(address));
        rest = behind;
    }
    plain.push_str(rest);
    Cow::Owned(plain)
}

/// An address without its password.
fn hidden(address: &str) -> String {
    let (address, parameter) = match address.split_once("password=") {
        Some((before, after)) => {
            let rest = after.find('&').map_or("", |end| &after[end..]);
            (before, format!("password={HIDDEN}{rest}"))
        }
        None => (address, String::new()),
    };
    let scheme = address.find('/').unwrap_or(0);
    let colon = address[scheme..].find(':').map(|at| scheme + at);
    match (colon, address.rfind('@')) {
        (Some(colon), Some(at)) if colon < at => {
            format!("{}:{HIDDEN}{}{parameter}", &address[..colon], &address[at..])
        }
        _ => format!("{address}{parameter}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_no_password_is_left() {
        for (text, plain) in [
            ("nothing", "nothing"),
            ("postgres is down", "postgres is down"),
            (
                "argument 'postgresql://kim:s3@cret@h:5/d' found",
                "argument 'postgresql://kim:…@h:5/d' found",
            ),
            (
                "postgres://kim:s3cret@h/d and postgresql:/u:s3cret@h",
                "postgres://kim:…@h/d and postgresql:/u:…@h",
            ),
            (
                "postgresql:///d?password=s3cret&host=/tmp",
                "postgresql:///d?password=…&host=/tmp",
            ),
            (
                "postgresql://kim@localhost:5433/d",
                "postgresql://kim@localhost:5433/d",
            ),
        ] {
            assert_eq!(without_passwords(text), plain);
        }
    }
}
