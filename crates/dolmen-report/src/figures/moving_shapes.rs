//! Animated mode shapes: sensors with positions in an oblique view from above. The animation is part of the drawing (SMIL), without scripts.

use super::ink::{Anchor, BLUE, GREY, LIGHT, Label, Line};
use super::scene::Scene;
use super::wires::Wires;
use super::words::{Modal, Titles, say};
use dolmen::modal::Modes;
use dolmen_words::Language;
use dolmen_words::number;
use std::f64::consts::TAU;

/// Panels in one row, and the largest width and height of the structure in each, px.
const ACROSS: usize = 4;
const FILLED: [f64; 2] = [118.0, 190.0];
/// Width of a panel, and height of the text above the structure, px.
const PANEL_PX: f64 = 178.0;
const TITLE_PX: f64 = 44.0;
/// Largest number of modes: the file grows with each.
const MODES_MOST: usize = 12;
/// Number of pictures per period, and its duration, s: every mode moves at the same pace.
const PICTURES: usize = 16;
const PERIOD_S: f64 = 2.0;
/// Largest displacement relative to the diagonal of the drawing.
const SWING: f64 = 0.13;
/// Projections of x and y on paper, per unit length; z is vertical.
const X: [f64; 2] = [0.90, -0.22];
const Y: [f64; 2] = [0.48, 0.34];

/// Each mode over one period; `None` if fewer than two sensors have a position and a direction.
pub fn moving_shapes(modes: &Modes, language: Language) -> Option<String> {
    let frame = Wires::of(modes)?;
    let shown = &modes.modes[..modes.modes.len().min(MODES_MOST)];
    if shown.is_empty() {
        return None;
    }
    let rows = shown.len().div_ceil(ACROSS);
    let across = shown.len().min(ACROSS);
    let Fit {
        scale,
        middle,
        size_px,
    } = frame.fit();
    let swing_px = SWING * size_px[0].hypot(size_px[1]);
    let panel_px = TITLE_PX + size_px[1] + 2.0 * swing_px + 12.0;
    let mut scene = Scene::new(across as f64 * PANEL_PX, rows as f64 * panel_px);
    for (m, mode) in shown.iter().enumerate() {
        let left = (m % ACROSS) as f64 * PANEL_PX + 0.5 * PANEL_PX;
        let top = (m / ACROSS) as f64 * panel_px;
        let title = format!("{} {}", say(Modal::Mode, language), m + 1);
        scene.text([left, top + 14.0], &Label::new(title, Anchor::Middle).bold());
        let frequency = format!(
            "{}{}Hz",
            number::significant(mode.frequency_hz, 4),
            number::NARROW_SPACE
        );
        scene.text(
            [left, top + 31.0],
            &Label::new(frequency, Anchor::Middle).coloured(BLUE),
        );
        let centre = top + TITLE_PX + 0.5 * (panel_px - TITLE_PX);
        let px = |at: [f64; 3]| {
            let [u, v] = paper(at);
            [left + scale * (u - middle[0]), centre - scale * (v - middle[1])]
        };
        if m % ACROSS == 0 {
            axes(&mut scene, [left - 0.5 * PANEL_PX + 20.0, top + panel_px - 12.0]);
        }
        let shape: Vec<[f64; 2]> = mode.shape.iter().map(|z| [z.re, z.im]).collect();
        let pictures = frame.pictures(&shape, swing_px / scale);
        for wire in &frame.wires {
            let still: Vec<[f64; 2]> = wire.iter().map(|&at| px(frame.places[at])).collect();
            scene.path(&still, Line::new(LIGHT, 1.2));
        }
        for wire in &frame.wires {
            let moving: Vec<Vec<[f64; 2]>> = pictures
                .iter()
                .map(|picture| wire.iter().map(|&at| px(picture[at])).collect())
                .collect();
            scene.moving_path(&moving, PERIOD_S, Line::new(BLUE, 2.0));
        }
        for at in 0..frame.sensors {
            let moving: Vec<[f64; 2]> = pictures.iter().map(|picture| px(picture[at])).collect();
            scene.moving_circle(&moving, PERIOD_S, 3.0, Line::new(GREY, 1.2));
        }
    }
    Some(scene.svg(say(Titles::ModeShapesMoving, language)))
}

