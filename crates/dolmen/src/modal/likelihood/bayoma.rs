//! Frequencies and damping ratios with the accuracy that the record allows: modes of a subspace method, fitted to the nearby Fourier lines.

use super::band_fit::{BandFit, fit};
use super::band_lines::{BandLines, DEVIATIONS_MOST, Fitted, Lines, bands_of};
use super::band_motion::Oscillator;
use crate::modal::Note;
use crate::modal::modes::Mode;
use crate::modal::quality::explained;
use crate::modal::settings::Settings;
use crate::modal::spectrum::FddResult;
use crate::modal::subspace::Criteria;
use crate::signal::Record;
use dolmen_linalg::ComplexMatrix;

/// Number of iterations with the contributions of other bands: after three nothing changes.
const ROUNDS: usize = 3;
/// Largest misfit, in standard deviations. It is between -2.3 and 2 for records simulated with the model (one of 130 at 4), and above 10 with
/// an undetected mode in the band.
const MISFIT_MOST: f64 = 4.0;

struct Refined {
    /// By frequency.
    modes: Vec<Mode>,
    /// Frequencies of modes found from peaks, Hz.
    from_peaks_hz: Vec<f64>,
    /// Frequencies of modes that were left unchanged, Hz.
    left_hz: Vec<f64>,
}

struct Refine<'a> {
    /// Range in which modes are accepted, Hz.
    range_hz: [f64; 2],
    /// Criteria for damping ratios of modes.
    criteria: &'a Criteria,
    /// Frequencies of machines, whose lines are removed, Hz.
    tones_hz: &'a [f64],
    /// Number of blocks of time, as in the subspace methods: each change of a frequency belongs to one block.
    time_blocks: usize,
}

/// Starting point of a fit.
#[derive(Clone, Copy, PartialEq)]
enum Source {
    /// A mode.
    Mode,
    /// A peak of the spectrum that no mode explains.
    Peak,
}

/// Fits all modes, and unexplained peaks of the spectrum with their widths, Hz. A peak that fits becomes a mode.
fn refine(record: &Record, mut modes: Vec<Mode>, peaks: &[(&Mode, f64)], how: &Refine<'_>) -> Refined {
    let mut candidates: Vec<Mode> = peaks
        .iter()
        .map(|(peak, width_hz)| candidate(peak, *width_hz))
        .collect();
    loop {
        let of_modes = modes.iter().zip(std::iter::repeat(Source::Mode));
        let of_peaks = candidates.iter().zip(std::iter::repeat(Source::Peak));
        let mut all: Vec<(&Mode, Source)> = of_modes.chain(of_peaks).collect();
        all.sort_by(|a, b| a.0.frequency_hz.total_cmp(&b.0.frequency_hz));
        let (with, sources): (Vec<Mode>, Vec<Source>) = all
            .into_iter()
            .map(|(mode, source)| (mode.clone(), source))
            .unzip();
        let answers = fit_all(record, &with, how);
        let damped = |o: &Oscillator| {
            let least = how
                .criteria
                .damping_estimate_least_at(o.frequency_hz, record.duration_s());
            (least..=how.criteria.damping_ratio_most).contains(&o.damping_ratio)
        };
        let fits = |answer: &Option<Fitted>| answer.as_ref().is_some_and(|to| damped(&to.oscillator));
        let none: Vec<f64> = (0..with.len())
            .filter(|&i| sources[i] == Source::Peak && !fits(&answers[i]))
            .map(|i| with[i].frequency_hz)
            .collect();
        if !none.is_empty() {
            candidates.retain(|c| !none.contains(&c.frequency_hz));
            continue;
        }
        let (mut from_peaks_hz, mut left_hz) = (Vec::new(), Vec::new());
        modes.clear();
        for ((mut mode, answer), source) in with.into_iter().zip(answers).zip(sources) {
            match answer {
                Some(answer) => answer.put(&mut mode),
                None => left_hz.push(mode.frequency_hz),
            }
            if source == Source::Peak {
                from_peaks_hz.push(mode.frequency_hz);
            }
            modes.push(mode);
        }
        return Refined {
            modes,
            from_peaks_hz,
            left_hz,
        };
    }
}

/// The modes fitted to their lines, and the unexplained peaks that fit.
pub(crate) fn refined(
    record: &Record,
    modes: Vec<Mode>,
    (peaks, tones_hz): (&FddResult, &[f64]),
    (settings, criteria): (&Settings, &Criteria),
    notes: &mut Vec<Note>,
) -> Vec<Mode> {
    let [low, high] = settings.range_hz;
    let width_hz = peaks.spectrum.half_power_width_hz.iter().copied();
    let alone = |(peak, _): &(&Mode, f64)| {
        !explained(peak, &modes) && peak.frequency_hz > low && peak.frequency_hz < high
    };
    let without: Vec<(&Mode, f64)> = peaks.modes.modes.iter().zip(width_hz).filter(alone).collect();
    let how = Refine {
        range_hz: settings.range_hz,
        criteria,
        tones_hz,
        time_blocks: settings.time_blocks,
    };
    let refined = refine(record, modes.clone(), &without, &how);
    if !refined.from_peaks_hz.is_empty() {
        notes.push(Note::FromPeaks {
            frequency_hz: refined.from_peaks_hz,
        });
    }
    if !refined.left_hz.is_empty() {
        notes.push(Note::NotFitted {
            frequency_hz: refined.left_hz,
        });
    }
    refined.modes
}

