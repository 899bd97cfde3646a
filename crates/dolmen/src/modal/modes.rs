//! Result of the identification, common to all methods.

use super::indicators::{normalized, phase_collinearity};
use super::{Accepted, Kurtosis, ModalError, Wander};
use crate::signal::{Channel, Processing};
use dolmen_linalg::Complex64;
use std::f64::consts::PI;

/// Method of identification.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Frequency domain decomposition.
    Fdd,
    /// Enhanced frequency domain decomposition: with damping, from the singular values about a peak.
    Efdd,
    /// Frequency-spatial domain decomposition: with damping, from the spectrum projected on the shape.
    Fsdd,
    /// Covariance-driven stochastic subspace identification.
    SsiCov,
    /// Data-driven stochastic subspace identification.
    SsiData,
    /// Bayesian operational modal analysis: covariance-driven subspace identification, with the modes then fitted to the nearby Fourier
    /// lines by maximum likelihood.
    Bayoma,
    /// Poly-reference least squares in the frequency domain.
    Plscf,
    /// Eigensystem realization of a free decay.
    Era,
    /// Observer/Kalman filter identification: realization of the observer of a structure with measured inputs.
    Okid,
}

impl Method {
    /// All methods.
    pub const ALL: [Method; 9] = [
        Method::Fdd,
        Method::Efdd,
        Method::Fsdd,
        Method::SsiCov,
        Method::SsiData,
        Method::Bayoma,
        Method::Plscf,
        Method::Era,
        Method::Okid,
    ];

    /// Name of the method in a project file, such as "ssi-cov".
    pub fn name(self) -> &'static str {
        match self {
            Method::Fdd => "fdd",
            Method::Efdd => "efdd",
            Method::Fsdd => "fsdd",
            Method::SsiCov => "ssi-cov",
            Method::SsiData => "ssi-data",
            Method::Bayoma => "bayoma",
            Method::Plscf => "plscf",
            Method::Era => "era",
            Method::Okid => "okid",
        }
    }

    /// The method with this name.
    pub fn named(name: &str) -> Option<Method> {
        Method::ALL.into_iter().find(|method| method.name() == name)
    }
}

/// One mode: estimates, standard deviations, and data for an assessment.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// Natural (undamped) frequency, Hz.
    pub frequency_hz: f64,
    /// Standard deviation of the frequency, Hz; `None` if the method gives none.
    pub frequency_sd_hz: Option<f64>,
    /// Change of the frequency by each block of time, Hz. The sum of the squares is the variance from the scatter of the blocks. Modes of
    /// one identification have the same blocks, and the sum of the products of two modes is their covariance. Empty if the method gives
    /// none.
    pub frequency_changes_hz: Vec<f64>,
    /// Damping ratio.
    pub damping_ratio: Option<f64>,
    /// Standard deviation of the damping ratio.
    pub damping_ratio_sd: Option<f64>,
    /// One component per channel; the largest is 1 + 0i.
    pub shape: Vec<Complex64>,
    /// Standard deviation of the modulus of each component of the shape.
    pub shape_sd: Option<Vec<f64>>,
    /// Modal phase collinearity, 0 to 1: 1 is a real shape.
    pub phase_collinearity: f64,
    /// Number of observed cycles, N_c = f T. For a long record the lower bound is sd(ζ)/ζ = 1/√(2πζN_c) (Au 2014).
    pub cycles: f64,
    /// Model orders with a stable pole of this mode (empty for FDD).
    pub orders: Vec<usize>,
    /// Steadiness of the amplitude near the frequency; `None` if the record is too short, or if the test was not requested.
    pub kurtosis: Option<Kurtosis>,
    /// Comparison of the changes of amplitude and phase; `None` under the same conditions as the kurtosis.
    pub wander: Option<Wander>,
    /// Relative bias of the damping ratio due to the window of the spectrum, already removed; `None` for methods without a window.
    pub window_bias: Option<f64>,
    /// Set if the user requested the mode although a test refused it. Such a mode is not counted as found.
    pub accepted: Option<Accepted>,
}

/// All modes found in one record, by frequency.
#[derive(Clone, Debug, PartialEq)]
pub struct Modes {
    /// Ascending in frequency.
    pub modes: Vec<Mode>,
    /// The channels of the components of the shapes, in order.
    pub channels: Vec<Channel>,
    /// Method of identification.
    pub method: Method,
    /// Duration of the record, s.
    pub duration_s: f64,
    /// Processing history of the record.
    pub history: Vec<Processing>,
}

#[cfg(test)]
impl Mode {
    /// A mode of a long record without deviations, for tests.
    pub(crate) fn made(frequency_hz: f64, damping_ratio: f64, shape: &[f64]) -> Self {
        Mode {
            frequency_hz,
            frequency_sd_hz: None,
            frequency_changes_hz: Vec::new(),
            damping_ratio: Some(damping_ratio),
            damping_ratio_sd: None,
            shape: shape.iter().copied().map(Complex64::from).collect(),
            shape_sd: None,
            phase_collinearity: 1.0,
            cycles: 600.0 * frequency_hz,
            orders: Vec::new(),
            kurtosis: None,
            wander: None,
            window_bias: None,
            accepted: None,
        }
    }
}

