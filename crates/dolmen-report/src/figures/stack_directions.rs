//! Acceleration at which a stack begins to move, by direction.

use super::axis::Axis;
use super::ink::{BLUE, GREEN, Line, ORANGE, Shape};
use super::plot::{Key, Plot};
use super::shaking::Shaking;
use super::words::{Axes, Signs, Titles, say};
use dolmen::stability::stack::StackLimitStates;
use dolmen_words::Language;
use std::f64::consts::TAU;

/// Directions of the curves.
const DIRECTIONS: usize = 360;

fn unit(k: usize) -> [f64; 2] {
    let angle = TAU * (k % DIRECTIONS) as f64 / DIRECTIONS as f64;
    [angle.cos(), angle.sin()]
}

/// First uplift in each direction of the plan, g; empty if some direction has none.
pub(super) fn uplift_g(limits: &StackLimitStates, gravity_m_s2: f64) -> Option<Vec<f64>> {
    let least = |k: usize| {
        let each = limits
            .cuts
            .iter()
            .filter_map(|cut| cut.uplift_in_m_s2(unit(k)).ok()?);
        let least = each.fold(f64::INFINITY, f64::min);
        least.is_finite().then_some(least / gravity_m_s2)
    };
    (0..DIRECTIONS).map(least).collect()
}

/// Limits by direction: the acceleration at which some joint opens, in every direction of the plan, and the lowest one at which a joint slides.
/// `shaking` is the ground motion. `None` if equilibrium alone does not determine the forces, or if the stack does not stand.
///
/// # Limits
/// Sliding is drawn as a circle of its least acceleration: on level joints it is the same in all directions.
///
/// # Source
/// Kim, N., Koo, I. Y. & Hong, S. G. (2018), Fig. 12, for two directions.
pub fn stack_directions(
    limits: &StackLimitStates,
    shaking: &Shaking,
    gravity_m_s2: f64,
    language: Language,
) -> Option<String> {
    if !limits.statically_determinate || !limits.standing.stands() {
        return None;
    }
    let along = |[x, y]: [f64; 2], g: f64| [g * x, g * y];
    let uplift = uplift_g(limits, gravity_m_s2)?;
    let rocks: Vec<[f64; 2]> = (0..=DIRECTIONS)
        .map(|k| along(unit(k), uplift[k % DIRECTIONS]))
        .collect();
    let circle = |g: f64| -> Vec<[f64; 2]> { (0..=DIRECTIONS).map(|k| along(unit(k), g)).collect() };
    let slides = limits.sliding.map(|sliding| sliding.threshold.acceleration_g);
    let far = rocks.iter().map(|[x, y]| x.hypot(*y)).fold(0.0, f64::max);
    let most = 1.12
        * [Some(far), slides, shaking.ground_g()]
            .into_iter()
            .flatten()
            .fold(0.05, f64::max);
    let axis = |name: String| Axis::linear(name, -most, most, 6);
    let mut plot = Plot::new(
        [480.0, 470.0],
        axis(say(Axes::AccelerationAlongX, language)),
        axis(say(Axes::AccelerationAlongY, language)),
    );
    plot.line(rocks, Line::new(BLUE, 1.8));
    plot.key(Key::Line(Line::new(BLUE, 1.8)), say(Signs::Rocks, language));
    if let Some(slides) = slides {
        plot.line(circle(slides), Line::new(ORANGE, 1.8).dashed());
        plot.key(
            Key::Line(Line::new(ORANGE, 1.8).dashed()),
            say(Signs::Slides, language),
        );
    }
    for level in shaking.levels() {
        if level.peak_g <= most {
            plot.line(circle(level.peak_g), level.line);
        }
        level.named(&mut plot, most, language);
    }
    if let Some(first) = &limits.governing {
        let threshold = &first.threshold;
        plot.dot(
            along(threshold.direction, threshold.acceleration_g),
            Shape::Diamond,
            GREEN,
        );
        plot.key(Key::Dot(Shape::Diamond, GREEN), say(Signs::FirstOfAll, language));
    }
    Some(plot.svg(say(Titles::LimitsByDirection, language)))
}
