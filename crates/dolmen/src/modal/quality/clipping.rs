//! Detects modes that the clipping of a channel creates.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | x, y | | motion of a channel, and its clipped record | – |
//! | d | | distortion, y − a x | – |
//! | ρ | `rho` | correlation coefficient of x at a lag | – |
//! | r | `r` | correlation coefficient of y at the lag | – |
//! | c_k | `powers` | share of the k-th Hermite polynomial in the power of y, times the power of x | – |
//! | q | `shares` | share of samples held at an end of the range | – |

use super::from_clipping::{FromClipping, terms_of};
use crate::modal::spectrum::{Fdd, SpectralMatrices, parzen};
use crate::modal::{ModalError, Mode, Modes, Note};
use crate::numeric::chi_squared_quantile;
use crate::signal::{ClippedChannel, Record};
use dolmen_linalg::ComplexMatrix;
use realfft::RealFftPlanner;
use realfft::num_complex::Complex;
use std::f64::consts::TAU;

/// Another channel takes part in a mode if its component is at least this number of its standard deviations. Our choice: 3.6 is the largest
/// of 31 modes that clipping made in simulated records.
const TAKES_PART: f64 = 5.0;
/// Clipping makes a mode if it explains at least this share of the power there that other channels do not explain. Our choice: 0.79 is the
/// smallest of these 31.
const EXPLAINS: f64 = 0.5;
/// Number of other channels that explain the power of a channel. Our choice: fewer modes overlap at a line.
const OTHERS_MOST: usize = 4;
/// Highest Hermite polynomial.
const DEGREE_MOST: usize = 15;
/// Lags with a smaller weight of the window do not count.
const WEIGHT_LEAST: f64 = 1e-3;
/// Fewest lines on each side of a mode.
const LINES_BESIDE: f64 = 1.0;

/// A record and its clipped channels.
#[derive(Clone, Debug)]
pub(crate) struct ClippedRecord<'a> {
    pub(crate) record: &'a Record,
    /// Index of each channel among those of the modes.
    pub(crate) places: Vec<usize>,
    pub(crate) clipped: Vec<ClippedChannel>,
}

/// Removes and names the modes that clipping creates. `records` are those behind the modes: one, or several setups.
///
/// ```text
/// y = clip(x) = a x + d      E[d(t) z(s)] = 0 for each z that is jointly Gaussian with x: no other channel shows d       (Bussgang)
/// R_y(τ) = σ² Σ_k c_k ρ(τ)^k                  c_1 = (1 − q₁ − q₂)²,   c_k = (He_(k−2)(l) φ(l) − He_(k−2)(h) φ(h))² / k!        (Price)
/// R_d(τ) = σ² Σ_(k ≥ 2) c_k ρ(τ)^k            its spectrum: sums and differences of the frequencies of x, such as 3 f₁ and 2 f₁ ± f₂
/// ```
/// l and h are the ends of the range over σ, from the shares of samples held there: q₁ = Φ(l), q₂ = 1 − Φ(h). ρ follows from the measured
/// R_y. A mode comes from clipping if a clipped channel has its largest component, no sound channel takes part in it, and d has at
/// least half of the power there that sound channels do not explain.
///
/// # Errors
/// [`ModalError::TooShort`].
///
/// # Limits
/// The motion is taken as Gaussian and stationary. A mode that only clipped channels show, at a frequency where d is stronger, is removed too.
/// A sensor that is clipped in one setup counts as clipped in all.
///
/// # Source
/// Bussgang (1952) MIT RLE Technical Report 216; Price (1958) IRE Trans. Inf. Theory 4:69-72.
pub(crate) fn leave_out_clipped(
    records: &[ClippedRecord<'_>],
    modes: &mut Modes,
    notes: &mut Vec<Note>,
) -> Result<(), ModalError> {
    let held: Vec<Held<'_>> = records.iter().flat_map(Held::all).collect();
    let is_sound = |place: usize| held.iter().all(|own| own.place != place);
    let sound: Vec<usize> = (0..modes.channels.len()).filter(|c| is_sound(*c)).collect();
    let of_largest = |mode: &Mode| {
        let most =
            (0..mode.shape.len()).max_by(|&a, &b| mode.shape[a].norm().total_cmp(&mode.shape[b].norm()));
        let own = held.iter().filter(|own| Some(own.place) == most);
        own.max_by(|a, b| a.share().total_cmp(&b.share()))
            .filter(|_| !takes_part(mode, &sound))
    };
    // channels may have been left out
    let is_whole = |of: &ClippedRecord<'_>| of.places.iter().all(|place| *place < modes.channels.len());
    let placed = records.iter().flat_map(|of| &of.places).max();
    let are_all = placed.is_some_and(|last| last + 1 == modes.channels.len()) && records.iter().all(is_whole);
    if !are_all || !modes.modes.iter().any(|m| of_largest(m).is_some()) {
        return Ok(());
    }
    let mut found: Vec<FromClipping> = Vec::new();
    let (mut kept, mut made): (Vec<Mode>, Vec<(Mode, FromClipping)>) = (Vec::new(), Vec::new());
    for mode in std::mem::take(&mut modes.modes) {
        let explained = match of_largest(&mode) {
            Some(own) => Some((own.of, own.explained(&mode, &sound)?)),
            None => None,
        };
        match explained {
            Some((of, share)) if share >= EXPLAINS => {
                let own = FromClipping {
                    frequency_hz: mode.frequency_hz,
                    channel: of.channel.clone(),
                    share: share.min(1.0),
                    terms: Vec::new(),
                };
                made.push((mode, own));
            }
            _ => kept.push(mode),
        }
    }
    for (mode, own) in made {
        let terms = terms_of(&mode, &kept);
        found.push(FromClipping { terms, ..own });
    }
    modes.modes = kept;
    if !found.is_empty() {
        notes.push(Note::Clipping { modes: found });
    }
    Ok(())
}

/// A clipped channel of a record.
#[derive(Clone, Copy)]
struct Held<'a> {
    within: &'a ClippedRecord<'a>,
    channel: usize,
    place: usize,
    of: &'a ClippedChannel,
}

