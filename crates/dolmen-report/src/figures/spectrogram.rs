//! The spectrogram of a channel as coloured cells, with the identified modes as lines.

use super::axis::Axis;
use super::channels::unit_of;
use super::ink::{Anchor, BLACK, GREY, Label, Line, VERMILLION};
use super::modal::WIDTH_PX;
use super::scene::Scene;
use super::words::{Axes, Modal, Titles, say};
use dolmen::modal::Modes;
use dolmen::signal::SpectrumAt;
use dolmen_words::Language;
use dolmen_work::record_seen::{RecordSeen, SpectrogramSeen};

/// The plotting area and the space around it, px.
const LEFT_PX: f64 = 64.0;
const RIGHT_PX: f64 = 112.0;
const TOP_PX: f64 = 14.0;
const HEIGHT_PX: f64 = 290.0;
const BELOW_PX: f64 = 48.0;
/// Number of colours for the range of densities.
const LEVELS: usize = 16;
/// Densities at least this far below the largest have the same colour, dB.
const DEPTH_DB: f64 = 60.0;
/// Share of all densities that may be below the first colour.
const BELOW_SHARE: f64 = 0.02;
/// Numbers of neighbouring modes closer than this stand side by side, px.
const NUMBER_PX: f64 = 11.0;

/// From light to dark in even steps of lightness, so that grey print keeps the order: YlGnBu of Brewer (2003).
const COLOURS: [[f64; 3]; 9] = [
    [255.0, 255.0, 217.0],
    [237.0, 248.0, 177.0],
    [199.0, 233.0, 180.0],
    [127.0, 205.0, 187.0],
    [65.0, 182.0, 196.0],
    [29.0, 145.0, 192.0],
    [34.0, 94.0, 168.0],
    [37.0, 52.0, 148.0],
    [8.0, 29.0, 88.0],
];

fn colour(level: usize) -> String {
    let at = level as f64 / (LEVELS - 1) as f64 * (COLOURS.len() - 1) as f64;
    let first = (at.floor() as usize).min(COLOURS.len() - 2);
    let part =
        |i: usize| COLOURS[first][i] + (at - first as f64) * (COLOURS[first + 1][i] - COLOURS[first][i]);
    let [red, green, blue] = [0, 1, 2].map(|i| part(i).round() as u8);
    format!("#{red:02x}{green:02x}{blue:02x}")
}

/// Range of drawn densities: [`LEVELS`] steps from `low_db` to `high_db`.
struct Range {
    low_db: f64,
    high_db: f64,
}

impl Range {
    fn of(columns: &[SpectrumAt], lines: usize) -> Self {
        let all = columns
            .iter()
            .flat_map(|column| column.density.iter().take(lines));
        let mut all: Vec<f64> = all.copied().filter(|value| *value > 0.0).map(decibels).collect();
        all.sort_by(f64::total_cmp);
        let high_db = all.last().copied().unwrap_or(0.0).ceil();
        let low_db = all
            .get((BELOW_SHARE * all.len() as f64) as usize)
            .copied()
            .unwrap_or(0.0);
        Range {
            low_db: low_db.floor().max(high_db - DEPTH_DB).min(high_db - 1.0),
            high_db,
        }
    }

    fn level(&self, density: f64) -> usize {
        if density <= 0.0 {
            return 0;
        }
        let share = (decibels(density) - self.low_db) / (self.high_db - self.low_db);
        ((share * LEVELS as f64).max(0.0) as usize).min(LEVELS - 1)
    }
}

fn decibels(density: f64) -> f64 {
    10.0 * density.log10()
}

