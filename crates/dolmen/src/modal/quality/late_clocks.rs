//! Detects recorders with a constant delay: it causes a phase between channels that is proportional to the frequency of the mode.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | φ_j | `phase` | angle of a channel in mode j relative to the agreeing channels, mod π, because signs are unknown | rad |
//! | σ_j | `sd` | standard deviation of φ_j | rad |
//! | τ | `delay_s` | delay of the channel's clock | s |

use super::remarks::explained;
use super::shape_checks::{has_phase, is_no_shapes};
use crate::modal::noted::LateClock;
use crate::modal::{Mode, Modes, Note};
use std::f64::consts::{PI, TAU};

/// Largest usual phase in shapes of structures, rad (3°); lightly damped shapes stay below it. Our choice.
const OWN_PHASE: f64 = 3.0 * TAU / 360.0;
/// Channels with a smaller phase difference in every mode have one clock, rad (15°). Our choice.
const ONE_CLOCK: f64 = 15.0 * TAU / 360.0;
/// Largest delay in the search with three or more modes, s. Two modes fit too many delays, so with two modes the limit is half a period of the
/// lower mode. Our choice.
const DELAY_MOST_S: f64 = 2.0;
/// A delay explains the phases if the mean square of the residuals over their standard deviations is at most this. Our choice.
const EXPLAINED: f64 = 4.0;
/// Smallest significant delay, in standard deviations. Our choice.
const DEVIATIONS: f64 = 5.0;
/// Phase change of the highest mode in one step of the search, rad (5°).
const TURN_STEP: f64 = PI / 36.0;

#[derive(Clone, Copy)]
struct Phase {
    frequency_hz: f64,
    phase: f64,
    sd: f64,
}

impl Phase {
    fn residual(&self, delay_s: f64) -> f64 {
        within_half_turn(self.phase - TAU * self.frequency_hz * delay_s)
    }
}

/// Removes from the shapes all channels with a constant clock delay, and all channels with a phase of 90° at every frequency, and names them.
/// Frequencies and damping do not change. `peaks` are those of the spectrum: a delay changes the shapes of some modes so much that no pole is
/// accepted as a mode, but the peaks show their phases.
///
/// ```text
/// y_c(t + τ) = φ_c q(t)   →   arg φ_c = 2π f_j τ + k π          in every mode j, k whole
/// ```
/// A channel is tested if its phase cannot come from a mode shape. The test needs at least two modes without overlap or peaks that none of these
/// explains. Channels at one place share one recorder and one delay: if they give different delays, no clock has a delay. If one of them agrees
/// with the other channels, the delay comes from the filter of a channel.
///
/// # Limits
/// Correlated forces and machines also change the phases of peaks: a delay at two of them is reported.
pub(crate) fn leave_out_late_clocks(modes: &mut Modes, peaks: &Modes, notes: &mut Vec<Note>) {
    let l = modes.channels.len();
    let seen = seen(modes, peaks);
    let agreeing = agreeing(&seen, l);
    let own = |c: usize| -> Vec<Phase> { seen.iter().filter_map(|mode| phase(mode, c, &agreeing)).collect() };
    let phases: Vec<Vec<Phase>> = (0..l).map(own).collect();
    let mut late: Vec<(usize, LateClock)> = Vec::new();
    let mut turned: Vec<usize> = Vec::new();
    for station in stations(modes) {
        let of = |channels: &[usize]| -> Vec<&[Phase]> { channels.iter().map(|&c| &phases[c][..]).collect() };
        let (agree, off): (Vec<usize>, Vec<usize>) = station.iter().partition(|c| agreeing.contains(c));
        let together = match agree.is_empty() {
            true => vec![off],
            // the clock is right, because only a single channel has a delay
            false => off.iter().map(|&c| vec![c]).collect(),
        };
        for channels in together {
            if is_quarter_turn(&of(&channels)) {
                turned.extend(&channels);
            } else if let Some(clock) = delay(&of(&channels)) {
                late.extend(channels.iter().map(|&c| {
                    let channel = modes.channels[c].name.clone();
                    (
                        c,
                        LateClock {
                            channel,
                            ..clock.clone()
                        },
                    )
                }));
            }
        }
    }
    if late.is_empty() && turned.is_empty() {
        return;
    }
    late.sort_by_key(|(c, _)| *c);
    turned.sort_unstable();
    let is_off = |c: &usize| turned.contains(c) || late.iter().any(|(off, _)| off == c);
    let kept: Vec<usize> = (0..l).filter(|c| !is_off(c)).collect();
    let names: Vec<String> = turned.iter().map(|&c| modes.channels[c].name.clone()).collect();
    let mut frequency_hz: Vec<f64> = turned
        .iter()
        .flat_map(|&c| phases[c].iter().map(|phase| phase.frequency_hz))
        .collect();
    frequency_hz.sort_by(f64::total_cmp);
    frequency_hz.dedup();
    modes.channels = kept.iter().map(|&c| modes.channels[c].clone()).collect();
    for mode in &mut modes.modes {
        mode.keep_channels(&kept);
    }
    if !names.is_empty() {
        notes.push(Note::QuarterTurn {
            channels: names,
            frequency_hz,
        });
    }
    if !late.is_empty() {
        let late = late.into_iter().map(|(_, clock)| clock).collect();
        notes.push(Note::LateClocks { late });
    }
}

