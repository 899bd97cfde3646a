//! Sketch of a frame: storeys with heights, masses, axial forces and stiffness.

use super::chain::part_name;
use super::ink::{Anchor, BLACK, BLUE, GREY, Label, Line, STONE, verdict_colour, verdict_shape};
use super::scene::Scene;
use super::words::{Signs, Titles, say};
use dolmen::stability::{FrameStability, Verdict};
use dolmen::structure::Frame;
use dolmen_words::Language;
use dolmen_words::number::{self, subscript};

/// Height of the drawn frame, px.
const SKETCH_PX: f64 = 250.0;

/// The frame's storeys with heights to scale, on the visible columns, with their loads, and the verdict on each storey's margin.
pub fn frame_sketch(
    frame: &Frame,
    (names, columns): (&[Option<String>], &[usize]),
    stability: Option<&FrameStability>,
    language: Language,
) -> String {
    let storeys = frame.storeys();
    let total: f64 = storeys.iter().map(|s| s.height_m).sum();
    let scale = SKETCH_PX / total;
    let (top, bottom) = (34.0, 34.0 + SKETCH_PX);
    let mut scene = Scene::new(520.0, bottom + 26.0);
    let (left, right) = (70.0, 240.0);
    let masses: Vec<f64> = storeys.iter().map(|s| s.mass_kg).collect();
    let forces: Vec<f64> = storeys.iter().map(|s| s.axial_n).collect();
    let (mass_unit, force_unit) = (number::prefix(&masses, "kg"), number::prefix(&forces, "N"));

    scene.line(
        [left - 26.0, bottom],
        [right + 26.0, bottom],
        Line::new(GREY, 1.5),
    );
    for i in 0..13 {
        let x = left - 26.0 + 17.0 * f64::from(i);
        scene.line([x + 8.0, bottom], [x, bottom + 7.0], Line::new(GREY, 0.8));
    }
    let mut base_m = 0.0;
    for (i, storey) in storeys.iter().enumerate() {
        let (low, high) = (
            bottom - base_m * scale,
            bottom - (base_m + storey.height_m) * scale,
        );
        // upper storeys of gates and pagodas are set back
        let inset = 14.0 * i as f64;
        let (first, last) = (left + inset + 8.0, right - inset - 8.0);
        let number = columns.get(i).copied().unwrap_or(2);
        for at in 0..number {
            let x = match number {
                1 => 0.5 * (first + last),
                several => first + (last - first) * at as f64 / (several - 1) as f64,
            };
            scene.line([x, low], [x, high + 7.0], Line::new(BLACK, 2.2));
        }
        let floor = [
            [left + inset - 8.0, high - 7.0],
            [right - inset + 8.0, high - 7.0],
            [right - inset + 8.0, high + 7.0],
            [left + inset - 8.0, high + 7.0],
        ];
        scene.polygon(&floor, STONE, Line::new(BLACK, 1.2));
        let middle = 0.5 * (low + high);
        let arrow_x = left - 40.0;
        scene.line([arrow_x, low], [arrow_x, high], Line::new(GREY, 0.9));
        for y in [low, high] {
            scene.line([arrow_x - 4.0, y], [arrow_x + 4.0, y], Line::new(GREY, 0.9));
        }
        let height = format!(
            "{}{}m",
            number::significant(storey.height_m, 3),
            number::NARROW_SPACE
        );
        scene.text(
            [arrow_x + 6.0, middle],
            &Label::new(height, Anchor::Start).small().coloured(GREY),
        );

        let mass = format!("m{} = {}", subscript(i + 1), mass_unit.trimmed(storey.mass_kg, 4));
        scene.text([282.0, high], &Label::new(mass, Anchor::Start));
        let name = part_name(names, i, &say(Signs::Storey, language));
        scene.text([282.0, middle - 9.0], &Label::new(name, Anchor::Start).bold());
        let axial = format!(
            "{} N{} = {}",
            say(Signs::AxialForce, language),
            subscript(i + 1),
            force_unit.trimmed(storey.axial_n, 4)
        );
        scene.text(
            [282.0, middle + 8.0],
            &Label::new(axial, Anchor::Start).small().coloured(GREY),
        );
        if let Some(storey) = stability.and_then(|s| s.storeys.get(i)) {
            margin(&mut scene, storey.margin, middle, language);
        }
        let spring = spring_path([0.5 * (left + right) + 14.0, middle], 46.0);
        scene.path(&spring, Line::new(BLUE, 1.6));
        scene.text(
            [0.5 * (left + right) + 36.0, middle - 14.0],
            &Label::new(format!("k{}", subscript(i + 1)), Anchor::Middle).coloured(BLUE),
        );
        base_m += storey.height_m;
    }
    scene.text(
        [8.0, top - 22.0],
        &Label::new(say(Signs::HeightsToScale, language), Anchor::Start)
            .small()
            .coloured(GREY),
    );
    scene.svg(say(Titles::SketchOfTheFrame, language))
}

/// The mark and the words of a storey's margin.
fn margin(scene: &mut Scene, margin: Option<f64>, middle: f64, language: Language) {
    let verdict = margin.map_or(Verdict::Unstable, Verdict::of_load_factor);
    scene.marker(
        [288.0, middle + 25.0],
        verdict_shape(verdict),
        5.0,
        verdict_colour(verdict),
    );
    let margin = margin.map_or("–".into(), |m| number::beside_one(m, 3));
    let words = say(Signs::Margin, language);
    scene.text(
        [300.0, middle + 25.0],
        &Label::new(format!("{words} {margin}"), Anchor::Start).small(),
    );
}

/// A horizontal zigzag of this length from a point to the right.
fn spring_path(from: [f64; 2], length: f64) -> Vec<[f64; 2]> {
    const TEETH: usize = 8;
    let step = length / (TEETH + 2) as f64;
    let mut points = vec![from, [from[0] + step, from[1]]];
    for i in 0..TEETH {
        let up = if i % 2 == 0 { -5.0 } else { 5.0 };
        points.push([from[0] + step * (i as f64 + 1.5), from[1] + up]);
    }
    points.push([from[0] + step * (TEETH + 1) as f64, from[1]]);
    points.push([from[0] + length, from[1]]);
    points
}
