//! Distinguishes modes from the effect of footsteps: a mode remains visible while nobody walks.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | Z_sk | `powers` | Fourier sum of window s (Hann, half overlapping) along the shape, k lines above the frequency |
//! | p | | sum of abs(Z_s0)² over windows |
//! | q_l, q_m | `OverSides` | sum of abs(Z_sk)² over windows, median of the lines of a side: of the lower side, and the geometric mean of both |

use super::in_spells::InSpells;
use super::remarks::near;
use crate::modal::Note;
use crate::modal::modes::{Mode, Modes};
use crate::signal::Record;
use std::f64::consts::PI;
use std::ops::RangeInclusive;

/// Lines examined on each side, outside the main lobe.
const BESIDE: RangeInclusive<usize> = 4..=12;
/// Least p/q_l of a mode in quiet times. Chosen on the development seeds of `unkind_modes`: the lowest of 271 modes has 2.7; 36 of 38
/// lines from footsteps have less than 1.7.
const OVER_LOWER: f64 = 2.0;
/// Least p/q_m in quiet times, unless it is at least this share of that in the whole record: on the flank of a strong mode everything exceeds the lower
/// side. On the development seeds of `unkind_modes` none of 3477 modes had both less, with either length of windows, but 13 of 21 lines from footsteps
/// that exceed the lower side had.
const OVER_BOTH: f64 = 1.5;
const UNEVEN: f64 = 0.3;
/// Windows for spells much shorter than the memory of a narrow line, as a share of it. In short windows the strength of a mode varies too.
const SHORT: f64 = 0.125;
/// Least p/q_m in quiet times of what stands at a multiple or a part of a line in spells, as other lines of the same steps do. Our choice.
const STEPS_OVER_BOTH: f64 = 4.0;
/// Multiples of one frequency at which steps have lines, and the largest distance from them, relative to the frequency: steps vary. Our choice.
const STEP_MULTIPLES: usize = 4;
const STEP_WITHIN: f64 = 0.01;

/// Removes modes that are visible only in some periods, and names them. Footsteps and other repeated impacts cause spectral lines that a
/// subspace method takes for modes.
pub(crate) fn leave_out_spells(record: &Record, modes: &mut Modes, notes: &mut Vec<Note>) {
    if modes.channels.len() != record.channels().len() {
        return;
    }
    let mut left: Vec<InSpells> = Vec::new();
    let mut kept: Vec<(Mode, Quiet)> = Vec::new();
    for mode in modes.modes.drain(..) {
        let quiet = Quiet::of(record, &mode);
        match quiet.in_spells() {
            Some(found) => left.push(found.named(&mode)),
            None => kept.push((mode, quiet)),
        }
    }
    let of_notes = notes.iter().flat_map(|note| match note {
        Note::InSpells { modes } => &modes[..],
        _ => &[],
    });
    let steps_hz: Vec<f64> = left.iter().chain(of_notes).map(|of| of.frequency_hz).collect();
    for (mode, quiet) in kept {
        match quiet.of_steps(mode.frequency_hz, &steps_hz) {
            Some(found) => left.push(found.named(&mode)),
            None => modes.modes.push(mode),
        }
    }
    note_spells(left, notes);
}

/// Adds one note with all modes that are visible only in some periods, by frequency.
pub(super) fn note_spells(found: Vec<InSpells>, notes: &mut Vec<Note>) {
    if found.is_empty() {
        return;
    }
    let before = notes
        .iter()
        .position(|note| matches!(note, Note::InSpells { .. }));
    let mut all = match before.map(|at| notes.remove(at)) {
        Some(Note::InSpells { modes }) => modes,
        _ => Vec::new(),
    };
    all.extend(
        found
            .into_iter()
            .filter(|of| {
                let is_told = |told: &InSpells| near(told.frequency_hz, of.frequency_hz);
                !all.iter().any(is_told)
            })
            .collect::<Vec<_>>(),
    );
    all.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
    notes.push(Note::InSpells { modes: all });
}

/// Result for a peak that exceeds its surroundings only in some periods.
///
/// # Limits
/// A mode that is visible only while something passes, and otherwise hidden by noise, is classified as visible only in some periods.
pub(super) fn in_spells(record: &Record, peak: &Mode) -> Option<InSpells> {
    let found = StandsOut::of(record, peak, remembers_s(record, peak))?.in_spells()?;
    Some(found.named(peak))
}