/// Directions of x, y and z on paper.
fn axes(scene: &mut Scene, at: [f64; 2]) {
    for (name, way) in [
        ("x", [1.0, 0.0, 0.0]),
        ("y", [0.0, 1.0, 0.0]),
        ("z", [0.0, 0.0, 1.0]),
    ] {
        let [u, v] = paper(way);
        let from_here = |px: f64| [at[0] + px * u, at[1] - px * v];
        scene.arrow(at, from_here(18.0), 5.0, Line::new(GREY, 1.0));
        scene.text(
            from_here(26.0),
            &Label::new(name, Anchor::Middle).small().coloured(GREY),
        );
    }
}

fn paper([x, y, z]: [f64; 3]) -> [f64; 2] {
    [X[0] * x + Y[0] * y, z + X[1] * x + Y[1] * y]
}

/// Scale and position of the structure in its panel.
struct Fit {
    /// px a metre.
    scale: f64,
    /// The centre of the drawing on paper, m.
    middle: [f64; 2],
    /// Its width and height, px.
    size_px: [f64; 2],
}

impl Wires {
    fn fit(&self) -> Fit {
        let mut low = [f64::INFINITY; 2];
        let mut high = [f64::NEG_INFINITY; 2];
        for place in &self.places {
            for (k, value) in paper(*place).into_iter().enumerate() {
                low[k] = low[k].min(value);
                high[k] = high[k].max(value);
            }
        }
        let fits = [0, 1].map(|k| FILLED[k] / (high[k] - low[k]).max(1e-9));
        let middle = [0, 1].map(|k| 0.5 * (low[k] + high[k]));
        let scale = fits[0].min(fits[1]);
        Fit {
            scale,
            middle,
            size_px: [0, 1].map(|k| scale * (high[k] - low[k])),
        }
    }

    /// Positions over one period, with a largest displacement of `most_m`: Re(φ e^{iωt}); the last picture equals the first.
    fn pictures(&self, shape: &[[f64; 2]], most_m: f64) -> Vec<Vec<[f64; 3]>> {
        let parts = self.moved(shape, most_m);
        let picture = |n: usize| {
            let (sin, cos) = (TAU * n as f64 / PICTURES as f64).sin_cos();
            let pairs = self.places.iter().zip(&parts);
            let moved = pairs.map(|(place, [re, im])| {
                let mut at = *place;
                for (k, x) in at.iter_mut().enumerate() {
                    *x += re[k] * cos - im[k] * sin;
                }
                at
            });
            moved.collect()
        };
        (0..=PICTURES).map(picture).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_a_drawing_moves_without_scripts_and_needs_places() {
        let record = dolmen::modal::ReferenceCase::ShearChain
            .made(11)
            .unwrap()
            .make()
            .unwrap();
        let mut modes = dolmen::modal::identify(&record, &Default::default())
            .unwrap()
            .modes;
        assert_eq!(moving_shapes(&modes, Language::English), None);
        for (j, channel) in modes.channels.iter_mut().enumerate() {
            channel.position_m = Some([0.0, 0.0, 3.0 * (j + 1) as f64]);
            channel.direction = Some([1.0, 0.0, 0.0]);
        }
        let svg = moving_shapes(&modes, Language::English).unwrap();
        // two modes of one line and two circles, a circle along both axes
        assert_eq!(svg.matches("<animate ").count(), 2 * (1 + 2 * 2));
        assert!(!svg.contains("<script") && !svg.contains("NaN"), "{svg}");
        let values = svg.split("values=\"").nth(1).unwrap().split('"').next().unwrap();
        let pictures: Vec<&str> = values.split(';').collect();
        assert_eq!((pictures.len(), pictures[0]), (PICTURES + 1, pictures[PICTURES]));
    }

    #[test]
    fn exact_one_period_ends_where_it_began_and_feet_stand_still() {
        let wires = Wires {
            places: vec![[0.0, 0.0, 3.0], [0.0, 0.0, 0.0]],
            sensors: 1,
            channels: vec![(0, [1.0, 0.0, 0.0]), (0, [0.0, 1.0, 0.0])],
            wires: vec![vec![1, 0]],
        };
        let pictures = wires.pictures(&[[2.0, 0.0], [0.0, 2.0]], 0.5);
        assert_eq!(pictures.len(), PICTURES + 1);
        for (n, picture) in pictures.iter().enumerate() {
            // a circle: x leads y by a quarter of a period, each with its share of the largest displacement
            let angle = TAU * n as f64 / PICTURES as f64;
            let part = 0.5 / 2f64.sqrt();
            assert!((picture[0][0] - part * angle.cos()).abs() < 1e-12);
            assert!((picture[0][1] + part * angle.sin()).abs() < 1e-12);
            assert_eq!(picture[1], [0.0, 0.0, 0.0]);
        }
    }
}
