//! Styles and colours of a document. Sizes are half-points, lengths twentieths of a point.

use crate::paper::xml::Xml;
use crate::paper::{HAIR, INK, QUIET, TEXT_WIDTH};
use dolmen_words::Language;

/// The namespace of WordprocessingML.
pub(super) const W: &str = "http://schemas.openxmlformats.org/wordprocessingml/2006/main";

/// A4 and its margins, as in the PDF.
pub(super) const PAGE: [&str; 2] = ["11906", "16838"];
pub(super) const MARGIN_SIDE: &str = "1304"; // 23 mm
pub(super) const MARGIN_TOP: &str = "1474"; // 26 mm
/// A paragraph style.
struct Style {
    id: &'static str,
    name: &'static str,
    based_on: &'static str,
    /// The style of the next paragraph when a user continues writing.
    next: &'static str,
    half_points: &'static str,
    colour: &'static str,
    bold: bool,
    before: &'static str,
    after: &'static str,
    keep_next: bool,
    /// Its level in the contents, from 0; `None` if it is no heading.
    level: Option<&'static str>,
    /// Indent from the left, and hanging indent of the first line.
    indent: Option<[&'static str; 2]>,
    centred: bool,
}

const BODY: Style = Style {
    id: "BodyText",
    name: "Body Text",
    based_on: "Normal",
    next: "BodyText",
    half_points: "20",
    colour: INK,
    bold: false,
    before: "0",
    after: "140",
    keep_next: false,
    level: None,
    indent: None,
    centred: false,
};

const fn heading(id: &'static str, name: &'static str, level: &'static str) -> Style {
    Style {
        id,
        name,
        next: "BodyText",
        bold: true,
        keep_next: true,
        level: Some(level),
        ..BODY
    }
}

const fn named(id: &'static str, name: &'static str) -> Style {
    Style { id, name, ..BODY }
}

/// Styles, each with what it changes of another.
macro_rules! styles {
    ($($style:expr => { $($field:ident: $value:expr),* }),* $(,)?) => {
        [$(Style { $($field: $value,)* ..$style }),*]
    };
}

const STYLES: [Style; 22] = styles! {
    BODY => {},
    heading("Heading1", "heading 1", "0") => { half_points: "30", before: "480", after: "200" },
    heading("Heading2", "heading 2", "1") => { half_points: "24", before: "320", after: "140" },
    heading("Heading3", "heading 3", "2") => { half_points: "21", before: "260", after: "120" },
    // headings without numbers, left out of the contents
    named("FrontHeading", "Front Heading") => { half_points: "26", bold: true, before: "360", after: "160", keep_next: true },
    named("TOCHeading", "TOC Heading") => { half_points: "26", bold: true, before: "480", after: "160", keep_next: true },
    named("Title", "Title") => { half_points: "52", bold: true, after: "80", next: "Subtitle" },
    named("Subtitle", "Subtitle") => { half_points: "22", colour: QUIET, after: "120" },
    named("Caption", "caption") => { half_points: "18", after: "120", before: "120", next: "BodyText" },
    named("Figure", "Figure") => { keep_next: true, before: "200", after: "0", centred: true, next: "Caption" },
    named("Equation", "Equation") => { keep_next: true, before: "160", after: "80", centred: true },
    named("Judgement", "Judgement") => { after: "60", indent: Some(["170", "0"]) },
    named("Finding", "Finding") => { after: "100", indent: Some(["340", "340"]) },
    named("Warning", "Warning") => { before: "80", indent: Some(["170", "0"]) },
    named("Remark", "Remark") => { half_points: "17", colour: QUIET },
    named("ListBullet", "List Bullet") => { after: "80" },
    named("TableText", "Table Text") => { half_points: "17", before: "40", after: "40", next: "TableText" },
    named("TableTextSmall", "Table Text Small") => { half_points: "15", based_on: "TableText", before: "30", after: "30", next: "TableTextSmall" },
    named("TableTextFine", "Table Text Fine") => { half_points: "13", based_on: "TableText", before: "30", after: "30", next: "TableTextFine" },
    named("Header", "header") => { half_points: "16", colour: QUIET, after: "0", next: "Header" },
    named("Footer", "footer") => { half_points: "16", colour: QUIET, after: "0", next: "Footer" },
    named("AfterTable", "After Table") => { half_points: "12", after: "120", next: "BodyText" },
};

/// The styles: Normal, the headings, Caption, Body Text, those of tables and contents.
pub(super) fn styles(language: Language) -> String {
    let mut xml = Xml::document();
    xml.element("w:styles", &[("xmlns:w", W)], |xml| {
        xml.element("w:docDefaults", &[], |xml| {
            xml.element("w:rPrDefault", &[], |xml| {
                xml.element("w:rPr", &[], |xml| {
                    fonts(xml, language);
                    xml.leaf("w:color", &[("w:val", INK)]);
                    xml.leaf("w:sz", &[("w:val", "20")]);
                    xml.leaf("w:szCs", &[("w:val", "20")]);
                    xml.leaf(
                        "w:lang",
                        &[
                            ("w:val", language.pick("en-GB", "en-US")),
                            ("w:eastAsia", "ko-KR"),
                            ("w:bidi", "ar-SA"),
                        ],
                    );
                });
            });
            xml.element("w:pPrDefault", &[], |xml| {
                xml.element("w:pPr", &[], |xml| {
                    // no extra space between digits or Latin letters and Hangul
                    xml.leaf("w:autoSpaceDE", &[("w:val", "0")]);
                    xml.leaf("w:autoSpaceDN", &[("w:val", "0")]);
                    xml.leaf("w:spacing", &[("w:line", "276"), ("w:lineRule", "auto")]);
                });
            });
        });
        xml.element(
            "w:style",
            &[
                ("w:type", "paragraph"),
                ("w:default", "1"),
                ("w:styleId", "Normal"),
            ],
            |xml| {
                xml.leaf("w:name", &[("w:val", "Normal")]);
                xml.leaf("w:qFormat", &[]);
            },
        );
        xml.element(
            "w:style",
            &[
                ("w:type", "character"),
                ("w:default", "1"),
                ("w:styleId", "DefaultParagraphFont"),
            ],
            |xml| {
                xml.leaf("w:name", &[("w:val", "Default Paragraph Font")]);
                xml.leaf("w:uiPriority", &[("w:val", "1")]);
                xml.leaf("w:semiHidden", &[]);
            },
        );
        xml.element(
            "w:style",
            &[
                ("w:type", "numbering"),
                ("w:default", "1"),
                ("w:styleId", "NoList"),
            ],
            |xml| {
                xml.leaf("w:name", &[("w:val", "No List")]);
            },
        );
        for style in &STYLES {
            paragraph_style(xml, style);
        }
        contents_style(xml, "TOC1", "toc 1", "0");
        contents_style(xml, "TOC2", "toc 2", "283");
        table_styles(xml);
    });
    xml.finish()
}

fn fonts(xml: &mut Xml, language: Language) {
    // Word knows the Korean font by either name, and Korean Word by its own
    let latin = language.pick("Calibri", "맑은 고딕");
    xml.leaf(
        "w:rFonts",
        &[
            ("w:ascii", latin),
            ("w:hAnsi", latin),
            ("w:eastAsia", "맑은 고딕"),
            ("w:cs", latin),
        ],
    );
}

fn paragraph_style(xml: &mut Xml, style: &Style) {
    xml.element(
        "w:style",
        &[("w:type", "paragraph"), ("w:styleId", style.id)],
        |xml| {
            xml.leaf("w:name", &[("w:val", style.name)]);
            xml.leaf("w:basedOn", &[("w:val", style.based_on)]);
            xml.leaf("w:next", &[("w:val", style.next)]);
            xml.leaf("w:qFormat", &[]);
            xml.element("w:pPr", &[], |xml| {
                if style.keep_next {
                    xml.leaf("w:keepNext", &[]);
                    xml.leaf("w:keepLines", &[]);
                }
                if let Some(level) = style.level {
                    xml.element("w:numPr", &[], |xml| {
                        xml.leaf("w:ilvl", &[("w:val", level)]);
                        xml.leaf("w:numId", &[("w:val", "1")]);
                    });
                }
                if style.id == "ListBullet" {
                    xml.element("w:numPr", &[], |xml| xml.leaf("w:numId", &[("w:val", "2")]));
                }
                xml.leaf(
                    "w:spacing",
                    &[("w:before", style.before), ("w:after", style.after)],
                );
                if let Some([left, hanging]) = style.indent {
                    xml.leaf("w:ind", &[("w:left", left), ("w:hanging", hanging)]);
                }
                if style.centred {
                    xml.leaf("w:jc", &[("w:val", "center")]);
                }
                if let Some(level) = style.level {
                    xml.leaf("w:outlineLvl", &[("w:val", level)]);
                }
            });
            xml.element("w:rPr", &[], |xml| {
                if style.bold {
                    xml.leaf("w:b", &[]);
                    xml.leaf("w:bCs", &[]);
                }
                xml.leaf("w:color", &[("w:val", style.colour)]);
                xml.leaf("w:sz", &[("w:val", style.half_points)]);
                xml.leaf("w:szCs", &[("w:val", style.half_points)]);
            });
        },
    );
}

fn contents_style(xml: &mut Xml, id: &str, name: &str, left: &str) {
    xml.element("w:style", &[("w:type", "paragraph"), ("w:styleId", id)], |xml| {
        xml.leaf("w:name", &[("w:val", name)]);
        xml.leaf("w:basedOn", &[("w:val", "Normal")]);
        xml.leaf("w:next", &[("w:val", "Normal")]);
        xml.leaf("w:uiPriority", &[("w:val", "39")]);
        xml.element("w:pPr", &[], |xml| {
            xml.element("w:tabs", &[], |xml| {
                let number = if left == "0" { "454" } else { "964" };
                xml.leaf("w:tab", &[("w:val", "left"), ("w:pos", number)]);
                let end = TEXT_WIDTH.to_string();
                xml.leaf(
                    "w:tab",
                    &[("w:val", "right"), ("w:leader", "dot"), ("w:pos", &end)],
                );
            });
            xml.leaf("w:spacing", &[("w:after", "60")]);
            xml.leaf("w:ind", &[("w:left", left)]);
        });
    });
}

/// Hairlines between rows, and a line below the head.
fn table_styles(xml: &mut Xml) {
    xml.element(
        "w:style",
        &[
            ("w:type", "table"),
            ("w:default", "1"),
            ("w:styleId", "TableNormal"),
        ],
        |xml| {
            xml.leaf("w:name", &[("w:val", "Normal Table")]);
            xml.leaf("w:uiPriority", &[("w:val", "99")]);
            xml.leaf("w:semiHidden", &[]);
            xml.element("w:tblPr", &[], |xml| {
                xml.leaf("w:tblInd", &[("w:w", "0"), ("w:type", "dxa")]);
                cell_margins(xml, "70");
            });
        },
    );
    xml.element(
        "w:style",
        &[
            ("w:type", "table"),
            ("w:customStyle", "1"),
            ("w:styleId", "DolmenTable"),
        ],
        |xml| {
            xml.leaf("w:name", &[("w:val", "Dolmen Table")]);
            xml.leaf("w:basedOn", &[("w:val", "TableNormal")]);
            xml.leaf("w:qFormat", &[]);
            xml.element("w:tblPr", &[], |xml| {
                xml.element("w:tblBorders", &[], |xml| {
                    for side in ["w:bottom", "w:insideH"] {
                        let size = if side == "w:bottom" { "8" } else { "4" };
                        let colour = if side == "w:bottom" { INK } else { HAIR };
                        border(xml, side, size, colour);
                    }
                });
            });
            xml.element("w:tblStylePr", &[("w:type", "firstRow")], |xml| {
                xml.element("w:rPr", &[], |xml| xml.leaf("w:b", &[]));
                xml.element("w:tcPr", &[], |xml| {
                    xml.element("w:tcBorders", &[], |xml| border(xml, "w:bottom", "8", INK));
                });
            });
        },
    );
}

pub(super) fn cell_margins(xml: &mut Xml, side: &str) {
    xml.element("w:tblCellMar", &[], |xml| {
        for (at, width) in [
            ("w:top", "0"),
            ("w:left", side),
            ("w:bottom", "0"),
            ("w:right", side),
        ] {
            xml.leaf(at, &[("w:w", width), ("w:type", "dxa")]);
        }
    });
}

pub(super) fn border(xml: &mut Xml, side: &str, eighths: &str, colour: &str) {
    xml.leaf(
        side,
        &[
            ("w:val", "single"),
            ("w:sz", eighths),
            ("w:space", "0"),
            ("w:color", colour),
        ],
    );
}
