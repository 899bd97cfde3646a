//! Limit analysis with sliding joints that do not dilate.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | N | `normal` | normal force of a joint | N |
//! | N₀ | `held` | normal force by which its friction counts in a round | N |
//! | S | `shear` | resultant of the friction of a joint | N |
//! | μ | `friction_static` | static friction | – |
//! | α | `DILATION` | dilation of a sliding joint, over that of associated friction | – |
//! | β | `NEWER` | share of the last solution in N₀ | – |

use super::Threshold;
use super::chosen_toes::UsedToes;
use super::limit_acts::{LimitProblem, acts};
use super::limit_mechanism::moving_with;
use super::limit_options::{Holding, LimitAnalysis, LimitAnalysisResult, LimitAnalysisStatus};
use super::limit_pieces::{GrowingLoad, Piece, pieces};
use super::limit_programme::{ACCELERATION_MOST, AccelerationSet, ProgrammeOutcome};
use super::limit_pushes::Push;
use super::mechanism::Mechanism;
use super::possible_force::{Law, PossibleForce};
use super::upright_slip::without_sliding_friction;
use crate::stability::StabilityError;
use crate::structure::stack::Stack;

/// Dilation of a sliding joint, over that of associated friction. Our choice: with 0.01, as Gilbert, Casapulla & Ahmed (2006) take, the limits of
/// their walls differ by less than 2e-4, and the solver fails on the largest.
const DILATION: f64 = 0.2;
/// Share of the last solution in the normal forces of the next. Gilbert, Casapulla & Ahmed (2006); with 0.9 the largest of their walls swings.
const NEWER: f64 = 0.6;
/// Largest number of rounds. Our choice: the six walls need 2 to 22.
const ROUNDS_MOST: usize = 40;
/// Largest number of stones. Our choice: for more, the rounds take minutes.
const BLOCKS_MOST: usize = 200;
/// Relative change of the limit, twice in a row, at which the rounds end. Our choice.
const SETTLED: f64 = 1e-4;
/// Largest friction beyond Coulomb's cone in any joint, over the weight of the stack, at which a limit counts. Our choice.
const BEYOND_MOST: f64 = 1e-3;

/// The limit along one direction in whose mechanism joints slide without dilation, for a stack that stands.
///
/// ```text
/// round       friction of each joint at most  (1 − α) μ N₀ + α μ N  in place of  μ N:  sliding dilates α times as much
/// next round  N₀ ← (1 − β) N₀ + β N;  upright joints that slide lose their friction
/// end         the limit has settled, and |S| ≤ μ N in every joint: Coulomb's law holds in the forces and in the mechanism
/// ```
///
/// `None` if the rounds do not end so, or for more than 200 stones.
///
/// # Limits
/// Without dilation the limit is not unique: this is one, not certainly the least. On the six walls of Ferris & Tin-Loi (2001) it is the least
/// that they found, to the three digits printed.
///
/// # Source
/// Gilbert, Casapulla & Ahmed (2006), Computers and Structures 84. Differs from the source: friction by joint in three dimensions; upright
/// joints that slide lose their friction.
pub(super) fn without_dilation(
    stack: &Stack,
    options: &LimitAnalysis,
    way: [f64; 2],
) -> Result<Option<LimitAnalysisResult>, StabilityError> {
    if stack.blocks().len() > BLOCKS_MOST {
        return Ok(None);
    }
    let weight = stack.mass_kg() * stack.gravity_m_s2();
    let mut stack = stack.clone();
    let mut held: Option<Vec<f64>> = None;
    let mut used = UsedToes::default();
    let (mut before_g, mut settled, mut solved) = (f64::INFINITY, 0, 0);
    for _ in 0..ROUNDS_MOST {
        let Some(round) = solve(
            &stack,
            options,
            way,
            Known {
                held: held.as_deref(),
                used: &mut used,
            },
        )?
        else {
            return Ok(None);
        };
        solved += round.analysis.solved;
        let smoother = without_sliding_friction(&stack, round.analysis.mechanism.as_ref());
        let is_still = (round.limit_g - before_g).abs() <= SETTLED * round.limit_g && smoother.is_none();
        settled = if is_still { settled + 1 } else { 0 };
        if settled > 1 && round.beyond_n <= BEYOND_MOST * weight {
            return Ok(Some(LimitAnalysisResult {
                solved,
                ..round.analysis
            }));
        }
        before_g = round.limit_g;
        let normals = round.normals_n;
        held = Some(match held {
            None => normals,
            Some(held) => held
                .iter()
                .zip(normals)
                .map(|(held, normal)| (1.0 - NEWER) * held + NEWER * normal)
                .collect(),
        });
        stack = smoother.unwrap_or(stack);
    }
    Ok(None)
}

