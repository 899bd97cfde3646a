//! Converts a figure from SVG to PNG. Opens no file; its fonts, Pretendard Regular, SemiBold and Bold, are compiled
//! in.

mod fonts;
mod painter;

pub use fonts::FONTS;
pub use painter::{NotPainted, Painter};

#[cfg(test)]
mod tests;