impl<'a> Held<'a> {
    fn all(within: &'a ClippedRecord<'a>) -> impl Iterator<Item = Held<'a>> {
        within.clipped.iter().filter_map(move |of| {
            let channels = within.record.channels();
            let channel = channels.iter().position(|own| own.name == of.channel)?;
            Some(Held {
                within,
                channel,
                place: *within.places.get(channel)?,
                of,
            })
        })
    }

    fn share(&self) -> f64 {
        self.of.shares.iter().sum()
    }

    /// Share of the distortion in the power of the channel near a mode. `sound` are the places that are clipped in no record.
    fn explained(&self, mode: &Mode, sound: &[usize]) -> Result<f64, ModalError> {
        let ClippedRecord { record, places, .. } = self.within;
        let matrices = SpectralMatrices::of(record, Fdd::default().lines_of(record)?)?;
        let step_hz = 0.5 * record.sampling_rate_hz() / matrices.lines() as f64;
        let others: Vec<usize> = (0..places.len())
            .filter(|c| sound.contains(&places[*c]))
            .collect();
        let distortion = Distortion::of(&matrices, self.channel, self.of.shares);
        Ok(distortion.share(mode, (&others, step_hz)))
    }
}

/// Whether one of these channels moves in a mode. Without standard deviations this is unknown: false.
fn takes_part(mode: &Mode, channels: &[usize]) -> bool {
    let Some(sd) = &mode.shape_sd else {
        return false;
    };
    channels
        .iter()
        .any(|&c| mode.shape[c].norm() >= TAKES_PART * sd[c])
}

/// Power of the distortion of a channel, line by line.
struct Distortion<'a> {
    matrices: &'a SpectralMatrices,
    channel: usize,
    power: Vec<f64>,
}

impl<'a> Distortion<'a> {
    fn of(matrices: &'a SpectralMatrices, channel: usize, shares: [f64; 2]) -> Self {
        let lines = matrices.lines();
        let own = (0..=lines).map(|line| matrices.power(channel, line));
        let mut planner = RealFftPlanner::new();
        let (back, forth) = (
            planner.plan_fft_inverse(2 * lines),
            planner.plan_fft_forward(2 * lines),
        );
        let mut bins: Vec<Complex<f64>> = own.map(|power| Complex::new(power, 0.0)).collect();
        let mut lags = back.make_output_vec();
        let _ = back.process(&mut bins, &mut lags); // lengths are the plan's own
        let powers = powers(shares);
        let scale = 1.0 / (2.0 * lines as f64);
        let zero = lags[0];
        for (k, lag) in lags.iter_mut().enumerate() {
            let weight = parzen(k.min(2 * lines - k) as f64 / lines as f64);
            *lag = match weight < WEIGHT_LEAST {
                true => 0.0,
                false => scale * zero * weight * distorted(&powers, *lag / (weight * zero)),
            };
        }
        let mut bins = forth.make_output_vec();
        let _ = forth.process(&mut lags, &mut bins);
        Distortion {
            matrices,
            channel,
            power: bins.iter().map(|bin| bin.re.max(0.0)).collect(),
        }
    }

