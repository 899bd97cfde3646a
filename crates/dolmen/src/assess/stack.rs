//! A whole check of a stack of stones: whether it stands, at what acceleration it begins to move, what is asked of it.

use super::AssessError;
use crate::stability::stack::{
    DemandComparison, LimitAnalysis, LimitAnalysisResult, LimitAnalysisStatus, PeriodOfThumb, RockingBlock,
    StackDemand, StackLimitStates, StackLimits, Threshold, compare_with_demand, limit_analysis,
    period_of_thumb, rocking_blocks, stack_limits,
};
use crate::stability::{StabilityError, Verdict};
use crate::structure::stack::Stack;
use std::f64::consts::TAU;
use std::fmt;

/// What a check of a stack looks at.
#[derive(Clone, Debug, PartialEq)]
pub struct StackCheckOptions {
    /// Loads, strength and soil.
    pub limits: StackLimits,
    /// What an earthquake asks for. Default `None`.
    pub demand: Option<StackDemand>,
    /// Directions of the limit analysis where equilibrium alone does not give the forces, 1 to 360. Default 16, chosen here.
    pub directions: usize,
}

impl Default for StackCheckOptions {
    fn default() -> Self {
        StackCheckOptions {
            limits: StackLimits::default(),
            demand: None,
            directions: 16,
        }
    }
}

/// What a check of a stack found.
#[derive(Clone, Debug, PartialEq)]
pub struct StackCheck {
    /// Joint by joint.
    pub limits: StackLimitStates,
    /// The check by limit analysis: in the direction that governs, and where equilibrium alone does not give the forces in
    /// many. Empty if the stack does not stand.
    pub analyses: Vec<LimitAnalysisResult>,
    /// Least acceleration at which it begins to move, of both; `None` if it does not stand.
    pub capacity: Option<Threshold>,
    /// stable, marginal, unstable without shaking.
    pub verdict: Verdict,
    /// The part that rocks first as one block; `None` if it does not stand or slides first.
    pub rocking: Option<RockingBlock>,
    /// A period from the height alone.
    pub period_of_thumb: PeriodOfThumb,
    /// Against the demand, if there is one.
    pub demand: Option<DemandComparison>,
    /// What to know of these numbers.
    pub notes: Vec<StackNote>,
}

/// What to know of a check of a stack. `Display` says it as a sentence.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum StackNote {
    /// Stones share their load: the joints alone give an upper bound, the limit analysis decides.
    SharedLoad,
    /// The limit analysis finds less than the joints one by one: parts move together, twist or slide and open.
    AnalysisLower {
        /// Acceleration of the joints one by one, over gravity; `None` where they give none.
        joints_g: Option<f64>,
        /// Acceleration of the limit analysis, over gravity.
        analysis_g: f64,
    },
    /// The joints one by one find it standing, the limit analysis does not.
    AnalysisFalls,
    /// The limit analysis knows no compressive strength, so of the stack that shares its load this is an upper bound.
    StrengthNotInAnalysis,
    /// Side supports are left out.
    SideSupportsLeftOut,
    /// Ties are left out of the capacity; the thresholds with ties stand beside it.
    TiesLeftOut,
    /// The demand lacks the spectrum at the first period.
    PeriodUnknown,
}

impl fmt::Display for StackNote {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            StackNote::SharedLoad => write!(
                f,
                "stones share their load, so the joints one by one give an upper bound; the limit analysis decides"
            ),
            StackNote::AnalysisLower {
                joints_g: Some(joints_g),
                analysis_g,
            } => write!(
                f,
                "the limit analysis finds {analysis_g:.3} g, less than the {joints_g:.3} g of the joints one by one: parts move \
                 together, twist, or slide and open"
            ),
            StackNote::AnalysisLower { analysis_g, .. } => {
                write!(f, "only the limit analysis gives a limit: {analysis_g:.3} g")
            }
            StackNote::AnalysisFalls => write!(
                f,
                "joint by joint it seems to stand, but no forces in the joints balance its weight and static loads"
            ),
            StackNote::StrengthNotInAnalysis => write!(
                f,
                "the limit analysis knows no compressive strength: with stones that share their load the capacity is an \
                 upper bound"
            ),
            StackNote::SideSupportsLeftOut => write!(f, "side supports are left out"),
            StackNote::TiesLeftOut => write!(
                f,
                "ties are left out of the capacity; thresholds with ties at their strength stand beside it"
            ),
            StackNote::PeriodUnknown => write!(
                f,
                "the first period is not known, so what elastic joints add to the shaking is not in the comparison"
            ),
        }
    }
}

/// By how much the limit analysis may be lower before it is said: what 16 edges of a friction pyramid lose is 1.9 %, what the
/// solver loses 1e-9. Chosen here.
const LOWER: f64 = 0.02;

