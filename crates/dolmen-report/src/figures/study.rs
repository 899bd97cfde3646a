//! Figures of a study: capacity against each input, and falls and survivals against shaking.

use super::Figure;
use super::axis::Axis;
use super::fragility::fragility_figures;
use super::ink::{BLUE, GREY, Line, ORANGE, SKY, Shape, VERMILLION};
use super::plot::{Key, Plot};
use super::study_drawing::{SIZE_PX, StudyDrawing, StudyFigure};
use super::study_growth::growth_figures;
use super::words::{Axes, Studied, Titles, say};
use dolmen::assess::{Reached, Trial};
use dolmen_words::Language;
use dolmen_work::study::{LevelRow, RunOutcome, StudyAnswer, StudyKind, input_words};
use std::collections::BTreeMap;

/// Space for the texts of a level on its axis, px.
const LEVEL_PX: f64 = 110.0;
/// Spread of the dots of one level, as a fraction of the distance to the next.
const SPREAD: f64 = 0.24;

/// The figures of a study.
pub fn study_figures(answer: &StudyAnswer, language: Language) -> Vec<Figure> {
    let drawings = study_drawings(answer, language).into_iter();
    drawings.map(|drawing| drawing.figure).collect()
}

/// The same, with the content of each figure.
pub(crate) fn study_drawings(answer: &StudyAnswer, language: Language) -> Vec<StudyDrawing> {
    let mut figures = Vec::new();
    let mut add = |shows, name: String, svg: String| figures.push(StudyDrawing::new(shows, name, svg));
    if answer.study.scan.is_some() {
        let mut by_input: BTreeMap<Option<usize>, Vec<LevelRow>> = BTreeMap::new();
        for row in answer.levels() {
            by_input.entry(row.input).or_default().push(row);
        }
        for (input, rows) in &by_input {
            let (name, label) = match input {
                Some(input) => {
                    let input = &answer.inputs[*input];
                    let unit = match numbers(rows) {
                        Some(_) => input.unit.as_str(),
                        None => "", // each value is written with its own
                    };
                    (
                        input.column.clone(),
                        named(&input_words(&input.path, language), unit),
                    )
                }
                None if answer.study.variants.len() > 1 => {
                    ("all".to_owned(), say(Studied::Variant, language))
                }
                None => ("all".to_owned(), say(Studied::NothingIsVaried, language)),
            };
            add(
                StudyFigure::Capacity,
                format!("capacity-{name}"),
                capacity(answer, rows, &label, language),
            );
            add(
                StudyFigure::Survived,
                format!("survived-{name}"),
                survived(answer, *input, rows, &label, language),
            );
        }
    }
    figures.extend(fragility_figures(answer, language));
    figures.extend(growth_figures(answer, language));
    figures
}

/// Adds the method below the plot.
fn explain(plot: &mut Plot, answer: &StudyAnswer, language: Language) {
    plot.note(answer.method(language));
    for note in &answer.notes {
        plot.note(note.text(language));
    }
}

fn named(path: &str, unit: &str) -> String {
    if unit.is_empty() {
        path.to_owned()
    } else {
        format!("{path} ({unit})")
    }
}

/// Ends of the scan, g.
fn largest_g(answer: &StudyAnswer) -> f64 {
    let peaks = answer.runs.iter().map(|run| run.peak_ground_acceleration_m_s2);
    peaks.filter(|peak| peak.is_finite()).fold(0.0, f64::max) / answer.gravity_m_s2
}

/// Positions of the levels of an input: numbers at their values, words evenly spaced.
struct Levels {
    axis: Axis,
    places: Vec<f64>,
    /// Space of one level along the axis.
    step: f64,
}

impl Levels {
    fn of(rows: &[LevelRow], label: &str, language: Language) -> Self {
        match numbers(rows) {
            Some(values) if values.len() > 1 => Self::at_values(values, label),
            _ => Self::side_by_side(rows, label, language),
        }
    }

    fn at_values(values: Vec<f64>, label: &str) -> Self {
        /// Levels closer than this fraction of the span would be too thin.
        const STEP_LEAST: f64 = 0.04;
        let mut sorted = values.clone();
        sorted.sort_by(f64::total_cmp);
        let span = sorted[sorted.len() - 1] - sorted[0];
        let closest = sorted
            .windows(2)
            .map(|pair| pair[1] - pair[0])
            .fold(span, f64::min);
        let step = closest.max(STEP_LEAST * span);
        let mut axis = Axis::linear(
            label,
            sorted[0] - 0.6 * step,
            sorted[sorted.len() - 1] + 0.6 * step,
            8,
        );
        axis.grid = false;
        Levels {
            axis,
            places: values,
            step,
        }
    }

