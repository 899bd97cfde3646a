//! Pictures, placed in a line like a letter.

use super::spaces::item;
use crate::paper::Picture;
use crate::paper::xml::Xml;

/// Hundredths of a point in a point.
const HUNDREDTHS: f64 = 100.0;

pub(super) fn picture(xml: &mut Xml, of: &Picture) {
    let [width, height] = of.size_pt.map(|side| (side * HUNDREDTHS).round().max(1.0));
    let [middle_x, middle_y] = [width, height].map(|side| format!("{:.0}", 0.5 * side));
    let [width, height] = [width, height].map(|side| format!("{side:.0}"));
    let (width, height) = (width.as_str(), height.as_str());
    let id = (1_000_000 + of.place).to_string();
    let attributes = [
        ("id", id.as_str()),
        ("zOrder", "0"),
        ("numberingType", "PICTURE"),
        ("textWrap", "TOP_AND_BOTTOM"),
        ("textFlow", "BOTH_SIDES"),
        ("lock", "0"),
        ("dropcapstyle", "None"),
        ("href", ""),
        ("groupLevel", "0"),
        ("instid", id.as_str()),
        ("reverse", "0"),
    ];
    xml.element("hp:pic", &attributes, |xml| {
        xml.leaf("hp:offset", &[("x", "0"), ("y", "0")]);
        xml.leaf("hp:orgSz", &[("width", width), ("height", height)]);
        xml.leaf("hp:curSz", &[("width", width), ("height", height)]);
        xml.leaf("hp:flip", &[("horizontal", "0"), ("vertical", "0")]);
        let turn = [
            ("angle", "0"),
            ("centerX", middle_x.as_str()),
            ("centerY", middle_y.as_str()),
            ("rotateimage", "1"),
        ];
        xml.leaf("hp:rotationInfo", &turn);
        xml.element("hp:renderingInfo", &[], |xml| {
            for tag in ["hc:transMatrix", "hc:scaMatrix", "hc:rotMatrix"] {
                let one = [
                    ("e1", "1"),
                    ("e2", "0"),
                    ("e3", "0"),
                    ("e4", "0"),
                    ("e5", "1"),
                    ("e6", "0"),
                ];
                xml.leaf(tag, &one);
            }
        });
        xml.element("hp:imgRect", &[], |xml| {
            let corners = [("0", "0"), (width, "0"), (width, height), ("0", height)];
            let tags = ["hc:pt0", "hc:pt1", "hc:pt2", "hc:pt3"];
            for (tag, (x, y)) in tags.into_iter().zip(corners) {
                xml.leaf(tag, &[("x", x), ("y", y)]);
            }
        });
        let all = [("left", "0"), ("right", width), ("top", "0"), ("bottom", height)];
        xml.leaf("hp:imgClip", &all);
        xml.leaf("hp:inMargin", &margins("0"));
        xml.leaf("hp:imgDim", &[("dimwidth", width), ("dimheight", height)]);
        let image = [
            ("binaryItemIDRef", item(&of.file)),
            ("bright", "0"),
            ("contrast", "0"),
            ("effect", "REAL_PIC"),
            ("alpha", "0"),
        ];
        xml.leaf("hc:img", &image);
        size(xml, width, height);
        place(xml, true);
        xml.leaf("hp:outMargin", &margins("0"));
        xml.words("hp:shapeComment", &[], &of.alt);
    });
}

/// The same margin on all sides.
pub(super) fn margins(side: &str) -> [(&'static str, &str); 4] {
    ["left", "right", "top", "bottom"].map(|at| (at, side))
}

/// Size of a picture or table.
pub(super) fn size(xml: &mut Xml, width: &str, height: &str) {
    xml.leaf(
        "hp:sz",
        &[
            ("width", width),
            ("widthRelTo", "ABSOLUTE"),
            ("height", height),
            ("heightRelTo", "ABSOLUTE"),
            ("protect", "0"),
        ],
    );
}

/// Position: in the line like a letter, or below its paragraph.
pub(super) fn place(xml: &mut Xml, as_letter: bool) {
    let as_letter = if as_letter { "1" } else { "0" };
    xml.leaf(
        "hp:pos",
        &[
            ("treatAsChar", as_letter),
            ("affectLSpacing", "0"),
            ("flowWithText", "1"),
            ("allowOverlap", "0"),
            ("holdAnchorAndSO", "0"),
            ("vertRelTo", "PARA"),
            ("horzRelTo", "COLUMN"),
            ("vertAlign", "TOP"),
            ("horzAlign", "LEFT"),
            ("vertOffset", "0"),
            ("horzOffset", "0"),
        ],
    );
}