/// Checks a stack: whether it stands, what moves first and at what acceleration, against a demand.
///
/// # Errors
/// [`AssessError`] for options out of their range.
///
/// # Limits
/// Those of [`stack_limits`] and [`limit_analysis`]. The capacity is the onset of rocking or sliding, not collapse. It is dry:
/// ties are left out. Where stones share their load, directions between those analysed are not looked at: with 16, a limit that
/// follows a straight line in the plane of accelerations is at most 2 % too high.
///
/// # Example
/// ```
/// use dolmen::assess::{check_stack, StackCheckOptions};
/// use dolmen::structure::stack::{Block, JointMaterial, Solid, Stack};
/// let block = Block { name: "stone".into(), solid: Solid::cuboid(0.4, 0.4, 2.0)?, density_kg_m3: 2600.0 };
/// let stack = Stack::new(vec![block], JointMaterial::default(), 9.81)?;
/// let check = check_stack(&stack, &StackCheckOptions::default())?;
/// assert!((check.capacity.ok_or("falls")?.acceleration_g - 0.2).abs() < 1e-8);
/// assert_eq!(check.verdict.word(), "stable");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn check_stack(stack: &Stack, options: &StackCheckOptions) -> Result<StackCheck, AssessError> {
    if !(1..=360).contains(&options.directions) {
        return Err(AssessError::Stability(StabilityError::Option {
            option: "directions",
            given: options.directions as f64,
            allowed: "1 to 360",
        }));
    }
    let limits = stack_limits(stack, &options.limits)?;
    let mut check = StackCheck {
        verdict: limits.verdict,
        analyses: Vec::new(),
        capacity: None,
        rocking: None,
        period_of_thumb: period_of_thumb(stack.height_m())?,
        demand: None,
        notes: Vec::new(),
        limits,
    };
    note_what_is_left_out(stack, options, &mut check);
    if check.limits.standing.stands() {
        analyse(stack, options, &mut check)?;
    }
    if let (Some(capacity), Some(uplift)) = (check.capacity, check.limits.uplift) {
        let slides = check
            .limits
            .sliding
            .is_some_and(|sliding| sliding.threshold.acceleration_m_s2 < uplift.threshold.acceleration_m_s2);
        if !slides && capacity.acceleration_m_s2 >= (1.0 - LOWER) * uplift.threshold.acceleration_m_s2 {
            let cut = &check.limits.cuts[uplift.cut];
            let blocks = rocking_blocks(stack, cut)?;
            let edge = |block: &RockingBlock| cut.edges[block.edge].uplift.acceleration_m_s2;
            check.rocking = blocks.into_iter().min_by(|a, b| edge(a).total_cmp(&edge(b)));
        }
    }
    if let Some(demand) = &options.demand {
        let capacity = check.capacity.map(|capacity| capacity.acceleration_m_s2);
        check.demand = Some(compare_with_demand(capacity, demand)?);
    }
    Ok(check)
}

fn note_what_is_left_out(stack: &Stack, options: &StackCheckOptions, check: &mut StackCheck) {
    if !check.limits.statically_determinate {
        check.notes.push(StackNote::SharedLoad);
        if options.limits.compressive_strength_pa.is_some() {
            check.notes.push(StackNote::StrengthNotInAnalysis);
        }
    }
    if !stack.side_supports().is_empty() {
        check.notes.push(StackNote::SideSupportsLeftOut);
    }
    if !stack.ties().is_empty() {
        check.notes.push(StackNote::TiesLeftOut);
    }
    if options.demand.is_some_and(|demand| demand.spectral.is_none()) {
        check.notes.push(StackNote::PeriodUnknown);
    }
}

