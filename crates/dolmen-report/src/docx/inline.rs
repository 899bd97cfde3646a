//! Runs of a paragraph: words, fields, and figures.

use super::xml::Xml;

/// How a run stands out.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Ink<'a> {
    pub(super) bold: bool,
    pub(super) colour: Option<&'a str>,
}

impl Ink<'_> {
    pub(super) const PLAIN: Ink<'static> = Ink {
        bold: false,
        colour: None,
    };
    pub(super) const BOLD: Ink<'static> = Ink {
        bold: true,
        colour: None,
    };

    fn put(self, xml: &mut Xml, lowered: bool) {
        if !self.bold && self.colour.is_none() && !lowered {
            return;
        }
        xml.element("w:rPr", &[], |xml| {
            if self.bold {
                xml.leaf("w:b", &[]);
                xml.leaf("w:bCs", &[]);
            }
            if let Some(colour) = self.colour {
                xml.leaf("w:color", &[("w:val", colour)]);
            }
            if lowered {
                xml.leaf("w:vertAlign", &[("w:val", "subscript")]);
            }
        });
    }
}

/// Symbols whose second part stands lower, as on the page.
const LOWERED: [&str; 2] = ["k_cr", "k_min"];

/// Words of a paragraph.
pub(super) fn words(xml: &mut Xml, text: &str, ink: Ink<'_>) {
    let mut rest = text;
    while let Some((at, symbol)) = first_symbol(rest) {
        let (before, behind) = rest.split_at(at);
        let (letter, index) = symbol.split_once('_').unwrap_or((symbol, ""));
        run(xml, &format!("{before}{letter}"), ink, false);
        run(xml, index, ink, true);
        rest = behind.strip_prefix(symbol).unwrap_or_default();
    }
    run(xml, rest, ink, false);
}

fn first_symbol(text: &str) -> Option<(usize, &'static str)> {
    let found = LOWERED
        .iter()
        .filter_map(|symbol| Some((text.find(symbol)?, *symbol)));
    found.min()
}

fn run(xml: &mut Xml, text: &str, ink: Ink<'_>, lowered: bool) {
    if text.is_empty() {
        return;
    }
    xml.element("w:r", &[], |xml| {
        ink.put(xml, lowered);
        xml.words("w:t", &[("xml:space", "preserve")], text);
    });
}

pub(super) fn tab(xml: &mut Xml) {
    xml.element("w:r", &[], |xml| xml.leaf("w:tab", &[]));
}

/// A field that the reader's program computes anew, and what it comes to now.
pub(super) fn field(xml: &mut Xml, instruction: &str, now: &str, ink: Ink<'_>) {
    let part = |xml: &mut Xml, what: &str| {
        xml.element("w:r", &[], |xml| {
            ink.put(xml, false);
            xml.leaf("w:fldChar", &[("w:fldCharType", what)]);
        });
    };
    part(xml, "begin");
    instruct(xml, instruction);
    part(xml, "separate");
    run(xml, now, ink, false);
    part(xml, "end");
}

/// What a field is to compute.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_the_second_part_of_a_symbol_stands_lower() {
        let mut xml = Xml::default();
        words(&mut xml, "M > k_cr; k_min.", Ink::PLAIN);
        let text = xml.finish();
        let lowered = text
            .matches("subscript\"/></w:rPr><w:t xml:space=\"preserve\">cr<")
            .count();
        assert_eq!(lowered, 1, "{text}");
        let plain = text.split("<w:t xml:space=\"preserve\">").skip(1);
        let plain: String = plain.filter_map(|run| run.split('<').next()).collect();
        assert_eq!(plain, "M &gt; kcr; kmin.");
    }
}
