//! Motion of a floor in plan in the modes of a stiffness from vibration.

use super::ink::{Anchor, BLACK, BLUE, GREEN, GREY, Label, Line, PURPLE, STONE, Shape, VERMILLION};
use super::scene::Scene;
use super::words::{Titles, say};
use dolmen::structure::building::{Outline, PlanSolution};
use dolmen_words::Language;
use dolmen_words::number::significant;
use dolmen_work::building::PlanAnswer;

/// Largest width and height of a drawn floor, px.
const FLOOR_PX: [f64; 2] = [150.0, 130.0];
/// Space around it, px, for the displaced floor.
const ROOM_PX: f64 = 40.0;
/// Height of the text above each, px.
const WORDS_PX: f64 = 24.0;
/// √(u² + v² + (ρθ)²) in the drawing, as a fraction of the smaller side of the floor. Our choice.
const MOVES: f64 = 0.2;
/// Colours of the modes.
const COLOURS: [&str; 3] = [BLUE, VERMILLION, GREEN];

/// The floor at rest and displaced in each of its three modes, side by side.
pub(crate) fn plan_modes(answer: &PlanAnswer, one: &PlanSolution, language: Language) -> String {
    let (centre, radius) = (answer.centre_of_mass_m, answer.storey.gyration_m);
    let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let square = square.map(|[x, y]| [centre[0] + radius * x, centre[1] + radius * y]);
    let corners = answer
        .outline
        .as_ref()
        .map_or(square.as_slice(), Outline::corners_m);
    let extent = |axis: usize| {
        let values = corners.iter().map(|corner| corner[axis]);
        values.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], at| {
            [least.min(at), most.max(at)]
        })
    };
    let ([left, right], [bottom, top]) = (extent(0), extent(1));
    let scale = (FLOOR_PX[0] / (right - left)).min(FLOOR_PX[1] / (top - bottom));
    let amplitude = MOVES * (right - left).min(top - bottom);
    let width = (right - left) * scale + 2.0 * ROOM_PX;
    let height = (top - bottom) * scale + 2.0 * ROOM_PX + WORDS_PX;
    let mut scene = Scene::new(3.0 * width, height);
    for (at, (mode, shape)) in answer.modes.iter().zip(&one.shapes).enumerate() {
        let px = |[x, y]: [f64; 2]| {
            [
                at as f64 * width + ROOM_PX + (x - left) * scale,
                WORDS_PX + ROOM_PX + (top - y) * scale,
            ]
        };
        let [u, v, turn] = [
            amplitude * shape[0],
            amplitude * shape[1],
            amplitude * shape[2] / radius,
        ];
        let (sin, cos) = turn.sin_cos();
        let moved = |[x, y]: [f64; 2]| {
            let (x, y) = (x - centre[0], y - centre[1]);
            px([
                centre[0] + u + cos * x - sin * y,
                centre[1] + v + sin * x + cos * y,
            ])
        };
        let rest: Vec<[f64; 2]> = corners.iter().map(|&corner| px(corner)).collect();
        let swung: Vec<[f64; 2]> = corners.iter().map(|&corner| moved(corner)).collect();
        scene.polygon(&swung, STONE, Line::new(COLOURS[at], 1.8));
        scene.polygon(&rest, "none", Line::new(GREY, 1.0).dashed());
        scene.marker(moved(centre), Shape::Circle, 3.5, BLACK);
        let rigidity = [0, 1].map(|axis| centre[axis] + one.eccentricity_m[axis]);
        scene.marker(px(rigidity), Shape::Cross, 5.0, PURPLE);
        let hertz = format!("{}\u{202f}Hz", significant(mode.frequency_hz, 3));
        let label = Label::new(hertz, Anchor::Middle).bold().coloured(COLOURS[at]);
        scene.text([(at as f64 + 0.5) * width, 18.0], &label);
    }
    scene.svg(say(Titles::PlanModes, language))
}
