//! Wind pressure over height, and the wind force on a strip of a body.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | q | `pressure` | peak velocity pressure, including the factor for gusts, size and resonance | Pa |
//! | ρ | `air_density_kg_m3` | density of air | kg/m³ |
//! | z_0, z_min | `roughness_m`, `lowest_m` | roughness length; height below which the pressure is constant | m |

/// Properties of a body that wind codes use.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WindBody {
    /// Height of the top above the ground, m.
    pub height_m: f64,
    /// Mean breadth across the wind, m.
    pub breadth_m: f64,
    /// Lowest natural frequency, Hz; `None` if the stiffness is unknown.
    pub frequency_hz: Option<f64>,
    /// Damping ratio of that mode; `None` if unknown.
    pub damping_ratio: Option<f64>,
}

/// Whether the pressure includes resonance with the natural frequency.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Resonance {
    /// The body is stiff by the definition of the code, so resonance is not considered.
    Stiff,
    /// The factor includes resonance.
    Counted,
    /// The pressure or gust is given, and it is unknown whether it includes resonance.
    NotCounted,
    /// The body is too soft for the factor of stiff bodies, which is used all the same: the pressure is a lower bound.
    LeftOut,
}

/// Wind pressure over height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WindPressure {
    pub(super) profile: Profile,
    /// Factor on the pressure for gusts, size and resonance: 1, c_s c_d or G_D.
    pub response_factor: f64,
    /// Whether the factor includes resonance.
    pub resonance: Resonance,
}

/// Variation of the pressure with height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Profile {
    /// Constant, Pa.
    Uniform(f64),
    /// scale · (ln²(z/z_0) + linear · ln(z/z_0)); constant below z_min.
    Logarithmic {
        scale_pa: f64,
        linear: f64,
        roughness_m: f64,
        lowest_m: f64,
    },
}

/// Wind force and moment on a strip of unit breadth between two heights.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WindStrip {
    /// Force ∫ q dz, N/m.
    pub force_n_m: f64,
    /// Moment ∫ q z dz about the ground, N.
    pub moment_n: f64,
}

/// Velocity pressure ½ ρ v², Pa.
pub(super) fn velocity_pressure_pa(speed_m_s: f64, air_density_kg_m3: f64) -> f64 {
    0.5 * air_density_kg_m3 * speed_m_s * speed_m_s
}

impl WindPressure {
    /// Pressure q at a height above the ground, Pa.
    pub fn at_pa(&self, height_m: f64) -> f64 {
        let pressure = match self.profile {
            Profile::Uniform(pressure_pa) => pressure_pa,
            Profile::Logarithmic {
                scale_pa,
                linear,
                roughness_m,
                lowest_m,
            } => {
                let log = (height_m.max(lowest_m) / roughness_m).ln();
                scale_pa * (log * log + linear * log)
            }
        };
        self.response_factor * pressure
    }

    /// Wind force and moment on a strip of unit breadth between two heights, in closed form.
    ///
    /// ```text
    /// ∫ ln u dz = z (ln u − 1)          ∫ z ln u dz = z² (ln u / 2 − 1/4)                u = z/z_0
    /// ∫ ln² u dz = z (ln² u − 2 ln u + 2)   ∫ z ln² u dz = z² (ln² u − ln u + ½)/2
    /// ```
    pub fn strip(&self, bottom_m: f64, top_m: f64) -> WindStrip {
        let flat = |pressure_pa: f64, from: f64, to: f64| WindStrip {
            force_n_m: pressure_pa * (to - from),
            moment_n: 0.5 * pressure_pa * (to * to - from * from),
        };
        match self.profile {
            Profile::Uniform(pressure_pa) => flat(self.response_factor * pressure_pa, bottom_m, top_m),
            Profile::Logarithmic {
                scale_pa,
                linear,
                roughness_m,
                lowest_m,
            } => {
                let knee = lowest_m.clamp(bottom_m, top_m);
                let low = flat(self.at_pa(lowest_m), bottom_m, knee);
                let antiderivative = |z: f64| {
                    let log = (z / roughness_m).ln();
                    let force = z * (log * log - 2.0 * log + 2.0) + linear * z * (log - 1.0);
                    let moment = 0.5 * z * z * (log * log - log + 0.5) + linear * z * z * (0.5 * log - 0.25);
                    [force, moment]
                };
                let scale = self.response_factor * scale_pa;
                let [from, to] = [antiderivative(knee), antiderivative(top_m)];
                match knee < top_m {
                    true => WindStrip {
                        force_n_m: low.force_n_m + scale * (to[0] - from[0]),
                        moment_n: low.moment_n + scale * (to[1] - from[1]),
                    },
                    false => low,
                }
            }
        }
    }
}
