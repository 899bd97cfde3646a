//! A stack with slowly moving supports: displacement of a stone against that of the supports.

use super::axis::Axis;
use super::ink::{GREY, Line, SERIES};
use super::plot::{Key, Plot};
use super::words::{Axes, Titles, say};
use crate::document::Series;
use dolmen::blocks::{ContactLaw, StackHistory};
use dolmen_words::Language;
use dolmen_work::stack::{SupportsRun, SupportsSimulation};

/// Width and height, px.
const SIZE_PX: [f64; 2] = [760.0, 300.0];
/// Displacements are drawn up to this multiple of that at which the stones began to move by themselves. Our choice.
const DRAWN: f64 = 1.6;
/// Approximate number of points of a line.
const POINTS: usize = 700;

/// A line of the figure.
struct LawLine<'a> {
    law: &'a ContactLaw,
    /// [movement of the supports, displacement of the stone], mm.
    points: Vec<[f64; 2]>,
}

fn lines(of: &SupportsSimulation) -> Vec<LawLine<'_>> {
    fn line<'a>(of: &SupportsSimulation, run: &'a SupportsRun) -> LawLine<'a> {
        let history = &run.moved.history;
        let ground = &run.moved.slow.ground;
        let stone = farthest(run);
        let every = history.time_s.len().div_ceil(POINTS).max(1);
        let samples = (0..history.time_s.len()).step_by(every);
        let points = samples.map(|sample| {
            let factor = ground.factor_at(history.time_s[sample]);
            [1e3 * of.length_m(factor), 1e3 * moved_m(history, sample, stone)]
        });
        LawLine {
            law: &run.law,
            points: points.collect(),
        }
    }
    of.runs.iter().map(|run| line(of, run)).collect()
}

/// The stone with the largest displacement when stones began to move by themselves, or at the end.
fn farthest(run: &SupportsRun) -> usize {
    let history = &run.moved.history;
    let sample = last_slow(run);
    let by = |a: &usize, b: &usize| moved_m(history, sample, *a).total_cmp(&moved_m(history, sample, *b));
    (0..history.blocks).max_by(by).unwrap_or(0)
}

fn last_slow(run: &SupportsRun) -> usize {
    let times = &run.moved.history.time_s;
    let last = times.len().saturating_sub(1);
    match run.moved.gave_way {
        Some(gave_way) => times.partition_point(|time_s| *time_s < gave_way.at_s).min(last),
        None => last,
    }
}

fn moved_m(history: &StackHistory, sample: usize, block: usize) -> f64 {
    let [from, to] = [0, sample].map(|sample| history.pose(sample, block).centroid_m);
    let squares = from.iter().zip(to).map(|(from, to)| (to - from) * (to - from));
    squares.sum::<f64>().sqrt()
}

/// The numbers of the figure.
pub(crate) fn supports_series(of: &SupportsSimulation) -> Vec<Series> {
    let each = lines(of).into_iter();
    let columns = each.flat_map(|LawLine { law, points }| {
        let column = |axis: Axes, place: usize| {
            let values: Vec<f64> = points.iter().map(|at| at[place]).collect();
            Series::numbers(axis, "", values)
        };
        let moved = match law {
            ContactLaw::Rigid(_) => Axes::StoneRigid,
            ContactLaw::Springs(_) => Axes::StoneSprings,
        };
        [column(Axes::SupportMovement, 0), column(moved, 1)]
    });
    columns.collect()
}

/// The figure; falling stones leave it at the top.
pub(crate) fn supports_in_time(of: &SupportsSimulation, language: Language) -> String {
    let at = |run: &SupportsRun| moved_m(&run.moved.history, last_slow(run), farthest(run));
    let most_mm = 1e3 * DRAWN * of.runs.iter().map(at).fold(1e-6, f64::max);
    let to_mm = 1e3 * of.length_m(of.factor_most);
    let x = Axis::linear(say(Axes::SupportMovement, language), 0.0, to_mm, 10);
    let y = Axis::linear(say(Axes::StoneDisplacement, language), 0.0, most_mm, 5);
    let mut plot = Plot::new(SIZE_PX, x, y);
    let given = Line::new(GREY, 1.2).dashed();
    plot.upright(1e3 * of.length_m(1.0), given);
    plot.key(Key::Line(given), say(Axes::MovementGiven, language));
    if of.followed_falls() {
        let falls = Line::new(SERIES[3], 1.2).dashed();
        plot.upright(1e3 * of.length_m(of.followed.last.factor), falls);
        plot.key(Key::Line(falls), say(Axes::LimitAnalysis, language));
    }
    for (number, LawLine { law, points }) in lines(of).into_iter().enumerate() {
        let line = Line::new(SERIES[number % SERIES.len()], 1.4);
        let within: Vec<[f64; 2]> = points.into_iter().take_while(|at| at[1] <= most_mm).collect();
        plot.line(within, line);
        let law = match law {
            ContactLaw::Rigid(_) => Axes::LawRigid,
            ContactLaw::Springs(_) => Axes::LawSprings,
        };
        plot.key(Key::Line(Line { width: 2.2, ..line }), say(law, language));
    }
    plot.svg(say(Titles::SupportsInTime, language))
}
