//! The mean wind of a code and its turbulence along the wind, by height.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | V | `mean_speed_m_s` | 10-minute mean | m/s |
//! | I_u | `intensity` | standard deviation of the speed along the wind over V | |
//! | L | `length_m` | integral length of the turbulence along the wind | m |
//! | f | `reduced` | n L/V | |
//! | n S_u/σ_u² | `TurbulenceSpectrum::normalised` | one-sided, ∫ S_u dn = σ_u² | |

/// The wind at a height.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Turbulence {
    /// V, m/s.
    pub mean_speed_m_s: f64,
    /// I_u.
    pub intensity: f64,
    /// L, m.
    pub length_m: f64,
}

/// Distribution of the power of the turbulence along the wind over frequency.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TurbulenceSpectrum {
    /// Kaimal's form in EN 1991-1-4:2005, B.2: 6.8 f/(1 + 10.2 f)^(5/3).
    Kaimal,
    /// Von Kármán: 4 f/(1 + 70.8 f²)^(5/6).
    VonKarman,
}

impl TurbulenceSpectrum {
    /// n S_u(n)/σ_u² at f = n L/V.
    pub fn normalised(self, reduced: f64) -> f64 {
        match self {
            TurbulenceSpectrum::Kaimal => 6.8 * reduced / (1.0 + 10.2 * reduced).powf(5.0 / 3.0),
            TurbulenceSpectrum::VonKarman => 4.0 * reduced / (1.0 + 70.8 * reduced * reduced).powf(5.0 / 6.0),
        }
    }
}

impl Turbulence {
    /// One-sided density of the speed along the wind, (m/s)²/Hz, at a frequency above 0.
    pub fn density(&self, spectrum: TurbulenceSpectrum, frequency_hz: f64) -> f64 {
        let sigma = self.intensity * self.mean_speed_m_s;
        let reduced = frequency_hz * self.length_m / self.mean_speed_m_s;
        sigma * sigma * spectrum.normalised(reduced) / frequency_hz
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_both_spectra_hold_the_whole_variance() {
        // ∫ S_u/σ_u² dn over ln f, by the trapezoidal rule from e^−30 to e^60
        for (spectrum, tolerance) in [
            (TurbulenceSpectrum::Kaimal, 1e-9),
            (TurbulenceSpectrum::VonKarman, 2e-4),
        ] {
            let step = 1e-3;
            let sum: f64 = (0..90_000)
                .map(|k| spectrum.normalised((-30.0 + step * f64::from(k)).exp()) * step)
                .sum();
            // Kaimal: 6.8/10.2 · 3/2; von Kármán rounds 70.8 and 4
            assert!((sum - 1.0).abs() < tolerance, "{spectrum:?} {sum}");
        }
    }
}
