//! Detects recorders with a constant delay, and channels that measure another quantity, by the symmetry of correlations.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | φ | | phase of a channel relative to another at a line of the spectrum | rad |
//! | τ | `delay_s` | delay of the channel's clock | s |
//! | J(τ) | `level` | weighted mean of cos 2(φ − 2πfτ) over the lines at crests | – |

use super::crest_phases::{Crests, Turns};
use crate::modal::noted::LateClock;
use crate::modal::{ModalError, Note};
use crate::signal::{Channel, Quantity, Record, cut, leave_out};
use std::f64::consts::TAU;

/// Arrays are tested in parts with this number of channels, in their order. Our choice: the memory of all pairs.
const PART: usize = 48;
/// Fewest coherent lines that tell the phase between two channels. Our choice.
const LINES_LEAST: f64 = 2.0;
/// Largest usual phase in shapes of structures, rad (3°); lightly damped shapes stay below it. Our choice.
const OWN_PHASE: f64 = 3.0 * TAU / 360.0;
/// Largest delay in the search, s. Our choice.
const DELAY_MOST_S: f64 = 2.0;
/// Steps of the search in a period of the highest line.
const STEPS_A_PERIOD: f64 = 32.0;
/// A delay explains the phases from the first level on, if the level without it is below the second, and if it leaves at most a third of what
/// that level lacks. Our choice: simulated delays reach 0.94, clocks that agree 0.96 without one; the pairs of Palisaden, whose modes lie close
/// together, reach 0.76 with the best of all delays and leave 0.4.
const EXPLAINS: f64 = 0.8;
const AS_ONE: f64 = 0.9;
const LEAVES: f64 = 1.0 / 3.0;
/// Level from which all bands but one agree without a delay: that one is then no clock's, but of steps, or of modes that lie close together.
const OTHERS_AS_ONE: f64 = 0.96;
/// Smallest significant delay, and largest difference between the halves of the record, in standard deviations. Our choice.
const DEVIATIONS: f64 = 5.0;
/// Another delay explains the phases too if its level is less than this below the best. Our choice.
const RIVAL: f64 = 0.05;
/// Highest level of a quarter turn: over all lines, and in each band. Our choice: simulated velocities reach −0.9.
const QUARTER: f64 = -0.8;
const QUARTER_EACH: f64 = 0.0;
/// Fewest bands of lines that tell a delay from another phase.
const BANDS_LEAST: usize = 2;

/// What the phases of a channel relative to others show.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Phases {
    /// Nearer to 0 or 180° than to 90°.
    AsOne,
    /// Neither a delay nor 90° explains them.
    Unclear,
    /// 90° in each band.
    QuarterTurn,
    /// A delay.
    Late(Delay),
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Delay {
    delay_s: f64,
    sd_s: f64,
    or_s: Option<f64>,
    bands: usize,
}

/// Channels of a record whose phases contradict those of the others.
#[derive(Clone, Debug, Default)]
pub(crate) struct OffClocks {
    /// Channels whose clock has a delay.
    late: Vec<LateClock>,
    /// Channels with a phase of 90°, and the frequencies at which they have it, Hz.
    turned: Vec<String>,
    turned_hz: Vec<f64>,
    /// Channels of which half are late: it is unknown which half.
    either_late: Vec<(Vec<LateClock>, Vec<String>)>,
    /// Channels of which half measure another quantity: it is unknown which half.
    either_turned: Vec<TurnedHalves>,
}

/// Two halves of the channels with a phase of 90° between them.
#[derive(Clone, Debug)]
struct TurnedHalves {
    halves: [Vec<String>; 2],
    frequency_hz: Vec<f64>,
}

