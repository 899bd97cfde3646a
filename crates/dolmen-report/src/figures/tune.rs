//! A damper compared with the rule and the optimum: motion against its place, the floor in plan, and the loss by detuning.

use super::Figure;
use super::axis::Axis;
use super::ink::{Anchor, BLACK, BLUE, GREEN, GREY, Label, Line, SERIES, Shape, VERMILLION};
use super::plot::{Key, Plot};
use super::scene::Scene;
use super::words::{Axes, Studied, Titles, say};
use dolmen::damper::{Choice, FloorDesign, MapCell};
use dolmen_words::{Language, number};
use dolmen_work::building::TuneAnswer;

const SIZE_PX: [f64; 2] = [680.0, 400.0];
/// Longer side of the floor in plan, px, and the space around it.
const PLAN_PX: f64 = 460.0;
const AROUND_PX: f64 = 84.0;
/// Size of the markers of the best floor and of that of the file, px.
const BEST_PX: f64 = 8.0;
/// Largest number of ticks along the axis of floors.
const TICKS_MOST: usize = 8;
/// Shades of the plan, light (small) to dark (large), in one hue, so that grey print keeps the order.
const SHADES: [&str; 8] = [
    "#f7fbff", "#deebf7", "#c6dbef", "#9ecae1", "#6baed6", "#4292c6", "#2171b5", "#084594",
];

/// The figures of one damper.
pub fn tune_figures(answer: &TuneAnswer, language: Language) -> Vec<Figure> {
    let floors = answer.floors.as_ref().map(|_| TuneFigure::Floors);
    let each = TuneFigure::of(answer)
        .into_iter()
        .chain(floors)
        .map(|figure| Figure {
            name: figure.name().to_owned(),
            svg: figure.draw(answer, language),
        });
    each.collect()
}

/// A figure of one damper.
#[derive(Clone, Copy)]
pub(crate) enum TuneFigure {
    /// Motion against the place of the damper.
    Position,
    /// The floor in plan.
    Plan,
    /// The goal on each floor.
    Floors,
    /// The loss by detuning.
    Robustness,
}

impl TuneFigure {
    /// The figures of the comparison on the file's floor.
    pub(crate) fn of(answer: &TuneAnswer) -> Vec<Self> {
        let mut figures = Vec::new();
        if answer.comparison.line_given.len() > 1 {
            figures.push(TuneFigure::Position);
        }
        if !answer.comparison.map.cells.is_empty() {
            figures.push(TuneFigure::Plan);
        }
        figures.push(TuneFigure::Robustness);
        figures
    }

    fn name(self) -> &'static str {
        match self {
            TuneFigure::Position => "position",
            TuneFigure::Plan => "plan",
            TuneFigure::Floors => "floors",
            TuneFigure::Robustness => "robustness",
        }
    }

    pub(crate) fn draw(self, answer: &TuneAnswer, language: Language) -> String {
        match self {
            TuneFigure::Position => position(answer, language),
            TuneFigure::Plan => plan(answer, language),
            TuneFigure::Floors => floors(answer, language),
            TuneFigure::Robustness => robustness(answer, language),
        }
    }
}

/// Distance of a place along the line, m: x or y if the line is parallel to an axis.
fn along(answer: &TuneAnswer, language: Language) -> (String, impl Fn(&MapCell) -> f64) {
    let degrees = answer.direction_degrees.rem_euclid(180.0);
    let (sin, cos) = degrees.to_radians().sin_cos();
    let name = match degrees {
        90.0 => say(Axes::XOfTheDamper, language),
        0.0 => say(Axes::YOfTheDamper, language),
        _ => say(Axes::PlaceOfDamperAcross, language),
    };
    let unit = if degrees == 0.0 { [0.0, 1.0] } else { [sin, -cos] };
    (name, move |cell: &MapCell| {
        let [x, y] = cell.damper.place_m;
        unit[0] * x + unit[1] * y
    })
}

