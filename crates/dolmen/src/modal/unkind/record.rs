//! Simulates the record of a plan with disturbances.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | p | | modal force: white and coloured noise times `envelope`, footsteps, tones |
//! | e(t) | `envelope` | strength of the forces: drift, slow variation, vehicles |

use super::energy::{Densities, signal_over_rest};
use super::plan::UnkindPlan;
use super::structures::{between, chance, log_between};
use crate::modal::synthetic::Oscillator;
use crate::modal::{MadeMode, ModalError};
use crate::numeric::Random;
use crate::signal::{Channel, Record};
use std::f64::consts::PI;

/// A mode of the simulated record, exact, and how clearly the record shows it.
#[derive(Clone, Debug, PartialEq)]
pub struct UnkindMode {
    /// The mode.
    pub mode: MadeMode,
    /// Its spectral density at its frequency over that of all other motion, in the best combination of channels: φᵀ S⁻¹ φ P.
    pub signal_over_rest: f64,
    /// Least relative standard deviation of its damping ratio for this duration, 1/√(2πζN_c) (Au 2014).
    pub damping_floor: f64,
    /// Least relative standard deviation of its damping ratio for any unbiased estimator of this record, with its neighbours and the noise
    /// (bound of Cramér and Rao).
    pub damping_bound: f64,
}

/// A simulated record with disturbances, and its exact modes.
#[derive(Clone, Debug)]
pub struct UnkindRecord {
    /// The measured record, including lost samples.
    pub record: Record,
    /// The modes by frequency.
    pub modes: Vec<UnkindMode>,
    /// The plan of the record.
    pub plan: UnkindPlan,
}

impl UnkindMode {
    /// Whether the record has enough energy in this mode: 10 dB above all other motion, and a damping ratio that an unbiased estimator can
    /// know to 30 %. Our choice.
    pub fn has_enough_energy(&self) -> bool {
        self.signal_over_rest >= 10.0 && self.damping_bound <= 0.3
    }
}

impl UnkindPlan {
    /// The record.
    ///
    /// # Errors
    /// [`ModalError::Record`] for a plan without samples.
    pub fn make(&self) -> Result<UnkindRecord, ModalError> {
        let (rate_hz, l) = (self.sampling_rate_hz, self.noise.len());
        let n = (self.duration_s * rate_hz).round() as usize;
        let envelope = self.envelope(n);
        let mean_square = envelope.iter().map(|e| e * e).sum::<f64>() / n as f64;
        let steps = self.footsteps(n);
        let mut motions: Vec<Vec<f64>> = Vec::with_capacity(self.modes.len());
        let mut densities = Vec::with_capacity(self.modes.len());
        for (j, mode) in self.modes.iter().enumerate() {
            let (motion, density) = self.motion(j, mode, (&envelope, mean_square));
            motions.push(motion);
            densities.push(density);
        }
        self.walk(&steps, &mut motions);
        self.hum(&mut motions);
        let mut samples: Vec<Vec<f64>> = (0..l)
            .map(|c| {
                let mut y = vec![0.0; n];
                for (mode, motion) in self.modes.iter().zip(&motions) {
                    y.iter_mut()
                        .zip(motion)
                        .for_each(|(y, q)| *y += mode.shape[c] * q);
                }
                y
            })
            .collect();
        let spread: Vec<f64> = samples.iter().map(|y| root_mean_square(y)).collect();
        let mut sorted = spread.clone();
        sorted.sort_by(f64::total_cmp);
        let usual = sorted[l / 2];
        let step = self.step * usual;
        for (c, y) in samples.iter_mut().enumerate() {
            self.disturb(c, y, (spread[c].max(0.02 * usual), step));
        }
        let noise = |c: usize| {
            let sd = self.noise[c] * spread[c].max(0.02 * usual);
            // white density, rounding of the digitiser, and a coloured part that falls with frequency
            move |hz: f64| {
                let slow = (SLOW * self.noise_colour).powi(2) * lag_one(slow_pole(rate_hz), hz / rate_hz);
                2.0 / rate_hz * (sd * sd * (1.0 + slow) + step * step / 12.0)
            }
        };
        let noises: Vec<_> = (0..l).map(noise).collect();
        let of_mode = |k: usize, hz: f64, by: [f64; 2]| {
            let mode = &self.modes[k];
            let moved = MadeMode {
                frequency_hz: mode.frequency_hz * by[0],
                damping_ratio: mode.damping_ratio * by[1],
                shape: Vec::new(),
            };
            densities[k].of(Oscillator::new(&moved, rate_hz, self.quantity), hz)
        };
        let seen = Densities {
            modes: &self.modes,
            of_mode: &of_mode,
            of_noise: &|c, hz| noises[c](hz),
            channels: l,
            nyquist_hz: 0.5 * rate_hz,
            duration_s: self.duration_s,
        };
        let modes = self
            .modes
            .iter()
            .enumerate()
            .map(|(j, mode)| {
                let density_at: Vec<f64> = densities.iter().map(|d| d.at(mode.frequency_hz)).collect();
                let noise: Vec<f64> = noises.iter().map(|noise| noise(mode.frequency_hz)).collect();
                let cycles = mode.frequency_hz * self.duration_s;
                Ok(UnkindMode {
                    mode: mode.clone(),
                    signal_over_rest: signal_over_rest(&self.modes, j, &density_at, &noise)?,
                    damping_floor: 1.0 / (2.0 * PI * mode.damping_ratio * cycles).sqrt(),
                    damping_bound: seen.least_damping_deviation(j)?,
                })
            })
            .collect::<Result<_, ModalError>>()?;
        let channels = (0..l).map(|c| Channel {
            quantity: self.quantity,
            ..Channel::named(format!("c{}", c + 1))
        });
        Ok(UnkindRecord {
            record: Record::new(channels.collect(), samples, rate_hz)?,
            modes,
            plan: self.clone(),
        })
    }

