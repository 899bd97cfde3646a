//! Figures of a record with measured inputs: the response of each channel, and its coherence with the inputs.

use super::axis::Axis;
use super::ink::{BLACK, BLUE, Line, ORANGE, PURPLE, SKY, VERMILLION};
use super::modal::{WIDTH_PX, end_hz, mark_modes, mode_key};
use super::plot::{Key, Plot};
use super::words::{Axes, Titles, say};
use dolmen::modal::{FrequencyResponse, FrequencyResponses, ModalAnalysis};
use dolmen_words::Language;

/// Number of channels drawn; the CSV file of the figure has all.
const CHANNELS_DRAWN: usize = 6;

/// Spectral lines at 0 Hz that contain the mean of a record under Hann's window.
const LINES_OF_MEAN: usize = 2;

/// The figures extend beyond the highest mode by this factor: above it, a weak input gives only noise.
const BEYOND_MODES: f64 = 1.5;

/// Colours of the channels: modes are green.
const COLOURS: [&str; CHANNELS_DRAWN] = [BLUE, VERMILLION, PURPLE, ORANGE, SKY, BLACK];

/// Modulus of the response of each channel to an input over frequency, with the modes of the fixed base.
pub(crate) fn response_magnitudes(
    analysis: &ModalAnalysis,
    (responses, input): (&FrequencyResponses, usize),
    language: Language,
) -> String {
    let name = analysis
        .driven
        .as_ref()
        .and_then(|driven| driven.inputs.get(input).cloned())
        .unwrap_or_default();
    let modulus = |of: &FrequencyResponse, line: usize| of.h1.get(input)?.get(line).map(|h| h.norm());
    let lines = drawn(analysis, responses, &modulus);
    let all: Vec<f64> = lines.iter().flatten().map(|at| at[1]).collect();
    let y = Axis::logarithmic(
        say(Axes::ResponseOver { input: name.clone() }, language),
        &all,
        language,
    );
    plotted(analysis, responses, (lines, y), language).svg(say(Titles::ResponseTo(name), language))
}

/// Coherence of each channel with the inputs over frequency.
pub(crate) fn response_coherence(
    analysis: &ModalAnalysis,
    responses: &FrequencyResponses,
    language: Language,
) -> String {
    let coherence = |of: &FrequencyResponse, line: usize| of.coherence.get(line).copied();
    let lines = drawn(analysis, responses, &coherence);
    let y = Axis::linear(say(Axes::Coherence, language), 0.0, 1.0, 5);
    plotted(analysis, responses, (lines, y), language).svg(say(Titles::CoherenceWithInputs, language))
}

type Points = Vec<[f64; 2]>;

/// The range drawn for each channel: from the first line without the mean to somewhat above the highest mode.
fn drawn(
    analysis: &ModalAnalysis,
    responses: &FrequencyResponses,
    value: &dyn Fn(&FrequencyResponse, usize) -> Option<f64>,
) -> Vec<Points> {
    let highest_hz = analysis
        .modes
        .modes
        .last()
        .map_or(f64::INFINITY, |mode| mode.frequency_hz);
    let end = end_hz(analysis).min(BEYOND_MODES * highest_hz);
    let shown = responses.frequency_hz.iter().enumerate();
    let shown: Vec<(usize, f64)> = shown
        .skip(LINES_OF_MEAN)
        .map(|(line, hz)| (line, *hz))
        .take_while(|(_, hz)| *hz <= end)
        .collect();
    let of = |output: &FrequencyResponse| -> Points {
        let points = shown
            .iter()
            .filter_map(|(line, hz)| Some([*hz, value(output, *line)?]));
        points.collect()
    };
    responses.outputs.iter().take(CHANNELS_DRAWN).map(of).collect()
}

fn plotted(
    analysis: &ModalAnalysis,
    responses: &FrequencyResponses,
    (lines, y): (Vec<Points>, Axis),
    language: Language,
) -> Plot {
    let end = lines.iter().flatten().map(|at| at[0]).fold(0.0, f64::max);
    let x = Axis::linear(say(Axes::Frequency, language), 0.0, end.max(f64::MIN_POSITIVE), 8);
    let mut plot = Plot::new([WIDTH_PX, 280.0], x, y);
    mark_modes(&mut plot, &analysis.modes);
    for (at, (points, output)) in lines.into_iter().zip(&responses.outputs).enumerate() {
        let line = Line::new(COLOURS[at % COLOURS.len()], 1.3);
        plot.line(points, line);
        plot.key(Key::Line(line), output.channel.clone());
    }
    mode_key(&mut plot, &analysis.modes, language);
    plot
}
