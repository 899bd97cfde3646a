//! The factor on growing loads that a stack on soil bears.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | λ | `factor` | factor on the growing loads | – |
//! | δ | `turn` | rotation of the footing under the loads | rad |

use super::AssessError;
use crate::stability::stack::{PointForce, StackLoads, SteadyLoads, growth, turned_at_rest};
use crate::structure::stack::{Stack, StaticLoad};

/// Number of equal steps in which the first factor is sought at which the footing overturns. Our choice.
const STEPS: usize = 24;
/// Number of bisections of that step. Our choice: 1e-9 of it.
const BISECTIONS: usize = 30;
/// Number of load factors of the joints on the turned footing. Our choice: each has a tenth of the error of the one before on common soils.
const ROUNDS: usize = 6;
/// Loads up to which the footing is examined where the joints bear any: this factor on the weight, or on the loads. Our choice.
const WEIGHTS_MOST: f64 = 10.0;
const LOADS_MOST: f64 = 3.0;

/// The factor on growing loads, at most that on rigid ground, up to which the footing and the joints on it bear them.
///
/// ```text
/// footing    M(θ_g + δ) = M_g(λ) + M_s(λ) + S(λ) δ has a stable solution           as in [`stack_limits`](crate::stability::stack::stack_limits)
/// joints     balance steady + λ growing, each vertical force F_z with a horizontal part |F_z| δ
/// ```
///
/// # Errors
/// [`AssessError`] for loads out of their range, and a programme that was not solved.
pub(super) fn factor_on_soil(
    stack: &Stack,
    steady: &SteadyLoads<'_>,
    growing: &[StaticLoad],
    rigid: f64,
) -> Result<f64, AssessError> {
    if stack.soil().is_none() || rigid <= 0.0 {
        return Ok(rigid);
    }
    let bare = stack.clone().without_static_loads();
    let at = |factor: f64| turned_at_rest(&bare, &loads_at(&bare, steady, growing, factor));
    if at(0.0)?.is_none() {
        return Ok(0.0);
    }
    let size = |load: &StaticLoad| load.force_n.iter().map(|part| part * part).sum::<f64>().sqrt();
    let pushed_n: f64 = growing.iter().map(size).sum();
    let weights = WEIGHTS_MOST * bare.mass_kg() * bare.gravity_m_s2() / pushed_n;
    let most = rigid.min(weights.max(LOADS_MOST));
    if !most.is_finite() {
        return Ok(rigid);
    }
    let mut bears = rigid;
    for step in 1..=STEPS {
        let share = |step: usize| most * step as f64 / STEPS as f64;
        if at(share(step))?.is_some() {
            continue;
        }
        let (mut low, mut high) = (share(step - 1), share(step));
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (low + high);
            match at(middle)? {
                Some(_) => low = middle,
                None => high = middle,
            }
        }
        bears = low;
        break;
    }
    on_turned_footing(&bare, steady, growing, bears.min(most), bears)
}

/// The factor of the joints, with what the rotation of the footing adds at that factor.
fn on_turned_footing(
    bare: &Stack,
    steady: &SteadyLoads<'_>,
    growing: &[StaticLoad],
    up_to: f64,
    bears: f64,
) -> Result<f64, AssessError> {
    // factors are too large and too small by turns
    let (mut factor, mut before) = (up_to, f64::INFINITY);
    for _ in 0..ROUNDS {
        let Some(turn) = turned_at_rest(bare, &loads_at(bare, steady, growing, factor))? else {
            return Ok(factor.min(before));
        };
        let mut loads = steady.loads.to_vec();
        let mut push = |block: usize, position_m: [f64; 3], down_n: f64| {
            loads.push(StaticLoad {
                block,
                position_m,
                force_n: [down_n * turn[0], down_n * turn[1], 0.0],
            });
        };
        for (index, block) in bare.blocks().iter().enumerate() {
            let weight_n = block.mass_kg() * bare.gravity_m_s2() * steady.weight;
            push(index, block.solid.centroid_m(), weight_n);
        }
        for load in steady.loads {
            push(load.block, load.position_m, -load.force_n[2]);
        }
        for load in growing {
            push(load.block, load.position_m, -factor * load.force_n[2]);
        }
        let turned = SteadyLoads {
            weight: steady.weight,
            loads: &loads,
        };
        let next = growth(bare, &turned, growing)?.min(up_to);
        if next >= up_to {
            return Ok(match factor >= up_to {
                true => bears,
                false => factor.min(next),
            });
        }
        (before, factor) = (factor, next);
    }
    Ok(factor.min(before))
}

/// All loads at a factor.
fn loads_at(bare: &Stack, steady: &SteadyLoads<'_>, growing: &[StaticLoad], factor: f64) -> StackLoads {
    let of = |load: &StaticLoad, factor: f64| PointForce {
        block: load.block,
        position_m: Some(load.position_m),
        force_n: load.force_n.map(|part| part * factor),
    };
    let constant = steady.loads.iter().map(|load| of(load, 1.0));
    StackLoads {
        vertical_acceleration_m_s2: bare.gravity_m_s2() * (steady.weight - 1.0),
        forces: constant
            .chain(growing.iter().map(|load| of(load, factor)))
            .collect(),
        ..StackLoads::default()
    }
}