impl Mode {
    /// Keeps only the components of these channels, scaled so that the largest is 1.
    pub(super) fn keep_channels(&mut self, kept: &[usize]) {
        let shape: Vec<Complex64> = kept.iter().map(|&c| self.shape[c]).collect();
        let most = shape.iter().map(|z| z.norm()).fold(0.0, f64::max);
        if let Some(sd) = &mut self.shape_sd {
            *sd = kept
                .iter()
                .map(|&c| sd[c] / most.max(f64::MIN_POSITIVE))
                .collect();
        }
        self.shape = normalized(&shape);
        self.phase_collinearity = phase_collinearity(&self.shape);
    }

    /// Whether the tests found the mode; `false` if only the user requested it.
    pub fn is_found(&self) -> bool {
        self.accepted.is_none()
    }

    /// Whether the mode is a machine: its amplitude is too steady for random forces, or amplitude and phase vary in a way that is
    /// impossible under random forces.
    pub fn harmonic(&self) -> bool {
        self.wanders() || self.kurtosis.is_some_and(|k| k.harmonic())
    }

    /// Whether the ratio of the changes of amplitude and phase is impossible under random forces.
    pub(super) fn wanders(&self) -> bool {
        self.wander.is_some_and(|of| of.is_machine())
    }

    /// Degrees of freedom of the standard deviations; `time_blocks` is the number of equally strong blocks behind them, below 2 if they are
    /// assumed exact.
    ///
    /// ```text
    /// 1/ν = 2/(b − 1) + (sd ζ/ζ)²/2        b blocks of time, ν one at least
    /// ```
    /// The selected order has a small standard deviation, so its value is low by chance: by 8 % in one minute at 1.5 to 6 Hz, 5 % in three minutes,
    /// none in ten (measured). Half of the degrees of freedom compensate for this. The standard deviation of a frequency is proportional to √ζ, so
    /// its relative error is that of √ζ.
    pub fn degrees_of_freedom(&self, time_blocks: usize) -> f64 {
        if time_blocks < 2 {
            return f64::INFINITY;
        }
        let of_damping = self.damping_ratio_sd.zip(self.damping_ratio);
        let c = of_damping.map_or(0.0, |(sd, zeta)| sd / zeta);
        (1.0 / (2.0 / (time_blocks - 1) as f64 + 0.5 * c * c)).max(1.0)
    }

    /// Lower bound of the standard deviation of the frequency for a long record, f √(ζ/2πN_c), Hz; infinite without a damping ratio.
    ///
    /// # Source
    /// Au (2014) Mech. Syst. Signal Process. 48:15-33.
    pub fn frequency_floor_hz(&self) -> f64 {
        match self.damping_ratio {
            Some(zeta) if zeta > 0.0 => self.frequency_hz * (zeta / (2.0 * PI * self.cycles)).sqrt(),
            _ => f64::INFINITY,
        }
    }

    /// Whether the half-power bands of the two modes overlap: |f - f'| < ζf + ζ'f'.
    pub fn overlaps(&self, other: &Mode) -> bool {
        let half_width_hz = |m: &Mode| m.damping_ratio.unwrap_or(0.0) * m.frequency_hz;
        (self.frequency_hz - other.frequency_hz).abs() < half_width_hz(self) + half_width_hz(other)
    }

    /// Lower bound of the relative standard deviation of the damping ratio for a long record, 1/√(2πζN_c); infinite without a damping
    /// ratio.
    ///
    /// # Source
    /// Au (2014) Mech. Syst. Signal Process. 48:15-33.
    pub fn damping_floor(&self) -> f64 {
        match self.damping_ratio {
            Some(zeta) if zeta > 0.0 => 1.0 / (2.0 * PI * zeta * self.cycles).sqrt(),
            _ => f64::INFINITY,
        }
    }
}

impl Modes {
    /// The mode nearest to `frequency_hz`, if it lies within `within_hz`.
    ///
    /// # Errors
    /// [`ModalError::NoModeAt`] if there is none; the result is never another mode.
    pub fn nearest(&self, frequency_hz: f64, within_hz: f64) -> Result<&Mode, ModalError> {
        let apart = |m: &Mode| (m.frequency_hz - frequency_hz).abs();
        self.modes
            .iter()
            .filter(|m| apart(m) <= within_hz)
            .min_by(|a, b| apart(a).total_cmp(&apart(b)))
            .ok_or_else(|| ModalError::NoModeAt {
                given_hz: frequency_hz,
                within_hz,
                found_hz: self.modes.iter().map(|m| m.frequency_hz).collect(),
            })
    }
}
