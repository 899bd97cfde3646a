//! Composition of a simulated record with disturbances, drawn from its seed.

use super::structures::{between, chance, log_between, structure, whole};
use crate::modal::MadeMode;
use crate::numeric::Random;
use crate::signal::Quantity;

const RATES_HZ: [f64; 5] = [50.0, 100.0, 128.0, 200.0, 256.0];
/// Largest number of samples in all channels, to limit the time of a test.
const SAMPLES_MOST: f64 = 3e6;

/// A sine from a machine or from the mains.
#[derive(Clone, Debug, PartialEq)]
pub struct UnkindTone {
    /// Frequency of the sine, Hz.
    pub frequency_hz: f64,
    /// RMS relative to that of the affected mode, or to that of the whole motion.
    pub strength: f64,
    /// Index of the mode at its frequency.
    pub over_mode: Option<usize>,
    /// Share of the time in which it runs, from the start of the record.
    pub share: f64,
    /// Whether it comes through the cables (mains) instead of the structure.
    pub by_cable: bool,
}

/// Composition of a simulated record with disturbances.
#[derive(Clone, Debug, PartialEq)]
pub struct UnkindPlan {
    /// Seed.
    pub seed: u64,
    /// Modes by frequency, exact.
    pub modes: Vec<MadeMode>,
    /// Root mean square of the motion of each mode, any unit.
    pub strengths: Vec<f64>,
    /// Sampling rate, Hz.
    pub sampling_rate_hz: f64,
    /// Duration, s.
    pub duration_s: f64,
    /// Measured quantity.
    pub quantity: Quantity,
    /// Pole of the coloured part of the modal forces, and share of this part; 0 is white.
    pub colour: [f64; 2],
    /// Logarithm of the strength of the forces at the end over that at the start, and of its slow variation.
    pub drift: [f64; 2],
    /// Number of passing vehicles.
    pub vehicles: usize,
    /// Number of periods with footsteps, and rate of the steps, Hz.
    pub walkers: (usize, f64),
    /// Tones.
    pub tones: Vec<UnkindTone>,
    /// White sensor noise relative to the motion of the channel, one value per channel.
    pub noise: Vec<f64>,
    /// Share of low-frequency noise.
    pub noise_colour: f64,
    /// Step of the digitiser over the motion of the median channel; 0: no rounding.
    pub step: f64,
    /// A channel with spikes, clipped at its range, and the number of spikes.
    pub spikes: Option<(usize, usize)>,
    /// A channel whose sensor is loose in some periods.
    pub loose: Option<usize>,
    /// A channel whose clock drifts, and its drift, 1e-6.
    pub clock: Option<(usize, f64)>,
    /// Lost samples: index of the first, and number.
    pub lost: Vec<(usize, usize)>,
}

