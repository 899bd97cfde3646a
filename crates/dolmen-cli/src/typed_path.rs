//! Paths as users type them.

/// A path to paste into a shell: in double quotes, which all shells accept, if it needs any.
pub(crate) fn for_a_shell(path: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "_-./\\:+,@".contains(c);
    let is_quotable = |c: char| !"\"$`!".contains(c);
    match (path.chars().all(is_plain), path.chars().all(is_quotable)) {
        (true, _) => path.to_owned(),
        (false, true) => format!("\"{path}\""),
        (false, false) => format!("'{}'", path.replace('\'', "'\\''")),
    }
}
