//! Limit analysis without the resistance that comes only from dilating joints.
//!
//! Associated friction makes a sliding joint dilate. Coulomb joints do not dilate: if two leaves of a wall rotate about their own toes, they
//! slide along each other without pressure.

use super::cuts::carries;
use super::limit_analysis::limit_analysis;
use super::limit_options::{LimitAnalysis, LimitAnalysisResult, LimitAnalysisStatus};
use super::mechanism::Mechanism;
use super::undilated_beds::without_dilation;
use super::upright_slip::{smoother_starts, without_sliding_friction};
use crate::stability::StabilityError;
use crate::structure::stack::Stack;

/// Largest number of rounds in which further joints begin to slide. Our choice.
pub(crate) const ROUNDS: usize = 6;

/// The smaller of the limits with and without dilating joints.
#[derive(Clone, Debug, PartialEq)]
pub struct Undilated {
    /// The analysis with the smaller limit.
    pub analysis: LimitAnalysisResult,
    /// Limit with associated friction in all joints, over gravity, if it is larger.
    pub dilating_g: Option<f64>,
    /// Whether a joint in the mechanism still dilates and pushes others apart, so that the limit is an upper bound.
    pub is_upper_bound: bool,
}

/// Repeats the limit analysis without friction in the upright joints that slide in its mechanism, until no upright joint with friction slides; and
/// then, if beds slide while joints open, with beds that slide without dilation. Returns the smallest limit.
///
/// # Errors
/// As for [`limit_analysis`].
///
/// # Limits
/// Beds are followed without dilation along the direction that governs before. The result is marked as an upper bound if that does not come to a
/// limit, or if the stack stands only by the friction of an upright sliding joint. Without dilation the limit is not unique: on the six walls of
/// Ferris & Tin-Loi (2001) it is the least that they found.
pub fn limit_analysis_undilated(stack: &Stack, options: &LimitAnalysis) -> Result<Undilated, StabilityError> {
    let (mut found, governing) = without_upright_friction(stack, options)?;
    let LimitAnalysisStatus::Limited(threshold) = found.analysis.status else {
        return Ok(found);
    };
    if slides_and_opens(stack, found.analysis.mechanism.as_ref()) {
        match without_dilation(&governing, options, threshold.direction) {
            Ok(Some(lesser)) if limit_g(&lesser) < Some(threshold.acceleration_g) => {
                let dilating_g = found.dilating_g.unwrap_or(threshold.acceleration_g);
                found.dilating_g = Some(dilating_g);
                found.analysis = LimitAnalysisResult {
                    frictionless: found.analysis.frictionless,
                    directions: found.analysis.directions,
                    ..lesser
                };
            }
            Ok(Some(_)) => {}
            // a programme that was not solved leaves the bound
            Ok(None) | Err(StabilityError::ConicProgramme { .. }) => found.is_upper_bound = true,
            Err(other) => return Err(other),
        }
    }
    Ok(found)
}

/// The limit without friction in the upright joints that slide, and the stack that has it.
pub(crate) fn without_upright_friction(
    stack: &Stack,
    options: &LimitAnalysis,
) -> Result<(Undilated, Stack), StabilityError> {
    let first = limit_analysis(stack, options)?;
    let all_friction_g = limit_g(&first);
    let mut found = Undilated {
        analysis: first,
        dilating_g: None,
        is_upper_bound: false,
    };
    let mut governing = stack.clone();
    let Some(all_friction_g) = all_friction_g else {
        return Ok((found, governing));
    };
    let mechanism = found.analysis.mechanism.as_ref();
    for start in smoother_starts(stack, (stack, &options.loads), mechanism)? {
        let mut smoother = Some(start);
        for _ in 0..ROUNDS {
            let Some(next) = smoother else {
                break;
            };
            let mut lesser = limit_analysis(&next, options)?;
            lesser.frictionless = frictionless(stack, &next);
            smoother = without_sliding_friction(&next, lesser.mechanism.as_ref());
            match (limit_g(&lesser), limit_g(&found.analysis)) {
                (Some(less), Some(more)) if less < more => {
                    found.analysis = lesser;
                    found.dilating_g = Some(all_friction_g);
                    governing = next;
                }
                (None, _) => {
                    found.is_upper_bound |= lesser.status == LimitAnalysisStatus::DoesNotStand;
                    break;
                }
                _ => {}
            }
        }
    }
    Ok((found, governing))
}