/// Finds channels with a constant delay, and channels with a phase of 90° at every frequency.
///
/// ```text
/// S_ab(f) = Σ_j φ_aj φ_bj |H_j(f)|²        real: modes with real shapes, under forces that differ from mode to mode
/// y_a(t) = x_a(t + τ)   →   arg S_ab = 2πfτ + kπ            a velocity beside an acceleration: arg S_ab = π/2 + kπ
/// ```
/// The correlation of two channels is therefore even in time, about −τ; J(τ) measures how even. Only lines at crests of the spectrum
/// count, because common forces turn the phases between them. Channels that agree with most others have the right clock and quantity. If as
/// many disagree as agree, it is unknown which are wrong.
///
/// # Limits
/// Modes that lie close together under common forces turn phases too: J(0) is −0.03 to 0.83 between the channels of such a building
/// (Palisaden), and a delay of one of them is not found there. A displacement beside accelerations has a phase of 180°, like a reversed sensor.
pub(crate) fn off_clocks(record: &Record) -> OffClocks {
    let mut off = OffClocks::default();
    let names: Vec<&str> = record.channels().iter().map(|c| c.name.as_str()).collect();
    if names.len() <= PART {
        off.add(record);
        return off;
    }
    for part in names.chunks(PART) {
        let others: Vec<&str> = names
            .iter()
            .filter(|name| !part.contains(name))
            .copied()
            .collect();
        if let Ok(part) = leave_out(record.clone(), &others) {
            off.add(&part);
        }
    }
    off
}

impl OffClocks {
    fn add(&mut self, record: &Record) {
        let Some(crests) = Crests::of(record) else {
            return;
        };
        let l = record.channels().len();
        let mut known = vec![vec![None; l]; l];
        for (a, b) in (0..l).flat_map(|a| (0..a).map(move |b| (a, b))) {
            let turns = crests.turns(a, b);
            let phases = (turns.total() >= LINES_LEAST).then(|| phases_of(&turns));
            (known[a][b], known[b][a]) = (phases, phases);
        }
        let mut left: Vec<usize> = (0..l).collect();
        while let Some(&first) = left.first() {
            let together = connected(first, &left, &known);
            left.retain(|c| !together.contains(c));
            self.judge((record, &crests), &together, &known);
        }
    }

    /// Judges channels that are connected by coherent lines.
    fn judge(
        &mut self,
        (record, crests): (&Record, &Crests),
        together: &[usize],
        known: &[Vec<Option<Phases>>],
    ) {
        let agrees = |a: usize, b: usize| a == b || known[a][b] == Some(Phases::AsOne);
        let group =
            |&r: &usize| -> Vec<usize> { together.iter().copied().filter(|&c| agrees(c, r)).collect() };
        let agreeing = together
            .iter()
            .rev()
            .map(group)
            .max_by_key(Vec::len)
            .unwrap_or_default();
        let name = |c: &usize| record.channels()[*c].name.clone();
        let mut late: Vec<LateClock> = Vec::new();
        let (mut turned, mut turned_hz) = (Vec::new(), Vec::new());
        for &c in together.iter().filter(|c| !agreeing.contains(c)) {
            let others: Vec<usize> = agreeing
                .iter()
                .copied()
                .filter(|&r| known[c][r].is_some())
                .collect();
            let turns = crests.turns_against(c, &others);
            match phases_of(&turns) {
                Phases::QuarterTurn => {
                    turned.push(name(&c));
                    turned_hz.extend(turns.bands().iter().map(Turns::middle_hz));
                }
                Phases::Late(delay) if is_constant(record, (c, &others), &delay) => late.push(LateClock {
                    channel: name(&c),
                    delay_s: delay.delay_s,
                    sd_s: delay.sd_s,
                    or_s: delay.or_s,
                    modes: delay.bands,
                }),
                _ => {}
            }
        }
        let others = || -> Vec<String> { agreeing.iter().map(name).collect() };
        if !turned.is_empty() && turned.len() >= agreeing.len() {
            self.either_turned.push(TurnedHalves {
                halves: [turned, others()],
                frequency_hz: turned_hz,
            });
        } else {
            self.turned.extend(turned);
            self.turned_hz.extend(turned_hz);
        }
        if !late.is_empty() && late.len() >= agreeing.len() {
            self.either_late.push((late, others()));
        } else {
            self.late.extend(late);
        }
    }

