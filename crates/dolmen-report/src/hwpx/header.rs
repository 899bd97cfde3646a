//! The header of a document: fonts, fills, letters, tabs, numbers, paragraphs and styles.

use super::looks::{Count, Ground, Letters, Lie, Looks, Style, Tab};
use super::spaces::SPACES;
use crate::paper::xml::Xml;

/// A font of Windows, which every computer with Hangul has.
const FONT: &str = "맑은 고딕";
const SCRIPTS: [&str; 7] = ["HANGUL", "LATIN", "HANJA", "JAPANESE", "OTHER", "SYMBOL", "USER"];
/// The number for no separate letter format.
const NO_LETTERS: &str = "4294967295";

/// The header of a document with this many sections.
pub(super) fn header(looks: &Looks, sections: usize) -> String {
    let mut xml = Xml::document();
    let mut attributes = SPACES.to_vec();
    let count = sections.to_string();
    attributes.extend([("version", "1.5"), ("secCnt", count.as_str())]);
    xml.element("hh:head", &attributes, |xml| {
        let first = ["page", "footnote", "endnote", "pic", "tbl", "equation"].map(|what| (what, "1"));
        xml.leaf("hh:beginNum", &first);
        xml.element("hh:refList", &[], |xml| {
            fonts(xml);
            counted(xml, "hh:borderFills", &looks.grounds, |xml, at, ground| {
                border_fill(xml, at + 1, *ground);
            });
            counted(xml, "hh:charProperties", &looks.letters, |xml, at, letters| {
                character(xml, at, letters);
            });
            counted(xml, "hh:tabProperties", &Tab::ALL, |xml, at, tab| {
                let flag = |wanted: Tab| if *tab == wanted { "1" } else { "0" };
                xml.leaf(
                    "hh:tabPr",
                    &[
                        ("id", &at.to_string()),
                        ("autoTabLeft", flag(Tab::Hanging)),
                        ("autoTabRight", flag(Tab::Right)),
                    ],
                );
            });
            numbers(xml);
            counted(xml, "hh:paraProperties", &looks.lies, |xml, at, lie| {
                paragraph(xml, at, lie, looks);
            });
            counted(xml, "hh:styles", &Style::ALL, |xml, at, style| {
                one_style(xml, at, *style, looks);
            });
        });
        xml.element("hh:compatibleDocument", &[("targetProgram", "HWP201X")], |xml| {
            xml.leaf("hh:layoutCompatibility", &[]);
        });
        xml.element("hh:docOption", &[], |xml| {
            xml.leaf(
                "hh:linkinfo",
                &[("path", ""), ("pageInherit", "0"), ("footnoteInherit", "0")],
            );
        });
        xml.leaf("hh:trackchageConfig", &[("flags", "56")]); // spelt as in the format
    });
    xml.finish()
}

fn counted<T>(xml: &mut Xml, tag: &str, all: &[T], each: impl Fn(&mut Xml, usize, &T)) {
    xml.element(tag, &[("itemCnt", &all.len().to_string())], |xml| {
        for (at, one) in all.iter().enumerate() {
            each(xml, at, one);
        }
    });
}

fn fonts(xml: &mut Xml) {
    counted(xml, "hh:fontfaces", &SCRIPTS, |xml, _, script| {
        xml.element("hh:fontface", &[("lang", script), ("fontCnt", "1")], |xml| {
            let font = [("id", "0"), ("face", FONT), ("type", "TTF"), ("isEmbedded", "0")];
            xml.leaf("hh:font", &font);
        });
    });
}