/// Motion of each point against the place of the damper, as Figure 5 of Hwang, Min & Hong; and with optimum tuning at each place.
fn position(answer: &TuneAnswer, language: Language) -> String {
    let comparison = &answer.comparison;
    let (name, at) = along(answer, language);
    let series = |cells: &[MapCell], point: usize| -> Vec<[f64; 2]> {
        cells
            .iter()
            .map(|cell| [at(cell), answer.over_without(&cell.point_rms)[point]])
            .collect()
    };
    let all = comparison.line_given.iter().chain(&comparison.line_best);
    let largest = all
        .flat_map(|cell| answer.over_without(&cell.point_rms))
        .fold(1.0, f64::max);
    let places: Vec<f64> = comparison.line_given.iter().map(&at).collect();
    let ends = [
        places.iter().copied().fold(f64::INFINITY, f64::min),
        places.iter().copied().fold(f64::NEG_INFINITY, f64::max),
    ];
    let x = Axis::linear(name, ends[0], ends[1], 10);
    let y_name = say(Axes::RmsRatio, language);
    let mut plot = Plot::new(SIZE_PX, x, Axis::linear(y_name, 0.0, 1.06 * largest, 6));
    plot.line(
        vec![[ends[0], 1.0], [ends[1], 1.0]],
        Line::new(GREY, 1.0).dashed(),
    );
    for (p, point) in answer.points.iter().enumerate() {
        let colour = SERIES[p % SERIES.len()];
        plot.line(series(&comparison.line_given, p), Line::new(colour, 2.0));
        plot.line(series(&comparison.line_best, p), Line::new(colour, 1.6).dashed());
        plot.key(Key::Line(Line::new(colour, 2.0)), point.name.clone());
    }
    plot.key(
        Key::Line(Line::new(GREY, 2.0)),
        say(Studied::TunedAsInTheFile, language),
    );
    plot.key(
        Key::Line(Line::new(GREY, 1.6).dashed()),
        say(Studied::TunedBestAtEachPlace, language),
    );
    plot.svg(say(Titles::MotionByPlace, language))
}

/// A floor on paper, and the goal there.
struct FloorView<'a> {
    answer: &'a TuneAnswer,
    x: [f64; 2],
    y: [f64; 2],
    scale: f64,
    /// Smallest goal of the map, and the span to the largest, relative to that without a damper.
    low: f64,
    span: f64,
}

/// A line of the legend.
struct LegendKey {
    shape: Shape,
    colour: &'static str,
    words: String,
}

