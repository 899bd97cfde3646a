//! The mark that pages and figures carry, by which Dolmen knows its own again.

/// What a page says of who made it, as in `<meta name="generator" content="Dolmen">`.
pub(crate) const GENERATOR: &str = "Dolmen";
/// The comment in a figure.
pub(crate) const FIGURE_MARK: &str = "<!-- Dolmen -->";
/// The mark of a page, as it stands in its bytes.
const PAGE_MARK: &str = "name=\"generator\" content=\"Dolmen\"";
/// Bytes from the beginning within which a mark stands.
const LOOKED_AT: usize = 1000;

/// Whether bytes are a page or a figure that Dolmen wrote, by their first thousand.
pub fn is_marked(bytes: &[u8]) -> bool {
    let start = &bytes[..bytes.len().min(LOOKED_AT)];
    let holds = |mark: &str| start.windows(mark.len()).any(|part| part == mark.as_bytes());
    start.starts_with(b"<") && (holds(PAGE_MARK) || holds(FIGURE_MARK))
}
