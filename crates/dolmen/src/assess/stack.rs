//! Complete check of a stack of stones: whether it stands, the acceleration at which it begins to move, and the demand.

use super::AssessError;
use super::kinetic_friction;
use super::least_motion::{BETWEEN, FirstMotion};
use super::least_pressed::LeastPressed;
use super::only_corners;
use super::stack_notes::{Gaps, SettleRun, StackNote};
use crate::blocks::LooseStones;
use crate::stability::Verdict;
use crate::stability::stack::{
    DemandComparison, LimitAnalysisResult, LimitAnalysisStatus, MovedSupports, MovementEnding, PeriodOfThumb,
    RockingBlock, StackDemand, StackLimitStates, StackLimits, StackLoads, SupportMovementOptions, Threshold,
    compare_with_demand, follow_support_movement, period_of_thumb, rocking_blocks, stack_limits,
    stands_by_limit_analysis, turned_at_rest,
};
use crate::structure::stack::Stack;

/// Options of the check of a stack.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StackCheckOptions {
    /// Loads and soil.
    pub limits: StackLimits,
    /// Seismic demand. Default `None`.
    pub demand: Option<StackDemand>,
}

/// Result of the check of a stack.
#[derive(Clone, Debug, PartialEq)]
pub struct StackCheck {
    /// Results joint by joint.
    pub limits: StackLimitStates,
    /// The result of limit analysis: in the direction that governs, and if equilibrium alone does not determine the forces, in all
    /// directions. `None` if the stack does not stand.
    pub analysis: Option<LimitAnalysisResult>,
    /// Least acceleration at which it begins to move, by joints and limit analysis; `None` if it does not stand.
    pub capacity: Option<Threshold>,
    /// The least of those without some of the static loads that press on stones; `None` if none presses.
    pub least_pressed: Option<LeastPressed>,
    /// Whether the stack is stable, marginal or unstable without shaking.
    pub verdict: Verdict,
    /// The part that rocks first as one block; `None` if the stack does not stand, slides first or carries static loads.
    pub rocking: Option<RockingBlock>,
    /// Capacity without crushing, for comparison; `None` without a strength.
    pub crushing: Option<Crushing>,
    /// A period estimated from the height alone.
    pub period_of_thumb: PeriodOfThumb,
    /// Comparison with the demand, if there is one.
    pub demand: Option<DemandComparison>,
    /// Result while supports move, if supports move and the stack stands before.
    pub supports: Option<MovedSupports>,
    /// The run under its own weight, if friction carries stones and the run was requested: [`with_settle_run`](super::with_settle_run).
    pub settle_run: Option<SettleRun>,
    /// Notes on these numbers.
    pub notes: Vec<StackNote>,
}

/// Comparison of finite and infinite joint strength, before supports move and without a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crushing {
    /// Smallest strength of its joints, Pa.
    pub strength_pa: f64,
    /// Verdict with the strength.
    pub verdict: Verdict,
    /// Verdict with infinite strength.
    pub uncrushed_verdict: Verdict,
    /// Acceleration at which it begins to move with the strength, over gravity; `None` if it does not stand.
    pub moves_at_g: Option<f64>,
    /// The same with infinite strength; `None` if the stack does not stand even then.
    pub uncrushed_g: Option<f64>,
}

impl Crushing {
    /// Whether crushing makes the verdict worse, or reduces the capacity clearly.
    pub fn governs(&self) -> bool {
        let is_sooner = match (self.moves_at_g, self.uncrushed_g) {
            (Some(with), Some(without)) => with < (1.0 - CRUSHING_COUNTS) * without,
            (None, without) => without.is_some(),
            (Some(_), None) => false,
        };
        self.verdict > self.uncrushed_verdict || is_sooner
    }
}