    /// The record without the channels that are off. Where it is unknown which channels are wrong, all stay: the delay is taken off, or the
    /// first half is taken for the different one. `None` if nothing is off, or nothing would be left.
    ///
    /// # Errors
    /// [`ModalError::Record`].
    pub(crate) fn taken_off(&self, record: &Record) -> Result<Option<Record>, ModalError> {
        let named = self.late.iter().map(|clock| clock.channel.as_str());
        let off: Vec<&str> = named.chain(self.turned.iter().map(String::as_str)).collect();
        let is_known = self.either_late.is_empty() && self.either_turned.is_empty();
        if off.is_empty() && is_known || off.len() >= record.channels().len() {
            return Ok(None);
        }
        let kept = leave_out(record.clone(), &off)?;
        if is_known {
            return Ok(Some(kept));
        }
        let delays: Vec<&LateClock> = self.either_late.iter().flat_map(|(late, _)| late).collect();
        let rate_hz = kept.sampling_rate_hz();
        let steps = |name: &str| {
            let own = delays.iter().find(|clock| clock.channel == name);
            own.map_or(0, |clock| (clock.delay_s * rate_hz).round() as i64)
        };
        let shifts: Vec<i64> = kept.channels().iter().map(|c| steps(&c.name)).collect();
        let most = shifts.iter().copied().max().unwrap_or(0);
        let least = shifts.iter().copied().min().unwrap_or(0);
        let length = kept.length() - (most - least) as usize;
        let samples = shifts.iter().enumerate().map(|(c, shift)| {
            let from = (most - shift) as usize;
            kept.samples(c)[from..from + length].to_vec()
        });
        let mut channels = kept.channels().to_vec();
        for of in &self.either_turned {
            of.set_quantities(&mut channels);
        }
        let mut brought = Record::new(channels, samples.collect(), rate_hz)?;
        kept.history().iter().for_each(|step| brought.note(step.clone()));
        Ok(Some(brought))
    }

    /// The notes that name these channels.
    pub(crate) fn notes(self) -> Vec<Note> {
        let mut notes = Vec::new();
        if !self.turned.is_empty() {
            notes.push(Note::QuarterTurn {
                channels: self.turned,
                frequency_hz: bands_of(self.turned_hz),
            });
        }
        if !self.late.is_empty() {
            notes.push(Note::LateClocks { late: self.late });
        }
        let either = self.either_late.into_iter();
        notes.extend(either.map(|(late, others)| Note::EitherLate { late, others }));
        let either = self.either_turned.into_iter().map(|of| {
            let [channels, others] = of.halves;
            let frequency_hz = bands_of(of.frequency_hz);
            Note::EitherTurned {
                channels,
                others,
                frequency_hz,
            }
        });
        notes.extend(either);
        notes
    }
}

impl TurnedHalves {
    /// Changes the quantities so that the halves differ by one derivative more than before.
    fn set_quantities(&self, channels: &mut [Channel]) {
        let [first, second] = &self.halves;
        let is_here = |c: &Channel| first.contains(&c.name) || second.contains(&c.name);
        let mut here = channels.iter().filter(|c| is_here(c));
        if here.any(|c| c.quantity == Quantity::Unknown) {
            let of_second = channels.iter_mut().filter(|c| second.contains(&c.name));
            of_second.for_each(|c| c.quantity = Quantity::Acceleration);
        }
        for channel in channels.iter_mut().filter(|c| first.contains(&c.name)) {
            channel.quantity = match channel.quantity {
                Quantity::Velocity => Quantity::Acceleration,
                Quantity::Acceleration | Quantity::Displacement | Quantity::Unknown => Quantity::Velocity,
            };
        }
    }
}

/// Bands of different channels with a smaller relative distance are one in the note.
const SAME_BAND: f64 = 0.05;

fn bands_of(mut frequency_hz: Vec<f64>) -> Vec<f64> {
    frequency_hz.sort_by(f64::total_cmp);
    frequency_hz.dedup_by(|b, a| *b < *a * (1.0 + SAME_BAND));
    frequency_hz
}

