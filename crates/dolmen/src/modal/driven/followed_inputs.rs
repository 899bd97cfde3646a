//! How each mode follows the inputs: its share of coherent motion, its like in ambient vibration, and the responses of the channels.

use super::driven_modes::DrivenMode;
use super::refused_inputs::averaged;
use super::responses::{FrequencyResponses, InputsAt, frequency_responses};
use crate::modal::indicators::largest;
use crate::modal::{Mode, Modes, assurance};
use crate::signal::{Channel, Record};
use dolmen_linalg::Complex64;

/// The share of each mode due to the inputs, and the corresponding mode of ambient vibration (`together`).
pub(super) fn driven_modes(
    (record, inputs): (&Record, &[usize]),
    modes: &Modes,
    together: Option<&Modes>,
) -> Vec<DrivenMode> {
    let of_mode = |mode: &Mode| DrivenMode {
        frequency_hz: mode.frequency_hz,
        explained: explained(record, inputs, (mode, &modes.channels)),
        with_base_hz: together.and_then(|all| alike(mode, modes, all)),
    };
    modes.modes.iter().map(of_mode).collect()
}

/// Multiple coherence of the inputs with the channel of largest motion, at the frequency of the mode.
fn explained(record: &Record, inputs: &[usize], (mode, channels): (&Mode, &[Channel])) -> Option<f64> {
    let spectra = averaged(record, segment_for(record, inputs, width_hz(mode))).ok()?;
    if spectra.segments < SEGMENTS_AN_INPUT * inputs.len() {
        return None;
    }
    let name = &channels[largest(&mode.shape)?].name;
    let at = record.channels().iter().position(|c| c.name == *name)?;
    let line = (mode.frequency_hz / spectra.resolution_hz).round() as usize;
    let of_inputs = InputsAt::of(&spectra, inputs, line).ok()?;
    Some(of_inputs.followed_by(&spectra, at).1)
}

/// Number of segments per input: with fewer, chance alone gives a coherence above 1/8.
const SEGMENTS_AN_INPUT: usize = 8;

/// Half of the half-power width of a mode, Hz.
fn width_hz(mode: &Mode) -> f64 {
    mode.damping_ratio.unwrap_or(0.01) * mode.frequency_hz
}

/// Length of a segment that resolves a mode of this width, limited by the number of segments needed for coherence.
pub(super) fn segment_for(record: &Record, inputs: &[usize], width_hz: f64) -> usize {
    let fine = (2.0 * record.sampling_rate_hz() / width_hz).ceil() as usize;
    fine.min(2 * record.length() / (9 * inputs.len()))
}

/// Response of each channel to the inputs, with the resolution of the narrowest mode if the record allows it.
pub(super) fn responses(record: &Record, inputs: &[usize], modes: &Modes) -> Option<FrequencyResponses> {
    let narrowest = modes.modes.iter().map(width_hz).reduce(f64::min)?;
    let segment = segment_for(record, inputs, narrowest).clamp(8, record.length().max(8));
    let found = frequency_responses(record, inputs, segment).ok()?;
    (found.segments >= SEGMENTS_AN_INPUT * inputs.len()).then_some(found)
}

/// The mode with a similar shape in the record without inputs. Its frequency is not higher, because the ground is elastic.
fn alike(mode: &Mode, of: &Modes, together: &Modes) -> Option<(f64, Option<f64>)> {
    const ALIKE: f64 = 0.9; // chosen here: a base that gives way adds its own motion to the shape
    const RATIO: std::ops::RangeInclusive<f64> = 0.3..=1.05;
    let places = of.channels.iter().map(|channel| {
        let is_same = |c: &Channel| c.name == channel.name;
        together.channels.iter().position(is_same)
    });
    let places: Vec<usize> = places.collect::<Option<_>>()?;
    let likeness = |other: &Mode| {
        let seen: Vec<Complex64> = places.iter().map(|&at| other.shape[at]).collect();
        assurance(&mode.shape, &seen)
    };
    let near = together
        .modes
        .iter()
        .filter(|other| RATIO.contains(&(other.frequency_hz / mode.frequency_hz)));
    let best = near.max_by(|a, b| likeness(a).total_cmp(&likeness(b)))?;
    (likeness(best) >= ALIKE).then_some((best.frequency_hz, best.frequency_sd_hz))
}