/// The limit analysis beside the joints one by one; the lesser is the capacity.
fn analyse(stack: &Stack, options: &StackCheckOptions, check: &mut StackCheck) -> Result<(), AssessError> {
    let both = [check.limits.uplift, check.limits.sliding].into_iter().flatten();
    let governing = both
        .map(|governing| governing.threshold)
        .min_by(|a, b| a.acceleration_m_s2.total_cmp(&b.acceleration_m_s2));
    let mut directions: Vec<[f64; 2]> = governing.iter().map(|threshold| threshold.direction).collect();
    if !check.limits.statically_determinate {
        directions.extend((0..options.directions).map(|k| {
            let angle = TAU * k as f64 / options.directions as f64;
            [angle.cos(), angle.sin()]
        }));
    }
    // the soil's rotation under static loads acts as one more lateral load, its rotation with the shaking as a factor
    let mut loads = options.limits.loads.clone();
    for (lateral, offset) in loads.lateral_m_s2.iter_mut().zip(check.limits.soil_offset_m_s2) {
        *lateral += offset;
    }
    let mut least = governing;
    for direction in directions {
        let analysis = limit_analysis(
            stack,
            &LimitAnalysis {
                loads: loads.clone(),
                direction,
                ..LimitAnalysis::default()
            },
        )?;
        let status = analysis.status;
        check.analyses.push(analysis);
        match status {
            LimitAnalysisStatus::Limited(threshold) => {
                let found = Threshold {
                    acceleration_m_s2: threshold.acceleration_m_s2 * check.limits.soil_factor,
                    acceleration_g: threshold.acceleration_g * check.limits.soil_factor,
                    direction,
                };
                if least.is_none_or(|least| found.acceleration_m_s2 < least.acceleration_m_s2) {
                    least = Some(found);
                }
            }
            LimitAnalysisStatus::DoesNotStand => {
                check.verdict = Verdict::Unstable;
                check.notes.push(StackNote::AnalysisFalls);
                return Ok(());
            }
            LimitAnalysisStatus::Unlimited => {}
        }
    }
    if let Some(least) = least
        && governing.is_none_or(|joints| least.acceleration_m_s2 < (1.0 - LOWER) * joints.acceleration_m_s2)
    {
        check.notes.push(StackNote::AnalysisLower {
            joints_g: governing.map(|joints| joints.acceleration_g),
            analysis_g: least.acceleration_g,
        });
    }
    check.capacity = least;
    // every direction found forces that balance the weight: it stands
    check.verdict = check
        .limits
        .gravity_margin
        .map_or(Verdict::Unknown, Verdict::of_gravity_margin);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stability::stack::{DemandVerdict, SpectralDemand};
    use crate::structure::stack::{Block, JointMaterial, Placement, Solid};

    /// Boxes [width, depth, height] with the middle of their base.
    fn boxes(sizes: &[([f64; 3], [f64; 3])], friction: f64) -> Stack {
        let blocks = sizes.iter().enumerate().map(|(i, (size, at))| Block {
            name: format!("stone {}", i + 1),
            solid: Solid::cuboid(size[0], size[1], size[2])
                .unwrap()
                .placed(&Placement {
                    position_m: *at,
                    ..Placement::default()
                }),
            density_kg_m3: 2600.0,
        });
        Stack::new(blocks.collect(), JointMaterial::with_friction(friction), 9.81).unwrap()
    }

    #[test]
    fn exact_single_block_against_a_demand() {
        let stack = boxes(&[([0.4, 0.4, 2.0], [0.0; 3])], 0.6);
        let spectral = SpectralDemand {
            period_s: 0.1,
            damping_ratio: 0.05,
            acceleration_m_s2: 1.9,
        };
        let options = StackCheckOptions {
            demand: Some(StackDemand {
                peak_ground_acceleration_m_s2: 1.0,
                spectral: Some(spectral),
            }),
            ..StackCheckOptions::default()
        };
        let check = check_stack(&stack, &options).unwrap();
        assert_eq!(check.demand.unwrap().verdict, DemandVerdict::Near);
        assert!((check.rocking.unwrap().frequency_parameter_rad_s - 2.686_005).abs() < 5e-7);
        assert!(check.notes.is_empty() && check.analyses.len() == 1);
    }

    #[test]
    fn exact_soil_agrees_between_both_ways() {
        let stack = boxes(&[([0.4, 0.4, 2.0], [0.0; 3])], 0.6);
        let mut options = StackCheckOptions::default();
        options.limits.soil_rocking_stiffness_n_m_rad = Some(10.0 * 0.32 * 2600.0 * 9.81);
        options.limits.loads.lateral_m_s2 = [0.05 * 9.81, 0.0];
        let check = check_stack(&stack, &options).unwrap();
        let LimitAnalysisStatus::Limited(analysis) = check.analyses[0].status else {
            panic!("no limit")
        };
        let exact = 0.9 * (0.15 - 0.05 / 9.0);
        assert!((analysis.acceleration_g * check.limits.soil_factor - exact).abs() < 1e-8);
        assert!((check.capacity.unwrap().acceleration_g - exact).abs() < 1e-8);
    }

    #[test]
    fn holds_where_stones_share_their_load_the_analysis_decides() {
        // a beam on two pillars sways along x at .4/2 g; each pillar alone, the beam only weight, would bear more
        let stack = boxes(
            &[
                ([0.4, 2.0, 2.0], [-0.8, 0.0, 0.0]),
                ([0.4, 2.0, 2.0], [0.8, 0.0, 0.0]),
                ([2.0, 2.0, 0.5], [0.0, 0.0, 2.0]),
            ],
            2.0,
        );
        let check = check_stack(&stack, &StackCheckOptions::default()).unwrap();
        assert!(
            (check.capacity.unwrap().acceleration_g - 0.2).abs() < 1e-8,
            "{:?}",
            check.capacity
        );
        assert!(check.notes.contains(&StackNote::SharedLoad));
        assert!(
            check
                .notes
                .iter()
                .any(|note| note.to_string().starts_with("the limit analysis finds 0.200 g"))
        );
        assert_eq!(check.rocking, None);
    }

    #[test]
    fn exact_a_stack_that_falls_has_no_capacity() {
        let stack = boxes(
            &[([1.0, 1.0, 0.5], [0.0; 3]), ([1.0, 1.0, 0.5], [0.62, 0.0, 0.5])],
            0.6,
        );
        let options = StackCheckOptions {
            demand: Some(StackDemand {
                peak_ground_acceleration_m_s2: 0.0,
                spectral: None,
            }),
            ..StackCheckOptions::default()
        };
        let check = check_stack(&stack, &options).unwrap();
        assert_eq!((check.verdict, check.capacity), (Verdict::Unstable, None));
        assert_eq!(check.demand.unwrap().verdict, DemandVerdict::Below);
        assert!(check.analyses.is_empty());
    }
}