/// Coloured cells over time and frequency, and the identified modes.
pub(crate) fn spectrogram(
    seen: &RecordSeen,
    drawn: &SpectrogramSeen,
    modes: &Modes,
    language: Language,
) -> String {
    let channel = &seen.channels[drawn.channel];
    let mut scene = Scene::new(WIDTH_PX, TOP_PX + HEIGHT_PX + BELOW_PX);
    let (from_s, to_s) = (seen.time.from_s, seen.time.to_s);
    let time = Axis::linear(say(Axes::TimeOfTheFile, language), from_s, to_s, 8);
    let frequency = Axis::linear(say(Axes::Frequency, language), 0.0, drawn.end_hz, 6);
    let width = WIDTH_PX - LEFT_PX - RIGHT_PX;
    let bottom = TOP_PX + HEIGHT_PX;
    let x = |s: f64| LEFT_PX + (s - from_s) / (to_s - from_s) * width;
    let y = |hz: f64| bottom - hz / drawn.end_hz * HEIGHT_PX;

    let of = &drawn.of;
    let lines = of
        .frequency_hz
        .iter()
        .take_while(|hz| **hz <= drawn.end_hz)
        .count();
    let range = Range::of(&of.columns, lines);
    // the cells of line 0 extend half a line below 0 Hz, and begin half a hop before the middle of the first segment
    let corner = [
        x(from_s + of.first_s - 0.5 * of.hop_s),
        y(-0.5 * of.resolution_hz),
    ];
    let cell = [
        of.hop_s / (to_s - from_s) * width,
        of.resolution_hz / drawn.end_hz * HEIGHT_PX,
    ];
    for (level, bars) in bars(&of.columns, lines, &range).iter().enumerate() {
        if !bars.is_empty() {
            scene.bars((corner, cell), bars, &colour(level));
        }
    }
    // covers cells beyond the frame
    let white = |scene: &mut Scene, top: f64, end: f64| {
        let corners = [[0.0, top], [WIDTH_PX, top], [WIDTH_PX, end], [0.0, end]];
        scene.polygon(&corners, "#ffffff", Line::new("#ffffff", 0.0));
    };
    white(&mut scene, bottom, bottom + cell[1] + 1.0);
    white(&mut scene, TOP_PX - cell[1] - 1.0, TOP_PX);

    mark_modes(&mut scene, modes, (drawn.end_hz, &y), LEFT_PX + width);
    let frame = [
        [LEFT_PX, TOP_PX],
        [LEFT_PX, bottom],
        [LEFT_PX + width, bottom],
        [LEFT_PX + width, TOP_PX],
        [LEFT_PX, TOP_PX],
    ];
    scene.path(&frame, Line::new(GREY, 1.0));
    for tick in &time.ticks {
        let at = x(tick.at);
        scene.line([at, bottom], [at, bottom + 4.0], Line::new(GREY, 1.0));
        scene.text(
            [at, bottom + 14.0],
            &Label::new(&tick.text, Anchor::Middle).small(),
        );
    }
    for tick in &frequency.ticks {
        let at = y(tick.at);
        scene.line([LEFT_PX - 4.0, at], [LEFT_PX, at], Line::new(GREY, 1.0));
        scene.text([LEFT_PX - 8.0, at], &Label::new(&tick.text, Anchor::End).small());
    }
    let below = [LEFT_PX + 0.5 * width, bottom + 34.0];
    scene.text(below, &Label::new(&time.name, Anchor::Middle));
    scene.upwards(
        [14.0, TOP_PX + 0.5 * HEIGHT_PX],
        &Label::new(&frequency.name, Anchor::Middle),
    );
    let unit = match unit_of(channel.quantity) {
        "" => say(Modal::Density, language),
        unit => say(Modal::DensityOf(unit.to_owned()), language),
    };
    scale(&mut scene, &range, unit);
    let channel = channel.name.clone();
    scene.svg(say(Titles::SpectrogramOf(channel), language))
}

