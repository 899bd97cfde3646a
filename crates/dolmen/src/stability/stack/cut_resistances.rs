//! Resistance of the parts of a stack against tipping and sliding, for inertia forces that are not proportional to the masses.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | F, M | – | resultant of the inertia forces on the part, and its moment about the origin | N, N m |
//! | f, m | `force`, `moment` | coefficients of F and M in this limit state | m or –, – |
//! | s | `reserve` | resistance by weight and friction | N m or N |

use super::cuts::cuts;
use super::part::Part;
use super::stack_limits::acting;
use super::{Resistance, StackLimits, contact::names_below};
use crate::stability::StabilityError;
use crate::structure::stack::Stack;

/// Resistance of the part above one cut, for all directions in which it can begin to move.
#[derive(Clone, Debug, PartialEq)]
pub struct CutResistance {
    /// The bodies below the cut, in words: "'body 1'", "the ground".
    pub above: String,
    /// The blocks above the cut, ascending.
    pub blocks: Vec<usize>,
    /// Tipping about every edge, and sliding in steps of 2°.
    pub resistances: Vec<Resistance>,
}

/// Resistance of the parts of a stack to tipping and sliding, as in [`stack_limits`](super::stack_limits), for inertia forces with any
/// distribution over the height.
///
/// ```text
/// tipping about the line (p, t)     t · (M − p × F) ≤ −t · (M₀ − p × F₀)        M₀, F₀ of weight and static loads
/// sliding along v                   (v + μ n) · F ≤ μ N + C − v · F₀
/// ```
///
/// # Errors
/// [`StabilityError`] for loads and options out of their range.
///
/// # Limits
/// As for [`stack_limits`](super::stack_limits). Ties are left out.
pub fn cut_resistances(stack: &Stack, options: &StackLimits) -> Result<Vec<CutResistance>, StabilityError> {
    let (loads, soil) = acting(stack, options)?;
    let found = cuts(stack).cuts.into_iter().map(|cut| {
        let (above, blocks) = (names_below(stack, &cut), cut.blocks.clone());
        CutResistance {
            above,
            blocks,
            resistances: Part::of(stack, cut, &loads, &soil).resists(),
        }
    });
    Ok(found.collect())
}

#[cfg(test)]
mod tests {
    use super::super::towers::shifted;
    use super::super::{LimitKind, StackLoads, stack_limits};
    use super::*;
    use crate::structure::stack::SoilBelow;
    use glam::DVec3;

    #[test]
    fn agrees_with_the_limits_where_all_masses_feel_alike() {
        let soil = SoilBelow {
            rocking_stiffness_n_m_rad: 1e6,
            normal_stiffness_pa_m: 1e8,
            shear_stiffness_pa_m: 1e8,
        };
        let stack = shifted(&[(1.0, 0.5), (0.8, 0.6), (0.6, 1.0)], &[0.0, 0.07, 0.02], 0.5)
            .with_soil(soil)
            .unwrap();
        let options = StackLimits {
            loads: StackLoads {
                vertical_acceleration_m_s2: -2.0,
                ..StackLoads::default()
            },
        };
        let limits = stack_limits(&stack, &options).unwrap();
        let found = cut_resistances(&stack, &options).unwrap();
        assert_eq!(found.len(), 3);
        for (cut, known) in found.iter().zip(&limits.cuts) {
            assert_eq!((&cut.above, &cut.blocks), (&known.above, &known.cut.blocks));
            let blocks = cut.blocks.iter().map(|&block| &stack.blocks()[block]);
            let (mut mass, mut first) = (0.0, DVec3::ZERO);
            for block in blocks {
                mass += block.mass_kg();
                first += DVec3::from(block.solid.centroid_m()) * block.mass_kg();
            }
            for (kind, known, off) in [
                (LimitKind::Uplift, known.uplift.unwrap(), 1e-12),
                (LimitKind::Sliding, known.sliding.unwrap(), 1.6e-4),
            ] {
                let towards = DVec3::new(known.direction[0], known.direction[1], 0.0);
                let of = cut.resistances.iter().filter(|one| one.kind == kind);
                let least = of
                    .map(|one| {
                        let asks = DVec3::from(one.force).dot(towards * mass)
                            + DVec3::from(one.moment).dot(first.cross(towards));
                        if asks > 0.0 {
                            one.reserve / asks
                        } else {
                            f64::INFINITY
                        }
                    })
                    .fold(f64::INFINITY, f64::min);
                let ratio = least / known.acceleration_m_s2 - 1.0;
                assert!((-1e-12..off).contains(&ratio), "{kind:?} {ratio:e}");
            }
        }
    }
}