/// The decay time of a mode, 1/(ζf), but at most an eighth of the record, and long enough to separate the lines beside it.
fn remembers_s(record: &Record, mode: &Mode) -> f64 {
    const WINDOWS_LEAST: usize = 15;
    let decays_s = mode
        .damping_ratio
        .map_or(0.0, |zeta| 1.0 / (zeta * mode.frequency_hz));
    let longest_s = 2.0 * record.duration_s() / (WINDOWS_LEAST + 1) as f64;
    decays_s.max(separates_s(mode)).min(longest_s)
}

fn separates_s(mode: &Mode) -> f64 {
    2.0 * *BESIDE.end() as f64 / mode.frequency_hz
}

/// How a mode exceeds its surroundings in windows as long as its decay time, and in short ones.
struct Quiet {
    own: Option<StandsOut>,
    short: Option<StandsOut>,
}

/// p/q_l and p/q_m.
#[derive(Clone, Copy)]
struct StandsOut {
    over_lower: OverSides,
    over_both: OverSides,
}

/// p/q in the whole record, and in its quiet parts.
///
/// ```text
/// quiet: the least of p/q   in the half of the windows in which the structure moves least,
///                           of each line in the half in which it is weakest (spells much shorter than the record), and
///                           in the third whose neighbours, two windows before and after, are weakest at this line (spells as long as the rest)
/// ```
#[derive(Clone, Copy)]
struct OverSides {
    whole: f64,
    quiet: f64,
}

impl Quiet {
    fn of(record: &Record, mode: &Mode) -> Quiet {
        let own_s = remembers_s(record, mode);
        let short_s = (SHORT * own_s).max(separates_s(mode));
        let of = |length_s: f64| StandsOut::of(record, mode, length_s);
        Quiet {
            own: of(own_s),
            short: (short_s < own_s).then(|| of(short_s)).flatten(),
        }
    }

    /// What shows that the mode is visible only in some periods.
    fn in_spells(&self) -> Option<OverSides> {
        let own = self.own.and_then(|of| of.in_spells());
        own.or_else(|| self.short?.uneven(OVER_BOTH))
    }

    /// What shows that the mode is a line of the steps that have other lines at `steps_hz`.
    fn of_steps(&self, mode_hz: f64, steps_hz: &[f64]) -> Option<OverSides> {
        if !steps_hz.iter().any(|of| are_of_one(mode_hz, *of)) {
            return None;
        }
        let both = self.own.into_iter().chain(self.short);
        both.filter_map(|of| of.uneven(STEPS_OVER_BOTH)).next()
    }
}

impl StandsOut {
    /// `None` if the record is too short, or if the lines are outside its frequency band.
    fn of(record: &Record, mode: &Mode, length_s: f64) -> Option<StandsOut> {
        let lines = Lines::of(record, mode, length_s)?;
        let windows = lines.strengths.len();
        let mut order: Vec<usize> = (0..windows).collect();
        order.sort_by(|a, b| lines.strengths[*a].total_cmp(&lines.strengths[*b]));
        let while_still = lines.stands_out(|powers| order[..windows / 2].iter().map(|s| powers[*s]).sum());
        let beside_weak = {
            let own = &lines.powers[BESIDE.count()];
            let around = |s: usize| {
                let [before, after] = [s.checked_sub(2), Some(s + 2)].map(|at| at.and_then(|at| own.get(at)));
                before.or(after).copied().unwrap_or(0.0) + after.or(before).copied().unwrap_or(0.0)
            };
            order.sort_by(|a, b| around(*a).total_cmp(&around(*b)));
            lines.stands_out(|powers| order[..windows / 3].iter().map(|s| powers[*s]).sum())
        };
        let at_their_weakest = lines.stands_out(|powers| {
            let mut sorted = powers.to_vec();
            sorted.sort_by(f64::total_cmp);
            sorted[..windows / 2].iter().sum()
        });
        let whole = lines.stands_out(|powers| powers.iter().sum());
        let [over_lower, over_both] = [0, 1].map(|side| OverSides {
            whole: whole[side],
            quiet: while_still[side]
                .min(at_their_weakest[side])
                .min(beside_weak[side]),
        });
        Some(StandsOut {
            over_lower,
            over_both,
        })
    }

