//! Limit analysis: the largest horizontal acceleration that forces in the joints can balance, by linear programming.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | λ | `most` | horizontal acceleration over gravity | – |
//! | f | – | share of one edge of the friction pyramid at one corner of a patch, ≥ 0 | – |
//! | n, v_j | `normal`, `way` | normal of a joint, directions in its plane | – |
//! | μ | `friction_static` | static friction | – |

use super::limit_pieces::{Force, pieces};
use super::{StackLoads, Threshold};
use crate::stability::StabilityError;
use crate::structure::stack::Stack;
use glam::DVec3;
use std::f64::consts::TAU;

/// What holds besides friction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Holding {
    /// Nothing: every joint is dry and every tie is gone. Default.
    #[default]
    FrictionOnly,
    /// Ties at their strengths all at once, as if each could stretch without breaking.
    Ties,
}

/// How a limit analysis is made.
#[derive(Clone, Debug, PartialEq)]
pub struct LimitAnalysis {
    /// What acts before any horizontal shaking. Default nothing.
    pub loads: StackLoads,
    /// Direction of the inertia forces; need not be of unit length. Default along x.
    pub direction: [f64; 2],
    /// Edges of the pyramid in the friction cone, 4 to 64. Default 16, chosen here: at most 1.9 % of the friction lost.
    pub friction_sides: usize,
    /// What holds besides friction.
    pub holding: Holding,
}

impl Default for LimitAnalysis {
    fn default() -> Self {
        LimitAnalysis {
            loads: StackLoads::default(),
            direction: [1.0, 0.0],
            friction_sides: 16,
            holding: Holding::default(),
        }
    }
}

/// What a limit analysis found.
#[derive(Clone, Debug, PartialEq)]
pub struct LimitAnalysisResult {
    /// How it ended.
    pub status: LimitAnalysisStatus,
    /// Largest error of the balance of forces and moments on any block, over the weight (times the size) of the stack:
    /// the evidence that the acceleration can be balanced.
    pub residual: f64,
    /// Part of the friction that the pyramid may lose, 1 − cos(π / sides).
    pub friction_lost: f64,
    /// Variables of the programme.
    pub variables: usize,
    /// Equations of the programme.
    pub equations: usize,
}

/// How a limit analysis ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LimitAnalysisStatus {
    /// The largest acceleration that can be balanced, in the direction asked for.
    Limited(Threshold),
    /// No forces in the joints balance the weight and static loads: it does not stand.
    DoesNotStand,
    /// Any acceleration can be balanced: the stack is wedged.
    Unlimited,
}

/// Balance lost at which an answer is refused, over weight and size. Chosen here; what is lost is
/// 1e-12 and less.
const RESIDUAL_MOST: f64 = 1e-7;

