//! A building: its plan with centres.

use super::ink::{Anchor, BLACK, BLUE, GREEN, GREY, Label, Line, ORANGE, PURPLE, STONE, Shape, VERMILLION};
use super::scene::Scene;
use super::words::{Signs, Titles, say};
use dolmen_words::Language;
use dolmen_words::number::significant;
use dolmen_work::building::StandingBuilding;

/// Largest width and height of the drawn floor, px.
const FLOOR_PX: [f64; 2] = [380.0, 300.0];
/// Space around the floor, px, for mode centres outside it.
const ROOM_PX: f64 = 90.0;
/// Width of the text next to the plan, px.
const WORDS_PX: f64 = 270.0;
/// Number of mode centres drawn. Our choice: the modes that sway both ways and twist.
const MODES_DRAWN: usize = 3;
/// Colours of the modes.
const MODE_COLOURS: [&str; MODES_DRAWN] = [BLUE, VERMILLION, GREEN];
/// Drawn length of the longest wall, as a fraction of the smaller side of the floor.
const WALL_LONGEST: f64 = 0.28;

/// From plan coordinates to px.
struct View {
    scale: f64,
    left_m: f64,
    top_m: f64,
    size_px: [f64; 2],
    /// Middle of the left and the right edge of the floor.
    middle_m: f64,
}

impl View {
    fn px(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [
            ROOM_PX + (x - self.left_m) * self.scale,
            ROOM_PX + (self.top_m - y) * self.scale,
        ]
    }

    /// A point, moved to the edge of the picture if it is beyond.
    fn clamped(&self, at: [f64; 2]) -> Clamped {
        let px = self.px(at);
        let most = self.size_px;
        let inside = |axis: usize| (14.0..=most[axis] - 14.0).contains(&px[axis]);
        Clamped {
            px: [0, 1].map(|axis| px[axis].clamp(14.0, most[axis] - 14.0)),
            is_beyond: !(inside(0) && inside(1)),
        }
    }
}

/// A point within the picture.
struct Clamped {
    px: [f64; 2],
    /// Whether the original point is beyond the picture.
    is_beyond: bool,
}

/// The top floor in plan with the walls below it, its centre of mass and of rigidity, the centres of the lowest modes, and dampers.
pub fn building_plan(standing: &StandingBuilding, language: Language) -> String {
    let building = &standing.building;
    let (Some(floor), Some(storey)) = (building.floors().last(), building.storeys().last()) else {
        return String::new();
    };
    let radius = floor.gyration_m;
    let square = [
        [-radius, -radius],
        [radius, -radius],
        [radius, radius],
        [-radius, radius],
    ];
    let square = square.map(|c| [c[0] + floor.centre_m[0], c[1] + floor.centre_m[1]]);
    let corners: Vec<[f64; 2]> = match &floor.outline {
        Some(outline) => outline.corners_m().to_vec(),
        None => square.to_vec(),
    };
    let extent = |axis: usize| {
        let values = corners.iter().map(|c| c[axis]);
        values.fold([f64::INFINITY, f64::NEG_INFINITY], |[l, m], v| {
            [l.min(v), m.max(v)]
        })
    };
    let ([left, right], [bottom, top]) = (extent(0), extent(1));
    let scale = (FLOOR_PX[0] / (right - left)).min(FLOOR_PX[1] / (top - bottom));
    let size_px = [
        2.0 * ROOM_PX + (right - left) * scale,
        2.0 * ROOM_PX + (top - bottom) * scale,
    ];
    let view = View {
        scale,
        left_m: left,
        top_m: top,
        size_px,
        middle_m: 0.5 * (left + right),
    };
    let mut scene = Scene::new(size_px[0] + WORDS_PX, size_px[1]);
    let outline: Vec<[f64; 2]> = corners.iter().map(|&c| view.px(c)).collect();
    let edge = match floor.outline {
        Some(_) => Line::new(BLACK, 1.4),
        None => Line::new(GREY, 1.2).dashed(),
    };
    scene.polygon(&outline, STONE, edge);
    walls(
        &mut scene,
        &view,
        storey.stiffness.elements(),
        (right - left).min(top - bottom),
    );
    axes(&mut scene, size_px[1]);
    let mut words = Words {
        at: [size_px[0] + 8.0, 30.0],
    };
    let title = say(Signs::TopFloorWallsBelowIt, language);
    words.line(&mut scene, None, title.to_owned());
    scene.marker(view.px(floor.centre_m), Shape::Circle, 5.5, BLACK);
    let mass = say(Signs::CentreOfMass, language);
    words.line(
        &mut scene,
        Some((Shape::Circle, BLACK)),
        format!("{mass} {}", place(floor.centre_m)),
    );
    if let Some(rigidity) = storey.stiffness.centre_of_rigidity_m() {
        scene.marker(view.clamped(rigidity).px, Shape::Cross, 6.0, PURPLE);
        let rigid = say(Signs::CentreOfRigidity, language);
        words.line(
            &mut scene,
            Some((Shape::Cross, PURPLE)),
            format!("{rigid} {}", place(rigidity)),
        );
    }
    mode_centres((&mut scene, &mut words), &view, standing, language);
    dampers((&mut scene, &mut words), &view, standing, language);
    scene.svg(say(Titles::PlanWithTheCentresOfTheModes, language))
}

