//! One step of a stack on moving supports: among all motions without penetration, the one that lowers the weight most.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | d, θ | `Motion` | displacement of the centroid and rotation vector of a block in the step | m, rad |
//! | u | `ground` | displacement of the ground under a block in this step | m |
//! | s | `scale` | largest |u| of this step | m |
//! | L, W | `length`, `weight` | height, weight of the stack | m, N |
//! | f | `z` | force at a corner on the upper block, over W | – |

use super::limit_programme::settings;
use super::moved_contacts::{BlockPose, Contact};
use crate::stability::StabilityError;
use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSolver, IPSolver, SolverStatus, SupportedConeT};
use glam::DVec3;

/// Largest error of the force balance and cones, over the weight. Our choice, as in the limit analysis.
const MISSED_MOST: f64 = 1e-6;
/// Coefficients (of order 1) below this are rounding errors. Our choice.
const ROUNDING: f64 = 1e-13;

/// Constant loads on a block: force at its centroid and moment about it.
#[derive(Clone, Copy, Debug)]
pub(super) struct BlockDeadLoad {
    pub(super) force: DVec3,
    pub(super) moment: DVec3,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Motion {
    pub(super) shift: DVec3,
    pub(super) turn: DVec3,
}

#[derive(Clone, Debug)]
pub(super) struct Step {
    pub(super) motions: Vec<Motion>,
    /// Force of the ground on each block, N; zero for blocks that are not on the ground.
    pub(super) reactions: Vec<DVec3>,
    /// Error of the force balance and cones, over the weight.
    pub(super) missed: f64,
}

pub(super) struct Stage<'a> {
    pub(super) moved: &'a [BlockPose],
    pub(super) contacts: &'a [Contact],
    pub(super) dead: &'a [BlockDeadLoad],
    /// Displacement of the ground under each block in this step, m.
    pub(super) ground: &'a [DVec3],
    pub(super) length: f64,
    pub(super) weight: f64,
}

/// The motion of one step; `None` if no forces can balance the weight, so that the stack falls.
///
/// ```text
/// minimise   −Σ (F·d + M·θ)   over d, θ of every block
///            (g + n·Δ, μ t·Δ) in the cone |across| ≤ along at every corner, Δ = d₂ + θ₂ × r₂ − d₁ − θ₁ × r₁ − u
/// dual       maximise the work of the ground's forces on its movement, minus Σ f₀ g, over forces f in Coulomb's cones that balance the weight
/// ```
///
/// With spreading supports, the thrust is therefore the smallest possible; with closing supports, the largest. Open corners (g > 0) carry no
/// force unless they close.
///
/// # Source
/// Portioli & Cascini (2017) for rigid blocks on settling supports. Differs from the source: Coulomb's cone is exact, in three
/// dimensions. An associated slip opens a gap, but the gap may close again in the next step, so slips do not lift stones.
pub(super) fn step(stage: &Stage<'_>) -> Result<Option<Step>, StabilityError> {
    let blocks = stage.moved.len();
    let scale = stage.ground.iter().map(|u| u.length()).fold(0.0, f64::max);
    let mut columns: Vec<Vec<(usize, f64)>> = vec![Vec::new(); 6 * blocks];
    let (mut right, mut cones) = (Vec::new(), Vec::new());
    for contact in stage.contacts {
        let [first, second, normal] = contact.axes;
        let ground = match contact.lower {
            None => stage.ground[contact.upper],
            Some(_) => DVec3::ZERO,
        };
        for corner in &contact.corners {
            let ways = [normal, first * contact.friction, second * contact.friction];
            let ways = &ways[..if contact.friction > 0.0 { 3 } else { 1 }];
            for (part, way) in ways.iter().enumerate() {
                let row = right.len();
                let gap = if part == 0 { corner.gap } else { 0.0 };
                right.push((gap - way.dot(ground)) / scale);
                let mut add = |block: usize, at: DVec3, sign: f64| {
                    let arm = (at - stage.moved[block].now()) / stage.length;
                    let six = [*way, arm.cross(*way)].map(|part| (part * sign).to_array());
                    for (axis, value) in six.into_iter().flatten().enumerate() {
                        if value.abs() > ROUNDING {
                            columns[6 * block + axis].push((row, -value));
                        }
                    }
                };
                add(contact.upper, corner.upper, 1.0);
                if let Some(lower) = contact.lower {
                    add(lower, corner.lower, -1.0);
                }
            }
            cones.push(match ways.len() {
                1 => SupportedConeT::NonnegativeConeT(1),
                parts => SupportedConeT::SecondOrderConeT(parts),
            });
        }
    }
    let costs: Vec<f64> = stage
        .dead
        .iter()
        .flat_map(|dead| {
            let force = (dead.force / -stage.weight).to_array();
            let moment = (dead.moment / (-stage.weight * stage.length)).to_array();
            force.into_iter().chain(moment)
        })
        .collect();
    let (mut starts, mut rows, mut values) = (vec![0], Vec::new(), Vec::new());
    for column in &columns {
        for &(row, value) in column {
            rows.push(row);
            values.push(value);
        }
        starts.push(rows.len());
    }
    let matrix = CscMatrix::new(right.len(), columns.len(), starts, rows, values);
    let none = CscMatrix::zeros((matrix.n, matrix.n));
    let mut solver = DefaultSolver::new(&none, &costs, &matrix, &right, &cones, settings());
    solver.solve();
    let solution = &solver.solution;
    match solution.status {
        SolverStatus::DualInfeasible | SolverStatus::AlmostDualInfeasible => return Ok(None),
        _ => {}
    }
    let (x, z) = (&solution.x, &solution.z);
    let missed = columns
        .iter()
        .zip(&costs)
        .map(|(column, cost)| {
            let sum: f64 = column.iter().map(|&(row, value)| value * z[row]).sum();
            (sum + cost).abs()
        })
        .fold(0.0, f64::max);
    if missed > MISSED_MOST || x.iter().chain(z).any(|value| !value.is_finite()) {
        return Err(StabilityError::ConicProgramme {
            reason: format!(
                "{:?} after {} steps, under moving supports, its forces miss the balance by {missed:e} of the weight",
                solution.status, solution.iterations
            ),
        });
    }
    let motions = x.chunks_exact(6).map(|six| Motion {
        shift: DVec3::new(six[0], six[1], six[2]) * scale,
        turn: DVec3::new(six[3], six[4], six[5]) * (scale / stage.length),
    });
    Ok(Some(Step {
        motions: motions.collect(),
        reactions: reactions(stage, z),
        missed,
    }))
}

/// Sum of the ground's forces on each block.
fn reactions(stage: &Stage<'_>, z: &[f64]) -> Vec<DVec3> {
    let mut sums = vec![DVec3::ZERO; stage.moved.len()];
    let mut row = 0;
    for contact in stage.contacts {
        let [first, second, normal] = contact.axes;
        for _ in &contact.corners {
            let mut force = normal * z[row];
            row += 1;
            if contact.friction > 0.0 {
                force += (first * z[row] + second * z[row + 1]) * contact.friction;
                row += 2;
            }
            if contact.lower.is_none() {
                sums[contact.upper] += force * stage.weight;
            }
        }
    }
    sums
}
