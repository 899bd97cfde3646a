//! A small SVG drawing for figures with and without axes. Coordinates in px, y down.

use super::ink::{Anchor, FONTS, Label, Line, Shape, TEXT};
use crate::lowered::with_lowered;
use dolmen_words::printed_label;
use std::fmt::Write as _;

pub(crate) struct Scene {
    width: f64,
    height: f64,
    body: String,
}

impl Scene {
    pub(crate) fn new(width: f64, height: f64) -> Self {
        Scene {
            width,
            height,
            body: String::new(),
        }
    }

    pub(crate) fn line(&mut self, from: [f64; 2], to: [f64; 2], line: Line) {
        self.path(&[from, to], line);
    }

    pub(crate) fn path(&mut self, points: &[[f64; 2]], line: Line) {
        let joins = match points.len() {
            0..=2 => "",
            _ => " stroke-linejoin=\"round\"",
        };
        let points = joined(points);
        let style = stroke(line);
        put(
            &mut self.body,
            format_args!("<polyline points=\"{points}\" fill=\"none\"{joins} {style}/>"),
        );
    }

    /// A rectangle between two corners, without outline.
    pub(crate) fn block(&mut self, from: [f64; 2], to: [f64; 2], fill: &str, opacity: f64) {
        let [x, y] = [0, 1].map(|axis| short(from[axis].min(to[axis])));
        let [width, height] = [0, 1].map(|axis| short((to[axis] - from[axis]).abs()));
        let opacity = match opacity < 1.0 {
            true => format!(" opacity=\"{}\"", short(opacity)),
            false => String::new(),
        };
        put(
            &mut self.body,
            format_args!(
                "<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" fill=\"{fill}\"{opacity}/>"
            ),
        );
    }

    pub(crate) fn polygon(&mut self, points: &[[f64; 2]], fill: &str, line: Line) {
        let points = joined(points);
        let style = stroke(line);
        put(
            &mut self.body,
            format_args!("<polygon points=\"{points}\" fill=\"{fill}\" {style}/>"),
        );
    }

    pub(crate) fn circle(&mut self, at: [f64; 2], radius: f64, fill: &str, line: Line) {
        let (x, y) = (short(at[0]), short(at[1]));
        let style = stroke(line);
        put(
            &mut self.body,
            format_args!(
                "<circle cx=\"{x}\" cy=\"{y}\" r=\"{}\" fill=\"{fill}\" {style}/>",
                short(radius)
            ),
        );
    }

    /// An animated line that goes through `pictures` repeatedly, `period_s` each time; without animation the first one is shown.
    pub(crate) fn moving_path(&mut self, pictures: &[Vec<[f64; 2]>], period_s: f64, line: Line) {
        let all: Vec<String> = pictures.iter().map(|points| joined(points)).collect();
        let style = stroke(line);
        put(
            &mut self.body,
            format_args!(
                "<polyline points=\"{}\" fill=\"none\" {style}><animate attributeName=\"points\" dur=\"{}s\" repeatCount=\"indefinite\" \
                 values=\"{}\"/></polyline>",
                all.first().map_or("", String::as_str),
                short(period_s),
                all.join(";")
            ),
        );
    }

    /// A white circle that goes through `places` in the same way.
    pub(crate) fn moving_circle(&mut self, places: &[[f64; 2]], period_s: f64, radius: f64, line: Line) {
        let along = |axis: usize| -> Vec<String> { places.iter().map(|at| short(at[axis])).collect() };
        let (xs, ys) = (along(0), along(1));
        let moving = |name: &str, values: &[String]| {
            format!(
                "<animate attributeName=\"{name}\" dur=\"{}s\" repeatCount=\"indefinite\" values=\"{}\"/>",
                short(period_s),
                values.join(";")
            )
        };
        let style = stroke(line);
        put(
            &mut self.body,
            format_args!(
                "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"#ffffff\" {style}>{}{}</circle>",
                xs.first().map_or("0", String::as_str),
                ys.first().map_or("0", String::as_str),
                short(radius),
                moving("cx", &xs),
                moving("cy", &ys)
            ),
        );
    }

    /// An arrow from `from` to `to` with a filled head of `head` px.
    pub(crate) fn arrow(&mut self, from: [f64; 2], to: [f64; 2], head: f64, line: Line) {
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        let length = dx.hypot(dy);
        if length < 1e-9 {
            return;
        }
        let (ux, uy) = (dx / length, dy / length);
        let head = head.min(0.7 * length);
        let neck = [to[0] - ux * head, to[1] - uy * head];
        self.line(from, neck, line);
        let half = 0.42 * head;
        let tip = [
            to,
            [neck[0] - uy * half, neck[1] + ux * half],
            [neck[0] + uy * half, neck[1] - ux * half],
        ];
        self.polygon(&tip, line.colour, Line::new(line.colour, 0.5));
    }

    pub(crate) fn marker(&mut self, at: [f64; 2], shape: Shape, size: f64, colour: &'static str) {
        let outline = Line::new(colour, 1.8);
        match shape {
            Shape::Circle => self.circle(at, size, colour, outline),
            Shape::Ring => self.circle(at, size, "#ffffff", outline),
            _ => {
                for stroke in marker_strokes(shape, size) {
                    let points: Vec<[f64; 2]> = stroke.iter().map(|p| [at[0] + p[0], at[1] + p[1]]).collect();
                    if stroke.len() == 2 {
                        self.path(&points, Line::new(colour, 2.4));
                    } else {
                        self.polygon(&points, colour, outline);
                    }
                }
            }
        }
    }

