//! Modes of a free decay, and their dependence on amplitude.

use super::blows::blows;
use super::mode_decay::{Decay, ModeDecay};
use super::not_modes::{is_machine, overtones};
use crate::modal::indicators::largest;
use crate::modal::modal_analysis::{ModalAnalysis, of_peaks};
use crate::modal::options::Identify;
use crate::modal::spectrum::{Fdd, FddResult, SpectralMatrices, peaks_of};
use crate::modal::{AtAmplitude, Decrement, Era, FreeDecay, ModalError, Mode, assurance, decrement, era};
use crate::numeric::quantile;
use crate::signal::{ChannelFault, Record, inspect};

/// Number of samples per spectral line of a decay.
const PARTS: usize = 16;
/// Number of samples below which a spectrum is not an average.
pub(crate) const SHORT: usize = 1024;

/// Modes of a free decay; the spectrum is only for information.
pub(crate) fn of_decay(
    record: &Record,
    options: &Identify,
    peaks: FddResult,
) -> Result<ModalAnalysis, ModalError> {
    refuse_clipped(record)?;
    let blows = blows(record)?;
    if !blows.is_empty() {
        return Err(ModalError::SeveralBlows { times_s: blows });
    }
    let found = era(
        record,
        &Era {
            block_rows: options.block_rows,
            order: options.order_most,
            ..Era::default()
        },
    )?;
    let nyquist_hz = 0.5 * record.sampling_rate_hz();
    let (low_hz, high_hz) = (
        options.frequency_low_hz.unwrap_or(0.0),
        options.frequency_high_hz.unwrap_or(nyquist_hz),
    );
    let mut analysis = of_peaks(peaks, record, options);
    let groups = of_one_mode(&found);
    analysis.modes = found.modes.clone();
    analysis.modes.modes = groups.iter().map(|group| strongest(&found, group)).collect();
    let mut modes = Vec::with_capacity(groups.len());
    for (k, group) in groups.iter().enumerate() {
        let swings = swings(record, &analysis.modes.modes, k, &found.noise)
            .filter(|swings| !beats(group.len(), swings))
            .unwrap_or_default();
        let damping_follows = follows(&swings);
        let mode = &mut analysis.modes.modes[k];
        if damping_follows {
            mode.damping_ratio_sd = None;
        }
        if group.len() > 1 {
            // a single pole that represents several decays decays faster than the mode
            let ratios: Vec<f64> = swings.iter().map(|of| of.damping_ratio).collect();
            mode.damping_ratio = quantile(&ratios, 0.5).ok().or(mode.damping_ratio);
        }
        modes.push(ModeDecay {
            frequency_hz: mode.frequency_hz,
            poles_hz: group.iter().map(|i| found.modes.modes[*i].frequency_hz).collect(),
            over_white: group.iter().map(|i| found.over_white[*i]).fold(1.0, f64::max),
            damping_follows,
            swings,
            overtone: None,
        });
    }
    let energy = |group: &Vec<usize>| group.iter().map(|i| found.energy[*i]).fold(0.0, f64::max);
    let energy: Vec<f64> = groups.iter().map(energy).collect();
    let overtones = overtones(&modes, &analysis.modes.modes, &energy);
    for (mode, overtone) in modes.iter_mut().zip(overtones) {
        mode.overtone = overtone;
    }
    let machines = analysis.modes.modes.iter().filter(|mode| is_machine(mode));
    let machines_hz: Vec<f64> = machines.map(|mode| mode.frequency_hz).collect();
    let within = |frequency_hz: f64| {
        (low_hz..=high_hz).contains(&frequency_hz) && !machines_hz.contains(&frequency_hz)
    };
    modes.retain(|m| within(m.frequency_hz));
    analysis.modes.modes.retain(|m| within(m.frequency_hz));
    analysis.decay = Some(Decay {
        channels: record.channels().len(),
        explained: found.explained,
        left_peaks_hz: peaks_of_rest(record, &found)?,
        modes,
        machines_hz,
    });
    analysis.settings.lines = 0;
    analysis.settings.range_hz = [low_hz, high_hz];
    analysis.settings.block_rows = found.block_rows;
    analysis.settings.order_most = found.order;
    analysis.hankel_singular_values = found.singular_values;
    Ok(analysis)
}

