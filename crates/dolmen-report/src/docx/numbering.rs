//! The numbers of headings, bullets, and settings.

use super::look::W;
use crate::paper::xml::Xml;

/// Headings numbered 1, 1.1, 1.1.1, and bullets.
pub(super) fn numbering() -> String {
    let mut xml = Xml::document();
    xml.element("w:numbering", &[("xmlns:w", W)], |xml| {
        xml.element("w:abstractNum", &[("w:abstractNumId", "0")], |xml| {
            xml.leaf("w:multiLevelType", &[("w:val", "multilevel")]);
            for (level, text, style) in [
                ("0", "%1", "Heading1"),
                ("1", "%1.%2", "Heading2"),
                ("2", "%1.%2.%3", "Heading3"),
            ] {
                xml.element("w:lvl", &[("w:ilvl", level)], |xml| {
                    xml.leaf("w:start", &[("w:val", "1")]);
                    xml.leaf("w:numFmt", &[("w:val", "decimal")]);
                    xml.leaf("w:pStyle", &[("w:val", style)]);
                    xml.leaf("w:suff", &[("w:val", "space")]);
                    xml.leaf("w:lvlText", &[("w:val", text)]);
                    xml.leaf("w:lvlJc", &[("w:val", "left")]);
                    xml.element("w:pPr", &[], |xml| {
                        xml.leaf("w:ind", &[("w:left", "0"), ("w:firstLine", "0")]);
                    });
                });
            }
        });
        xml.element("w:abstractNum", &[("w:abstractNumId", "1")], |xml| {
            xml.leaf("w:multiLevelType", &[("w:val", "hybridMultilevel")]);
            xml.element("w:lvl", &[("w:ilvl", "0")], |xml| {
                xml.leaf("w:start", &[("w:val", "1")]);
                xml.leaf("w:numFmt", &[("w:val", "bullet")]);
                xml.leaf("w:pStyle", &[("w:val", "ListBullet")]);
                xml.leaf("w:lvlText", &[("w:val", "•")]);
                xml.leaf("w:lvlJc", &[("w:val", "left")]);
                xml.element("w:pPr", &[], |xml| {
                    xml.leaf("w:ind", &[("w:left", "340"), ("w:hanging", "227")]);
                });
            });
        });
        for (number, of) in [("1", "0"), ("2", "1")] {
            xml.element("w:num", &[("w:numId", number)], |xml| {
                xml.leaf("w:abstractNumId", &[("w:val", of)]);
            });
        }
    });
    xml.finish()
}

/// Settings: Word computes the page numbers of the contents when it opens the document.
pub(super) fn settings(with_contents: bool) -> String {
    let mut xml = Xml::document();
    xml.element("w:settings", &[("xmlns:w", W)], |xml| {
        xml.leaf("w:zoom", &[("w:percent", "100")]);
        xml.leaf("w:defaultTabStop", &[("w:val", "720")]);
        if with_contents {
            xml.leaf("w:updateFields", &[("w:val", "true")]);
        }
        xml.leaf("w:characterSpacingControl", &[("w:val", "doNotCompress")]);
        xml.element("w:compat", &[], |xml| {
            xml.leaf(
                "w:compatSetting",
                &[
                    ("w:name", "compatibilityMode"),
                    ("w:uri", "http://schemas.microsoft.com/office/word"),
                    ("w:val", "15"),
                ],
            );
        });
    });
    xml.finish()
}
