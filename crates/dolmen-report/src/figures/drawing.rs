//! A structure as entered, before any computation: names, dimensions, offsets and tilts, sensors.

use super::damage_map::put_view_name;
use super::elevation::{SLOPE_DRAWN, elevations, times};
use super::ink::{Anchor, BLUE, GREY, Label, Line, Shape, VERMILLION, text_width};
use super::scene::Scene;
use super::sheet::{LEFT_PX, Sheet, View, put_names, put_outlines, sheet};
use super::words::say;
use dolmen::signal::Component;
use dolmen_project::{Project, RecordSource, Structure, Survey};
use dolmen_words::message::Both;
use dolmen_words::number::{NARROW_SPACE, trimmed};
use dolmen_words::{Language, Sentence, messages};
use dolmen_work::sensors::{Axis, SensorsAnswer};
use std::collections::BTreeMap;

/// Levels closer than this have one dimension, px.
const LEVELS_PX: f64 = 11.0;
/// Lines below the drawing, px.
const FOOT_PX: f64 = 16.0;

messages! {
    /// Words of the drawing.
    pub(crate) enum Drawn in "figure.drawing" {
        Title(name: Both) => { en: "{name} as entered", ko: "{name}: 입력한 구조" },
        Heights => { en: "Heights in m, to scale.", ko: "높이 단위 m, 축척에 따름." },
        NoWidths => { en: "Widths are not in the file and not to scale.", ko: "폭은 입력값이 없어 축척에 따르지 않는다." },
        Columns => { en: "Columns and beams are schematic.", ko: "기둥과 보는 개략도이다." },
        Offsets(times: String) => { en: "Offsets of stones drawn {times} times as large.", ko: "부재의 어긋남은 {times}배로 과장하였다." },
        Tilts(times: String) => { en: "Tilts of stones drawn {times} times as large.", ko: "부재의 기울기는 {times}배로 과장하였다." },
        Posts => {
            en: "Grey: side posts, schematic; a gap is drawn open.",
            ko: "회색: 지주(개략도). 간격은 벌려 그렸다.",
        },
        Leans { survey: String, times: String } => {
            en: "Dashed: the tilt of survey {survey}, drawn {times} times as large.",
            ko: "점선: {survey} 조사의 기울기, {times}배로 과장하였다.",
        },
        Sensors => { en: "Triangles: sensors.", ko: "삼각형: 센서." },
    }
}

/// The drawing; `None` for a survey alone, and for a stack that cannot be built.
pub(crate) fn drawing(project: &Project, language: Language) -> Option<String> {
    let leaning = project.surveys.iter().rfind(|survey| !survey.tilt.is_empty());
    drawn(project, leaning, sensors(project), language)
}

/// The structure with numbered planned sensors instead of those of surveys.
pub(crate) fn planned_drawing(answer: &SensorsAnswer, language: Language) -> Option<String> {
    let numbered = answer.sensors.iter().enumerate().map(|(at, sensor)| {
        let axes: Vec<&str> = sensor.site.axes.iter().filter_map(Axis::key).collect();
        (
            sensor.site.position_m,
            format!("{} {}", at + 1, axes.join("")).trim_end().to_owned(),
        )
    });
    drawn(&answer.project, None, by_place(numbered), language)
}

fn drawn(
    project: &Project,
    leaning: Option<&Survey>,
    sensors: Vec<([f64; 3], String)>,
    language: Language,
) -> Option<String> {
    let sheet = sheet(elevations(&project.structure, true))?;
    let notes = notes(&sheet, leaning, !sensors.is_empty());
    let lines = notes.len() as f64;
    let mut scene = Scene::new(sheet.width_px, sheet.ground_px + 52.0 + FOOT_PX * lines);
    let several = sheet.views.len() > 1;
    for (number, view) in sheet.views.iter().enumerate() {
        put_outlines(&mut scene, view, sheet.ground_px);
        put_width(&mut scene, view, sheet.ground_px + 14.0);
        if number == 0 {
            put_heights(&mut scene, view);
            put_names(&mut scene, view, sheet.ground_px);
        }
        if let Some(survey) = leaning {
            put_lean(&mut scene, view, survey, (&project.structure, several));
        }
        put_sensors(&mut scene, view, &sensors);
        if several {
            put_view_name(&mut scene, view, sheet.ground_px + 34.0, language);
        }
    }
    for (number, note) in notes.into_iter().enumerate() {
        let y = sheet.ground_px + 54.0 + FOOT_PX * number as f64;
        scene.text(
            [10.0, y],
            &Label::new(note.text(language), Anchor::Start)
                .small()
                .coloured(GREY),
        );
    }
    let title = Drawn::Title(Both::of(|language| {
        language.pick(project.name.english(), project.name.korean())
    }));
    Some(scene.svg(say(title, language)))
}

