//! Plots with axes: marks are collected, then drawn through plotters.
//!
//! plotters' SVG backend rounds to whole units and has no dashes of its own, so it is given tenths of a px.

use super::axis::Axis;
use super::ink::{Anchor, GREY, LIGHT, Label, Line, Shape};
use super::scene::{escaped, marker_strokes, wrapped};
use plotters::coord::cartesian::Cartesian2d;
use plotters::coord::{CoordTranslate, Shift};
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Units of plotters in one px.
const FINE: f64 = 10.0;

/// plotters divides the size of a text by this before writing it.
const PLOTTERS_FONT: f64 = 1.24;

/// Length of tick marks, px.
const TICK_PX: f64 = 4.0;

/// Height of one line below the plot, px.
const NOTE_PX: f64 = 16.0;

/// Height of one line of the legend, px.
const LEGEND_PX: f64 = 20.0;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Drawn = Result<(), DrawingAreaErrorKind<std::io::Error>>;
/// A point in px from the upper left corner.
type Px = [f64; 2];

/// One thing in the plot, in the units of its axes; `shift` is in px, right and down.
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

/// How an entry of the legend is drawn.
pub(crate) enum Key {
    Dot(Shape, &'static str),
    Line(Line),
    Block(&'static str, f64),
}

/// A plot under construction.
pub(crate) struct Plot {
    pub(crate) width: f64,
    pub(crate) height: f64,
    /// Room left of the plotting area for tick texts and the axis' name, px.
    pub(crate) left: f64,
    /// Room above it, px.
    pub(crate) head: f64,
    /// Room right of it, px.
    pub(crate) right: f64,
    pub(crate) x: Axis,
    pub(crate) y: Axis,
    pub(crate) marks: Vec<Mark>,
    pub(crate) legend: Vec<(Key, String)>,
    /// Lines below the plot.
    notes: Vec<String>,
}

/// Where the axes lie, px: from left to right, from top to bottom, and where notes begin.
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

    /// Words below the plot, in as many lines as they need; it grows by them.
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

    /// A line across the whole plot at x.
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
        let title = title.as_ref();
        let view = [self.width * FINE, self.height * FINE];
        let mut drawn = String::new();
        let outcome = {
            let backend = SVGBackend::with_string(&mut drawn, (view[0] as u32, view[1] as u32));
            let area = backend.into_drawing_area();
            self.draw(&area).and_then(|()| area.present())
        };
        if let Err(fault) = outcome {
            // Writing into a String cannot fail; if it ever does, the reader sees it.
            let text = format!(
                "<text x=\"10\" y=\"200\" font-size=\"120\">{}</text>",
                escaped(&fault.to_string())
            );
            return wrapped(self.width, self.height, view, title, &text);
        }
        let inner = drawn.split_once(">\n").map_or("", |(_, rest)| rest);
        let inner = inner.trim_end().trim_end_matches("</svg>");
        // What the frame already says, and what is so by default.
        let inner = inner
            .replace(" opacity=\"1\"", "")
            .replace(" font-family=\"sans-serif\"", "");
        let inner = inner.replace(" fill=\"#1F2328\"", "");
        let inner = inner.replace(">\n<polyline", ">\n<polyline stroke-linejoin=\"round\"");
        wrapped(self.width, self.height, view, title, &inner)
    }

    fn draw(&self, area: &Area) -> Drawn {
        let rows = self.legend_rows();
        let top = 10.0 + rows.len() as f64 * LEGEND_PX + self.head;
        let named = if self.x.name.is_empty() { 0.0 } else { 20.0 };
        let end = self.height - NOTE_PX * self.notes.len() as f64;
        let bottom = end - 24.0 - named;
        let (x0, x1) = (self.left, self.width - self.right);
        let spec = Cartesian2d::<Axis, Axis>::new(
            self.x.clone(),
            self.y.clone(),
            (fine(x0)..fine(x1), fine(bottom)..fine(top)),
        );
        let to_px = |at: [f64; 2]| {
            let (x, y) = spec.translate(&(at[0], at[1]));
            [f64::from(x) / FINE, f64::from(y) / FINE]
        };

        let field = Field {
            x: [x0, x1],
            y: [top, bottom],
            end,
        };
        self.draw_ticks(area, &field, &to_px)?;
        self.draw_marks(area, &to_px)?;
        self.draw_names(area, &field)?;
        self.draw_legend(area, &rows)
    }

