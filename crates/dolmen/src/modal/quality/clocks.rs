//! Compares the clocks of recorders: the structure cannot cause a phase between two channels that drifts during the record.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | C_jq | `turns` | Σ z_c z_r* of part q at mode j: channel c with the reference channel r | – |
//! | d | `ppm` | rate of the clock of c relative to that of r, positive if fast | 1e-6 |
//! | γ_j | `coherence` | coherence of channel and reference at mode j over the whole record, drift removed | – |
//! | K_j | `independent` | number of independent pieces of the record at mode j | – |
//! | ω_j, t_q | `omega`, `at_s` | circular frequency of the mode, middle of the part | rad/s, s |

use crate::modal::{Mode, Modes, Note};
use crate::numeric::inner;
use crate::signal::Record;
use dolmen_linalg::Complex64;
use std::f64::consts::{PI, TAU};

/// Number of parts of the record; each part has its own phase.
const PARTS: usize = 12;
/// Cycles in a Hann segment: enough to separate modes 10 % apart.
const CYCLES: f64 = 24.0;
/// Number of modes used: those with the smallest standard deviations.
const MODES_MOST: usize = 4;
/// Mean coherence below which a mode gives no information about a channel. Our choice.
const COHERENCE_LEAST: f64 = 0.5;
/// Largest probability that channels which move independently look as coherent as this with some drift. Our choice: one false claim in a thousand
/// surveys of a hundred pairs of channels is 1e-5.
const CHANCE_MOST: f64 = 1e-6;
/// Largest drift in the search. Our choice: quartz clocks of recorders stay within 100 ppm.
const PPM_MOST: f64 = 300.0;
/// Phase change of the highest mode in one step of the search, rad.
const TURN_STEP: f64 = PI / 6.0;
const STEPS_MOST: f64 = 4000.0;
/// Smallest significant drift: in standard deviations, and as phase rotation of the highest mode over the record, rad (10°).
/// Our choice.
const DEVIATIONS: f64 = 5.0;
const TURN_LEAST: f64 = PI / 18.0;

/// Rate of the clock of one channel relative to that of the reference.
#[derive(Clone, Copy)]
struct Drift {
    ppm: f64,
    sd: f64,
}

impl Drift {
    /// Whether two clocks differ. `turn_ppm` is the clock error that changes the phase noticeably.
    fn differs(&self, other: &Drift, turn_ppm: f64) -> bool {
        let apart = (self.ppm - other.ppm).abs();
        apart > turn_ppm && apart > DEVIATIONS * self.sd.hypot(other.sd)
    }
}

/// Removes from the shapes all channels whose clock drifts relative to most others, and names them. Frequencies and damping do
/// not change.
pub(crate) fn leave_out_other_clocks(record: &Record, modes: &mut Modes, notes: &mut Vec<Note>) {
    let l = record.channels().len();
    if l < 2 || modes.channels.len() != l {
        return;
    }
    let seen = best_known(&modes.modes);
    let Some(highest_hz) = seen.iter().map(|m| m.frequency_hz).reduce(f64::max) else {
        return;
    };
    let motion = |c: usize| seen.iter().map(|m| m.shape[c].norm_sqr()).sum::<f64>();
    let Some(reference) = (0..l).max_by(|a, b| motion(*a).total_cmp(&motion(*b))) else {
        return;
    };
    let drifts = of_channels(record, &seen, reference);
    let turn_ppm = 1e6 * TURN_LEAST / (TAU * highest_hz * record.duration_s());
    let known = || drifts.iter().flatten();
    let likes = |base: &Drift| known().filter(|d| !d.differs(base, turn_ppm)).count();
    let Some(base) = known().rev().max_by_key(|d| likes(d)).copied() else {
        return;
    };
    let is_off = |c: &usize| drifts[*c].is_some_and(|d| d.differs(&base, turn_ppm));
    let off: Vec<usize> = (0..l).filter(is_off).collect();
    if off.is_empty() {
        return;
    }
    let each = off.iter().filter_map(|&c| {
        let drift = drifts[c]?;
        Some((
            record.channels()[c].name.clone(),
            [drift.ppm - base.ppm, drift.sd.hypot(base.sd)],
        ))
    });
    let drifting: Vec<(String, [f64; 2])> = each.collect();
    let turn = drifting.iter().map(|(_, [ppm, _])| ppm.abs()).fold(0.0, f64::max)
        * 1e-6
        * TAU
        * highest_hz
        * record.duration_s();
    // without a majority either clock may be the wrong one
    let agrees = |c: &usize| drifts[*c].is_some_and(|d| !d.differs(&base, turn_ppm));
    let mut others: Vec<String> = (0..l)
        .filter(agrees)
        .map(|c| record.channels()[c].name.clone())
        .collect();
    if others.len() > off.len() {
        others.clear();
    }
    let kept: Vec<usize> = (0..l).filter(|c| !off.contains(c)).collect();
    modes.channels = kept.iter().map(|&c| modes.channels[c].clone()).collect();
    for mode in &mut modes.modes {
        mode.keep_channels(&kept);
    }
    notes.push(Note::ClockDrift {
        drifting,
        others,
        turn_degrees: turn.to_degrees(),
        frequency_hz: highest_hz,
        sampling_rate_hz: record.sampling_rate_hz(),
    });
}

