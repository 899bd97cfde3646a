//! Peaks and modes caused by machines, detected by their width, steadiness and variation.

use super::averaged::AveragedWidths;
use super::harmonics::{GAUSSIAN, Kurtosis, band_kurtosis};
use super::in_spells::InSpells;
use super::lines::{FineLines, LEAVES_MOST, LineTest, seeing_most};
use super::remarks::{USUAL_LEAST, explained};
use super::spells::{in_spells, note_spells};
use super::wander::{Wander, wander};
use crate::modal::candidate::Candidate;
use crate::modal::options::{Harmonics, Identify};
use crate::modal::spectrum::FddResult;
use crate::modal::{Method, ModalError, Mode, Modes, Note, Refusal, Tone, ToneOnMode};
use crate::signal::Record;

/// Largest power of a sine, over that of the mode at its frequency, for which both have a separate result. Our choice: a stronger sine has
/// flanks that look like a mode.
const STRENGTH_MOST: f64 = 15.0;

/// Kurtosis below which an amplitude is closer to that of a sine (1.5) than to that of random motion. Our choice: the tone of Palisaden at 20.5 Hz has 1.57.
const STEADY_MOST: f64 = 2.0;

/// Peaks that are not modes.
#[derive(Clone, Debug, Default)]
pub(crate) struct SetAside {
    /// Frequencies of machines, and of lines that cannot be distinguished from machines, Hz.
    pub(crate) tones_hz: Vec<f64>,
    /// Each peak as a mode, with the reason.
    pub(crate) peaks: Vec<Candidate>,
}

/// Removes and returns the peaks that are too steady for random forces, or narrower than a mode with the least damping (if the resolution is
/// sufficient). Peaks with a constant phase throughout, or too steady, are machines; the others are undecided.
pub(crate) fn split_tones(
    record: &Record,
    peaks: &mut FddResult,
    options: &Identify,
    notes: &mut Vec<Note>,
) -> Result<SetAside, ModalError> {
    let width_hz = std::mem::take(&mut peaks.spectrum.half_power_width_hz);
    let prominence_db = std::mem::take(&mut peaks.spectrum.prominence_db);
    let modes = std::mem::take(&mut peaks.modes.modes);
    let mut lines = FineLines::new(record);
    let averaged = AveragedWidths::of(record, options)?;
    let (mut taken, mut spells): (Vec<RemovedPeak>, Vec<InSpells>) = (Vec::new(), Vec::new());
    let mut set_aside: Vec<Candidate> = Vec::new();
    for ((mode, width_hz), prominence_db) in modes.into_iter().zip(width_hz).zip(prominence_db) {
        let damping_ratio_least = options
            .criteria
            .damping_least_at(mode.frequency_hz, record.duration_s());
        let kurtosis = kurtosis(record, &mode, USUAL_LEAST.max(damping_ratio_least))?;
        let looks_steady = kurtosis.as_ref().is_some_and(Kurtosis::harmonic);
        let is_sine = (looks_steady || 0.5 * width_hz / mode.frequency_hz < USUAL_LEAST)
            && lines.test(&mode).is_some_and(|line| line.is_sine());
        // the width of a steady line does not come from averaging
        let width_hz = match is_sine || looks_steady {
            true => width_hz,
            false => averaged.width_hz(mode.frequency_hz, width_hz),
        };
        let damping_ratio = 0.5 * width_hz / mode.frequency_hz;
        let as_wide = Mode {
            damping_ratio: Some(damping_ratio),
            ..mode.clone()
        };
        // a free decay is never present throughout the record
        let found = in_spells(record, &as_wide).filter(|_| options.method != Method::Era);
        // a peak that looks too steady for usual damping is a machine if it is also a sine, intermittent, or too steady for its own width
        let is_steady = looks_steady
            && (is_sine
                || found.is_some()
                || is_steady_at(record, &mode, [damping_ratio_least, damping_ratio])?);
        if let Some(found) = found.filter(|_| !is_steady) {
            spells.push(found);
            set_aside.push(Candidate {
                mode,
                refusal: Some(Refusal::InSpells),
            });
        } else if damping_ratio < damping_ratio_least || looks_steady || is_sine {
            let tone = Tone {
                frequency_hz: mode.frequency_hz,
                width_hz,
                kurtosis,
            };
            taken.push(RemovedPeak {
                prominence_db,
                tone,
                is_machine: is_steady || is_sine,
                damping_ratio_least,
            });
            let refusal = match is_steady || is_sine {
                true => Refusal::Machine,
                false => Refusal::Narrow {
                    least: damping_ratio_least,
                },
            };
            set_aside.push(Candidate {
                mode,
                refusal: Some(refusal),
            });
        } else {
            peaks.modes.modes.push(mode);
            peaks.spectrum.half_power_width_hz.push(width_hz);
            peaks.spectrum.prominence_db.push(prominence_db);
        }
    }
    let line_hz = peaks.spectrum.frequency_hz.get(1).copied().unwrap_or(0.0);
    let taken = strongest(taken, SKIRT_LINES * line_hz);
    let tones_hz = taken.iter().map(|of| of.tone.frequency_hz).collect();
    let (machines, narrow): (Vec<RemovedPeak>, Vec<RemovedPeak>) =
        taken.into_iter().partition(|of| of.is_machine);
    let widest = |most: f64, of: &RemovedPeak| most.max(of.damping_ratio_least);
    let damping_ratio_least = narrow.iter().fold(0.0, widest);
    let tones = |of: Vec<RemovedPeak>| -> Vec<Tone> { of.into_iter().map(|of| of.tone).collect() };
    note_spells(spells, notes);
    if !machines.is_empty() {
        notes.push(Note::Tones {
            tones: tones(machines),
        });
    }
    if !narrow.is_empty() {
        notes.push(Note::Narrow {
            peaks: tones(narrow),
            damping_ratio_least,
        });
    }
    Ok(SetAside {
        tones_hz,
        peaks: set_aside,
    })
}

