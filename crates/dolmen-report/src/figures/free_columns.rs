//! Force of the free-standing columns of a storey against its drift.

use super::axis::Axis;
use super::ink::{BLACK, BLUE, Line, ORANGE, Shape, VERMILLION};
use super::plot::{Key, Plot};
use super::words::{Axes, Signs, Titles, say};
use dolmen::stability::ColumnPoint;
use dolmen_words::Language;
use dolmen_work::frame::{Springs, StoreyColumns};

/// Millimetres in a metre; newtons in a kilonewton.
const MILLI: f64 = 1e3;
const KILO: f64 = 1e3;
/// Largest force of the springs in the figure relative to the columns: beyond it the curve of the columns would be flat. Our choice.
const SPRINGS_MOST: f64 = 3.0;

/// Columns, springs and both, from upright to the fall of the columns; the springs up to the edge of the figure.
pub fn free_columns(columns: &StoreyColumns, language: Language) -> String {
    let Some(standing) = &columns.standing else {
        return String::new();
    };
    let end_mm = MILLI * standing.falls.drift_m;
    let top_kn = standing.greatest.force_n / KILO;
    let spring_n_m = match columns.springs {
        Springs::Beside { stiffness_n_m } => Some(stiffness_n_m),
        Springs::Unknown | Springs::RigidBed | Springs::Grounded | Springs::LessThanBeds { .. } => None,
    };
    let spring_kn = |point: &ColumnPoint| spring_n_m.unwrap_or(0.0) * point.drift_m / KILO;
    let both_kn = |point: &ColumnPoint| point.force_n / KILO + spring_kn(point);
    let highest_kn = columns.curve.iter().map(both_kn).fold(top_kn, f64::max);
    let most_kn = 1.1 * highest_kn.min(SPRINGS_MOST * top_kn);
    let drawn = |force_kn: &dyn Fn(&ColumnPoint) -> f64| -> Vec<[f64; 2]> {
        let points = columns.curve.iter();
        let points = points.map(|point| [MILLI * point.drift_m, force_kn(point)]);
        cut_above(&points.collect::<Vec<_>>(), most_kn)
    };
    let x = Axis::linear(say(Axes::Drift, language), 0.0, 1.05 * end_mm, 6);
    let y = Axis::linear(say(Axes::ForceOfTheStorey, language), 0.0, most_kn, 6);
    let mut plot = Plot::new([680.0, 360.0], x, y);
    if spring_n_m.is_some() {
        for (points, colour, words) in [
            (drawn(&spring_kn), ORANGE, Signs::SpringsBeside),
            (drawn(&both_kn), BLACK, Signs::ColumnsAndSprings),
        ] {
            plot.line(points, Line::new(colour, 1.4));
            plot.key(Key::Line(Line::new(colour, 1.4)), say(words, language));
        }
    }
    plot.line(drawn(&|point| point.force_n / KILO), Line::new(BLUE, 2.0));
    plot.key(
        Key::Line(Line::new(BLUE, 2.0)),
        say(Signs::ColumnsAlone, language),
    );
    for (point, shape, words) in [
        (standing.uplift, Shape::Square, Signs::FeetLiftOff),
        (standing.greatest, Shape::Circle, Signs::GreatestForce),
        (standing.falls, Shape::Ring, Signs::ColumnsFall),
    ] {
        let at = [MILLI * point.drift_m, point.force_n.max(0.0) / KILO];
        // on a rigid bed the columns lift off at their largest force
        if shape == Shape::Square && point == standing.greatest {
            continue;
        }
        plot.sized_dot(at, shape, 6.0, VERMILLION);
        plot.key(Key::Dot(shape, VERMILLION), say(words, language));
    }
    plot.svg(say(Titles::ForceOfColumns, language))
}

/// A rising line up to a height, ending exactly there.
pub(super) fn cut_above(points: &[[f64; 2]], most: f64) -> Vec<[f64; 2]> {
    let mut all: Vec<[f64; 2]> = Vec::with_capacity(points.len());
    for point in points {
        if point[1] > most {
            if let Some(before) = all.last() {
                let share = (most - before[1]) / (point[1] - before[1]);
                all.push([before[0] + share * (point[0] - before[0]), most]);
            }
            break;
        }
        all.push(*point);
    }
    all
}