fn border_fill(xml: &mut Xml, id: usize, ground: Ground) {
    let attributes = [
        ("id", id.to_string()),
        ("threeD", "0".to_owned()),
        ("shadow", "0".to_owned()),
        ("centerLine", "NONE".to_owned()),
        ("breakCellSeparateLine", "0".to_owned()),
    ];
    let attributes: Vec<(&str, &str)> = attributes
        .iter()
        .map(|(name, value)| (*name, value.as_str()))
        .collect();
    xml.element("hh:borderFill", &attributes, |xml| {
        for tag in ["hh:slash", "hh:backSlash"] {
            xml.leaf(tag, &[("type", "NONE"), ("Crooked", "0"), ("isCounter", "0")]);
        }
        for (tag, line) in [
            ("hh:leftBorder", ground.left()),
            ("hh:rightBorder", None),
            ("hh:topBorder", None),
            ("hh:bottomBorder", ground.below()),
        ] {
            let (kind, width, colour) = match line {
                Some((width, colour)) => ("SOLID", width, hash(colour)),
                None => ("NONE", "0.1 mm", "#000000".to_owned()),
            };
            xml.leaf(tag, &[("type", kind), ("width", width), ("color", &colour)]);
        }
        if let Some(wash) = ground.wash() {
            xml.element("hc:fillBrush", &[], |xml| {
                let colour = hash(wash);
                let brush = [
                    ("faceColor", colour.as_str()),
                    ("hatchColor", "#999999"),
                    ("alpha", "0"),
                ];
                xml.leaf("hc:winBrush", &brush);
            });
        }
    });
}

fn hash(colour: &str) -> String {
    format!("#{colour}")
}

fn character(xml: &mut Xml, id: usize, letters: &Letters) {
    let (id, size, colour) = (id.to_string(), letters.size.to_string(), hash(letters.colour));
    let attributes = [
        ("id", id.as_str()),
        ("height", &size),
        ("textColor", &colour),
        ("shadeColor", "none"),
        ("useFontSpace", "0"),
        ("useKerning", "0"),
        ("symMark", "NONE"),
        ("borderFillIDRef", "1"),
    ];
    xml.element("hh:charPr", &attributes, |xml| {
        for (tag, value) in [
            ("hh:fontRef", "0"),
            ("hh:ratio", "100"),
            ("hh:spacing", "0"),
            ("hh:relSz", "100"),
            ("hh:offset", "0"),
        ] {
            let scripts = ["hangul", "latin", "hanja", "japanese", "other", "symbol", "user"];
            xml.leaf(tag, &scripts.map(|script| (script, value)));
        }
        if letters.bold {
            xml.leaf("hh:bold", &[]);
        }
        xml.leaf(
            "hh:underline",
            &[("type", "NONE"), ("shape", "SOLID"), ("color", "#000000")],
        );
        xml.leaf("hh:strikeout", &[("shape", "NONE"), ("color", "#000000")]);
        xml.leaf("hh:outline", &[("type", "NONE")]);
        xml.leaf(
            "hh:shadow",
            &[
                ("type", "NONE"),
                ("color", "#C0C0C0"),
                ("offsetX", "10"),
                ("offsetY", "10"),
            ],
        );
        if letters.low {
            xml.leaf("hh:subscript", &[]);
        }
    });
}

/// Headings numbered 1, 1.1, 1.1.1, and the bullet.
fn numbers(xml: &mut Xml) {
    let head = |xml: &mut Xml, level: &str, text: &str, distance: &str| {
        let attributes = [
            ("start", "1"),
            ("level", level),
            ("align", "LEFT"),
            ("useInstWidth", "1"),
            ("autoIndent", "0"),
            ("widthAdjust", "0"),
            ("textOffsetType", "PERCENT"),
            ("textOffset", distance),
            ("numFormat", "DIGIT"),
            ("charPrIDRef", NO_LETTERS),
            ("checkable", "0"),
        ];
        xml.words("hh:paraHead", &attributes, text);
    };
    xml.element("hh:numberings", &[("itemCnt", "1")], |xml| {
        xml.element("hh:numbering", &[("id", "1"), ("start", "1")], |xml| {
            head(xml, "1", "^1", "50");
            head(xml, "2", "^1.^2", "50");
            head(xml, "3", "^1.^2.^3", "50");
        });
    });
    xml.element("hh:bullets", &[("itemCnt", "1")], |xml| {
        let bullet = [("id", "1"), ("char", "•"), ("useImage", "0")];
        xml.element("hh:bullet", &bullet, |xml| head(xml, "0", "", "50"));
    });
}

