//! The damage map of an inspection: numbered marks on the elevations.

use super::elevation::elevations;
use super::ink::{Anchor, BLACK, Label, Line, ORANGE, VERMILLION};
use super::scene::Scene;
use super::sheet::{View, put_names, put_outlines, sheet};
use super::words::say;
use dolmen_project::{Severity, Structure};
use dolmen_words::{Language, messages};

/// Radius of a mark, px.
const MARK_PX: f64 = 7.5;

messages! {
    /// Words of elevations.
    pub(crate) enum Mapped in "figure.damage" {
        Title => { en: "Damage map", ko: "외관조사망도" },
        Front => { en: "front (x across)", ko: "정면(x 방향)" },
        Side => { en: "side (y across)", ko: "측면(y 방향)" },
    }
}

/// One mark, numbered by its position in the list from 1.
#[derive(Clone, Debug)]
pub(crate) struct DamageMark {
    pub(crate) part: String,
    /// x, y, z, m; the middle of the part if unknown.
    pub(crate) at_m: Option<[f64; 3]>,
    pub(crate) severity: Option<Severity>,
}

/// The elevations with the marks; `None` if the structure cannot be drawn.
pub(crate) fn damage_map(structure: &Structure, marks: &[DamageMark], language: Language) -> Option<String> {
    let sheet = sheet(elevations(structure, false))?;
    let mut scene = Scene::new(sheet.width_px, sheet.ground_px + 34.0);
    let several = sheet.views.len() > 1;
    for (number, view) in sheet.views.iter().enumerate() {
        put_outlines(&mut scene, view, sheet.ground_px);
        if number == 0 {
            put_names(&mut scene, view, sheet.ground_px);
        }
        put_marks(&mut scene, view, marks);
        if several {
            put_view_name(&mut scene, view, sheet.ground_px + 20.0, language);
        }
    }
    Some(scene.svg(say(Mapped::Title, language)))
}

/// The direction of a view, below it.
pub(super) fn put_view_name(scene: &mut Scene, view: &View, y: f64, language: Language) {
    let name = match view.elevation.axis {
        0 => Mapped::Front,
        _ => Mapped::Side,
    };
    let middle = 0.5 * (view.left_px() + view.right_px);
    scene.text(
        [middle, y],
        &Label::new(say(name, language), Anchor::Middle).small(),
    );
}

fn put_marks(scene: &mut Scene, view: &View, marks: &[DamageMark]) {
    let mut taken: Vec<[f64; 2]> = Vec::new();
    for (number, mark) in (1..).zip(marks) {
        let part = view.elevation.parts.iter().find(|part| part.name == mark.part);
        let own = mark.at_m.map(|at| [at[view.elevation.axis], at[2]]);
        let Some(at) = own.or_else(|| part.map(|part| part.middle())) else {
            continue;
        };
        let mut place = view.px(at);
        // next to existing marks
        while taken
            .iter()
            .any(|other| (other[0] - place[0]).hypot(other[1] - place[1]) < 2.0 * MARK_PX)
        {
            place[0] += 2.0 * MARK_PX + 1.0;
        }
        taken.push(place);
        let (fill, ink) = match mark.severity {
            Some(Severity::Severe) => (VERMILLION, "#ffffff"),
            Some(Severity::Moderate) => (ORANGE, BLACK),
            Some(Severity::Slight) | None => ("#ffffff", BLACK),
        };
        scene.circle(place, MARK_PX, fill, Line::new(BLACK, 1.0));
        let label = Label {
            size: 9.5,
            ..Label::new(number.to_string(), Anchor::Middle)
                .coloured(ink)
                .bold()
        };
        scene.text(place, &label);
    }
}