/// Real modes whose bands do not overlap, with the most accurate frequencies.
fn best_known(modes: &[Mode]) -> Vec<Mode> {
    const REAL: f64 = 0.5; // of 1; a drift turns shapes
    let alone = |i: usize| {
        let after = modes.get(i + 1).is_none_or(|next| !modes[i].overlaps(next));
        let before = i == 0 || !modes[i - 1].overlaps(&modes[i]);
        after && before && modes[i].phase_collinearity > REAL
    };
    let mut seen: Vec<Mode> = (0..modes.len())
        .filter(|i| alone(*i))
        .map(|i| modes[i].clone())
        .collect();
    let known = |m: &Mode| m.frequency_sd_hz.unwrap_or(f64::INFINITY) / m.frequency_hz;
    seen.sort_by(|a, b| known(a).total_cmp(&known(b)));
    seen.truncate(MODES_MOST);
    seen
}

/// C_jq of one mode: phase of every channel relative to the reference in each part, and its coherence.
struct PhaseTurns {
    omega: f64,
    independent: f64,
    /// Parts of channels.
    cross: Vec<Vec<Complex64>>,
}

/// C_jq of one mode and one channel.
struct ChannelTurns {
    omega: f64,
    independent: f64,
    parts: Vec<Complex64>,
}

impl ChannelTurns {
    /// The parts, with the phase of a drift removed.
    fn without(&self, ppm: f64, duration_s: f64) -> impl Iterator<Item = Complex64> {
        let turn = 1e-6 * ppm * self.omega;
        let parts = self.parts.iter().enumerate();
        parts.map(move |(q, z)| z * Complex64::from_polar(1.0, turn * middle_s(q, duration_s)))
    }

    /// γ with this drift removed.
    fn coherence(&self, ppm: f64, duration_s: f64) -> f64 {
        self.without(ppm, duration_s).sum::<Complex64>().norm() / self.parts.len() as f64
    }
}

/// Middle of a part, from the middle of the record, s.
fn middle_s(part: usize, duration_s: f64) -> f64 {
    ((part as f64 + 0.5) / PARTS as f64 - 0.5) * duration_s
}

fn of_channels(record: &Record, modes: &[Mode], reference: usize) -> Vec<Option<Drift>> {
    let turns: Vec<PhaseTurns> = modes
        .iter()
        .filter_map(|mode| turns(record, mode, reference))
        .collect();
    let of_channel = |c: usize| -> Vec<ChannelTurns> {
        let each = turns.iter().map(|t| ChannelTurns {
            omega: t.omega,
            independent: t.independent,
            parts: t.cross.iter().map(|part| part[c]).collect(),
        });
        each.filter(|t| t.parts.iter().map(|z| z.norm()).sum::<f64>() > COHERENCE_LEAST * PARTS as f64)
            .collect()
    };
    (0..record.channels().len())
        .map(|c| {
            if c == reference {
                return (!turns.is_empty()).then_some(Drift { ppm: 0.0, sd: 0.0 });
            }
            drift(&of_channel(c), record.duration_s())
        })
        .collect()
}