    /// Share of the distortion in the power near a mode that the sound channels do not explain, or in the whole power if nothing is known
    /// about their part in it.
    fn share(&self, mode: &Mode, (sound, step_hz): (&[usize], f64)) -> f64 {
        let half_hz = (mode.damping_ratio.unwrap_or(0.0) * mode.frequency_hz).max(LINES_BESIDE * step_hz);
        let last = (self.power.len() - 1) as f64;
        let line = |hz: f64| (hz / step_hz).clamp(0.0, last).round() as usize;
        let near = line(mode.frequency_hz - half_hz)..=line(mode.frequency_hz + half_hz);
        let others: &[usize] = if mode.shape_sd.is_some() { sound } else { &[] };
        let left = |line: usize| unexplained(self.matrices.at(line), self.channel, others);
        let distortion: f64 = self.power[near.clone()].iter().sum();
        distortion / near.map(left).sum::<f64>().max(f64::MIN_POSITIVE)
    }
}

/// Power of a channel at a line without the parts that are coherent with the most coherent of the others.
fn unexplained(mut s: ComplexMatrix, channel: usize, others: &[usize]) -> f64 {
    let mut left = others.to_vec();
    let coherent =
        |s: &ComplexMatrix, j: usize| s[(channel, j)].norm_sqr() / s[(j, j)].re.max(f64::MIN_POSITIVE);
    for _ in 0..OTHERS_MOST {
        let most = (0..left.len()).max_by(|&a, &b| coherent(&s, left[a]).total_cmp(&coherent(&s, left[b])));
        let Some(j) = most.map(|at| left.swap_remove(at)) else {
            break;
        };
        let pivot = s[(j, j)].re;
        if pivot <= 0.0 {
            continue;
        }
        let remaining: Vec<usize> = left.iter().copied().chain([channel]).collect();
        for &a in &remaining {
            for &b in &remaining {
                let product = s[(a, j)] * s[(j, b)] / pivot;
                s[(a, b)] -= product;
            }
        }
    }
    s[(channel, channel)].re
}

/// c_1, c_2, … for these shares of samples held at the ends of the range.
fn powers(shares: [f64; 2]) -> Vec<f64> {
    // He_n(h) φ(h) of the end that holds this share; −l of the lower end
    let at_end = |share: f64| -> Vec<f64> {
        let is_end = share > 0.0 && share < 0.5;
        let square = chi_squared_quantile(1.0 - 2.0 * share, 1.0)
            .ok()
            .filter(|_| is_end);
        let Some(h) = square.map(f64::sqrt) else {
            return vec![0.0; DEGREE_MOST];
        };
        let density = (-0.5 * h * h).exp() / TAU.sqrt();
        let mut hermite = vec![1.0, h];
        for n in 2..DEGREE_MOST {
            hermite.push(h * hermite[n - 1] - (n - 1) as f64 * hermite[n - 2]);
        }
        hermite.iter().map(|of| of * density).collect()
    };
    let [low, high] = shares.map(at_end);
    let mut all = vec![(1.0 - shares[0] - shares[1]).powi(2)];
    let mut factorial = 1.0;
    for k in 2..=DEGREE_MOST {
        factorial *= k as f64;
        let odd = if k % 2 == 0 { 1.0 } else { -1.0 };
        all.push((odd * low[k - 2] - high[k - 2]).powi(2) / factorial);
    }
    all
}