/// The largest horizontal acceleration, in one direction, for which forces in the joints exist that balance every block.
///
/// ```text
/// maximise λ over f ≥ 0:  Σ (n + μ v_j) f = weight + static + λ g m u       [3 a block]
///                         Σ r × (n + μ v_j) f = its moment                  [3 a block]
/// at every corner of every patch, v_j = the directions of a regular polygon, one of them along the shaking
/// ```
///
/// # Errors
/// [`StabilityError`] for options and loads out of their range, or a programme that the solver could not solve.
///
/// # Limits
/// The forces found are checked against the balance, so without friction's own caveats the stack can balance that
/// acceleration: a safe (lower) bound, short by what the pyramid loses. Friction is taken as associated (sliding joints would
/// dilate): where sliding takes part the true limit may be lower, since Coulomb joints do not dilate. Stone is rigid and
/// infinitely strong; forces at corners can carry more torsion than pressure spread over the joint (on a square .5 of
/// its diagonal against .271). Upright joints push and rub as any other. Bond is left out. Measured on one core,
/// 16 sides: below 2 ms for P10; 26 ms for a pagoda with eight posts and walls under one roof.
///
/// # Source
/// Livesley (1978), limit analysis of structures formed from rigid blocks.
/// Differs from the source: joints that alone carry what is above are solved each by itself, with the sum of what they carry;
/// and what cannot be balanced without shaking does not stand, even if some shaking would help.
///
/// # Example
/// ```
/// use dolmen::stability::stack::{limit_analysis, LimitAnalysis, LimitAnalysisStatus};
/// use dolmen::structure::stack::{Block, JointMaterial, Solid, Stack};
/// let block = Block { name: "stone".into(), solid: Solid::cuboid(0.4, 0.4, 2.0)?, density_kg_m3: 2600.0 };
/// let stack = Stack::new(vec![block], JointMaterial::default(), 9.81)?;
/// let result = limit_analysis(&stack, &LimitAnalysis::default())?;
/// let LimitAnalysisStatus::Limited(threshold) = result.status else { return Err("no limit".into()) };
/// assert!((threshold.acceleration_g - 0.2).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn limit_analysis(stack: &Stack, options: &LimitAnalysis) -> Result<LimitAnalysisResult, StabilityError> {
    let direction = checked(options)?;
    let loads = options.loads.on_blocks(stack)?;
    let (sides, ties) = (options.friction_sides, options.holding == Holding::Ties);
    let mut forces = Vec::new();
    in_joints(stack, direction, sides, &mut forces);
    if ties {
        in_ties(stack, direction, sides, &mut forces);
    }
    let mut result = LimitAnalysisResult {
        status: LimitAnalysisStatus::Unlimited,
        residual: 0.0,
        friction_lost: 1.0 - (0.5 * TAU / options.friction_sides as f64).cos(),
        variables: 0,
        equations: 0,
    };
    let mut least = f64::INFINITY;
    for piece in pieces(stack, &loads, &forces, direction, ties) {
        result.variables += piece.variables();
        result.equations += piece.equations();
        let found = piece.solve()?;
        result.residual = result.residual.max(found.residual);
        if !found.stands {
            result.status = LimitAnalysisStatus::DoesNotStand;
            return Ok(result);
        }
        least = least.min(found.most);
    }
    if result.residual > RESIDUAL_MOST {
        return Err(StabilityError::LinearProgramme {
            reason: format!(
                "its forces miss the balance by {:e} of the weight",
                result.residual
            ),
        });
    }
    if least.is_finite() {
        let gravity = stack.gravity_m_s2();
        result.status = LimitAnalysisStatus::Limited(Threshold::new(least * gravity, gravity, direction));
    }
    Ok(result)
}

fn checked(options: &LimitAnalysis) -> Result<[f64; 2], StabilityError> {
    if !(4..=64).contains(&options.friction_sides) {
        return Err(StabilityError::Option {
            option: "friction_sides",
            given: options.friction_sides as f64,
            allowed: "4 to 64",
        });
    }
    let [x, y] = options.direction;
    let length = x.hypot(y);
    if !(length > 0.0 && length.is_finite()) {
        return Err(StabilityError::Direction {
            quantity: "direction of shaking",
            given: options.direction,
        });
    }
    Ok([x / length, y / length])
}

/// The edges of the friction pyramid at every corner of every joint.
fn in_joints(stack: &Stack, direction: [f64; 2], sides: usize, forces: &mut Vec<Force>) {
    for (link, joint) in stack.joints().iter().enumerate() {
        let axes = joint.axes.map(DVec3::from);
        let mu = joint.material.friction_static;
        let mut ways = vec![axes[2]];
        if mu != 0.0 {
            ways = around(axes, direction, sides);
            ways.iter_mut().for_each(|way| *way = axes[2] + *way * mu);
        }
        for corner in &joint.patch.corners_m {
            let at = DVec3::from(joint.origin_m) + axes[0] * corner[0] + axes[1] * corner[1];
            forces.extend(ways.iter().map(|&way| Force {
                link,
                at,
                way,
                bound: None,
            }));
        }
    }
}

/// Tension along each tie, shear across it.
fn in_ties(stack: &Stack, direction: [f64; 2], sides: usize, forces: &mut Vec<Force>) {
    for (index, tie) in stack.ties().iter().enumerate() {
        let link = stack.joints().len() + index;
        let axis = DVec3::from(tie.axis).normalize();
        let at = DVec3::from(tie.position_m);
        let mut push = |way: DVec3, bound: usize, strength: f64| {
            let bound = strength.is_finite().then_some((bound, strength));
            forces.push(Force { link, at, way, bound });
        };
        if tie.axial_stiffness_n_m > 0.0 {
            push(-axis, 2 * index, tie.tension_strength_n);
        }
        let [first, second] = across(axis);
        for way in around([first, second, axis], direction, sides) {
            push(way, 2 * index + 1, tie.shear_strength_n);
        }
    }
}

