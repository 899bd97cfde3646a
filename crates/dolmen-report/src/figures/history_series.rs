//! The data of figures over time, as columns.

use super::lines::Lines;
use super::words::{Axes, Columns, say};
use crate::document::{Entries, Series};
use dolmen_words::message::Both;
use dolmen_words::{Language, Sentence};

/// Name and unit of an axis: "Displacement (mm)" contains both.
fn name_and_unit(axis: &Axes, language: Language) -> (String, String) {
    let text = say(axis.clone(), language);
    match text
        .rsplit_once(" (")
        .and_then(|(name, rest)| Some((name, rest.strip_suffix(')')?)))
    {
        Some((name, "–")) => (name.to_owned(), String::new()),
        Some((name, unit)) => (name.to_owned(), unit.to_owned()),
        None => (text, String::new()),
    }
}

fn unit(axis: &Axes) -> String {
    name_and_unit(axis, Language::English).1
}

pub(super) fn column(axis: &Axes, of: Option<[&str; 2]>, values: Vec<f64>) -> Series {
    let axis_name = |language| name_and_unit(axis, language).0;
    let name = match of {
        None => Sentence::from(Columns::Axis(Both::of(axis_name))),
        Some([english, korean]) => Sentence::from(Columns::Of {
            axis: Both::of(axis_name),
            line: Both {
                english: english.to_owned(),
                korean: korean.to_owned(),
            },
        }),
    };
    Series::numbers(name, &unit(axis), values)
}

/// Lines over time: the time, once for all lines that share it, and each line.
pub(super) fn history_series(lines: impl Fn(Language) -> Option<Lines>) -> Vec<Series> {
    let (Some(english), Some(korean)) = (lines(Language::English), lines(Language::Korean)) else {
        return Vec::new();
    };
    let mut all = Vec::new();
    let mut times: Vec<f64> = Vec::new();
    for (line, named) in english.lines.iter().zip(&korean.lines) {
        let own: Vec<f64> = line.points.iter().map(|point| point[0]).collect();
        if all.is_empty() || own != times {
            all.push(column(&Axes::Time, None, own.clone()));
            times = own;
        }
        let values = line.points.iter().map(|point| point[1]).collect();
        all.push(column(&english.axis, Some([&line.name, &named.name]), values));
    }
    all
}

/// Two columns of a loop, such as force against displacement.
pub(super) fn loop_series(names: [Axes; 2], values: [Vec<f64>; 2]) -> Vec<Series> {
    let each = names.iter().zip(values);
    each.map(|(name, values)| column(name, None, values)).collect()
}

/// Start and end time of each band, and its part.
pub(super) fn band_series(names: &[String], bands: &[(usize, [f64; 2])]) -> Vec<Series> {
    let name = |part: &usize| names.get(*part).map_or("", String::as_str);
    let parts = bands.iter().map(|(part, _)| Sentence::of_symbol(name(part)));
    vec![
        Series {
            name: Columns::Part.into(),
            unit: String::new(),
            entries: Entries::Words(parts.collect()),
        },
        Series::numbers(Columns::From, "s", bands.iter().map(|(_, times)| times[0])),
        Series::numbers(Columns::To, "s", bands.iter().map(|(_, times)| times[1])),
    ]
}