fn limit_g(analysis: &LimitAnalysisResult) -> Option<f64> {
    match analysis.status {
        LimitAnalysisStatus::Limited(threshold) => Some(threshold.acceleration_g),
        LimitAnalysisStatus::DoesNotStand | LimitAnalysisStatus::Unlimited => None,
    }
}

/// The joints that have friction in a stack and none in its smoother copy.
fn frictionless(stack: &Stack, smoother: &Stack) -> Vec<usize> {
    let rubs = |stack: &Stack, joint: usize| stack.joints()[joint].material.friction_static > 0.0;
    let joints = 0..stack.joints().len();
    joints
        .filter(|&joint| rubs(stack, joint) && !rubs(smoother, joint))
        .collect()
}

/// Whether joints with friction slide while others open.
fn slides_and_opens(stack: &Stack, mechanism: Option<&Mechanism>) -> bool {
    let joints = mechanism.map(|of| of.joints.as_slice()).unwrap_or_default();
    let rubs = |joint: usize| stack.joints()[joint].material.friction_static > 0.0;
    let slides = joints
        .iter()
        .any(|of| of.motion.slides() && carries(&stack.joints()[of.joint]) && rubs(of.joint));
    let opens = joints.iter().any(|of| of.motion.opens());
    slides && opens
}

#[cfg(test)]
mod tests {
    use super::super::{Shaking, StackLoads, stands_by_limit_analysis};
    use super::*;
    use crate::structure::stack::{Block, JointMaterial, Placement, Solid};

    fn leaves(count: usize, courses: usize) -> Stack {
        let mut blocks = Vec::new();
        let height = 3.0 / courses as f64;
        for leaf in 0..count {
            for course in 0..courses {
                blocks.push(Block {
                    name: format!("leaf {leaf} course {course}"),
                    solid: Solid::cuboid(0.2, 3.0, height).unwrap().placed(&Placement {
                        position_m: [0.2 * leaf as f64, 0.0, height * course as f64],
                        ..Placement::default()
                    }),
                    density_kg_m3: 2500.0,
                });
            }
        }
        Stack::new(blocks, JointMaterial::with_friction(0.6), 9.80665).unwrap()
    }

    /// Two leaves of 0.2 × 3 m without through stones: each rotates about its own toe, b/h = 0.2/3, for any friction between them. The analysis
    /// with dilating friction gives 0.0869.
    #[test]
    fn exact_two_leaves_bear_what_one_bears() {
        let options = LimitAnalysis {
            shaking: Shaking::Along([1.0, 0.0]),
            ..LimitAnalysis::default()
        };
        for courses in [1, 3] {
            let found = limit_analysis_undilated(&leaves(2, courses), &options).unwrap();
            let least = limit_g(&found.analysis).unwrap();
            assert!((least - 0.2 / 3.0).abs() < 1e-7, "{courses}: {least}");
            assert!(found.dilating_g.unwrap() > 0.08, "{:?}", found.dilating_g);
        }
        // beside a pillar that touches nothing, and that moves later than the leaves with all their friction, and earlier than they do
        let [mut blocks, pillar] = [leaves(4, 1), leaves(1, 1)].map(|of| of.blocks().to_vec());
        blocks.push(Block {
            name: "pillar".into(),
            solid: Solid::cuboid(0.3, 0.3, 3.0).unwrap().placed(&Placement {
                position_m: [9.0, 0.0, 0.0],
                ..Placement::default()
            }),
            ..pillar[0].clone()
        });
        let both = Stack::new(blocks, JointMaterial::with_friction(0.8), 9.80665).unwrap();
        let found = limit_analysis_undilated(&both, &options).unwrap();
        assert!(
            (limit_g(&found.analysis).unwrap() - 0.2 / 3.0).abs() < 1e-7,
            "{found:?}"
        );
        assert!((found.dilating_g.unwrap() - 0.1).abs() < 1e-7, "{found:?}");
        let one = limit_analysis_undilated(&leaves(1, 1), &options).unwrap();
        assert_eq!((one.dilating_g, one.is_upper_bound), (None, false));
        assert!((limit_g(&one.analysis).unwrap() - 0.2 / 3.0).abs() < 1e-8);
    }

