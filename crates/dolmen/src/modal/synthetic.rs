//! Simulated ambient records with exactly known poles, which measure the accuracy of all methods of this chapter.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | q, q̇ | `q`, `v` | modal coordinate and its velocity | m, m/s |
//! | ω, ζ | `omega`, `zeta` | natural frequency, damping ratio | rad/s, - |
//! | p | `p` | white-noise modal force per modal mass, constant within a sample | m/s² |

use super::ModalError;
use crate::numeric::Random;
use crate::signal::{Channel, Quantity, Record};
use dolmen_linalg::{Complex64, Matrix, generalized_symmetric_eigen};
use std::f64::consts::PI;

/// Number of decay times before the first stored sample: e⁻⁸ = 0.03 % of the initial transient remains.
const DECAYS_BEFORE_START: f64 = 8.0;

/// One mode of a simulated record, with exact values.
#[derive(Clone, Debug, PartialEq)]
pub struct MadeMode {
    /// Natural (undamped) frequency, Hz, below half the sampling rate.
    pub frequency_hz: f64,
    /// Damping ratio, between 0 and 1.
    pub damping_ratio: f64,
    /// One component per channel.
    pub shape: Vec<f64>,
}

/// Description of a simulated ambient record.
#[derive(Clone, Debug, PartialEq)]
pub struct MadeRecord {
    /// The modes, all with shapes of the same length.
    pub modes: Vec<MadeMode>,
    /// Duration, s.
    pub duration_s: f64,
    /// Sampling rate, Hz.
    pub sampling_rate_hz: f64,
    /// Measured quantity of the channels; default acceleration (`Unknown` gives acceleration).
    pub quantity: Quantity,
    /// Standard deviation of the white sensor noise over that of the channel's motion; default 0.1 (20 dB).
    pub noise_ratio: f64,
    /// Seed; the same seed gives the same record.
    pub seed: u64,
}

impl Default for MadeRecord {
    fn default() -> Self {
        MadeRecord {
            modes: Vec::new(),
            duration_s: 600.0,
            sampling_rate_hz: 100.0,
            quantity: Quantity::Acceleration,
            noise_ratio: 0.1,
            seed: 0,
        }
    }
}

impl MadeRecord {
    /// The record: each mode is a single degree of freedom under its own white-noise force; white sensor noise is
    /// added.
    ///
    /// ```text
    /// q̈ + 2ζω q̇ + ω² q = p,   p constant over each sample:   [q v]ₖ₊₁ = Ad [q v]ₖ + Bd pₖ   exact (zero-order hold)
    /// yₖ = Σ φ x + noise,      x = q, v, or p - 2ζω v - ω² q     shape: channels × 1
    /// ```
    ///
    /// # Errors
    /// [`ModalError::MadeMode`] for a mode out of range; [`ModalError::Record`] if there is nothing to record.
    ///
    /// # Example
    /// ```
    /// use dolmen::modal::{MadeMode, MadeRecord};
    /// let mode = MadeMode { frequency_hz: 2.0, damping_ratio: 0.01, shape: vec![1.0, -0.5] };
    /// let record = MadeRecord { modes: vec![mode], duration_s: 60.0, ..Default::default() }.make()?;
    /// assert_eq!((record.channels().len(), record.length()), (2, 6000));
    /// # Ok::<(), dolmen::modal::ModalError>(())
    /// ```
    pub fn make(&self) -> Result<Record, ModalError> {
        let channels = self.modes.first().map_or(0, |m| m.shape.len());
        for (mode, made) in self.modes.iter().enumerate() {
            let nyquist_hz = 0.5 * self.sampling_rate_hz;
            let frequency = made.frequency_hz > 0.0 && made.frequency_hz < nyquist_hz;
            let damping = made.damping_ratio > 0.0 && made.damping_ratio < 1.0;
            let shape = made.shape.len() == channels && made.shape.iter().all(|x| x.is_finite());
            if !(frequency && damping && shape) {
                return Err(ModalError::MadeMode {
                    mode,
                    frequency_hz: made.frequency_hz,
                    damping_ratio: made.damping_ratio,
                    nyquist_hz,
                });
            }
        }
        let length = (self.duration_s * self.sampling_rate_hz).round() as usize;
        let mut samples = vec![0.0; channels * length];
        for (index, mode) in self.modes.iter().enumerate() {
            let motion = self.motion(mode, Random::new(self.seed, index as u64), length);
            for (channel, phi) in samples.chunks_exact_mut(length.max(1)).zip(&mode.shape) {
                for (y, x) in channel.iter_mut().zip(&motion) {
                    *y += phi * x;
                }
            }
        }
        for (c, channel) in samples.chunks_exact_mut(length.max(1)).enumerate() {
            let mut random = Random::new(self.seed, (self.modes.len() + c) as u64);
            let power = channel.iter().map(|y| y * y).sum::<f64>() / length as f64;
            let sd = self.noise_ratio * power.sqrt();
            for y in channel {
                *y += sd * random.normal();
            }
        }
        let named = (0..channels).map(|c| Channel {
            quantity: match self.quantity {
                Quantity::Unknown => Quantity::Acceleration,
                known => known,
            },
            ..Channel::named(format!("made {}", c + 1))
        });
        Ok(Record::from_contiguous(
            named.collect(),
            samples,
            self.sampling_rate_hz,
        )?)
    }

