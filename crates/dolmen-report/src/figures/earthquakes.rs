//! Figures of a record that holds an earthquake: response spectra of its channels, and the lowest frequency through it.

use super::axis::Axis;
use super::ink::{BLACK, BLUE, GREY, Line, ORANGE, PURPLE, SKY, Shape, VERMILLION};
use super::modal::WIDTH_PX;
use super::plot::{Key, Plot};
use super::words::{Axes, Titles, say};
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen::modal::{During, Part, StrongChannel, StrongMotion};
use dolmen_words::Language;

/// Channels drawn; the numbers of all stand in the CSV beside the figure.
const CHANNELS_DRAWN: usize = 6;
const COLOURS: [&str; CHANNELS_DRAWN] = [BLUE, VERMILLION, PURPLE, ORANGE, SKY, BLACK];
/// Half of the width of an interval that holds 95 %, in standard deviations.
const HALF_95: f64 = 1.96;

/// Pseudo-acceleration of each channel over period, damping 5 %.
pub(crate) fn spectra_of_channels(channels: &[StrongChannel], language: Language) -> String {
    let with = channels.iter().filter(|of| !of.spectrum.is_empty());
    let lines: Vec<(String, Vec<[f64; 2]>)> = with
        .take(CHANNELS_DRAWN)
        .map(|of| {
            let points = of.spectrum.iter();
            let points =
                points.map(|of| [of.period_s, of.pseudo_acceleration_m_s2() / STANDARD_GRAVITY_M_S2]);
            (of.name.clone(), points.collect())
        })
        .collect();
    let all = |axis: usize| -> Vec<f64> {
        lines
            .iter()
            .flat_map(|(_, points)| points)
            .map(|at| at[axis])
            .collect()
    };
    let x = Axis::logarithmic(say(Axes::Period, language), &all(0), language);
    let most = all(1).into_iter().fold(f64::MIN_POSITIVE, f64::max);
    let y = Axis::linear(say(Axes::PseudoAcceleration, language), 0.0, 1.05 * most, 6);
    let mut plot = Plot::new([WIDTH_PX, 280.0], x, y);
    for (at, (name, points)) in lines.into_iter().enumerate() {
        let line = Line::new(COLOURS[at % COLOURS.len()], 1.4);
        plot.line(points, line);
        plot.key(Key::Line(line), name);
    }
    let percent = "5".to_owned();
    plot.svg(say(Titles::ResponseSpectrum { percent }, language))
}

/// The lowest frequency before, in and after, with 95 % intervals.
pub(crate) fn frequency_through(found: &StrongMotion, language: Language) -> String {
    let lowest = |part: &Part| {
        let mode = part.analysis.as_ref()?.modes.modes.first()?;
        Some([mode.frequency_hz, HALF_95 * mode.frequency_sd_hz.unwrap_or(0.0)])
    };
    let of = |change: usize| {
        let found = found.changes.first()?;
        let [hz, sd] = [
            [Some(found.before_hz), found.before_sd_hz],
            [Some(found.after_hz), found.after_sd_hz],
        ][change];
        Some([hz?, HALF_95 * sd.unwrap_or(0.0)])
    };
    let shaking = &found.shaking;
    let end_s = found.after.span_s[1].max(shaking.end_s);
    let mut points: Vec<([f64; 2], [f64; 2])> = Vec::new();
    let before = of(0).or_else(|| lowest(&found.before));
    points.extend(before.map(|at| (found.before.span_s, at)));
    let after = of(1).or_else(|| lowest(&found.after));
    points.extend(after.map(|at| (found.after.span_s, at)));
    let strong = [shaking.strong_from_s, shaking.strong_to_s];
    let mut windows: Vec<[f64; 3]> = Vec::new();
    match &found.during {
        During::Driven { modes, .. } => points.extend(modes.first().map(|mode| {
            let half = HALF_95 * mode.frequency_sd_hz.unwrap_or(0.0);
            (strong, [mode.frequency_hz, half])
        })),
        During::Tracked(track) => windows.extend(
            track
                .points
                .iter()
                .map(|of| [of.at_s, of.frequency_hz, HALF_95 * of.frequency_sd_hz]),
        ),
        During::Unknown => {}
    }
    let spans = points.iter().flat_map(|(_, [hz, half])| [hz - half, hz + half]);
    let all: Vec<f64> = spans
        .chain(windows.iter().flat_map(|[_, hz, half]| [hz - half, hz + half]))
        .collect();
    let x = Axis::linear(say(Axes::Time, language), 0.0, end_s, 8);
    let y = match all.is_empty() {
        true => Axis::linear(say(Axes::Frequency, language), 0.0, 1.0, 5),
        false => Axis::around(say(Axes::Frequency, language), &all, 6),
    };
    let [low, high] = [y.from, y.to];
    let mut plot = Plot::new([WIDTH_PX, 260.0], x, y);
    plot.block([strong[0], low], [strong[1], high], GREY, 0.25);
    for ([from, to], [hz, half]) in points {
        plot.line(vec![[from, hz], [to, hz]], Line::new(BLUE, 2.0));
        let middle = 0.5 * (from + to);
        plot.line(
            vec![[middle, hz - half], [middle, hz + half]],
            Line::new(BLUE, 1.4),
        );
    }
    for [at, hz, half] in windows {
        plot.line(vec![[at, hz - half], [at, hz + half]], Line::new(VERMILLION, 0.9));
        plot.dot([at, hz], Shape::Circle, VERMILLION);
    }
    plot.svg(say(Titles::FrequencyThroughEarthquake, language))
}