    fn in_spells(&self) -> Option<OverSides> {
        let hidden = (self.over_lower.quiet < OVER_LOWER).then_some(self.over_lower);
        hidden.or_else(|| self.uneven(OVER_BOTH))
    }

    /// What shows that it exceeds both sides by less than `least` in quiet times, and by far more in the whole record.
    fn uneven(&self, least: f64) -> Option<OverSides> {
        let of = self.over_both;
        (of.quiet < least.min(UNEVEN * of.whole)).then_some(of)
    }
}

impl OverSides {
    fn named(&self, mode: &Mode) -> InSpells {
        InSpells {
            frequency_hz: mode.frequency_hz,
            stands_out: self.whole,
            stands_out_quiet: self.quiet,
        }
    }
}

/// Whether two different frequencies are multiples of one.
fn are_of_one(a_hz: f64, b_hz: f64) -> bool {
    let multiples = 1..=STEP_MULTIPLES;
    multiples.clone().any(|m| {
        multiples.clone().any(|n| {
            let ratio = a_hz * n as f64 / (b_hz * m as f64);
            m != n && (ratio - 1.0).abs() < STEP_WITHIN
        })
    })
}

/// Powers of the lines near a mode, window by window.
struct Lines {
    /// Power of all motion along the shape, one per window.
    strengths: Vec<f64>,
    /// Powers in the windows for each line: below the mode, at the mode, and above it.
    powers: Vec<Vec<f64>>,
}

impl Lines {
    fn of(record: &Record, mode: &Mode, length_s: f64) -> Option<Lines> {
        const NYQUIST_SHARE: f64 = 0.96;
        let (rate_hz, n, f) = (record.sampling_rate_hz(), record.length(), mode.frequency_hz);
        let reach = *BESIDE.end() as f64;
        let length = (length_s * rate_hz) as usize;
        let line_hz = rate_hz / length as f64;
        if f < (reach + 2.0) * line_hz || f + reach * line_hz > 0.5 * NYQUIST_SHARE * rate_hz {
            return None;
        }
        let along = along(record, mode);
        let hann = |t: usize| (PI * (t as f64 + 0.5) / length as f64).sin().powi(2);
        let hann: Vec<f64> = (0..length).map(hann).collect();
        let beside = BESIDE.map(|k| k as f64);
        let offsets: Vec<f64> = beside.clone().map(|k| -k).chain([0.0]).chain(beside).collect();
        let mut strengths = Vec::new();
        let mut powers = vec![Vec::new(); offsets.len()];
        for s in 0..(2 * n / length).saturating_sub(1) {
            let from = s * length / 2;
            let part: Vec<f64> = along[from..from + length]
                .iter()
                .zip(&hann)
                .map(|(y, h)| y * h)
                .collect();
            strengths.push(part.iter().map(|y| y * y).sum());
            let at = powers_at(&part, &offsets, |k| (f + k * line_hz) / rate_hz);
            for (powers, power) in powers.iter_mut().zip(at) {
                powers.push(power);
            }
        }
        Some(Lines { strengths, powers })
    }

    /// p/q_l and p/q_m; `of` computes the power of a line from its powers in the windows.
    fn stands_out(&self, of: impl Fn(&[f64]) -> f64) -> [f64; 2] {
        let each: Vec<f64> = self.powers.iter().map(|powers| of(powers)).collect();
        let middle = BESIDE.count();
        let median = |side: &[f64]| {
            let mut sorted = side.to_vec();
            sorted.sort_by(f64::total_cmp);
            sorted[sorted.len() / 2]
        };
        let [below, above] = [&each[..middle], &each[middle + 1..]].map(median);
        [below.min(above), (below * above).sqrt()].map(|beside| each[middle] / beside.max(f64::MIN_POSITIVE))
    }
}

