//! The factor on static loads up to which joint forces can balance them.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | λ | `factor` | load factor on the growing loads | – |
//! | W | `weight_n` | weight of the stack | N |

use super::StackLoads;
use super::limit_acts::{LimitProblem, acts};
use super::limit_along::{DirectionLimit, along};
use super::limit_mechanism::{falling, moving_with};
use super::limit_options::Holding;
use super::limit_pieces::{GrowingLoad, Piece, pieces};
use super::limit_programme::{ACCELERATION_MOST, AccelerationSet, ProgrammeOutcome};
use super::loads::{push_all, without_weight};
use super::mechanism::Mechanism;
use crate::stability::StabilityError;
use crate::structure::stack::{Stack, StaticLoad};

/// Direction of the growing loads in a programme.
pub(super) const GROWS: [f64; 2] = [1.0, 0.0];

/// Load factor that counts as unlimited, for loads equal to the weight.
const MOST: f64 = ACCELERATION_MOST * (1.0 - 1e-6);

/// The constant loads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SteadyLoads<'a> {
    /// Factor on the weight of the blocks, above 0.
    pub weight: f64,
    /// Constant static loads.
    pub loads: &'a [StaticLoad],
}

/// The load factor of a stack.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct LoadFactor {
    /// Smallest factor that no joint forces balance, with its mechanism; 0 if the stack does not stand without the loads; infinite if loads of
    /// ten times the weight move nothing.
    pub factor: f64,
    /// Largest factor for which balanced forces were found.
    pub at_least: f64,
    /// The mechanism at this factor; `None` if nothing moves.
    pub mechanism: Option<Mechanism>,
}

impl LoadFactor {
    /// Whether a joint slides in the mechanism: associated friction then makes the factor an upper bound.
    pub fn slides(&self) -> bool {
        let joints = self.mechanism.iter().flat_map(|mechanism| &mechanism.joints);
        joints.into_iter().any(|joint| joint.motion.slides())
    }
}

/// The factor on the growing loads up to which joint forces balance every block. Only the loads given here count, not the static loads of the
/// stack.
///
/// ```text
/// Σ f = weight · W + steady + λ growing,  |f₁, f₂| ≤ μ f₀ + share of C at every corner      λ ↦ max
/// ```
///
/// # Errors
/// [`StabilityError`] for a factor on the weight that is not positive, and a programme that the solver could not solve.
///
/// # Limits
/// As for [`limit_analysis`](super::limit_analysis()): stone is rigid and infinitely strong, friction is associated, cohesion resists sliding,
/// and ties resist nothing.
///
/// # Example
/// ```
/// use dolmen::stability::stack::{SteadyLoads, load_factor};
/// use dolmen::structure::stack::{Block, JointMaterial, Solid, Stack, StaticLoad};
/// let block = Block { name: "stone".into(), solid: Solid::cuboid(0.4, 0.4, 2.0)?, density_kg_m3: 2500.0 };
/// let stack = Stack::new(vec![block], JointMaterial::default(), 10.0)?;
/// // weight 8 kN, push of 400 N at the top: 8 · 0.2 = λ · 0.4 · 2
/// let push = StaticLoad { block: 0, position_m: [0.0, 0.0, 2.0], force_n: [400.0, 0.0, 0.0] };
/// let found = load_factor(&stack, &SteadyLoads { weight: 1.0, loads: &[] }, &[push])?;
/// assert!((found.factor - 2.0).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// As [`limit_analysis`](super::limit_analysis()).
pub fn load_factor(
    stack: &Stack,
    steady: &SteadyLoads<'_>,
    growing: &[StaticLoad],
) -> Result<LoadFactor, StabilityError> {
    let bare = stack.clone().without_static_loads();
    let (pieces, unit) = pieces_of(&bare, steady, growing)?;
    let mut found = LoadFactor {
        factor: f64::INFINITY,
        at_least: f64::INFINITY,
        mechanism: None,
    };
    for piece in &pieces {
        let DirectionLimit {
            found: reached,
            velocities,
            ..
        } = along(piece, GROWS)?;
        if !reached.stands {
            return Ok(LoadFactor {
                factor: 0.0,
                at_least: 0.0,
                mechanism: falling(&bare, piece)?,
            });
        }
        if reached.bound < MOST {
            found.at_least = found.at_least.min(reached.at_least * unit);
            if reached.bound * unit < found.factor {
                found.factor = reached.bound * unit;
                found.mechanism = moving_with(&bare, piece, &velocities);
            }
        }
    }
    Ok(found)
}

/// Computes only the factor, for a stack that is known to stand without the loads; takes a third of the time.
///
/// # Errors
/// As [`load_factor`].
pub fn growth(
    stack: &Stack,
    steady: &SteadyLoads<'_>,
    growing: &[StaticLoad],
) -> Result<f64, StabilityError> {
    let bare = stack.clone().without_static_loads();
    let (pieces, unit) = pieces_of(&bare, steady, growing)?;
    let mut least = f64::INFINITY;
    for piece in &pieces {
        match piece.programme(AccelerationSet::Line(GROWS)).support(GROWS)? {
            ProgrammeOutcome::Reaches(support) if support.bound < MOST => {
                least = least.min(support.bound * unit)
            }
            ProgrammeOutcome::Reaches(_) => {}
            ProgrammeOutcome::Falls => return Ok(0.0),
        }
    }
    Ok(least)
}

/// The equilibrium in pieces, and the scale of its growing loads.
pub(super) fn pieces_of(
    bare: &Stack,
    steady: &SteadyLoads<'_>,
    growing: &[StaticLoad],
) -> Result<(Vec<Piece>, f64), StabilityError> {
    let gravity = bare.gravity_m_s2();
    let weighs = StackLoads {
        vertical_acceleration_m_s2: gravity * (steady.weight - 1.0),
        ..StackLoads::default()
    };
    let mut loads = weighs.on_blocks(bare)?;
    push_all(&mut loads, steady.loads);
    let size = |load: &StaticLoad| load.force_n.iter().map(|part| part * part).sum::<f64>().sqrt();
    let pushed_n: f64 = growing.iter().map(size).sum();
    // growing loads equal to the weight make the programme of order 1
    let weight_n = bare.mass_kg() * gravity;
    let unit = if pushed_n > 0.0 { weight_n / pushed_n } else { 1.0 };
    let scaled: Vec<StaticLoad> = growing
        .iter()
        .map(|load| StaticLoad {
            force_n: load.force_n.map(|part| part * unit),
            ..*load
        })
        .collect();
    let grows = without_weight(loads.len(), &scaled);
    let problem = LimitProblem {
        stack: bare,
        loads: &loads,
        towards: None,
        grows: true,
        is_coarse: false,
    };
    let acts = acts(&problem, Holding::Cohesion);
    Ok((
        pieces(bare, &loads, &acts, GrowingLoad::Loads(&grows), false),
        unit,
    ))
}