/// Notes for reading it.
fn notes(sheet: &Sheet, leaning: Option<&Survey>, has_sensors: bool) -> Vec<Sentence> {
    let mut all: Vec<Sentence> = vec![Drawn::Heights.into()];
    if sheet.views.iter().any(|view| !view.elevation.has_widths) {
        all.push(Drawn::NoWidths.into());
    }
    if sheet.views.iter().any(|view| view.elevation.is_frame) {
        all.push(Drawn::Columns.into());
    }
    // one factor for all views
    let most = |of: fn(&View) -> f64| sheet.views.iter().map(of).fold(1.0, f64::max);
    let offsets = most(|view| view.elevation.offsets_times);
    if offsets > 1.0 {
        let times = trimmed(offsets, 3);
        all.push(Drawn::Offsets(times).into());
    }
    let tilts = most(|view| view.elevation.tilts_times);
    if tilts > 1.0 {
        let times = trimmed(tilts, 3);
        all.push(Drawn::Tilts(times).into());
    }
    if let Some(survey) = leaning {
        let times = trimmed(lean_times(survey), 3);
        let survey = survey.name.clone();
        all.push(Drawn::Leans { survey, times }.into());
    }
    if sheet
        .views
        .iter()
        .any(|view| !view.elevation.posts.posts.is_empty())
    {
        all.push(Drawn::Posts.into());
    }
    if has_sensors {
        all.push(Drawn::Sensors.into());
    }
    all
}

fn lean_times(survey: &Survey) -> f64 {
    let steepest = survey
        .tilt
        .values()
        .map(|tilt| tilt.ratio.abs())
        .fold(0.0, f64::max);
    times(steepest, SLOPE_DRAWN)
}

/// Heights between levels at the left, and the total height.
fn put_heights(scene: &mut Scene, view: &View) {
    let bounds = view.elevation.parts.iter().map(|part| part.bounds());
    let mut levels: Vec<f64> = bounds.flat_map(|[least, most]| [least[1], most[1]]).collect();
    levels.sort_by(f64::total_cmp);
    let (Some(&bottom), Some(&top)) = (levels.first(), levels.last()) else {
        return;
    };
    // overlapping levels are left out, except the top
    let mut shown = vec![bottom];
    // the file has no heights of parts that lean against each other, as in an arch
    let is_stacked = view.elevation.is_stacked();
    for level in levels.into_iter().filter(|level| is_stacked || *level == top) {
        if (level - shown[shown.len() - 1]) * view.scale >= LEVELS_PX {
            shown.push(level);
        }
    }
    if let Some(last) = shown
        .last_mut()
        .filter(|last| (top - **last) * view.scale < LEVELS_PX && **last > bottom)
    {
        *last = top;
    }
    let x = LEFT_PX - 30.0;
    for pair in shown.windows(2) {
        let [low, high] = [pair[0], pair[1]];
        put_height(scene, view, x, [low, high]);
    }
    if shown.len() > 2 {
        put_height(scene, view, x - 46.0, [bottom, top]);
    }
}

fn put_height(scene: &mut Scene, view: &View, x: f64, [low, high]: [f64; 2]) {
    let [below, above] = [low, high].map(|level| view.px([0.0, level])[1]);
    scene.line([x, below], [x, above], Line::new(GREY, 0.8));
    for y in [below, above] {
        scene.line([x - 3.0, y], [x + 3.0, y], Line::new(GREY, 0.8));
    }
    let label = Label::new(metres(high - low), Anchor::End).small();
    scene.text([x - 5.0, 0.5 * (below + above)], &label);
}

/// At most three digits after the point: millimetres.
fn metres(length_m: f64) -> String {
    trimmed((length_m * 1e3).round() / 1e3, 6)
}

/// A part is nearly as wide as all from this fraction: a pagoda's widest roof has free neighbours. Our choice.
const NEARLY: f64 = 0.9;

/// The width of the widest part, below the ground, or the total width if no part is nearly as wide; none if it is not in the file.
fn put_width(scene: &mut Scene, view: &View, y: f64) {
    if !view.elevation.has_widths {
        return;
    }
    let width = |bounds: &[[f64; 2]; 2]| bounds[1][0] - bounds[0][0];
    let bounds = || view.elevation.parts.iter().map(|part| part.bounds());
    let all = bounds().reduce(|a, b| {
        [0, 1].map(|end| match end {
            0 => [a[0][0].min(b[0][0]), a[0][1].min(b[0][1])],
            _ => [a[1][0].max(b[1][0]), a[1][1].max(b[1][1])],
        })
    });
    let Some((widest, all)) = bounds().max_by(|a, b| width(a).total_cmp(&width(b))).zip(all) else {
        return;
    };
    let widest = if width(&widest) < NEARLY * width(&all) {
        all
    } else {
        widest
    };
    let [left, right] = [widest[0][0], widest[1][0]].map(|across| view.px([across, 0.0])[0]);
    scene.line([left, y - 6.0], [right, y - 6.0], Line::new(GREY, 0.8));
    for x in [left, right] {
        scene.line([x, y - 9.0], [x, y - 3.0], Line::new(GREY, 0.8));
    }
    let text = format!("{}{NARROW_SPACE}m", metres(width(&widest)));
    scene.text(
        [0.5 * (left + right), y + 4.0],
        &Label::new(text, Anchor::Middle).small(),
    );
}