    fn envelope(&self, n: usize) -> Vec<f64> {
        let mut random = Random::new(self.seed, 1);
        let [slope, wander] = self.drift;
        let turn_s = log_between(&mut random, 60.0, 900.0);
        let phase = between(&mut random, 0.0, 2.0 * PI);
        let mut e: Vec<f64> = (0..n)
            .map(|t| {
                let at_s = t as f64 / self.sampling_rate_hz;
                let slow = wander * (2.0 * PI * at_s / turn_s + phase).sin();
                (slope * t as f64 / n as f64 + slow).exp()
            })
            .collect();
        for _ in 0..self.vehicles {
            let (at, width_s) = (random.uniform() * n as f64, log_between(&mut random, 2.0, 12.0));
            let strength = log_between(&mut random, 0.5, 5.0);
            for (t, e) in e.iter_mut().enumerate() {
                let x = (t as f64 - at) / (width_s * self.sampling_rate_hz);
                if x.abs() < 5.0 {
                    *e += strength * (-x * x).exp();
                }
            }
        }
        e
    }

    /// Motion of one mode under its coloured force with the planned strength, and its density.
    fn motion(
        &self,
        j: usize,
        mode: &MadeMode,
        (envelope, mean_square): (&[f64], f64),
    ) -> (Vec<f64>, Density) {
        let mut random = Random::new(self.seed, 100 + j as u64);
        let [rho, coloured] = self.colour;
        let mut slow = 0.0;
        let own = Oscillator::new(mode, self.sampling_rate_hz, self.quantity);
        let before = own.samples_before();
        let force = (0..before + envelope.len()).map(|k| {
            let white = random.normal();
            slow = rho * slow + (1.0 - rho * rho).sqrt() * random.normal();
            ((1.0 - coloured) * white + coloured * slow) * envelope[k.saturating_sub(before)]
        });
        let mut motion: Vec<f64> = own.driven(force).skip(before).collect();
        let scale = self.strengths[j] / root_mean_square(&motion);
        motion.iter_mut().for_each(|q| *q *= scale);
        let density = Density {
            own,
            force: scale * scale * mean_square,
            colour: self.colour,
            rate_hz: self.sampling_rate_hz,
        };
        (motion, density)
    }

    /// Times of footfalls, samples.
    fn footsteps(&self, n: usize) -> Vec<usize> {
        let mut random = Random::new(self.seed, 2);
        let (spells, rate_hz) = self.walkers;
        let mut all = Vec::new();
        for _ in 0..spells {
            let mut at_s = random.uniform() * n as f64 / self.sampling_rate_hz;
            for _ in 0..(between(&mut random, 10.0, 40.0) * rate_hz) as usize {
                at_s += (1.0 + 0.05 * random.normal()) / rate_hz;
                all.push((at_s * self.sampling_rate_hz) as usize);
            }
        }
        all.retain(|t| *t < n);
        all
    }

