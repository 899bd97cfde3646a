//! Pictures: a PNG for every program, an SVG for those that support it, and a description for readers who cannot see it.

use crate::paper::Picture;
use crate::paper::xml::Xml;

/// English Metric Units per point.
const EMU: f64 = 12_700.0;
/// A quarter of a turn, in 60 000ths of a degree.
const QUARTER_TURN: u32 = 5_400_000;

const A: &str = "http://schemas.openxmlformats.org/drawingml/2006/main";
const PIC: &str = "http://schemas.openxmlformats.org/drawingml/2006/picture";
const ASVG: &str = "http://schemas.microsoft.com/office/drawing/2016/SVG/main";
/// The extension that holds an SVG.
const SVG_EXTENSION: &str = "{96DAC541-7B7A-43D3-8B79-37D633B846F1}";

/// The relation of a picture's file: "image3-png".
pub(super) fn relation(file: &str) -> String {
    file.replace('.', "-")
}

/// Rotation of a photograph from the camera, and how far the result exceeds its box.
struct Turn {
    angle: String,
    beside: String,
    above: String,
}

/// The run that shows a picture.
pub(super) fn drawing(picture: &Picture) -> Xml {
    let emu = |side: f64| format!("{:.0}", side * EMU);
    let [width, height] = picture.size_pt;
    // after rotation
    let [across, down] = match picture.quarters % 2 {
        1 => [height, width],
        _ => [width, height],
    };
    let turn = (picture.quarters > 0).then(|| Turn {
        angle: (u32::from(picture.quarters) * QUARTER_TURN).to_string(),
        beside: emu((0.5 * (across - width)).max(0.0)),
        above: emu((0.5 * (down - height)).max(0.0)),
    });
    let size = [width, height].map(emu);
    let (shown, svg) = (relation(&picture.file), picture.svg.as_deref().map(relation));
    let alt = picture.alt.as_str();
    let id = picture.place;
    let (id, name) = (id.to_string(), format!("Figure {id}"));
    let extent = [("cx", size[0].as_str()), ("cy", size[1].as_str())];
    let mut xml = Xml::default();
    let flat = [("distT", "0"), ("distB", "0"), ("distL", "0"), ("distR", "0")];
    xml.element("w:r", &[], |xml| {
        xml.element("w:drawing", &[], |xml| {
            xml.element("wp:inline", &flat, |xml| {
                xml.leaf("wp:extent", &extent);
                if let Some(Turn { beside, above, .. }) = &turn {
                    let beyond = [("l", beside), ("t", above), ("r", beside), ("b", above)];
                    xml.leaf("wp:effectExtent", &beyond.map(|(side, by)| (side, by.as_str())));
                }
                xml.leaf("wp:docPr", &[("id", &id), ("name", &name), ("descr", alt)]);
                xml.element("wp:cNvGraphicFramePr", &[], |xml| {
                    xml.leaf("a:graphicFrameLocks", &[("xmlns:a", A), ("noChangeAspect", "1")]);
                });
                xml.element("a:graphic", &[("xmlns:a", A)], |xml| {
                    xml.element("a:graphicData", &[("uri", PIC)], |xml| {
                        xml.element("pic:pic", &[("xmlns:pic", PIC)], |xml| {
                            xml.element("pic:nvPicPr", &[], |xml| {
                                xml.leaf("pic:cNvPr", &[("id", &id), ("name", &name), ("descr", alt)]);
                                xml.leaf("pic:cNvPicPr", &[]);
                            });
                            xml.element("pic:blipFill", &[], |xml| blip(xml, &shown, svg.as_deref()));
                            xml.element("pic:spPr", &[], |xml| {
                                let turned: Vec<(&str, &str)> =
                                    turn.iter().map(|turn| ("rot", turn.angle.as_str())).collect();
                                xml.element("a:xfrm", &turned, |xml| {
                                    xml.leaf("a:off", &[("x", "0"), ("y", "0")]);
                                    xml.leaf("a:ext", &extent);
                                });
                                xml.element("a:prstGeom", &[("prst", "rect")], |xml| {
                                    xml.leaf("a:avLst", &[])
                                });
                            });
                        });
                    });
                });
            });
        });
    });
    xml
}

fn blip(xml: &mut Xml, shown: &str, svg: Option<&str>) {
    xml.element("a:blip", &[("r:embed", shown)], |xml| {
        if let Some(svg) = svg {
            xml.element("a:extLst", &[], |xml| {
                xml.element("a:ext", &[("uri", SVG_EXTENSION)], |xml| {
                    xml.leaf("asvg:svgBlip", &[("xmlns:asvg", ASVG), ("r:embed", svg)]);
                });
            });
        }
    });
    xml.element("a:stretch", &[], |xml| xml.leaf("a:fillRect", &[]));
}
