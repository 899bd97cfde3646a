//! A rocking part under the spectral velocity of a site: Housner's energy balance, and its published forms.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | S_v | `velocity_m_s` | pseudo-velocity S_a T/2π, where it is largest | m/s |
//! | α | `slenderness_rad` | slenderness of the part that lifts first | rad |
//! | p, R | | its frequency parameter, and its radius | rad/s, m |

use dolmen::assess::AssessError;
use dolmen::assess::demand::{DesignSpectrum, SiteDemand};
use dolmen::stability::stack::{
    RockingBlock, published_critical_slenderness_2a, published_critical_slenderness_3,
};
use std::f64::consts::TAU;

/// The largest pseudo-velocity of a spectrum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpectralVelocity {
    /// S_v, m/s.
    pub velocity_m_s: f64,
    /// The shortest period at which it is reached, s.
    pub period_s: f64,
}

/// A part that rocks as one block, under the spectral velocity of a site.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VelocityDemand {
    /// S_v.
    pub velocity: SpectralVelocity,
    /// The part.
    pub block: RockingBlock,
    /// Critical slenderness S_v p/g, rad: S_v overturns half of all blocks with this slenderness.
    pub critical_slenderness_rad: f64,
    /// Eq. 3 as published, S_v/√(g R), rad.
    pub published_3_rad: f64,
    /// Eq. 2a as published, S_v p, m/s²: not an angle.
    pub published_2a_m_s2: f64,
}

impl VelocityDemand {
    /// Slenderness of the part over the critical one.
    pub fn ratio(&self) -> f64 {
        self.block.slenderness_rad / self.critical_slenderness_rad
    }
}

/// The largest pseudo-velocity S_a T/2π of a spectrum: the constant-velocity branch, or the largest value of a table.
///
/// # Errors
/// [`AssessError`] where the spectrum is not given at this damping ratio.
fn spectral_velocity(spectrum: &DesignSpectrum, damping_ratio: f64) -> Result<SpectralVelocity, AssessError> {
    let at = |period_s: f64| -> Result<SpectralVelocity, AssessError> {
        let acceleration_m_s2 = spectrum.acceleration_m_s2(period_s, damping_ratio)?;
        Ok(SpectralVelocity {
            velocity_m_s: acceleration_m_s2 * period_s / TAU,
            period_s,
        })
    };
    let periods: Vec<f64> = match spectrum.branches() {
        Some(branches) => vec![branches.plateau_s],
        None => {
            let points = spectrum.points();
            // between two points S_a = a + b T, and (a + b T) T is largest at −a/2b
            let between = points.windows(2).filter_map(|pair| {
                let [[from_s, from], [to_s, to]] = [pair[0], pair[1]];
                let slope = (to - from) / (to_s - from_s);
                let most_s = -(from - slope * from_s) / (2.0 * slope);
                (slope < 0.0 && most_s > from_s && most_s < to_s).then_some(most_s)
            });
            points.iter().map(|point| point[0]).chain(between).collect()
        }
    };
    let mut most = SpectralVelocity {
        velocity_m_s: 0.0,
        period_s: 0.0,
    };
    for period_s in periods {
        let found = at(period_s)?;
        if found.velocity_m_s > most.velocity_m_s {
            most = found;
        }
    }
    Ok(most)
}

/// A part that rocks as one block, under the demand of the site.
///
/// ```text
/// α_crit = S_v p/g = (S_v/√(g R)) √(M R²/I₀)
/// ```
///
/// # Errors
/// As [`spectral_velocity`].
///
/// # Limits
/// Housner's white noise overturns half of the blocks at α_crit. One motion of the same S_v may be far above or below it. A code's spectrum is smooth; S_v is then that
/// of its constant-velocity branch.
///
/// # Source
/// Kim, Koo & Hong (2018), eqs 2 and 3, after Housner (1963). Differences from the source: eq. 2a lacks 1/g, eq. 2b prints (M R)² for M R², and eq. 3 sets M R²/I₀ to 1,
/// although every uniform rectangle has 3/4.
pub(crate) fn velocity_demand(
    block: RockingBlock,
    gravity_m_s2: f64,
    site: &SiteDemand,
) -> Result<VelocityDemand, AssessError> {
    let velocity = spectral_velocity(&site.spectrum, site.damping_ratio)?;
    let s_v = velocity.velocity_m_s;
    Ok(VelocityDemand {
        velocity,
        block,
        critical_slenderness_rad: block.critical_slenderness_rad(s_v, gravity_m_s2),
        published_3_rad: published_critical_slenderness_3(s_v, gravity_m_s2, block.radius_m),
        published_2a_m_s2: published_critical_slenderness_2a(s_v, block.frequency_parameter_rad_s),
    })
}