impl<'a> FloorView<'a> {
    fn new(answer: &'a TuneAnswer) -> Self {
        let ends = |axis: usize| {
            let values = answer.corners_m.iter().map(|corner| corner[axis]);
            values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| {
                [low.min(v), high.max(v)]
            })
        };
        let [x, y] = [ends(0), ends(1)];
        let cells = answer.comparison.map.cells.iter().flatten();
        let costs: Vec<f64> = cells
            .map(|cell| cell.cost / answer.comparison.cost_without)
            .collect();
        let low = costs.iter().copied().fold(f64::INFINITY, f64::min);
        let high = costs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        FloorView {
            answer,
            x,
            y,
            scale: PLAN_PX / (x[1] - x[0]).max(y[1] - y[0]),
            low,
            span: (high - low).max(1e-9),
        }
    }

    fn px(&self, [a, b]: [f64; 2]) -> [f64; 2] {
        [
            AROUND_PX + self.scale * (a - self.x[0]),
            AROUND_PX + self.scale * (self.y[1] - b),
        ]
    }

    fn over(&self, cost: f64) -> f64 {
        cost / self.answer.comparison.cost_without
    }

    fn shade(&self, cell: &Option<MapCell>) -> Option<usize> {
        cell.as_ref().map(|cell| {
            let part = (self.over(cell.cost) - self.low) / self.span;
            ((part * SHADES.len() as f64) as usize).min(SHADES.len() - 1)
        })
    }

    /// The goal for each place; equal shades in a row form one rectangle.
    fn map(&self, scene: &mut Scene) {
        let map = &self.answer.comparison.map;
        let step = |list: &[f64], whole: f64| whole / list.len().max(1) as f64;
        let (dx, dy) = (
            step(&map.x_m, self.x[1] - self.x[0]),
            step(&map.y_m, self.y[1] - self.y[0]),
        );
        let columns = map.x_m.len();
        for (j, row_y) in map.y_m.iter().enumerate() {
            let row = &map.cells[j * columns..(j + 1) * columns];
            let mut from = 0;
            for i in 1..=columns {
                if i < columns && self.shade(&row[i]) == self.shade(&row[from]) {
                    continue;
                }
                if let Some(shade) = self.shade(&row[from]) {
                    let left = map.x_m[from] - 0.5 * dx;
                    let right = map.x_m[i - 1] + 0.5 * dx;
                    let (bottom, top) = (row_y - 0.5 * dy, row_y + 0.5 * dy);
                    let corners =
                        [[left, bottom], [right, bottom], [right, top], [left, top]].map(|at| self.px(at));
                    scene.polygon(&corners, SHADES[shade], Line::new(SHADES[shade], 0.6));
                }
                from = i;
            }
        }
    }

    /// The outline of the floor and the points of the goal.
    fn floor(&self, scene: &mut Scene) {
        let answer = self.answer;
        let outline: Vec<[f64; 2]> = answer.corners_m.iter().map(|corner| self.px(*corner)).collect();
        scene.polygon(&outline, "none", Line::new(BLACK, 1.4));
        for point in answer.points.iter().filter(|point| point.floor == answer.floor) {
            let at = self.px(point.place_m);
            scene.marker(at, Shape::Cross, 5.0, BLACK);
            // names are outside the floor, on the nearer side
            let right = point.place_m[0] > 0.5 * (self.x[0] + self.x[1]);
            let anchor = if right { Anchor::Start } else { Anchor::End };
            let beside = [at[0] + if right { 9.0 } else { -9.0 }, at[1] - 12.0];
            scene.text(beside, &Label::new(point.name.clone(), anchor).small());
        }
    }

    /// The centre of the mode, if it has one and it is on the floor.
    fn mode_centre(&self, scene: &mut Scene, language: Language) -> Option<LegendKey> {
        let centre = self.answer.mode_centre_m?;
        let number = self.answer.mode;
        let inside =
            (self.x[0]..=self.x[1]).contains(&centre[0]) && (self.y[0]..=self.y[1]).contains(&centre[1]);
        let words = match inside {
            true => say(Studied::CentreOfMode(number), language),
            false => {
                let x = number::fixed(centre[0], 2);
                say(Studied::CentreOffTheFloor { number, x }, language)
            }
        };
        if inside {
            scene.marker(self.px(centre), Shape::Ring, 6.0, GREY);
        }
        Some(LegendKey {
            shape: Shape::Ring,
            colour: GREY,
            words,
        })
    }

    /// The damper of the file, by the rule, and optimised; smaller symbols are drawn over larger ones, so that none is hidden at a common place.
    fn choices(&self, scene: &mut Scene, language: Language) -> Vec<LegendKey> {
        let choices = [
            (Choice::Given, Shape::Square, 8.0, BLACK, Studied::AsInTheFile),
            (Choice::Rule, Shape::Triangle, 6.0, VERMILLION, Studied::TheRule),
            (
                Choice::Best,
                Shape::Diamond,
                4.0,
                GREEN,
                Studied::PlacedAndTunedBest,
            ),
        ];
        let mut keys = Vec::new();
        for (choice, shape, size, colour, words) in choices {
            if let Some(row) = self.answer.comparison.row(choice) {
                scene.marker(self.px(row.damper.place_m), shape, size, colour);
                let words = format!("{}: {:.4}", say(words, language), self.over(row.cost));
                keys.push(LegendKey { shape, colour, words });
            }
        }
        keys
    }

    /// Legend and shades, right of the floor.
    fn legend(&self, scene: &mut Scene, keys: Vec<LegendKey>, language: Language) {
        let left = AROUND_PX * 2.0 + self.scale * (self.x[1] - self.x[0]);
        let mut down = AROUND_PX;
        for key in keys {
            scene.marker([left, down], key.shape, 6.0, key.colour);
            scene.text([left + 14.0, down], &Label::new(key.words, Anchor::Start).small());
            down += 22.0;
        }
        down += 14.0;
        let heading = say(Axes::GoalRatio, language);
        scene.text(
            [left - 6.0, down],
            &Label::new(heading, Anchor::Start).small().bold(),
        );
        for (k, colour) in SHADES.iter().enumerate() {
            down += 18.0;
            let box_px = [
                [left - 6.0, down - 7.0],
                [left + 14.0, down - 7.0],
                [left + 14.0, down + 7.0],
                [left - 6.0, down + 7.0],
            ];
            scene.polygon(&box_px, colour, Line::new(GREY, 0.5));
            let [from, to] = [k, k + 1].map(|k| self.low + self.span * k as f64 / SHADES.len() as f64);
            scene.text(
                [left + 22.0, down],
                &Label::new(format!("{from:.3}–{to:.3}"), Anchor::Start).small(),
            );
        }
    }

    /// Coordinates of the ends of the floor.
    fn ends(&self, scene: &mut Scene) {
        let ([x0, x1], [y0, y1]) = (self.x, self.y);
        for (value, at) in [(x0, [x0, y0]), (x1, [x1, y0])] {
            let [a, b] = self.px(at);
            scene.text(
                [a, b + 16.0],
                &Label::new(number::trimmed(value, 3) + " m", Anchor::Middle).small(),
            );
        }
        for (value, at) in [(y0, [x0, y0]), (y1, [x0, y1])] {
            let [a, b] = self.px(at);
            scene.text(
                [a - 6.0, b],
                &Label::new(number::trimmed(value, 3) + " m", Anchor::End).small(),
            );
        }
    }
}