struct RemovedPeak {
    prominence_db: f64,
    tone: Tone,
    is_machine: bool,
    /// Least damping ratio of a mode, if the peak is narrower than that.
    damping_ratio_least: f64,
}

/// Names the sines at modes and at unexplained peaks of the spectrum where a mode remains without the sine. A mode of which nothing remains, or whose
/// amplitude is as steady as that of a sine, is a machine and left out.
pub(crate) fn note_tones_on_modes(
    (record, options): (&Record, &Identify),
    (modes, peaks): (&mut Modes, &Modes),
    notes: &mut Vec<Note>,
) {
    if modes.channels.len() != record.channels().len() || modes.method == Method::Era {
        return;
    }
    let mut lines = FineLines::new(record);
    let mut independent = FineLines::independent(record);
    let line_hz = 1.0 / record.duration_s();
    let far_hz = 0.5 * line_hz;
    let unexplained = peaks.modes.iter().filter(|peak| !explained(peak, &modes.modes));
    let (mut tones, mut machines): (Vec<ToneOnMode>, Vec<Tone>) = (Vec::new(), Vec::new());
    let mut left_out_hz = Vec::new();
    let each = modes.modes.iter().map(|mode| (mode, false));
    for (mode, is_peak) in each.chain(unexplained.map(|peak| (peak, true))) {
        let nearest_hz = to_nearest_hz(mode, &modes.modes);
        let by_phase = independent.sine_on(mode, nearest_hz, is_peak);
        let by_power = || lines.test(mode).filter(LineTest::is_sine);
        let mut in_half = || independent.sine_in_half(mode, nearest_hz).filter(|_| !is_peak);
        let Some(line) = by_phase.or_else(by_power).or_else(&mut in_half) else {
            continue;
        };
        // a sine can take the width of its mode
        let damping_ratio = mode.damping_ratio.unwrap_or(0.0).max(line.damping_ratio);
        let within_hz = far_hz + 1.5 * damping_ratio * mode.frequency_hz;
        let is_here = (line.frequency_hz - mode.frequency_hz).abs() <= within_hz;
        let mut left = None;
        if !line.mode_remains && shows_light(options, mode, record) {
            left = independent.left_by(&line, mode, is_peak);
        }
        let stands_alone = left.is_some_and(|left| left < LEAVES_MOST);
        let is_on_it = line.mode_remains && line.strength <= STRENGTH_MOST
            || left.is_some() && !is_peak && !is_steady(mode);
        if is_here && is_on_it && !stands_alone {
            tones.push(ToneOnMode {
                frequency_hz: line.frequency_hz,
                mode_hz: mode.frequency_hz,
                strength: line.strength,
            });
        } else if mode.is_found() && (stands_alone || is_here && is_steady(mode)) {
            if !is_peak {
                left_out_hz.push(mode.frequency_hz);
            }
            machines.push(Tone {
                frequency_hz: line.frequency_hz,
                width_hz: 2.0 * mode.damping_ratio.unwrap_or(0.0) * mode.frequency_hz,
                kurtosis: mode.kurtosis,
            });
        }
    }
    modes
        .modes
        .retain(|mode| !left_out_hz.contains(&mode.frequency_hz));
    note_machines(machines, 2.0 * line_hz, notes);
    if !tones.is_empty() {
        tones.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
        for mode in &mut modes.modes {
            let own = tones.iter().find(|tone| tone.mode_hz == mode.frequency_hz);
            if own.is_some_and(|tone| takes_width(mode, tone)) {
                (mode.damping_ratio, mode.damping_ratio_sd) = (None, None);
            }
        }
        notes.push(Note::TonesOnModes { tones });
    }
}