/// Result of one round.
struct Round {
    analysis: LimitAnalysisResult,
    limit_g: f64,
    /// Normal force of each joint, N.
    normals_n: Vec<f64>,
    /// Largest friction beyond Coulomb's cone in any joint, N.
    beyond_n: f64,
}

/// What a round takes from those before.
struct Known<'a> {
    /// N₀ of each joint; none for associated friction.
    held: Option<&'a [f64]>,
    used: &'a mut UsedToes,
}

/// One round with given normal forces N₀; with associated friction if there are none. `None` if a piece falls or is wedged.
fn solve(
    stack: &Stack,
    options: &LimitAnalysis,
    way: [f64; 2],
    known: Known<'_>,
) -> Result<Option<Round>, StabilityError> {
    let Known { held, used } = known;
    let loads = options.loads.on_blocks(stack)?;
    let problem = LimitProblem {
        stack,
        loads: &loads,
        towards: Some(way),
        grows: false,
        is_coarse: false,
    };
    let mut forces = acts(&problem, options.holding);
    if let Some(held) = held {
        forces = with_friction_of(held, forces);
    }
    let growing = match &options.swaying {
        None => GrowingLoad::Shaking,
        Some(swaying) => GrowingLoad::Swaying(swaying),
    };
    let ties = options.holding == Holding::CohesionAndTies;
    let mut joints = vec![JointForces::default(); stack.joints().len()];
    let mut least: Option<(f64, Option<Mechanism>)> = None;
    let mut analysis = LimitAnalysisResult {
        status: LimitAnalysisStatus::Unlimited,
        mechanism: None,
        directions: vec![way],
        frictionless: Vec::new(),
        at_least_g: f64::INFINITY,
        residual: 0.0,
        solved: 0,
        variables: 0,
        equations: 0,
    };
    for piece in pieces(stack, &loads, &forces, growing, ties) {
        let mut programme = piece.programme_after(used, AccelerationSet::Line(way));
        let ProgrammeOutcome::Reaches(support) = programme.support(way)? else {
            return Ok(None);
        };
        analysis.solved += 1;
        analysis.residual = analysis.residual.max(support.missed);
        analysis.variables += programme.unknowns();
        analysis.equations += piece.equations();
        let share = if held.is_some() { DILATION } else { 1.0 };
        gather(&mut joints, stack, &piece, (&programme.forces(), share));
        if least.as_ref().is_none_or(|(least, _)| support.bound < *least) {
            least = Some((support.bound, moving_with(stack, &piece, programme.velocities())));
        }
        used.keep(&piece.links, programme.into_chosen());
    }
    let Some((limit_g, mechanism)) = least.filter(|(limit, _)| *limit < ACCELERATION_MOST * (1.0 - 1e-6))
    else {
        return Ok(None);
    };
    let gravity = stack.gravity_m_s2();
    analysis.status = LimitAnalysisStatus::Limited(Threshold::new(limit_g * gravity, gravity, way));
    analysis.at_least_g = limit_g;
    analysis.mechanism = mechanism;
    let beyond = |(joint, forces): (usize, &JointForces)| {
        let material = &stack.joints()[joint].material;
        let cohesion = match options.holding {
            Holding::FrictionOnly => 0.0,
            _ => material.cohesion_pa * stack.joints()[joint].patch.moments().area_m2,
        };
        let [x, y] = forces.shear_n;
        x.hypot(y) - material.friction_static * forces.normal_n - cohesion
    };
    Ok(Some(Round {
        limit_g,
        beyond_n: joints.iter().enumerate().map(beyond).fold(0.0, f64::max),
        normals_n: joints.iter().map(|forces| forces.normal_n).collect(),
        analysis,
    }))
}