/// Correlation coefficient of the distortion at a lag where that of the clipped record is `r`; both over the power of the record.
fn distorted(powers: &[f64], r: f64) -> f64 {
    const HALVINGS: usize = 50;
    let total: f64 = powers.iter().sum();
    let of = |rho: f64| powers.iter().rev().fold(0.0, |sum, c| (sum + c) * rho) / total;
    let (mut low, mut high) = (-1.0, 1.0);
    for _ in 0..HALVINGS {
        let rho = 0.5 * (low + high);
        match of(rho) < r {
            true => low = rho,
            false => high = rho,
        }
    }
    r - powers[0] * 0.5 * (low + high) / total
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::{Identify, MadeMode, MadeRecord, Refusal, identify, joint_setups};
    use crate::signal::{Channel, Quantity, leave_out};

    /// Modes at these frequencies, of which the lowest is the strongest; the first channel is clipped at one standard deviation.
    fn clipped(modes: &[(f64, [f64; 4])], seed: u64) -> Record {
        let made = MadeRecord {
            modes: modes
                .iter()
                .map(|(frequency_hz, shape)| MadeMode {
                    frequency_hz: *frequency_hz,
                    damping_ratio: 0.01,
                    shape: shape.to_vec(),
                })
                .collect(),
            quantity: Quantity::Velocity,
            noise_ratio: 0.02,
            seed,
            ..MadeRecord::default()
        };
        let record = made.make().unwrap();
        let end = record.mean_square(0).sqrt();
        let samples = (0..4).map(|c| {
            let end = if c == 0 { end } else { f64::INFINITY };
            record.samples(c).iter().map(|y| y.clamp(-end, end)).collect()
        });
        Record::new(
            ["a", "b", "c", "d"].map(Channel::named).to_vec(),
            samples.collect(),
            100.0,
        )
        .unwrap()
    }

    const FIRST: (f64, [f64; 4]) = (1.23, [1.0, 0.8, 0.6, 0.3]);
    const THIRD: (f64, [f64; 4]) = (8.9, [0.5, -0.5, -0.2, 0.5]);

    fn made_by_clipping(notes: &[Note]) -> Vec<FromClipping> {
        let modes = |note: &Note| match note {
            Note::Clipping { modes } => modes.clone(),
            _ => Vec::new(),
        };
        notes.iter().flat_map(modes).collect()
    }

    #[test]
    fn exact_powers_of_the_distortion() {
        // E[clip(x)²] = 1 − 2φ(1) − 2Q(1) + 2Q(1) of x clipped at ±σ, by hand; c_1 is the square of the share inside
        let q = 0.158_655_253_931_457;
        let all = powers([q, q]);
        // the series ends at its highest polynomial
        let lacking = |all: &[f64], exact: f64| exact - all.iter().sum::<f64>();
        assert!((0.0..2e-3).contains(&lacking(&all, 0.516_058_551)), "{all:?}");
        assert!((all[0] - 0.682_689_492_137_086_f64.powi(2)).abs() < 1e-12);
        assert!(all[1].abs() < 1e-15 && (all[2] - (2.0 * 0.241_970_725_f64).powi(2) / 6.0).abs() < 1e-8);
        // one end at σ/2: E[y] = Q/2 − φ, E[y²] = Φ − φ/2 + Q/4; c_2 = φ²/2
        let (q, phi) = (0.308_537_538_725_987, 0.352_065_326_764_3_f64);
        let one_end = powers([q, 0.0]);
        let exact = (1.0 - q - 0.5 * phi + 0.25 * q) - (0.5 * q - phi).powi(2);
        assert!((0.0..2e-3).contains(&lacking(&one_end, exact)), "{one_end:?}");
        assert!((one_end[1] - 0.5 * phi.powi(2)).abs() < 1e-8);
    }

    #[test]
    fn holds_three_times_the_strongest_mode_is_left_out_and_can_be_accepted() {
        let record = clipped(&[FIRST, THIRD], 1);
        let found = identify(&record, &Identify::default()).unwrap();
        let made = made_by_clipping(&found.notes);
        let third = made.iter().find(|of| (of.frequency_hz - 3.69).abs() < 0.04);
        let third = third.unwrap_or_else(|| panic!("{:?}", found.notes));
        assert_eq!((third.channel.as_str(), third.terms[0].0), ("a", 3));
        let hz: Vec<f64> = found.modes.modes.iter().map(|mode| mode.frequency_hz).collect();
        assert!(
            hz.len() == 2 && (hz[0] - 1.23).abs() < 0.01 && (hz[1] - 8.9).abs() < 0.05,
            "{hz:?}"
        );
        let wanted = Identify {
            accept_hz: vec![third.frequency_hz],
            ..Identify::default()
        };
        let found = identify(&record, &wanted).unwrap();
        let accepted = found.modes.modes[1].accepted.unwrap();
        assert_eq!(accepted.refusal, Some(Refusal::Clipping));
    }

    #[test]
    fn holds_setups_identified_as_one_lose_what_a_clipped_reference_makes_and_no_mode() {
        let setup = |seed: u64, moved: &str| {
            let all = clipped(&[FIRST, THIRD], seed);
            leave_out(all, &[moved]).unwrap()
        };
        let setups = [setup(1, "d"), setup(2, "c")];
        let found = joint_setups(&setups, &Identify::default(), 0.1).unwrap();
        let made = made_by_clipping(&found.notes);
        assert!(made.iter().all(|of| of.channel == "a"), "{made:?}");
        assert!(
            made.iter().any(|of| (of.frequency_hz - 3.69).abs() < 0.04),
            "{:?}",
            found.notes
        );
        let hz: Vec<f64> = found.modes.modes.iter().map(|mode| mode.frequency_hz).collect();
        assert!(
            hz.len() == 2 && (hz[0] - 1.23).abs() < 0.01 && (hz[1] - 8.9).abs() < 0.05,
            "{hz:?}"
        );
    }

    #[test]
    fn holds_a_mode_there_that_other_channels_show_is_kept() {
        for seed in [1, 2] {
            let record = clipped(&[FIRST, (3.66, [0.1, -0.15, 0.1, 0.15]), THIRD], seed);
            let found = identify(&record, &Identify::default()).unwrap();
            let hz: Vec<f64> = found.modes.modes.iter().map(|mode| mode.frequency_hz).collect();
            for true_hz in [1.23, 3.66, 8.9] {
                found.modes.nearest(true_hz, 0.01 * true_hz).unwrap();
            }
            assert!(hz.len() == 3, "{hz:?} {:?}", found.notes);
        }
    }
}