/// A peak as a mode with a large uncertainty: its half-power width.
fn candidate(peak: &Mode, width_hz: f64) -> Mode {
    const DAMPING_RANGE: [f64; 2] = [0.003, 0.05];
    let damping_ratio = (0.5 * width_hz / peak.frequency_hz).clamp(DAMPING_RANGE[0], DAMPING_RANGE[1]);
    Mode {
        frequency_sd_hz: Some(damping_ratio * peak.frequency_hz / DEVIATIONS_MOST),
        damping_ratio: Some(damping_ratio),
        damping_ratio_sd: Some(damping_ratio),
        ..peak.clone()
    }
}

/// The modes of all bands, by frequency; `None` for the modes of a band that does not fit.
fn fit_all(record: &Record, modes: &[Mode], how: &Refine<'_>) -> Vec<Option<Fitted>> {
    let lines = Lines::of(record);
    let mut bands = bands_of(modes, how.range_hz, &lines);
    lines.fill(record, &mut bands);
    for band in &mut bands {
        band.look_along_shapes();
        band.gather(&lines, how.tones_hz);
    }
    let fitted = |band: &BandLines, before: Option<&BandFit>| {
        let start = before
            .map(|fit| fit.band.clone())
            .or_else(|| band.start(&lines))?;
        let found = fit(&band.cells, start, lines.recorded)?;
        band.are_the_same(&found, modes).then_some(found)
    };
    let mut fits: Vec<Option<BandFit>> = bands.iter().map(|band| fitted(band, None)).collect();
    for _ in 0..ROUNDS {
        let with_shapes = |(band, fit): (&BandLines, &Option<BandFit>)| {
            let fit = fit.clone()?;
            let shapes = band.shapes_found(&fit);
            Some((fit, shapes))
        };
        let found: Vec<Option<(BandFit, ComplexMatrix)>> = bands.iter().zip(&fits).map(with_shapes).collect();
        for (b, band) in bands.iter_mut().enumerate() {
            let others = found.iter().enumerate().filter(|(other, _)| *other != b);
            band.see_others(others.filter_map(|(_, found)| found.as_ref()));
        }
        fits = bands
            .iter()
            .zip(&fits)
            .map(|(band, fit)| fitted(band, fit.as_ref()))
            .collect();
    }
    let answers = |(band, fit): (&BandLines, Option<BandFit>)| {
        let fit = fit?;
        let fits = fit.misfit(&band.cells)? <= MISFIT_MOST;
        fits.then(|| band.answers(&fit, how.time_blocks))?
    };
    let mut all = Vec::with_capacity(modes.len());
    for (band, fit) in bands.iter().zip(fits) {
        match answers((band, fit)) {
            Some(found) => all.extend(found.into_iter().map(Some)),
            None => all.extend(band.modes.clone().map(|_| None)),
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::{Refine, refine};
    use crate::modal::{
        Criteria, Fate, Identify, MadeMode, MadeRecord, Method, ModalAnalysis, Note, ReferenceCase, identify,
    };
    use crate::signal::{Quantity, Record};

    fn by(method: Method, record: &Record) -> ModalAnalysis {
        let options = Identify {
            method,
            ..Identify::default()
        };
        identify(record, &options).unwrap()
    }

    #[test]
    fn holds_lines_know_frequencies_better_than_correlations() {
        // both methods use the same 24 records, with two modes each
        let truth = ReferenceCase::ShearChain.made(0).unwrap();
        let mut squares = [0.0; 2];
        for seed in 500..524 {
            let record = ReferenceCase::ShearChain.made(seed).unwrap().make().unwrap();
            for (square, method) in squares.iter_mut().zip([Method::Bayoma, Method::SsiCov]) {
                let found = by(method, &record).modes.modes;
                assert_eq!(found.len(), 2);
                for (mode, truth) in found.iter().zip(&truth.modes) {
                    let floor_hz = truth.frequency_hz
                        * (truth.damping_ratio / (std::f64::consts::TAU * truth.frequency_hz * 600.0)).sqrt();
                    *square += ((mode.frequency_hz - truth.frequency_hz) / floor_hz).powi(2) / 48.0;
                    let off = (mode.frequency_hz - truth.frequency_hz) / mode.frequency_sd_hz.unwrap();
                    assert!(off.abs() < 4.0, "{method:?} {seed} {off}");
                    let changes: f64 = mode.frequency_changes_hz.iter().map(|d| d * d).sum();
                    let between_orders = mode.frequency_sd_hz.unwrap().powi(2) - changes;
                    assert!(between_orders > -1e-9 * changes);
                }
            }
        }
        let [lines, correlations] = squares.map(f64::sqrt);
        assert!(lines < 1.25 && correlations > lines, "{lines} {correlations}");
    }

    #[test]
    fn holds_a_mode_in_whose_band_another_moves_unseen_stays_as_it_was_found() {
        let mode = |frequency_hz, shape: [f64; 2]| MadeMode {
            frequency_hz,
            damping_ratio: 0.02,
            shape: shape.to_vec(),
        };
        let made = MadeRecord {
            modes: vec![
                mode(1.1, [0.5, 1.0]),
                mode(1.3, [0.6, 0.9]),
                mode(4.2, [1.0, -0.5]),
            ],
            seed: 5,
            ..MadeRecord::default()
        };
        let record = made.make().unwrap();
        let found = by(Method::SsiCov, &record);
        assert_eq!(found.modes.modes.len(), 3);
        let how = Refine {
            range_hz: [0.3, 8.0],
            criteria: &Criteria::default(),
            tones_hz: &[],
            time_blocks: 30,
        };
        let whole = refine(&record, found.modes.modes.clone(), &[], &how);
        assert!(whole.left_hz.is_empty(), "{:?}", whole.left_hz);
        let mut less = found.modes.modes;
        let unseen = less.remove(1);
        let before = less[0].clone();
        let refined = refine(&record, less.clone(), &[], &how);
        assert_eq!(
            (refined.left_hz, &refined.modes[0]),
            (vec![before.frequency_hz], &before)
        );
        // if its peak is known, the mode is found again
        let refined = refine(&record, less, &[(&unseen, 0.05)], &how);
        assert_eq!(refined.modes.len(), 3, "{:?}", refined.left_hz);
        for (again, whole) in refined.modes.iter().zip(&whole.modes) {
            let sd_hz = whole.frequency_sd_hz.unwrap();
            assert!(
                (again.frequency_hz - whole.frequency_hz).abs() < 0.2 * sd_hz,
                "{again:?} {whole:?}"
            );
        }
    }

    #[test]
    fn holds_a_mode_that_high_orders_split_is_found_at_its_peak() {
        let record = ReferenceCase::ShearChain.made(47).unwrap().make().unwrap();
        let poles = by(Method::SsiCov, &record);
        let whole = poles.clusters.iter().filter(|c| c.fate == Fate::Mode);
        assert_eq!((whole.count(), poles.modes.modes.len()), (1, 2));
        let found = by(Method::Bayoma, &record);
        assert_eq!(found.modes.modes.len(), 2);
        let second = &found.modes.modes[1];
        let sd_hz = second.frequency_sd_hz.unwrap();
        assert!((second.frequency_hz - 4.2).abs() < 3.0 * sd_hz, "{second:?}");
        let told = |note: &&Note| matches!(note, Note::FromPeaks { .. });
        assert_eq!(found.notes.iter().filter(told).count(), 1);
    }

    #[test]
    fn holds_the_quantity_that_is_measured_makes_no_difference() {
        let mode = |frequency_hz, shape: [f64; 2]| MadeMode {
            frequency_hz,
            damping_ratio: 0.02,
            shape: shape.to_vec(),
        };
        let of = |quantity| {
            let made = MadeRecord {
                modes: vec![mode(1.1, [0.5, 1.0]), mode(2.4, [1.0, -0.5])],
                noise_ratio: 1e-3,
                quantity,
                seed: 7,
                ..MadeRecord::default()
            };
            made.make().unwrap()
        };
        let acceleration = of(Quantity::Acceleration);
        let known = by(Method::Bayoma, &acceleration).modes.modes;
        let velocity = of(Quantity::Velocity);
        let of_velocity = by(Method::Bayoma, &velocity).modes.modes;
        // one sensor of each quantity
        let channels = vec![acceleration.channels()[0].clone(), velocity.channels()[1].clone()];
        let samples = vec![acceleration.samples(0).to_vec(), velocity.samples(1).to_vec()];
        let mixed = Record::new(channels, samples, 100.0).unwrap();
        let of_both = by(Method::Bayoma, &mixed).modes.modes;
        for found in [of_velocity, of_both] {
            assert_eq!(found.len(), 2);
            for (found, known) in found.iter().zip(&known) {
                let sd_hz = known.frequency_sd_hz.unwrap();
                assert!(
                    (found.frequency_hz - known.frequency_hz).abs() < 0.5 * sd_hz,
                    "{found:?} {known:?}"
                );
                let zeta = [found, known].map(|m| m.damping_ratio.unwrap());
                assert!(
                    (zeta[0] - zeta[1]).abs() < 0.5 * known.damping_ratio_sd.unwrap(),
                    "{zeta:?}"
                );
            }
        }
    }
}