    fn walk(&self, steps: &[usize], motions: &mut [Vec<f64>]) {
        if steps.is_empty() {
            return;
        }
        for (j, motion) in motions.iter_mut().enumerate() {
            let mut random = Random::new(self.seed, 300 + j as u64);
            let mut force = vec![0.0; motion.len()];
            for t in steps {
                force[*t] += 1.0 + 0.2 * random.normal();
            }
            let own = Oscillator::new(&self.modes[j], self.sampling_rate_hz, self.quantity);
            let walked: Vec<f64> = own.driven(force.into_iter()).collect();
            let scale = between(&mut random, 0.1, 0.6) * self.strengths[j] / root_mean_square(&walked);
            motion.iter_mut().zip(&walked).for_each(|(q, x)| *q += scale * x);
        }
    }

    /// Adds tones that come through the structure.
    fn hum(&self, motions: &mut [Vec<f64>]) {
        for (i, tone) in self.tones.iter().enumerate().filter(|(_, tone)| !tone.by_cable) {
            let mut random = Random::new(self.seed, 500 + i as u64);
            let n = motions[0].len();
            let factors: Vec<f64> = self.modes.iter().map(|_| random.normal()).collect();
            let runs = (tone.share * n as f64) as usize;
            let sine = |t: usize| match t < runs {
                true => (2.0 * PI * tone.frequency_hz * t as f64 / self.sampling_rate_hz).sin(),
                false => 0.0,
            };
            let sizes: Vec<Vec<f64>> = self
                .modes
                .iter()
                .zip(&factors)
                .map(|(mode, factor)| {
                    let own = Oscillator::new(mode, self.sampling_rate_hz, self.quantity);
                    own.driven((0..n).map(|t| factor * sine(t))).collect()
                })
                .collect();
            let wanted = match tone.over_mode {
                Some(mode) => tone.strength * self.strengths[mode],
                None => tone.strength * self.strengths.iter().map(|s| s * s).sum::<f64>().sqrt(),
            };
            let got = match tone.over_mode {
                Some(mode) => root_mean_square(&sizes[mode][..runs]),
                None => sizes
                    .iter()
                    .map(|q| root_mean_square(&q[..runs]).powi(2))
                    .sum::<f64>()
                    .sqrt(),
            };
            for (motion, size) in motions.iter_mut().zip(&sizes) {
                motion
                    .iter_mut()
                    .zip(size)
                    .for_each(|(q, x)| *q += wanted / got * x);
            }
        }
    }

    /// Adds noise, mains, a loose sensor, spikes, and errors of digitiser and clock to one channel.
    fn disturb(&self, c: usize, y: &mut [f64], (spread, step): (f64, f64)) {
        let mut random = Random::new(self.seed, 1000 + c as u64);
        let rate_hz = self.sampling_rate_hz;
        if let Some((_, ppm)) = self.clock.filter(|(channel, _)| *channel == c) {
            late(y, 1e-6 * ppm);
        }
        let rho = slow_pole(rate_hz);
        let (mut slow, sd) = (0.0, self.noise[c] * spread);
        for y in y.iter_mut() {
            slow = rho * slow + (1.0 - rho * rho).sqrt() * random.normal();
            *y += sd * (random.normal() + SLOW * self.noise_colour * slow);
        }
        for tone in self.tones.iter().filter(|tone| tone.by_cable) {
            let (phase, size) = (
                between(&mut random, 0.0, 2.0 * PI),
                log_between(&mut random, 0.3, 2.0),
            );
            let size = 2f64.sqrt() * size * tone.strength * spread;
            for (t, y) in y.iter_mut().enumerate() {
                *y += size * (2.0 * PI * tone.frequency_hz * t as f64 / rate_hz + phase).sin();
            }
        }
        if self.loose == Some(c) {
            let mut loose = false;
            for y in y.iter_mut() {
                if chance(&mut random, 1.0 / (40.0 * rate_hz)) {
                    loose = !loose;
                }
                if loose {
                    *y = 0.3 * *y + 1.5 * spread * random.normal();
                }
            }
        }
        if let Some((_, count)) = self.spikes.filter(|(channel, _)| *channel == c) {
            let end = 12.0 * spread;
            for _ in 0..count {
                let at = (random.uniform() * y.len() as f64) as usize;
                let sign = if chance(&mut random, 0.5) { 1.0 } else { -1.0 };
                y[at] = sign * end;
            }
            y.iter_mut().for_each(|y| *y = y.clamp(-end, end));
        }
        if step > 0.0 {
            y.iter_mut().for_each(|y| *y = (*y / step).round() * step);
        }
    }
}

