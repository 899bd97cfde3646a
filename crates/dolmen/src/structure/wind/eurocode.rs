//! Wind by EN 1991-1-4:2005, with the structural factor of its Annex B.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | v_b | `basic_speed_m_s` | 10-minute mean at 10 m over terrain II, once in 50 years, with direction and season | m/s |
//! | c_o | `orography` | factor on the speed for hills | |
//! | k_r | `terrain_factor` | 0.19 (z_0/0.05)^0.07 | |
//! | I_v | `turbulence` | 1/(c_o ln(z/z_0)), k_I = 1 | |
//! | n, δ | `n`, `delta` | lowest natural frequency; logarithmic decrement, 2π ζ | Hz, |
//! | L, f_L, S_L | `length_scale`, `f_l`, `spectrum` | of turbulence at z_s | m, , |
//! | B², R² | `background`, `resonant` | | |

use super::error::positive;
use super::pressure::{Profile, Resonance, WindBody, WindPressure, velocity_pressure_pa};
use super::{Turbulence, TurbulenceSpectrum, WindError};
use std::f64::consts::PI;

/// Terrain of EN 1991-1-4:2005, table 4.1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EurocodeTerrain {
    /// Sea, coast to the open sea.
    Zero,
    /// Lakes, flat land without obstacles.
    I,
    /// Grass and isolated obstacles.
    Ii,
    /// Villages, suburbs, forest.
    Iii,
    /// Towns: buildings higher than 15 m on at least 15 % of the ground.
    Iv,
}

/// A mean wind according to EN 1991-1-4.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EurocodeWind {
    /// v_b, m/s.
    pub basic_speed_m_s: f64,
    /// Terrain.
    pub terrain: EurocodeTerrain,
    /// c_o; 1 on flat land.
    pub orography: f64,
    /// ρ, kg/m³; 1.25 in the code.
    pub air_density_kg_m3: f64,
}

/// Height at which the profile of the code ends, m (4.3.2).
const HEIGHT_MOST_M: f64 = 200.0;
/// Frequency above which a structure is stiff, Hz: 6.2 (1) c gives 5 Hz for façades and roofs; here it applies to free-standing
/// structures.
const STIFF_HZ: f64 = 5.0;
/// Factor of I_v in q_p: 4.8.
const PEAK: f64 = 7.0;
/// Averaging time of the mean, s.
const MEAN_S: f64 = 600.0;

impl EurocodeTerrain {
    /// z_0 and z_min, m.
    fn lengths_m(self) -> [f64; 2] {
        match self {
            EurocodeTerrain::Zero => [0.003, 1.0],
            EurocodeTerrain::I => [0.01, 1.0],
            EurocodeTerrain::Ii => [0.05, 2.0],
            EurocodeTerrain::Iii => [0.3, 5.0],
            EurocodeTerrain::Iv => [1.0, 10.0],
        }
    }
}

impl EurocodeWind {
    /// The pressure on a body, with the structural factor.
    ///
    /// ```text
    /// v_m = k_r ln(z/z_0) c_o v_b,  I_v = 1/(c_o ln(z/z_0)),  q_p = (1 + 7 I_v) ½ ρ v_m²        below z_min as there
    /// q = c_s c_d q_p;  c_s c_d = 1 above 5 Hz, else (1 + 2 k_p I_v √(B² + R²))/(1 + 7 I_v) at z_s = 0.6 h     Annex B
    /// ```
    ///
    /// # Errors
    /// [`WindError::Height`] above 200 m, [`WindError::FrequencyUnknown`], [`WindError::DampingUnknown`] at 5 Hz and below.
    ///
    /// # Limits
    /// Along the wind, in the first mode. Aerodynamic damping (conservative) and vortices are left out.
    ///
    /// # Source
    /// EN 1991-1-4:2005, 4.3 to 4.5, 6.2, Annex B.
    pub(super) fn pressure(&self, body: &WindBody) -> Result<WindPressure, WindError> {
        let factor = self.structural_factor(body)?;
        let is_stiff = body.frequency_hz.is_some_and(|n| n > STIFF_HZ);
        Ok(WindPressure {
            response_factor: factor,
            resonance: match is_stiff {
                true => Resonance::Stiff,
                false => Resonance::Counted,
            },
            ..self.peak()?
        })
    }