/// Refuses a decay that a sensor or logger clipped, because clipping distorts it.
fn refuse_clipped(record: &Record) -> Result<(), ModalError> {
    let mut last: Option<(usize, String)> = None;
    for fault in inspect(record) {
        let ChannelFault::Clipped { channel, value, .. } = fault else {
            continue;
        };
        let of = record.channels().iter().position(|c| c.name == channel);
        let held = of.and_then(|c| record.samples(c).iter().rposition(|x| *x == value));
        if let Some(at) = held.filter(|at| last.as_ref().is_none_or(|(other, _)| at > other)) {
            last = Some((at, channel));
        }
    }
    match last {
        None => Ok(()),
        Some((at, channel)) => Err(ModalError::ClippedDecay {
            channel,
            until_s: at as f64 / record.sampling_rate_hz(),
            whole_from_s: (at + 2) as f64 / record.sampling_rate_hz(),
        }),
    }
}

/// Peaks of the residual of a decay, Hz; none if it is white.
fn peaks_of_rest(record: &Record, found: &FreeDecay) -> Result<Vec<f64>, ModalError> {
    const ROUNDING: f64 = 1e-6; // of the power: peaks in the residual of an exact decay are only rounding
    if 1.0 - found.explained < ROUNDING {
        return Ok(Vec::new());
    }
    let rest = Record::new(
        record.channels().to_vec(),
        found.rest.clone(),
        record.sampling_rate_hz(),
    )?;
    let peaks = short_spectrum(&rest, &Fdd::default())?;
    Ok(peaks.modes.modes.iter().map(|m| m.frequency_hz).collect())
}

/// Groups poles with the same shape and overlapping half-power bands: if a joint opens or slips, several poles represent one mode.
fn of_one_mode(found: &FreeDecay) -> Vec<Vec<usize>> {
    const ALIKE: f64 = 0.95; // MAC of shapes; distinct modes are rarely so similar, but with one channel always
    let modes = &found.modes.modes;
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for (i, mode) in modes.iter().enumerate() {
        let one = |j: &usize| modes[*j].overlaps(mode) && assurance(&modes[*j].shape, &mode.shape) >= ALIKE;
        let mut joined = vec![i];
        groups.retain(|group| {
            let apart = !group.iter().any(one);
            if !apart {
                joined.extend(group);
            }
            apart
        });
        joined.sort_unstable();
        groups.push(joined);
    }
    groups.sort();
    groups
}

/// The strongest pole of a group. With several poles, its standard deviations do not describe the mode.
fn strongest(found: &FreeDecay, group: &[usize]) -> Mode {
    let of = |best: usize, i: usize| {
        if found.energy[i] > found.energy[best] {
            i
        } else {
            best
        }
    };
    let mode = &found.modes.modes[group.iter().copied().reduce(of).unwrap_or(0)];
    if group.len() == 1 {
        return mode.clone();
    }
    Mode {
        frequency_sd_hz: None,
        frequency_changes_hz: Vec::new(),
        damping_ratio_sd: None,
        ..mode.clone()
    }
}

fn swings(record: &Record, modes: &[Mode], k: usize, noise: &[f64]) -> Option<Vec<AtAmplitude>> {
    const WIDEST: f64 = 0.3; // fraction of the frequency on either side; chosen here
    const FREE: f64 = 0.6; // fraction of the distance to the next mode; chosen here
    let f = modes[k].frequency_hz;
    let others = modes.iter().enumerate().filter(|(i, _)| *i != k);
    let apart_hz = others
        .map(|(_, m)| (m.frequency_hz - f).abs())
        .fold(f64::INFINITY, f64::min);
    let half_hz = (WIDEST * f).min(FREE * apart_hz);
    let high_hz = (f + half_hz).min(0.49 * record.sampling_rate_hz());
    let channel = largest(&modes[k].shape)?;
    let options = Decrement {
        channel,
        band_hz: Some([f - half_hz, high_hz]),
        noise: noise[channel],
        ..Decrement::default()
    };
    decrement(record, &options).ok()
}

