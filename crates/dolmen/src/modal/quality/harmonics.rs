//! Distinguishes machines from modes: near one frequency the amplitude fluctuates under random forces, but is steady for a machine.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | z_s | `parts` | Fourier sum of part s of the record at the frequency, one value for each channel |
//! | u | `direction` | first eigenvector of Σ z_s z_s* |
//! | a_s | | u* z_s |
//! | p_s | `strengths` | |a_s|² |
//! | γ | `kurtosis` | 3/2 mean |a|⁴ / (mean |a|²)²: 3 if Gaussian, 3/2 for a sine |
//! | n | `independent` | number of independent strengths in one block of time |

use crate::modal::ModalError;
use crate::modal::error::refused;
use crate::numeric::inner;
use crate::signal::Record;
use dolmen_linalg::{Complex64, ComplexMatrix, hermitian_eigen};
use std::f64::consts::PI;

pub(super) const GAUSSIAN: f64 = 3.0;
/// Numbers of parts into which the record is divided. Long parts show a weak tone, short parts a tone of variable frequency.
const PARTS: [usize; 2] = [64, 256];
/// Fewest cycles in a part; with fewer, the sum includes the mean and the mirrored frequency.
const CYCLES_LEAST: f64 = 8.0;
/// Numbers of blocks in which the machine may run or not. Long blocks show a machine with long runs, short blocks a machine with brief
/// runs. Our choice.
const BLOCKS: [usize; 3] = [12, 24, 48];
/// Fewest independent strengths in a block. Our choice.
const INDEPENDENT_LEAST: f64 = 4.0;
/// A machine runs in a block if its power is at least this share of the strongest block. Our choice: this includes blocks with three
/// quarters of machine time.
const RUNS_FROM: f64 = 0.75;
/// Number of standard deviations below the Gaussian value from which a motion is not random.
const DEVIATIONS: f64 = 3.0;

/// Kurtosis of the motion in a narrow frequency band.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kurtosis {
    /// Middle of the band, Hz.
    pub frequency_hz: f64,
    /// 3 if the motion is random (Gaussian), 1.5 if it is one sine.
    pub kurtosis: f64,
    /// Standard deviation of the kurtosis for a mode under random forces.
    pub deviation: f64,
    /// Share of the record used, 0 to 1: below 1 for a machine that runs only part of the time.
    pub share: f64,
}

impl Kurtosis {
    /// Whether the motion is too steady for random forces: three standard deviations below 3.
    pub fn harmonic(&self) -> bool {
        self.kurtosis < GAUSSIAN - DEVIATIONS * self.deviation
    }
}

