//! Wind according to KDS 41 12 00:2022, stiff structures.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | V_0 | `basic_speed_m_s` | 10-minute mean at 10 m over exposure C, once in 500 years | m/s |
//! | K_zr, K_zt, I_w | | height and exposure; topography; importance | |
//! | γ_D, B_D | `gamma`, `background` | turbulence; size | |

use super::error::positive;
use super::pressure::{Profile, Resonance, WindBody, WindPressure, velocity_pressure_pa};
use super::{Turbulence, WindError};

/// Exposure of the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kds41Exposure {
    /// Centre of a large town.
    A,
    /// Town, suburb, forest.
    B,
    /// Open country with scattered obstacles.
    C,
    /// Open sea, coast, flat land.
    D,
}

/// A mean wind according to KDS 41 12 00.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kds41Wind {
    /// V_0, m/s.
    pub basic_speed_m_s: f64,
    /// Exposure.
    pub exposure: Kds41Exposure,
    /// K_zt; 1 on flat land.
    pub topography: f64,
    /// I_w; 1 for once in 500 years.
    pub importance: f64,
    /// ρ, kg/m³; 1.225 in the code.
    pub air_density_kg_m3: f64,
}

/// Frequency below which the code adds a resonant part, Hz.
const STIFF_HZ: f64 = 1.0;

/// Parameters of an exposure.
struct Numbers {
    /// z_b, m.
    lowest_m: f64,
    /// Z_g, m.
    gradient_m: f64,
    /// K_zr below z_b.
    at_lowest: f64,
    /// K_zr = coefficient · z^α above it.
    coefficient: f64,
    alpha: f64,
}

impl Kds41Exposure {
    fn numbers(self) -> Numbers {
        let [lowest_m, gradient_m, at_lowest, coefficient, alpha] = match self {
            Kds41Exposure::A => [20.0, 550.0, 0.58, 0.22, 0.33],
            Kds41Exposure::B => [15.0, 450.0, 0.81, 0.45, 0.22],
            Kds41Exposure::C => [10.0, 350.0, 1.0, 0.71, 0.15],
            Kds41Exposure::D => [5.0, 250.0, 1.13, 0.98, 0.10],
        };
        Numbers {
            lowest_m,
            gradient_m,
            at_lowest,
            coefficient,
            alpha,
        }
    }
}

impl Kds41Wind {
    /// The pressure on a body, constant over its height.
    ///
    /// ```text
    /// V_H = V_0 K_zr K_zt I_w,  q_H = ½ ρ V_H²,  q = G_D q_H,  G_D = 1 + 4 γ_D √B_D
    /// γ_D = (3 + 3α)/(2 + α) I_H,  I_H = 0.1 (max(H, z_b)/Z_g)^(−α − 0.05)
    /// B_D = 1 − [1 + 5.1 (L_H/√(H B))^1.3 (B/H)^k]^(−1/3),  k = 0.33 for H ≥ B, else −0.33;  L_H = 100 m, above 30 m · √(H/30)
    /// ```
    ///
    /// # Errors
    /// [`WindError::FrequencyUnknown`].
    ///
    /// # Limits
    /// At 1 Hz and below the code adds a resonant part, which the factor then lacks: [`Resonance::LeftOut`]. The pressure is a lower bound.
    /// K_D, the directional factor, is 1.
    ///
    /// # Source
    /// KDS 41 12 00:2022, chapter 5, from two public programs; the text of the code was not available.
    pub(super) fn pressure(&self, body: &WindBody) -> Result<WindPressure, WindError> {
        let (h, b) = (body.height_m, body.breadth_m);
        let of = self.numbers_up_to(h)?;
        let frequency_hz = body.frequency_hz.ok_or(WindError::FrequencyUnknown)?;
        let speed_m_s = self.speed_m_s(&of, h);
        Ok(WindPressure {
            profile: Profile::Uniform(velocity_pressure_pa(speed_m_s, self.air_density_kg_m3)),
            response_factor: gust_factor(&of, h, b),
            resonance: match frequency_hz <= STIFF_HZ {
                true => Resonance::LeftOut,
                false => Resonance::Stiff,
            },
        })
    }
}

impl Kds41Wind {
    /// Mean wind and turbulence at a height: see [`Wind::turbulence_at`](super::Wind::turbulence_at).
    pub(super) fn turbulence_at(&self, height_m: f64) -> Result<Turbulence, WindError> {
        let of = self.numbers_up_to(height_m)?;
        Ok(Turbulence {
            mean_speed_m_s: self.speed_m_s(&of, height_m),
            intensity: intensity(&of, height_m),
            length_m: length_m(height_m.max(of.lowest_m)),
        })
    }

