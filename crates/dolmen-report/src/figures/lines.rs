//! Lines over time, as plots.

use super::axis::Axis;
use super::ink::{GREY, Line, SERIES};
use super::plot::{Key, Plot};
use super::words::{Axes, Titles, say};
use dolmen_words::Language;

/// Width and height of one plot, px.
const SIZE_PX: [f64; 2] = [760.0, 210.0];
/// Number of time intervals of a line, about one per px; it is drawn through the smallest and largest value of each.
const STRETCHES: usize = 700;

/// Lines over time: their axis, the title, and the lines.
pub(super) struct Lines {
    pub(super) axis: Axes,
    pub(super) title: Titles,
    pub(super) lines: Vec<Series>,
}

impl Lines {
    /// Their plot; `None` without a line.
    pub(super) fn draw(self, language: Language) -> Option<String> {
        plot(&self.lines, self.axis, language, self.title)
    }
}

/// One line of a plot.
pub(super) struct Series {
    pub(super) name: String,
    pub(super) points: Vec<[f64; 2]>,
}

/// A line with no more points than are visible: the smallest and largest of each interval, in order. Peaks stay.
fn thinned(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    if points.len() <= 2 * STRETCHES {
        return points.to_vec();
    }
    let mut kept = Vec::with_capacity(2 * STRETCHES + 2);
    kept.extend(points.first());
    for stretch in points.chunks(points.len().div_ceil(STRETCHES)) {
        let by = |a: &(usize, &[f64; 2]), b: &(usize, &[f64; 2])| a.1[1].total_cmp(&b.1[1]);
        let least = stretch.iter().enumerate().min_by(by);
        let most = stretch.iter().enumerate().max_by(by);
        if let (Some(least), Some(most)) = (least, most) {
            let (first, second) = if least.0 < most.0 {
                (least, most)
            } else {
                (most, least)
            };
            kept.push(*first.1);
            kept.push(*second.1);
        }
    }
    kept.extend(points.last());
    kept
}

/// A plot of lines over time; `None` without a line.
pub(super) fn plot(series: &[Series], axis: Axes, language: Language, title: Titles) -> Option<String> {
    let name = say(axis, language);
    let end = series.first()?.points.last()?[0];
    let mut values: Vec<f64> = series
        .iter()
        .flat_map(|s| s.points.iter().map(|p| p[1]))
        .collect();
    values.push(0.0);
    let x = Axis::linear(say(Axes::Time, language), 0.0, end, 10);
    let mut y = Axis::around(name.as_str(), &values, 4);
    if y.to - y.from < 1e-6 {
        y = Axis::linear(name, -1.0, 1.0, 4); // no motion: a flat line on a suitable scale
    }
    let mut plot = Plot::new(SIZE_PX, x, y);
    plot.line(vec![[0.0, 0.0], [end, 0.0]], Line::new(GREY, 0.8));
    for (number, series) in series.iter().enumerate() {
        let line = Line::new(SERIES[number % SERIES.len()], 1.2);
        plot.line(thinned(&series.points), line);
        plot.key(Key::Line(Line { width: 2.2, ..line }), series.name.as_str());
    }
    Some(plot.svg(say(title, language)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_thinning_keeps_both_ends_and_every_peak() {
        let points: Vec<[f64; 2]> = (0..10_000)
            .map(|i| {
                [
                    f64::from(i),
                    if i == 7777 {
                        5.0
                    } else {
                        (0.1 * f64::from(i)).sin()
                    },
                ]
            })
            .collect();
        let kept = thinned(&points);
        assert!(kept.len() <= 2 * STRETCHES + 2);
        assert!(kept.contains(&[7777.0, 5.0]));
        assert_eq!((kept[0], kept[kept.len() - 1]), (points[0], points[9999]));
        assert!(kept.windows(2).all(|pair| pair[0][0] <= pair[1][0]));
    }
}