/// Adds a note with the machines that no earlier note names. They are no narrow peaks of an unknown cause.
fn note_machines(mut machines: Vec<Tone>, apart_hz: f64, notes: &mut Vec<Note>) {
    for note in &mut *notes {
        if let Note::Narrow { peaks, .. } = note {
            peaks.retain(|of| {
                let is_one = |own: &Tone| (own.frequency_hz - of.frequency_hz).abs() <= apart_hz;
                !machines.iter().any(is_one)
            });
        }
    }
    notes.retain(|note| !matches!(note, Note::Narrow { peaks, .. } if peaks.is_empty()));
    let named = notes.iter().flat_map(|note| match note {
        Note::Tones { tones } => &tones[..],
        _ => &[],
    });
    let named_hz: Vec<f64> = named.map(|tone| tone.frequency_hz).collect();
    machines.retain(|own| {
        let is_own = |hz: &f64| (hz - own.frequency_hz).abs() <= apart_hz;
        !named_hz.iter().any(is_own)
    });
    if !machines.is_empty() {
        notes.push(Note::Tones { tones: machines });
    }
}

/// Distance to the nearest other mode, Hz; infinite if there is none.
fn to_nearest_hz(mode: &Mode, modes: &[Mode]) -> f64 {
    let apart = modes.iter().map(|of| (of.frequency_hz - mode.frequency_hz).abs());
    apart.filter(|apart| *apart > 0.0).fold(f64::INFINITY, f64::min)
}

fn is_steady(mode: &Mode) -> bool {
    mode.kurtosis.is_some_and(|of| of.kurtosis < STEADY_MOST)
}

/// Whether a mode with the least damping ratio would be at least a line wide: a narrower one looks like a sine.
fn shows_light(options: &Identify, mode: &Mode, record: &Record) -> bool {
    let least = options.criteria.damping_ratio_least.unwrap_or(USUAL_LEAST);
    least.min(USUAL_LEAST) * mode.frequency_hz * record.duration_s() >= 1.0
}

/// Whether a sine makes the damping ratio of its mode too low by more than the 95 % interval: the ratio is about that of a motion of which the share
/// 1/(1 + strength) decays.
fn takes_width(mode: &Mode, tone: &ToneOnMode) -> bool {
    const INTERVAL: f64 = 1.96;
    let relative = mode
        .damping_ratio_sd
        .zip(mode.damping_ratio)
        .map(|(sd, zeta)| sd / zeta);
    relative.is_none_or(|sd| tone.strength / (1.0 + tone.strength) > INTERVAL * sd)
}

/// Lines on each side of a tone in which leakage causes small peaks.
const SKIRT_LINES: f64 = 20.0;

