//! Runs of a paragraph: words, fields, and figures.

use crate::lowered::{Stretch, stretches_of};
use crate::paper::Ink;
use crate::paper::xml::Xml;

/// Emphasis of a run; `lowered` is a subscript.
fn look(ink: Ink, xml: &mut Xml, lowered: bool) {
    if !ink.bold && ink.colour.is_none() && !lowered {
        return;
    }
    xml.element("w:rPr", &[], |xml| {
        if ink.bold {
            xml.leaf("w:b", &[]);
            xml.leaf("w:bCs", &[]);
        }
        if let Some(colour) = ink.colour {
            xml.leaf("w:color", &[("w:val", colour)]);
        }
        if lowered {
            xml.leaf("w:vertAlign", &[("w:val", "subscript")]);
        }
    });
}

/// Words of a paragraph.
pub(super) fn words(xml: &mut Xml, text: &str, ink: Ink) {
    for Stretch { words, is_lowered } in stretches_of(text) {
        run(xml, &words, ink, is_lowered);
    }
}

fn run(xml: &mut Xml, text: &str, ink: Ink, low: bool) {
    if text.is_empty() {
        return;
    }
    xml.element("w:r", &[], |xml| {
        look(ink, xml, low);
        xml.words("w:t", &[("xml:space", "preserve")], text);
    });
}

pub(super) fn tab(xml: &mut Xml) {
    xml.element("w:r", &[], |xml| xml.leaf("w:tab", &[]));
}

/// A field that the reader's program updates, with its present value.
pub(super) fn field(xml: &mut Xml, instruction: &str, now: &str, ink: Ink) {
    let part = |xml: &mut Xml, what: &str| {
        xml.element("w:r", &[], |xml| {
            look(ink, xml, false);
            xml.leaf("w:fldChar", &[("w:fldCharType", what)]);
        });
    };
    part(xml, "begin");
    instruct(xml, instruction);
    part(xml, "separate");
    run(xml, now, ink, false);
    part(xml, "end");
}

/// The instruction of a field.
pub(super) fn instruct(xml: &mut Xml, instruction: &str) {
    xml.element("w:r", &[], |xml| {
        xml.words(
            "w:instrText",
            &[("xml:space", "preserve")],
            &format!(" {instruction} "),
        );
    });
}

/// A paragraph of a style: `more` adds to its properties, in the order of the schema.
pub(super) fn paragraph(
    xml: &mut Xml,
    style: &str,
    more: impl FnOnce(&mut Xml),
    inside: impl FnOnce(&mut Xml),
) {
    xml.element("w:p", &[], |xml| {
        xml.element("w:pPr", &[], |xml| {
            xml.leaf("w:pStyle", &[("w:val", style)]);
            more(xml);
        });
        inside(xml);
    });
}

/// A paragraph of words alone.
pub(super) fn said(xml: &mut Xml, style: &str, text: &str) {
    paragraph(xml, style, |_| (), |xml| words(xml, text, Ink::PLAIN));
}