/// The channels of `left` that coherent lines connect to the first, over others.
fn connected(first: usize, left: &[usize], known: &[Vec<Option<Phases>>]) -> Vec<usize> {
    let mut together = vec![first];
    let mut next = 0;
    while next < together.len() {
        let from = together[next];
        let more = left
            .iter()
            .filter(|&&c| known[from][c].is_some() && !together.contains(&c));
        let more: Vec<usize> = more.copied().collect();
        together.extend(more);
        next += 1;
    }
    together.sort_unstable();
    together
}

fn phases_of(turns: &Turns) -> Phases {
    let at_zero = turns.level(0.0);
    if at_zero > AS_ONE {
        return Phases::AsOne;
    }
    let bands = turns.bands();
    let unexplained = match at_zero >= 0.0 {
        true => Phases::AsOne,
        false => Phases::Unclear,
    };
    if bands.len() < BANDS_LEAST {
        return unexplained;
    }
    let best = delay(turns, &bands);
    let is_quarter = at_zero <= QUARTER && bands.iter().all(|band| band.level(0.0) <= QUARTER_EACH);
    if is_quarter && best.is_none_or(|of| turns.level(of.delay_s) <= RIVAL - at_zero) {
        return Phases::QuarterTurn;
    }
    let explains = |of: &Delay| {
        let level = turns.level(of.delay_s);
        level >= EXPLAINS
            && 1.0 - level <= LEAVES * (1.0 - at_zero)
            && of.delay_s.abs() > DEVIATIONS * of.sd_s
            && !(0..bands.len()).any(|band| level_without(&bands, band) > OTHERS_AS_ONE)
    };
    best.filter(explains).map_or(unexplained, Phases::Late)
}

/// Level without a delay of all bands but one.
fn level_without(bands: &[Turns], left_out: usize) -> f64 {
    let others = bands.iter().enumerate().filter(|(band, _)| *band != left_out);
    let each = others.map(|(_, turns)| [turns.level(0.0) * turns.total(), turns.total()]);
    let [level, total] = each.fold([0.0, 0.0], |[level, total], [own, weight]| {
        [level + own, total + weight]
    });
    level / total
}

/// The delay with the highest level, and the next that is nearly as high.
fn delay(turns: &Turns, bands: &[Turns]) -> Option<Delay> {
    let step_s = 1.0 / (STEPS_A_PERIOD * turns.highest_hz());
    // two bands fit too many delays
    let most_s = match bands {
        [lowest, _] => 0.5 / lowest.middle_hz(),
        _ => DELAY_MOST_S,
    };
    let steps = (most_s / step_s).ceil() as i64;
    let levels = turns.levels(step_s, steps);
    let is_crest = |k: &usize| levels[*k] >= levels[k - 1] && levels[*k] > levels[k + 1];
    let mut crests: Vec<usize> = (1..levels.len() - 1).filter(is_crest).collect();
    crests.sort_by(|a, b| levels[*b].total_cmp(&levels[*a]));
    let at_s = |k: usize| (k as i64 - steps) as f64 * step_s;
    let (&best, rivals) = crests.split_first()?;
    let [delay_s, scatter_s] = settled(turns, at_s(best));
    let levers: f64 = bands.iter().map(|band| (TAU * band.middle_hz()).powi(2)).sum();
    let rival = rivals.first().filter(|k| levels[**k] > levels[best] - RIVAL);
    Some(Delay {
        delay_s,
        sd_s: scatter_s.hypot(OWN_PHASE / levers.sqrt()),
        or_s: rival.map(|&k| at_s(k)),
        bands: bands.len(),
    })
}

