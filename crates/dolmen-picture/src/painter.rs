//! SVG → PNG.

use crate::FONTS;
use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb};
use std::sync::Arc;

/// Largest side in pixels. Our choice: larger than any figure of a report.
const SIDE_MOST: f32 = 8192.0;
/// The family of the fonts.
const FAMILY: &str = "Pretendard";

/// A figure that could not be painted.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the figure could not be painted: {0}")]
pub struct NotPainted(String);

/// Paints figures with its own fonts only, so that the same figure gives the same bytes on every machine.
pub struct Painter {
    options: Options<'static>,
}

impl Default for Painter {
    fn default() -> Self {
        Self::new()
    }
}

impl Painter {
    /// Uses the report fonts for every font family that a figure names.
    pub fn new() -> Self {
        let mut fonts = fontdb::Database::new();
        for font in FONTS {
            fonts.load_font_source(fontdb::Source::Binary(Arc::new(font)));
        }
        fonts.set_sans_serif_family(FAMILY);
        Painter {
            options: Options {
                font_family: FAMILY.to_owned(),
                fontdb: Arc::new(fonts),
                ..Options::default()
            },
        }
    }

    /// Paints a figure as PNG on white, with `scale` pixels per unit.
    ///
    /// # Errors
    /// If it is not an SVG, or a side would have 0 or more than 8192 pixels.
    pub fn png(&self, svg: &str, scale: f32) -> Result<Vec<u8>, NotPainted> {
        // the fonts have no such character
        let svg = svg.replace('⊕', "(+)");
        let tree = Tree::from_str(&svg, &self.options).map_err(|fault| NotPainted(fault.to_string()))?;
        let [width, height] = [tree.size().width(), tree.size().height()].map(|side| (side * scale).round());
        let fits = |side: f32| (1.0..=SIDE_MOST).contains(&side);
        if !(fits(width) && fits(height)) {
            return Err(NotPainted(format!("{width} × {height} pixels")));
        }
        // both are whole numbers from 1 to 8192
        let mut canvas = Pixmap::new(width as u32, height as u32)
            .ok_or_else(|| NotPainted(format!("{width} × {height} pixels")))?;
        canvas.fill(Color::WHITE);
        resvg::render(&tree, Transform::from_scale(scale, scale), &mut canvas.as_mut());
        canvas.encode_png().map_err(|fault| NotPainted(fault.to_string()))
    }
}
