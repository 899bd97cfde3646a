//! Mean wind and turbulence of a code at any height.

use super::{Turbulence, TurbulenceSpectrum, Wind, WindError};

impl Wind {
    /// Mean wind and turbulence at a height above the ground.
    ///
    /// ```text
    /// EN 1991-1-4   v_m = k_r ln(z/z_0) c_o v_b,  I_v = 1/(c_o ln(z/z_0)),  L = 300 (z/200)^(0.67 + 0.05 ln z_0)      4.3, 4.4, B.1
    /// KDS 41 12 00  V = V_0 K_zr K_zt I_w,  I_z = 0.1 (z/Z_g)^(−α − 0.05),  L = 100 m, above 30 m · √(z/30)
    /// ```
    /// Below z_min (EN) or z_b (KDS) the values are those at that height.
    ///
    /// # Errors
    /// [`WindError::NotAMean`] for a gust or a given pressure; [`WindError::Height`] above the profile of the code;
    /// [`WindError::NotPositive`].
    ///
    /// # Source
    /// EN 1991-1-4:2005; KDS 41 12 00:2022 from two public programs. Differs from these: they use speed and turbulence at the roof height;
    /// here the same formulas are evaluated at every height.
    pub fn turbulence_at(&self, height_m: f64) -> Result<Turbulence, WindError> {
        super::error::positive("height_m", height_m)?;
        match self {
            Wind::Pressure(_) | Wind::Gust { .. } => Err(WindError::NotAMean),
            Wind::Eurocode(wind) => wind.turbulence_at(height_m),
            Wind::Kds41(wind) => wind.turbulence_at(height_m),
        }
    }

    /// ρ of a wind given by its speed, kg/m³.
    pub fn air_density_kg_m3(&self) -> Option<f64> {
        match self {
            Wind::Pressure(_) => None,
            Wind::Gust {
                air_density_kg_m3, ..
            } => Some(*air_density_kg_m3),
            Wind::Eurocode(wind) => Some(wind.air_density_kg_m3),
            Wind::Kds41(wind) => Some(wind.air_density_kg_m3),
        }
    }

    /// The spectrum of the code: Kaimal's form for EN 1991-1-4, otherwise von Kármán's.
    pub fn own_spectrum(&self) -> TurbulenceSpectrum {
        match self {
            Wind::Eurocode(_) => TurbulenceSpectrum::Kaimal,
            Wind::Pressure(_) | Wind::Gust { .. } | Wind::Kds41(_) => TurbulenceSpectrum::VonKarman,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::wind::{EurocodeTerrain, EurocodeWind, Kds41Exposure, Kds41Wind};

    #[test]
    fn exact_profiles_by_hand() {
        let eurocode = Wind::Eurocode(EurocodeWind {
            basic_speed_m_s: 26.0,
            terrain: EurocodeTerrain::Iii,
            orography: 1.0,
            air_density_kg_m3: 1.25,
        });
        let at = eurocode.turbulence_at(30.0).unwrap();
        // k_r = 0.19 (0.3/0.05)^0.07 = 0.21539, ln(30/0.3) = 4.60517
        assert!(
            (at.mean_speed_m_s - 0.215_389 * 4.605_170 * 26.0).abs() < 1e-3,
            "{at:?}"
        );
        assert!((at.intensity - 1.0 / 4.605_170).abs() < 1e-6);
        // 300 (0.15)^(0.67 + 0.05 ln 0.3)
        assert!(
            (at.length_m - 300.0 * (0.15_f64).powf(0.609_801)).abs() < 1e-3,
            "{at:?}"
        );
        assert_eq!(eurocode.turbulence_at(2.0), eurocode.turbulence_at(5.0));
        let korea = Wind::Kds41(Kds41Wind {
            basic_speed_m_s: 30.0,
            exposure: Kds41Exposure::B,
            topography: 1.0,
            importance: 1.0,
            air_density_kg_m3: 1.225,
        });
        let at = korea.turbulence_at(60.0).unwrap();
        assert!((at.mean_speed_m_s - 30.0 * 0.45 * 60.0_f64.powf(0.22)).abs() < 1e-9);
        assert!((at.intensity - 0.1 * (60.0_f64 / 450.0).powf(-0.27)).abs() < 1e-12);
        assert!((at.length_m - 100.0 * 2.0_f64.sqrt()).abs() < 1e-9);
        assert_eq!(korea.turbulence_at(3.0), korea.turbulence_at(15.0));
    }

    #[test]
    fn refuses_a_gust_and_heights_above_the_profile() {
        let gust = Wind::Gust {
            speed_m_s: 40.0,
            air_density_kg_m3: 1.25,
        };
        assert_eq!(gust.turbulence_at(10.0), Err(WindError::NotAMean));
        assert_eq!(
            Wind::Pressure(900.0).turbulence_at(10.0),
            Err(WindError::NotAMean)
        );
        let eurocode = Wind::Eurocode(EurocodeWind {
            basic_speed_m_s: 26.0,
            terrain: EurocodeTerrain::Zero,
            orography: 1.0,
            air_density_kg_m3: 1.25,
        });
        assert!(matches!(
            eurocode.turbulence_at(200.1),
            Err(WindError::Height { .. })
        ));
    }
}