/// Modes without overlap, and the peaks that none of them explains.
fn seen(modes: &Modes, peaks: &Modes) -> Vec<Mode> {
    let all = &modes.modes;
    let alone = |i: &usize| {
        let clear = |other: Option<&Mode>| other.is_none_or(|m| !m.overlaps(&all[*i]));
        clear(all.get(i + 1)) && clear(i.checked_sub(1).and_then(|before| all.get(before)))
    };
    let mut seen: Vec<Mode> = (0..all.len()).filter(alone).map(|i| all[i].clone()).collect();
    if peaks.channels.len() == modes.channels.len() {
        let unexplained = peaks.modes.iter().filter(|peak| !explained(peak, &seen));
        let unexplained: Vec<Mode> = unexplained.cloned().collect();
        seen.extend(unexplained);
    }
    seen
}

/// The largest set of channels with equal phase, within its uncertainty.
fn agreeing(seen: &[Mode], l: usize) -> Vec<usize> {
    let alike = |a: usize, b: usize| {
        let of = |mode: &&Mode| has_phase(mode, a) && has_phase(mode, b);
        let apart = |mode: &Mode| within_half_turn(mode.shape[a].arg() - mode.shape[b].arg()).abs();
        let most = |mode: &Mode| ONE_CLOCK.max(3.0 * angle_sd(mode, a).hypot(angle_sd(mode, b)));
        let mut both = seen.iter().filter(of).peekable();
        both.peek().is_some() && both.all(|mode| apart(mode) < most(mode))
    };
    let group = |r: usize| -> Vec<usize> { (0..l).filter(|&c| c == r || alike(c, r)).collect() };
    (0..l).rev().map(group).max_by_key(Vec::len).unwrap_or_default()
}

/// Channels grouped by place; a channel with an unknown place forms its own group.
fn stations(modes: &Modes) -> Vec<Vec<usize>> {
    let mut all: Vec<Vec<usize>> = Vec::new();
    for (c, channel) in modes.channels.iter().enumerate() {
        let is_here = |station: &&mut Vec<usize>| {
            let other = modes.channels[station[0]].position_m;
            other.is_some() && other == channel.position_m
        };
        match all.iter_mut().find(is_here) {
            Some(station) => station.push(c),
            None => all.push(vec![c]),
        }
    }
    all
}

/// An angle mod π, −π/2 to π/2.
fn within_half_turn(angle: f64) -> f64 {
    angle - PI * (angle / PI).round()
}

fn angle_sd(mode: &Mode, c: usize) -> f64 {
    mode.shape_sd.as_ref().map_or(0.0, |sd| sd[c]) / mode.shape[c].norm()
}

/// Phase of a channel relative to the agreeing channels; `None` if either is unknown.
fn phase(mode: &Mode, c: usize, agreeing: &[usize]) -> Option<Phase> {
    let base = agreeing.iter().filter(|r| has_phase(mode, **r));
    let squares = base
        .map(|&r| mode.shape[r] * mode.shape[r])
        .reduce(|a, b| a + b)?;
    has_phase(mode, c).then(|| Phase {
        frequency_hz: mode.frequency_hz,
        phase: within_half_turn(mode.shape[c].arg() - 0.5 * squares.arg()),
        sd: angle_sd(mode, c).hypot(OWN_PHASE),
    })
}