/// Kurtosis of the motion of the given channels (empty: all) near `frequency_hz`, in the direction of the largest motion there; `None` if
/// the record is too short for a conclusion.
///
/// ```text
/// a_s = u* Σ_t h(t) y(t_s + t) e^(-2πi f t dt),   γ = 3/2 mean |a|⁴ / (mean |a|²)²      h: Hann's window, half overlapping
/// γ = 3 - 3/2 p²                                                     p: share of the sine in the power of the band
/// ```
/// Two lengths of part are tested, 1/64 and 1/256 of the record; the result farther below 3 is used. The standard deviation is 3/√n with
/// n independent amplitudes. n is the number of parts, or π 2ζf T/2 if the motion of a mode with `damping_ratio_least` is correlated for
/// longer than a part.
///
/// # Errors
/// [`ModalError::Option`] for a frequency outside 0 … half the sampling rate; [`ModalError::Linalg`].
///
/// # Limits
/// A sine with less than 3/4 of the power in its band cannot be distinguished from a mode. Intermittent traffic or gusts raise γ above 3
/// and can hide a sine. Fewer than 36 independent amplitudes allow no conclusion; this number needs 96 minutes at 1 Hz and ζ 0.2 %, 14
/// minutes at 7 Hz.
///
/// # Source
/// Jacobsen, Andersen & Brincker (2007) Proc. 2nd IOMAC: kurtosis of the band-passed signal. Differs from the source: we use the moments
/// of the complex amplitude of the band, which need no filter and no correlated narrow-band samples.
///
/// # Example
/// ```
/// use dolmen::modal::{ReferenceCase, band_kurtosis};
/// let record = ReferenceCase::ShearChain.made(1)?.make()?;
/// let mode = band_kurtosis(&record, &[], 4.2, 0.005)?;
/// assert!(mode.is_some_and(|k| !k.harmonic()));
/// # Ok::<(), dolmen::modal::ModalError>(())
/// ```
pub fn band_kurtosis(
    record: &Record,
    channels: &[usize],
    frequency_hz: f64,
    damping_ratio_least: f64,
) -> Result<Option<Kurtosis>, ModalError> {
    let all: Vec<usize> = (0..record.channels().len()).collect();
    let channels = if channels.is_empty() { &all } else { channels };
    if let Some(channel) = channels.iter().find(|c| **c >= all.len()) {
        return refused("channels", *channel as f64, "indices of channels, counted from 0");
    }
    let rate_hz = record.sampling_rate_hz();
    if !(frequency_hz > 0.0 && frequency_hz < 0.5 * rate_hz) {
        return refused(
            "frequency_hz",
            frequency_hz,
            "between 0 and half the sampling rate",
        );
    }
    let mut steadiest: Option<Kurtosis> = None;
    let mut in_spells: Option<Kurtosis> = None;
    let beyond = |k: &Kurtosis| (k.kurtosis - GAUSSIAN) / k.deviation;
    for parts in PARTS {
        let length = record.length() / parts;
        if (length as f64) < CYCLES_LEAST * rate_hz / frequency_hz {
            continue;
        }
        let count = 2 * parts - 1; // half overlapping Hann parts share 3 % of their power
        let independent_most = 0.5 * PI * 2.0 * damping_ratio_least * frequency_hz * record.duration_s();
        let half_overlapping = Parts {
            length,
            halves: 1,
            count,
        };
        let sums = fourier_sums(record, channels, frequency_hz, half_overlapping);
        let along = strengths(&sums)?;
        let found = Kurtosis {
            frequency_hz,
            kurtosis: kurtosis(&along),
            deviation: GAUSSIAN / independent_most.min(count as f64).max(1.0).sqrt(),
            share: 1.0,
        };
        if found.kurtosis.is_finite() && steadiest.is_none_or(|best| beyond(&found) < beyond(&best)) {
            steadiest = Some(found);
        }
        for blocks in BLOCKS {
            let independent = (independent_most / blocks as f64).min((count / blocks) as f64);
            if independent >= INDEPENDENT_LEAST {
                let found = where_it_runs(&sums, &along, (blocks, independent))?;
                let found = Kurtosis {
                    frequency_hz,
                    ..found
                };
                if found.kurtosis.is_finite() && in_spells.is_none_or(|best| beyond(&found) < beyond(&best)) {
                    in_spells = Some(found);
                }
            }
        }
    }
    Ok(match in_spells.filter(Kurtosis::harmonic) {
        Some(spells) if steadiest.is_none_or(|whole| !whole.harmonic()) => Some(spells),
        _ => steadiest,
    })
}

/// Parts of a record, samples.
#[derive(Clone, Copy)]
pub(super) struct Parts {
    pub(super) length: usize,
    /// Distance between the starts of successive parts, in half lengths.
    pub(super) halves: usize,
    pub(super) count: usize,
}

