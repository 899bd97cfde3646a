//! Measured modes compared with those of the model: MAC matrix of their shapes at the sensors.

use super::ink::{Anchor, LIGHT, Label, Line, TEXT, VERMILLION};
use super::likeness::{DARK, PRINTED, shade};
use super::scene::Scene;
use super::words::{Modal, Titles, say};
use dolmen_words::Language;
use dolmen_words::number::{NARROW_SPACE, fixed, significant};
use dolmen_work::model_modes::{ModelModes, WhichMode};

/// Largest width of the figure, and width of its title, px.
const WIDTH_PX: f64 = 680.0;
const TITLE_PX: f64 = 340.0;
/// Space to the left of the matrix and above it, and the largest side of a cell, px.
const LEFT_PX: f64 = 120.0;
const ABOVE_PX: f64 = 66.0;
const CELL_MOST_PX: f64 = 46.0;

/// One row per measured mode, one column per mode of the model; a frame marks a pair.
pub(crate) fn model_likeness(model: &ModelModes, language: Language) -> String {
    let columns = model.of_model.len().max(1) as f64;
    let cell = ((WIDTH_PX - LEFT_PX - 8.0) / columns).min(CELL_MOST_PX);
    let height = ABOVE_PX + cell * model.measured.len() as f64 + 8.0;
    let width = (LEFT_PX + cell * columns + 8.0).max(TITLE_PX);
    let mut scene = Scene::new(width, height);
    let title = Label::new(say(Modal::AssuranceWithModel, language), Anchor::Start).bold();
    scene.text([0.0, 12.0], &title);
    let hertz = |hz: f64| format!("{}{NARROW_SPACE}Hz", significant(hz, 3));
    let small = |text: String, anchor: Anchor| Label::new(text, anchor).small();
    for (at, of) in model.of_model.iter().enumerate() {
        let middle = LEFT_PX + (at as f64 + 0.5) * cell;
        let number = match of.count {
            1 => format!("{}", of.first + 1),
            count => format!("{}–{}", of.first + 1, of.first + count),
        };
        scene.text([middle, ABOVE_PX - 24.0], &small(number, Anchor::Middle));
        let frequency = significant(of.frequency_hz, 3);
        scene.text([middle, ABOVE_PX - 9.0], &small(frequency, Anchor::Middle));
    }
    let heads = [
        (Modal::OfModel, ABOVE_PX - 24.0),
        (Modal::OfModelHertz, ABOVE_PX - 9.0),
    ];
    for (words, y) in heads {
        scene.text([LEFT_PX - 10.0, y], &small(say(words, language), Anchor::End));
    }
    for (row, mode) in model.measured.iter().enumerate() {
        let top = ABOVE_PX + row as f64 * cell;
        let name = format!(
            "{} {}: {}",
            say(Modal::Mode, language),
            row + 1,
            hertz(mode.frequency_hz)
        );
        scene.text([LEFT_PX - 10.0, top + 0.5 * cell], &small(name, Anchor::End));
        for (at, value) in mode.assurance.iter().enumerate() {
            let x = LEFT_PX + at as f64 * cell;
            let corners = [[x, top], [x + cell, top], [x + cell, top + cell], [x, top + cell]];
            scene.polygon(&corners, &shade(*value), Line::new(LIGHT, 0.8));
            if *value >= PRINTED && cell >= 22.0 {
                let ink = if *value >= DARK { "#ffffff" } else { TEXT };
                let label = small(fixed(*value, 2), Anchor::Middle).coloured(ink);
                scene.text([x + 0.5 * cell, top + 0.5 * cell], &label);
            }
        }
    }
    for (row, mode) in model.measured.iter().enumerate() {
        if let WhichMode::One(at) = mode.is {
            let (x, top) = (
                LEFT_PX + at as f64 * cell + 1.0,
                ABOVE_PX + row as f64 * cell + 1.0,
            );
            let side = cell - 2.0;
            let corners = [[x, top], [x + side, top], [x + side, top + side], [x, top + side]];
            scene.polygon(&corners, "none", Line::new(VERMILLION, 2.0));
        }
    }
    scene.svg(say(Titles::LikenessWithModel, language))
}
