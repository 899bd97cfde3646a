//! The part above a joint as one rocking block: Housner's parameters, and published rules of thumb.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | R | `radius_m` | distance from the axis of rotation to the centroid | m |
//! | α | `slenderness_rad` | angle of that radius to the vertical | rad |
//! | I₀ | `inertia_kg_m2` | moment of inertia about that axis | kg m² |
//! | p | `frequency_parameter_rad_s` | √(W R / I₀) | rad/s |
//! | r | `velocity_ratio` | ratio of the angular velocities after and before an impact | – |
//! | θ₀ | `amplitude_rad` | initial rotation of a release | rad |

use super::CutLimits;
use crate::known::rocking;
use crate::stability::StabilityError;
use crate::structure::stack::Stack;
use glam::{DMat3, DVec3};

/// The part above a joint, as one block that rocks about an edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RockingBlock {
    /// Index into [`CutLimits::edges`].
    pub edge: usize,
    /// Radius R, m.
    pub radius_m: f64,
    /// Slenderness angle α, rad.
    pub slenderness_rad: f64,
    /// Moment of inertia I₀, kg m².
    pub inertia_kg_m2: f64,
    /// Frequency parameter p, rad/s.
    pub frequency_parameter_rad_s: f64,
    /// r, if the block lands flat on a parallel opposite edge; `None` if it lands on a corner or obliquely.
    pub velocity_ratio: Option<f64>,
}

/// The part above a cut as a block that rocks about each of its edges; empty if the part does not stand.
///
/// ```text
/// I₀ = Σ (t · J_k t + m_k |r_k ⊥ t|²),   p = √(W R / I₀),  W = m g (the weight without vertical acceleration)
/// r = (I_c + m ρ·ρ′) / (I_c + m ρ′·ρ′),   ρ, ρ′ from the old and the new edge to the centroid;
///     symmetric: 1 − (m R²/I₀)(1 − cos 2α); rectangle: 1 − 1.5 sin²α
/// ```
///
/// # Errors
/// [`StabilityError::Block`] if the limits belong to another stack.
///
/// # Limits
/// The part stays one body and does not slide; the joint below is rigid. An impact is instantaneous, without bounce: for real stone the ratio
/// may be larger or smaller than r.
///
/// # Source
/// Housner (1963), eqs 1–6. Tested by `stack_rocking`. Differs from the source: his r is the square of this one (a ratio of energies), and the
/// block need not be a rectangle.
///
/// # Example
/// ```
/// use dolmen::stability::stack::{rocking_blocks, stack_limits, StackLimits};
/// use dolmen::structure::stack::{Block, JointMaterial, Solid, Stack};
/// let block = Block { name: "stone".into(), solid: Solid::cuboid(0.4, 0.4, 2.0)?, density_kg_m3: 2600.0 };
/// let stack = Stack::new(vec![block], JointMaterial::default(), 9.81)?;
/// let limits = stack_limits(&stack, &StackLimits::default())?;
/// let rocking = rocking_blocks(&stack, &limits.cuts[0])?[0];
/// assert!((rocking.frequency_parameter_rad_s - 2.686005).abs() < 5e-7);
/// assert!((rocking.quarter_period_s(0.5)? - 0.490304).abs() < 5e-7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn rocking_blocks(stack: &Stack, limits: &CutLimits) -> Result<Vec<RockingBlock>, StabilityError> {
    let count = stack.blocks().len();
    if let Some(&given) = limits.cut.blocks.iter().find(|&&block| block >= count) {
        return Err(StabilityError::Block {
            quantity: "limits",
            given,
            count,
        });
    }
    let centroid = DVec3::from(limits.centroid_m);
    let mass: f64 = limits
        .cut
        .blocks
        .iter()
        .map(|&block| stack.blocks()[block].mass_kg())
        .sum();
    let mut found = Vec::with_capacity(limits.edges.len());
    for (edge, line) in limits.edges.iter().enumerate() {
        let axis = DVec3::from(line.axis);
        let square = |v: DVec3| (v - axis * v.dot(axis)).length_squared();
        let mut own = 0.0; // moment of inertia about the centroid
        for &block in &limits.cut.blocks {
            let block = &stack.blocks()[block];
            let inertia = DMat3::from_cols_array_2d(&block.solid.inertia_m5());
            let away = DVec3::from(block.solid.centroid_m()) - centroid;
            own += block.density_kg_m3 * axis.dot(inertia * axis) + block.mass_kg() * square(away);
        }
        let flat = |from: [f64; 3]| {
            let v = centroid - DVec3::from(from);
            v - axis * v.dot(axis)
        };
        let rho = flat(line.pivot_m);
        let radius = rho.length();
        let inertia = own + mass * radius * radius;
        let opposite = limits.edges.iter().find(|other| {
            DVec3::from(other.axis).dot(axis) < -1.0 + 1e-12 // antiparallel to a millionth of a radian
        });
        found.push(RockingBlock {
            edge,
            radius_m: radius,
            slenderness_rad: rho.truncate().length().atan2(rho.z),
            inertia_kg_m2: inertia,
            frequency_parameter_rad_s: (mass * stack.gravity_m_s2() * radius / inertia).sqrt(),
            velocity_ratio: opposite.map(|other| {
                let next = flat(other.pivot_m);
                (own + mass * rho.dot(next)) / (own + mass * next.length_squared())
            }),
        });
    }
    Ok(found)
}

