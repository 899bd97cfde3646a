//! A design spectrum with the first periods of a structure on it.

use super::axis::Axis;
use super::ink::{BLUE, GREEN, Line, ORANGE, PURPLE, Shape, VERMILLION};
use super::plot::{Key, Plot};
use super::words::{Axes, Signs, Titles, say};
use dolmen::assess::demand::ShakenDirection;
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen_words::Language;
use dolmen_words::number::trimmed;
use dolmen_work::state::DemandAnswer;

/// Points of the curve.
const POINTS: usize = 240;
/// Damping ratios whose relative difference is smaller share a curve.
const SAME_DAMPING: f64 = 1e-9;
/// Shortest axis of periods, s.
const PERIOD_LEAST_S: f64 = 1.5;

/// A design spectrum for drawing.
pub(crate) struct SpectrumCurve {
    pub(crate) damping_ratio: f64,
    /// Periods, s, with spectral accelerations, g.
    pub(crate) points: Vec<[f64; 2]>,
}

/// The curves of a site: at its own damping, and at that of each first period.
pub(crate) fn spectrum_curves(answer: &DemandAnswer) -> Vec<SpectrumCurve> {
    curves_until(answer).0
}

/// The curves, and the longest period, s.
fn curves_until(answer: &DemandAnswer) -> (Vec<SpectrumCurve>, f64) {
    let site = &answer.site;
    let of_points = site.spectrum.points();
    let ends = [of_points.first(), of_points.last()].map(|point| point.map(|point| point[0]));
    let longest = answer.spectral.iter().map(|at| at.period_s).fold(0.0, f64::max);
    let plateau_s = site
        .spectrum
        .branches()
        .map_or(0.0, |branches| branches.plateau_s);
    let most_s = ends[1].unwrap_or((2.5 * plateau_s).max(1.3 * longest).max(PERIOD_LEAST_S));
    let from_s = ends[0].unwrap_or(0.0);
    let mut periods: Vec<f64> = (0..=POINTS)
        .map(|i| from_s + (most_s - from_s) * i as f64 / POINTS as f64)
        .collect();
    if let Some(branches) = site.spectrum.branches() {
        periods.extend([branches.rise_s, branches.plateau_s]);
    }
    periods.extend(of_points.iter().map(|point| point[0]));
    periods.retain(|t| *t <= most_s);
    periods.sort_by(f64::total_cmp);
    let curve = |damping_ratio: f64| -> Vec<[f64; 2]> {
        let at = |period_s: f64| site.spectrum.acceleration_m_s2(period_s, damping_ratio).ok();
        let each = periods.iter();
        each.filter_map(|t| Some([*t, at(*t)? / STANDARD_GRAVITY_M_S2]))
            .collect()
    };
    // the site's, and that of each period's own damping
    let mut dampings = vec![site.damping_ratio];
    for at in &answer.spectral {
        if dampings
            .iter()
            .all(|other| (other / at.damping_ratio - 1.0).abs() > SAME_DAMPING)
        {
            dampings.push(at.damping_ratio);
        }
    }
    let curves = dampings.into_iter().map(|damping_ratio| SpectrumCurve {
        damping_ratio,
        points: curve(damping_ratio),
    });
    (curves.collect(), most_s)
}

/// The design spectrum of a site, with the first periods of the structure and the acceleration at which a stack begins to move.
pub fn design_spectrum(answer: &DemandAnswer, language: Language) -> String {
    let (curves, most_s) = curves_until(answer);
    let capacity = answer.stack.as_ref().and_then(|stack| {
        let any = stack
            .rows
            .iter()
            .find(|row| row.direction == ShakenDirection::Any)?;
        Some(any.comparison.rigid.capacity_m_s2? / STANDARD_GRAVITY_M_S2)
    });
    let highest = curves.iter().flat_map(|curve| curve.points.iter().map(|p| p[1]));
    let top = highest.chain(capacity).fold(0.1, f64::max);
    let x = Axis::linear(say(Axes::Period, language), 0.0, most_s, 8);
    let y = Axis::linear(say(Axes::SpectralAcceleration, language), 0.0, 1.1 * top, 6);
    let mut plot = Plot::new([620.0, 320.0], x, y);
    let several = curves.len() > 1;
    for (curve, colour) in curves.into_iter().zip([BLUE, PURPLE].into_iter().cycle()) {
        let line = Line::new(colour, 1.8);
        plot.line(curve.points, line);
        let percent = trimmed(100.0 * curve.damping_ratio, 3);
        plot.key(
            Key::Line(line),
            match several {
                true => say(Signs::DemandAtDamping(percent), language),
                false => say(Signs::Demand, language),
            },
        );
    }
    if let Some(capacity) = capacity {
        plot.line(
            vec![[0.0, capacity], [most_s, capacity]],
            Line::new(GREEN, 1.6).dashed(),
        );
    }
    // for equal periods the circle is visible around the diamond
    let marks = [(Shape::Circle, 7.0, ORANGE), (Shape::Diamond, 4.5, VERMILLION)];
    for (at, (shape, size, colour)) in answer.spectral.iter().zip(marks.into_iter().cycle()) {
        let place = [at.period_s, at.acceleration_m_s2 / STANDARD_GRAVITY_M_S2];
        plot.sized_dot(place, shape, size, colour);
        plot.key(Key::Dot(shape, colour), format!("T1, {}", at.direction));
    }
    if capacity.is_some() {
        plot.key(
            Key::Line(Line::new(GREEN, 1.6).dashed()),
            say(Signs::BeginsToMove, language),
        );
    }
    plot.svg(say(Titles::DesignSpectrum, language))
}