    /// q_p alone.
    pub(super) fn peak(&self) -> Result<WindPressure, WindError> {
        self.check()?;
        let [roughness_m, lowest_m] = self.terrain.lengths_m();
        let basic_pa = velocity_pressure_pa(self.basic_speed_m_s, self.air_density_kg_m3);
        let scale = self.terrain_factor() * self.orography;
        Ok(WindPressure {
            profile: Profile::Logarithmic {
                scale_pa: basic_pa * scale * scale,
                linear: PEAK / self.orography,
                roughness_m,
                lowest_m,
            },
            response_factor: 1.0,
            resonance: Resonance::NotCounted,
        })
    }

    /// Mean wind and turbulence at a height: see [`Wind::turbulence_at`](super::Wind::turbulence_at).
    pub(super) fn turbulence_at(&self, height_m: f64) -> Result<Turbulence, WindError> {
        self.check()?;
        if height_m > HEIGHT_MOST_M {
            return Err(WindError::Height {
                given: height_m,
                most_m: HEIGHT_MOST_M,
            });
        }
        let [roughness_m, lowest_m] = self.terrain.lengths_m();
        let z = height_m.max(lowest_m);
        let log = (z / roughness_m).ln();
        Ok(Turbulence {
            mean_speed_m_s: self.terrain_factor() * log * self.orography * self.basic_speed_m_s,
            intensity: 1.0 / (self.orography * log),
            length_m: length_scale_m(z, roughness_m),
        })
    }

    fn check(&self) -> Result<(), WindError> {
        positive("basic_speed_m_s", self.basic_speed_m_s)?;
        positive("orography", self.orography)?;
        positive("air_density_kg_m3", self.air_density_kg_m3)
    }

    /// k_r: 4.5.
    fn terrain_factor(&self) -> f64 {
        const ROUGHNESS_OF_II_M: f64 = 0.05;
        let [roughness_m, _] = self.terrain.lengths_m();
        0.19 * (roughness_m / ROUGHNESS_OF_II_M).powf(0.07)
    }

    /// c_s c_d of Annex B.
    fn structural_factor(&self, body: &WindBody) -> Result<f64, WindError> {
        let (h, b) = (body.height_m, body.breadth_m);
        if h > HEIGHT_MOST_M {
            return Err(WindError::Height {
                given: h,
                most_m: HEIGHT_MOST_M,
            });
        }
        let n = body.frequency_hz.ok_or(WindError::FrequencyUnknown)?;
        if n > STIFF_HZ {
            return Ok(1.0);
        }
        positive("frequency_hz", n)?;
        let zeta = body
            .damping_ratio
            .ok_or(WindError::DampingUnknown { frequency_hz: n })?;
        positive("damping_ratio", zeta)?;
        let [roughness_m, lowest_m] = self.terrain.lengths_m();
        let z_s = (0.6 * h).max(lowest_m); // figure 6.1 a
        let log = (z_s / roughness_m).ln();
        let turbulence = 1.0 / (self.orography * log);
        let mean_m_s = self.terrain_factor() * log * self.orography * self.basic_speed_m_s;
        let length_scale = length_scale_m(z_s, roughness_m);
        let background = 1.0 / (1.0 + 0.9 * ((b + h) / length_scale).powf(0.63)); // B.3
        let f_l = n * length_scale / mean_m_s;
        let spectrum = TurbulenceSpectrum::Kaimal.normalised(f_l); // B.2
        let delta = 2.0 * PI * zeta;
        let admitted = |size_m: f64| admittance(4.6 * size_m / length_scale * f_l); // B.7, B.8
        let resonant = PI * PI / (2.0 * delta) * spectrum * admitted(h) * admitted(b); // B.6
        let total = background + resonant;
        let up_crossing_hz = (n * (resonant / total).sqrt()).max(0.08); // B.5
        let s = (2.0 * (up_crossing_hz * MEAN_S).ln()).sqrt();
        let peak_factor = (s + 0.6 / s).max(3.0); // B.4
        Ok((1.0 + 2.0 * peak_factor * turbulence * total.sqrt()) / (1.0 + PEAK * turbulence)) // 6.1
    }
}