/// Whether each half of the record shows the delay: that of a clock which drifts grows. `false` if a half cannot decide.
fn is_constant(record: &Record, (c, others): (usize, &[usize]), whole: &Delay) -> bool {
    let middle_s = 0.5 * record.duration_s();
    let halves = [(0.0, middle_s), (middle_s, record.duration_s())];
    let of = |(from_s, to_s): (f64, f64)| {
        let crests = Crests::of(&cut(record.clone(), from_s, to_s).ok()?)?;
        let turns = crests.turns_against(c, others);
        let nearest = settled(&turns, whole.delay_s);
        let best = delay(&turns, &turns.bands())?;
        let is_best = turns.level(nearest[0]) > turns.level(best.delay_s) - RIVAL;
        (turns.total() >= LINES_LEAST && is_best).then_some(nearest)
    };
    match halves.map(of) {
        // the scatter of each half is about its own delay, so a difference does not widen what is allowed
        [Some([first_s, first_sd_s]), Some([second_s, second_sd_s])] => {
            (first_s - second_s).abs() <= DEVIATIONS * first_sd_s.hypot(second_sd_s)
        }
        _ => false,
    }
}

/// The delay to which least squares from this one leads, and the scatter about it, s.
fn settled(turns: &Turns, delay_s: f64) -> [f64; 2] {
    const REFINEMENTS: usize = 3;
    let first = turns.refined(delay_s);
    let next = |[delay_s, _]: [f64; 2], _| turns.refined(delay_s);
    (1..REFINEMENTS).fold(first, next)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::{Identify, MadeMode, MadeRecord, Modes, identify};
    use std::f64::consts::PI;

    const SHAPES: [[f64; 4]; 3] = [
        [1.0, 0.8, 0.5, 0.25],
        [1.0, -0.2, -0.9, -0.7],
        [0.6, -1.0, 0.3, 0.9],
    ];

    /// Four floors, ten minutes; each channel is delayed by this number of samples of 0.01 s.
    fn measured(late: [usize; 4], seed: u64) -> Record {
        let mode = |(frequency_hz, shape): (f64, [f64; 4])| MadeMode {
            frequency_hz,
            damping_ratio: 0.01,
            shape: shape.to_vec(),
        };
        let made = MadeRecord {
            modes: [1.4, 4.1, 6.6].into_iter().zip(SHAPES).map(mode).collect(),
            duration_s: 601.0,
            seed,
            ..MadeRecord::default()
        };
        let record = made.make().unwrap();
        let samples = (0..4).map(|c| record.samples(c)[late[c]..][..60_000].to_vec());
        let channels = ["a", "b", "c", "d"].map(Channel::named).to_vec();
        Record::new(channels, samples.collect(), 100.0).unwrap()
    }

    fn late(late: [usize; 4], seed: u64) -> (Vec<LateClock>, Modes) {
        let found = identify(&measured(late, seed), &Identify::default()).unwrap();
        let note = found.notes.iter().find_map(|note| match note {
            Note::LateClocks { late } => Some(late.clone()),
            _ => None,
        });
        (note.unwrap_or_default(), found.modes)
    }

    #[test]
    fn holds_a_recorder_that_begins_late_is_named_with_its_delay_and_is_in_no_shape() {
        for seed in 0..3 {
            for samples in [5, 12, 20] {
                let (found, modes) = late([0, 0, samples, 0], seed);
                let [clock] = &found[..] else {
                    panic!("{samples}: {found:?}")
                };
                let off_s = clock.delay_s - 0.01 * samples as f64;
                assert!(clock.channel == "c" && clock.modes >= 2, "{clock:?}");
                assert!(off_s.abs() < 4.0 * clock.sd_s && clock.sd_s < 2e-3, "{clock:?}");
                assert_eq!(modes.channels.len(), 3);
                for true_hz in [1.4, 4.1, 6.6] {
                    let mode = modes.nearest(true_hz, 0.02 * true_hz).unwrap();
                    assert!(mode.phase_collinearity > 0.9, "{mode:?}");
                }
            }
        }
    }

    #[test]
    fn holds_of_two_recorders_the_one_with_fewer_channels_is_named_early_where_it_is() {
        // the largest component of the first mode belongs to the delayed channel
        let (found, _) = late([12, 0, 0, 0], 7);
        assert!(found.len() == 1 && found[0].channel == "a", "{found:?}");
        let (found, _) = late([9, 9, 9, 0], 7);
        let [clock] = &found[..] else { panic!("{found:?}") };
        assert!(
            clock.channel == "d" && (clock.delay_s + 0.09).abs() < 4.0 * clock.sd_s,
            "{clock:?}"
        );
    }

    #[test]
    fn holds_clocks_that_agree_are_left_in() {
        for seed in 0..4 {
            let (found, modes) = late([0; 4], seed);
            assert!(found.is_empty() && modes.channels.len() == 4, "{found:?}");
        }
    }

    #[test]
    fn holds_a_clock_that_runs_fast_is_not_late() {
        // 0 to 6 samples of 0.01 s over ten minutes: 0.03 s in the mean
        for seed in 0..2 {
            let record = measured([0; 4], seed);
            let mut samples: Vec<Vec<f64>> = (0..4).map(|c| record.samples(c).to_vec()).collect();
            let last = samples[2].len() - 1;
            samples[2] = (0..=last)
                .map(|i| {
                    let at = (i as f64 * (1.0 + 1e-4)).min(last as f64 - 1e-6);
                    let (k, part) = (at as usize, at.fract());
                    (1.0 - part) * record.samples(2)[k] + part * record.samples(2)[k + 1]
                })
                .collect();
            let record = Record::new(record.channels().to_vec(), samples, 100.0).unwrap();
            let off = off_clocks(&record);
            assert!(off.late.is_empty() && off.either_late.is_empty(), "{off:?}");
        }
    }

    const CORNERS: [&str; 6] = ["roof x", "roof y", "mid x", "mid y", "low x", "low y"];
    const PAIRS_HZ: [f64; 5] = [1.314, 1.611, 4.127, 5.056, 6.78];

    /// Three floors × (x, y), ten minutes, axes rotated by 20°. The given channels are delayed by this number of samples of 0.005 s, or measure
    /// velocity.
    fn floors(
        seed: u64,
        (late, samples): (&[usize], usize),
        (velocities, factor): (&[usize], f64),
    ) -> Record {
        let shape = |mode: usize| -> Vec<f64> {
            let (along, number) = (mode % 2, mode / 2);
            let (sin, cos) = 0.35_f64.sin_cos();
            let axes = if along == 0 { [cos, sin] } else { [-sin, cos] };
            let at = |height: f64| (0.5 * PI * (2 * number + 1) as f64 * height).sin();
            [1.0, 0.66, 0.33]
                .iter()
                .flat_map(|&height| axes.map(|of| of * at(height)))
                .collect()
        };
        let mode = |(mode, frequency_hz): (usize, f64)| MadeMode {
            frequency_hz,
            damping_ratio: 0.01,
            shape: shape(mode),
        };
        let made = MadeRecord {
            modes: PAIRS_HZ.into_iter().enumerate().map(mode).collect(),
            duration_s: 602.0,
            sampling_rate_hz: 200.0,
            seed,
            ..MadeRecord::default()
        };
        let accelerations = made.make().unwrap();
        let quantity = Quantity::Velocity;
        let as_velocities = MadeRecord { quantity, ..made }.make().unwrap();
        let of = |c: usize| {
            let from = if late.contains(&c) { samples } else { 0 };
            let record = if velocities.contains(&c) {
                &as_velocities
            } else {
                &accelerations
            };
            let factor = if velocities.contains(&c) { factor } else { 1.0 };
            let samples = record.samples(c)[from..][..120_000].iter();
            samples.map(|y| factor * y).collect()
        };
        let channel = |c: usize| Channel {
            position_m: Some([0.0, 0.0, [9.0, 6.0, 3.0][c / 2]]),
            ..Channel::named(CORNERS[c])
        };
        Record::new((0..6).map(channel).collect(), (0..6).map(of).collect(), 200.0).unwrap()
    }

    #[test]
    fn holds_both_channels_of_a_late_station_are_named_and_no_mode_is_lost() {
        for (station, seed) in [([2, 3], 1), ([0, 1], 2)] {
            for samples in [10, 16, 24] {
                let found = identify(
                    &floors(seed, (&station, samples), (&[], 1.0)),
                    &Identify::default(),
                )
                .unwrap();
                let note = found.notes.iter().find_map(|note| match note {
                    Note::LateClocks { late } => Some(late.clone()),
                    _ => None,
                });
                let late = note.unwrap_or_default();
                let names: Vec<&str> = late.iter().map(|clock| &clock.channel[..]).collect();
                assert_eq!(names, station.map(|c| CORNERS[c]), "{samples}: {:?}", found.notes);
                for clock in &late {
                    let off_s = clock.delay_s - 0.005 * samples as f64;
                    assert!(off_s.abs() < 4.0 * clock.sd_s && clock.sd_s < 2e-3, "{clock:?}");
                }
                for hz in PAIRS_HZ {
                    found.modes.nearest(hz, 0.01 * hz).unwrap();
                }
            }
        }
    }

    #[test]
    fn holds_velocities_beside_accelerations_are_no_late_clock_and_lose_no_mode() {
        for (velocities, seed) in [(&[2, 3][..], 3), (&[0, 1, 2], 4), (&[3, 4, 5], 4)] {
            let unsaid = floors(seed, (&[], 0), (velocities, 20.0));
            let found = identify(&unsaid, &Identify::default()).unwrap();
            let names = |of: &[usize]| -> Vec<String> { of.iter().map(|&c| CORNERS[c].into()).collect() };
            let named = found.notes.iter().find_map(|note| match note {
                Note::QuarterTurn { channels, .. } => Some([channels.clone(), Vec::new()]),
                Note::EitherTurned { channels, others, .. } => Some([channels.clone(), others.clone()]),
                _ => None,
            });
            // with two halves, either may be the different one, and none is left out
            let is_half = velocities.len() == 3;
            let wanted = match is_half {
                true => [names(&[3, 4, 5]), names(&[0, 1, 2])],
                false => [names(velocities), Vec::new()],
            };
            assert_eq!(named, Some(wanted), "{:?}", found.notes);
            let mut kept = unsaid.channels().to_vec();
            kept.retain(|c| is_half || !names(velocities).contains(&c.name));
            assert_eq!(found.modes.channels, kept);
            let clocks = |note: &Note| matches!(note, Note::LateClocks { .. });
            assert!(!found.notes.iter().any(clocks), "{:?}", found.notes);
            let mut said: Vec<Channel> = unsaid.channels().to_vec();
            for (c, channel) in said.iter_mut().enumerate() {
                channel.quantity = match velocities.contains(&c) {
                    true => Quantity::Velocity,
                    false => Quantity::Acceleration,
                };
            }
            let samples = (0..6).map(|c| unsaid.samples(c).to_vec()).collect();
            let said = Record::new(said, samples, 200.0).unwrap();
            let with_units = identify(&said, &Identify::default()).unwrap();
            assert_eq!(with_units.modes.channels.len(), 6, "{:?}", with_units.notes);
            if velocities == [3, 4, 5] {
                assert_eq!(found.modes.modes, with_units.modes.modes);
            }
            for of in [&found, &with_units] {
                for hz in PAIRS_HZ {
                    let mode = of.modes.nearest(hz, 0.01 * hz).unwrap();
                    assert!(mode.phase_collinearity > 0.9, "{mode:?}");
                }
            }
        }
    }

    #[test]
    fn holds_of_two_channels_it_is_unknown_which_is_late_and_no_mode_is_lost() {
        for (late, sign) in [([0, 12, 0, 0], 1.0), ([12, 0, 0, 0], -1.0)] {
            let record = leave_out(measured(late, 1), &["c", "d"]).unwrap();
            let found = identify(&record, &Identify::default()).unwrap();
            let either: Vec<&Note> = found
                .notes
                .iter()
                .filter(|note| {
                    matches!(
                        note,
                        Note::EitherLate { .. } | Note::LateClocks { .. } | Note::PhaseOff { .. }
                    )
                })
                .collect();
            let [Note::EitherLate { late, others }] = &either[..] else {
                panic!("{:?}", found.notes)
            };
            let off_s = late[0].delay_s - sign * 0.12;
            assert!(late[0].channel == "b" && others == &["a"], "{either:?}");
            assert!(
                off_s.abs() < 4.0 * late[0].sd_s && late[0].sd_s < 3e-3,
                "{either:?}"
            );
            assert_eq!(found.modes.channels.len(), 2);
            for true_hz in [1.4, 4.1, 6.6] {
                let mode = found.modes.nearest(true_hz, 0.02 * true_hz).unwrap();
                assert!(mode.phase_collinearity > 0.9, "{mode:?}");
            }
        }
    }

    #[test]
    fn holds_a_velocity_is_named_however_small_its_numbers_are() {
        // in m/s beside m/s² each component of the channel is below a tenth of the largest
        let found = identify(&floors(5, (&[], 0), (&[3], 1.0)), &Identify::default()).unwrap();
        let named = found.notes.iter().find_map(|note| match note {
            Note::QuarterTurn { channels, .. } => Some(channels.clone()),
            _ => None,
        });
        assert_eq!(named, Some(vec!["mid y".to_string()]), "{:?}", found.notes);
        assert_eq!(found.modes.channels.len(), 5);
    }

    fn phases_at(degrees_at_hz: &[(f64, f64)]) -> Phases {
        let lines = degrees_at_hz.iter().flat_map(|&(degrees, hz)| {
            [-0.01, 0.0, 0.01].map(|apart_hz| (degrees.to_radians(), hz + apart_hz))
        });
        phases_of(&Turns::made(lines))
    }

    /// Steps at 4.28 Hz whose phase is free; the modes have none, nor a long delay that turns each of them by nearly whole half turns.
    #[test]
    fn holds_the_phase_of_one_band_is_no_delay_of_a_clock() {
        let modes_hz = [7.933, 21.450, 26.233, 35.750, 43.733];
        let with = |steps_degrees: f64| {
            let mut all = vec![(steps_degrees, 4.267), (steps_degrees, 4.300)];
            all.extend(modes_hz.map(|hz| (0.0, hz)));
            all
        };
        let lines = with(60.0)
            .into_iter()
            .map(|(degrees, hz)| (f64::to_radians(degrees), hz));
        let turns = Turns::made(lines);
        let found = delay(&turns, &turns.bands()).unwrap();
        let [before, after] = [0.0, found.delay_s].map(|delay_s| turns.level(delay_s));
        assert!(before < AS_ONE && after > EXPLAINS && 1.0 - after < LEAVES * (1.0 - before));
        for degrees in [45.0, 60.0, 75.0] {
            assert_eq!(phases_at(&with(degrees)), Phases::AsOne, "{degrees}");
        }
    }

    #[test]
    fn exact_delay_of_two_phases_and_none_where_no_delay_explains_them() {
        // 0.05 s is 18° per hertz
        let Phases::Late(delay) = phases_at(&[(27.0, 1.5), (75.6, 4.2)]) else {
            panic!("no delay")
        };
        assert!(
            (delay.delay_s - 0.05).abs() < 1e-4 && delay.bands == 2,
            "{delay:?}"
        );
        // 1/√Σ(2πf/σ)² by hand
        assert!(delay.sd_s >= OWN_PHASE / (TAU * 4.2_f64.hypot(1.5)));
        let same = [1.5, 2.1, 3.3, 4.7, 6.1, 8.3].map(|hz| (40.0, hz));
        assert_eq!(phases_at(&same), Phases::AsOne);
        // 90° in each mode is another quantity, although the frequency ratio 1 : 3 also fits a delay
        assert_eq!(phases_at(&[(90.0, 1.4), (90.0, 4.2)]), Phases::QuarterTurn);
        assert_eq!(phases_at(&[(5.0, 1.4), (175.0, 4.2)]), Phases::AsOne);
        // a phase at a single frequency may come from a machine
        assert_eq!(phases_at(&[(75.6, 4.2)]), Phases::Unclear);
    }
}