/// Cells of each level, with adjacent cells of one colour joined to bars: first segment, line, segments.
fn bars(columns: &[SpectrumAt], lines: usize, range: &Range) -> Vec<Vec<[usize; 3]>> {
    let mut all = vec![Vec::new(); LEVELS];
    for line in 0..lines {
        let mut first = 0;
        let mut open: Option<(usize, usize, usize)> = None;
        for column in columns {
            let level = range.level(column.density[line]);
            open = match open {
                Some((from, length, same)) if same == level => Some((from, length + column.segments, level)),
                other => {
                    if let Some((from, length, level)) = other {
                        all[level].push([from, line, length]);
                    }
                    Some((first, column.segments, level))
                }
            };
            first += column.segments;
        }
        if let Some((from, length, level)) = open {
            all[level].push([from, line, length]);
        }
    }
    all
}

/// A line across for each mode, its number at the right.
fn mark_modes(scene: &mut Scene, modes: &Modes, (end_hz, y): (f64, &dyn Fn(f64) -> f64), right: f64) {
    let mut before: Option<(f64, f64)> = None;
    for (m, mode) in modes.modes.iter().enumerate() {
        if mode.frequency_hz > end_hz {
            continue;
        }
        let at = y(mode.frequency_hz);
        let line = Line::new(VERMILLION, 0.9).dashed();
        scene.line([LEFT_PX, at], [right, at], line.faint(0.8));
        let step = match before {
            Some((last, step)) if last - at < NUMBER_PX => step + 14.0,
            _ => 0.0,
        };
        before = Some((at, step));
        let label = Label::new((m + 1).to_string(), Anchor::Start)
            .small()
            .bold()
            .coloured(VERMILLION);
        scene.text([right + 4.0 + step, at], &label);
    }
}

/// The colours with their decibels.
fn scale(scene: &mut Scene, range: &Range, unit: String) {
    let left = WIDTH_PX - 46.0;
    let (top, height) = (TOP_PX + 24.0, HEIGHT_PX - 44.0);
    let step = height / LEVELS as f64;
    for level in 0..LEVELS {
        let low = top + height - level as f64 * step;
        let corners = [
            [left, low],
            [left + 14.0, low],
            [left + 14.0, low - step],
            [left, low - step],
        ];
        let fill = colour(level);
        scene.polygon(&corners, &fill, Line::new(GREY, 0.2));
    }
    let axis = Axis::linear("", range.low_db, range.high_db, 6);
    for tick in &axis.ticks {
        let share = (tick.at - range.low_db) / (range.high_db - range.low_db);
        let at = top + (1.0 - share) * height;
        scene.line([left + 14.0, at], [left + 18.0, at], Line::new(BLACK, 0.8));
        scene.text([left + 20.0, at], &Label::new(&tick.text, Anchor::Start).small());
    }
    scene.text(
        [WIDTH_PX - 2.0, TOP_PX + 4.0],
        &Label::new(unit, Anchor::End).small(),
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    fn column(density: Vec<f64>, segments: usize) -> SpectrumAt {
        SpectrumAt {
            time_s: 0.0,
            segments,
            density,
        }
    }

    #[test]
    fn exact_bars_hold_every_cell_once_in_its_colour() {
        let columns = [
            column(vec![1.0, 1e-3], 2),
            column(vec![1.0, 1.0], 2),
            column(vec![1e-9, 1.0], 1),
        ];
        let range = Range::of(&columns, 2);
        assert_eq!((range.low_db, range.high_db), (-60.0, 0.0));
        let all = bars(&columns, 2, &range);
        assert_eq!(all[LEVELS - 1], vec![[0, 0, 4], [2, 1, 3]]);
        assert_eq!(all[0], vec![[4, 0, 1]]);
        assert_eq!(all[8], vec![[0, 1, 2]]);
        assert_eq!(all.iter().map(Vec::len).sum::<usize>(), 4);
    }

    #[test]
    fn holds_colours_darken_evenly_so_that_grey_print_keeps_their_order() {
        let grey = |level: usize| {
            let colour = colour(level);
            let part = |at: usize| f64::from(u8::from_str_radix(&colour[at..at + 2], 16).unwrap());
            0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5)
        };
        for level in 1..LEVELS {
            assert!(grey(level) + 4.0 < grey(level - 1), "{level}");
        }
    }
}
