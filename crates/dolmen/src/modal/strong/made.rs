//! A simulated record of an earthquake: two storeys whose stiffness changes during the shaking, with the motion
//! before and after.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | r | `softened` | stiffness over the initial stiffness | – |
//! | x, v | `state` | displacement and velocity of the floors relative to the ground | m, m/s |

use crate::numeric::Random;
use crate::signal::{Channel, Quantity, Record, SignalError, low_pass};
use std::f64::consts::{PI, TAU};

/// Mass of each storey, kg; stiffness of each storey, N/m: the initial first mode is at 2.5 Hz.
const MASS_KG: f64 = 10e3;
const STIFFNESS: f64 = 6.459e6;
const FINER: usize = 4;
const RATE_HZ: f64 = 100.0;
/// Highest frequency of the shaking, Hz.
const CORNER_HZ: f64 = 12.0;

/// Time course of a simulated earthquake.
#[derive(Clone, Debug, PartialEq)]
pub struct MadeEarthquake {
    /// Seed of all random values.
    pub seed: u64,
    /// Duration of the record, s.
    pub duration_s: f64,
    /// Arrival of the earthquake, s.
    pub arrival_s: f64,
    /// Rise time, s.
    pub rise_s: f64,
    /// Duration of the strong part, s.
    pub plateau_s: f64,
    /// Time of the decay to 1/e after the strong part, s.
    pub fall_s: f64,
    /// Peak acceleration of the ground, m/s².
    pub peak_m_s2: f64,
    /// Root mean square of ground and sensor noise without the earthquake, m/s².
    pub noise_m_s2: f64,
    /// Ground acceleration at 100 Hz that replaces the noise with this envelope, scaled to the peak; empty: no
    /// replacement.
    pub ground_m_s2: Vec<f64>,
    /// Stiffness in the earthquake, and after it, over the initial stiffness.
    pub softened: [f64; 2],
}

impl Default for MadeEarthquake {
    fn default() -> Self {
        MadeEarthquake {
            seed: 1,
            duration_s: 400.0,
            arrival_s: 150.0,
            rise_s: 2.0,
            plateau_s: 8.0,
            fall_s: 6.0,
            peak_m_s2: 2.0,
            noise_m_s2: 2e-3,
            ground_m_s2: Vec::new(),
            softened: [0.7, 0.9],
        }
    }
}

impl MadeEarthquake {
    /// Initial damping ratio of both modes.
    pub const DAMPING: f64 = 0.02;

    /// Frequencies with this share of the stiffness, Hz, in closed form.
    ///
    /// ```text
    /// ω² = (3 ∓ √5)/2 · r k/m
    /// ```
    pub fn frequencies_hz(softened: f64) -> [f64; 2] {
        let of = softened * STIFFNESS / MASS_KG;
        [-1.0, 1.0].map(|sign| (0.5 * (3.0 + sign * 5f64.sqrt()) * of).sqrt() / TAU)
    }