/// The tones, by frequency, without those that are within `skirt_hz` of a stronger tone.
fn strongest(mut tones: Vec<RemovedPeak>, skirt_hz: f64) -> Vec<RemovedPeak> {
    tones.sort_by(|a, b| b.prominence_db.total_cmp(&a.prominence_db));
    let mut kept: Vec<RemovedPeak> = Vec::new();
    for of in tones {
        let beside = |k: &RemovedPeak| (k.tone.frequency_hz - of.tone.frequency_hz).abs() <= skirt_hz;
        if !kept.iter().any(beside) {
            kept.push(of);
        }
    }
    kept.sort_by(|a, b| a.tone.frequency_hz.total_cmp(&b.tone.frequency_hz));
    kept
}

/// Whether the motion is too steady for a mode as narrow as its peak.
fn is_steady_at(record: &Record, peak: &Mode, damped: [f64; 2]) -> Result<bool, ModalError> {
    Ok(kurtosis(record, peak, follows_itself(damped))?.is_some_and(|k| k.harmonic()))
}

/// Damping ratio for the correlation time of the motion of a mode: half of the found value, but at least the least damping ratio. Our choice.
fn follows_itself([least, found]: [f64; 2]) -> f64 {
    (0.5 * found).min(USUAL_LEAST).max(least)
}

/// Kurtosis near a mode at the sensors with its largest motion.
fn kurtosis(record: &Record, mode: &Mode, damping_ratio_least: f64) -> Result<Option<Kurtosis>, ModalError> {
    let channels = seeing_most(mode);
    if mode.frequency_hz < 0.5 * record.sampling_rate_hz() {
        band_kurtosis(record, &channels, mode.frequency_hz, damping_ratio_least)
    } else {
        Ok(None)
    }
}

/// Adds to each mode the kurtosis of its band and its variation (the least and the most extreme over all records). Names or removes modes that
/// are too steady, or that vary in a way impossible under random forces. The components of the shapes belong to the channels of each record.
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
            let least = options
                .criteria
                .damping_least_at(mode.frequency_hz, record.duration_s());
            let damped = [least, mode.damping_ratio.unwrap_or(least)];
            let found = kurtosis(record, &seen, follows_itself(damped))?;
            let least = [mode.kurtosis, found].into_iter().flatten();
            mode.kurtosis = least.min_by(|a, b| a.kurtosis.total_cmp(&b.kurtosis));
            let found = wander(record, &seeing_most(&seen), mode.frequency_hz)?;
            let both = [mode.wander, found].into_iter().flatten();
            mode.wander = both.max_by(|a, b| a.beyond().total_cmp(&b.beyond()));
        }
        steady.extend(mode.kurtosis.filter(Kurtosis::harmonic));
    }
    let removed = options.harmonics == Harmonics::Remove;
    if !steady.is_empty() {
        notes.push(Note::Harmonics { steady, removed });
    }
    note_wandering(options, modes, notes);
    if removed {
        modes.modes.retain(|mode| !mode.harmonic());
    }
    leave_out_steady_light(options, modes, notes);
    Ok(())
}

/// Leaves out modes that are steadier than random motion by one standard deviation of the kurtosis. For modes that poles alone do not decide: the
/// motion must look random, not only possibly random. Our choice.
pub(crate) fn leave_out_steadier(
    (record, options): (&Record, &Identify),
    modes: &mut Vec<Mode>,
) -> Result<(), ModalError> {
    let mut left = Vec::with_capacity(modes.len());
    for mode in modes.drain(..) {
        let least = options
            .criteria
            .damping_least_at(mode.frequency_hz, record.duration_s());
        let damped = [least, mode.damping_ratio.unwrap_or(least)];
        let found = kurtosis(record, &mode, follows_itself(damped))?;
        if found.is_none_or(|of| of.kurtosis >= GAUSSIAN - of.deviation) {
            left.push(mode);
        }
    }
    *modes = left;
    Ok(())
}

