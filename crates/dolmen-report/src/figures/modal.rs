//! Figures of an identification: singular values, stabilisation diagram, shapes at the sensors.

use super::axis::Axis;
use super::ink::{
    Anchor, BLACK, BLUE, GREEN, GREY, LIGHT, Label, Line, ORANGE, PURPLE, SERIES, SKY, Shape, VERMILLION,
};
use super::plot::{Key, Plot};
use super::scene::Scene;
use super::words::{Axes, Modal, Titles, say};
use dolmen::modal::{ModalAnalysis, Modes, Stability};
use dolmen_words::Language;
use dolmen_words::number;

/// Number of singular values drawn; the rest is noise.
const VALUES_DRAWN: usize = 4;

/// Largest number of points of a spectrum; more than one per px is not visible.
const POINTS_MOST: usize = 640;

/// The frequency axis extends beyond the search range by this factor.
const BEYOND_RANGE: f64 = 1.08;

/// Singular values more than this below the largest are cut off, dB.
const DEPTH_DB: f64 = 90.0;

/// Mode numbers closer than this are stacked, px.
const NUMBER_PX: f64 = 18.0;

/// Height of a row of numbers, px.
const NUMBER_ROW_PX: f64 = 14.0;

/// Number of rows for stacked mode numbers.
const NUMBER_STEPS: f64 = 4.0;

/// The stabilisation diagram extends beyond the highest possible mode by this factor.
const BEYOND_POLES: f64 = 1.12;

/// Width of plots, px.
pub(super) const WIDTH_PX: f64 = 680.0;

/// Singular values of the spectral matrix in dB over frequency, with the chosen modes marked.
pub fn singular_values(analysis: &ModalAnalysis, language: Language) -> String {
    let spectrum = &analysis.spectrum;
    let end = end_hz(analysis);
    let lines: Vec<Vec<[f64; 2]>> = (0..VALUES_DRAWN)
        .map(|rank| {
            thinned(
                &spectrum.frequency_hz,
                |line| spectrum.singular_values[line].get(rank).copied(),
                end,
            )
        })
        .filter(|points| !points.is_empty())
        .collect();
    // drift near 0 Hz would compress everything else
    let low = 0.5 * analysis.settings.range_hz[0];
    let within = lines.iter().flatten().filter(|p| p[0] >= low).map(|p| p[1]);
    let most = within.clone().fold(f64::NEG_INFINITY, f64::max);
    let shown: Vec<f64> = within.filter(|v| *v > most - DEPTH_DB).collect();
    let x = Axis::linear(say(Axes::Frequency, language), 0.0, end, 8);
    let y = Axis::around(say(Axes::SingularValue, language), &shown, 5);
    let mut plot = Plot::new([WIDTH_PX, 310.0], x, y);
    mark_modes(&mut plot, &analysis.modes);
    for (rank, points) in lines.iter().enumerate().rev() {
        let (colour, width) = if rank == 0 {
            (BLUE, 1.6)
        } else {
            (SERIES[(rank + 1) % SERIES.len()], 0.9)
        };
        let colour = if rank == 1 { GREY } else { colour };
        plot.line(points.clone(), Line::new(colour, width));
    }
    for rank in 0..lines.len() {
        let colour = match rank {
            0 => BLUE,
            1 => GREY,
            _ => SERIES[(rank + 1) % SERIES.len()],
        };
        plot.key(
            Key::Line(Line::new(colour, 1.6)),
            format!("{} {}", say(Modal::SingularValue, language), rank + 1),
        );
    }
    mode_key(&mut plot, &analysis.modes, language);
    plot.svg(say(Titles::SingularValues, language))
}

