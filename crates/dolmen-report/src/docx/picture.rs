//! Figures: a PNG for every program, the SVG beside it for those that draw it sharp, and words for those who do not see it.

use super::fault::DocxFault;
use super::xml::Xml;

/// English Metric Units of a point.
const EMU: f64 = 12_700.0;
/// A figure is drawn this much smaller than its units say, as on paper.
const SCALE: f64 = 0.8;
/// No figure is higher, pt: 170 mm.
const HEIGHT_MOST: f64 = 482.0;

/// Width and height of a photograph, pt: 125 × 85 mm.
const PHOTO_MOST: [f64; 2] = [354.0, 241.0];

/// A quarter of a turn, in 60 000ths of a degree.
const QUARTER_TURN: u32 = 5_400_000;

const A: &str = "http://schemas.openxmlformats.org/drawingml/2006/main";
const PIC: &str = "http://schemas.openxmlformats.org/drawingml/2006/picture";
const ASVG: &str = "http://schemas.microsoft.com/office/drawing/2016/SVG/main";
/// The extension that holds an SVG.
const SVG_EXTENSION: &str = "{96DAC541-7B7A-43D3-8B79-37D633B846F1}";

/// The pictures of a document.
pub(super) struct Media<'a> {
    paint: &'a dyn Fn(&str) -> Result<Vec<u8>, String>,
    /// Names with their bytes: "image1.png", "image1.svg".
    pub(super) files: Vec<(String, Vec<u8>)>,
    /// Pictures of figures, each with its SVG.
    drawn: usize,
    placed: usize,
}

impl<'a> Media<'a> {
    pub(super) fn new(paint: &'a dyn Fn(&str) -> Result<Vec<u8>, String>) -> Self {
        Media {
            paint,
            files: Vec::new(),
            drawn: 0,
            placed: 0,
        }
    }

    /// Keeps a figure, and gives the run that shows it, at most so many points wide.
    pub(super) fn picture(&mut self, svg: &str, alt: &str, width_most: f64) -> Result<Xml, DocxFault> {
        let bytes = svg.as_bytes();
        // the cover shows a figure of the text
        let there = self
            .files
            .iter()
            .find(|(name, of)| name.ends_with(".svg") && of == bytes);
        let name = match there {
            Some((name, _)) => name.trim_end_matches(".svg").to_owned(),
            None => {
                let png = (self.paint)(svg).map_err(DocxFault::Figure)?;
                self.drawn += 1;
                let name = format!("image{}", self.drawn);
                self.files.push((format!("{name}.png"), png));
                self.files.push((format!("{name}.svg"), bytes.to_vec()));
                name
            }
        };
        self.placed += 1;
        let [width, height] = sides(svg).ok_or_else(|| DocxFault::Figure("it has no size".to_owned()))?;
        let scale = SCALE.min(width_most / width).min(HEIGHT_MOST / height);
        let size = [width * scale, height * scale].map(|side| format!("{:.0}", side * EMU));
        let svg = relation(&format!("{name}.svg"));
        Ok(drawing(
            self.placed,
            (&relation(&format!("{name}.png")), Some(&svg)),
            (&size, None),
            alt,
        ))
    }

    /// Keeps a photograph, and gives the run that shows it.
    pub(super) fn photo(&mut self, photo: &dolmen_records::Photo, alt: &str, width_most: f64) -> Xml {
        let there = self.files.iter().find(|(_, of)| *of == photo.bytes);
        let name = there.map_or_else(
            || format!("photo{}.{}", self.files.len() + 1, photo.format.extension()),
            |(name, _)| name.clone(),
        );
        if there.is_none() {
            self.files.push((name.clone(), photo.bytes.clone()));
        }
        self.placed += 1;
        let [width, height] = [photo.width, photo.height].map(|side| f64::from(side.max(1)));
        let quarters = photo.quarter_turns();
        // as it lies on the page
        let [across, down] = match quarters % 2 {
            1 => [height, width],
            _ => [width, height],
        };
        let scale = (width_most.min(PHOTO_MOST[0]) / across).min(PHOTO_MOST[1] / down);
        let emu = |side: f64| format!("{:.0}", side * scale * EMU);
        let size = [width, height].map(emu);
        let turn = (quarters > 0).then(|| Turn {
            angle: (u32::from(quarters) * QUARTER_TURN).to_string(),
            beside: emu((0.5 * (across - width)).max(0.0)),
            above: emu((0.5 * (down - height)).max(0.0)),
        });
        drawing(self.placed, (&relation(&name), None), (&size, turn), alt)
    }
}

/// The relation of a picture's file: "image3-png".
pub(super) fn relation(file: &str) -> String {
    file.replace('.', "-")
}

/// Width and height of a figure, by its own head.
fn sides(svg: &str) -> Option<[f64; 2]> {
    let head = svg.split_once("<svg")?.1.split_once('>')?.0;
    let number = |name: &str| -> Option<f64> {
        let rest = head.split_once(&format!(" {name}=\""))?.1;
        rest.split_once('"')?.0.parse().ok()
    };
    let sides = [number("width")?, number("height")?];
    sides.iter().all(|side| *side > 0.0).then_some(sides)
}

/// How a photograph is turned as the camera noted, and what it then takes beyond its own box.
struct Turn {
    angle: String,
    beside: String,
    above: String,
}

fn drawing(
    id: usize,
    (shown, svg): (&str, Option<&str>),
    (size, turn): (&[String; 2], Option<Turn>),
    alt: &str,
) -> Xml {
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
                            xml.element("pic:blipFill", &[], |xml| blip(xml, shown, svg));
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
