//! Limits of the joints of a stack: which one governs, and capacity compared with the ground motion.

use super::axis::Axis;
use super::ink::{Anchor, BLUE, GREEN, GREY, Label, Line, ORANGE, Shape, VERMILLION};
use super::plot::{Key, Plot};
use super::shaking::Shaking;
use super::words::{Axes, Signs, Titles, say};
use dolmen::stability::stack::{CutLimits, StackLimitStates, Threshold};
use dolmen_words::{Language, Quantity};

/// Approximate width of the plotting area, px.
const AREA_PX: f64 = 550.0;
/// Space to the right of the plot.
const RIGHT_PX: f64 = 12.0;
/// Approximate height of the plotting area, px.
const TALL_PX: f64 = 285.0;
/// Least number of names that are shortened to the first and a count.
const NAMES_MANY: usize = 3;
/// Distance of a name from a line above it, px.
const BELOW_LINE_PX: f64 = 14.0;

fn finite(threshold: Option<Threshold>) -> Option<f64> {
    threshold.map(|t| t.acceleration_g).filter(|g| g.is_finite())
}

/// Name of a joint for a figure: that of the stones at it, shortened to one name and a count from three on.
pub(crate) fn joint_name(above: &str, language: Language) -> String {
    let name = above.replace('\'', "");
    let all: Vec<&str> = name.split(", ").collect();
    match all.as_slice() {
        ["the ground"] => say(Signs::Ground, language),
        [first, rest @ ..] if rest.len() + 1 >= NAMES_MANY => {
            let (first, more) = ((*first).to_owned(), rest.len());
            say(Signs::AndMore { first, more }, language)
        }
        _ => name,
    }
}

/// Acceleration that moves the part above each joint: on the line a/g = B/H it rocks; on a horizontal line a/g = μ it slides. B/H is tan α: the distance from the centroid of the part to the nearer edge, divided by its height above the joint.
/// `shaking` is the ground motion.
///
/// # Source
/// Kim, N., Koo, I. Y. & Hong, S. G. (2018), Fig. 10.
pub fn stack_governing(limits: &StackLimitStates, shaking: &Shaking, language: Language) -> String {
    let levels = shaking.levels();
    let points: Vec<(f64, f64, &CutLimits)> = limits
        .cuts
        .iter()
        .filter_map(|cut| Some((finite(cut.uplift)?, finite(cut.sliding)?, cut)))
        .collect();
    let slides = points.iter().map(|p| p.1).fold(0.0, f64::max);
    let rocks = points.iter().map(|p| p.0).fold(0.0, f64::max);
    let most = 1.12 * rocks.max(slides).min(4.0 * slides.max(0.05));
    let tall = 1.15 * shaking.ground_g().unwrap_or(0.0).max(slides).max(0.05);
    let x = Axis::linear(say(Axes::WidthOverHeight, language), 0.0, most, 8);
    let y = Axis::linear(say(Axes::Acceleration, language), 0.0, tall, 6);
    let mut plot = Plot::new([620.0, 360.0], x, y);
    let mut frictions: Vec<f64> = points.iter().map(|p| p.1).collect();
    frictions.sort_by(f64::total_cmp);
    frictions.dedup_by(|a, b| (*a - *b).abs() < 1e-6);
    plot.line(
        vec![[0.0, 0.0], [tall.min(most), tall.min(most)]],
        Line::new(BLUE, 1.8),
    );
    for mu in &frictions {
        plot.line(vec![[0.0, *mu], [most, *mu]], Line::new(ORANGE, 1.8).dashed());
    }
    for level in levels.iter().filter(|level| level.peak_g <= tall) {
        plot.line(vec![[0.0, level.peak_g], [most, level.peak_g]], level.line);
    }
    let mut named: Vec<[f64; 3]> = Vec::new();
    for (rock, slide, cut) in &points {
        let name = joint_name(&cut.above, language);
        let name = match *rock > most {
            true => {
                let ratio = Quantity::ratio(*rock, 3);
                say(Signs::BeyondAxis { name, ratio }, language)
            }
            false => name,
        };
        let label = Label::new(name, Anchor::Middle).small();
        let half = 0.5 * (label.width() + 8.0) * most / AREA_PX;
        let (at, shape, colour, shift) = if rock <= slide {
            ([*rock, *rock], Shape::Circle, BLUE, 12.0 + 0.5 * label.width())
        } else {
            // at the right end, the name stays inside the plot
            let room = (most - rock.min(most)) * AREA_PX / most;
            let shift = (room + RIGHT_PX - 0.5 * label.width()).min(0.0);
            ([rock.min(most), *slide], Shape::Diamond, ORANGE, shift)
        };
        plot.dot(at, shape, colour);
        // names on the slope are beside their points at different heights; names on the horizontal line have one height
        let raise = match rock <= slide {
            true => {
                let to_line = frictions.iter().map(|mu| (mu - rock) * TALL_PX / tall);
                let near = to_line.filter(|px| (0.0..BELOW_LINE_PX).contains(px));
                near.map(|px| BELOW_LINE_PX - px).fold(5.0, f64::max)
            }
            false => -13.0,
        };
        let height = at[1] - raise * tall / TALL_PX;
        let middle = at[0] + shift * most / AREA_PX;
        let clear = |other: &[f64; 3]| {
            (other[0] - middle).abs() > other[1] + half || (other[2] - height).abs() > 13.0 * tall / TALL_PX
        };
        if named.iter().all(clear) {
            plot.text(at, [shift, raise], label);
            named.push([middle, half, height]);
        }
    }
    plot.key(
        Key::Line(Line::new(BLUE, 1.8)),
        say(Signs::RocksOnSlope, language),
    );
    let slides = say(Signs::SlidesOnLevel, language);
    plot.key(Key::Line(Line::new(ORANGE, 1.8).dashed()), slides);
    for level in levels {
        level.named(&mut plot, tall, language);
    }
    plot.svg(say(Titles::WhatGovernsEachJoint, language))
}