/// Whether damping depends on amplitude: the damping ratio of the largest cycles differs from that of later ones significantly, and
/// by more than a fifth.
fn follows(swings: &[AtAmplitude]) -> bool {
    const DEVIATIONS: f64 = 4.0; // chosen here: about ten windows are compared, and their standard deviations come from few swings
    const PART: f64 = 0.2;
    let Some((first, later)) = swings.split_first() else {
        return false;
    };
    // the second window shares half of its cycles with the first
    later.iter().skip(1).any(|at| {
        let apart = (at.damping_ratio - first.damping_ratio).abs();
        apart > DEVIATIONS * at.damping_ratio_sd.hypot(first.damping_ratio_sd)
            && apart > PART * first.damping_ratio.abs()
    })
}

/// Whether the cycles of a group of poles grow with time: then the poles are modes that beat, not one mode that depends on amplitude.
fn beats(poles: usize, swings: &[AtAmplitude]) -> bool {
    poles > 1 && swings.iter().any(|at| at.damping_ratio < 0.0)
}

/// The spectrum of a decay that is too short for averages.
pub(crate) fn short_spectrum(record: &Record, options: &Fdd) -> Result<FddResult, ModalError> {
    const LINES: usize = 64;
    let lines = LINES.max(record.length() / PARTS).min(record.length() / 4);
    peaks_of(record, &SpectralMatrices::of(record, lines)?, options)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::{Method, identify};
    use crate::signal::{Channel, cut, leave_out};
    use std::f64::consts::PI;

    #[test]
    fn holds_a_decay_is_identified_with_its_swings() {
        // a mode whose frequency is 10 % lower in its largest swings: phase 4π (t - 0.5 (1 - e^(-0.2 t)))
        let y = |i: usize| {
            let t = 0.01 * i as f64;
            let u = (-0.2 * t).exp();
            u * (4.0 * PI * (t - 0.5 * (1.0 - u))).sin()
        };
        let record =
            |n: usize| Record::new(vec![Channel::named("y")], vec![(0..n).map(y).collect()], 100.0).unwrap();
        let options = Identify {
            method: Method::Era,
            ..Identify::default()
        };
        let found = identify(&record(1500), &options).unwrap();
        let decay = found.decay.as_ref().unwrap();
        // a single mode, although several poles represent it; it has no standard deviation, which would suggest precision
        assert_eq!(
            (found.modes.modes.len(), decay.modes.len()),
            (1, 1),
            "{:?}",
            decay.modes
        );
        assert!(decay.modes[0].poles_hz.len() > 1 && found.modes.modes[0].frequency_sd_hz.is_none());
        let swings = &decay.modes[0].swings;
        let (first, last) = (swings[0], swings[swings.len() - 1]);
        for at in [first, last] {
            let truth = 2.0 * (1.0 - 0.1 * at.amplitude);
            assert!((at.frequency_hz / truth - 1.0).abs() < 0.01, "{at:?} {truth}");
        }
        assert!(
            last.frequency_hz > 1.04 * first.frequency_hz,
            "{first:?} {last:?}"
        );
        // short decays have a spectrum too, and a given frequency range is respected
        let short = Identify {
            frequency_low_hz: Some(1.0),
            frequency_high_hz: Some(3.0),
            ..options
        };
        let found = identify(&record(600), &short).unwrap();
        assert!(
            found
                .modes
                .modes
                .iter()
                .all(|m| (1.0..3.0).contains(&m.frequency_hz))
        );
        assert!(!found.modes.modes.is_empty() && found.stabilization.poles.is_empty());
    }

    #[test]
    fn refuses_a_decay_with_a_second_blow_or_a_cut_crest() {
        let swing = |t: f64| (-0.12 * t).exp() * (10.0 * t).sin();
        let record = |y: &dyn Fn(f64) -> f64| {
            let samples = (0..2000).map(|i| y(0.01 * f64::from(i))).collect();
            Record::new(vec![Channel::named("y")], vec![samples], 100.0).unwrap()
        };
        let options = Identify {
            method: Method::Era,
            ..Identify::default()
        };
        let said = |y: &dyn Fn(f64) -> f64| identify(&record(y), &options).unwrap_err().to_string();
        let twice = said(&|t| swing(t) + if t > 11.0 { swing(t - 11.0) } else { 0.0 });
        assert!(
            twice.starts_with("the swings grow at once at 11.")
                || twice.starts_with("the swings grow at once at 10.9"),
            "{twice}"
        );
        let cut = said(&|t| swing(t).clamp(-0.6, 0.6));
        assert!(
            cut.starts_with("channel \"y\" is clipped until ")
                && cut.contains("a clipped decay has another shape"),
            "{cut}"
        );
        assert!(identify(&record(&swing), &options).is_ok());
    }

    #[test]
    fn holds_a_clipped_channel_of_a_decay_is_named_and_without_it_or_later_the_modes_are_right() {
        const MODES: [(f64, f64, [f64; 3]); 2] =
            [(2.0, 0.01, [1.0, 0.7, 0.4]), (5.3, 0.015, [0.3, -0.4, 0.2])];
        let y = |c: usize, i: u32| -> f64 {
            let t = 0.01 * f64::from(i);
            let of = MODES.map(|(f, zeta, shape)| {
                let omega = 2.0 * PI * f;
                shape[c] * (-zeta * omega * t).exp() * (omega * (1.0 - zeta * zeta).sqrt() * t).sin()
            });
            let value: f64 = of.iter().sum();
            if c == 1 { value.clamp(-0.5, 0.5) } else { value }
        };
        let samples = (0..3).map(|c| (0..2000).map(|i| y(c, i)).collect());
        let channels = ["a", "b", "c"].map(Channel::named).to_vec();
        let record = Record::new(channels, samples.collect(), 100.0).unwrap();
        let options = Identify {
            method: Method::Era,
            ..Identify::default()
        };
        let ModalError::ClippedDecay {
            channel,
            whole_from_s,
            ..
        } = identify(&record, &options).unwrap_err()
        else {
            panic!("taken as sound")
        };
        assert_eq!(channel, "b");
        let without = leave_out(record.clone(), &["b"]).unwrap();
        let later = cut(record.clone(), whole_from_s, record.duration_s()).unwrap();
        for part in [without, later] {
            let found = identify(&part, &options).unwrap();
            assert_eq!(found.modes.modes.len(), 2);
            for (mode, (f, zeta, _)) in found.modes.modes.iter().zip(MODES) {
                assert!((mode.frequency_hz / f - 1.0).abs() < 1e-6, "{mode:?}");
                assert!(
                    (mode.damping_ratio.unwrap() / zeta - 1.0).abs() < 1e-3,
                    "{mode:?}"
                );
            }
        }
    }

    #[test]
    fn holds_damping_that_follows_its_swings_is_told_from_scatter_and_from_beats() {
        let all = |dampings: [f64; 3], sd: f64| {
            dampings.map(|damping_ratio| AtAmplitude {
                time_s: 1.0,
                amplitude: 1.0,
                frequency_hz: 2.0,
                damping_ratio,
                damping_ratio_sd: sd,
                degrees_of_freedom: 3.0,
            })
        };
        // √2 × 4 standard deviations of 0.1 % are 0.57 %
        assert!(follows(&all([0.010, 0.013, 0.016], 1e-3)));
        assert!(!follows(&all([0.010, 0.013, 0.0155], 1e-3)));
        // a significant difference, but below a fifth; the second window shares half of its swings
        assert!(!follows(&all([0.010, 0.0105, 0.0119], 1e-5)));
        assert!(follows(&all([0.010, 0.0105, 0.0121], 1e-5)));
        assert!(!follows(&all([0.010, 0.030, 0.010], 1e-5)));
        let growing = all([0.010, -0.004, 0.012], 1e-3);
        assert!(beats(2, &growing) && !beats(1, &growing) && !beats(2, &all([0.01; 3], 1e-3)));
    }
}
