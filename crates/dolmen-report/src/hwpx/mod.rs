//! A report as a Hangul document (HWPX, KS X 6101), the format that Korean authorities file, for editing and reuse.

mod equation;
mod header;
mod lines;
mod looks;
mod package;
mod picture;
mod section;
mod spaces;
mod table;

#[cfg(test)]
mod tests;

use crate::html::{Imprint, NotReported};
use crate::paper::{PaperFault, paper};
use dolmen_words::Language;
use dolmen_work::answer::ProjectReport;
use section::Writer;

/// The report on one or more projects as the bytes of an HWPX file; `paint` makes a PNG of a figure's SVG.
///
/// Headings are the outline of Hangul and are numbered automatically; body, captions and tables have their own styles, and table heads repeat on
/// the next page. Caption numbers are plain text. The contents list headings without pages (Hangul makes its own from the outline). Photographs
/// keep the bytes of their files. The same input gives the same bytes.
///
/// # Errors
/// [`PaperFault`].
pub fn hwpx(
    answers: &[ProjectReport],
    others: &[NotReported],
    language: Language,
    imprint: &Imprint,
    paint: &dyn Fn(&str) -> Result<Vec<u8>, String>,
) -> Result<Vec<u8>, PaperFault> {
    let paper = paper(answers, others, language, imprint, paint)?;
    let mut writer = Writer::new(&paper, language);
    for piece in &paper.pieces {
        writer.put(piece);
    }
    let (sections, looks, text) = writer.finish();
    package::pack(&paper, language, sections, &looks, text)
}