    fn motion(&self, mode: &MadeMode, mut random: Random, length: usize) -> Vec<f64> {
        let own = Oscillator::new(mode, self.sampling_rate_hz, self.quantity);
        let before = own.samples_before();
        let force = (0..before + length).map(|_| random.normal());
        own.driven(force).skip(before).collect()
    }
}

/// One mode as a recursion, exact for forces that are constant within a sample.
#[derive(Clone, Copy, Debug)]
pub(super) struct Oscillator {
    omega: f64,
    zeta: f64,
    dt: f64,
    quantity: Quantity,
    /// Ad = e^(A dt)
    ad: [[f64; 2]; 2],
    /// Bd = (1/ω²) (x_static - Ad x_static) with x_static = [1 0]
    bd: [f64; 2],
}

impl Oscillator {
    pub(super) fn new(mode: &MadeMode, sampling_rate_hz: f64, quantity: Quantity) -> Self {
        let (omega, zeta) = (2.0 * PI * mode.frequency_hz, mode.damping_ratio);
        let dt = 1.0 / sampling_rate_hz;
        let omega_d = omega * (1.0 - zeta * zeta).sqrt();
        let decay = (-zeta * omega * dt).exp();
        let (s, c) = (omega_d * dt).sin_cos();
        let (s, c) = (decay * s / omega_d, decay * c);
        let ad = [
            [c + zeta * omega * s, s],
            [-omega * omega * s, c - zeta * omega * s],
        ];
        Oscillator {
            omega,
            zeta,
            dt,
            quantity,
            ad,
            bd: [(1.0 - ad[0][0]) / (omega * omega), -ad[1][0] / (omega * omega)],
        }
    }

    /// Number of samples after which the start has no effect.
    pub(super) fn samples_before(&self) -> usize {
        (DECAYS_BEFORE_START / (self.zeta * self.omega * self.dt)).ceil() as usize
    }

    /// Measured response to these forces, starting at rest.
    pub(super) fn driven(self, forces: impl Iterator<Item = f64>) -> impl Iterator<Item = f64> {
        let (ad, bd) = (self.ad, self.bd);
        forces.scan([0.0, 0.0], move |[q, v], p| {
            let y = match self.quantity {
                Quantity::Displacement => *q,
                Quantity::Velocity => *v,
                Quantity::Acceleration | Quantity::Unknown => {
                    p - 2.0 * self.zeta * self.omega * *v - self.omega * self.omega * *q
                }
            };
            (*q, *v) = (
                ad[0][0] * *q + ad[0][1] * *v + bd[0] * p,
                ad[1][0] * *q + ad[1][1] * *v + bd[1] * p,
            );
            Some(y)
        })
    }

    /// Modulus of C (z - Ad)⁻¹ Bd + D at z = e^(iω dt).
    pub(super) fn gain(&self, frequency_hz: f64) -> f64 {
        let z = Complex64::from_polar(1.0, 2.0 * PI * frequency_hz * self.dt);
        let ([[a, b], [c, d]], [p, q]) = (self.ad, self.bd);
        let determinant = (z - a) * (z - d) - b * c;
        let (x, y) = ((z - d) * p + b * q, c * p + (z - a) * q);
        let omega = self.omega;
        let [cx, cy, dp] = match self.quantity {
            Quantity::Displacement => [1.0, 0.0, 0.0],
            Quantity::Velocity => [0.0, 1.0, 0.0],
            Quantity::Acceleration | Quantity::Unknown => [-omega * omega, -2.0 * self.zeta * omega, 1.0],
        };
        ((cx * x + cy * y) / determinant + dp).norm()
    }
}

/// Reference structures whose simulated records are used to measure the accuracy in this chapter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReferenceCase {
    /// Two floors, 1.1 and 4.2 Hz, ζ 2 %: 2 channels × 10 min × 100 Hz.
    ShearChain,
    /// Four floors × (x, y), y 4 % stiffer so that pairs of modes are 2 % apart, axes rotated by 30°, f1 1.5 Hz, ζ 1
    /// %: 8 channels × 10 min × 100 Hz.
    ClosePairs,
    /// Four floors × (x, y, rotation) with eccentric mass, f1 1.2 Hz, ζ 1.2 %, three sensors per floor at two corners:
    /// 12 channels × 1 h × 200 Hz.
    Twisting,
    /// Sixteen floors × (x, y); storeys, axes and pairs as in `ClosePairs`, f1 0.8 Hz, ζ 1 %: 32 channels × 1 h × 200
    /// Hz.
    Tower,
}

