//! Fragility curves with their bands, and the observations.

use super::axis::Axis;
use super::ink::{BLUE, GREEN, Line, ORANGE, PURPLE, Shape, VERMILLION};
use super::plot::{Key, Plot};
use super::study_drawing::{SIZE_PX, StudyDrawing, StudyFigure};
use super::words::{Axes, Studied, Titles, say};
use dolmen::assess::Observation;
use dolmen_words::Language;
use dolmen_work::study::{CombinationFragility, StateFragility, StudyAnswer};

/// Points of a curve.
const POINTS: usize = 240;
/// Number of combinations drawn; fragility.csv has all curves.
const DRAWN_MOST: usize = 4;
/// Colours of the states, the mildest first; the allowable drift of the file last.
const COLOURS: [&str; 5] = [GREEN, BLUE, ORANGE, VERMILLION, PURPLE];
const SHAPES: [Shape; 5] = [
    Shape::Circle,
    Shape::Diamond,
    Shape::Square,
    Shape::Triangle,
    Shape::Circle,
];

/// One figure per combination of inputs, for the first ones.
pub(super) fn fragility_figures(answer: &StudyAnswer, language: Language) -> Vec<StudyDrawing> {
    let drawn = answer
        .fragilities()
        .iter()
        .filter(|one| one.states.iter().any(|s| s.by_acceleration.is_ok()));
    let each = drawn.take(DRAWN_MOST).map(|one| {
        let name = format!("fragility-{}", one.combination + 1);
        StudyDrawing::new(StudyFigure::Fragility, name, curves(answer, one, language))
    });
    each.collect()
}

fn curves(answer: &StudyAnswer, one: &CombinationFragility, language: Language) -> String {
    let g = answer.gravity_m_s2;
    let largest = one.states.iter().flat_map(|state| &state.observations);
    let largest = largest.map(|seen| ends(*seen)[1] / g).fold(0.0, f64::max);
    let thetas = one
        .states
        .iter()
        .filter_map(|state| state.by_acceleration.as_ref().ok());
    let theta = thetas.map(|fit| fit.curve.theta() / g).fold(0.0, f64::max);
    let most = (1.6 * theta).min(largest).max(0.5 * largest);
    let x = Axis::linear(say(Axes::PeakGroundAcceleration, language), 0.0, most, 8);
    let y = Axis::linear(say(Axes::Probability, language), 0.0, 1.0, 5);
    let mut plot = Plot::new(SIZE_PX, x, y);
    let at = |i: usize| most * i as f64 / POINTS as f64;
    let mut has_no_band = false;
    for state in &one.states {
        let colour = COLOURS[state.state];
        if let Ok(fit) = &state.by_acceleration {
            let band = state.band().ok().flatten();
            has_no_band |= band.is_none();
            for i in 0..POINTS {
                let middle = 0.5 * (at(i) + at(i + 1));
                let interval = band
                    .as_ref()
                    .and_then(|band| band.probability(middle * g, 0.9).ok()?);
                if let Some(interval) = interval {
                    let [lower, upper] = [interval.lower, interval.upper].map(|p| state.with_those_alone(p));
                    plot.block([at(i), lower], [at(i + 1), upper], colour, 0.14);
                }
            }
            let points =
                (0..=POINTS).map(|i| [at(i), state.with_those_alone(fit.curve.probability(at(i) * g))]);
            plot.line(points.collect(), Line::new(colour, 1.8));
        }
        for [intensity, share] in seen(state) {
            if intensity / g <= most {
                plot.sized_dot([intensity / g, share], SHAPES[state.state], 3.2, colour);
            }
        }
        plot.key(
            Key::Dot(SHAPES[state.state], colour),
            answer.state_words(state.state, language),
        );
    }
    let words = answer.combination_words(one.job);
    if !words.is_empty() {
        plot.note(&words);
    }
    if let Some(after) = answer.after_words(language) {
        plot.note(&after);
    }
    plot.note(say(Studied::CurvesBandsDots, language));
    if has_no_band {
        plot.note(say(Studied::NoBand, language));
    }
    plot.note(answer.method(language));
    plot.svg(say(Titles::Fragility, language))
}

fn ends(seen: Observation) -> [f64; 2] {
    match seen {
        Observation::Stripe { intensity: x, .. }
        | Observation::At(x)
        | Observation::Above(x)
        | Observation::Below(x) => [x, x],
        Observation::Between(low, high) => [low, high],
    }
}

/// Peaks at which scans reached the state, each with the share of all scans that had reached it.
fn seen(state: &StateFragility) -> Vec<[f64; 2]> {
    let reached = state.observations.iter();
    let reached = reached.filter(|seen| !matches!(seen, Observation::Above(_)));
    let mut places: Vec<f64> = reached.map(|seen| ends(*seen)[1]).collect();
    places.sort_by(f64::total_cmp);
    let all = state.scans() as f64;
    let by_then = |place: f64| {
        let seen = places.partition_point(|other| *other <= place);
        (state.without_shaking() + seen) as f64 / all
    };
    let mut found: Vec<[f64; 2]> = places.iter().map(|place| [*place, by_then(*place)]).collect();
    if state.without_shaking() > 0 {
        found.insert(0, [0.0, state.share_alone()]);
    }
    found.dedup();
    found
}