/// The centres of rotation of the top floor in the lowest modes; an arrow towards one beyond the picture.
fn mode_centres(
    (scene, words): (&mut Scene, &mut Words),
    view: &View,
    standing: &StandingBuilding,
    language: Language,
) {
    let Some(floor) = standing.building.floors().last() else {
        return;
    };
    let mass = view.px(floor.centre_m);
    for (j, mode) in standing.modes.modes.iter().take(MODES_DRAWN).enumerate() {
        let colour = MODE_COLOURS[j];
        let name = say(Signs::ModeOfNumber(j + 1), language);
        let hertz = significant(mode.frequency_hz, 3);
        let Some(centre) = mode.centres.last().copied().flatten() else {
            let none = say(Signs::NoCentre, language);
            words.line(scene, None, format!("{name}, {hertz}\u{202f}Hz: {none}"));
            continue;
        };
        let at = [centre.x_m, centre.y_m];
        let Clamped { px, is_beyond } = view.clamped(at);
        if is_beyond {
            let from = toward(px, mass, 34.0);
            scene.arrow(from, px, 9.0, Line::new(colour, 1.8));
            scene.text(toward(px, mass, 44.0), &number(j + 1, colour));
        } else {
            scene.marker(px, Shape::Diamond, 6.5, colour);
            scene.text([px[0] + 13.0, px[1] - 11.0], &number(j + 1, colour));
        }
        words.line(
            scene,
            Some((Shape::Diamond, colour)),
            format!("{name}, {hertz}\u{202f}Hz: {}", place(at)),
        );
    }
}

/// Dampers with their directions, with names on the inner side, away from the walls.
fn dampers(
    (scene, words): (&mut Scene, &mut Words),
    view: &View,
    standing: &StandingBuilding,
    language: Language,
) {
    let middle_m = view.middle_m;
    let mut named: Vec<([f64; 2], Vec<&str>)> = Vec::new();
    for damper in &standing.dampers {
        match named.iter_mut().find(|(place, _)| *place == damper.place_m) {
            Some((_, names)) => names.push(&damper.name),
            None => named.push((damper.place_m, vec![&damper.name])),
        }
    }
    for (place_m, names) in named {
        let [x, y] = view.px(place_m);
        let (anchor, aside) = match place_m[0] > middle_m {
            true => (Anchor::End, -9.0),
            false => (Anchor::Start, 9.0),
        };
        let name = Label::new(names.join(", "), anchor).small();
        scene.text([x + aside, y - 22.0], &name);
    }
    for damper in &standing.dampers {
        let at = view.px(damper.place_m);
        let [cos, sin] = damper.direction.unit();
        let line = Line::new(ORANGE, 2.0);
        for sign in [-1.0, 1.0] {
            let to = [at[0] + sign * 24.0 * cos, at[1] - sign * 24.0 * sin];
            scene.arrow(at, to, 8.0, line);
        }
        scene.marker(at, Shape::Square, 5.0, ORANGE);
        let word = say(Signs::Damper, language);
        let floor = say(Signs::Floor(damper.floor), language);
        words.line(
            scene,
            Some((Shape::Square, ORANGE)),
            format!("{word} {} ({floor})", damper.name),
        );
    }
}

fn place([x, y]: [f64; 2]) -> String {
    format!("({}, {}) m", short(x), short(y)).replace('-', "−")
}

fn short(value: f64) -> String {
    format!("{:.2}", value + 0.0)
}

fn number(mode: usize, colour: &'static str) -> Label {
    Label::new(mode.to_string(), Anchor::Middle)
        .bold()
        .coloured(colour)
}

/// A point at a distance in px from one towards another.
fn toward(from: [f64; 2], to: [f64; 2], px: f64) -> [f64; 2] {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    let length = dx.hypot(dy).max(1e-9);
    [from[0] + dx / length * px, from[1] + dy / length * px]
}

/// Lines of text next to the plan.
struct Words {
    at: [f64; 2],
}

impl Words {
    fn line(&mut self, scene: &mut Scene, key: Option<(Shape, &'static str)>, text: String) {
        if let Some((shape, colour)) = key {
            scene.marker([self.at[0] + 6.0, self.at[1]], shape, 5.0, colour);
        }
        let from = [self.at[0] + if key.is_some() { 18.0 } else { 0.0 }, self.at[1]];
        scene.text(from, &Label::new(text, Anchor::Start).small());
        self.at[1] += 22.0;
    }
}

fn axes(scene: &mut Scene, height: f64) {
    let from = [24.0, height - 24.0];
    let line = Line::new(GREY, 1.2);
    for (to, name, beside) in [
        ([58.0, height - 24.0], "x", [66.0, height - 24.0]),
        ([24.0, height - 58.0], "y", [24.0, height - 67.0]),
    ] {
        scene.arrow(from, to, 7.0, line);
        scene.text(beside, &Label::new(name, Anchor::Middle).small().coloured(GREY));
    }
}

/// Each wall as a bar along each axis in which it is stiff, with length in proportion to its stiffness.
fn walls(scene: &mut Scene, view: &View, elements: &[dolmen::structure::building::Element], side_m: f64) {
    let stiffest = elements
        .iter()
        .map(|e| e.stiffness_x_n_m.max(e.stiffness_y_n_m))
        .fold(0.0, f64::max);
    for element in elements {
        let (sin, cos) = element.angle_degrees.to_radians().sin_cos();
        for (stiffness, [dx, dy]) in [
            (element.stiffness_x_n_m, [cos, sin]),
            (element.stiffness_y_n_m, [-sin, cos]),
        ] {
            let half = 0.5 * WALL_LONGEST * side_m * stiffness / stiffest;
            let ends = [-half, half].map(|t| view.px([element.x_m + t * dx, element.y_m + t * dy]));
            scene.line(ends[0], ends[1], Line::new(BLACK, 4.0).faint(0.75));
        }
    }
}
