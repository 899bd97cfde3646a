//! Plots with axes: marks are collected, then drawn.

use super::axis::Axis;
use super::ink::{Anchor, GREY, LIGHT, Label, Line, Shape};
use super::scene::Scene;

/// Length of tick marks, px.
const TICK_PX: f64 = 4.0;

/// Height of one line below the plot, px.
const NOTE_PX: f64 = 16.0;

/// Height of one line of the legend, px.
const LEGEND_PX: f64 = 20.0;

/// Half the outline of a marker, px; plots draw it within the marker's size.
const OUTLINE_PX: f64 = 0.9;

/// A point in px from the upper left corner.
type Px = [f64; 2];

/// A mark in the plot, in the units of its axes; `shift` is in px, right and down.
pub(crate) enum Mark {
    Line {
        points: Vec<[f64; 2]>,
        line: Line,
    },
    Block {
        from: [f64; 2],
        to: [f64; 2],
        colour: &'static str,
        opacity: f64,
    },
    Dot {
        at: [f64; 2],
        shape: Shape,
        size: f64,
        colour: &'static str,
    },
    Text {
        at: [f64; 2],
        shift: [f64; 2],
        label: Label,
    },
}

/// Symbol of a legend entry.
pub(crate) enum Key {
    Dot(Shape, &'static str),
    Line(Line),
    Block(&'static str, f64),
}

/// A plot under construction.
pub(crate) struct Plot {
    pub(crate) width: f64,
    pub(crate) height: f64,
    /// Space left of the plotting area for tick labels and the axis name, px.
    pub(crate) left: f64,
    /// Space above it, px.
    pub(crate) head: f64,
    /// Space to the right of it, px.
    pub(crate) right: f64,
    pub(crate) x: Axis,
    pub(crate) y: Axis,
    pub(crate) marks: Vec<Mark>,
    pub(crate) legend: Vec<(Key, String)>,
    /// Lines below the plot.
    notes: Vec<String>,
}

/// Position of the axes, px: left to right, top to bottom, and the start of the notes.
struct Field {
    x: [f64; 2],
    y: [f64; 2],
    end: f64,
}

impl Plot {
    pub(crate) fn new(size: [f64; 2], x: Axis, y: Axis) -> Self {
        let widest = y.ticks.iter().map(|t| Label::new(&t.text, Anchor::End).width());
        let named = if y.name.is_empty() { 0.0 } else { 22.0 };
        let left = widest.fold(18.0, f64::max) + 2.0 * TICK_PX + 8.0 + named;
        Plot {
            width: size[0],
            height: size[1],
            left,
            head: 0.0,
            right: 16.0,
            x,
            y,
            marks: Vec::new(),
            legend: Vec::new(),
            notes: Vec::new(),
        }
    }

    /// Text below the plot, wrapped; the figure grows with it.
    pub(crate) fn note(&mut self, words: impl AsRef<str>) {
        let mut lines: Vec<String> = Vec::new();
        for word in words.as_ref().split_inclusive(' ') {
            let fits = |line: &String| {
                let whole = Label::new(format!("{line}{word}"), Anchor::Start).small();
                whole.width() + 24.0 < self.width
            };
            match lines.last_mut().filter(|line| fits(line)) {
                Some(line) => line.push_str(word),
                None => lines.push(word.to_owned()),
            }
        }
        self.height += NOTE_PX * lines.len() as f64;
        self.notes.extend(lines);
    }

    pub(crate) fn line(&mut self, points: Vec<[f64; 2]>, line: Line) {
        self.marks.push(Mark::Line { points, line });
    }

    /// A vertical line across the whole plot at x.
    pub(crate) fn upright(&mut self, x: f64, line: Line) {
        let (from, to) = (self.y.from, self.y.to);
        self.line(vec![[x, from], [x, to]], line);
    }

    pub(crate) fn block(&mut self, from: [f64; 2], to: [f64; 2], colour: &'static str, opacity: f64) {
        self.marks.push(Mark::Block {
            from,
            to,
            colour,
            opacity,
        });
    }

    pub(crate) fn dot(&mut self, at: [f64; 2], shape: Shape, colour: &'static str) {
        self.sized_dot(at, shape, 4.5, colour);
    }

    pub(crate) fn sized_dot(&mut self, at: [f64; 2], shape: Shape, size: f64, colour: &'static str) {
        self.marks.push(Mark::Dot {
            at,
            shape,
            size,
            colour,
        });
    }

    pub(crate) fn text(&mut self, at: [f64; 2], shift: [f64; 2], label: Label) {
        self.marks.push(Mark::Text { at, shift, label });
    }

    pub(crate) fn key(&mut self, key: Key, text: impl Into<String>) {
        self.legend.push((key, text.into()));
    }

    /// The SVG. `title` describes it to a reader who cannot see it.
    pub(crate) fn svg(&self, title: impl AsRef<str>) -> String {
        let mut scene = Scene::new(self.width, self.height);
        let rows = self.legend_rows();
        let named = if self.x.name.is_empty() { 0.0 } else { 20.0 };
        let end = self.height - NOTE_PX * self.notes.len() as f64;
        let field = Field {
            x: [self.left, self.width - self.right],
            y: [
                10.0 + rows.len() as f64 * LEGEND_PX + self.head,
                end - 24.0 - named,
            ],
            end,
        };
        self.draw_ticks(&mut scene, &field);
        self.draw_marks(&mut scene, &field);
        self.draw_names(&mut scene, &field);
        self.draw_legend(&mut scene, &rows);
        scene.svg(title)
    }

    /// Position of a point, rounded to a tenth of a px.
    fn px(&self, [x, y]: [f64; 2], field: &Field) -> Px {
        let [top, bottom] = field.y;
        [self.x.px(x, field.x), self.y.px(y, [bottom, top])].map(tenth)
    }

    /// Ticks of both axes, with their grid.
    fn draw_ticks(&self, scene: &mut Scene, field: &Field) {
        let ([x0, x1], [top, bottom]) = (field.x.map(tenth), field.y.map(tenth));
        for tick in &self.x.ticks {
            let [x, _] = self.px([tick.at, self.y.from], field);
            if self.x.grid {
                scene.line([x, top], [x, bottom], Line::new(LIGHT, 1.0));
            }
            if !tick.text.is_empty() {
                scene.line([x, bottom], [x, bottom + TICK_PX], Line::new(GREY, 1.0));
                scene.text(
                    [x, bottom + 14.0],
                    &Label::new(&tick.text, Anchor::Middle).small(),
                );
            }
        }
        for tick in &self.y.ticks {
            let [_, y] = self.px([self.x.from, tick.at], field);
            if self.y.grid {
                scene.line([x0, y], [x1, y], Line::new(LIGHT, 1.0));
            }
            if !tick.text.is_empty() {
                scene.line([x0 - TICK_PX, y], [x0, y], Line::new(GREY, 1.0));
                let at = [x0 - TICK_PX - 4.0, y];
                scene.text(at, &Label::new(&tick.text, Anchor::End).small());
            }
        }
    }

    fn draw_marks(&self, scene: &mut Scene, field: &Field) {
        for mark in &self.marks {
            match mark {
                Mark::Line { points, line } => {
                    let points: Vec<Px> = points.iter().map(|&point| self.px(point, field)).collect();
                    scene.path(&points, *line);
                }
                Mark::Block {
                    from,
                    to,
                    colour,
                    opacity,
                } => scene.block(self.px(*from, field), self.px(*to, field), colour, *opacity),
                Mark::Dot {
                    at,
                    shape,
                    size,
                    colour,
                } => dot(scene, self.px(*at, field), *shape, *size, colour),
                Mark::Text { at, shift, label } => {
                    let [x, y] = self.px(*at, field);
                    scene.text([x + shift[0], y + shift[1]], label);
                }
            }
        }
    }

    /// The axes, their names, and notes below them.
    fn draw_names(&self, scene: &mut Scene, field: &Field) {
        let ([x0, x1], [top, bottom], end) = (field.x.map(tenth), field.y.map(tenth), field.end);
        scene.path(&[[x0, top], [x0, bottom], [x1, bottom]], Line::new(GREY, 1.0));
        if !self.x.name.is_empty() {
            let at = [0.5 * (x0 + x1), end - 9.0];
            scene.text(at, &Label::new(&self.x.name, Anchor::Middle));
        }
        for (line, words) in self.notes.iter().enumerate() {
            let at = [12.0, end + NOTE_PX * (line as f64 + 0.6)];
            scene.text(at, &Label::new(words, Anchor::Start).small());
        }
        if !self.y.name.is_empty() {
            let at = [10.0, 0.5 * (top + bottom)];
            scene.upwards(at, &Label::new(&self.y.name, Anchor::Middle));
        }
    }

    fn draw_legend(&self, scene: &mut Scene, rows: &[Vec<(usize, f64)>]) {
        for (row, entries) in rows.iter().enumerate() {
            let y = 10.0 + row as f64 * LEGEND_PX;
            for &(entry, x) in entries {
                let (key, words) = &self.legend[entry];
                match key {
                    Key::Dot(shape, colour) => dot(scene, [x + 9.0, y], *shape, 4.5, colour),
                    Key::Line(line) => scene.line([x, y], [x + 20.0, y], *line),
                    Key::Block(colour, opacity) => {
                        scene.block([x, y - 6.0], [x + 18.0, y + 6.0], colour, *opacity);
                    }
                }
                scene.text([x + 25.0, y], &Label::new(words, Anchor::Start).small());
            }
        }
    }

    /// Legend entries row by row, each with its left edge, px.
    fn legend_rows(&self) -> Vec<Vec<(usize, f64)>> {
        let mut rows: Vec<Vec<(usize, f64)>> = Vec::new();
        let mut x = f64::INFINITY;
        for (i, (_, words)) in self.legend.iter().enumerate() {
            let width = 25.0 + Label::new(words, Anchor::Start).small().width() + 22.0;
            if x + width > self.width {
                rows.push(Vec::new());
                x = 12.0;
            }
            if let Some(row) = rows.last_mut() {
                row.push((i, x));
            }
            x += width;
        }
        rows
    }
}

/// Rounds to a tenth of a px: sufficient, and it keeps files small.
fn tenth(px: f64) -> f64 {
    (px * 10.0).round() / 10.0
}

/// A marker with its outline within its size.
fn dot(scene: &mut Scene, at: Px, shape: Shape, size: f64, colour: &'static str) {
    let size = match shape {
        Shape::Ring | Shape::Cross | Shape::Bar => size,
        Shape::Circle | Shape::Square | Shape::Diamond | Shape::Triangle => size - OUTLINE_PX,
    };
    scene.marker(at, shape, size, colour);
}
