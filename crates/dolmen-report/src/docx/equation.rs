//! Formulas as Office MathML, which word processors can edit.

use super::inline::paragraph;
use crate::document::Math;
use crate::paper::xml::Xml;

/// The namespace.
pub(super) const M: &str = "http://schemas.openxmlformats.org/officeDocument/2006/math";

/// A formula on a line of its own.
pub(super) fn equation(xml: &mut Xml, formula: &[Math]) {
    paragraph(
        xml,
        "Equation",
        |_| (),
        |xml| {
            xml.element("m:oMathPara", &[], |xml| {
                xml.element("m:oMath", &[], |xml| pieces(xml, formula));
            });
        },
    );
}

fn pieces(xml: &mut Xml, all: &[Math]) {
    for one in all {
        piece(xml, one);
    }
}

fn piece(xml: &mut Xml, of: &Math) {
    match of {
        Math::Symbol(text) => run(xml, "i", text),
        Math::Matrix(text) => run(xml, "b", text),
        Math::Word(text) | Math::Sign(text) => run(xml, "p", text),
        Math::Index(base, foot) => xml.element("m:sSub", &[], |xml| {
            xml.element("m:e", &[], |xml| piece(xml, base));
            xml.element("m:sub", &[], |xml| piece(xml, foot));
        }),
        Math::Power(base, head) => xml.element("m:sSup", &[], |xml| {
            xml.element("m:e", &[], |xml| piece(xml, base));
            xml.element("m:sup", &[], |xml| piece(xml, head));
        }),
        Math::Fraction(above, below) => xml.element("m:f", &[], |xml| {
            xml.element("m:num", &[], |xml| pieces(xml, above));
            xml.element("m:den", &[], |xml| pieces(xml, below));
        }),
        Math::Fenced([left, right], inside) => xml.element("m:d", &[], |xml| {
            xml.element("m:dPr", &[], |xml| {
                xml.leaf("m:begChr", &[("m:val", left)]);
                xml.leaf("m:endChr", &[("m:val", right)]);
            });
            xml.element("m:e", &[], |xml| pieces(xml, inside));
        }),
    }
}

/// A span of letters: slanted, bold or upright.
fn run(xml: &mut Xml, style: &str, text: &str) {
    xml.element("m:r", &[], |xml| {
        xml.element("m:rPr", &[], |xml| xml.leaf("m:sty", &[("m:val", style)]));
        xml.element("w:rPr", &[], |xml| {
            let font = "Cambria Math";
            xml.leaf("w:rFonts", &[("w:ascii", font), ("w:hAnsi", font)]);
        });
        xml.words("m:t", &[("xml:space", "preserve")], text);
    });
}
