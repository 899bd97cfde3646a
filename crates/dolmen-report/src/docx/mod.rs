//! A report as a document for Word, Hangul and LibreOffice (DOCX), for editing and reuse.

mod contents;
mod equation;
mod inline;
mod look;
mod numbering;
mod package;
mod picture;
mod pieces;
mod table;

#[cfg(test)]
mod tests;

use crate::html::{Imprint, NotReported};
use crate::paper::xml::Xml;
use crate::paper::{Ink, paper};
use dolmen_words::Language;
use dolmen_work::answer::ProjectReport;
use inline::{field, words};
use package::{Package, running};
use pieces::{put, section};

pub use crate::paper::PaperFault;

/// The report on one or more projects as the bytes of a DOCX file; `paint` makes a PNG of a figure's SVG.
///
/// Headings, captions, tables and body have their own styles. Headings are numbered automatically, captions by fields, and the contents are a
/// field with its entries. Each project begins with a cover; a report on one project has contents. Figures are PNG together with the SVG. The
/// same input gives the same bytes.
///
/// # Errors
/// [`PaperFault`].
pub fn docx(
    answers: &[ProjectReport],
    others: &[NotReported],
    language: Language,
    imprint: &Imprint,
    paint: &dyn Fn(&str) -> Result<Vec<u8>, String>,
) -> Result<Vec<u8>, PaperFault> {
    let paper = paper(answers, others, language, imprint, paint)?;
    let mut document = Xml::document();
    let spaces = [
        ("xmlns:w", look::W),
        ("xmlns:m", equation::M),
        (
            "xmlns:r",
            "http://schemas.openxmlformats.org/officeDocument/2006/relationships",
        ),
        (
            "xmlns:wp",
            "http://schemas.openxmlformats.org/drawingml/2006/wordprocessingDrawing",
        ),
    ];
    document.element("w:document", &spaces, |xml| {
        xml.element("w:body", &[], |xml| {
            for piece in &paper.pieces {
                put(xml, piece, &paper, language);
            }
            section(xml);
        });
    });
    let package = Package {
        body: document,
        header: running("w:hdr", "Header", &paper.title, |xml| {
            words(xml, paper.kind, Ink::PLAIN);
        }),
        footer: running("w:ftr", "Footer", &paper.program, |xml| {
            field(xml, "PAGE", "", Ink::PLAIN);
            words(xml, " / ", Ink::PLAIN);
            field(xml, "NUMPAGES", "", Ink::PLAIN);
        }),
        paper,
    };
    package.pack(language)
}