    /// Ticks of both axes, with their grid.
    fn draw_ticks(&self, area: &Area, field: &Field, to_px: &dyn Fn([f64; 2]) -> Px) -> Drawn {
        let ([x0, x1], [top, bottom]) = (field.x, field.y);
        for tick in &self.x.ticks {
            let [x, _] = to_px([tick.at, self.y.from]);
            if self.x.grid {
                segment(area, [x, top], [x, bottom], Line::new(LIGHT, 1.0))?;
            }
            if !tick.text.is_empty() {
                segment(area, [x, bottom], [x, bottom + TICK_PX], Line::new(GREY, 1.0))?;
                text(
                    area,
                    [x, bottom + 14.0],
                    &Label::new(&tick.text, Anchor::Middle).small(),
                    Turn::None,
                )?;
            }
        }
        for tick in &self.y.ticks {
            let [_, y] = to_px([self.x.from, tick.at]);
            if self.y.grid {
                segment(area, [x0, y], [x1, y], Line::new(LIGHT, 1.0))?;
            }
            if !tick.text.is_empty() {
                segment(area, [x0 - TICK_PX, y], [x0, y], Line::new(GREY, 1.0))?;
                let at = [x0 - TICK_PX - 4.0, y];
                text(area, at, &Label::new(&tick.text, Anchor::End).small(), Turn::None)?;
            }
        }
        Ok(())
    }

    fn draw_marks(&self, area: &Area, to_px: &dyn Fn([f64; 2]) -> Px) -> Drawn {
        for mark in &self.marks {
            match mark {
                Mark::Line { points, line } => {
                    let points: Vec<Px> = points.iter().map(|&p| to_px(p)).collect();
                    path(area, &points, *line)?;
                }
                Mark::Block {
                    from,
                    to,
                    colour,
                    opacity,
                } => {
                    let (a, b) = (to_px(*from), to_px(*to));
                    let corners = [a, [b[0], a[1]], b, [a[0], b[1]]].map(whole);
                    area.draw(&Polygon::new(
                        corners.to_vec(),
                        rgb(colour).mix(*opacity).filled(),
                    ))?;
                }
                Mark::Dot {
                    at,
                    shape,
                    size,
                    colour,
                } => dot(area, to_px(*at), *shape, *size, colour)?,
                Mark::Text { at, shift, label } => {
                    let [x, y] = to_px(*at);
                    text(area, [x + shift[0], y + shift[1]], label, Turn::None)?;
                }
            }
        }
        Ok(())
    }

    /// The axes, their names, and notes below them.
    fn draw_names(&self, area: &Area, field: &Field) -> Drawn {
        let ([x0, x1], [top, bottom], end) = (field.x, field.y, field.end);
        path(
            area,
            &[[x0, top], [x0, bottom], [x1, bottom]],
            Line::new(GREY, 1.0),
        )?;
        if !self.x.name.is_empty() {
            let at = [0.5 * (x0 + x1), end - 9.0];
            text(area, at, &Label::new(&self.x.name, Anchor::Middle), Turn::None)?;
        }
        for (line, words) in self.notes.iter().enumerate() {
            let at = [12.0, end + NOTE_PX * (line as f64 + 0.6)];
            text(area, at, &Label::new(words, Anchor::Start).small(), Turn::None)?;
        }
        if !self.y.name.is_empty() {
            let at = [10.0, 0.5 * (top + bottom)];
            text(area, at, &Label::new(&self.y.name, Anchor::Middle), Turn::Left)?;
        }
        Ok(())
    }