/// The motion along a mode's shape, at the sensors with its largest motion.
fn along(record: &Record, mode: &Mode) -> Vec<f64> {
    const CHANNELS: usize = 4;
    let mut channels: Vec<usize> = (0..mode.shape.len()).collect();
    channels.sort_by(|&a, &b| mode.shape[b].norm().total_cmp(&mode.shape[a].norm()));
    let mut along = vec![0.0; record.length()];
    for &c in channels.iter().take(CHANNELS) {
        let samples = record.samples(c);
        let mean = record.mean(c);
        let weight = mode.shape[c].re;
        along
            .iter_mut()
            .zip(samples)
            .for_each(|(sum, y)| *sum += weight * (y - mean));
    }
    along
}

/// abs(Σ x_t e^(−2πiνt))² by Goertzel's recurrence, ν in cycles per sample, for several lines together.
fn powers_at(x: &[f64], offsets: &[f64], cycles_a_sample: impl Fn(f64) -> f64) -> Vec<f64> {
    const LANES: usize = 24; // three registers of the widest kind: the lines about one mode
    let mut powers = Vec::with_capacity(offsets.len());
    for some in offsets.chunks(LANES) {
        let mut twice_cos = [0.0; LANES];
        for (twice_cos, k) in twice_cos.iter_mut().zip(some) {
            *twice_cos = 2.0 * (2.0 * PI * cycles_a_sample(*k)).cos();
        }
        let (mut last, mut before) = ([0.0; LANES], [0.0; LANES]);
        for x in x {
            for ((last, before), twice_cos) in last.iter_mut().zip(&mut before).zip(&twice_cos) {
                (*last, *before) = (x + twice_cos * *last - *before, *last);
            }
        }
        let ends = last.iter().zip(&before).zip(&twice_cos).take(some.len());
        powers.extend(
            ends.map(|((last, before), twice_cos)| last * last + before * before - twice_cos * last * before),
        );
    }
    powers
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::{MadeMode, MadeRecord, Method};
    use crate::numeric::Random;
    use dolmen_linalg::Complex64;
    use std::ops::Range;

    const MODES: [(f64, f64, [f64; 2]); 2] = [(3.1, 0.01, [1.0, 0.6]), (8.3, 0.008, [-0.7, 1.0])];

    fn mode((frequency_hz, damping_ratio, shape): (f64, f64, [f64; 2])) -> Mode {
        Mode::made(frequency_hz, damping_ratio, &shape)
    }

    /// Two modes, ten minutes, with an additional motion near this frequency at these times and passing vehicles.
    fn record(vehicles: &[f64], (line_hz, runs_s): (f64, Range<f64>)) -> Record {
        let made = MadeRecord {
            modes: MODES
                .map(|(frequency_hz, damping_ratio, shape)| MadeMode {
                    frequency_hz,
                    damping_ratio,
                    shape: shape.to_vec(),
                })
                .to_vec(),
            duration_s: 600.0,
            seed: 11,
            ..MadeRecord::default()
        };
        let kind = made.make().unwrap();
        let rate_hz = kind.sampling_rate_hz();
        let mut random = Random::new(4, 0);
        let samples: Vec<Vec<f64>> = (0..2)
            .map(|c| {
                let spread =
                    (kind.samples(c).iter().map(|y| y * y).sum::<f64>() / kind.length() as f64).sqrt();
                let mut phase = 0.0;
                let each = kind.samples(c).iter().enumerate().map(|(t, y)| {
                    let at_s = t as f64 / rate_hz;
                    phase += 2.0 * PI * line_hz / rate_hz + 0.01 * random.normal();
                    let walks = runs_s.contains(&at_s);
                    let passes = |from_s: &f64| (0.0..8.0).contains(&(at_s - from_s));
                    let gust = if vehicles.iter().any(passes) { 5.0 } else { 1.0 };
                    gust * y
                        + if walks { spread * f64::sin(phase) } else { 0.0 }
                        + 0.1 * spread * random.normal()
                });
                each.collect()
            })
            .collect();
        Record::new(kind.channels().to_vec(), samples, rate_hz).unwrap()
    }

    #[test]
    fn holds_a_line_of_half_a_minute_is_in_spells_and_modes_are_not() {
        for vehicles in [&[][..], &[50.0, 310.0, 480.0]] {
            let record = record(vehicles, (5.5, 200.0..230.0));
            for own in MODES {
                assert_eq!(in_spells(&record, &mode(own)), None, "{vehicles:?}");
            }
            let walked = in_spells(&record, &mode((5.5, 0.004, [0.8, 0.9]))).unwrap();
            assert!(
                walked.stands_out > 5.0 && walked.stands_out_quiet < 1.7,
                "{walked:?}"
            );
        }
    }

    #[test]
    fn holds_it_is_left_out_and_named() {
        let record = record(&[], (5.5, 200.0..230.0));
        let mut all = Modes {
            modes: vec![mode(MODES[0]), mode((5.5, 0.004, [0.8, 0.9])), mode(MODES[1])],
            channels: record.channels().to_vec(),
            method: Method::SsiCov,
            duration_s: 600.0,
            history: Vec::new(),
        };
        let mut notes = Vec::new();
        leave_out_spells(&record, &mut all, &mut notes);
        assert_eq!(all.modes.len(), 2);
        let said = notes[0].to_string();
        assert!(said.contains("while the structure is quiet: 5.500 Hz"), "{said}");
    }

    #[test]
    fn holds_short_windows_show_the_end_of_a_line_that_ran_for_two_thirds_of_the_time() {
        let record = record(&[], (5.5, 0.0..390.0));
        let ran = Quiet::of(&record, &mode((5.5, 0.0019, [0.8, 0.9])));
        assert!(ran.own.unwrap().in_spells().is_none());
        assert!(
            ran.in_spells()
                .is_some_and(|of| of.quiet < 1.7 && of.whole > 20.0)
        );
        for (frequency_hz, _, shape) in MODES {
            // as narrow a mode would be
            let light = Quiet::of(&record, &mode((frequency_hz, 0.0019, shape)));
            assert!(light.in_spells().is_none(), "{frequency_hz}");
        }
    }

    /// Above the mode at 3.1 Hz every line exceeds the upper side.
    #[test]
    fn holds_a_line_on_the_flank_of_a_mode_is_in_spells() {
        let line = mode((3.3, 0.01, [1.0, 0.6]));
        let of = |record: &Record| StandsOut::of(record, &line, remembers_s(record, &line)).unwrap();
        let walks = of(&record(&[], (3.3, 200.0..230.0)));
        assert!(walks.over_lower.quiet > OVER_LOWER);
        let found = walks.in_spells().unwrap();
        assert!(
            found.whole > 3.0 && found.quiet < 1.0,
            "{} {}",
            found.whole,
            found.quiet
        );
        let still = of(&record(&[], (3.3, 0.0..0.0)));
        assert!(still.over_lower.quiet > OVER_LOWER && still.in_spells().is_none());
    }

    #[test]
    fn exact_uneven_lines_at_multiples_of_steps_are_theirs() {
        let quiet = |whole: f64, quiet: f64| Quiet {
            own: Some(StandsOut {
                over_lower: OverSides { whole, quiet },
                over_both: OverSides { whole, quiet },
            }),
            short: None,
        };
        let steps_hz = [4.049, 8.1];
        assert!(quiet(40.6, 3.0).of_steps(2.0219, &steps_hz).is_some());
        assert!(quiet(40.6, 3.0).of_steps(3.04, &steps_hz).is_some()); // 3/4
        // apart from all multiples, or as strong in quiet times
        assert!(quiet(40.6, 3.0).of_steps(2.2, &steps_hz).is_none());
        assert!(quiet(40.6, 30.0).of_steps(2.0219, &steps_hz).is_none());
        assert!(quiet(40.6, 3.0).of_steps(2.0219, &[]).is_none());
    }

    #[test]
    fn exact_powers_of_more_lines_than_stand_side_by_side() {
        let x = [1.0, -2.0, 0.5, 3.0, -1.0];
        let offsets: Vec<f64> = (0..30).map(f64::from).collect();
        let nu = |k: f64| 0.03 + 0.015 * k;
        let found = powers_at(&x, &offsets, nu);
        assert_eq!(found.len(), offsets.len());
        for (power, k) in found.iter().zip(&offsets) {
            let sum: Complex64 = x
                .iter()
                .enumerate()
                .map(|(t, x)| Complex64::from_polar(*x, -2.0 * PI * nu(*k) * t as f64))
                .sum();
            assert!((power / sum.norm_sqr() - 1.0).abs() < 1e-10, "{k} {power}");
        }
    }
}