impl RockingBlock {
    /// A quarter of the period of free rocking from rest at θ₀ = `amplitude_over_slenderness` α, without an impact, s, by the linear equation.
    ///
    /// ```text
    /// T / 4 = acosh(1 / (1 − θ₀/α)) / p
    /// ```
    ///
    /// # Errors
    /// [`StabilityError::Option`] unless 0 < θ₀/α < 1.
    ///
    /// # Limits
    /// Slender blocks: at α = 0.2 and θ₀ = α/2 it is 0.11 % below the exact value.
    pub fn quarter_period_s(&self, amplitude_over_slenderness: f64) -> Result<f64, StabilityError> {
        let share = inside(amplitude_over_slenderness)?;
        Ok((1.0 / (1.0 - share)).acosh() / self.frequency_parameter_rad_s)
    }

    /// The quarter period from the full equation θ″ = −p² sin(α − θ), by quadrature.
    ///
    /// # Errors
    /// [`StabilityError::Option`] unless 0 < θ₀/α < 1.
    pub fn quarter_period_exact_s(&self, amplitude_over_slenderness: f64) -> Result<f64, StabilityError> {
        let share = inside(amplitude_over_slenderness)?;
        let alpha = self.slenderness_rad;
        Ok(rocking::quarter_period_s(
            alpha,
            self.frequency_parameter_rad_s,
            share * alpha,
        ))
    }

    /// Slenderness α of a block that a pulse of spectral velocity S_v overturns, by Housner's energy balance: S_v p / g, rad.
    ///
    /// ```text
    /// α = S_v p / g = (S_v / √(g R)) √(m R² / I₀)
    /// ```
    ///
    /// # Limits
    /// A rule for random shaking of long duration: half of the blocks are expected to fall. `gravity_m_s2` is the gravity of the stack.
    pub fn critical_slenderness_rad(&self, spectral_velocity_m_s: f64, gravity_m_s2: f64) -> f64 {
        spectral_velocity_m_s * self.frequency_parameter_rad_s / gravity_m_s2
    }
}

fn inside(share: f64) -> Result<f64, StabilityError> {
    if share > 0.0 && share < 1.0 {
        return Ok(share);
    }
    Err(StabilityError::Option {
        option: "amplitude_over_slenderness",
        given: share,
        allowed: "above 0 and below 1, where the block would fall",
    })
}

/// Published eq. 2a, S_v √(W R / I₀), m/s². It lacks 1/g, so it is not an angle. [`RockingBlock::critical_slenderness_rad`] is correct.
///
/// # Source
/// Kim, Koo & Hong (2018), eq. 2a.
pub fn published_critical_slenderness_2a(spectral_velocity_m_s: f64, frequency_parameter_rad_s: f64) -> f64 {
    spectral_velocity_m_s * frequency_parameter_rad_s
}

