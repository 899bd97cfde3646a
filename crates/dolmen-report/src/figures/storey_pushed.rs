//! Resistance of a storey against its drift, and its load.

use super::axis::Axis;
use super::free_columns::cut_above;
use super::ink::{BLACK, BLUE, Line, Shape, VERMILLION};
use super::plot::{Key, Plot};
use super::words::{Axes, Signs, Titles, say};
use dolmen_words::Language;
use dolmen_work::loads::LoadedStorey;

/// Millimetres in a metre; newtons in a kilonewton.
const MILLI: f64 = 1e3;
const KILO: f64 = 1e3;
/// Largest force in the figure relative to the load: beyond it the load would lie on the axis. Our choice.
const PUSH_MOST: f64 = 4.0;

/// The curve of the storey, the level of the load, and their intersection.
pub fn storey_pushed(storey: &LoadedStorey, language: Language) -> String {
    let under = &storey.under;
    let lean_kn = under.lean_at_rest.map_or(0.0, |_| leaning_n(storey) / KILO);
    let pushed_kn = under.shear_n.abs() / KILO + lean_kn;
    let curve: Vec<[f64; 2]> = under
        .curve
        .iter()
        .map(|point| [MILLI * point.drift_m, point.force_n / KILO])
        .collect();
    let highest_kn = curve.iter().map(|point| point[1]).fold(pushed_kn, f64::max);
    let most_kn = 1.1 * highest_kn.min(PUSH_MOST * pushed_kn);
    let curve = cut_above(&curve, most_kn);
    let end_mm = curve.iter().map(|point| point[0]).fold(0.0, f64::max);
    let x = Axis::linear(say(Axes::Drift, language), 0.0, 1.05 * end_mm, 6);
    let y = Axis::linear(say(Axes::ForceOfTheStorey, language), 0.0, most_kn, 6);
    let mut plot = Plot::new([680.0, 360.0], x, y);
    plot.line(curve, Line::new(BLUE, 2.0));
    plot.key(
        Key::Line(Line::new(BLUE, 2.0)),
        say(Signs::StoreyResists, language),
    );
    plot.line(
        vec![[0.0, pushed_kn], [1.05 * end_mm, pushed_kn]],
        Line::new(BLACK, 1.4),
    );
    plot.key(Key::Line(Line::new(BLACK, 1.4)), say(Signs::PushedWith, language));
    if let (Some(drift_m), Some(at_rest)) = (under.drift_m, at_rest_m(storey)) {
        let at = [MILLI * (at_rest + drift_m), pushed_kn];
        plot.sized_dot(at, Shape::Circle, 6.0, VERMILLION);
        plot.key(
            Key::Dot(Shape::Circle, VERMILLION),
            say(Signs::HeldHere, language),
        );
    }
    if let (Some(greatest_n), Some(drift_m)) = (under.greatest_n, under.greatest_drift_m)
        && greatest_n / KILO <= most_kn
    {
        let at = [MILLI * drift_m, greatest_n / KILO];
        plot.sized_dot(at, Shape::Ring, 6.0, VERMILLION);
        plot.key(
            Key::Dot(Shape::Ring, VERMILLION),
            say(Signs::GreatestForce, language),
        );
    }
    plot.svg(say(Titles::ForceOfStorey, language))
}

/// Force of the weight due to the lean, N.
fn leaning_n(storey: &LoadedStorey) -> f64 {
    storey.under.axial_n * storey.tilt
}

/// Drift due to the lean alone, m.
fn at_rest_m(storey: &LoadedStorey) -> Option<f64> {
    Some((storey.under.lean_at_rest? - storey.tilt) * storey.height_m)
}