impl UnkindPlan {
    /// The plan for one seed.
    pub fn drawn(seed: u64) -> UnkindPlan {
        let mut random = Random::new(seed, 0);
        let random = &mut random;
        let channels = match whole(random, 0, 9) {
            0 => whole(random, 16, 40),
            1..=3 => whole(random, 8, 16),
            _ => whole(random, 2, 8),
        };
        let first_hz = log_between(random, 0.15, 12.0);
        let modes = structure(random, channels, first_hz, 80.0_f64.min(60.0 * first_hz));
        let top_hz = modes.last().map_or(first_hz, |m| m.frequency_hz);
        let fits: Vec<f64> = RATES_HZ.into_iter().filter(|hz| 0.42 * hz > top_hz).collect();
        let sampling_rate_hz = fits[whole(random, 0, fits.len() - 1)];
        let wished_s = (log_between(random, 300.0, 900.0) / first_hz).clamp(600.0, 1800.0);
        let duration_s = wished_s.min(SAMPLES_MOST / (channels as f64 * sampling_rate_hz));
        let motion = |random: &mut Random| 10f64.powf(between(random, -0.6, 0.6));
        let strengths = modes.iter().map(|_| motion(random)).collect();
        let samples = (duration_s * sampling_rate_hz) as usize;
        UnkindPlan {
            seed,
            strengths,
            sampling_rate_hz,
            duration_s,
            quantity: if chance(random, 0.25) {
                Quantity::Velocity
            } else {
                Quantity::Acceleration
            },
            colour: [between(random, 0.5, 0.99), random.uniform()],
            drift: [0.7 * random.normal(), log_between(random, 0.05, 0.7)],
            vehicles: if chance(random, 0.5) {
                whole(random, 3, 40)
            } else {
                0
            },
            walkers: if chance(random, 0.3) {
                (whole(random, 1, 5), between(random, 1.6, 2.2))
            } else {
                (0, 2.0)
            },
            tones: tones(random, &modes, sampling_rate_hz),
            noise: {
                let usual = log_between(random, 0.02, 0.4);
                (0..channels)
                    .map(|_| usual * log_between(random, 0.6, 1.6))
                    .collect()
            },
            noise_colour: random.uniform(),
            step: if chance(random, 0.4) {
                log_between(random, 0.02, 0.4)
            } else {
                0.0
            },
            spikes: chance(random, 0.2).then(|| (whole(random, 0, channels - 1), whole(random, 1, 20))),
            loose: (channels >= 4 && chance(random, 0.15)).then(|| whole(random, 0, channels - 1)),
            clock: (channels >= 3 && chance(random, 0.15)).then(|| {
                let sign = if chance(random, 0.5) { 1.0 } else { -1.0 };
                (
                    whole(random, 0, channels - 1),
                    sign * log_between(random, 5.0, 60.0),
                )
            }),
            lost: if chance(random, 0.2) {
                lost(random, samples)
            } else {
                Vec::new()
            },
            modes,
        }
    }
}

fn tones(random: &mut Random, modes: &[MadeMode], sampling_rate_hz: f64) -> Vec<UnkindTone> {
    let nyquist_hz = 0.5 * sampling_rate_hz;
    let mut tones = Vec::new();
    let mains_hz = if chance(random, 0.5) { 50.0 } else { 60.0 };
    if chance(random, 0.3) && mains_hz < 0.9 * nyquist_hz {
        tones.push(UnkindTone {
            frequency_hz: mains_hz,
            strength: log_between(random, 0.05, 1.0),
            over_mode: None,
            share: 1.0,
            by_cable: true,
        });
    }
    let share = |random: &mut Random| {
        if chance(random, 0.7) {
            1.0
        } else {
            between(random, 0.3, 0.9)
        }
    };
    for _ in 0..whole(random, 0, 4).saturating_sub(2) {
        tones.push(UnkindTone {
            frequency_hz: log_between(random, 1.0, 0.8 * nyquist_hz),
            strength: log_between(random, 0.05, 1.0),
            over_mode: None,
            share: share(random),
            by_cable: false,
        });
    }
    if chance(random, 0.15) {
        let mode = whole(random, 0, modes.len() - 1);
        let half_width_hz = modes[mode].damping_ratio * modes[mode].frequency_hz;
        tones.push(UnkindTone {
            frequency_hz: modes[mode].frequency_hz + between(random, -0.5, 0.5) * half_width_hz,
            strength: log_between(random, 0.3, 3.0),
            over_mode: Some(mode),
            share: share(random),
            by_cable: false,
        });
    }
    tones
}

/// Single samples, or a few longer gaps.
fn lost(random: &mut Random, samples: usize) -> Vec<(usize, usize)> {
    let single = chance(random, 0.6);
    let count = if single {
        whole(random, 1, 30)
    } else {
        whole(random, 1, 4)
    };
    let mut all: Vec<(usize, usize)> = (0..count)
        .map(|_| {
            let length = if single { 1 } else { whole(random, 2, samples / 50) };
            (whole(random, 1, samples - length - 1), length)
        })
        .collect();
    all.sort_unstable();
    all
}
