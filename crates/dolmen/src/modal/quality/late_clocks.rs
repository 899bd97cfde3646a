//! Recorders that begin late by the same time throughout: a phase between channels that grows with the frequency of the mode is a delay.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | φ_j | `phase` | angle of a channel in mode j against the channels that agree, mod π: signs are not known | rad |
//! | σ_j | `sd` | standard deviation of φ_j | rad |
//! | τ | `delay_s` | what the clock of the channel is late | s |

use super::shape_checks::{has_phase, is_no_shapes};
use crate::modal::notes::LateClock;
use crate::modal::{Mode, Modes, Note};
use std::f64::consts::{PI, TAU};

/// Angle that shapes of structures have of themselves, rad (3°): lightly damped ones lie within it. Chosen here.
const OWN_PHASE: f64 = 3.0 * TAU / 360.0;
/// Channels whose phases differ by less in every mode have one clock, rad (15°). Chosen here.
const ONE_CLOCK: f64 = 15.0 * TAU / 360.0;
/// Delays looked for where three modes or more show one, s; two modes fit too many, and theirs is below half a period of the lower. Chosen here.
const DELAY_MOST_S: f64 = 2.0;
/// Mean square of the residuals over their deviations up to which a delay explains the phases. Chosen here.
const EXPLAINED: f64 = 4.0;
/// Deviations of a delay from none from which it counts. Chosen here.
const DEVIATIONS: f64 = 5.0;
/// Steps of the search turn the highest mode by so much, rad (5°).
const TURN_STEP: f64 = PI / 36.0;

/// The phase of one channel in one mode.
#[derive(Clone, Copy)]
struct Phase {
    frequency_hz: f64,
    phase: f64,
    sd: f64,
}

impl Phase {
    /// Residual of a delay.
    fn residual(&self, delay_s: f64) -> f64 {
        within_half_turn(self.phase - TAU * self.frequency_hz * delay_s)
    }
}

/// Leaves channels out of the shapes whose clock is late or early by one time throughout, and names them with it. Frequencies and damping stay.
///
/// ```text
/// y_c(t + τ) = φ_c q(t)   →   arg φ_c = 2π f_j τ + k π          in every mode j, k whole
/// ```
/// A channel is looked at whose phase is no shape's, in the modes that no other overlaps, two at least.
///
/// # Limits
/// A late channel that moves much turns a shape so far that it passes for noise: a mode that no order shows tells nothing of the delay, and with
/// one mode left nothing is told.
pub(crate) fn leave_out_late_clocks(modes: &mut Modes, notes: &mut Vec<Note>) {
    let l = modes.channels.len();
    let alone = |i: &usize| {
        let clear = |other: Option<&Mode>| other.is_none_or(|m| !m.overlaps(&modes.modes[*i]));
        clear(modes.modes.get(i + 1)) && clear(i.checked_sub(1).and_then(|before| modes.modes.get(before)))
    };
    let seen: Vec<Mode> = (0..modes.modes.len())
        .filter(alone)
        .map(|i| modes.modes[i].clone())
        .collect();
    let alike = |a: usize, b: usize| {
        let of = |mode: &&Mode| has_phase(mode, a) && has_phase(mode, b);
        let apart = |mode: &Mode| within_half_turn(mode.shape[a].arg() - mode.shape[b].arg()).abs();
        let mut both = seen.iter().filter(of).peekable();
        both.peek().is_some() && both.all(|mode| apart(mode) < ONE_CLOCK)
    };
    let group = |r: usize| -> Vec<usize> { (0..l).filter(|&c| c == r || alike(c, r)).collect() };
    let Some(agreeing) = (0..l).rev().map(group).max_by_key(Vec::len) else {
        return;
    };
    let others = (0..l).filter(|c| !agreeing.contains(c));
    let late: Vec<(usize, LateClock)> = others
        .filter_map(|c| {
            let phases: Vec<Phase> = seen.iter().filter_map(|mode| phase(mode, c, &agreeing)).collect();
            let clock = delay(&phases)?;
            let channel = modes.channels[c].name.clone();
            Some((c, LateClock { channel, ..clock }))
        })
        .collect();
    if late.is_empty() {
        return;
    }
    let kept: Vec<usize> = (0..l).filter(|c| late.iter().all(|(off, _)| off != c)).collect();
    modes.channels = kept.iter().map(|&c| modes.channels[c].clone()).collect();
    for mode in &mut modes.modes {
        mode.keep_channels(&kept);
    }
    let late = late.into_iter().map(|(_, clock)| clock).collect();
    notes.push(Note::LateClocks { late });
}

/// An angle mod π, −π/2 to π/2.
fn within_half_turn(angle: f64) -> f64 {
    angle - PI * (angle / PI).round()
}

/// The phase of a channel against those that agree; `None` where it has none or they have none.
fn phase(mode: &Mode, c: usize, agreeing: &[usize]) -> Option<Phase> {
    let base = agreeing.iter().filter(|r| has_phase(mode, **r));
    let squares = base
        .map(|&r| mode.shape[r] * mode.shape[r])
        .reduce(|a, b| a + b)?;
    let sd = mode.shape_sd.as_ref().map_or(0.0, |sd| sd[c]) / mode.shape[c].norm();
    has_phase(mode, c).then(|| Phase {
        frequency_hz: mode.frequency_hz,
        phase: within_half_turn(mode.shape[c].arg() - 0.5 * squares.arg()),
        sd: sd.hypot(OWN_PHASE),
    })
}

/// The least delay that explains the phases of a channel, and the next that does as well.
fn delay(phases: &[Phase]) -> Option<LateClock> {
    let angles: Vec<f64> = phases.iter().map(|p| p.phase.abs()).collect();
    // velocities beside accelerations are a quarter turn apart in every mode
    let is_quarter = phases
        .iter()
        .all(|p| (p.phase.abs() - 0.5 * PI).abs() < 2.0 * p.sd);
    if phases.len() < 2 || !is_no_shapes(&angles) || is_quarter {
        return None;
    }
    let highest = phases.iter().map(|p| p.frequency_hz).fold(0.0, f64::max);
    let lowest = phases
        .iter()
        .map(|p| p.frequency_hz)
        .fold(f64::INFINITY, f64::min);
    let most_s = if phases.len() > 2 {
        DELAY_MOST_S
    } else {
        0.5 / lowest
    };
    let square = |delay_s: f64| -> f64 {
        let each = phases.iter().map(|p| (p.residual(delay_s) / p.sd).powi(2));
        each.sum::<f64>() / (phases.len() - 1) as f64
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
        .filter(|&s| square(s) <= EXPLAINED)
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
        modes: phases.len(),
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

    /// Four floors for ten minutes, each channel late by so many samples of 0.01 s.
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
        // the largest component of the first mode is of the late channel
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
        // 0.05 s: 18° a hertz
        let clock = delay(&phases(&[(27.0, 1.5), (75.6, 4.2)])).unwrap();
        assert!((clock.delay_s - 0.05).abs() < 1e-12, "{clock:?}");
        // 1/√Σ(2πf/σ)² by hand
        assert!((clock.sd_s - OWN_PHASE / (TAU * 4.2_f64.hypot(1.5))).abs() < 1e-12);
        assert_eq!(delay(&phases(&[(60.0, 1.5), (70.0, 4.2)])), None);
        // a quarter turn in each is another quantity, though 1 : 3 fits a delay
        assert_eq!(delay(&phases(&[(90.0, 1.4), (90.0, 4.2)])), None);
        assert_eq!(delay(&phases(&[(75.6, 4.2)])), None);
    }
}
