//! Figures of a record with an earthquake: response spectra of its channels, and the lowest frequency over time.

use super::axis::Axis;
use super::ink::{BLACK, BLUE, GREY, Line, ORANGE, PURPLE, SKY, Shape, VERMILLION};
use super::modal::WIDTH_PX;
use super::plot::{Key, Plot};
use super::words::{Axes, Titles, say};
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen::modal::{During, Mode, Part, Shaking, StrongChannel, StrongMotion};
use dolmen_words::Language;

/// Number of channels drawn; the CSV file of the figure has all.
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
    plot.svg(say(Titles::ResponseSpectrum(percent), language))
}

/// The lowest frequency of each part of a record, and its deviation: for one earthquake that of the lowest mode found both before and after
/// it; for several, in each part the mode nearest to that.
pub(crate) fn lowest_of_parts(found: &StrongMotion) -> Vec<Option<(f64, Option<f64>)>> {
    let shown = found.shown().first();
    let nearest = |part: &Part| {
        let modes = &part.analysis.as_ref()?.modes.modes;
        let off = |mode: &&Mode| shown.map_or(0.0, |of| (mode.frequency_hz / of.before_hz).ln().abs());
        let mode = modes.iter().min_by(|a, b| off(a).total_cmp(&off(b)))?;
        Some((mode.frequency_hz, mode.frequency_sd_hz))
    };
    let mut all: Vec<Option<(f64, Option<f64>)>> = found.quiet.iter().map(nearest).collect();
    if let (Some([from, to]), Some(of)) = (found.compared, shown) {
        all[from] = Some((of.before_hz, of.before_sd_hz));
        all[to] = Some((of.after_hz, of.after_sd_hz));
    }
    all
}

/// The lowest frequency before, during and after, with 95 % intervals.
pub(crate) fn frequency_through(found: &StrongMotion, language: Language) -> String {
    let half = |sd: Option<f64>| HALF_95 * sd.unwrap_or(0.0);
    let lowest = lowest_of_parts(found);
    let parts = found.quiet.iter().zip(lowest);
    let mut points: Vec<([f64; 2], [f64; 2])> = parts
        .filter_map(|(part, of)| of.map(|(hz, sd)| (part.span_s, [hz, half(sd)])))
        .collect();
    let mut windows: Vec<[f64; 3]> = Vec::new();
    for event in &found.events {
        match &event.during {
            During::Driven(of) => points.extend(
                of.analysis
                    .modes
                    .modes
                    .first()
                    .map(|mode| (of.span_s, [mode.frequency_hz, half(mode.frequency_sd_hz)])),
            ),
            During::Tracked(track) => windows.extend(
                track
                    .points
                    .iter()
                    .map(|of| [of.at_s, of.frequency_hz, HALF_95 * of.frequency_sd_hz]),
            ),
            During::Unknown => {}
        }
    }
    let last = found.events.last().map_or(0.0, |of| of.shaking.end_s);
    let (start_s, end_s) = (found.before().span_s[0], found.after().span_s[1].max(last));
    let spans = points.iter().flat_map(|(_, [hz, half])| [hz - half, hz + half]);
    let all: Vec<f64> = spans
        .chain(windows.iter().flat_map(|[_, hz, half]| [hz - half, hz + half]))
        .collect();
    let x = Axis::linear(say(Axes::Time, language), start_s.min(0.0), end_s, 8);
    let y = match all.is_empty() {
        true => Axis::linear(say(Axes::Frequency, language), 0.0, 1.0, 5),
        false => Axis::around(say(Axes::Frequency, language), &all, 6),
    };
    let [low, high] = [y.from, y.to];
    let mut plot = Plot::new([WIDTH_PX, 260.0], x, y);
    for event in &found.events {
        let Shaking {
            strong_from_s,
            strong_to_s,
            ..
        } = event.shaking;
        plot.block([strong_from_s, low], [strong_to_s, high], GREY, 0.25);
    }
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