    fn side_by_side(rows: &[LevelRow], label: &str, language: Language) -> Self {
        /// Largest number of characters of a level on its axis.
        const SHOWN_MOST: usize = 16;
        let shown = |text: &str| {
            let text = text.trim_matches('"');
            let short: String = text.chars().take(SHOWN_MOST).collect();
            if short.len() < text.len() {
                format!("{short}…")
            } else {
                short
            }
        };
        let names: Vec<String> = rows.iter().map(|row| shown(row.shown(language))).collect();
        Levels {
            axis: Axis {
                name: label.to_owned(),
                ..Axis::rows(&names)
            },
            places: (0..rows.len()).map(|i| i as f64).collect(),
            step: 1.0,
        }
    }
}

/// The levels as the finite numbers that they are written as; `None` if one is not.
fn numbers(rows: &[LevelRow]) -> Option<Vec<f64>> {
    let each = rows.iter().map(|row| row.text.parse().ok());
    let numbers: Option<Vec<f64>> = each.collect();
    numbers.filter(|numbers| numbers.iter().all(|v| v.is_finite()))
}

fn wide(rows: &[LevelRow]) -> [f64; 2] {
    [SIZE_PX[0].max(LEVEL_PX * rows.len() as f64), SIZE_PX[1]]
}

/// First falls at each level: one dot per scan, median and 5 to 95 %.
fn capacity(answer: &StudyAnswer, rows: &[LevelRow], label: &str, language: Language) -> String {
    let largest = largest_g(answer);
    let y_name = match answer.kind {
        StudyKind::Stack => say(Axes::FirstFall, language),
        StudyKind::Chain => say(Axes::FirstOverturning, language),
        StudyKind::Frame | StudyKind::Building => say(Axes::DriftLimit, language),
    };
    let y = Axis::linear(y_name, 0.0, 1.06 * largest, 6);
    let Levels { axis, places, step } = Levels::of(rows, label, language);
    let mut plot = Plot::new(wide(rows), axis, y);
    let g = answer.gravity_m_s2;
    let at = |found: Option<Reached>| {
        let reached = found.filter(|found| found.is_reached());
        reached.map(|found| found.value() / g)
    };
    let above = |found: Option<Reached>| found.map(|found| at(Some(found)).unwrap_or(1.03 * largest));
    let (mut tails, mut left_out) = (false, false);
    for (i, row) in rows.iter().enumerate() {
        let place = places[i];
        let tail = |probability| above(row.quantile_m_s2(3, probability));
        if let (Some(low), Some(high)) = (tail(0.05), tail(0.95)) {
            plot.block([place - 0.3 * step, low], [place + 0.3 * step, high], SKY, 0.25);
            tails = true;
        }
        let count = row.scans.len();
        let spread = |k: usize| match count {
            0 | 1 => 0.0,
            _ => step * SPREAD * (2.0 * k as f64 / (count - 1) as f64 - 1.0),
        };
        let usable = row.first_m_s2(3);
        for (k, value) in usable.iter().enumerate() {
            match value {
                Reached::At(value) => {
                    plot.sized_dot([place + spread(k), value / g], Shape::Circle, 3.0, BLUE);
                }
                Reached::Above(_) => {
                    plot.sized_dot([place + spread(k), 1.03 * largest], Shape::Triangle, 3.5, GREY);
                }
            }
        }
        // an unusable scan: its capacity is within this range
        for (k, scan) in row.left_out().enumerate() {
            let x = place + spread(usable.len() + k);
            let high = scan.fell_m_s2().map_or(1.06 * largest, |fell| fell / g);
            let low = scan.survived_m_s2() / g;
            plot.line(vec![[x, low], [x, high]], Line::new(GREY, 1.2).dashed());
            left_out = true;
        }
        if let Some(median) = at(row.quantile_m_s2(3, 0.5)) {
            plot.line(
                vec![[place - 0.3 * step, median], [place + 0.3 * step, median]],
                Line::new(VERMILLION, 2.2),
            );
        }
    }
    let mut joined: Vec<[f64; 2]> = rows
        .iter()
        .enumerate()
        .filter_map(|(i, row)| Some([places[i], at(row.quantile_m_s2(3, 0.5))?]))
        .collect();
    joined.sort_by(|a, b| a[0].total_cmp(&b[0]));
    plot.line(joined, Line::new(VERMILLION, 1.0).dashed());
    plot.key(Key::Dot(Shape::Circle, BLUE), say(Studied::OneScan, language));
    plot.key(
        Key::Dot(Shape::Triangle, GREY),
        say(Studied::NotReached, language),
    );
    if left_out {
        plot.key(
            Key::Line(Line::new(GREY, 1.2).dashed()),
            say(Studied::Unusable, language),
        );
    }
    plot.key(
        Key::Line(Line::new(VERMILLION, 2.2)),
        say(Studied::Median, language),
    );
    if tails {
        plot.key(Key::Block(SKY, 0.4), say(Studied::FiveToNinetyFive, language));
    }
    explain(&mut plot, answer, language);
    plot.svg(say(Titles::CapacityAgainstAnInput, language))
}

