//! A ranked portfolio: capacities with their intervals, the worst on top.

use super::axis::Axis;
use super::ink::{BLUE, GREY, Line, ORANGE, Shape};
use super::plot::{Key, Plot};
use super::words::{Axes, Studied, Titles, say};
use dolmen::assess::{Known, KnownCapacity, Place};
use dolmen_words::Language;
use dolmen_work::portfolio::{Basis, PortfolioAnswer, PortfolioEntry, state_words};

/// Number of structures drawn.
const DRAWN_MOST: usize = 30;
/// Characters of a name.
const NAME_MOST: usize = 34;
/// Number of standard deviations on each side that contain 90 % of a normal variable.
const NORMAL_90: f64 = 1.6448536269514722;

/// Median capacities in the state of the ranking, and of falls, with 90 % intervals.
pub fn ranking(answer: &PortfolioAnswer, language: Language) -> String {
    let drawn: Vec<(&Place, &PortfolioEntry, &KnownCapacity)> = answer.rows().take(DRAWN_MOST).collect();
    let ends = |known: &KnownCapacity| {
        let theta = known.fragility.theta() / answer.gravity_m_s2;
        let half = (NORMAL_90 * known.ln_theta_sd).exp();
        [theta / half, theta, theta * half]
    };
    let mut values = Vec::new();
    let mut names = Vec::new();
    for (place, entry, known) in drawn.iter().rev() {
        values.extend(ends(known));
        values.extend(entry.states[3].as_ref().map(ends).into_iter().flatten());
        let mut name: String = entry.name.chars().take(NAME_MOST).collect();
        if name.len() < entry.name.len() {
            name.push('…');
        }
        names.push(format!("{}. {name}", place.rank));
    }
    let x = Axis::logarithmic(say(Axes::MedianCapacity, language), &values, language);
    let height = 110.0 + 24.0 * names.len() as f64;
    let mut plot = Plot::new([720.0, height], x, Axis::rows(&names));
    for (row, (_, entry, known)) in drawn.iter().rev().enumerate() {
        let row = row as f64;
        if let Some(falls) = entry.states[3].as_ref().filter(|_| answer.state != 3) {
            plot.sized_dot([ends(falls)[1], row], shape(falls.known), 4.0, GREY);
        }
        let [low, middle, high] = ends(known);
        let colour = match entry.basis {
            Basis::Study { .. } => BLUE,
            Basis::Score { .. } => ORANGE,
        };
        plot.line(vec![[low, row], [high, row]], Line::new(colour, 2.0));
        plot.sized_dot([middle, row], shape(known.known), 4.5, colour);
    }
    let state = state_words(answer.state, language);
    let study = say(Studied::OwnStudy(state.to_owned()), language);
    let score = say(Studied::OfScore(state.to_owned()), language);
    for (colour, words, of) in [(BLUE, study, true), (ORANGE, score, false)] {
        if drawn
            .iter()
            .any(|(_, entry, _)| matches!(entry.basis, Basis::Study { .. }) == of)
        {
            plot.key(Key::Dot(Shape::Circle, colour), words);
        }
    }
    if answer.state != 3 {
        plot.key(Key::Dot(Shape::Circle, GREY), state_words(3, language));
    }
    if drawn.iter().any(|(_, entry, known)| {
        known.known != Known::Found || entry.states[3].is_some_and(|falls| falls.known != Known::Found)
    }) {
        plot.key(Key::Dot(Shape::Triangle, GREY), say(Studied::Bound, language));
    }
    plot.note(say(Studied::NinetyPercentLines, language));
    let not_drawn = answer.ranked.places.len().saturating_sub(DRAWN_MOST);
    let without = answer.left_out.len();
    if not_drawn + without > 0 {
        plot.note(say(
            Studied::NotDrawn {
                later: not_drawn,
                without,
            },
            language,
        ));
    }
    plot.svg(say(Titles::StructuresRanked, language))
}

fn shape(known: Known) -> Shape {
    match known {
        Known::Found => Shape::Circle,
        Known::AtLeast | Known::AtMost => Shape::Triangle,
    }
}
