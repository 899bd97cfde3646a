//! The mark in pages and figures by which Dolmen recognises its own files.

/// Name of the program in a page, as in `<meta name="generator" content="Dolmen">`.
pub(crate) const GENERATOR: &str = "Dolmen";
/// The comment in a figure.
pub(crate) const FIGURE_MARK: &str = "<!-- Dolmen -->";
/// The mark of a page as bytes.
const PAGE_MARK: &str = "name=\"generator\" content=\"Dolmen\"";
/// Number of bytes at the beginning that contain the mark.
const LOOKED_AT: usize = 1000;

/// Whether bytes are a page or a figure from Dolmen, judged by the first thousand.
pub fn is_marked(bytes: &[u8]) -> bool {
    let start = &bytes[..bytes.len().min(LOOKED_AT)];
    let holds = |mark: &str| start.windows(mark.len()).any(|part| part == mark.as_bytes());
    start.starts_with(b"<") && (holds(PAGE_MARK) || holds(FIGURE_MARK))
}
