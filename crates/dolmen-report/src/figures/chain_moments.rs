//! Moments in the joints of a chain under loads, compared with the limits of its beds.

use super::axis::Axis;
use super::ink::{BLACK, BLUE, Line, ORANGE, Shape, VERMILLION};
use super::plot::{Key, Plot};
use super::words::{Axes, Signs, Titles, say};
use dolmen::stability::{ChainUnderLoads, JointUnderLoads};
use dolmen_words::Language;

/// N·m in a kN·m.
const KILO: f64 = 1e3;

/// At the height of each joint, m: the moment of the loads on the upright chain, that of the leaning shape with the tilt, and the limit.
pub fn chain_moments(under: &ChainUnderLoads, heights_m: &[f64], language: Language) -> String {
    let points = |value: fn(&JointUnderLoads) -> Option<f64>| -> Vec<[f64; 2]> {
        let pairs = under.joints.iter().zip(heights_m);
        pairs
            .filter_map(|(joint, height_m)| Some([value(joint)? / KILO, *height_m]))
            .collect()
    };
    let upright = points(|joint| Some(joint.rigid_moment_n_m.abs()));
    let leaning = points(|joint| Some(joint.moment_n_m?.abs() + joint.tilt_moment_n_m.abs()));
    let limit = points(|joint| joint.limit_n_m);
    let each = upright.iter().chain(&leaning).chain(&limit);
    let most = each.map(|point| point[0]).fold(0.0, f64::max);
    let top_m = heights_m.last().copied().unwrap_or(1.0);
    let x = Axis::linear(say(Axes::Moment, language), 0.0, 1.05 * most, 6);
    let y = Axis::linear(say(Axes::Height, language), 0.0, top_m.max(1.0), 6);
    let mut plot = Plot::new([680.0, 360.0], x, y);
    let series = [
        (limit, BLACK, Shape::Bar, Signs::BedLimit),
        (upright, ORANGE, Shape::Square, Signs::MomentUpright),
        (leaning, BLUE, Shape::Circle, Signs::MomentLeaning),
    ];
    for (points, colour, shape, words) in series {
        if points.is_empty() {
            continue;
        }
        for point in &points {
            plot.sized_dot(*point, shape, 5.0, colour);
        }
        plot.line(points, Line::new(colour, 1.6));
        plot.key(Key::Dot(shape, colour), say(words, language));
    }
    if let Some(joint) = under.governing_joint
        && let (Some(of), Some(height_m)) = (under.joints.get(joint - 1), heights_m.get(joint - 1))
        && of.factor.is_some_and(|factor| factor <= 1.0)
    {
        let moment = of.moment_n_m.unwrap_or(of.rigid_moment_n_m).abs() + of.tilt_moment_n_m.abs();
        plot.sized_dot([moment / KILO, *height_m], Shape::Ring, 9.0, VERMILLION);
    }
    plot.svg(say(Titles::MomentsOfTheJoints, language))
}
