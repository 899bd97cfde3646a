//! Peaks and modes that machines make: told by their width and by how steady they are.

use super::harmonics::{Kurtosis, band_kurtosis};
use crate::modal::options::{Harmonics, Identify};
use crate::modal::spectrum::FddResult;
use crate::modal::{ModalError, Mode, Modes, Note, Tone};
use crate::signal::Record;

/// Takes the peaks out that machines make: narrower than any structure's where the lines are fine enough to tell, or too
/// steady for random forces; returns their frequencies, Hz.
pub(crate) fn split_tones(
    record: &Record,
    peaks: &mut FddResult,
    damping_ratio_least: f64,
    notes: &mut Vec<Note>,
) -> Result<Vec<f64>, ModalError> {
    let width_hz = std::mem::take(&mut peaks.spectrum.half_power_width_hz);
    let prominence_db = std::mem::take(&mut peaks.spectrum.prominence_db);
    let modes = std::mem::take(&mut peaks.modes.modes);
    let mut tones: Vec<(f64, Tone)> = Vec::new();
    for ((mode, width_hz), prominence_db) in modes.into_iter().zip(width_hz).zip(prominence_db) {
        let kurtosis = kurtosis(record, &mode, damping_ratio_least)?;
        let narrow = width_hz < 2.0 * damping_ratio_least * mode.frequency_hz;
        if narrow || kurtosis.is_some_and(|k| k.harmonic()) {
            let tone = Tone {
                frequency_hz: mode.frequency_hz,
                width_hz,
                kurtosis,
            };
            tones.push((prominence_db, tone));
        } else {
            peaks.modes.modes.push(mode);
            peaks.spectrum.half_power_width_hz.push(width_hz);
            peaks.spectrum.prominence_db.push(prominence_db);
        }
    }
    let line_hz = peaks.spectrum.frequency_hz.get(1).copied().unwrap_or(0.0);
    let tones = strongest(tones, SKIRT_LINES * line_hz);
    let frequency_hz = tones.iter().map(|tone| tone.frequency_hz).collect();
    if !tones.is_empty() {
        notes.push(Note::Tones { tones });
    }
    Ok(frequency_hz)
}

/// Lines on each side of a tone that its leakage fills with small peaks.
const SKIRT_LINES: f64 = 20.0;

/// The tones, by frequency, without those that lie within `skirt_hz` of a stronger one.
fn strongest(mut tones: Vec<(f64, Tone)>, skirt_hz: f64) -> Vec<Tone> {
    tones.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut kept: Vec<Tone> = Vec::new();
    for (_, tone) in tones {
        let beside = |k: &Tone| (k.frequency_hz - tone.frequency_hz).abs() <= skirt_hz;
        if !kept.iter().any(beside) {
            kept.push(tone);
        }
    }
    kept.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
    kept
}

/// Kurtosis near a mode at the sensors that see most of it.
fn kurtosis(record: &Record, mode: &Mode, damping_ratio_least: f64) -> Result<Option<Kurtosis>, ModalError> {
    const CHANNELS: usize = 4;
    let mut channels: Vec<usize> = (0..mode.shape.len()).collect();
    channels.sort_by(|&a, &b| mode.shape[b].norm().total_cmp(&mode.shape[a].norm()));
    channels.truncate(CHANNELS);
    if mode.frequency_hz < 0.5 * record.sampling_rate_hz() {
        band_kurtosis(record, &channels, mode.frequency_hz, damping_ratio_least)
    } else {
        Ok(None)
    }
}

/// Gives each mode the kurtosis of its band, the least of all records, and names or takes out those that are too steady. Each record stands
/// with the components of the shapes that its channels are.
pub(crate) fn test_for_machines(
    records: &[(&Record, Vec<usize>)],
    options: &Identify,
    modes: &mut Modes,
    notes: &mut Vec<Note>,
) -> Result<(), ModalError> {
    let mut steady: Vec<Kurtosis> = Vec::new();
    for mode in &mut modes.modes {
        for (record, places) in records {
            let seen = Mode {
                shape: places.iter().map(|&place| mode.shape[place]).collect(),
                ..mode.clone()
            };
            let found = kurtosis(record, &seen, options.criteria.damping_ratio_least)?;
            let least = [mode.kurtosis, found].into_iter().flatten();
            mode.kurtosis = least.min_by(|a, b| a.kurtosis.total_cmp(&b.kurtosis));
        }
        steady.extend(mode.kurtosis.filter(Kurtosis::harmonic));
    }
    if !steady.is_empty() {
        let removed = options.harmonics == Harmonics::Remove;
        if removed {
            modes.modes.retain(|mode| !mode.harmonic());
        }
        notes.push(Note::Harmonics { steady, removed });
    }
    Ok(())
}
