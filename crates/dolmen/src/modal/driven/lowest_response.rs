//! Lowest resonance of the responses to the inputs.

use super::responses::frequency_responses;
use crate::signal::Record;

/// Ratio of |H₁|² at a resonance to its smallest values below and above. Our choice: with half the motion coherent in eight segments, a line scatters
/// by 25 %.
const ABOVE: f64 = 4.0;
/// Smallest multiple coherence at a resonance. Our choice: chance gives an eighth.
const COHERENCE_LEAST: f64 = 0.5;
/// Lines of a resonance on either side of its highest one, and lines near zero that the mean and the drift of a sensor fill. Our choice.
const AROUND: usize = 2;

/// Frequency of the lowest resonance of the structure above the inputs, Hz; `None` if the responses show none.
///
/// The spectrum of a short, uneven record has no clear peak at a mode whose cycles are few, and none at all where the ground hardly moves. Divided by the
/// ground, each mode of the fixed base is a peak.
pub(super) fn lowest_response_hz(record: &Record, inputs: &[usize], segment_length: usize) -> Option<f64> {
    let found = frequency_responses(record, inputs, segment_length).ok()?;
    let lines = found.frequency_hz.len();
    let gain = |line: usize| -> f64 {
        let all = found.outputs.iter().flat_map(|of| &of.h1);
        all.map(|h1| h1[line].norm_sqr()).sum()
    };
    let gains: Vec<f64> = (0..lines).map(gain).collect();
    let lowest = |range: std::ops::Range<usize>| gains[range].iter().copied().fold(f64::INFINITY, f64::min);
    let is_resonance = |&line: &usize| {
        let near = &gains[line - AROUND..=line + AROUND];
        let is_top = near.iter().all(|of| *of <= gains[line]);
        let coherences = found.outputs.iter().map(|of| of.coherence[line]);
        is_top
            && coherences.fold(0.0, f64::max) >= COHERENCE_LEAST
            && gains[line] >= ABOVE * lowest(1 + AROUND..line)
            && gains[line] >= ABOVE * lowest(line..(2 * line).min(lines))
    };
    let first = 2 * AROUND + 1..lines.saturating_sub(AROUND);
    first
        .into_iter()
        .find(is_resonance)
        .map(|line| found.frequency_hz[line])
}