/// The stabilisation diagram: poles of every order by class, over the first singular value, with the chosen modes as
/// lines and ± their standard deviation as bands.
pub fn stabilization(analysis: &ModalAnalysis, language: Language) -> String {
    let possible = analysis
        .stabilization
        .poles
        .iter()
        .filter(|p| p.stability.possible());
    let highest = possible.map(|p| p.pole.frequency_hz).fold(0.0, f64::max);
    let end = if highest > 0.0 {
        (BEYOND_POLES * highest).min(end_hz(analysis))
    } else {
        end_hz(analysis)
    };
    let poles = || {
        analysis
            .stabilization
            .poles
            .iter()
            .filter(|p| p.pole.frequency_hz <= end)
    };
    let order_most = poles().map(|p| p.pole.order).max().unwrap_or(2) as f64;
    let x = Axis::linear(say(Axes::Frequency, language), 0.0, end, 8);
    let y = Axis::linear(say(Axes::ModelOrder, language), 0.0, order_most + 2.0, 6);
    let mut plot = Plot::new([WIDTH_PX, 390.0], x, y);
    plot.y.grid = false;

    let spectrum = &analysis.spectrum;
    let first = thinned(
        &spectrum.frequency_hz,
        |line| spectrum.singular_values[line].first().copied(),
        end,
    );
    let most = first.iter().map(|p| p[1]).fold(f64::NEG_INFINITY, f64::max);
    let least = first
        .iter()
        .map(|p| p[1])
        .fold(f64::INFINITY, f64::min)
        .max(most - DEPTH_DB);
    let lifted = first.iter().map(|p| {
        [
            p[0],
            (p[1] - least).max(0.0) / (most - least).max(1e-9) * order_most,
        ]
    });
    plot.line(lifted.collect(), Line::new(GREY, 1.1).faint(0.55));
    mark_modes(&mut plot, &analysis.modes);

    // better classes are drawn over worse ones
    let classes = [
        (Class::Hard, Shape::Cross, 1.6, LIGHT),
        (Class::Moved, Shape::Cross, 2.0, GREY),
        (Class::Half, Shape::Ring, 2.4, ORANGE),
        (Class::Stable, Shape::Circle, 2.6, BLUE),
    ];
    for (class, shape, size, colour) in classes {
        for judged in poles().filter(|p| Class::of(p.stability) == Some(class)) {
            let at = [judged.pole.frequency_hz, judged.pole.order as f64];
            plot.sized_dot(at, shape, size, colour);
        }
    }
    plot.key(Key::Dot(Shape::Circle, BLUE), say(Modal::StablePole, language));
    plot.key(
        Key::Dot(Shape::Ring, ORANGE),
        say(Modal::DampingOrShapeChanges, language),
    );
    plot.key(
        Key::Dot(Shape::Cross, GREY),
        say(Modal::FrequencyChanges, language),
    );
    plot.key(
        Key::Dot(Shape::Cross, LIGHT),
        say(Modal::ImpossiblePole, language),
    );
    plot.key(
        Key::Line(Line::new(GREY, 1.1).faint(0.55)),
        say(Modal::FirstSingularValue, language),
    );
    mode_key(&mut plot, &analysis.modes, language);
    plot.svg(say(Titles::StabilisationDiagram, language))
}

/// Class of a pole.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Class {
    Stable,
    /// The frequency recurred, damping or shape did not.
    Half,
    Moved,
    /// The pole fails a criterion for a single pole.
    Hard,
}

impl Class {
    fn of(stability: Stability) -> Option<Class> {
        match stability {
            Stability::Stable => Some(Class::Stable),
            Stability::DampingMoved | Stability::ShapeMoved => Some(Class::Half),
            Stability::FrequencyMoved => Some(Class::Moved),
            Stability::Damping | Stability::Complex | Stability::Scattered => Some(Class::Hard),
            Stability::OutOfRange => None,
        }
    }
}

/// Shapes of the modes at the sensors. In plan, one arrow per position: the sum of the components that its channels
/// measured. Without positions and directions, one bar per channel.
pub fn sensor_shapes(modes: &Modes, language: Language) -> String {
    match Plan::of(modes) {
        Some(plan) => plan.draw(modes, language),
        None => bars(modes, language),
    }
}

/// Places of the sensors in plan.
struct Plan {
    /// x, y, z of each place, m.
    places: Vec<[f64; 3]>,
    /// Position and horizontal direction of each channel.
    channels: Vec<(usize, [f64; 2])>,
    /// Heights, ascending, m.
    levels: Vec<f64>,
}

impl Plan {
    fn of(modes: &Modes) -> Option<Plan> {
        let mut plan = Plan {
            places: Vec::new(),
            channels: Vec::new(),
            levels: Vec::new(),
        };
        for channel in &modes.channels {
            let (at, direction) = (channel.position_m?, channel.direction?);
            let place = match plan.places.iter().position(|p| *p == at) {
                Some(place) => place,
                None => {
                    plan.places.push(at);
                    plan.places.len() - 1
                }
            };
            plan.channels.push((place, [direction[0], direction[1]]));
            if !plan.levels.contains(&at[2]) {
                plan.levels.push(at[2]);
            }
        }
        plan.levels.sort_by(f64::total_cmp);
        // a single position shows only directions, which is still useful
        (!plan.places.is_empty()).then_some(plan)
    }

