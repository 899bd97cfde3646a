//! The first frequency of pagodas against the height of their bodies.

use super::axis::Axis;
use super::ink::{GREY, Line, SERIES};
use super::plot::{Key, Plot};
use super::words::{Axes, Signs, Titles, say};
use dolmen_words::Language;
use dolmen_work::stack::FrequencyByHeight;

/// Width and height, px.
const SIZE_PX: [f64; 2] = [560.0, 340.0];

/// One line per number of storeys, and eq. 1 of Kim, Koo and Hong (2018) from the height alone; `None` without a point.
pub(crate) fn frequency_by_height(
    grid: &[FrequencyByHeight],
    of_thumb: &[[f64; 2]],
    language: Language,
) -> Option<String> {
    let points = |of: &FrequencyByHeight| -> Vec<[f64; 2]> {
        let each = of.points.iter();
        each.map(|point| [point.body_height_m, point.frequency_hz])
            .collect()
    };
    let all: Vec<[f64; 2]> = grid
        .iter()
        .flat_map(points)
        .chain(of_thumb.iter().copied())
        .collect();
    let heights: Vec<f64> = all.iter().map(|point| point[0]).collect();
    let mut frequencies: Vec<f64> = all.iter().map(|point| point[1]).collect();
    frequencies.push(0.0);
    all.first()?;
    let mut plot = Plot::new(
        SIZE_PX,
        Axis::around(say(Axes::BodyHeight, language).as_str(), &heights, 7),
        Axis::around(say(Axes::Frequency, language).as_str(), &frequencies, 6),
    );
    for (number, of) in grid.iter().enumerate() {
        let line = Line::new(SERIES[number % SERIES.len()], 1.6);
        plot.line(points(of), line);
        let name = say(Signs::StoreysOf(of.storeys as usize), language);
        plot.key(Key::Line(Line { width: 2.2, ..line }), name);
    }
    let line = Line::new(GREY, 1.2);
    plot.line(of_thumb.to_vec(), line);
    plot.key(Key::Line(line), say(Signs::ByHeightAlone, language));
    Some(plot.svg(say(Titles::FrequencyAgainstHeight, language)))
}