/// Adds the forces of a piece to those of the joints; each cone has a share of the friction of its joint.
fn gather(joints: &mut [JointForces], stack: &Stack, piece: &Piece, (forces, share): (&[[f64; 3]], f64)) {
    let pushes = piece.pushes().iter().zip(forces);
    for ((push, force), (&link, &unit)) in pushes.zip(piece.links.iter().zip(&piece.units)) {
        if let (Some(sum), Some(joint)) = (joints.get_mut(link), stack.joints().get(link)) {
            sum.add(push, force, unit, share * joint.material.friction_static);
        }
    }
}

/// Resultant forces of a joint.
#[derive(Clone, Copy, Default)]
struct JointForces {
    normal_n: f64,
    shear_n: [f64; 2],
}

impl JointForces {
    /// Adds the force of a push; `friction` is the coefficient of its cone.
    fn add(&mut self, push: &Push, force: &[f64; 3], unit: f64, friction: f64) {
        let across = if matches!(push, Push::Disc(..) | Push::Held(_)) {
            1.0
        } else {
            friction
        };
        self.normal_n += unit * force[0];
        for (sum, part) in self.shear_n.iter_mut().zip(&force[1..]) {
            *sum += unit * across * part;
        }
    }
}

/// The same forces with friction that follows N only slightly, and is that of N₀ otherwise, shared equally by the corners of each joint.
fn with_friction_of(held: &[f64], forces: Vec<PossibleForce>) -> Vec<PossibleForce> {
    let mut corners = vec![0_usize; held.len()];
    for force in &forces {
        if let (Law::Friction(_) | Law::Toe { .. }, Some(corners)) = (force.law, corners.get_mut(force.link))
        {
            *corners += 1;
        }
    }
    let mut fixed = Vec::new();
    let mut all: Vec<PossibleForce> = forces
        .into_iter()
        .map(|mut force| {
            // a joint with a strength has so many points that a few discs stand for them
            let is_toe = matches!(force.law, Law::Toe { .. });
            let (Law::Friction(friction) | Law::Toe { friction, .. }) = &mut force.law else {
                return force;
            };
            let shear_n =
                (1.0 - DILATION) * *friction * held[force.link].max(0.0) / corners[force.link] as f64;
            *friction *= DILATION;
            if shear_n > 0.0 {
                fixed.push(PossibleForce {
                    law: match is_toe {
                        true => Law::Held(shear_n),
                        false => Law::Shear(shear_n),
                    },
                    ..force
                });
            }
            force
        })
        .collect();
    all.append(&mut fixed);
    all
}

#[cfg(test)]
mod tests {
    use super::super::towers::arch_that_crushes;
    use super::*;
    use crate::stability::stack::StackLoads;

    /// The limit of an arch with a strength, whose joints also have the friction of known normal forces, along a direction; and its unknown forces.
    fn limit(stack: &Stack, way: [f64; 2], is_point_by_point: bool) -> (f64, usize) {
        let loads = StackLoads::default().on_blocks(stack).unwrap();
        let problem = LimitProblem {
            stack,
            loads: &loads,
            towards: Some(way),
            grows: false,
            is_coarse: false,
        };
        let held = vec![0.3 * stack.mass_kg() * stack.gravity_m_s2(); stack.joints().len()];
        let mut forces = with_friction_of(&held, acts(&problem, Holding::FrictionOnly));
        for force in &mut forces {
            if let (Law::Held(shear_n), true) = (force.law, is_point_by_point) {
                force.law = Law::Shear(shear_n);
            }
        }
        let pieces = pieces(stack, &loads, &forces, GrowingLoad::Shaking, false);
        let mut programme = pieces[0].programme(AccelerationSet::Line(way));
        match programme.support(way).unwrap() {
            ProgrammeOutcome::Reaches(support) => (support.bound, programme.rows()),
            ProgrammeOutcome::Falls => panic!("{way:?}"),
        }
    }

    /// Across an arch and obliquely its joints twist: a few discs for each joint resist as its friction at every point does.
    #[test]
    fn agrees_with_friction_point_by_point() {
        let stack = arch_that_crushes();
        for way in [[0.0, 1.0], [0.6, 0.8]] {
            let [(few, few_rows), (all, all_rows)] = [false, true].map(|each| limit(&stack, way, each));
            assert!((few - all).abs() < 1e-7 && few > 0.05, "{way:?}: {few} {all}");
            assert!(3 * few_rows < all_rows, "{way:?}: {few_rows} {all_rows}");
        }
    }
}
