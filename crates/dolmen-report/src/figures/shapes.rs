//! Mode shapes of chains and frames, side by side, with their frequencies.

use super::ink::{Anchor, BLUE, GREY, LIGHT, Label, Line, Shape, VERMILLION};
use super::scene::Scene;
use super::words::{Axes, Modal, Titles, say};
use dolmen::structure::{NaturalMode, ShapePoint};
use dolmen_words::Language;
use dolmen_words::number;

/// Width of one panel and height of its drawing, px.
const PANEL_PX: [f64; 2] = [128.0, 250.0];

/// Largest displacement drawn, px.
const SWING_PX: f64 = 42.0;

/// One mode to draw.
pub struct ShapePanel<'a> {
    /// The text above the panel: "mode 1".
    pub title: String,
    /// The mode; its displacements belong to `heights_m` of the figure.
    pub mode: &'a NaturalMode,
    /// Measured points, scaled to the computed shape; empty if none were measured.
    pub measured: &'a [ShapePoint],
}

/// One panel per mode: the displaced line over the line at rest, with the frequency. `heights_m` are the
/// heights of the displacements, lowest first, m above the ground.
pub fn mode_shapes(heights_m: &[f64], panels: &[ShapePanel], language: Language) -> String {
    /// Largest number of panels in a row; panels are distributed so that no row has only one.
    const ACROSS_MOST: usize = 6;
    let rows = panels.len().div_ceil(ACROSS_MOST).max(1);
    let across = panels.len().div_ceil(rows).max(1);
    let left = 46.0;
    let row_px = PANEL_PX[1] + 66.0;
    let mut scene = Scene::new(
        left + across as f64 * PANEL_PX[0] + 8.0,
        rows as f64 * row_px + 16.0,
    );
    let total = heights_m.last().copied().unwrap_or(1.0);
    for (p, panel) in panels.iter().enumerate() {
        let (row, column) = (p / across, p % across);
        let base = row as f64 * row_px + 46.0 + PANEL_PX[1];
        let middle = left + (column as f64 + 0.5) * PANEL_PX[0];
        let y = |height: f64| base - height / total * PANEL_PX[1];
        if column == 0 {
            scene.line([left - 4.0, base], [left - 4.0, y(total)], Line::new(GREY, 1.0));
            for (i, height) in [&[0.0], heights_m].concat().iter().enumerate() {
                scene.line(
                    [left - 8.0, y(*height)],
                    [left - 4.0, y(*height)],
                    Line::new(GREY, 1.0),
                );
                let text = if i == 0 {
                    "0".into()
                } else {
                    number::significant(*height, 3)
                };
                scene.text([left - 11.0, y(*height)], &Label::new(text, Anchor::End).small());
            }
            let name = say(Axes::Height, language);
            scene.text([2.0, base + 20.0], &Label::new(name, Anchor::Start).small());
        }
        let falls = panel.mode.omega_squared <= 0.0;
        let colour = if falls { VERMILLION } else { BLUE };
        scene.text(
            [middle, y(total) - 32.0],
            &Label::new(&panel.title, Anchor::Middle).bold(),
        );
        let frequency = if falls {
            say(Modal::NegativeModeFalls, language)
        } else {
            format!(
                "{}{}Hz",
                number::significant(panel.mode.frequency_hz, 4),
                number::NARROW_SPACE
            )
        };
        scene.text(
            [middle, y(total) - 15.0],
            &Label::new(frequency, Anchor::Middle).coloured(colour),
        );
        scene.line(
            [middle - SWING_PX, base],
            [middle + SWING_PX, base],
            Line::new(GREY, 1.5),
        );
        for height in heights_m {
            scene.line(
                [middle - SWING_PX, y(*height)],
                [middle + SWING_PX, y(*height)],
                Line::new(LIGHT, 0.8),
            );
        }
        scene.line([middle, base], [middle, y(total)], Line::new(GREY, 1.0).dashed());
        let mut points = vec![[middle, base]];
        for (height, displacement) in heights_m.iter().zip(&panel.mode.displacement) {
            points.push([middle + SWING_PX * displacement, y(*height)]);
        }
        scene.path(&points, Line::new(colour, 2.4));
        for point in points.iter().skip(1) {
            scene.marker(*point, Shape::Circle, 3.2, colour);
        }
        let scale = measured_scale(heights_m, panel);
        for point in panel.measured {
            let x = middle + SWING_PX * scale * point.displacement;
            scene.marker([x, y(point.height_m)], Shape::Ring, 4.5, VERMILLION);
        }
    }
    scene.svg(say(Titles::ModeShapesWithFrequencies, language))
}

/// The factor with which measured points are closest to the computed shape.
fn measured_scale(heights_m: &[f64], panel: &ShapePanel) -> f64 {
    let (mut over, mut under) = (0.0, 0.0);
    for point in panel.measured {
        let computed = interpolated(heights_m, &panel.mode.displacement, point.height_m);
        over += computed * point.displacement;
        under += point.displacement * point.displacement;
    }
    if under > 0.0 { over / under } else { 0.0 }
}

/// Displacement at a height, linear between the levels and 0 at the ground.
fn interpolated(heights_m: &[f64], displacement: &[f64], at_m: f64) -> f64 {
    let (mut low, mut from) = (0.0, 0.0);
    for (&high, &to) in heights_m.iter().zip(displacement) {
        if at_m <= high {
            return from + (to - from) * (at_m - low) / (high - low);
        }
        (low, from) = (high, to);
    }
    from
}