impl ReferenceCase {
    /// Plan of a simulated record: `made.make()` gives the record, `made.modes` the true modes.
    ///
    /// # Errors
    /// [`ModalError::Linalg`], which does not occur for these fixed buildings.
    pub fn made(self, seed: u64) -> Result<MadeRecord, ModalError> {
        Ok(match self {
            ReferenceCase::ShearChain => MadeRecord {
                modes: [(1.1, [0.5, 1.0]), (4.2, [1.0, -0.5])]
                    .map(|(frequency_hz, shape)| MadeMode {
                        frequency_hz,
                        damping_ratio: 0.02,
                        shape: shape.to_vec(),
                    })
                    .to_vec(),
                seed,
                ..Default::default()
            },
            ReferenceCase::ClosePairs => MadeRecord {
                modes: close_pairs(4, 1.5)?,
                seed,
                ..Default::default()
            },
            ReferenceCase::Twisting => MadeRecord {
                modes: twisting()?,
                duration_s: 3600.0,
                sampling_rate_hz: 200.0,
                seed,
                ..Default::default()
            },
            ReferenceCase::Tower => MadeRecord {
                modes: close_pairs(16, 0.8)?,
                duration_s: 3600.0,
                sampling_rate_hz: 200.0,
                seed,
                ..Default::default()
            },
        })
    }
}

/// Entry of the stiffness of a shear building; storey stiffness falls from 1 at the ground to 0.6 at the top.
fn shear_stiffness(i: usize, j: usize, floors: usize) -> f64 {
    let storey = |k: usize| 1.0 - 0.4 * k as f64 / (floors - 1) as f64;
    let above = |k: usize| if k + 1 < floors { storey(k + 1) } else { 0.0 };
    match i.abs_diff(j) {
        0 => storey(i) + above(i),
        1 => -storey(i.max(j)),
        _ => 0.0,
    }
}

/// Modes of K with unit masses, scaled to the first frequency `first_hz`; the sensors measure `sensors` × coordinates.
fn modes_of(
    k: &Matrix,
    sensors: &Matrix,
    first_hz: f64,
    damping_ratio: f64,
) -> Result<Vec<MadeMode>, ModalError> {
    let e = generalized_symmetric_eigen(k, &Matrix::identity(k.rows()))?;
    let scale = first_hz / e.values[0].sqrt();
    Ok((0..k.rows())
        .map(|j| MadeMode {
            frequency_hz: scale * e.values[j].sqrt(),
            damping_ratio,
            shape: sensors.times(e.vectors.column(j)),
        })
        .collect())
}

fn close_pairs(floors: usize, first_hz: f64) -> Result<Vec<MadeMode>, ModalError> {
    const STIFFER_Y: f64 = 1.04;
    let (s, c) = (PI / 6.0).sin_cos();
    let k = Matrix::from_fn(2 * floors, 2 * floors, |i, j| {
        let factor = if i % 2 == 1 { STIFFER_Y } else { 1.0 };
        if i % 2 == j % 2 {
            factor * shear_stiffness(i / 2, j / 2, floors)
        } else {
            0.0
        }
    });
    let turned = Matrix::from_fn(2 * floors, 2 * floors, |i, j| {
        match (i / 2 == j / 2, i % 2, j % 2) {
            (false, ..) => 0.0,
            (true, 0, 0) | (true, 1, 1) => c,
            (true, 0, _) => -s,
            (true, ..) => s,
        }
    });
    modes_of(&k, &turned, first_hz, 0.01)
}

fn twisting() -> Result<Vec<MadeMode>, ModalError> {
    const FLOORS: usize = 4;
    // lengths in radii of gyration, so that each coordinate (x, y, rotation × radius) has unit mass
    const STIFFER_Y: f64 = 1.04;
    const TWIST: f64 = 1.5; // twisting over sway stiffness: uncoupled frequencies 22 % apart
    const OFF_CENTRE: [f64; 2] = [0.12, 0.06];
    const CORNER: f64 = 1.2; // half the side of a square floor: 1.22 radii of gyration
    let [ex, ey] = OFF_CENTRE;
    let storey = [
        [1.0, 0.0, -ey],
        [0.0, STIFFER_Y, STIFFER_Y * ex],
        [-ey, STIFFER_Y * ex, TWIST],
    ];
    let sensor = [[1.0, 0.0, CORNER], [0.0, 1.0, CORNER], [0.0, 1.0, -CORNER]];
    let n = 3 * FLOORS;
    let k = Matrix::from_fn(n, n, |i, j| {
        storey[i % 3][j % 3] * shear_stiffness(i / 3, j / 3, FLOORS)
    });
    let sensors = Matrix::from_fn(
        n,
        n,
        |i, j| if i / 3 == j / 3 { sensor[i % 3][j % 3] } else { 0.0 },
    );
    modes_of(&k, &sensors, 1.2, 0.012)
}
