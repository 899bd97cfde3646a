//! A stack in the plane of its loads: its stones, the forces on them, and the pivots of its joints.

use super::hull::hull;
use super::ink::{Anchor, BLUE, Label, Line, STONE, TEXT, VERMILLION};
use super::scene::Scene;
use super::stack_view::bounds;
use super::words::say;
use dolmen::assess::StackUnderLoads;
use dolmen::structure::stack::Stack;
use dolmen_words::{Language, messages, number};

/// Room for the drawing, px.
const ROOM_PX: [f64; 2] = [420.0, 420.0];
/// Margin around it, px.
const MARGIN_PX: f64 = 26.0;
/// Space for arrows next to the stack, px; the longest arrow has this length.
const ARROWS_PX: f64 = 90.0;
/// Room below it for words, px.
const FOOT_PX: f64 = 60.0;
/// Radius of a hinge, px.
const HINGE_PX: f64 = 4.0;
/// Length of the head of an arrow, px.
const HEAD_PX: f64 = 6.0;
/// Arrows shorter than this are not drawn, px.
const SHORTEST_PX: f64 = 2.0;

messages! {
    /// Words of a stack under loads.
    pub(crate) enum Shown in "figure.pushed" {
        Title => { en: "The stack under its loads", ko: "하중을 받는 적층 구조" },
        Wind(longest: String) => { en: "wind; the longest arrow is {longest}", ko: "풍하중(가장 긴 화살표 {longest})" },
        Load(longest: String) => { en: "static load; the longest arrow is {longest}", ko: "정하중(가장 긴 화살표 {longest})" },
        Hinge => { en: "where an open joint stays closed", ko: "벌어진 접합면에서 닿아 있는 곳" },
    }
}

/// An arrow: its point of action, its force in the plane of the figure, its colour.
struct Arrow {
    at: [f64; 2],
    force: [f64; 2],
    colour: &'static str,
}

/// The stones at true scale in the plane of the wind, or of the largest static load, without factors of a combination.
pub(crate) fn stack_pushed(stack: &Stack, under: &StackUnderLoads, language: Language) -> String {
    let way = under.wind_to.unwrap_or_else(|| plane_of_loads(stack));
    let flat = |at: [f64; 3]| [way[0] * at[0] + way[1] * at[1], at[2]];
    let outlines: Vec<Vec<[f64; 2]>> = stack
        .blocks()
        .iter()
        .map(|block| hull(block.solid.vertices_m().iter().map(|at| flat(*at)).collect()))
        .collect();
    let wind = under.blown.iter().map(|of| Arrow {
        at: flat(of.position_m),
        force: [of.force_n, 0.0],
        colour: BLUE,
    });
    let loads = stack.static_loads().iter().map(|load| Arrow {
        at: flat(load.position_m),
        force: flat(load.force_n),
        colour: VERMILLION,
    });
    let arrows: Vec<Arrow> = wind.chain(loads).collect();
    let size = |arrow: &Arrow| arrow.force[0].hypot(arrow.force[1]);
    let longest = arrows.iter().map(size).fold(0.0, f64::max);
    let [low, high] = bounds(outlines.iter().flatten().copied());
    let extent = [high[0] - low[0], high[1] - low[1]];
    let scale = (ROOM_PX[0] / extent[0]).min(ROOM_PX[1] / extent[1]);
    let foot = MARGIN_PX + ARROWS_PX + scale * extent[1];
    let width = 2.0 * (MARGIN_PX + ARROWS_PX) + ROOM_PX[0];
    let left = 0.5 * (width - scale * extent[0]);
    let px = |at: &[f64; 2]| [left + scale * (at[0] - low[0]), foot - scale * (at[1] - low[1])];
    let mut scene = Scene::new(width, foot + FOOT_PX);
    for corners in &outlines {
        let corners: Vec<[f64; 2]> = corners.iter().map(px).collect();
        scene.polygon(&corners, STONE, Line::new(TEXT, 1.0));
    }
    scene.line([MARGIN_PX, foot], [width - MARGIN_PX, foot], Line::new(TEXT, 1.0));
    for of in &arrows {
        arrow(&mut scene, px(&of.at), of, ARROWS_PX / longest);
    }
    let joints = under
        .found
        .mechanism
        .iter()
        .flat_map(|mechanism| &mechanism.joints);
    for at in joints.filter_map(|joint| joint.closed_at_m) {
        scene.circle(px(&flat(at)), HINGE_PX, "#ffffff", Line::new(TEXT, 1.8));
    }
    legend(&mut scene, foot + 18.0, &arrows, language);
    scene.svg(say(Shown::Title, language))
}

/// A unit vector in plan along the largest horizontal load; along x if all are vertical.
fn plane_of_loads(stack: &Stack) -> [f64; 2] {
    let horizontal = |force: [f64; 3]| force[0].hypot(force[1]);
    let loads = stack.static_loads().iter().map(|load| load.force_n);
    let largest = loads.max_by(|a, b| horizontal(*a).total_cmp(&horizontal(*b)));
    match largest {
        Some(force) if horizontal(force) > 0.0 => [0, 1].map(|axis| force[axis] / horizontal(force)),
        _ => [1.0, 0.0],
    }
}

/// An arrow that ends at the point of action.
fn arrow(scene: &mut Scene, end: [f64; 2], of: &Arrow, px_per_n: f64) {
    let along = [of.force[0] * px_per_n, -of.force[1] * px_per_n];
    let length = along[0].hypot(along[1]);
    if !length.is_finite() || length < SHORTEST_PX {
        return;
    }
    let start = [end[0] - along[0], end[1] - along[1]];
    scene.line(start, end, Line::new(of.colour, 1.8));
    let unit = along.map(|part| part / length);
    let head = HEAD_PX.min(length);
    for side in [-0.5, 0.5] {
        let back = [
            end[0] - head * (unit[0] - side * unit[1]),
            end[1] - head * (unit[1] + side * unit[0]),
        ];
        scene.line(back, end, Line::new(of.colour, 1.8));
    }
}

fn legend(scene: &mut Scene, from: f64, arrows: &[Arrow], language: Language) {
    let mut at = from;
    let longest = |colour: &str| {
        let of = arrows.iter().filter(|arrow| arrow.colour == colour);
        of.map(|arrow| arrow.force[0].hypot(arrow.force[1]))
            .fold(0.0, f64::max)
    };
    let said = |force_n: f64| {
        let (value, unit) = match force_n >= 1e3 {
            true => (force_n / 1e3, "kN"),
            false => (force_n, "N"),
        };
        format!("{}{}{unit}", number::significant(value, 3), number::NARROW_SPACE)
    };
    for (colour, force_n) in [(BLUE, longest(BLUE)), (VERMILLION, longest(VERMILLION))] {
        if force_n > 0.0 {
            let words = match colour == BLUE {
                true => Shown::Wind(said(force_n)),
                false => Shown::Load(said(force_n)),
            };
            scene.line([MARGIN_PX, at], [MARGIN_PX + 20.0, at], Line::new(colour, 1.8));
            let words = say(words, language);
            scene.text([MARGIN_PX + 28.0, at], &Label::new(words, Anchor::Start).small());
            at += 14.0;
        }
    }
    scene.circle([MARGIN_PX + 10.0, at], HINGE_PX, "#ffffff", Line::new(TEXT, 1.8));
    let words = say(Shown::Hinge, language);
    scene.text([MARGIN_PX + 28.0, at], &Label::new(words, Anchor::Start).small());
}
