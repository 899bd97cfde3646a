//! Figures of a ground motion: acceleration, velocity, displacement, and the response spectrum with its demand.

use super::Figure;
use super::axis::Axis;
use super::ink::{BLACK, Line, SERIES};
use super::lines::{Series, plot};
use super::plot::{Key, Plot};
use super::words::{Axes, Titles, say};
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen_words::Language;
use dolmen_work::motion::{MotionReport, MotionSeries};

/// Width and height of the spectrum, px.
const SPECTRUM_PX: [f64; 2] = [760.0, 380.0];

/// Histories of every series, and the spectra if there are any.
pub fn motion_figures(report: &MotionReport, language: Language) -> Vec<Figure> {
    let names = [
        (
            "acceleration",
            Axes::Acceleration,
            Titles::AccelerationOfTheGround,
        ),
        ("velocity", Axes::Velocity, Titles::VelocityOfTheGround),
        (
            "displacement",
            Axes::GroundDisplacement,
            Titles::DisplacementOfTheGround,
        ),
    ];
    let mut figures = Vec::new();
    for (order, (name, axis, title)) in names.into_iter().enumerate() {
        let lines: Vec<Series> = report.series.iter().map(|one| line(one, order)).collect();
        figures.extend(plot(&lines, axis, language, title).map(|svg| Figure {
            name: name.to_owned(),
            svg,
        }));
    }
    figures.extend(spectrum(report, language));
    figures
}

/// A series integrated `order` times, exactly for linear interpolation between its samples.
fn line(series: &MotionSeries, order: usize) -> Series {
    let a = series.motion.acceleration_m_s2(series.component);
    let h = series.motion.time_step_s();
    let (mut v, mut u) = (0.0, 0.0);
    let mut points = Vec::with_capacity(a.len());
    for (i, now) in a.iter().enumerate() {
        if i > 0 {
            let before = a[i - 1];
            u += h * v + h * h * (2.0 * before + now) / 6.0;
            v += 0.5 * h * (before + now);
        }
        points.push([i as f64 * h, [now / STANDARD_GRAVITY_M_S2, v, u][order]]);
    }
    Series {
        name: series.name.clone(),
        points,
    }
}

fn spectrum(report: &MotionReport, language: Language) -> Option<Figure> {
    let drawn: Vec<&MotionSeries> = report
        .series
        .iter()
        .filter(|one| !one.spectrum.is_empty())
        .collect();
    let mut lines: Vec<(String, Vec<[f64; 2]>, Line)> = Vec::new();
    for (number, one) in drawn.iter().enumerate() {
        let points = one
            .spectrum
            .iter()
            .map(|o| [o.period_s, o.pseudo_acceleration_m_s2() / STANDARD_GRAVITY_M_S2]);
        lines.push((
            one.name.clone(),
            points.collect(),
            Line::new(SERIES[number % SERIES.len()], 1.6),
        ));
    }
    if let Some(answer) = &report.matched {
        let matched = &answer.matched;
        let points = matched
            .periods_s
            .iter()
            .zip(&matched.target_m_s2)
            .map(|(t, a)| [*t, a / STANDARD_GRAVITY_M_S2]);
        lines.push((
            answer.demand.clone(),
            points.collect(),
            Line::new(BLACK, 1.6).dashed(),
        ));
    }
    let damping = drawn.first()?.spectrum[0].damping_ratio;
    let periods: Vec<f64> = lines
        .iter()
        .flat_map(|(_, points, _)| points.iter().map(|p| p[0]))
        .collect();
    let values: Vec<f64> = lines
        .iter()
        .flat_map(|(_, points, _)| points.iter().map(|p| p[1]))
        .collect();
    let most = values.iter().fold(0.0_f64, |most, v| most.max(*v));
    let x = Axis::logarithmic(say(Axes::Period, language), &periods, language);
    let y = Axis::linear(say(Axes::PseudoAcceleration, language), 0.0, 1.08 * most, 6);
    let mut plot = Plot::new(SPECTRUM_PX, x, y);
    for (name, points, line) in lines {
        plot.line(points, line);
        plot.key(Key::Line(Line { width: 2.2, ..line }), name);
    }
    let percent = dolmen_words::number::trimmed(100.0 * damping, 2);
    let title = say(Titles::ResponseSpectrum(percent), language);
    Some(Figure {
        name: "spectrum".to_owned(),
        svg: plot.svg(&title),
    })
}