/// Published eq. 3, S_v / √(g R), rad. It assumes m R²/I₀ = 1, but the value is 3/4 for every uniform rectangle. The result is therefore 15.5
/// % above [`RockingBlock::critical_slenderness_rad`].
///
/// # Source
/// Kim, Koo & Hong (2018), eq. 3. Its eq. 2b has (M R)² instead of M R².
pub fn published_critical_slenderness_3(spectral_velocity_m_s: f64, gravity_m_s2: f64, radius_m: f64) -> f64 {
    spectral_velocity_m_s / (gravity_m_s2 * radius_m).sqrt()
}

/// Published eq. 12, √(g/R) / 2π, Hz: a rocking parameter and not a natural frequency. It gives about 0.3 Hz for pagodas with measured
/// frequencies of 2.6 to 13 Hz.
///
/// # Source
/// Kim, Koo & Hong (2018), eq. 12.
pub fn published_rocking_frequency_hz(gravity_m_s2: f64, radius_m: f64) -> f64 {
    (gravity_m_s2 / radius_m).sqrt() / std::f64::consts::TAU
}

/// A period estimated from the height alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PeriodOfThumb {
    /// T, s.
    pub period_s: f64,
    /// Limitation of the estimate.
    pub caveat: PeriodCaveat,
}

/// Limitation of a period estimated from the height alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PeriodCaveat {
    /// Fitted to eight stone pagodas of 4 to 10 m. Six measured frequencies are within 15 % of the estimate; one is less than half of it, one
    /// more than twice.
    FewPagodas,
}

impl std::fmt::Display for PeriodCaveat {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            PeriodCaveat::FewPagodas => write!(
                f,
                "a period from the height alone, fitted to eight stone pagodas, of which one is measured at 2.6 Hz where it \
                 gives 5.9 Hz and one at 13 Hz where it gives 5.0 Hz: measure it, or compute it from the joints"
            ),
        }
    }
}

/// Rule of thumb for the period of a stone pagoda, T = 0.045 h^¾ (h in m, T in s).
///
/// # Errors
/// [`StabilityError::Option`] unless the height is positive.
///
/// # Source
/// Kim, Koo & Hong (2018), eq. 1 and Table 2; its authors call for more measurements before it is used. Its text gives 5.59 Hz for the pagoda
/// at Seojungri (5.9 m), but this is the value of Sungjusa (6.3 m); its Table 2 has 5.87 Hz, as eq. 1.
pub fn period_of_thumb(height_m: f64) -> Result<PeriodOfThumb, StabilityError> {
    if !(height_m > 0.0 && height_m.is_finite()) {
        return Err(StabilityError::Option {
            option: "height_m",
            given: height_m,
            allowed: "a positive number",
        });
    }
    Ok(PeriodOfThumb {
        period_s: 0.045 * height_m.powf(0.75),
        caveat: PeriodCaveat::FewPagodas,
    })
}

#[cfg(test)]
mod tests {
    use super::super::towers::{P10, leaning, shifted, tower};
    use super::super::{StackLimits, stack_limits};
    use super::*;

    fn of(stack: &Stack, cut: usize) -> Vec<RockingBlock> {
        let limits = stack_limits(stack, &StackLimits::default()).unwrap();
        rocking_blocks(stack, &limits.cuts[cut]).unwrap()
    }

    #[test]
    fn exact_single_block() {
        for block in of(&tower(&[(0.4, 2.0)], 0.6), 0) {
            assert!((block.slenderness_rad - 0.197_396).abs() < 5e-7);
            assert!((block.frequency_parameter_rad_s - 2.686_005).abs() < 5e-7);
            assert!((block.velocity_ratio.unwrap() - 0.942_308).abs() < 5e-7);
            assert!((block.quarter_period_s(0.5).unwrap() - 0.490_304).abs() < 5e-7);
            let exact = block.quarter_period_exact_s(0.5).unwrap();
            assert!((exact - 0.490_864).abs() < 5e-7, "{exact}");
            let alpha = block.critical_slenderness_rad(0.8, 9.81);
            let ratio = published_critical_slenderness_3(0.8, 9.81, block.radius_m) / alpha;
            assert!((ratio - (4.0_f64 / 3.0).sqrt()).abs() < 1e-12);
            let published = published_critical_slenderness_2a(0.8, block.frequency_parameter_rad_s);
            assert!((published / alpha - 9.81).abs() < 1e-12);
        }
    }