/// Names modes that vary like machines. Modes with as little damping as machines and the lightest structures are left out, unless the user
/// allows them.
fn note_wandering(options: &Identify, modes: &mut Modes, notes: &mut Vec<Note>) {
    let admitted = options.criteria.damping_ratio_least.is_some();
    let is_left_out = |mode: &Mode| {
        let is_light = mode.damping_ratio.is_some_and(|zeta| zeta < USUAL_LEAST);
        mode.wanders() && (options.harmonics == Harmonics::Remove || is_light && !admitted)
    };
    for removed in [true, false] {
        let here = modes
            .modes
            .iter()
            .filter(|mode| mode.wanders() && is_left_out(mode) == removed);
        let machines: Vec<Wander> = here.filter_map(|mode| mode.wander).collect();
        if !machines.is_empty() {
            notes.push(Note::Wandering { machines, removed });
        }
    }
    modes.modes.retain(|mode| !is_left_out(mode));
}

/// The reason for a mode that was removed because its amplitude is too steady.
pub(crate) fn of_steady(mode: &Mode) -> Refusal {
    match mode.harmonic() {
        true => Refusal::Machine,
        false => Refusal::Narrow { least: USUAL_LEAST },
    }
}

/// Leaves out modes with as little damping as machines and the lightest structures, if their amplitude is as steady as that of a machine, even
/// with few independent amplitudes. The user can allow such modes.
fn leave_out_steady_light(options: &Identify, modes: &mut Modes, notes: &mut Vec<Note>) {
    if options.criteria.damping_ratio_least.is_some() {
        return;
    }
    let mut peaks: Vec<Tone> = Vec::new();
    modes.modes.retain(|mode| {
        let light = mode.damping_ratio.filter(|zeta| *zeta < USUAL_LEAST);
        let steady = mode.kurtosis.filter(|of| of.kurtosis < STEADY_MOST);
        let (Some(zeta), Some(_)) = (light, steady) else {
            return true;
        };
        peaks.push(Tone {
            frequency_hz: mode.frequency_hz,
            width_hz: 2.0 * zeta * mode.frequency_hz,
            kurtosis: mode.kurtosis,
        });
        false
    });
    if !peaks.is_empty() {
        notes.push(Note::Narrow {
            peaks,
            damping_ratio_least: USUAL_LEAST,
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::{MadeMode, MadeRecord};
    use std::f64::consts::PI;

    #[test]
    fn holds_a_sine_alone_is_left_out_and_a_mode_under_a_sine_stays() {
        let (shape, sine_hz) = ([1.0, -0.6], 6.2);
        let made = MadeRecord {
            modes: vec![MadeMode {
                frequency_hz: 2.3,
                damping_ratio: 0.012,
                shape: vec![0.5, 1.0],
            }],
            duration_s: 600.0,
            seed: 3,
            ..MadeRecord::default()
        };
        let record = made.make().unwrap();
        let rate_hz = record.sampling_rate_hz();
        let with_sine = |at_hz: f64| -> Record {
            let samples = shape.iter().enumerate().map(|(c, share)| {
                let size = 0.2 * record.mean_square(c).sqrt();
                let of =
                    |(t, y): (usize, &f64)| y + size * share * (2.0 * PI * at_hz * t as f64 / rate_hz).sin();
                record.samples(c).iter().enumerate().map(of).collect()
            });
            Record::new(record.channels().to_vec(), samples.collect(), rate_hz).unwrap()
        };
        let left = |record: &Record, mode: Mode| -> usize {
            let found = |modes| Modes {
                modes,
                channels: record.channels().to_vec(),
                method: Method::SsiCov,
                duration_s: record.duration_s(),
                history: Vec::new(),
            };
            let mut modes = found(vec![mode]);
            let options = Identify::default();
            note_tones_on_modes(
                (record, &options),
                (&mut modes, &found(Vec::new())),
                &mut Vec::new(),
            );
            modes.modes.len()
        };
        // 7 lines wide, if it were a mode; the kurtosis is not known
        let false_mode = Mode::made(sine_hz, 0.002, &shape);
        assert_eq!(left(&with_sine(sine_hz), false_mode.clone()), 0);
        assert_eq!(left(&record, false_mode), 1);
        assert_eq!(left(&with_sine(2.31), Mode::made(2.3, 0.012, &[0.5, 1.0])), 1);
    }
}
