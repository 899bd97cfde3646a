//! Typesets a report as PDF, with Typst. Opens no file; its fonts, Pretendard Regular, SemiBold and Bold, are
//! compiled in.

mod sheets;
mod world;

pub use sheets::{NotPrinted, Printed, Sheets};

use typst::diag::SourceDiagnostic;
use typst::layout::PagedDocument;
use typst_pdf::{PdfOptions, PdfStandard, PdfStandards};
use world::Desk;

/// The document as PDF: PDF/A-2a if possible, otherwise a tagged PDF 1.7. The same source gives the same
/// bytes.
///
/// # Errors
/// If the source is not a Typst document.
pub fn pdf(sheets: Sheets) -> Result<Printed, NotPrinted> {
    let desk = Desk::new(sheets);
    let document = typst::compile::<PagedDocument>(&desk)
        .output
        .map_err(|faults| not_printed(&faults))?;
    let archival = PdfStandards::new(&[PdfStandard::A_2a]).map_err(|fault| NotPrinted(fault.to_string()))?;
    let options = PdfOptions {
        standards: archival,
        ..PdfOptions::default()
    };
    let first = typst_pdf::pdf(&document, &options);
    let is_archival = first.is_ok();
    let bytes = match first {
        Ok(bytes) => bytes,
        Err(_) => typst_pdf::pdf(&document, &PdfOptions::default()).map_err(|faults| not_printed(&faults))?,
    };
    Ok(Printed {
        bytes,
        is_archival,
        without_glyph: desk.without_glyph(),
    })
}

fn not_printed(faults: &[SourceDiagnostic]) -> NotPrinted {
    let each: Vec<String> = faults
        .iter()
        .take(3)
        .map(|fault| fault.message.to_string())
        .collect();
    NotPrinted(each.join("; "))
}

#[cfg(test)]
mod tests;