/// z_s of every part and channel, with each channel normalised, so that units and gains of sensors do not affect the direction.
pub(super) fn fourier_sums(
    record: &Record,
    channels: &[usize],
    frequency_hz: f64,
    Parts {
        length,
        halves,
        count,
    }: Parts,
) -> Vec<Vec<Complex64>> {
    let turn = 2.0 * PI * frequency_hz / record.sampling_rate_hz();
    let wave = |of: fn(f64) -> f64| -> Vec<f64> {
        let hann = |t: usize| (PI * (t as f64 + 0.5) / length as f64).sin().powi(2);
        (0..length).map(|t| hann(t) * of(turn * t as f64)).collect()
    };
    let (cos, sin) = (wave(f64::cos), wave(f64::sin));
    let mut parts: Vec<Vec<Complex64>> = (0..count)
        .map(|s| {
            let from = s * halves * length / 2;
            let sum = |c: &usize| {
                let samples = &record.samples(*c)[from..from + length];
                Complex64::new(inner(samples, &cos), -inner(samples, &sin))
            };
            channels.iter().map(sum).collect()
        })
        .collect();
    for c in 0..channels.len() {
        let power: f64 = parts.iter().map(|z| z[c].norm_sqr()).sum();
        let strength = power.sqrt().max(f64::MIN_POSITIVE);
        parts.iter_mut().for_each(|z| z[c] /= strength);
    }
    parts
}

/// p_s of the parts.
fn strengths(parts: &[Vec<Complex64>]) -> Result<Vec<f64>, ModalError> {
    let along = along_the_strongest(parts)?;
    Ok(along.into_iter().map(|a| a.norm_sqr()).collect())
}

/// a_s of the parts, in the direction of the largest motion.
pub(super) fn along_the_strongest(parts: &[Vec<Complex64>]) -> Result<Vec<Complex64>, ModalError> {
    let l = parts.first().map_or(0, Vec::len);
    let power = ComplexMatrix::from_fn(l, l, |i, j| {
        parts.iter().map(|z| z[i] * z[j].conj()).sum::<Complex64>()
    });
    let e = hermitian_eigen(&power)?;
    let direction = e.vectors.column(l - 1);
    let along = |z: &Vec<Complex64>| {
        let both = direction.iter().zip(z);
        both.map(|(u, z)| u.conj() * z).sum::<Complex64>()
    };
    Ok(parts.iter().map(along).collect())
}

fn kurtosis(strengths: &[f64]) -> f64 {
    let second: f64 = strengths.iter().sum();
    let fourth: f64 = strengths.iter().map(|p| p * p).sum();
    1.5 * fourth * strengths.len() as f64 / (second * second)
}