/// Coherence of each channel with the reference in each part, with its phase; `None` if the parts are too short.
fn turns(record: &Record, mode: &Mode, reference: usize) -> Option<PhaseTurns> {
    let frequency_hz = mode.frequency_hz;
    let rate_hz = record.sampling_rate_hz();
    let length = (CYCLES * rate_hz / frequency_hz).round() as usize;
    let part = record.length() / PARTS;
    let segments = (2 * part / length).saturating_sub(1); // half overlapping
    if length < 8 || segments < 3 {
        return None;
    }
    let omega = TAU * frequency_hz;
    let wave: Vec<Complex64> = (0..length)
        .map(|t| {
            let hann = (PI * (t as f64 + 0.5) / length as f64).sin().powi(2);
            Complex64::from_polar(hann, -omega * t as f64 / rate_hz)
        })
        .collect();
    let [re, im]: [Vec<f64>; 2] =
        [|z: &Complex64| z.re, |z: &Complex64| z.im].map(|f| wave.iter().map(f).collect());
    let l = record.channels().len();
    let cross = (0..PARTS).map(|q| {
        let (mut cross, mut power) = (vec![Complex64::ZERO; l], vec![0.0; l]);
        for s in 0..segments {
            let from = q * part + s * length / 2;
            let z: Vec<Complex64> = (0..l)
                .map(|c| {
                    let samples = &record.samples(c)[from..from + length];
                    Complex64::new(inner(samples, &re), inner(samples, &im))
                })
                .collect();
            for c in 0..l {
                cross[c] += z[c] * z[reference].conj();
                power[c] += z[c].norm_sqr();
            }
        }
        let over = |c: usize| (power[c] * power[reference]).sqrt().max(f64::MIN_POSITIVE);
        (0..l).map(|c| cross[c] / over(c)).collect()
    });
    let memory = mode
        .damping_ratio
        .map_or(f64::INFINITY, |zeta| zeta * omega * record.duration_s());
    Some(PhaseTurns {
        omega,
        independent: memory.min((record.length() / length) as f64),
        cross: cross.collect(),
    })
}

/// The drift that makes the phases of each mode constant: the largest Σ_j |Σ_q C_jq e^(iω_j d t_q)|, refined by least squares. `None` if the
/// channels are not coherent with any drift.
fn drift(seen: &[ChannelTurns], duration_s: f64) -> Option<Drift> {
    let highest = seen.iter().map(|t| t.omega).reduce(f64::max)?;
    let gathered = |ppm: f64| -> f64 { seen.iter().map(|t| t.coherence(ppm, duration_s)).sum() };
    let turn = PPM_MOST * 1e-6 * highest * duration_s;
    let steps = (turn / TURN_STEP).clamp(1.0, STEPS_MOST) as i64;
    let ppm_of = |i: i64| PPM_MOST * i as f64 / steps as f64;
    // from zero outwards, so that equally good drifts give zero
    let order = (0..=steps).flat_map(|i| [i, -i]);
    let best = order.map(|i| (ppm_of(i), gathered(ppm_of(i))));
    let (ppm, _) = best.reduce(|a, b| if b.1 > a.1 * (1.0 + 1e-9) { b } else { a })?;
    let (mut slope, mut square, mut power, mut count) = (0.0_f64, 0.0_f64, 0.0_f64, 0.0_f64);
    let mut residuals: Vec<(f64, f64, f64)> = Vec::new();
    for of in seen {
        let back: Vec<Complex64> = of.without(ppm, duration_s).collect();
        let middle: Complex64 = back.iter().sum();
        for (q, z) in back.iter().enumerate() {
            let lever = 1e-6 * of.omega * middle_s(q, duration_s); // rad a ppm
            let angle = (z * middle.conj()).arg();
            residuals.push((angle, lever, z.norm_sqr()));
            slope += z.norm_sqr() * lever * angle;
            power += z.norm_sqr() * lever * lever;
        }
        count -= 1.0;
    }
    let more = slope / power;
    for (angle, lever, weight) in &residuals {
        square += weight * (angle - more * lever).powi(2);
        count += 1.0;
    }
    let sd = (square / (count - 1.0).max(1.0) / power).sqrt();
    let found = Drift { ppm: ppm - more, sd };
    let is_known = found.ppm.is_finite() && found.sd.is_finite();
    (is_known && is_coherent(seen, found.ppm, duration_s)).then_some(found)
}