    fn draw(&self, modes: &Modes, language: Language) -> String {
        /// Panels in one row.
        const ACROSS: usize = 3;
        /// Side of a panel, and of the area for the positions, px.
        const PANEL: f64 = 226.0;
        const FILLED: f64 = 104.0;
        /// Longest arrow, px.
        const ARROW: f64 = 46.0;
        let rows = modes.modes.len().div_ceil(ACROSS).max(1);
        let across = modes.modes.len().clamp(1, ACROSS);
        let mut scene = Scene::new(across as f64 * PANEL + 10.0, rows as f64 * (PANEL + 8.0) + 40.0);
        let bounds = |axis: usize| {
            let values = self.places.iter().map(move |p| p[axis]);
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| {
                (a.min(v), b.max(v))
            })
        };
        let ((x0, x1), (y0, y1)) = (bounds(0), bounds(1));
        let span = (x1 - x0).max(y1 - y0).max(1e-9);
        let scale = if x1 > x0 || y1 > y0 { FILLED / span } else { 1.0 };
        for (m, mode) in modes.modes.iter().enumerate() {
            let middle = [
                (m % ACROSS) as f64 * PANEL + 0.5 * PANEL,
                (m / ACROSS) as f64 * (PANEL + 8.0) + 46.0 + 0.5 * (PANEL - 46.0),
            ];
            let px = |p: &[f64; 3]| {
                [
                    middle[0] + scale * (p[0] - 0.5 * (x0 + x1)),
                    middle[1] - scale * (p[1] - 0.5 * (y0 + y1)),
                ]
            };
            let title = format!("{} {}", say(Modal::Mode, language), m + 1);
            let frequency = format!(
                "{}{}Hz",
                number::significant(mode.frequency_hz, 4),
                number::NARROW_SPACE
            );
            let top = middle[1] - 0.5 * (PANEL - 46.0) - 34.0;
            scene.text([middle[0], top], &Label::new(title, Anchor::Middle).bold());
            scene.text(
                [middle[0], top + 17.0],
                &Label::new(frequency, Anchor::Middle).coloured(BLUE),
            );
            let outline: Vec<[f64; 2]> = around(&self.places).iter().map(&px).collect();
            if outline.len() >= 3 {
                scene.polygon(&outline, "none", Line::new(LIGHT, 1.5));
            }
            let mut moved = vec![[0.0; 2]; self.places.len()];
            for ((place, direction), component) in self.channels.iter().zip(&mode.shape) {
                moved[*place][0] += component.re * direction[0];
                moved[*place][1] += component.re * direction[1];
            }
            let longest = moved.iter().map(|v| v[0].hypot(v[1])).fold(1e-12, f64::max);
            for (place, by) in self.places.iter().zip(&moved) {
                let at = px(place);
                let colour = self.colour(place[2]);
                scene.circle(at, 2.8, "#ffffff", Line::new(GREY, 1.2));
                let to = [at[0] + ARROW * by[0] / longest, at[1] - ARROW * by[1] / longest];
                scene.arrow(at, to, 8.0, Line::new(colour, 2.2));
            }
        }
        let y = rows as f64 * (PANEL + 8.0) + 24.0;
        let mut x = 10.0;
        for level in &self.levels {
            let label = Label::new(
                format!("z = {}{}m", number::trimmed(*level, 4), number::NARROW_SPACE),
                Anchor::Start,
            );
            scene.arrow([x, y], [x + 22.0, y], 7.0, Line::new(self.colour(*level), 2.2));
            scene.text([x + 28.0, y], &label);
            x += 28.0 + label.width() + 20.0;
        }
        let extent = format!(
            "{} {} × {}{}m",
            say(Modal::PlanSensorsOver, language),
            number::trimmed(x1 - x0, 3),
            number::trimmed(y1 - y0, 3),
            number::NARROW_SPACE
        );
        scene.text(
            [across as f64 * PANEL, y],
            &Label::new(extent, Anchor::End).small().coloured(GREY),
        );
        scene.svg(say(Titles::ModeShapesInPlan, language))
    }

    fn colour(&self, level: f64) -> &'static str {
        let colours = [BLUE, VERMILLION, GREEN, PURPLE, ORANGE, SKY];
        let rank = self.levels.iter().rev().position(|l| *l == level).unwrap_or(0);
        colours[rank % colours.len()]
    }
}

/// Positions in plan ordered around their middle, without duplicates: the outline of a convex house.
fn around(places: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let count = places.len().max(1) as f64;
    let sum = places.iter().fold([0.0; 2], |s, p| [s[0] + p[0], s[1] + p[1]]);
    let middle = [sum[0] / count, sum[1] / count];
    let mut outline: Vec<[f64; 3]> = Vec::new();
    for place in places {
        if !outline.iter().any(|p| p[0] == place[0] && p[1] == place[1]) {
            outline.push(*place);
        }
    }
    let angle = |p: &[f64; 3]| (p[1] - middle[1]).atan2(p[0] - middle[0]);
    outline.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
    outline
}