    /// Channels "ground", "floor", "roof": absolute accelerations, m/s², at 100 Hz.
    ///
    /// # Errors
    /// [`SignalError`] of a record that is too short for its filter.
    pub fn make(&self) -> Result<Record, SignalError> {
        let rate_hz = RATE_HZ * FINER as f64;
        let steps = (self.duration_s * rate_hz) as usize;
        let white = |stream: u64| -> Vec<f64> {
            let mut random = Random::new(self.seed, stream);
            (0..steps).map(|_| random.normal()).collect()
        };
        let names = ["ground", "still", "low", "high"].map(Channel::named).to_vec();
        let smooth = low_pass(
            Record::new(names, (0..4).map(white).collect(), rate_hz)?,
            CORNER_HZ,
            4,
        )?;
        let ground = self.ground(smooth.samples(0), rate_hz);
        let still = scaled(smooth.samples(1), self.noise_m_s2);
        let wind = [2, 3].map(|of| scaled(smooth.samples(of), self.noise_m_s2));
        let [w1, w2] = Self::frequencies_hz(1.0).map(|hz| TAU * hz);
        let b = 2.0 * Self::DAMPING / (w1 + w2);
        let a = b * w1 * w2;
        let mut state = [[0.0; 2]; 2];
        let mut samples: [Vec<f64>; 3] = Default::default();
        for step in 0..steps - 1 {
            let k = STIFFNESS / MASS_KG * self.stiffness_at(step as f64 / rate_hz);
            let forces = |at: usize| [ground[at] + still[at], wind[0][at], wind[1][at]];
            let rate = |[x, v]: &[[f64; 2]; 2], [g, p, q]: [f64; 3]| {
                let r = [x[0] + b * v[0], x[1] + b * v[1]];
                [
                    p - g - k * (2.0 * r[0] - r[1]) - a * v[0],
                    q - g - k * (r[1] - r[0]) - a * v[1],
                ]
            };
            if step % FINER == 0 {
                let (now, f) = (rate(&state, forces(step)), forces(step));
                for (samples, x) in samples.iter_mut().zip([f[0], now[0] + f[0], now[1] + f[0]]) {
                    samples.push(x);
                }
            }
            let (now, next) = (forces(step), forces(step + 1));
            let middle = [0, 1, 2].map(|i| 0.5 * (now[i] + next[i]));
            let h = 1.0 / rate_hz;
            let moved = |of: [f64; 2], by: [f64; 2], h: f64| [of[0] + h * by[0], of[1] + h * by[1]];
            let [x, v] = state;
            let a1 = rate(&state, now);
            let v2 = moved(v, a1, 0.5 * h);
            let a2 = rate(&[moved(x, v, 0.5 * h), v2], middle);
            let v3 = moved(v, a2, 0.5 * h);
            let a3 = rate(&[moved(x, v2, 0.5 * h), v3], middle);
            let v4 = moved(v, a3, h);
            let a4 = rate(&[moved(x, v3, h), v4], next);
            let mean =
                |i: usize, of: [[f64; 2]; 4]| (of[0][i] + 2.0 * of[1][i] + 2.0 * of[2][i] + of[3][i]) / 6.0;
            let by = |of: [[f64; 2]; 4]| [mean(0, of), mean(1, of)];
            state = [
                moved(x, by([v, v2, v3, v4]), h),
                moved(v, by([a1, a2, a3, a4]), h),
            ];
        }
        let mut random = Random::new(self.seed, 9);
        for x in samples.iter_mut().flatten() {
            *x += 0.2 * self.noise_m_s2 * random.normal();
        }
        let channel = |(at, name): (usize, &str)| Channel {
            quantity: Quantity::Acceleration,
            position_m: Some([0.0, 0.0, 3.0 * at as f64]),
            direction: Some([1.0, 0.0, 0.0]),
            ..Channel::named(name)
        };
        let channels = ["ground", "floor", "roof"].into_iter().enumerate().map(channel);
        Record::new(channels.collect(), samples.to_vec(), RATE_HZ)
    }

    /// The stiffness falls as the earthquake rises, and recovers as it decays.
    fn stiffness_at(&self, at_s: f64) -> f64 {
        let [during, after] = self.softened;
        let turn = |from: f64, to: f64, share: f64| {
            from + (to - from) * (0.5 - 0.5 * (PI * share.clamp(0.0, 1.0)).cos())
        };
        let down = turn(1.0, during, (at_s - self.arrival_s) / self.rise_s.max(0.5));
        let strong_s = match self.ground_m_s2.len() {
            0 => self.rise_s + self.plateau_s + 2.0 * self.fall_s,
            samples => samples as f64 / RATE_HZ,
        };
        turn(down, after, (at_s - self.arrival_s - strong_s) / 3.0)
    }

    /// The shaking alone, m/s².
    fn ground(&self, noise: &[f64], rate_hz: f64) -> Vec<f64> {
        let envelope = |t: f64| match t {
            t if t < 0.0 => 0.0,
            t if t < self.rise_s => (t / self.rise_s).powi(2),
            t if t < self.rise_s + self.plateau_s => 1.0,
            t => (-(t - self.rise_s - self.plateau_s) / self.fall_s).exp(),
        };
        let given = |t: f64| {
            let at = t * RATE_HZ;
            let (i, part) = (at.floor() as usize, at - at.floor());
            let of = |i: usize| self.ground_m_s2.get(i).copied().unwrap_or(0.0);
            (1.0 - part) * of(i) + part * of(i + 1)
        };
        let shaken: Vec<f64> = noise
            .iter()
            .enumerate()
            .map(|(step, x)| {
                let t = step as f64 / rate_hz - self.arrival_s;
                match self.ground_m_s2.is_empty() {
                    true => x * envelope(t),
                    false if t < 0.0 => 0.0,
                    false => given(t),
                }
            })
            .collect();
        let peak = shaken.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let scale = self.peak_m_s2 / peak.max(f64::MIN_POSITIVE);
        shaken.into_iter().map(|x| scale * x).collect()
    }
}

/// A noise of this root mean square.
fn scaled(noise: &[f64], to: f64) -> Vec<f64> {
    let square = noise.iter().map(|x| x * x).sum::<f64>() / noise.len() as f64;
    noise.iter().map(|x| x * to / square.sqrt()).collect()
}