    /// Bars of one colour without outlines, each `[column, row, columns]` on a grid with cells of size `cell`; row 0 ends at `corner`,
    /// its lower left, and rows count upwards.
    pub(crate) fn bars(&mut self, (corner, cell): ([f64; 2], [f64; 2]), bars: &[[usize; 3]], colour: &str) {
        let mut path = String::new();
        for [column, row, columns] in bars {
            let _ = write!(path, "M{column} {row}.5h{columns}");
        }
        put(
            &mut self.body,
            format_args!(
                "<path transform=\"matrix({} 0 0 {} {} {})\" d=\"{path}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.04\" \
                 shape-rendering=\"crispEdges\"/>",
                fine(cell[0]),
                fine(-cell[1]),
                short(corner[0]),
                short(corner[1])
            ),
        );
    }

    /// A text, vertically centred at `at`.
    pub(crate) fn text(&mut self, at: [f64; 2], label: &Label) {
        let anchor = match label.anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let mut style = String::new();
        if label.bold {
            style.push_str(" font-weight=\"bold\"");
        }
        if label.colour != TEXT {
            let _ = write!(style, " fill=\"{}\"", label.colour);
        }
        put(
            &mut self.body,
            format_args!(
                "<text x=\"{}\" y=\"{}\" dy=\"0.36em\" font-size=\"{}\" text-anchor=\"{anchor}\"{style}>{}</text>",
                short(at[0]),
                short(at[1]),
                short(label.size),
                escaped(&printed_label(&label.text))
            ),
        );
    }

    /// A text that reads upwards.
    pub(crate) fn upwards(&mut self, at: [f64; 2], label: &Label) {
        let (x, y) = (short(at[0]), short(at[1]));
        put(
            &mut self.body,
            format_args!("<g transform=\"translate({x} {y}) rotate(-90)\">"),
        );
        self.text([0.0, 0.0], label);
        put(&mut self.body, format_args!("</g>"));
    }

    /// The whole drawing. `title` describes it to a reader who cannot see it.
    pub(crate) fn svg(&self, title: impl AsRef<str>) -> String {
        wrapped(self.width, self.height, title.as_ref(), &self.body)
    }
}

/// The frame that every figure has.
fn wrapped(width: f64, height: f64, title: &str, body: &str) -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" viewBox=\"0 0 {} {}\" \
         font-family=\"{FONTS}\" fill=\"{TEXT}\" role=\"img\"><title>{}</title>\n{}</svg>\n",
        short(width),
        short(height),
        short(width),
        short(height),
        escaped(title),
        with_subscripts(body)
    )
}

/// Outline of a marker around its point: two points are a line, more are a filled polygon.
fn marker_strokes(shape: Shape, size: f64) -> Vec<Vec<[f64; 2]>> {
    let s = size;
    match shape {
        Shape::Circle | Shape::Ring => vec![],
        Shape::Square => vec![vec![[-s, -s], [s, -s], [s, s], [-s, s]]],
        Shape::Diamond => vec![vec![
            [0.0, -1.35 * s],
            [1.35 * s, 0.0],
            [0.0, 1.35 * s],
            [-1.35 * s, 0.0],
        ]],
        Shape::Triangle => vec![vec![
            [0.0, -1.15 * s],
            [1.15 * s, 0.85 * s],
            [-1.15 * s, 0.85 * s],
        ]],
        Shape::Cross => vec![vec![[-s, -s], [s, s]], vec![[-s, s], [s, -s]]],
        Shape::Bar => vec![vec![[0.0, -1.9 * s], [0.0, 1.9 * s]]],
    }
}

/// Sets subscripts: of symbols, and of numbers, because Unicode subscripts are too small in Korean fonts.
fn with_subscripts(body: &str) -> String {
    let set = |below: &str| {
        format!(
            "<tspan dy=\"0.28em\" font-size=\"0.75em\">{below}</tspan><tspan dy=\"-0.21em\">\u{200b}</tspan>"
        )
    };
    let body = with_lowered(body, set);
    let mut written = String::with_capacity(body.len());
    let mut digits = String::new();
    for letter in body.chars().chain(['\n']) {
        match letter {
            '₀'..='₉' => digits.extend(char::from_digit(u32::from(letter) - u32::from('₀'), 10)),
            _ => {
                if !digits.is_empty() {
                    written += &set(&digits);
                    digits.clear();
                }
                written.push(letter);
            }
        }
    }
    written.pop();
    written
}

/// Escapes text for use between tags and in attributes.
pub(crate) fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\'' => safe.push_str("&#39;"),
            // characters that XML forbids even when escaped
            c if c.is_control() && !matches!(c, '\n' | '\t') => {}
            c => safe.push(c),
        }
    }
    safe
}

fn put(body: &mut String, arguments: std::fmt::Arguments) {
    // Writing into a String cannot fail.
    let _ = body.write_fmt(arguments);
    body.push('\n');
}

fn joined(points: &[[f64; 2]]) -> String {
    let text: Vec<String> = points
        .iter()
        .map(|p| format!("{},{}", short(p[0]), short(p[1])))
        .collect();
    text.join(" ")
}

fn stroke(line: Line) -> String {
    let mut style = format!(
        "stroke=\"{}\" stroke-width=\"{}\"",
        line.colour,
        short(line.width)
    );
    if line.dashed {
        style.push_str(" stroke-dasharray=\"5 4\"");
    }
    if line.opacity < 1.0 {
        let _ = write!(style, " opacity=\"{}\"", short(line.opacity));
    }
    style
}

/// A scale with six digits after the point.
fn fine(value: f64) -> String {
    format!("{:.6}", if value.is_finite() { value } else { 0.0 })
}

/// A coordinate with at most two digits after the point; 0 if it is not a number.
fn short(value: f64) -> String {
    let value = if value.is_finite() { value } else { 0.0 };
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.into() }
}
