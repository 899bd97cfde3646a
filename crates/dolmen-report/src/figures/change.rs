//! Change between two surveys: each frequency with its interval, and changes that could have been missed.

use super::axis::Axis;
use super::ink::{BLUE, GREY, LIGHT, Line, Shape, VERMILLION};
use super::plot::{Key, Plot};
use super::words::{Axes, Modal, Titles, say};
use dolmen::assess::SurveyChange;
use dolmen_words::Language;

/// Half the height of a band, in rows.
const BAND: f64 = 0.32;

/// Relative changes of frequencies with their 95 % intervals, over the bands within which a change could have been missed.
pub fn survey_changes(change: &SurveyChange, language: Language) -> String {
    let mut values = vec![0.0];
    for mode in &change.modes {
        let r = 100.0 * mode.frequency.relative;
        values.push(r);
        if let Some(e) = &mode.frequency.evidence {
            let (half, band) = (100.0 * e.half_width_95, 100.0 * e.detectable);
            values.extend([r - half, r + half, -band, band]);
        }
    }
    let names: Vec<String> = change
        .modes
        .iter()
        .rev()
        .map(|mode| format!("{:.3} Hz", mode.from.frequency_hz))
        .collect();
    let x = Axis::around(say(Axes::ChangeOfTheFrequency, language), &values, 8);
    let mut plot = Plot::new([640.0, 110.0 + 30.0 * names.len() as f64], x, Axis::rows(&names));
    for (row, mode) in change.modes.iter().rev().enumerate() {
        let (row, r) = (row as f64, 100.0 * mode.frequency.relative);
        let Some(e) = &mode.frequency.evidence else {
            plot.dot([r, row], Shape::Ring, GREY);
            continue;
        };
        let band = 100.0 * e.detectable;
        plot.block([-band, row - BAND], [band, row + BAND], LIGHT, 1.0);
        let (colour, shape) = if e.significant {
            (VERMILLION, Shape::Diamond)
        } else {
            (BLUE, Shape::Circle)
        };
        let half = 100.0 * e.half_width_95;
        plot.line(vec![[r - half, row], [r + half, row]], Line::new(colour, 2.0));
        plot.dot([r, row], shape, colour);
    }
    plot.upright(0.0, Line::new(GREY, 1.0));
    let any = |significant: bool| {
        let all = change.modes.iter().filter_map(|m| m.frequency.evidence.as_ref());
        all.into_iter().any(|e| e.significant == significant)
    };
    if any(true) {
        plot.key(
            Key::Dot(Shape::Diamond, VERMILLION),
            say(Modal::ChangedBeyondChance, language),
        );
    }
    if any(false) {
        plot.key(Key::Dot(Shape::Circle, BLUE), say(Modal::NoChangeShown, language));
    }
    if any(true) || any(false) {
        plot.key(Key::Block(LIGHT, 1.0), say(Modal::SmallerChangesMissed, language));
    }
    plot.svg(say(Titles::WhatChangedBetweenTwoSurveys, language))
}