    #[test]
    fn exact_blocks_of_many_slendernesses() {
        for half_width in [0.1, 0.2, 0.4] {
            let block = of(&tower(&[(2.0 * half_width, 2.0)], 0.9), 0)[0];
            let p = rocking::frequency_parameter_rad_s(half_width, 1.0, 9.81);
            assert!((block.frequency_parameter_rad_s / p - 1.0).abs() < 1e-12);
            let r = rocking::velocity_ratio(rocking::slenderness_rad(half_width, 1.0));
            assert!((block.velocity_ratio.unwrap() - r).abs() < 1e-12);
        }
    }

    #[test]
    fn exact_inertia_of_a_stack_is_the_sum_of_its_stones() {
        // p² of the upper two of three equal boxes = that of one box twice as high
        let two = of(&tower(&[(1.0, 0.5), (0.6, 0.8), (0.6, 0.8)], 0.6), 1);
        let one = of(&tower(&[(0.6, 1.6)], 0.6), 0);
        for (a, b) in two.iter().zip(&one) {
            assert!((a.frequency_parameter_rad_s / b.frequency_parameter_rad_s - 1.0).abs() < 1e-12);
            assert!((a.velocity_ratio.unwrap() - b.velocity_ratio.unwrap()).abs() < 1e-12);
        }
    }

    #[test]
    fn holds_momentum_about_the_new_edge_off_centre() {
        // the impact in both directions: (I_c + m ρ·ρ′) is the same, so r I₀′ = r′ I₀
        let blocks = of(&shifted(&[(1.0, 0.5), (0.8, 1.5)], &[0.0, 0.2], 0.9), 1);
        assert_eq!(blocks.len(), 4);
        for (i, block) in blocks.iter().enumerate() {
            let other = blocks[(i + 2) % 4];
            let r = block.velocity_ratio.unwrap() * other.inertia_kg_m2;
            assert!((r / (other.velocity_ratio.unwrap() * block.inertia_kg_m2) - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn exact_slenderness_of_a_leaning_block() {
        let blocks = of(&leaning(0.01, 0.6), 1);
        let alphas = blocks.iter().map(|block| block.slenderness_rad);
        let least = alphas.fold(f64::INFINITY, f64::min);
        assert!((least - (0.4_f64.atan() - 0.01_f64.atan())).abs() < 1e-12);
    }

    #[test]
    fn published_rules_of_thumb() {
        // Table 2: heights and the frequencies that eq. 1 gives; measured 2.6 to 13 Hz
        let table = [
            (8.9, 4.31),
            (7.4, 4.95),
            (3.8, 8.16),
            (4.7, 6.96),
            (5.9, 5.87),
            (6.3, 5.59),
            (4.0, 7.86),
            (9.6, 4.07),
        ];
        for (height_m, hz) in table {
            let period_s = period_of_thumb(height_m).unwrap().period_s;
            assert!((1.0 / period_s - hz).abs() < 0.0051, "{height_m} {period_s}");
        }
        let thumb = period_of_thumb(5.9).unwrap();
        assert!(thumb.caveat.to_string().contains("2.6 Hz"));
        let stack = tower(&P10, 0.6);
        let whole = of(&stack, 0)[0];
        let f = published_rocking_frequency_hz(9.81, whole.radius_m);
        assert!((0.25..0.35).contains(&f), "{f}");
        assert!(period_of_thumb(0.0).is_err());
    }

    #[test]
    fn refuses_an_amplitude_at_which_it_falls() {
        let block = of(&tower(&[(0.4, 2.0)], 0.6), 0)[0];
        assert!(block.quarter_period_s(1.0).is_err() && block.quarter_period_exact_s(0.0).is_err());
    }
}
