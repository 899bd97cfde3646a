//! Range of the factor on the springs of each joint of a stack.

use super::axis::Axis;
use super::ink::{BLUE, GREEN, GREY, Line, ORANGE, Shape};
use super::plot::{Key, Plot};
use super::words::{Axes, Factors, Titles, body_words, say};
use dolmen_words::Language;
use dolmen_work::stack::FactorsAnswer;

/// Characters of a name.
const NAME_MOST: usize = 34;

/// Range, best and smallest factor, one row per joint, the lowest at the bottom.
pub(crate) fn joint_factors(answer: &FactorsAnswer, language: Language) -> String {
    let found = &answer.found;
    let names: Vec<String> = (0..found.factors.len())
        .map(|at| {
            let [upper, lower] = answer.names(at);
            let first = |names: &[&str]| names.first().map_or_else(String::new, |name| (*name).to_owned());
            let name = format!("{} / {}", first(&upper), body_words(&first(&lower), language));
            name.chars().take(NAME_MOST).collect()
        })
        .collect();
    let mut values = found.band.to_vec();
    values.extend(found.factors.iter().filter_map(|factor| factor.least));
    let x = Axis::logarithmic(say(Axes::FactorOnSprings, language), &values, language);
    let mut plot = Plot::new([700.0, 92.0 + 24.0 * names.len() as f64], x, Axis::rows(&names));
    let common = Line::new(GREY, 1.4);
    plot.upright(found.common.factor, common);
    plot.key(Key::Line(common), say(Factors::Common, language));
    for (row, factor) in found.factors.iter().enumerate() {
        let row = row as f64;
        if let Some(range) = factor.range {
            // the end of the search band is no bound
            let line = match range.is_band() {
                true => Line::new(GREY, 2.0).dashed(),
                false => Line::new(BLUE, 4.0),
            };
            plot.line(vec![[range.lower, row], [range.upper, row]], line);
        }
        if let Some(least) = factor.least {
            plot.dot([least, row], Shape::Triangle, ORANGE);
        }
        if let Some(best) = factor.best {
            plot.dot([best, row], Shape::Diamond, GREEN);
        }
    }
    if found.factors.iter().any(|factor| factor.range.is_some()) {
        plot.key(Key::Line(Line::new(BLUE, 4.0)), say(Factors::Range, language));
    }
    if found
        .factors
        .iter()
        .any(|f| f.range.is_some_and(|range| range.is_band()))
    {
        let line = Line::new(GREY, 2.0).dashed();
        plot.key(Key::Line(line), say(Factors::NotSeen, language));
    }
    plot.key(Key::Dot(Shape::Triangle, ORANGE), say(Factors::Least, language));
    if found.factors.iter().any(|factor| factor.best.is_some()) {
        plot.key(Key::Dot(Shape::Diamond, GREEN), say(Factors::Best, language));
    }
    plot.svg(say(Titles::FactorsOfTheJoints, language))
}