fn paragraph(xml: &mut Xml, id: usize, lie: &Lie, looks: &Looks) {
    let tab = Tab::ALL.iter().position(|tab| *tab == lie.tab).unwrap_or(0);
    let (id, tab) = (id.to_string(), tab.to_string());
    let attributes = [
        ("id", id.as_str()),
        ("tabPrIDRef", &tab),
        ("condense", "0"),
        ("fontLineHeight", "0"),
        ("snapToGrid", "1"),
        ("suppressLineNumbers", "0"),
        ("checked", "0"),
    ];
    xml.element("hh:paraPr", &attributes, |xml| {
        xml.leaf(
            "hh:align",
            &[("horizontal", lie.align.word()), ("vertical", "BASELINE")],
        );
        let (kind, number, level) = match lie.count {
            Count::None => ("NONE", "0", 0),
            Count::Outline(level) => ("OUTLINE", "0", level),
            Count::Bullet => ("BULLET", "1", 0),
        };
        let level = level.to_string();
        xml.leaf(
            "hh:heading",
            &[("type", kind), ("idRef", number), ("level", &level)],
        );
        let keep = if lie.keep_next { "1" } else { "0" };
        xml.leaf(
            "hh:breakSetting",
            &[
                ("breakLatinWord", "KEEP_WORD"),
                ("breakNonLatinWord", "KEEP_WORD"),
                ("widowOrphan", "1"),
                ("keepWithNext", keep),
                ("keepLines", keep),
                ("pageBreakBefore", "0"),
                ("lineWrap", "BREAK"),
            ],
        );
        xml.leaf("hh:autoSpacing", &[("eAsianEng", "0"), ("eAsianNum", "0")]);
        xml.element("hh:margin", &[], |xml| {
            let intent = match lie.hanging {
                0 => "0".to_owned(),
                by => format!("-{by}"),
            };
            for (tag, value) in [
                ("hc:intent", intent),
                ("hc:left", lie.left.to_string()),
                ("hc:right", "0".to_owned()),
                ("hc:prev", lie.above.to_string()),
                ("hc:next", lie.below.to_string()),
            ] {
                xml.leaf(tag, &[("value", &value), ("unit", "HWPUNIT")]);
            }
        });
        let line = lie.line.to_string();
        xml.leaf(
            "hh:lineSpacing",
            &[("type", "PERCENT"), ("value", &line), ("unit", "HWPUNIT")],
        );
        let ground = looks.grounds.iter().position(|ground| *ground == lie.ground);
        let ground = (ground.unwrap_or(0) + 1).to_string();
        let room = if lie.ground == Ground::None { "0" } else { "283" }; // 1 mm
        let joined = if lie.ground == Ground::None { "0" } else { "1" };
        xml.leaf(
            "hh:border",
            &[
                ("borderFillIDRef", ground.as_str()),
                ("offsetLeft", room),
                ("offsetRight", room),
                ("offsetTop", room),
                ("offsetBottom", room),
                ("connect", joined),
                ("ignoreMargin", "0"),
            ],
        );
    });
}

fn one_style(xml: &mut Xml, at: usize, style: Style, looks: &Looks) {
    let [korean, english] = style.names();
    let (letters, lie) = (style.letters(), style.lie());
    let lie = looks.lies.iter().position(|of| *of == lie).unwrap_or(0);
    let letters = looks.letters.iter().position(|of| *of == letters).unwrap_or(0);
    let next = match style {
        Style::Outline1 | Style::Outline2 | Style::Outline3 | Style::Caption => Style::Body.number(),
        _ => at,
    };
    xml.leaf(
        "hh:style",
        &[
            ("id", &at.to_string()),
            ("type", "PARA"),
            ("name", korean),
            ("engName", english),
            ("paraPrIDRef", &lie.to_string()),
            ("charPrIDRef", &letters.to_string()),
            ("nextStyleIDRef", &next.to_string()),
            ("langID", "1042"),
            ("lockForm", "0"),
        ],
    );
}