/// Kurtosis within the strongest blocks of time.
///
/// ```text
/// γ = (n + 1)/n mean_b γ_b,   sd² = 9 (n − 1)/((n + 2)(n + 3)) / blocks      n independent strengths in a block
/// ```
/// For Gaussian motion p_s/Σp is independent of Σp, and E γ_b = 3n/(n + 1). So γ stays 3 even if the data select the strongest blocks.
/// Differences in strength between blocks (gusts) do not affect γ; such differences within a block raise it.
fn where_it_runs(
    parts: &[Vec<Complex64>],
    along: &[f64],
    (blocks, independent): (usize, f64),
) -> Result<Kurtosis, ModalError> {
    let length = parts.len() / blocks;
    let power: Vec<f64> = along
        .chunks_exact(length)
        .take(blocks)
        .map(|block| block.iter().sum())
        .collect();
    let strongest = power.iter().copied().fold(0.0, f64::max);
    let runs: Vec<usize> = (0..power.len())
        .filter(|b| power[*b] >= RUNS_FROM * strongest)
        .collect();
    let there: Vec<Vec<Complex64>> = runs
        .iter()
        .flat_map(|b| parts[b * length..(b + 1) * length].iter().cloned())
        .collect();
    let strengths = strengths(&there)?;
    let count = runs.len() as f64;
    let mean = strengths.chunks_exact(length).map(kurtosis).sum::<f64>() / count;
    let n = independent;
    Ok(Kurtosis {
        frequency_hz: 0.0,
        kurtosis: (n + 1.0) / n * mean,
        deviation: GAUSSIAN * ((n - 1.0) / ((n + 2.0) * (n + 3.0)) / count).sqrt(),
        share: count / blocks as f64,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;
    use crate::signal::Channel;

    /// Two channels of noise, a sine of `amplitude` in both.
    fn record(amplitude: f64) -> Record {
        let (n, rate_hz) = (64_000, 50.0);
        let mut random = Random::new(11, 0);
        let samples = (0..2)
            .map(|c| {
                let wave = |t: usize| (2.0 * PI * 7.03 * t as f64 / rate_hz + c as f64).sin();
                (0..n).map(|t| amplitude * wave(t) + random.normal()).collect()
            })
            .collect();
        Record::new(["a", "b"].map(Channel::named).to_vec(), samples, rate_hz).unwrap()
    }

    #[test]
    fn exact_kurtosis_of_noise_and_of_a_sine() {
        let noise = band_kurtosis(&record(0.0), &[], 7.03, 0.002).unwrap().unwrap();
        assert!((noise.kurtosis - 3.0).abs() < 3.0 * noise.deviation, "{noise:?}");
        assert!(!noise.harmonic());
        let sine = band_kurtosis(&record(1.0), &[], 7.03, 0.002).unwrap().unwrap();
        assert!((sine.kurtosis - 1.5).abs() < 0.1, "{sine:?}");
        assert!(sine.harmonic());
        let beside = band_kurtosis(&record(1.0), &[], 9.0, 0.002).unwrap().unwrap();
        assert!(!beside.harmonic(), "{beside:?}");
    }

    /// A sine of `amplitude` in noise, present in the first `on` seconds of every `period`.
    fn in_spells(amplitude: f64, on: f64, period: f64) -> Record {
        let (still, running) = (record(0.0), record(amplitude));
        let samples = (0..2).map(|c| {
            let runs = |t: usize| (t as f64 / 50.0) % period < on;
            let of = |t: usize| {
                if runs(t) {
                    running.samples(c)[t]
                } else {
                    still.samples(c)[t]
                }
            };
            (0..still.length()).map(of).collect()
        });
        Record::new(still.channels().to_vec(), samples.collect(), 50.0).unwrap()
    }

    #[test]
    fn holds_a_machine_that_runs_for_a_part_of_the_time_is_told_with_its_share() {
        // 1280 s: the first half; a minute of every two
        for (on, period, share) in [(640.0, 1280.0, 0.5), (106.7, 213.3, 0.5)] {
            let found = band_kurtosis(&in_spells(1.0, on, period), &[], 7.03, 0.002);
            let found = found.unwrap().unwrap();
            assert!(
                found.harmonic() && (found.share - share).abs() < 0.13,
                "{found:?}"
            );
            assert!((1.4..2.2).contains(&found.kurtosis), "{found:?}");
        }
        // noise that is twice as strong for half of the time is not a machine
        let loud = |c: usize| -> Vec<f64> {
            let noise = record(0.0);
            let y = noise.samples(c).iter().enumerate();
            y.map(|(t, y)| if t < 32_000 { 2.0 * y } else { *y }).collect()
        };
        let channels = ["a", "b"].map(Channel::named).to_vec();
        let noise = Record::new(channels, vec![loud(0), loud(1)], 50.0).unwrap();
        for hz in [3.1, 7.03, 11.4, 19.2] {
            let found = band_kurtosis(&noise, &[], hz, 0.002).unwrap().unwrap();
            assert!(!found.harmonic() && found.share == 1.0, "{found:?}");
        }
    }

    #[test]
    fn refuses_to_tell_where_the_record_is_too_short() {
        assert_eq!(band_kurtosis(&record(0.0), &[], 0.3, 0.002).unwrap(), None);
        let slow = band_kurtosis(&record(1.0), &[], 0.5, 0.002).unwrap();
        assert!(slow.is_none_or(|k| !k.harmonic()), "{slow:?}");
        let fault = band_kurtosis(&record(0.0), &[2], 3.0, 0.002)
            .unwrap_err()
            .to_string();
        assert!(fault.starts_with("channels is 2, but must be indices"), "{fault}");
        let fault = band_kurtosis(&record(0.0), &[], 30.0, 0.002)
            .unwrap_err()
            .to_string();
        assert!(
            fault.starts_with("frequency_hz is 30, but must be between 0"),
            "{fault}"
        );
    }
}