/// Whether channels are coherent once this drift is removed, more than chance explains.
///
/// ```text
/// P = M Π_j (1 − γ_j²)^(K_j − 1)         independent Gaussian motion (Goodman 1957); M, number of distinct drifts in the search
/// K_j = min(ζ_j ω_j T, f_j T / 24)       the correlation of a mode falls as e^(−ζω|τ|); pieces of 24 cycles
/// ```
fn is_coherent(seen: &[ChannelTurns], ppm: f64, duration_s: f64) -> bool {
    let coherence = |of: &ChannelTurns| of.coherence(ppm, duration_s);
    let mean = seen.iter().map(coherence).sum::<f64>() / seen.len() as f64;
    let chance = |of: &ChannelTurns| (of.independent - 1.0).max(0.0) * (1.0 - coherence(of).powi(2)).ln();
    let highest = seen.iter().map(|of| of.omega).fold(0.0, f64::max);
    // drifts that differ by a turn over the record
    let distinct = 1.0 + 2.0 * PPM_MOST * 1e-6 * highest * duration_s / TAU;
    mean > COHERENCE_LEAST && distinct.ln() + seen.iter().map(chance).sum::<f64>() < CHANCE_MOST.ln()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::{Identify, MadeMode, MadeRecord, identify};
    use crate::numeric::Random;
    use crate::signal::{Join, Piece, Starts, join};

    const SHAPES: [[f64; 4]; 3] = [
        [1.0, 0.8, 0.5, 0.25],
        [1.0, -0.2, -0.9, -0.7],
        [0.6, -1.0, 0.3, 0.9],
    ];

    /// Four floors, twenty minutes; the clock of each channel is fast by this many ppm, but 100 Hz is assumed.
    fn measured(ppm: [f64; 4], seed: u64) -> Record {
        let mode = |(frequency_hz, shape): (f64, [f64; 4])| MadeMode {
            frequency_hz,
            damping_ratio: 0.01,
            shape: shape.to_vec(),
        };
        let made = MadeRecord {
            modes: [1.4, 4.1, 6.6].into_iter().zip(SHAPES).map(mode).collect(),
            duration_s: 1200.0,
            seed,
            ..MadeRecord::default()
        };
        let record = made.make().unwrap();
        // join converts a clock of 100 (1 − ppm) Hz to 100 Hz, which has the effect of a clock that is fast by ppm
        let piece = |(c, hz): (usize, f64)| Piece {
            channel: record.channels()[c].clone(),
            samples: record.samples(c).to_vec(),
            sampling_rate_hz: hz,
            begins_s: Some(0.0),
        };
        let together = |rates: [f64; 4]| {
            let pieces = rates.into_iter().enumerate().map(piece).collect();
            let options = Join {
                starts: Starts::Together,
                ..Join::default()
            };
            join(pieces, &options).unwrap().record
        };
        together(ppm.map(|ppm| 100.0 * (1.0 - 1e-6 * ppm)))
    }

    #[test]
    fn holds_a_clock_that_drifts_is_named_with_its_drift_and_is_in_no_shape() {
        for ppm in [50.0, -30.0] {
            let found = identify(&measured([0.0, 0.0, ppm, 0.0], 7), &Identify::default()).unwrap();
            let note = found.notes.iter().find_map(|note| match note {
                Note::ClockDrift { drifting, .. } => Some(drifting),
                _ => None,
            });
            let [(channel, [found_ppm, sd])] = &note.unwrap()[..] else {
                panic!("{:?}", found.notes)
            };
            assert_eq!(channel, "made 3");
            assert!(
                (found_ppm - ppm).abs() < 4.0 * sd && *sd < 2.0,
                "{found_ppm} ± {sd}"
            );
            assert_eq!(found.modes.channels.len(), 3);
            for true_hz in [1.4, 4.1, 6.6] {
                found.modes.nearest(true_hz, 0.02 * true_hz).unwrap();
            }
            assert!(found.modes.modes.iter().all(|mode| mode.shape.len() == 3));
        }
    }

    #[test]
    fn holds_of_two_clocks_with_as_many_channels_either_may_be_wrong() {
        let others_of = |ppm: [f64; 4]| {
            let found = identify(&measured(ppm, 7), &Identify::default()).unwrap();
            let note = found.notes.iter().find_map(|note| match note {
                Note::ClockDrift { others, drifting, .. } => Some((others.clone(), drifting.len())),
                _ => None,
            });
            note.unwrap_or_else(|| panic!("{:?}", found.notes))
        };
        let (others, drifting) = others_of([0.0, 0.0, 50.0, 50.0]);
        assert_eq!((others.len(), drifting), (2, 2));
        assert_eq!(others_of([0.0, 0.0, 50.0, 0.0]), (Vec::new(), 1));
    }

    #[test]
    fn holds_clocks_that_agree_are_left_alone() {
        for seed in 0..4 {
            let found = identify(&measured([0.0; 4], seed), &Identify::default()).unwrap();
            assert_eq!(found.modes.channels.len(), 4);
            let drifts = |note: &Note| matches!(note, Note::ClockDrift { .. });
            assert!(!found.notes.iter().any(drifts), "{:?}", found.notes);
        }
    }

    /// C of two channels that move independently: each part is the mean of these many Gaussian products.
    fn independent(omega: f64, products: usize, random: &mut Random) -> ChannelTurns {
        let mut part = || {
            let (mut cross, mut powers) = (Complex64::ZERO, [0.0; 2]);
            for _ in 0..products {
                let [a, b] = [(); 2].map(|()| Complex64::new(random.normal(), random.normal()));
                cross += a * b.conj();
                powers[0] += a.norm_sqr();
                powers[1] += b.norm_sqr();
            }
            cross / (powers[0] * powers[1]).sqrt()
        };
        ChannelTurns {
            omega,
            independent: (PARTS * products) as f64,
            parts: (0..PARTS).map(|_| part()).collect(),
        }
    }

    #[test]
    fn holds_channels_that_move_independently_have_no_common_clock_and_coherent_ones_have() {
        let mut random = Random::new(4, 0);
        for run in 0..500 {
            // few products: the coherence in single parts is often above a half
            let chance = independent(TAU * 2.7, 3 + run % 4, &mut random);
            assert!(drift(&[chance], 600.0).is_none(), "{run}");
        }
        let mut coherent = independent(TAU * 2.7, 5, &mut random);
        let turn = |q: usize| Complex64::from_polar(0.7, -40e-6 * TAU * 2.7 * middle_s(q, 600.0));
        coherent.parts = (0..PARTS).map(turn).collect();
        let found = drift(&[coherent], 600.0).unwrap();
        assert!((found.ppm - 40.0).abs() < 1e-6, "{}", found.ppm);
    }

    #[test]
    fn exact_chance_of_a_coherence() {
        // (1 − 0.36)^K-1 M = 1e-6 for K = 1 + (6 ln 10 + ln M) / ln(1/0.64)
        let at = |more: f64| {
            let distinct = 1.0 + 2.0 * 300e-6 * 2.0 * 600.0;
            let needed = 1.0 + (6.0 * 10f64.ln() + f64::ln(distinct)) / (1.0 / 0.64_f64).ln();
            let turns = ChannelTurns {
                omega: TAU * 2.0,
                independent: needed + more,
                parts: vec![Complex64::new(0.0, 0.6); PARTS],
            };
            is_coherent(&[turns], 0.0, 600.0)
        };
        assert!(at(0.01) && !at(-0.01));
    }
}