    /// The parameters of the exposure, after a check of every input.
    fn numbers_up_to(&self, height_m: f64) -> Result<Numbers, WindError> {
        positive("basic_speed_m_s", self.basic_speed_m_s)?;
        positive("topography", self.topography)?;
        positive("importance", self.importance)?;
        positive("air_density_kg_m3", self.air_density_kg_m3)?;
        let of = self.exposure.numbers();
        match height_m > of.gradient_m {
            true => Err(WindError::Height {
                given: height_m,
                most_m: of.gradient_m,
            }),
            false => Ok(of),
        }
    }

    /// V_0 K_zr K_zt I_w, m/s.
    fn speed_m_s(&self, of: &Numbers, height_m: f64) -> f64 {
        let by_height = match height_m > of.lowest_m {
            true => of.coefficient * height_m.powf(of.alpha),
            false => of.at_lowest,
        };
        self.basic_speed_m_s * by_height * self.topography * self.importance
    }
}

/// I_H.
fn intensity(of: &Numbers, height_m: f64) -> f64 {
    0.1 * (height_m.max(of.lowest_m) / of.gradient_m).powf(-of.alpha - 0.05)
}

/// L_H, m.
fn length_m(height_m: f64) -> f64 {
    match height_m > 30.0 {
        true => 100.0 * (height_m / 30.0).sqrt(),
        false => 100.0,
    }
}

/// Gust factor G_D of a stiff structure.
fn gust_factor(of: &Numbers, h: f64, b: f64) -> f64 {
    let gamma = (3.0 + 3.0 * of.alpha) / (2.0 + of.alpha) * intensity(of, h);
    let k = if h >= b { 0.33 } else { -0.33 };
    let size = 5.1 * (length_m(h) / (h * b).sqrt()).powf(1.3) * (b / h).powf(k);
    let background = 1.0 - (1.0 + size).powf(-1.0 / 3.0);
    1.0 + 4.0 * gamma * background.sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::wind::KDS_41_AIR_KG_M3;

    const POLE: WindBody = WindBody {
        height_m: 10.8,
        breadth_m: 0.4,
        frequency_hz: Some(1.5),
        damping_ratio: None,
    };
    const EXPOSURES: [Kds41Exposure; 4] = [
        Kds41Exposure::A,
        Kds41Exposure::B,
        Kds41Exposure::C,
        Kds41Exposure::D,
    ];

    fn wind(exposure: Kds41Exposure) -> Kds41Wind {
        Kds41Wind {
            basic_speed_m_s: 30.0,
            exposure,
            topography: 1.0,
            importance: 1.0,
            air_density_kg_m3: KDS_41_AIR_KG_M3,
        }
    }

    #[test]
    fn exact_gust_factor_of_a_pole_in_the_four_exposures() {
        // a pole of 10.8 × 0.4 m, by hand
        for (exposure, expected) in EXPOSURES.into_iter().zip([3.22, 2.52, 2.18, 1.93]) {
            let factor = wind(exposure).pressure(&POLE).unwrap().response_factor;
            assert!((factor - expected).abs() < 5e-3, "{exposure:?}: {factor}");
        }
    }

    #[test]
    fn exact_pressure_is_gust_factor_times_that_of_the_speed_at_the_top() {
        // exposure C at 10.8 m: K_zr = 0.71 · 10.8^0.15
        let pressure = wind(Kds41Exposure::C).pressure(&POLE).unwrap();
        let speed = 30.0 * 0.71 * 10.8_f64.powf(0.15);
        let exact = pressure.response_factor * 0.5 * 1.225 * speed * speed;
        assert!((pressure.at_pa(3.0) / exact - 1.0).abs() < 1e-14);
        // exposure A below z_b = 20 m: K_zr = 0.58
        let town = wind(Kds41Exposure::A).pressure(&POLE).unwrap();
        let exact = town.response_factor * 0.5 * 1.225 * (30.0 * 0.58_f64).powi(2);
        assert!((town.at_pa(3.0) / exact - 1.0).abs() < 1e-14);
    }

    #[test]
    fn refuses_a_pole_whose_frequency_is_not_known_and_says_that_a_soft_one_lacks_resonance() {
        let found = |frequency_hz| {
            let body = WindBody { frequency_hz, ..POLE };
            wind(Kds41Exposure::C).pressure(&body)
        };
        assert_eq!(found(None), Err(WindError::FrequencyUnknown));
        let [soft, stiff] = [1.0, 1.01].map(|hz| found(Some(hz)).unwrap());
        assert_eq!(soft.response_factor, stiff.response_factor);
        assert_eq!(
            [soft.resonance, stiff.resonance],
            [Resonance::LeftOut, Resonance::Stiff]
        );
    }
}