/// The view in which a direction runs across.
fn axis_of(structure: &Structure, direction: &str) -> usize {
    let own = match structure {
        Structure::Frame(frame) => frame.directions.iter().find(|own| own.name == direction),
        _ => None,
    };
    let is_y = match own.and_then(|own| own.along) {
        Some(along) => along == Component::Y,
        None => direction == "y",
    };
    usize::from(is_y)
}

/// The tilts of a survey along the view as leaning lines from the foot.
fn put_lean(scene: &mut Scene, view: &View, survey: &Survey, (structure, several): (&Structure, bool)) {
    let [least, most] = view.elevation.bounds();
    let foot = 0.5 * (least[0] + most[0]);
    let height = most[1] - least[1];
    let times = lean_times(survey);
    let of_view = |direction: &str| match several {
        true => view.elevation.axis == axis_of(structure, direction),
        false => view.elevation.axis == 0,
    };
    let shown = survey.tilt.iter().filter(|(direction, _)| of_view(direction));
    for (number, (direction, tilt)) in shown.enumerate() {
        let from = view.px([foot, least[1]]);
        let to = view.px([foot + tilt.ratio * times * height, most[1]]);
        scene.line(from, [to[0], to[1] - 8.0], Line::new(VERMILLION, 1.4).dashed());
        let text = format!("{direction} {}", tilt.written);
        let label = Label::new(text, Anchor::Middle).small().coloured(VERMILLION);
        scene.text([to[0], to[1] - 17.0 - 12.0 * number as f64], &label);
    }
}

/// Positions of sensors, m, each with the names of its channels.
fn sensors(project: &Project) -> Vec<([f64; 3], String)> {
    fn channels<'a>(source: &'a RecordSource, all: &mut Vec<(&'a str, [f64; 3])>) {
        for channel in source.channels.iter().filter(|channel| !channel.leave_out) {
            let name = channel.name.as_deref().unwrap_or_default();
            all.extend(channel.position_m.map(|place| (name, place)));
        }
        source.stations.iter().for_each(|station| channels(station, all));
    }
    let mut all = Vec::new();
    for survey in &project.surveys {
        let sources = survey.records.iter().chain(&survey.setups);
        sources.for_each(|source| channels(source, &mut all));
    }
    by_place(all.into_iter().map(|(name, place)| (place, name.to_owned())))
}

/// Sensors within a millimetre share a position.
fn by_place(all: impl IntoIterator<Item = ([f64; 3], String)>) -> Vec<([f64; 3], String)> {
    let mut places: BTreeMap<[i64; 3], ([f64; 3], Vec<String>)> = BTreeMap::new();
    for (place, name) in all {
        let key = place.map(|length| (length * 1e3).round() as i64);
        let (_, names) = places.entry(key).or_insert((place, Vec::new()));
        if !name.is_empty() && !names.contains(&name) {
            names.push(name);
        }
    }
    places
        .into_values()
        .map(|(place, names)| (place, names.join(", ")))
        .collect()
}

fn put_sensors(scene: &mut Scene, view: &View, sensors: &[([f64; 3], String)]) {
    let mut labelled: Vec<[f64; 2]> = Vec::new();
    let across: Vec<f64> = sensors
        .iter()
        .map(|(place, _)| place[view.elevation.axis])
        .collect();
    let across = match view.elevation.has_widths {
        true => across,
        false => spread_within(&across, view.elevation.bounds()),
    };
    for ((place, names), across) in sensors.iter().zip(across) {
        let at = view.px([across, place[2]]);
        scene.marker(at, Shape::Triangle, 5.0, BLUE);
        let anchor = if view.elevation.has_widths {
            Anchor::Start
        } else {
            Anchor::Middle
        };
        let label = Label::new(names.clone(), anchor).small().coloured(BLUE);
        let free = |other: &[f64; 2]| {
            (other[0] - at[0]).abs() > text_width(names, 11.0) || (other[1] - at[1]).abs() > 11.0
        };
        // one name for sensors that hide each other in this view
        if labelled.iter().all(free) {
            // above the beam of a storey without widths, whose line would strike the name through
            let beside = if view.elevation.has_widths {
                [8.0, 0.0]
            } else {
                [0.0, -13.0]
            };
            scene.text([at[0] + beside[0], at[1] + beside[1]], &label);
            labelled.push(at);
        }
    }
}

/// Places across an outline that is not to scale, in their order and with their distances in proportion.
fn spread_within(places: &[f64], [least, most]: [[f64; 2]; 2]) -> Vec<f64> {
    /// Share of the width on each side without a place.
    const EDGE: f64 = 0.1;
    let low = places.iter().copied().fold(f64::INFINITY, f64::min);
    let high = places.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let share = |place: f64| match high > low {
        true => EDGE + (1.0 - 2.0 * EDGE) * (place - low) / (high - low),
        false => 0.5,
    };
    let width = most[0] - least[0];
    places
        .iter()
        .map(|place| least[0] + share(*place) * width)
        .collect()
}