/// Capacity of each joint, lowest at the bottom, against the peak of the ground, after Fig. 12 of the paper.
///
/// # Source
/// Kim, N., Koo, I. Y. & Hong, S. G. (2018), Fig. 12.
pub fn stack_capacity(limits: &StackLimitStates, shaking: &Shaking, language: Language) -> String {
    let rows: Vec<String> = limits
        .cuts
        .iter()
        .map(|cut| joint_name(&cut.above, language))
        .collect();
    let mut all: Vec<f64> = limits
        .cuts
        .iter()
        .flat_map(|c| [finite(c.uplift), finite(c.sliding)])
        .flatten()
        .collect();
    let levels = shaking.levels();
    all.extend(levels.iter().map(|level| level.peak_g));
    let name = say(Axes::FirstMotion, language);
    let x = Axis::logarithmic(name, &all, language);
    let mut plot = Plot::new([700.0, 92.0 + 24.0 * rows.len() as f64], x, Axis::rows(&rows));
    if let Some(ground) = shaking.ground_g().filter(|g| *g > plot.x.from) {
        plot.block([plot.x.from, plot.y.from], [ground, plot.y.to], VERMILLION, 0.10);
    }
    for level in levels {
        plot.upright(level.peak_g, level.line);
        plot.key(Key::Line(level.line), say(level.words, language));
    }
    for (row, cut) in limits.cuts.iter().enumerate() {
        let row = row as f64;
        let (rocks, slides) = (finite(cut.uplift), finite(cut.sliding));
        if let (Some(rocks), Some(slides)) = (rocks, slides) {
            plot.line(vec![[rocks, row], [slides, row]], Line::new(GREY, 0.9));
        }
        if let Some(rocks) = rocks {
            plot.dot([rocks, row], Shape::Circle, BLUE);
        }
        if let Some(slides) = slides {
            plot.dot([slides, row], Shape::Diamond, ORANGE);
        }
    }
    if let Some(first) = &limits.governing {
        let at = [first.threshold.acceleration_g, first.cut as f64];
        plot.sized_dot(at, Shape::Bar, 5.0, GREEN);
        plot.key(Key::Dot(Shape::Bar, GREEN), say(Signs::FirstOfAll, language));
    }
    plot.key(Key::Dot(Shape::Circle, BLUE), say(Signs::Rocks, language));
    plot.key(Key::Dot(Shape::Diamond, ORANGE), say(Signs::Slides, language));
    plot.svg(say(Titles::CapacityOfEachJoint, language))
}