/// A velocity channel among accelerations has a phase of 90° in every mode: a phase that does not grow with frequency is not a delay.
fn is_quarter_turn(channels: &[&[Phase]]) -> bool {
    let off = |p: &Phase| ((p.phase.abs() - 0.5 * PI) / p.sd).powi(2);
    let fits = |of: &&[Phase]| of.iter().map(off).sum::<f64>() <= EXPLAINED * of.len() as f64;
    at_hz(channels).len() > 1 && channels.iter().all(fits)
}

fn at_hz(channels: &[&[Phase]]) -> Vec<f64> {
    let mut all: Vec<f64> = channels
        .iter()
        .flat_map(|of| of.iter().map(|p| p.frequency_hz))
        .collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

/// The smallest delay that explains the phases of these channels, together and separately, and the next such delay.
fn delay(channels: &[&[Phase]]) -> Option<LateClock> {
    let phases: Vec<Phase> = channels.iter().flat_map(|of| of.iter().copied()).collect();
    let angles: Vec<f64> = phases.iter().map(|p| p.phase.abs()).collect();
    let is_turned = |p: &&Phase| p.phase.abs() > ONE_CLOCK;
    let turned: Vec<Phase> = phases.iter().filter(is_turned).copied().collect();
    let modes = at_hz(channels);
    if at_hz(&[&turned]).len() < 2 || !is_no_shapes(&angles) {
        return None;
    }
    let (lowest, highest) = (*modes.first()?, *modes.last()?);
    let most_s = if modes.len() > 2 {
        DELAY_MOST_S
    } else {
        0.5 / lowest
    };
    let square = |delay_s: f64| -> f64 {
        let each = phases.iter().map(|p| (p.residual(delay_s) / p.sd).powi(2));
        each.sum::<f64>() / (phases.len() - 1) as f64
    };
    let explains = |delay_s: f64| {
        let each = |of: &&[Phase]| {
            let sum: f64 = of.iter().map(|p| (p.residual(delay_s) / p.sd).powi(2)).sum();
            sum <= EXPLAINED * of.len() as f64
        };
        square(delay_s) <= EXPLAINED && channels.iter().all(each)
    };
    let levers: f64 = phases.iter().map(|p| (TAU * p.frequency_hz / p.sd).powi(2)).sum();
    let better = |from_s: f64| {
        let pull = phases
            .iter()
            .map(|p| TAU * p.frequency_hz * p.residual(from_s) / p.sd.powi(2));
        from_s + pull.sum::<f64>() / levers
    };
    let step_s = TURN_STEP / (TAU * highest);
    let steps = (most_s / step_s).ceil() as i64;
    let mut found: Vec<f64> = (-steps..=steps)
        .map(|i| i as f64 * step_s)
        .filter(|&s| square(s) <= square(s - step_s) && square(s) < square(s + step_s))
        .map(|s| better(better(s)))
        .filter(|&s| explains(s))
        .collect();
    found.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
    let delay_s = *found.first()?;
    let sd_s = square(delay_s).max(1.0).sqrt() / levers.sqrt();
    let apart = |other: &&f64| (**other - delay_s).abs() > DEVIATIONS * sd_s;
    (delay_s.abs() > DEVIATIONS * sd_s).then(|| LateClock {
        channel: String::new(),
        delay_s,
        sd_s,
        or_s: found.iter().find(apart).copied(),
        modes: modes.len(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::{Identify, MadeMode, MadeRecord, identify};
    use crate::signal::{Channel, Record};

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

    const CORNERS: [&str; 6] = ["roof x", "roof y", "mid x", "mid y", "low x", "low y"];
    const PAIRS_HZ: [f64; 5] = [1.314, 1.611, 4.127, 5.056, 6.78];

    /// Three floors × (x, y), ten minutes, axes rotated by 20°. The given channels are delayed by this number of samples of 0.005 s, or measure
    /// velocity.
    fn floors(seed: u64, (late, samples): (&[usize], usize), velocities: &[usize]) -> Record {
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
        let quantity = crate::signal::Quantity::Velocity;
        let as_velocities = MadeRecord { quantity, ..made }.make().unwrap();
        let of = |c: usize| {
            let from = if late.contains(&c) { samples } else { 0 };
            let record = if velocities.contains(&c) {
                &as_velocities
            } else {
                &accelerations
            };
            let factor = if velocities.contains(&c) { 20.0 } else { 1.0 };
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
                let found = identify(&floors(seed, (&station, samples), &[]), &Identify::default()).unwrap();
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
        for (velocities, seed) in [(&[2, 3][..], 3), (&[0, 1, 2], 4)] {
            let unsaid = floors(seed, (&[], 0), velocities);
            let found = identify(&unsaid, &Identify::default()).unwrap();
            let named = found.notes.iter().find_map(|note| match note {
                Note::QuarterTurn { channels, .. } => Some(channels.clone()),
                _ => None,
            });
            // with two halves, either may be the different one
            let count = velocities.len();
            assert_eq!(named.map(|of| of.len()), Some(count), "{:?}", found.notes);
            let clocks = |note: &Note| matches!(note, Note::LateClocks { .. });
            assert!(!found.notes.iter().any(clocks), "{:?}", found.notes);
            let mut said: Vec<Channel> = unsaid.channels().to_vec();
            for (c, channel) in said.iter_mut().enumerate() {
                channel.quantity = match velocities.contains(&c) {
                    true => crate::signal::Quantity::Velocity,
                    false => crate::signal::Quantity::Acceleration,
                };
            }
            let samples = (0..6).map(|c| unsaid.samples(c).to_vec()).collect();
            let said = Record::new(said, samples, 200.0).unwrap();
            let with_units = identify(&said, &Identify::default()).unwrap();
            assert_eq!(with_units.modes.channels.len(), 6, "{:?}", with_units.notes);
            for of in [&found, &with_units] {
                for hz in PAIRS_HZ {
                    of.modes.nearest(hz, 0.01 * hz).unwrap();
                }
            }
        }
    }

    #[test]
    fn exact_channels_of_one_place_have_one_delay_or_none() {
        let delayed = |delay_s: f64| -> Vec<Phase> {
            let at: Vec<(f64, f64)> = [1.4, 4.1, 6.6]
                .iter()
                .map(|f| (360.0 * f * delay_s, *f))
                .collect();
            phases(&at)
        };
        let (a, b, other) = (delayed(0.12), delayed(0.12), delayed(0.05));
        let clock = delay(&[&a, &b]).unwrap();
        assert!(
            (clock.delay_s - 0.12).abs() < 1e-12 && clock.modes == 3,
            "{clock:?}"
        );
        assert!(delay(&[&other]).is_some());
        assert_eq!(delay(&[&a, &other]), None);
    }

    fn phases(degrees_at_hz: &[(f64, f64)]) -> Vec<Phase> {
        let phase = |&(degrees, frequency_hz): &(f64, f64)| Phase {
            frequency_hz,
            phase: within_half_turn(degrees.to_radians()),
            sd: OWN_PHASE,
        };
        degrees_at_hz.iter().map(phase).collect()
    }

    #[test]
    fn exact_delay_of_two_phases_and_none_where_no_delay_explains_them() {
        // 0.05 s is 18° per hertz
        let clock = delay(&[&phases(&[(27.0, 1.5), (75.6, 4.2)])]).unwrap();
        assert!((clock.delay_s - 0.05).abs() < 1e-12, "{clock:?}");
        // 1/√Σ(2πf/σ)² by hand
        assert!((clock.sd_s - OWN_PHASE / (TAU * 4.2_f64.hypot(1.5))).abs() < 1e-12);
        assert_eq!(delay(&[&phases(&[(60.0, 1.5), (70.0, 4.2)])]), None);
        // 90° in each mode is another quantity, although the frequency ratio 1 : 3 also fits a delay
        assert!(is_quarter_turn(&[&phases(&[(90.0, 1.4), (90.0, 4.2)])]));
        assert!(!is_quarter_turn(&[&phases(&[(27.0, 1.5), (75.6, 4.2)])]));
        assert_eq!(delay(&[&phases(&[(75.6, 4.2)])]), None);
        // a phase at a single frequency may come from a machine
        assert_eq!(delay(&[&phases(&[(1.2, 1.0), (60.0, 50.0)])]), None);
    }
}
