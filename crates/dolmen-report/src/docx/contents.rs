//! The contents: a field with its present entries.

use super::inline::{instruct, paragraph, said, tab, words};
use crate::paper::xml::Xml;
use crate::paper::{Heading, Ink, Paper};
use dolmen_words::Language;

/// The bookmark of the heading with this number.
pub(super) fn mark(number: usize) -> String {
    format!("_Toc{number:06}")
}

/// Contents of two levels. Page numbers are fields without a value until the document is laid out.
pub(super) fn contents(xml: &mut Xml, paper: &Paper, language: Language) {
    let entries: Vec<&Heading> = paper.entries().collect();
    xml.element("w:sdt", &[], |xml| {
        xml.element("w:sdtPr", &[], |xml| {
            xml.element("w:docPartObj", &[], |xml| {
                xml.leaf("w:docPartGallery", &[("w:val", "Table of Contents")]);
                xml.leaf("w:docPartUnique", &[]);
            });
        });
        xml.element("w:sdtContent", &[], |xml| {
            said(xml, "TOCHeading", language.pick("Contents", "목차"));
            for (at, entry) in entries.iter().enumerate() {
                let style = format!("TOC{}", entry.level);
                paragraph(
                    xml,
                    &style,
                    |_| (),
                    |xml| {
                        if at == 0 {
                            mark_of_field(xml, "begin");
                            instruct(xml, "TOC \\o \"1-2\" \\h \\z");
                            mark_of_field(xml, "separate");
                        }
                        line(xml, entry);
                        if at + 1 == entries.len() {
                            mark_of_field(xml, "end");
                        }
                    },
                );
            }
        });
    });
}

fn line(xml: &mut Xml, entry: &Heading) {
    let mark = mark(entry.place);
    let link = [("w:anchor", mark.as_str()), ("w:history", "1")];
    xml.element("w:hyperlink", &link, |xml| {
        words(xml, &entry.number, Ink::PLAIN);
        tab(xml);
        words(xml, &entry.head, Ink::PLAIN);
        tab(xml);
        mark_of_field(xml, "begin");
        instruct(xml, &format!("PAGEREF {mark} \\h"));
        mark_of_field(xml, "separate");
        mark_of_field(xml, "end");
    });
}

fn mark_of_field(xml: &mut Xml, what: &str) {
    xml.element("w:r", &[], |xml| {
        xml.leaf("w:fldChar", &[("w:fldCharType", what)])
    });
}