/// Directions in the plane of a joint, the first as near to the shaking as can be.
fn around(axes: [DVec3; 3], direction: [f64; 2], sides: usize) -> Vec<DVec3> {
    let wanted = DVec3::new(direction[0], direction[1], 0.0);
    let in_plane = wanted - axes[2] * wanted.dot(axes[2]);
    let first = in_plane.try_normalize().unwrap_or(axes[0]);
    let second = axes[2].cross(first);
    (0..sides)
        .map(|side| {
            let angle = TAU * side as f64 / sides as f64;
            first * angle.cos() + second * angle.sin()
        })
        .collect()
}

fn across(axis: DVec3) -> [DVec3; 2] {
    let near = if axis.x.abs() < 0.9 { DVec3::X } else { DVec3::Y };
    let first = (near - axis * near.dot(axis)).normalize();
    [first, axis.cross(first)]
}

#[cfg(test)]
mod tests {
    use super::super::towers::{P10, p20, shifted, tower};
    use super::super::{StackLimits, stack_limits};
    use super::*;
    use crate::numeric::Random;
    use crate::structure::stack::{Block, Body, JointMaterial, Placement, Solid, Tie};

    fn limit(stack: &Stack, options: &LimitAnalysis) -> f64 {
        let result = limit_analysis(stack, options).unwrap();
        assert!(result.residual < 1e-7, "{}", result.residual);
        match result.status {
            LimitAnalysisStatus::Limited(threshold) => threshold.acceleration_g,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn agrees_with_the_cuts_on_towers_unless_they_slide() {
        for (sizes, known) in [(P10.to_vec(), 0.324), (p20(), 0.251)] {
            let stack = tower(&sizes, 0.6);
            let first = stack_limits(&stack, &StackLimits::default())
                .unwrap()
                .uplift
                .unwrap();
            let found = limit(&stack, &LimitAnalysis::default());
            assert!(
                (found - first.threshold.acceleration_g).abs() < 1e-8,
                "{found} {first:?}"
            );
            assert!((found - known).abs() < 5e-4);
        }
        let smooth = tower(&P10, 0.3);
        let found = limit(&smooth, &LimitAnalysis::default());
        assert!((found - 0.3).abs() < 1e-8, "{found}");
    }

    #[test]
    fn agrees_with_the_cuts_in_any_direction_on_offset_stones() {
        let mut random = Random::new(5, 0);
        for case in 0..60 {
            let sizes: Vec<(f64, f64)> = (0..2 + case % 3)
                .map(|_| (0.8 + 0.4 * random.uniform(), 0.3 + 0.7 * random.uniform()))
                .collect();
            let shifts: Vec<f64> = sizes.iter().map(|_| 0.3 * (random.uniform() - 0.5)).collect();
            let stack = shifted(&sizes, &shifts, 4.0);
            let angle = TAU * random.uniform();
            let direction = [angle.cos(), angle.sin()];
            let states = stack_limits(&stack, &StackLimits::default()).unwrap();
            let cuts = states
                .cuts
                .iter()
                .map(|cut| cut.uplift_in_m_s2(direction).unwrap().unwrap());
            let least = cuts.fold(f64::INFINITY, f64::min) / 9.81;
            let options = LimitAnalysis {
                direction,
                ..LimitAnalysis::default()
            };
            let found = limit(&stack, &options);
            assert!((found / least - 1.0).abs() < 1e-7, "case {case}: {found} {least}");
        }
    }

    /// Two pillars .4 wide, 2 m high, 1.6 m apart, with a beam across.
    fn portal(friction: f64) -> Stack {
        let block = |name: &str, size: [f64; 3], at: [f64; 3]| Block {
            name: name.into(),
            solid: Solid::cuboid(size[0], size[1], size[2])
                .unwrap()
                .placed(&Placement {
                    position_m: at,
                    ..Placement::default()
                }),
            density_kg_m3: 2600.0,
        };
        let blocks = vec![
            block("left", [0.4, 0.4, 2.0], [-0.8, 0.0, 0.0]),
            block("right", [0.4, 0.4, 2.0], [0.8, 0.0, 0.0]),
            block("beam", [2.0, 0.4, 0.5], [0.0, 0.0, 2.0]),
        ];
        Stack::new(blocks, JointMaterial::with_friction(friction), 9.81).unwrap()
    }

    #[test]
    fn exact_portal_that_sways() {
        // both pillars turn about their feet and the beam stays level, carried at the corners that rise:
        // virtual work: λ (2 w h/2 + W h) = 2 w b/2 + W b, w = .32, W = .4, h = 2, b = .4
        let sway: f64 = 0.4 * (0.32 + 0.4) / (2.0 * (0.32 + 0.4));
        let found = limit(&portal(2.0), &LimitAnalysis::default());
        assert!((found - sway).abs() < 1e-8, "{found} {sway}");
        // the cuts do not see it: an upper bound, and said so
        let states = stack_limits(&portal(2.0), &StackLimits::default()).unwrap();
        assert!(!states.statically_determinate);
        assert_eq!(
            (states.governing, states.verdict),
            (None, crate::stability::Verdict::Unknown)
        );
        let options = LimitAnalysis {
            direction: [0.0, 1.0],
            ..LimitAnalysis::default()
        };
        let across = limit(&portal(2.0), &options);
        assert!(across <= states.uplift.unwrap().threshold.acceleration_g + 1e-8);
    }

    #[test]
    fn exact_portal_within_a_stack_is_a_piece_of_its_own() {
        // on a pedestal and with a stone on the beam: the sway stays b/h = .2, whatever the beam carries
        let block = |name: &str, size: [f64; 3], at: [f64; 3]| Block {
            name: name.into(),
            solid: Solid::cuboid(size[0], size[1], size[2])
                .unwrap()
                .placed(&Placement {
                    position_m: at,
                    ..Placement::default()
                }),
            density_kg_m3: 2600.0,
        };
        let blocks = vec![
            block("pedestal", [4.0, 4.0, 0.5], [0.0; 3]),
            block("left", [0.4, 2.0, 2.0], [-0.8, 0.0, 0.5]),
            block("right", [0.4, 2.0, 2.0], [0.8, 0.0, 0.5]),
            block("beam", [2.0, 2.0, 0.5], [0.0, 0.0, 2.5]),
            block("stone", [1.2, 1.2, 0.5], [0.0, 0.0, 3.0]),
        ];
        let stack = Stack::new(blocks, JointMaterial::with_friction(2.0), 9.81).unwrap();
        let result = limit_analysis(&stack, &LimitAnalysis::default()).unwrap();
        // pedestal 6, stone 6, pillars and beam 18; four corners of 16 edges a joint, λ three times
        assert_eq!((result.equations, result.variables), (30, 6 * 4 * 16 + 3));
        assert!((limit(&stack, &LimitAnalysis::default()) - 0.2).abs() < 1e-9);
    }

    #[test]
    fn exact_ties_hold_at_their_strength() {
        let weight = 0.32 * 2600.0 * 9.81;
        let tie = Tie {
            lower: Body::Ground,
            upper: 0,
            position_m: [0.0; 3],
            axis: [0.0, 0.0, 1.0],
            axial_stiffness_n_m: 1e8,
            shear_stiffness_n_m: 1e8,
            tension_strength_n: 0.5 * weight,
            shear_strength_n: 0.0,
        };
        let stack = tower(&[(0.4, 2.0)], 0.6).with_tie(tie).unwrap();
        let tied = LimitAnalysis {
            holding: Holding::Ties,
            ..LimitAnalysis::default()
        };
        assert!((limit(&stack, &LimitAnalysis::default()) - 0.2).abs() < 1e-9);
        assert!((limit(&stack, &tied) - 0.3).abs() < 1e-9);
    }

    #[test]
    fn exact_a_stack_that_falls_is_named() {
        let stack = shifted(&[(1.0, 0.5), (1.0, 0.5)], &[0.0, 0.62], 0.6);
        let result = limit_analysis(&stack, &LimitAnalysis::default()).unwrap();
        assert_eq!(result.status, LimitAnalysisStatus::DoesNotStand);
    }

    #[test]
    fn refuses_a_pyramid_of_three_sides() {
        let options = LimitAnalysis {
            friction_sides: 3,
            ..LimitAnalysis::default()
        };
        let fault = limit_analysis(&portal(0.6), &options).unwrap_err();
        assert_eq!(fault.to_string(), "friction_sides is 3, but must be 4 to 64");
    }
}