/// One row per channel, one colour per mode: for records without positions.
fn bars(modes: &Modes, language: Language) -> String {
    let names: Vec<String> = modes.channels.iter().rev().map(|c| c.name.clone()).collect();
    let x = Axis::linear(say(Axes::ShapeComponent, language), -1.1, 1.1, 5);
    let mut plot = Plot::new(
        [WIDTH_PX, 96.0 + 30.0 * names.len() as f64],
        x,
        Axis::rows(&names),
    );
    plot.upright(0.0, Line::new(BLACK, 1.2));
    let count = modes.modes.len().max(1) as f64;
    let shapes = [
        Shape::Circle,
        Shape::Triangle,
        Shape::Square,
        Shape::Diamond,
        Shape::Ring,
        Shape::Cross,
    ];
    for (m, mode) in modes.modes.iter().enumerate() {
        let colour = SERIES[m % SERIES.len()];
        let shift = 0.3 - 0.6 * (m as f64 + 0.5) / count;
        for (row, component) in mode.shape.iter().rev().enumerate() {
            let at = row as f64 + shift;
            plot.line(vec![[0.0, at], [component.re, at]], Line::new(colour, 1.4));
            plot.sized_dot([component.re, at], shapes[m % shapes.len()], 3.2, colour);
        }
        let words = format!(
            "{} {}: {} Hz",
            say(Modal::Mode, language),
            m + 1,
            number::significant(mode.frequency_hz, 4)
        );
        plot.key(Key::Dot(shapes[m % shapes.len()], colour), words);
    }
    plot.svg(say(Titles::ModeShapesByChannel, language))
}

/// End of the frequency axis: a little above the highest mode of the search, within the spectrum.
pub(super) fn end_hz(analysis: &ModalAnalysis) -> f64 {
    let most = analysis.spectrum.frequency_hz.last().copied().unwrap_or(1.0);
    let range = analysis.settings.range_hz[1];
    if range.is_finite() {
        (BEYOND_RANGE * range).min(most)
    } else {
        most
    }
}

/// Lines at the modes with bands of ± their standard deviation, numbered above the plot.
pub(super) fn mark_modes(plot: &mut Plot, modes: &Modes) {
    let (low, high) = (plot.y.from, plot.y.to);
    let px = |hz: f64| (hz - plot.x.from) / (plot.x.to - plot.x.from) * (plot.width - plot.left - plot.right);
    // stacked so that neighbouring numbers do not overlap
    let mut steps: Vec<f64> = Vec::new();
    for (m, mode) in modes.modes.iter().enumerate() {
        let near = m > 0 && px(mode.frequency_hz) - px(modes.modes[m - 1].frequency_hz) < NUMBER_PX;
        let step = if near {
            (steps.last().copied().unwrap_or(0.0) + 1.0) % NUMBER_STEPS
        } else {
            0.0
        };
        steps.push(step);
    }
    plot.head = NUMBER_ROW_PX * (1.0 + steps.iter().copied().fold(0.0, f64::max));
    plot.height += plot.head;
    for ((m, mode), step) in modes.modes.iter().enumerate().zip(steps) {
        let frequency = mode.frequency_hz;
        if let Some(sd) = mode.frequency_sd_hz {
            plot.block([frequency - sd, low], [frequency + sd, high], GREEN, 0.25);
        }
        let line = Line::new(GREEN, 1.1);
        // a mode accepted by the user that no test found
        let line = if mode.is_found() { line } else { line.dashed() };
        plot.upright(frequency, line);
        let label = Label::new((m + 1).to_string(), Anchor::Middle)
            .bold()
            .coloured(GREEN);
        plot.text([frequency, high], [0.0, -8.0 - NUMBER_ROW_PX * step], label);
    }
}

pub(super) fn mode_key(plot: &mut Plot, modes: &Modes, language: Language) {
    plot.key(Key::Line(Line::new(GREEN, 1.6)), say(Modal::ChosenMode, language));
    if modes.modes.iter().any(|mode| !mode.is_found()) {
        let dashed = Line::new(GREEN, 1.6).dashed();
        plot.key(Key::Line(dashed), say(Modal::AcceptedMode, language));
    }
}

/// Points of one line in dB up to `end_hz`, thinned so that peaks stay: the largest of every few.
fn thinned(frequency_hz: &[f64], value: impl Fn(usize) -> Option<f64>, end_hz: f64) -> Vec<[f64; 2]> {
    let count = frequency_hz.iter().take_while(|f| **f <= end_hz).count();
    let few = count.div_ceil(POINTS_MOST).max(1);
    let mut points = Vec::with_capacity(count.div_ceil(few));
    for start in (0..count).step_by(few) {
        let lines = start..(start + few).min(count);
        let db = |line: usize| value(line).filter(|v| *v > 0.0).map(|v| (line, 10.0 * v.log10()));
        if let Some((line, db)) = lines.filter_map(db).max_by(|a, b| a.1.total_cmp(&b.1)) {
            points.push([frequency_hz[line], db]);
        }
    }
    points
}