/// Falls and survivals of all runs, by peak and level.
fn survived(
    answer: &StudyAnswer,
    input: Option<usize>,
    rows: &[LevelRow],
    label: &str,
    language: Language,
) -> String {
    let largest = largest_g(answer);
    let y = Axis::linear(
        say(Axes::PeakGroundAcceleration, language),
        0.0,
        1.04 * largest,
        6,
    );
    let Levels { axis, places, step } = Levels::of(rows, label, language);
    let mut plot = Plot::new(wide(rows), axis, y);
    let level_of = |job: usize| {
        let case = answer.case(job);
        rows.iter().position(|row| match input {
            Some(input) => case.texts.get(input).is_some_and(|text| *text == row.text),
            None => case.variant.as_deref().is_none_or(|variant| variant == row.text) || rows.len() == 1,
        })
    };
    // every scan of a level has its own column
    let mut columns: Vec<Vec<usize>> = vec![Vec::new(); rows.len()];
    for run in &answer.runs {
        if let Some(level) = level_of(run.job).filter(|level| columns[*level].last() != Some(&run.job)) {
            columns[level].push(run.job);
        }
    }
    for run in answer.runs.iter().filter(|run| run.scale > 0.0) {
        let Some(level) = level_of(run.job) else { continue };
        let own = &columns[level];
        let column = own.iter().position(|job| *job == run.job).unwrap_or(0) as f64;
        let spread = if own.len() > 1 {
            0.38 * step * (2.0 * column / (own.len() - 1) as f64 - 1.0)
        } else {
            0.0
        };
        let at = [
            places[level] + spread,
            run.peak_ground_acceleration_m_s2 / answer.gravity_m_s2,
        ];
        let (shape, size, colour) = match (run.outcome.trial(), run.damage_state) {
            (Trial::Fell, _) => (Shape::Cross, 3.0, VERMILLION),
            (Trial::Unknown, _) => (Shape::Ring, 3.0, GREY),
            (_, 3) => (Shape::Square, 2.6, ORANGE),
            (_, 0) => (Shape::Circle, 2.0, SKY),
            _ => (Shape::Circle, 2.6, BLUE),
        };
        plot.sized_dot(at, shape, size, colour);
    }
    key_of_states(&mut plot, answer.kind, language);
    let unusable = |outcome: RunOutcome| outcome.trial() == Trial::Unknown;
    if answer.outcomes().into_keys().any(unusable) {
        plot.key(Key::Dot(Shape::Ring, GREY), say(Studied::NoResult, language));
    }
    explain(&mut plot, answer, language);
    plot.svg(say(Titles::WhatFellAndWhatSurvived, language))
}

/// The meaning of the run colours, by kind of structure.
fn key_of_states(plot: &mut Plot, kind: StudyKind, language: Language) {
    match kind {
        StudyKind::Stack => {
            plot.key(Key::Dot(Shape::Circle, SKY), say(Studied::NothingMoved, language));
            plot.key(Key::Dot(Shape::Circle, BLUE), "DS1, DS2");
            plot.key(Key::Dot(Shape::Square, ORANGE), "DS3");
            plot.key(Key::Dot(Shape::Cross, VERMILLION), say(Studied::Fell, language));
        }
        StudyKind::Chain => {
            plot.key(Key::Dot(Shape::Circle, SKY), say(Studied::NoJointMoved, language));
            plot.key(
                Key::Dot(Shape::Circle, BLUE),
                say(Studied::JointsOpenedOrSlipped, language),
            );
            plot.key(
                Key::Dot(Shape::Cross, VERMILLION),
                say(Studied::FellOver, language),
            );
        }
        StudyKind::Frame => {
            plot.key(Key::Dot(Shape::Circle, SKY), say(Studied::Stuck, language));
            plot.key(Key::Dot(Shape::Circle, BLUE), say(Studied::Slipped, language));
            plot.key(
                Key::Dot(Shape::Cross, VERMILLION),
                say(Studied::BeyondTheDriftLimit, language),
            );
        }
        StudyKind::Building => {
            plot.key(
                Key::Dot(Shape::Circle, SKY),
                say(Studied::BelowEveryLimit, language),
            );
            plot.key(
                Key::Dot(Shape::Circle, BLUE),
                say(Studied::LimitsOneAndTwo, language),
            );
            plot.key(
                Key::Dot(Shape::Square, ORANGE),
                say(Studied::LimitThree, language),
            );
            plot.key(
                Key::Dot(Shape::Cross, VERMILLION),
                say(Studied::LimitFour, language),
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_levels_stand_at_their_values_and_keep_room_of_their_closest_neighbours() {
        let levels = Levels::at_values(vec![0.7, 0.3, 0.4], "friction");
        assert_eq!(levels.places, [0.7, 0.3, 0.4]);
        assert!((levels.step - 0.1).abs() < 1e-12);
        assert!((levels.axis.from - 0.24).abs() < 1e-12 && (levels.axis.to - 0.76).abs() < 1e-12);
        // a step of 0 would hide the levels: 4 % of the span
        let close = Levels::at_values(vec![0.0, 0.001, 1.0], "friction");
        assert!((close.step - 0.04).abs() < 1e-12);
    }
}
