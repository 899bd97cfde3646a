//! Limit analysis: the largest horizontal acceleration that forces in the joints can balance, by linear programming.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | λ | `acceleration` | horizontal acceleration over gravity | – |
//! | f | – | share of one edge of the friction pyramid at one corner of a patch, ≥ 0, over the weight of the stack | – |
//! | n, v_j | `normal`, `way` | normal of a joint, directions in its plane | – |
//! | μ | `friction_static` | static friction | – |

use super::cuts::carried;
use super::loads::Load;
use super::{StackLoads, Threshold};
use crate::stability::StabilityError;
use crate::structure::stack::{Body, Stack};
use glam::DVec3;
use microlp::{ComparisonOp, LinearExpr, OptimizationDirection, Problem, SolveOptions, Variable};
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

/// Coefficients (of order 1) below this are rounding and left out, or they would spoil the pivots. Chosen here.
const ROUNDING: f64 = 1e-13;
/// Balance the solver may lose, over weight and size. Chosen here; its least is 1e-10.
const FEASIBLE: f64 = 1e-9;
/// Balance lost at which an answer is refused, over weight and size: what the solver promises for groups of blocks, a hundred
/// times, since it is taken for single ones.
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
/// its diagonal against .271). Upright joints push and rub as any other. Bond is left out. Measured on one core: 5 ms for P10, 11 ms
/// for P20 that rocks, 23 ms for P20 that slides, 16 sides.
///
/// # Source
/// Livesley (1978), limit analysis of structures formed from rigid blocks.
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
    let mut programme = Programme::new(stack, &loads, direction);
    programme.joints(stack, direction, options.friction_sides);
    if options.holding == Holding::Ties {
        programme.ties(stack, direction, options.friction_sides);
    }
    let mut result = LimitAnalysisResult {
        status: LimitAnalysisStatus::DoesNotStand,
        residual: 0.0,
        friction_lost: 1.0 - (0.5 * TAU / options.friction_sides as f64).cos(),
        variables: programme.columns.len() + 1,
        equations: 6 * programme.groups.len(),
    };
    match programme.solve()? {
        Solved::Infeasible => {}
        Solved::Unbounded => result.status = LimitAnalysisStatus::Unlimited,
        Solved::At { most, residual } => {
            if residual > RESIDUAL_MOST {
                return Err(StabilityError::LinearProgramme {
                    reason: format!("its forces miss the balance by {residual:e} of the weight"),
                });
            }
            let gravity = stack.gravity_m_s2();
            result.residual = residual;
            result.status = LimitAnalysisStatus::Limited(Threshold::new(most * gravity, gravity, direction));
        }
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

/// One unknown: a unit force on a block and its opposite on what is below.
struct Column {
    lower: Option<usize>,
    upper: usize,
    at: DVec3,
    force: DVec3,
    most: f64,
}

/// A force with its moment about the origin.
#[derive(Clone, Copy, Default)]
struct Wrench {
    force: DVec3,
    moment: DVec3,
}

impl Wrench {
    fn of(at: DVec3, force: DVec3) -> Self {
        Wrench {
            force,
            moment: at.cross(force),
        }
    }

    fn add(&mut self, other: Wrench, times: f64) {
        self.force += other.force * times;
        self.moment += other.moment * times;
    }

    /// Six numbers: force over a weight, moment about a point over weight and length.
    fn scaled(&self, about: DVec3, weight: f64, length: f64) -> [f64; 6] {
        let moment = (self.moment - about.cross(self.force)) / (weight * length);
        let force = self.force / weight;
        [force.x, force.y, force.z, moment.x, moment.y, moment.z]
    }
}

/// The balance of one block with all that it carries. In a stack of single stones only the joint below enters, so
/// that these equations are nearly free of each other; all together they say the same as those of the single blocks.
struct Group {
    blocks: Vec<usize>,
    about: DVec3,
    weight: f64,
}

struct Programme {
    groups: Vec<Group>,
    length: f64,
    columns: Vec<Column>,
    /// Inertia forces at λ = 1, block by block.
    shaking: Vec<Wrench>,
    /// Weight and static loads.
    at_rest: Vec<Wrench>,
    /// The sum of these columns is bounded.
    sums: Vec<(Vec<usize>, f64)>,
}

/// What is made as large as can be.
#[derive(Clone, Copy)]
enum Goal {
    /// λ, with weight and static loads whole.
    Acceleration,
    /// The share of weight and static loads, up to 1, at λ = 0.
    Load,
}

enum Solved {
    At { most: f64, residual: f64 },
    Infeasible,
    Unbounded,
}

impl Programme {
    fn new(stack: &Stack, loads: &[Load], direction: [f64; 2]) -> Self {
        let gravity = stack.gravity_m_s2();
        let way = DVec3::new(direction[0], direction[1], 0.0);
        let groups = (0..loads.len()).map(|block| {
            let blocks = carried(stack, vec![block]);
            Group {
                weight: blocks.iter().map(|&above| loads[above].mass).sum::<f64>() * gravity,
                about: loads[block].centroid(),
                blocks,
            }
        });
        let shaking = loads
            .iter()
            .map(|load| Wrench::of(load.centroid(), way * (load.mass * gravity)));
        let at_rest = loads.iter().map(|load| Wrench {
            force: load.force,
            moment: load.moment,
        });
        Programme {
            groups: groups.collect(),
            length: stack.height_m(),
            columns: Vec::new(),
            shaking: shaking.collect(),
            at_rest: at_rest.collect(),
            sums: Vec::new(),
        }
    }

    /// A unit force on `upper`: the weight that it carries.
    fn push(&mut self, lower: Body, upper: usize, at: DVec3, way: DVec3, most_n: f64) -> usize {
        let weight = self.groups[upper].weight;
        self.columns.push(Column {
            lower: match lower {
                Body::Ground => None,
                Body::Block(block) => Some(block),
            },
            upper,
            at,
            force: way * weight,
            most: most_n / weight,
        });
        self.columns.len() - 1
    }

    fn joints(&mut self, stack: &Stack, direction: [f64; 2], sides: usize) {
        for joint in stack.joints() {
            let axes = joint.axes.map(DVec3::from);
            let ways = around(axes, direction, sides);
            for corner in &joint.patch.corners_m {
                let at = DVec3::from(joint.origin_m) + axes[0] * corner[0] + axes[1] * corner[1];
                if joint.material.friction_static == 0.0 {
                    self.push(joint.lower, joint.upper, at, axes[2], f64::INFINITY);
                    continue;
                }
                for way in &ways {
                    let force = axes[2] + *way * joint.material.friction_static;
                    self.push(joint.lower, joint.upper, at, force, f64::INFINITY);
                }
            }
        }
    }

    fn ties(&mut self, stack: &Stack, direction: [f64; 2], sides: usize) {
        for tie in stack.ties() {
            let axis = DVec3::from(tie.axis).normalize();
            let at = DVec3::from(tie.position_m);
            if tie.axial_stiffness_n_m > 0.0 {
                self.push(tie.lower, tie.upper, at, -axis, tie.tension_strength_n);
            }
            let [first, second] = across(axis);
            let mut shear = Vec::new();
            for way in around([first, second, axis], direction, sides) {
                shear.push(self.push(tie.lower, tie.upper, at, way, f64::INFINITY));
            }
            if tie.shear_strength_n.is_finite() {
                let weight = self.groups[tie.upper].weight;
                self.sums.push((shear, tie.shear_strength_n / weight));
            }
        }
    }

    fn solve(&self) -> Result<Solved, StabilityError> {
        let fault = match self.most(Goal::Acceleration) {
            Ok(solved) => return Ok(solved),
            Err(fault) => fault,
        };
        // without acceleration: how much of the load can be balanced? None always can, so this one has an answer
        match self.most(Goal::Load) {
            Ok(Solved::At { most, residual }) if most < 1.0 - RESIDUAL_MOST && residual <= RESIDUAL_MOST => {
                Ok(Solved::Infeasible)
            }
            _ => Err(fault),
        }
    }

    fn most(&self, goal: Goal) -> Result<Solved, StabilityError> {
        let mut problem = Problem::new(OptimizationDirection::Maximize);
        let limit = match goal {
            Goal::Acceleration => f64::INFINITY,
            Goal::Load => 1.0,
        };
        let sought = problem.add_var(1.0, (0.0, limit));
        let variables: Vec<Variable> = self
            .columns
            .iter()
            .map(|column| problem.add_var(0.0, (0.0, column.most)))
            .collect();
        for group in &self.groups {
            let (mut shaking, mut at_rest) = (Wrench::default(), Wrench::default());
            let mut within = vec![false; self.groups.len()];
            for &block in &group.blocks {
                shaking.add(self.shaking[block], 1.0);
                at_rest.add(self.at_rest[block], 1.0);
                within[block] = true;
            }
            let six = |wrench: &Wrench| wrench.scaled(group.about, group.weight, self.length);
            let mut rows: [LinearExpr; 6] = std::array::from_fn(|_| LinearExpr::empty());
            let (varied, fixed) = match goal {
                Goal::Acceleration => (six(&shaking), six(&at_rest)),
                Goal::Load => (six(&at_rest), [0.0; 6]),
            };
            add(&mut rows, sought, varied);
            for (column, &variable) in self.columns.iter().zip(&variables) {
                let below = column.lower.is_some_and(|lower| within[lower]);
                if within[column.upper] != below {
                    let sign = if below { -1.0 } else { 1.0 };
                    add(
                        &mut rows,
                        variable,
                        six(&Wrench::of(column.at, column.force * sign)),
                    );
                }
            }
            for (row, right) in rows.into_iter().zip(fixed) {
                problem.add_constraint(row, ComparisonOp::Eq, -right);
            }
        }
        for (sum, most) in &self.sums {
            let mut row = LinearExpr::empty();
            for &column in sum {
                row.add(variables[column], 1.0);
            }
            problem.add_constraint(row, ComparisonOp::Le, *most);
        }
        let mut options = SolveOptions::default();
        options.tolerances.feasibility = FEASIBLE;
        let outcome = match problem.solve_with(options) {
            Ok(outcome) => outcome,
            Err(microlp::Error::Unbounded) => return Ok(Solved::Unbounded),
            Err(fault) => {
                return Err(StabilityError::LinearProgramme {
                    reason: fault.to_string(),
                });
            }
        };
        let Ok(solution) = outcome.into_solution() else {
            return Err(StabilityError::LinearProgramme {
                reason: "it was interrupted".to_owned(),
            });
        };
        let values: Vec<f64> = variables
            .iter()
            .map(|&variable| solution.var_value(variable))
            .collect();
        let most = solution.var_value(sought);
        let [acceleration, load] = match goal {
            Goal::Acceleration => [most, 1.0],
            Goal::Load => [0.0, most],
        };
        Ok(Solved::At {
            residual: self.residual(acceleration, load, &values),
            most,
        })
    }

    /// Largest balance lost on a single block, over the weight that it carries and the size of the stack, and largest bound
    /// missed.
    fn residual(&self, acceleration: f64, load: f64, values: &[f64]) -> f64 {
        let mut left = vec![Wrench::default(); self.groups.len()];
        for (left, (shaking, at_rest)) in left.iter_mut().zip(self.shaking.iter().zip(&self.at_rest)) {
            left.add(*shaking, acceleration);
            left.add(*at_rest, load);
        }
        let mut residual = 0.0_f64;
        for (column, &value) in self.columns.iter().zip(values) {
            residual = residual.max(-value).max(value - column.most);
            let wrench = Wrench::of(column.at, column.force);
            left[column.upper].add(wrench, value);
            if let Some(lower) = column.lower {
                left[lower].add(wrench, -value);
            }
        }
        for (left, group) in left.iter().zip(&self.groups) {
            for value in left.scaled(group.about, group.weight, self.length) {
                residual = residual.max(value.abs());
            }
        }
        residual
    }
}

fn add(rows: &mut [LinearExpr; 6], variable: Variable, values: [f64; 6]) {
    for (row, value) in rows.iter_mut().zip(values) {
        if value.abs() > ROUNDING {
            row.add(variable, value);
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
    use crate::structure::stack::{Block, JointMaterial, Placement, Solid, Tie};

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