/// Corner of the coloured sensor noise, Hz, and its largest standard deviation over that of the white noise.
const SLOW_HZ: f64 = 0.5;
const SLOW: f64 = 3.0;

fn slow_pole(rate_hz: f64) -> f64 {
    (-2.0 * PI * SLOW_HZ / rate_hz).exp()
}

/// Density of x_k = ρ x_(k-1) + √(1 - ρ²) w_k over that of w, at a frequency over the sampling rate.
fn lag_one(rho: f64, of_rate: f64) -> f64 {
    (1.0 - rho * rho) / (1.0 - 2.0 * rho * (2.0 * PI * of_rate).cos() + rho * rho)
}

/// Spectral density of the motion of a mode, one-sided.
struct Density {
    own: Oscillator,
    force: f64,
    colour: [f64; 2],
    rate_hz: f64,
}

impl Density {
    fn at(&self, frequency_hz: f64) -> f64 {
        self.of(self.own, frequency_hz)
    }

    /// The same for another mode under this force.
    fn of(&self, own: Oscillator, frequency_hz: f64) -> f64 {
        let [rho, coloured] = self.colour;
        let slow = lag_one(rho, frequency_hz / self.rate_hz);
        let force = (1.0 - coloured).powi(2) + coloured * coloured * slow;
        2.0 / self.rate_hz * self.force * force * own.gain(frequency_hz).powi(2)
    }
}

fn root_mean_square(x: &[f64]) -> f64 {
    (x.iter().map(|x| x * x).sum::<f64>() / x.len().max(1) as f64)
        .sqrt()
        .max(f64::MIN_POSITIVE)
}

/// Samples of a clock that is fast by `fast`: sample k is at k / (1 + fast), by cubic interpolation of four samples.
fn late(y: &mut [f64], fast: f64) {
    let read = y.to_vec();
    for (k, y) in y.iter_mut().enumerate() {
        let at = k as f64 / (1.0 + fast);
        let i = (at as usize).clamp(1, read.len() - 3);
        let x = at - i as f64;
        let [a, b, c, d] = [read[i - 1], read[i], read[i + 1], read[i + 2]];
        *y = b + 0.5 * x * (c - a + x * (2.0 * a - 5.0 * b + 4.0 * c - d + x * (3.0 * (b - c) + d - a)));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compares the periodogram of one mode near its peak with the density that decides which modes have enough energy.
    #[test]
    fn agrees_the_density_of_a_mode_with_its_periodogram() {
        let plan = UnkindPlan {
            walkers: (0, 2.0),
            vehicles: 0,
            drift: [0.0, 0.0],
            ..UnkindPlan::drawn(3)
        };
        let n = (plan.duration_s * plan.sampling_rate_hz) as usize;
        let mode = &plan.modes[0];
        let (motion, density) = plan.motion(0, mode, (&vec![1.0; n], 1.0));
        let rate_hz = plan.sampling_rate_hz;
        let step_hz = rate_hz / n as f64;
        let reach = (2.0 * mode.damping_ratio * mode.frequency_hz / step_hz).max(20.0) as i64;
        let (mut found, mut exact) = (0.0, 0.0);
        for i in -reach..=reach {
            let hz = mode.frequency_hz + i as f64 * step_hz;
            let turn = 2.0 * PI * hz / rate_hz;
            let sum = |f: fn(f64) -> f64| {
                motion
                    .iter()
                    .enumerate()
                    .map(|(t, q)| q * f(turn * t as f64))
                    .sum::<f64>()
            };
            found += 2.0 / (rate_hz * n as f64) * (sum(f64::cos).powi(2) + sum(f64::sin).powi(2));
            exact += density.at(hz);
        }
        assert!((found / exact - 1.0).abs() < 0.35, "{found} {exact}");
    }

    #[test]
    fn holds_one_seed_one_record() {
        let plan = UnkindPlan::drawn(11);
        assert_eq!(plan, UnkindPlan::drawn(11));
        let (a, b) = (plan.make().unwrap(), plan.make().unwrap());
        assert_eq!(a.record.samples(0), b.record.samples(0));
        assert_ne!(plan.modes, UnkindPlan::drawn(12).modes);
        assert_ne!(a.record.channels()[0].quantity, crate::signal::Quantity::Unknown);
    }
}
