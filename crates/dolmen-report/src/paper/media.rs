//! Figures: a PNG for every program, an SVG for those that support it, and a description for readers who cannot see it.

use super::PaperFault;

/// Scale from the units of a figure to points on paper.
const SCALE: f64 = 0.62;
/// Largest height of a figure, pt: 170 mm.
const HEIGHT_MOST: f64 = 482.0;

/// Width and height of a photograph, pt: 125 × 85 mm.
const PHOTO_MOST: [f64; 2] = [354.0, 241.0];
/// Height of photographs side by side, and their largest width, pt: 70 mm, 100 mm.
const PHOTO_BESIDE: [f64; 2] = [283.0, 198.0];

/// A picture in the text.
#[derive(Clone, Debug)]
pub(crate) struct Picture {
    /// Number of the picture in the document, from 1.
    pub(crate) place: usize,
    /// "image1.png", "photo3.jpg".
    pub(crate) file: String,
    /// The same as SVG, of a figure.
    pub(crate) svg: Option<String>,
    /// Width and height before rotation, pt.
    pub(crate) size_pt: [f64; 2],
    /// Quarter turns clockwise from the camera.
    pub(crate) quarters: u8,
    pub(crate) alt: String,
}

/// The pictures of a document.
pub(crate) struct Media<'a> {
    paint: &'a dyn Fn(&str) -> Result<Vec<u8>, String>,
    /// Names with their bytes: "image1.png", "image1.svg".
    pub(crate) files: Vec<(String, Vec<u8>)>,
    /// Number of pictures that are figures with an SVG.
    drawn: usize,
    placed: usize,
}

impl Picture {
    /// The same with at most this height.
    pub(crate) fn within(self, height_most: f64) -> Self {
        let [width, height] = self.size_pt;
        let scale = (height_most / height).min(1.0);
        Picture {
            size_pt: [width * scale, height * scale],
            ..self
        }
    }
}

impl<'a> Media<'a> {
    pub(crate) fn new(paint: &'a dyn Fn(&str) -> Result<Vec<u8>, String>) -> Self {
        Media {
            paint,
            files: Vec::new(),
            drawn: 0,
            placed: 0,
        }
    }

    /// Stores a figure, and returns it as shown with at most this width in points.
    pub(crate) fn picture(&mut self, svg: &str, alt: &str, width_most: f64) -> Result<Picture, PaperFault> {
        let bytes = svg.as_bytes();
        // the cover repeats a figure of the text
        let there = self
            .files
            .iter()
            .find(|(name, of)| name.ends_with(".svg") && of == bytes);
        let name = match there {
            Some((name, _)) => name.trim_end_matches(".svg").to_owned(),
            None => {
                let png = (self.paint)(svg).map_err(PaperFault::Figure)?;
                self.drawn += 1;
                let name = format!("image{}", self.drawn);
                self.files.push((format!("{name}.png"), png));
                self.files.push((format!("{name}.svg"), bytes.to_vec()));
                name
            }
        };
        self.placed += 1;
        let [width, height] = sides(svg).ok_or_else(|| PaperFault::Figure("it has no size".to_owned()))?;
        let scale = SCALE.min(width_most / width).min(HEIGHT_MOST / height);
        Ok(Picture {
            place: self.placed,
            file: format!("{name}.png"),
            svg: Some(format!("{name}.svg")),
            size_pt: [width * scale, height * scale],
            quarters: 0,
            alt: alt.to_owned(),
        })
    }

    /// Stores a photograph, and returns it as shown.
    pub(crate) fn photo(&mut self, photo: &dolmen_records::Photo, alt: &str, width_most: f64) -> Picture {
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
        // after rotation
        let [across, down] = match quarters % 2 {
            1 => [height, width],
            _ => [width, height],
        };
        let height_most = match width_most < PHOTO_BESIDE[0] {
            true => PHOTO_BESIDE[1],
            false => PHOTO_MOST[1],
        };
        let scale = (width_most.min(PHOTO_MOST[0]) / across).min(height_most / down);
        Picture {
            place: self.placed,
            file: name,
            svg: None,
            size_pt: [width * scale, height * scale],
            quarters,
            alt: alt.to_owned(),
        }
    }
}

/// Width and height of a figure, from its SVG header.
fn sides(svg: &str) -> Option<[f64; 2]> {
    let head = svg.split_once("<svg")?.1.split_once('>')?.0;
    let number = |name: &str| -> Option<f64> {
        let rest = head.split_once(&format!(" {name}=\""))?.1;
        rest.split_once('"')?.0.parse().ok()
    };
    let sides = [number("width")?, number("height")?];
    sides.iter().all(|side| *side > 0.0).then_some(sides)
}