/// The floor: the goal for each place of the damper with optimum tuning; the damper, the rule, the optimum; centre of the mode.
fn plan(answer: &TuneAnswer, language: Language) -> String {
    let view = FloorView::new(answer);
    let (width, height) = (
        view.scale * (view.x[1] - view.x[0]),
        view.scale * (view.y[1] - view.y[0]),
    );
    let legend = 250.0;
    let total_height = (height + 2.0 * AROUND_PX).max(330.0);
    let mut scene = Scene::new(width + 2.0 * AROUND_PX + legend, total_height);
    view.map(&mut scene);
    view.floor(&mut scene);
    let mut keys: Vec<LegendKey> = view.mode_centre(&mut scene, language).into_iter().collect();
    keys.extend(view.choices(&mut scene, language));
    view.legend(&mut scene, keys, language);
    view.ends(&mut scene);
    scene.svg(say(Titles::DamperByPlace, language))
}

/// The goal with the damper placed and tuned best on each floor.
fn floors(answer: &TuneAnswer, language: Language) -> String {
    let designs = answer.floors.as_ref().map_or(&[][..], |of| &of.comparison.floors);
    let at = |of: &FloorDesign| [of.cost / answer.comparison.cost_without, of.floor as f64];
    let points: Vec<[f64; 2]> = designs.iter().map(at).collect();
    let [goals, numbers] = [0, 1].map(|i| points.iter().map(|point| point[i]).collect::<Vec<f64>>());
    let x = Axis::around(say(Axes::GoalRatio, language), &goals, 6);
    let y = Axis::around(
        say(Axes::FloorOfTheDamper, language),
        &numbers,
        designs.len().min(TICKS_MOST),
    );
    let mut plot = Plot::new(SIZE_PX, x, y);
    plot.line(points.clone(), Line::new(GREY, 1.0));
    let best = answer.floors.as_ref().and_then(|of| of.comparison.best());
    let is_best = |of: &FloorDesign| best.is_some_and(|best| best.floor == of.floor);
    for (design, point) in designs.iter().zip(points) {
        plot.dot(point, Shape::Circle, BLACK);
        if is_best(design) {
            plot.sized_dot(point, Shape::Ring, BEST_PX, VERMILLION);
        }
        if design.floor == answer.floor {
            plot.sized_dot(point, Shape::Diamond, BEST_PX, BLUE);
        }
    }
    plot.key(
        Key::Dot(Shape::Diamond, BLUE),
        say(Studied::FloorOfTheFile, language),
    );
    plot.key(
        Key::Dot(Shape::Ring, VERMILLION),
        say(Studied::BestFloor, language),
    );
    plot.svg(say(Titles::DamperByFloor, language))
}

/// The goal with detuned frequency and damping.
fn robustness(answer: &TuneAnswer, language: Language) -> String {
    let comparison = &answer.comparison;
    let curves = [
        (&comparison.off_frequency, true),
        (&comparison.off_damping, false),
    ];
    let all = curves.iter().flat_map(|(pair, _)| pair.iter().flatten());
    let values: Vec<f64> = all.map(|point| point.cost / comparison.cost_without).collect();
    let largest = values.iter().copied().fold(0.0, f64::max);
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    let ends = comparison.off_frequency[0]
        .iter()
        .map(|point| 100.0 * (point.factor - 1.0))
        .fold([0.0_f64; 2], |[low, high], v| [low.min(v), high.max(v)]);
    let x = Axis::linear(say(Axes::OffBy, language), ends[0], ends[1], 8);
    let margin = 0.08 * (largest - least).max(0.02);
    let y = Axis::linear(
        say(Axes::GoalRatio, language),
        least - margin,
        largest + margin,
        6,
    );
    let mut plot = Plot::new(SIZE_PX, x, y);
    for (pair, frequency) in curves {
        for (k, points) in pair.iter().enumerate() {
            let colour = [BLUE, VERMILLION][k];
            let line = match frequency {
                true => Line::new(colour, 2.0),
                false => Line::new(colour, 1.6).dashed(),
            };
            let points = points
                .iter()
                .map(|point| [100.0 * (point.factor - 1.0), point.cost / comparison.cost_without])
                .collect();
            plot.line(points, line);
            let which = match k {
                0 => say(Studied::AsInTheFileDamper, language),
                _ => say(Studied::PlacedAndTunedBest, language),
            };
            let what = match frequency {
                true => say(Studied::FrequencyOff, language),
                false => say(Studied::DampingOff, language),
            };
            plot.key(Key::Line(line), format!("{which}, {what}"));
        }
    }
    plot.svg(say(Titles::WhatBeingOutOfTuneCosts, language))
}
