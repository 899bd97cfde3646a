//! Similarity of mode shapes (MAC matrix), and their complexity: the components in the complex plane.

use super::ink::{Anchor, BLACK, BLUE, GREY, LIGHT, Label, Line, TEXT};
use super::scene::Scene;
use super::words::{Modal, Titles, say};
use dolmen::modal::{Mode, Modes, assurance};
use dolmen_words::Language;
use dolmen_words::number;

/// Largest number of modes: the lowest in frequency.
const MODES_MOST: usize = 12;
/// Width of the figure and of the matrix with its labels, px.
const WIDTH_PX: f64 = 680.0;
const MATRIX_PX: f64 = 300.0;
/// Space to the left of the matrix and above it, px.
const LABELS_PX: f64 = 74.0;
const ABOVE_PX: f64 = 44.0;
/// Side of a cell at most, px.
const CELL_MOST_PX: f64 = 44.0;
/// Panels of components per row, and the height of the text above each circle, px.
const ACROSS: usize = 4;
const TITLE_PX: f64 = 34.0;
/// Smallest printed value; smaller cells are nearly white.
pub(super) const PRINTED: f64 = 0.05;
/// From this value on cells are dark, with a white number.
pub(super) const DARK: f64 = 0.55;

/// The matrix and the components; `None` for fewer than two modes or two channels.
pub fn likeness(modes: &Modes, language: Language) -> Option<String> {
    let shown = &modes.modes[..modes.modes.len().min(MODES_MOST)];
    if shown.len() < 2 || modes.channels.len() < 2 {
        return None;
    }
    let cell = ((MATRIX_PX - LABELS_PX) / shown.len() as f64).min(CELL_MOST_PX);
    let panel = (WIDTH_PX - MATRIX_PX - 24.0) / ACROSS as f64;
    let rows = shown.len().div_ceil(ACROSS) as f64;
    let height = (ABOVE_PX + cell * shown.len() as f64).max(rows * (TITLE_PX + panel)) + 14.0;
    let mut scene = Scene::new(WIDTH_PX, height);
    matrix(&mut scene, shown, cell, language);
    for (m, mode) in shown.iter().enumerate() {
        let left = MATRIX_PX + 24.0 + (m % ACROSS) as f64 * panel;
        let top = (m / ACROSS) as f64 * (TITLE_PX + panel);
        components(&mut scene, (m + 1, mode), ([left, top], panel));
    }
    Some(scene.svg(say(Titles::LikenessOfModes, language)))
}

fn matrix(scene: &mut Scene, shown: &[Mode], cell: f64, language: Language) {
    let title = Label::new(say(Modal::Assurance, language), Anchor::Start).bold();
    scene.text([0.0, 14.0], &title);
    for (i, a) in shown.iter().enumerate() {
        let y = ABOVE_PX + i as f64 * cell;
        let hz = format!(
            "{}{}Hz",
            number::significant(a.frequency_hz, 3),
            number::NARROW_SPACE
        );
        scene.text(
            [LABELS_PX - 6.0, y + 0.5 * cell + 4.0],
            &Label::new(hz, Anchor::End).small(),
        );
        let column = Label::new(format!("{}", i + 1), Anchor::Middle).small();
        scene.text([LABELS_PX + (i as f64 + 0.5) * cell, ABOVE_PX - 6.0], &column);
        scene.text(
            [2.0, y + 0.5 * cell + 4.0],
            &Label::new(format!("{}", i + 1), Anchor::Start).small(),
        );
        for (j, b) in shown.iter().enumerate() {
            let value = assurance(&a.shape, &b.shape);
            let x = LABELS_PX + j as f64 * cell;
            let corners = [[x, y], [x + cell, y], [x + cell, y + cell], [x, y + cell]];
            scene.polygon(&corners, &shade(value), Line::new(LIGHT, 0.8));
            if value >= PRINTED && cell >= 22.0 {
                let ink = if value >= DARK { "#ffffff" } else { TEXT };
                let label = Label::new(number::fixed(value, 2), Anchor::Middle)
                    .small()
                    .coloured(ink);
                scene.text([x + 0.5 * cell, y + 0.5 * cell + 4.0], &label);
            }
        }
    }
}

/// White for 0, blue for 1.
pub(super) fn shade(value: f64) -> String {
    let [red, green, blue] = [0x00, 0x72, 0xb2].map(|full: u8| {
        let part = 255.0 - value.clamp(0.0, 1.0) * (255.0 - f64::from(full));
        part.round() as u8
    });
    format!("#{red:02x}{green:02x}{blue:02x}")
}

/// Each channel's component as a line from the centre, the largest with length 1.
fn components(scene: &mut Scene, (number, mode): (usize, &Mode), ([left, top], side): ([f64; 2], f64)) {
    let middle = [left + 0.5 * side, top + TITLE_PX + 0.5 * side];
    let radius = 0.5 * side - 8.0;
    let hertz = number::significant(mode.frequency_hz, 3);
    let title = format!("{number} · {hertz}{}Hz", number::NARROW_SPACE);
    scene.text(
        [middle[0], top + 14.0],
        &Label::new(title, Anchor::Middle).small(),
    );
    let real = format!("MPC {}", number::fixed(mode.phase_collinearity, 2));
    scene.text(
        [middle[0], top + 28.0],
        &Label::new(real, Anchor::Middle).small().coloured(GREY),
    );
    scene.circle(middle, radius, "none", Line::new(LIGHT, 1.0));
    scene.line(
        [middle[0] - radius, middle[1]],
        [middle[0] + radius, middle[1]],
        Line::new(LIGHT, 1.0),
    );
    for z in &mode.shape {
        let end = [middle[0] + radius * z.re, middle[1] - radius * z.im];
        scene.line(middle, end, Line::new(BLUE, 1.4));
        scene.circle(end, 1.8, BLUE, Line::new(BLACK, 0.0));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen::modal::{Identify, ReferenceCase, identify};

    #[test]
    fn draws_every_pair_of_modes_and_every_component() {
        let record = ReferenceCase::ShearChain.made(1).unwrap().make().unwrap();
        let modes = identify(&record, &Identify::default()).unwrap().modes;
        let svg = likeness(&modes, Language::English).unwrap();
        assert_eq!(
            svg.matches("1.00").count(),
            2 + svg.matches("MPC 1.00").count(),
            "{svg}"
        );
        let between = assurance(&modes.modes[0].shape, &modes.modes[1].shape);
        assert_eq!(
            svg.matches(&format!(">{between:.2}<")).count(),
            if between < PRINTED { 0 } else { 2 }
        );
        let alone = Modes {
            modes: modes.modes[..1].to_vec(),
            ..modes
        };
        assert_eq!(likeness(&alone, Language::English), None);
    }

    #[test]
    fn exact_shades() {
        assert_eq!((shade(0.0).as_str(), shade(1.0).as_str()), ("#ffffff", "#0072b2"));
        assert_eq!(shade(0.5), "#80b9d9");
    }
}