/// Relative reduction of the capacity from which crushing governs. Our choice: less than the uncertainty of the dimensions.
const CRUSHING_COUNTS: f64 = 0.05;
/// Horizontal acceleration, over gravity, below which a stack that stands is "marginal", as [`LooseStones::MARGINAL_BELOW_G`].
pub const MARGINAL_BELOW_G: f64 = LooseStones::MARGINAL_BELOW_G;
/// Fraction of the friction with which equilibrium must still be possible; otherwise friction carries. Our choice: a bed inclined by
/// 3.4° needs a tenth of the usual 0.6, an arch a third and more.
const FRICTION_SPARE: f64 = 0.1;
/// Relative difference by which the limit analysis must be lower for a note; the solver loses 1e-8. Our choice.
const LOWER: f64 = 1e-4;

/// Checks a stack: whether it stands, what moves first and at what acceleration, and the demand.
///
/// # Errors
/// [`AssessError`] for options out of their range.
///
/// # Limits
/// As for [`stack_limits`] and [`limit_analysis`](crate::stability::stack::limit_analysis). The capacity is the onset of rocking or sliding, not collapse. It does not include
/// ties; cohesion resists sliding.
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
    let mut check = without_shaking(stack, options)?;
    let found = only_corners::Found {
        limits: &check.limits,
        analysis: check.analysis.as_ref(),
        capacity: check.capacity,
    };
    let corners = only_corners::note(stack, &options.limits, &found)?;
    check.notes.extend(corners);
    if let Some(strength_pa) = stack.least_strength_pa() {
        let uncrushed = without_shaking(&stack.clone().without_strength(), options)?;
        check.crushing = Some(Crushing {
            strength_pa,
            verdict: check.verdict,
            uncrushed_verdict: uncrushed.verdict,
            moves_at_g: check.capacity.map(|least| least.acceleration_g),
            uncrushed_g: uncrushed.capacity.map(|least| least.acceleration_g),
        });
    }
    if stack.is_pressed() {
        check.least_pressed = LeastPressed::of(stack, &options.limits, check.capacity)?;
        let without = check.least_pressed.as_ref().and_then(|least| least.capacity);
        check.notes.push(StackNote::LoadsWithoutMass {
            with_g: check.capacity.map(|capacity| capacity.acceleration_g),
            without_g: without.map(|least| least.acceleration_g),
        });
    }
    if check.verdict != Verdict::Unstable && !stack.support_movements().is_empty() {
        let following = SupportMovementOptions {
            loads: options.limits.loads.clone(),
            ..SupportMovementOptions::default()
        };
        check.supports = Some(follow_support_movement(stack, &following)?);
        check.verdict = with_movement(check.verdict, check.supports.as_ref());
    }
    // the rocking model is for one block without static loads
    let own_weight = stack.static_loads().is_empty();
    if let (Some(capacity), Some(uplift), true) = (check.capacity, check.limits.uplift, own_weight) {
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

/// The joints and the limit analysis only, without moving supports and demand.
fn without_shaking(stack: &Stack, options: &StackCheckOptions) -> Result<StackCheck, AssessError> {
    let limits = stack_limits(stack, &options.limits)?;
    let mut check = StackCheck {
        verdict: limits.verdict,
        analysis: None,
        capacity: None,
        least_pressed: None,
        rocking: None,
        crushing: None,
        period_of_thumb: period_of_thumb(stack.height_m())?,
        demand: None,
        supports: None,
        settle_run: None,
        notes: Vec::new(),
        limits,
    };
    note_what_is_left_out(stack, options, &mut check);
    check.notes.extend(kinetic_friction::of_single_joints(
        stack,
        &options.limits,
        &check.limits,
    )?);
    if check.limits.standing.stands() {
        analyse(stack, options, &mut check)?;
    }
    Ok(check)
}

/// Checks a stack with the gaps of its joints closed, and with the gaps open as drawn; the smaller capacity counts. If an open joint
/// leaves a stone without support, or the stack does not stand, the joint counts as closed.
///
/// # Errors
/// As [`check_stack`].
pub fn check_stack_with_gaps(
    stack: Stack,
    options: &StackCheckOptions,
) -> Result<(Stack, StackCheck), AssessError> {
    let mut closed = check_stack(&stack, options)?;
    let drawn_open = stack.joints_drawn_open();
    let joints = drawn_open.iter().map(|&joint| &stack.joints()[joint]);
    let Some(widest) = joints.max_by(|a, b| a.gap_m.total_cmp(&b.gap_m)) else {
        return Ok((stack, closed));
    };
    let (lower, upper, gap_m) = (widest.lower, widest.upper, widest.gap_m);
    let note = |gaps: Gaps| StackNote::Gaps {
        lower,
        upper,
        gap_m,
        joints: drawn_open.len(),
        gaps,
    };
    let Some(open) = stack
        .with_gaps_open()
        .filter(|_| closed.verdict != Verdict::Unstable)
    else {
        closed.notes.push(note(Gaps::Closed));
        return Ok((stack, closed));
    };
    let mut opened = check_stack(&open, options)?;
    let least = |check: &StackCheck| check.capacity.map_or(f64::INFINITY, |least| least.acceleration_g);
    if opened.verdict == Verdict::Unstable {
        closed.notes.push(note(Gaps::FallsOpen));
        closed.verdict = closed.verdict.max(Verdict::Marginal);
        return Ok((stack, closed));
    }
    // open as drawn, unless the capacity is then larger
    if least(&opened) > (1.0 + LOWER) * least(&closed) {
        closed.notes.push(note(Gaps::Closed));
        return Ok((stack, closed));
    }
    opened.notes.push(note(Gaps::Open {
        closed_g: closed.capacity.map(|least| least.acceleration_g),
    }));
    Ok((open, opened))
}

fn note_what_is_left_out(stack: &Stack, options: &StackCheckOptions, check: &mut StackCheck) {
    if !check.limits.statically_determinate {
        check.notes.push(StackNote::SharedLoad);
        if stack.least_strength_pa().is_some() {
            check.notes.push(StackNote::StrengthFromInside);
        }
    }
    check.notes.extend(StackNote::of_slivers(stack));
    let joints = stack.joints();
    if joints.iter().any(|joint| joint.material.cohesion_pa > 0.0) {
        check.notes.push(StackNote::CohesionCounted);
    }
    if joints.iter().any(|joint| joint.material.tension_pa > 0.0) {
        check.notes.push(StackNote::TensionLeftOut);
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

/// Limit analysis in addition to the single joints; the smaller result is the capacity.
fn analyse(stack: &Stack, options: &StackCheckOptions, check: &mut StackCheck) -> Result<(), AssessError> {
    let motion = FirstMotion::of(stack, &options.limits, &check.limits)?;
    check.capacity = motion.capacity();
    let is_between = motion.is_between();
    let FirstMotion {
        found,
        soil,
        governing,
        least,
        at_least_g,
    } = motion;
    let falls = found.analysis.status == LimitAnalysisStatus::DoesNotStand;
    check.analysis = Some(found.analysis);
    if let Some(least) = least.filter(|_| !falls) {
        if governing.is_none_or(|joints| least.acceleration_m_s2 < (1.0 - LOWER) * joints.acceleration_m_s2) {
            check.notes.push(StackNote::AnalysisLower {
                joints_g: governing.map(|joints| joints.acceleration_g),
                analysis_g: least.acceleration_g,
            });
        }
        if is_between {
            check.notes.push(StackNote::AnalysisBetween {
                at_least_g,
                analysis_g: least.acceleration_g,
            });
        }
    }
    if falls || (least.is_some() && check.capacity.is_none()) {
        check.verdict = Verdict::Unstable;
        check.notes.push(StackNote::AnalysisFalls);
        return Ok(());
    }
    if let (Some(dilating_g), Some(least)) = (found.dilating_g, least)
        && least.acceleration_g < (1.0 - BETWEEN) * soil.over_gravity(dilating_g, &least)
    {
        check.notes.push(StackNote::WithoutDilatancy {
            dilating_g: soil.over_gravity(dilating_g, &least),
            without_g: least.acceleration_g,
        });
    }
    if found.is_upper_bound && !check.limits.statically_determinate {
        check.notes.push(StackNote::UpperBound);
    }
    check.notes.extend(kinetic_friction::of_shared_loads(
        stack,
        &options.limits,
        &check.limits,
    )?);
    // forces that balance the weight exist: it stands
    let carries = !check.limits.statically_determinate && friction_carries(stack, options, check)?;
    if carries {
        check.notes.push(StackNote::FrictionCarries);
    }
    let bonded = joint_bonds(stack) && bond_carries(stack, options, check)?;
    if bonded {
        check.notes.push(StackNote::BondCarries);
    }
    let by_margins = by_margins(check);
    check.verdict = match carries {
        true => by_margins.max(Verdict::Marginal),
        false => by_margins,
    };
    Ok(())
}

fn joint_bonds(stack: &Stack) -> bool {
    stack
        .joints()
        .iter()
        .any(|joint| joint.material.cohesion_pa > 0.0)
}

/// Whether the stack stands only with the bond of its joints.
fn bond_carries(stack: &Stack, options: &StackCheckOptions, check: &StackCheck) -> Result<bool, AssessError> {
    let direction = check.capacity.map_or([1.0, 0.0], |capacity| capacity.direction);
    let loads = loads_at_rest(stack, options)?;
    Ok(!stands_by_limit_analysis(stack, &loads, direction)?)
}

/// The verdict, modified by the result for moving supports.
pub(super) fn with_movement(verdict: Verdict, supports: Option<&MovedSupports>) -> Verdict {
    let Some(supports) = supports else { return verdict };
    let at_least = |other: Verdict| match verdict {
        Verdict::Unstable => Verdict::Unstable,
        verdict => verdict.max(other),
    };
    match (supports.ending, &supports.given) {
        (MovementEnding::Falls { .. }, None) => Verdict::Unstable,
        (_, None) => at_least(Verdict::Unknown),
        (MovementEnding::Falls { .. }, Some(_)) if supports.is_near() => at_least(Verdict::Marginal),
        (MovementEnding::Stands, Some(_)) if supports.is_near() => at_least(Verdict::Unknown),
        _ => verdict,
    }
}

/// Verdict of a stack that stands: by its joints and by its smallest capacity.
pub(super) fn by_margins(check: &StackCheck) -> Verdict {
    let by_joints = check
        .limits
        .gravity_margin
        .map_or(Verdict::Stable, Verdict::of_gravity_margin);
    let is_doubted = check.notes.iter().any(|note| {
        let falls_open = matches!(
            note,
            StackNote::Gaps {
                gaps: Gaps::FallsOpen,
                ..
            }
        );
        falls_open
            || matches!(
                note,
                StackNote::BondCarries | StackNote::KineticFalls | StackNote::SliversCarry { .. }
            )
    });
    let is_near = check
        .capacity
        .is_some_and(|least| least.acceleration_g < MARGINAL_BELOW_G);
    match is_near || is_doubted {
        true => by_joints.max(Verdict::Marginal),
        false => by_joints,
    }
}

/// Whether equilibrium is impossible with a tenth of the friction and no bond; then it does not exclude slip.
fn friction_carries(
    stack: &Stack,
    options: &StackCheckOptions,
    check: &StackCheck,
) -> Result<bool, AssessError> {
    let mut smooth = stack.clone();
    for (index, joint) in stack.joints().iter().enumerate() {
        let mut material = joint.material;
        material.friction_static *= FRICTION_SPARE;
        material.friction_kinetic = material.friction_kinetic.min(material.friction_static);
        smooth = smooth.with_material(index, material)?;
    }
    let direction = check.capacity.map_or([1.0, 0.0], |capacity| capacity.direction);
    let loads = loads_at_rest(stack, options)?;
    Ok(!stands_by_limit_analysis(&smooth, &loads, direction)?)
}

/// The loads, with the lateral part that the weight has on a footing turned by them.
fn loads_at_rest(stack: &Stack, options: &StackCheckOptions) -> Result<StackLoads, AssessError> {
    let mut loads = options.limits.loads.clone();
    let turn = turned_at_rest(stack, &loads)?.unwrap_or_default();
    let gravity_m_s2 = stack.gravity_m_s2() + loads.vertical_acceleration_m_s2;
    for (lateral, turn) in loads.lateral_m_s2.iter_mut().zip(turn) {
        *lateral += gravity_m_s2 * turn;
    }
    Ok(loads)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stability::stack::{DemandVerdict, OnSoil, SpectralDemand};
    use crate::structure::stack::{Block, JointMaterial, Placement, SoilBelow, Solid};

    /// Boxes [width, depth, height] and the centre of the base of each.
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
        assert!(check.notes.is_empty() && check.analysis.is_some());
    }

    #[test]
    fn exact_soil_agrees_between_both_ways() {
        let soil = SoilBelow {
            rocking_stiffness_n_m_rad: 10.0 * 0.32 * 2600.0 * 9.81,
            normal_stiffness_pa_m: 10.0 * 0.32 * 2600.0 * 9.81 * 12.0 / 0.4_f64.powi(4),
            shear_stiffness_pa_m: 1e8,
        };
        let stack = boxes(&[([0.4, 0.4, 2.0], [0.0; 3])], 0.6)
            .with_soil(soil)
            .unwrap();
        let mut options = StackCheckOptions::default();
        options.limits.loads.lateral_m_s2 = [0.05 * 9.81, 0.0];
        let check = check_stack(&stack, &options).unwrap();
        // b/(2 h) (1 - (S/K)^⅓), less the lateral load
        let exact = 0.2 * (1.0 - 0.1_f64.cbrt()) - 0.05;
        let LimitAnalysisStatus::Limited(rigid) = check.analysis.as_ref().unwrap().status else {
            panic!("no limit")
        };
        let soil = OnSoil::of(&stack, &options.limits.loads).unwrap();
        assert!((soil.threshold(&rigid).acceleration_g - exact).abs() < 1e-8);
        assert!((check.capacity.unwrap().acceleration_g - exact).abs() < 1e-8);
    }

    #[test]
    fn holds_where_stones_share_their_load_the_analysis_decides() {
        // a beam on two pillars sways along x at 0.4/2 g; each pillar alone, with the beam as weight only, would resist more
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
    fn exact_notes_on_bond_and_kinetic_friction() {
        let weight = 0.32 * 2600.0 * 9.81;
        let material = JointMaterial {
            friction_kinetic: 0.5,
            cohesion_pa: 0.1 * weight / 0.16,
            tension_pa: 1e3,
            ..JointMaterial::default()
        };
        let stack = boxes(&[([0.4, 0.4, 0.5], [0.0; 3])], 0.6);
        let dry = check_stack(&stack, &StackCheckOptions::default()).unwrap();
        assert!(dry.notes.is_empty());
        // weight a quarter of that of 2 m: cohesion adds .4, so it slides at 1.0 and rocks at .8
        let stack = stack.with_material(0, material).unwrap();
        let check = check_stack(&stack, &StackCheckOptions::default()).unwrap();
        assert!((check.capacity.unwrap().acceleration_g - 0.8).abs() < 1e-8);
        let [
            StackNote::CohesionCounted,
            StackNote::TensionLeftOut,
            StackNote::KineticLess { slides_at_g },
        ] = check.notes[..]
        else {
            panic!("{:?}", check.notes)
        };
        assert!((slides_at_g - 0.9).abs() < 1e-9, "{slides_at_g}");
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
        assert!(check.analysis.is_none());
    }
}
