//! A stack with moved supports: its displaced stones over their original outlines.

use super::hull::hull;
use super::ink::{Anchor, GREY, Label, Line, STONE, TEXT, VERMILLION};
use super::scene::Scene;
use super::stack_view::bounds;
use super::words::say;
use dolmen::stability::stack::MovedStack;
use dolmen::structure::stack::{Solid, Stack};
use dolmen_words::{Language, messages, number};

/// Room for the drawing, px.
const ROOM_PX: [f64; 2] = [520.0, 380.0];
/// Margin around it, px.
const MARGIN_PX: f64 = 26.0;
/// Space below it for the scale bar and text, px.
const FOOT_PX: f64 = 46.0;
/// Radius of a hinge, px.
const HINGE_PX: f64 = 4.0;

messages! {
    /// Words of a stack whose supports moved.
    pub(crate) enum Shown in "figure.supports" {
        Title => { en: "The stack on its moved supports", ko: "지점이 움직인 적층 구조" },
        AsDrawn => { en: "dashed: as drawn", ko: "점선: 원래 형상" },
        Hinge => { en: "hinge: where an open joint stays closed", ko: "힌지: 벌어진 접합면에서 닿아 있는 곳" },
    }
}

/// The stones of a displaced state at true scale, seen along y, or along x if the supports move more across than along.
pub(crate) fn moved_supports(stack: &Stack, moved: &MovedStack, language: Language) -> String {
    let along = |axis: usize| -> f64 {
        let each = stack.support_movements().iter();
        each.map(|movement| movement.movement_m[axis].abs())
            .fold(0.0, f64::max)
    };
    let axis = usize::from(along(1) > along(0));
    let outline = |solid: &Solid| -> Vec<[f64; 2]> {
        hull(solid.vertices_m().iter().map(|at| [at[axis], at[2]]).collect())
    };
    let drawn: Vec<Vec<[f64; 2]>> = stack.blocks().iter().map(|block| outline(&block.solid)).collect();
    let now: Vec<Vec<[f64; 2]>> = moved.solids.iter().map(outline).collect();
    let [low, high] = bounds(drawn.iter().chain(&now).flatten().copied());
    let size = [high[0] - low[0], high[1] - low[1]];
    let scale = (ROOM_PX[0] / size[0]).min(ROOM_PX[1] / size[1]);
    let foot = MARGIN_PX + scale * size[1];
    let width = 2.0 * MARGIN_PX + (scale * size[0]).max(ROOM_PX[0]);
    let left = 0.5 * (width - scale * size[0]);
    let px = |at: &[f64; 2]| [left + scale * (at[0] - low[0]), foot - scale * (at[1] - low[1])];
    let mut scene = Scene::new(width, foot + FOOT_PX);
    let closed =
        |corners: &[[f64; 2]]| -> Vec<[f64; 2]> { corners.iter().chain(corners.first()).map(px).collect() };
    for corners in &now {
        let corners: Vec<[f64; 2]> = corners.iter().map(px).collect();
        scene.polygon(&corners, STONE, Line::new(TEXT, 1.0));
    }
    for corners in &drawn {
        scene.path(&closed(corners), Line::new(GREY, 0.8).dashed());
    }
    let joints = moved.mechanism.iter().flat_map(|mechanism| &mechanism.joints);
    for at in joints.filter_map(|joint| joint.closed_at_m) {
        let at = px(&[at[axis], at[2]]);
        scene.circle(at, HINGE_PX, "#ffffff", Line::new(VERMILLION, 2.0));
    }
    let below = foot + 22.0;
    let bar = bar(&mut scene, [left, below], scale);
    let mut from = bar + 24.0;
    scene.line([from, below], [from + 26.0, below], Line::new(GREY, 0.8).dashed());
    let words = say(Shown::AsDrawn, language);
    from += 32.0;
    scene.text([from, below], &Label::new(words, Anchor::Start).small());
    let second = below + 16.0;
    scene.circle(
        [left + 5.0, second],
        HINGE_PX,
        "#ffffff",
        Line::new(VERMILLION, 2.0),
    );
    let words = say(Shown::Hinge, language);
    scene.text([left + 16.0, second], &Label::new(words, Anchor::Start).small());
    scene.svg(say(Shown::Title, language))
}

/// A scale bar of a round length with its label; returns its end, px.
fn bar(scene: &mut Scene, at: [f64; 2], scale: f64) -> f64 {
    let rough = 90.0 / scale;
    let power = 10f64.powf(rough.log10().floor());
    let fits = [5.0, 2.0, 1.0].map(|n| n * power);
    let length = fits.into_iter().find(|length| *length <= rough).unwrap_or(power);
    let end = [at[0] + scale * length, at[1]];
    scene.line(at, end, Line::new(TEXT, 2.0));
    for x in [at[0], end[0]] {
        scene.line([x, at[1] - 4.0], [x, at[1] + 4.0], Line::new(TEXT, 1.2));
    }
    let words = format!("{}{}m", number::trimmed(length, 2), number::NARROW_SPACE);
    scene.text([end[0] + 6.0, at[1]], &Label::new(words, Anchor::Start).small());
    end[0] + 42.0
}