    /// Opposite corners of the stones of a wall with a pier, in an order in which the solver misses the balance by 1.15e-6 of the weight.
    const WALL_AND_PIER: [[[f64; 3]; 2]; 19] = [
        [[1.6, -0.15, 0.6], [2.4, 0.15, 0.9]],
        [[2.0, -0.15, 0.9], [2.4, 0.15, 1.2]],
        [[1.25, 0.15, 0.9], [1.65, 0.55, 1.2]],
        [[2.0, -0.15, 0.3], [2.4, 0.15, 0.6]],
        [[1.2, -0.15, 0.3], [2.0, 0.15, 0.6]],
        [[1.25, 0.15, 0.3], [1.65, 0.55, 0.6]],
        [[0.8, -0.15, 0.6], [1.6, 0.15, 0.9]],
        [[1.6, -0.15, 1.2], [2.4, 0.15, 1.5]],
        [[0.0, -0.15, 0.9], [0.4, 0.15, 1.2]],
        [[0.0, -0.15, 0.3], [0.4, 0.15, 0.6]],
        [[0.8, -0.15, 0.0], [1.6, 0.15, 0.3]],
        [[0.0, -0.15, 1.2], [0.8, 0.15, 1.5]],
        [[0.8, -0.15, 1.2], [1.6, 0.15, 1.5]],
        [[1.6, -0.15, 0.0], [2.4, 0.15, 0.3]],
        [[0.0, -0.15, 0.6], [0.8, 0.15, 0.9]],
        [[0.4, -0.15, 0.9], [1.2, 0.15, 1.2]],
        [[0.0, -0.15, 0.0], [0.8, 0.15, 0.3]],
        [[1.25, 0.15, 0.6], [1.65, 0.55, 0.9]],
        [[1.25, 0.15, 0.0], [1.65, 0.55, 0.3]],
    ];

    #[test]
    fn exact_a_programme_that_misses_is_solved_again() {
        let blocks = WALL_AND_PIER.iter().enumerate().map(|(number, ends)| {
            let corner = |k: usize| [ends[k / 4][0], ends[k / 2 % 2][1], ends[k % 2][2]];
            let corners: Vec<[f64; 3]> = (0..8).map(corner).collect();
            Block {
                name: format!("stone {number}"),
                solid: Solid::convex(&corners).unwrap(),
                density_kg_m3: 2600.0,
            }
        });
        let blocks: Vec<Block> = blocks.collect();
        let mut sorted = blocks.clone();
        sorted.sort_by(|a, b| {
            let [a, b] = [a, b].map(|of| of.solid.bounds_m()[0]);
            a[2].total_cmp(&b[2])
                .then(a[1].total_cmp(&b[1]))
                .then(a[0].total_cmp(&b[0]))
        });
        let ways = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];
        let limits = |blocks: Vec<Block>| -> Vec<f64> {
            let stack = Stack::new(blocks, JointMaterial::with_friction(0.08), 9.806_65).unwrap();
            let of = |way: [f64; 2]| {
                let options = LimitAnalysis {
                    shaking: Shaking::Along(way),
                    ..LimitAnalysis::default()
                };
                assert!(stands_by_limit_analysis(&stack, &StackLoads::default(), way).unwrap());
                limit_g(&limit_analysis(&stack, &options).unwrap()).unwrap()
            };
            ways.map(of).to_vec()
        };
        let (given, sorted) = (limits(blocks), limits(sorted));
        // away from the pier the stones slide at μ
        assert!((given[1] - 0.08).abs() < 1e-6, "{given:?}");
        for (one, other) in given.iter().zip(&sorted) {
            assert!((one - other).abs() < 1e-6, "{given:?} {sorted:?}");
        }
    }
}
