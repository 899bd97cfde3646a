//! A given wind: a pressure, a gust, or a mean wind of a code.

use super::error::positive;
use super::pressure::{Profile, Resonance, WindBody, WindPressure, velocity_pressure_pa};
use super::{EurocodeWind, Kds41Wind, WindError};

/// A given wind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Wind {
    /// The peak velocity pressure, the same at all heights, Pa.
    Pressure(f64),
    /// The speed of a gust, the same at all heights: q = ½ ρ v².
    Gust {
        /// v, m/s.
        speed_m_s: f64,
        /// ρ, kg/m³.
        air_density_kg_m3: f64,
    },
    /// A 10-minute mean according to EN 1991-1-4.
    Eurocode(EurocodeWind),
    /// A 10-minute mean according to KDS 41 12 00.
    Kds41(Kds41Wind),
}

impl Wind {
    /// The pressure on a body.
    ///
    /// # Errors
    /// [`WindError`] for a value that is not positive, and if a code needs an unknown property of the body.
    ///
    /// # Example
    /// ```
    /// use dolmen::structure::wind::{Wind, WindBody};
    /// let body = WindBody { height_m: 10.8, breadth_m: 0.4, frequency_hz: None, damping_ratio: None };
    /// let gust = Wind::Gust { speed_m_s: 30.0, air_density_kg_m3: 1.25 };
    /// assert_eq!(gust.pressure(&body)?.at_pa(5.0), 562.5);
    /// # Ok::<(), dolmen::structure::wind::WindError>(())
    /// ```
    pub fn pressure(&self, body: &WindBody) -> Result<WindPressure, WindError> {
        positive("height_m", body.height_m)?;
        positive("breadth_m", body.breadth_m)?;
        let as_given = |pressure_pa| WindPressure {
            profile: Profile::Uniform(pressure_pa),
            response_factor: 1.0,
            resonance: Resonance::NotCounted,
        };
        match self {
            Wind::Pressure(pressure_pa) => {
                positive("pressure_pa", *pressure_pa)?;
                Ok(as_given(*pressure_pa))
            }
            Wind::Gust {
                speed_m_s,
                air_density_kg_m3,
            } => {
                positive("speed_m_s", *speed_m_s)?;
                positive("air_density_kg_m3", *air_density_kg_m3)?;
                Ok(as_given(velocity_pressure_pa(*speed_m_s, *air_density_kg_m3)))
            }
            Wind::Eurocode(wind) => wind.pressure(body),
            Wind::Kds41(wind) => wind.pressure(body),
        }
    }
}
