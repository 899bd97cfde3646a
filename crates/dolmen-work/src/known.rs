//! What there is, in an error that names what there is not.

/// The names, or "none".
pub(crate) fn or_none(known: &str) -> &str {
    match known {
        "" => "none",
        known => known,
    }
}