/// Length scale L(z): B.1.
fn length_scale_m(z_m: f64, roughness_m: f64) -> f64 {
    300.0 * (z_m / 200.0).powf(0.67 + 0.05 * roughness_m.ln())
}

/// Admittances R_h(η), R_b(η): 1 as η → 0.
fn admittance(eta: f64) -> f64 {
    // below this the difference loses digits: the error of 1 − 2η/3 is below 1e-8
    const SMALL: f64 = 1e-4;
    match eta < SMALL {
        true => 1.0 - 2.0 * eta / 3.0,
        false => 1.0 / eta - (1.0 - (-2.0 * eta).exp()) / (2.0 * eta * eta),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::wind::EUROCODE_AIR_KG_M3;

    const TERRAINS: [EurocodeTerrain; 5] = [
        EurocodeTerrain::Zero,
        EurocodeTerrain::I,
        EurocodeTerrain::Ii,
        EurocodeTerrain::Iii,
        EurocodeTerrain::Iv,
    ];

    fn wind(terrain: EurocodeTerrain) -> EurocodeWind {
        EurocodeWind {
            basic_speed_m_s: 26.0,
            terrain,
            orography: 1.0,
            air_density_kg_m3: EUROCODE_AIR_KG_M3,
        }
    }

    #[test]
    fn exact_peak_pressure_at_10_8_m_in_the_five_terrains() {
        // q_p/(½ ρ v_b²) computed by hand from 4.3 to 4.8
        for (terrain, ratio) in TERRAINS.into_iter().zip([3.028, 2.815, 2.401, 1.759, 1.226]) {
            let peak = wind(terrain).peak().unwrap().at_pa(10.8);
            let basic = 0.5 * 1.25 * 26.0 * 26.0;
            assert!(
                (peak / basic - ratio).abs() < 5e-4,
                "{terrain:?}: {}",
                peak / basic
            );
        }
    }

    #[test]
    fn holds_pressure_is_that_of_z_min_below_it() {
        let peak = wind(EurocodeTerrain::Iv).peak().unwrap();
        assert_eq!(peak.at_pa(0.0), peak.at_pa(10.0));
        assert!(peak.at_pa(10.5) > peak.at_pa(10.0));
    }

    #[test]
    fn exact_structural_factor_of_a_stiff_body_and_in_the_limit_of_a_small_one() {
        let body = WindBody {
            height_m: 10.0,
            breadth_m: 0.4,
            frequency_hz: Some(5.01),
            damping_ratio: None,
        };
        let stiff = wind(EurocodeTerrain::Ii).pressure(&body).unwrap();
        assert_eq!((stiff.response_factor, stiff.resonance), (1.0, Resonance::Stiff));
        // B² → 1 and R² → 0: k_p is at least 3, so that c_s c_d → (1 + 6 I_v)/(1 + 7 I_v)
        let small = WindBody {
            height_m: 3.0,
            breadth_m: 1e-9,
            frequency_hz: Some(5.0),
            damping_ratio: Some(1e6),
        };
        let factor = wind(EurocodeTerrain::Ii).structural_factor(&small).unwrap();
        let turbulence = 1.0 / (2.0_f64 / 0.05).ln();
        let length = 300.0 * 0.01_f64.powf(0.67 + 0.05 * 0.05_f64.ln());
        let background: f64 = 1.0 / (1.0 + 0.9 * (3.0_f64 / length).powf(0.63));
        let exact = (1.0 + 6.0 * turbulence * background.sqrt()) / (1.0 + 7.0 * turbulence);
        assert!((factor - exact).abs() < 1e-6, "{factor} {exact}");
    }

    #[test]
    fn refuses_what_annex_b_needs_and_is_not_known() {
        let body = |frequency_hz, damping_ratio| WindBody {
            height_m: 10.0,
            breadth_m: 0.4,
            frequency_hz,
            damping_ratio,
        };
        let said = |body: WindBody| wind(EurocodeTerrain::Ii).pressure(&body).unwrap_err();
        assert_eq!(said(body(None, None)), WindError::FrequencyUnknown);
        assert_eq!(
            said(body(Some(0.3), None)),
            WindError::DampingUnknown { frequency_hz: 0.3 }
        );
        let high = WindBody {
            height_m: 201.0,
            ..body(Some(9.0), None)
        };
        assert!(matches!(said(high), WindError::Height { .. }));
    }
}