    fn draw_legend(&self, area: &Area, rows: &[Vec<(usize, f64)>]) -> Drawn {
        for (row, entries) in rows.iter().enumerate() {
            let y = 10.0 + row as f64 * LEGEND_PX;
            for &(entry, x) in entries {
                let (key, words) = &self.legend[entry];
                match key {
                    Key::Dot(shape, colour) => dot(area, [x + 9.0, y], *shape, 4.5, colour)?,
                    Key::Line(line) => segment(area, [x, y], [x + 20.0, y], *line)?,
                    Key::Block(colour, opacity) => {
                        let corners = [
                            [x, y - 6.0],
                            [x + 18.0, y - 6.0],
                            [x + 18.0, y + 6.0],
                            [x, y + 6.0],
                        ];
                        let style = rgb(colour).mix(*opacity).filled();
                        area.draw(&Polygon::new(corners.map(whole).to_vec(), style))?;
                    }
                }
                text(
                    area,
                    [x + 25.0, y],
                    &Label::new(words, Anchor::Start).small(),
                    Turn::None,
                )?;
            }
        }
        Ok(())
    }

    /// Entries of the legend, row by row, each with where it begins, px.
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

enum Turn {
    None,
    /// Read from below.
    Left,
}

fn fine(px: f64) -> i32 {
    (px * FINE).round() as i32
}

fn whole(px: Px) -> (i32, i32) {
    (fine(px[0]), fine(px[1]))
}

/// "#e69f00" as plotters wants it.
fn rgb(colour: &str) -> RGBColor {
    let part = |at: usize| {
        colour
            .get(at..at + 2)
            .and_then(|h| u8::from_str_radix(h, 16).ok())
            .unwrap_or(0)
    };
    RGBColor(part(1), part(3), part(5))
}

fn segment(area: &Area, from: Px, to: Px, line: Line) -> Drawn {
    path(area, &[from, to], line)
}

fn path(area: &Area, points: &[Px], line: Line) -> Drawn {
    let style = rgb(line.colour)
        .mix(line.opacity)
        .stroke_width((line.width * FINE).round() as u32);
    let points: Vec<(i32, i32)> = points.iter().map(|&p| whole(p)).collect();
    if line.dashed {
        area.draw(&DashedPathElement::new(points, fine(5.0), fine(4.0), style))
    } else {
        area.draw(&PathElement::new(points, style))
    }
}

fn dot(area: &Area, at: Px, shape: Shape, size: f64, colour: &str) -> Drawn {
    let colour = rgb(colour);
    match shape {
        Shape::Circle => area.draw(&Circle::new(whole(at), fine(size), colour.filled())),
        Shape::Ring => {
            area.draw(&Circle::new(whole(at), fine(size), WHITE.filled()))?;
            area.draw(&Circle::new(
                whole(at),
                fine(size),
                colour.stroke_width(fine(1.8) as u32),
            ))
        }
        _ => {
            for outline in marker_strokes(shape, size) {
                let points: Vec<(i32, i32)> = outline
                    .iter()
                    .map(|p| whole([at[0] + p[0], at[1] + p[1]]))
                    .collect();
                if points.len() == 2 {
                    area.draw(&PathElement::new(points, colour.stroke_width(fine(2.4) as u32)))?;
                } else {
                    area.draw(&Polygon::new(points, colour.filled()))?;
                }
            }
            Ok(())
        }
    }
}

fn text(area: &Area, at: Px, label: &Label, turn: Turn) -> Drawn {
    let anchor = match label.anchor {
        Anchor::Start => HPos::Left,
        Anchor::Middle => HPos::Center,
        Anchor::End => HPos::Right,
    };
    let style = if label.bold {
        FontStyle::Bold
    } else {
        FontStyle::Normal
    };
    let font = FontDesc::new(FontFamily::SansSerif, label.size * FINE * PLOTTERS_FONT, style);
    let font = match turn {
        Turn::None => font,
        Turn::Left => font.transform(FontTransform::Rotate270),
    };
    let colour = rgb(label.colour);
    let style = TextStyle::from(font)
        .color(&colour)
        .pos(Pos::new(anchor, VPos::Center));
    // Sizes and places of a title come from the font's own estimate; only its own point matters here.
    area.draw(&Text::new(label.text.as_str(), whole(at), style))
}
