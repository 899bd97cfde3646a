//! A report as a document for Word, Hangul and LibreOffice (DOCX): to be edited and used again.

mod body;
mod contents;
mod fault;
mod inline;
mod look;
mod numbering;
mod package;
mod parts;
mod picture;
mod table;
mod xml;

#[cfg(test)]
mod tests;

use crate::document::Numbers;
use crate::engineer::date_of;
use crate::html::front::kind_words;
use crate::html::{Imprint, NotReported, day, project_name};
pub use fault::DocxFault;

use body::Body;
use dolmen_words::Language;
use dolmen_work::answer::ProjectReport;
use inline::{Ink, field, words};
use package::{Package, running};
use picture::Media;
use xml::Xml;

/// The report on one or more projects as the bytes of a DOCX file; `paint` makes a PNG of a figure's SVG.
///
/// Heads, captions, tables and body have styles of their own; heads number themselves, captions count by fields, contents are a field with its
/// entries. Each project begins with a cover; contents follow where there is one project. Figures are PNG with the SVG beside. The same input
/// gives the same bytes.
///
/// # Errors
/// [`DocxFault`].
pub fn docx(
    answers: &[ProjectReport],
    others: &[NotReported],
    language: Language,
    imprint: &Imprint,
    paint: &dyn Fn(&str) -> Result<Vec<u8>, String>,
) -> Result<Vec<u8>, DocxFault> {
    let (title, kind) = match (answers, others) {
        ([one], []) => (
            project_name(one, language),
            kind_words(&one.project.structure, language),
        ),
        _ => (language.pick("Reports", "보고서 모음"), ""),
    };
    let date = match answers {
        [one] => date_of(one, imprint),
        _ => imprint.date.as_deref(),
    };
    let mut body = Body {
        language,
        front: Xml::default(),
        xml: Xml::default(),
        media: Media::new(paint),
        numbers: Numbers::alone(),
        entries: Vec::new(),
        deeper: 0,
        marks: 0,
    };
    let alone = answers.len() == 1;
    for (at, answer) in answers.iter().enumerate() {
        if at > 0 {
            body.end_section();
        }
        body.project(answer, imprint, (!alone).then_some(at + 1))?;
    }
    body.not_reported(others, answers.len());
    let mut document = Xml::document();
    let spaces = [
        ("xmlns:w", look::W),
        (
            "xmlns:r",
            "http://schemas.openxmlformats.org/officeDocument/2006/relationships",
        ),
        (
            "xmlns:wp",
            "http://schemas.openxmlformats.org/drawingml/2006/wordprocessingDrawing",
        ),
    ];
    let (text, media) = body.finish(alone);
    document.element("w:document", &spaces, |xml| {
        xml.element("w:body", &[], |xml| {
            xml.append(text);
            parts::section(xml);
        });
    });
    let package = Package {
        title: title.to_owned(),
        program: imprint.program.clone(),
        date: date.filter(|date| day(Some(date)).is_some()).map(str::to_owned),
        body: document,
        header: running("w:hdr", "Header", title, |xml| words(xml, kind, Ink::PLAIN)),
        footer: running("w:ftr", "Footer", &imprint.program, |xml| {
            field(xml, "PAGE", "", Ink::PLAIN);
            words(xml, " / ", Ink::PLAIN);
            field(xml, "NUMPAGES", "", Ink::PLAIN);
        }),
        media,
        with_contents: alone,
    };
    package.pack(language)
}
