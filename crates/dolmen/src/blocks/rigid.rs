//! Time integration with the rigid contact law: stones neither deform nor overlap, and impacts are located within the step.
//!
//! Stages of a step at time t: update the contacts of pairs that have moved far → velocities at t + h/2 that satisfy every contact
//! ([`super::rigid_solve`]) → positions at t + h, or at the first impact before it → velocities after the impact → the remaining part of the step.

use super::after_fall::AfterFall;
use super::assembly::Assembly;
use super::contact_points::ContactRule;
use super::contact_tolerances::ContactTolerances;
use super::error::{BlocksError, check_times};
use super::history::StackHistory;
use super::matrices::longest_step_of_held;
use super::moving_ground::{MovingGround, OwnGround};
use super::observe::Observer;
use super::rigid_run::Run;
use super::run_length::RunLength;
use super::set_back::assembly_that_crushes;
use super::springs::{Start, push};
use crate::signal::GroundMotion;
use crate::structure::stack::{Body, JointMaterial, Stack};
use glam::DVec3;

/// Tolerances for contact detection, larger than for the springs law because the steps are longer. Our choice: contacts of stones that approach at
/// less than about 2 m/s are detected before they touch.
const WATCHFULNESS: ContactTolerances = ContactTolerances {
    clip_again: 5e-5,
    near: 2e-2,
    far: 5e-2,
};

/// Longest step, s. Our choice: with steps of 50 ms, a motion sampled every 20 ms left 0.5 mm of slip instead of 24 mm.
const STEP_MOST_S: f64 = 5e-3;

/// Largest and usual step, as fractions of the longest step that is stable for dowels, clamps and side supports. Our choice: with the usual step, the
/// apparent energy of a stone that oscillates on such a spring changes by less than 0.1 %, (ω h)²/4.
const HELD_MOST: f64 = 0.9;
const HELD_USUAL: f64 = 0.03;

/// Usual steps, s: for equal static and kinetic friction, and for kinetic friction below static friction.
const USUAL_STEP_S: f64 = 1e-3;
const KINETIC_STEP_S: f64 = 2e-4;

/// Options of [`simulate_rigid`].
#[derive(Clone, Debug, PartialEq)]
pub struct Rigid {
    /// Contact points of a joint. Default 4 × 4.
    pub contact_rule: ContactRule,
    /// Time step, s, up to 5e-3. Default 1e-3; see [`Rigid::usual_step_s`].
    pub time_step_s: f64,
    /// Duration of the run, s. Default `None`: the motion plus `rest_s`, then until the stack is at rest or rocks with decreasing amplitude, for at
    /// most [`StackHistory::LONGER_MOST_S`].
    pub duration_s: Option<f64>,
    /// Time that is always simulated after the motion, s. Default 2.
    pub rest_s: f64,
    /// Time between samples of the history, s, rounded to a whole number of steps. Default 0.01.
    pub output_step_s: f64,
    /// What happens after a stone has fallen. Default: the run stops.
    pub after_fall: AfterFall,
    /// Initial velocities of stones. Default none.
    pub starts: Vec<Start>,
    /// Whether to run more than 20 million steps or a million samples. Default: such a run is refused.
    pub however_long: bool,
}

impl Default for Rigid {
    fn default() -> Self {
        Rigid {
            contact_rule: ContactRule::Four,
            time_step_s: USUAL_STEP_S,
            duration_s: None,
            rest_s: 2.0,
            output_step_s: 0.01,
            after_fall: AfterFall::Stop,
            starts: Vec::new(),
            however_long: false,
        }
    }
}

impl Rigid {
    /// The usual step for a stack, s: 1 ms, or 0.2 ms if the kinetic friction of a joint is below its static friction. A slowly sliding stone comes
    /// to rest within a step, and static friction then holds it. Under two-component noise, with μ 0.4 and 0.25, the slip of a block was therefore
    /// 3.8 % too small (6.0 % of the residual slip) at 1 ms, and 0.16 % at 0.2 ms. With dowels, clamps or side supports the step is at most 0.03 of
    /// the longest step that is stable for them.
    ///
    /// ```
    /// use dolmen::blocks::Rigid;
    /// use dolmen::structure::stack::JointMaterial;
    /// let alike = JointMaterial::with_friction(0.6);
    /// let easier = JointMaterial { friction_kinetic: 0.5, ..alike };
    /// assert_eq!(Rigid::usual_step_s(&dolmen::comparisons::p10(alike, 9.81)?), 1e-3);
    /// assert_eq!(Rigid::usual_step_s(&dolmen::comparisons::p10(easier, 9.81)?), 2e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn usual_step_s(stack: &Stack) -> f64 {
        let slides_easier = |of: &JointMaterial| of.friction_kinetic < of.friction_static;
        let mut materials = stack
            .joints()
            .iter()
            .map(|joint| &joint.material)
            .chain(stack.loose_material());
        let usual = match materials.any(slides_easier) {
            true => KINETIC_STEP_S,
            false => USUAL_STEP_S,
        };
        if stack.ties().is_empty() && stack.side_supports().is_empty() {
            return usual;
        }
        let held = HELD_USUAL * longest_step_of_held(&Assembly::of(stack, ContactRule::Four));
        // the usual step is a whole multiple of this step, so that samples fall on steps
        usual / (usual / held).ceil().max(1.0)
    }
}

/// Motion of a stack of rigid stones under base motion, with the rigid contact law: stones neither deform nor overlap.
///
/// `progress` receives the simulated time at intervals, and stops the run by returning false. If a step has no solution, the run ends as
/// [`super::Outcome::NotConverged`]. [`StackHistory::rigid`] contains the residuals of the contact law.
///
/// ```text
/// M (v⁺ − v⁻) = κ f + Σ Gᵀ p               kick over κ: half the step before and half the step after
/// 0 ≤ gap⁺ ⟂ p_n ≥ 0                       gap at the end of the drift, so that penetrations do not accumulate
/// |p_t| ≤ μ p_n,  p_t = −μ p_n u_t/|u_t| where the point slips                 (Coulomb's disc)
/// impact, inside the step:  0 ≤ u_n⁺ ⟂ p_n ≥ 0,  and  0 ≤ ū_n⁺ + e ū_n⁻ ⟂ p̄ ≥ 0  for the mean over the points in contact
/// ```
///
/// # Errors
/// [`BlocksError`] for options out of range, a block that does not exist, a step too long for dowels, clamps or side supports, and for bonds
/// (cohesion, tension), which need the springs law.
///
/// # Limits
/// Stones are rigid; contact is between convex hulls. In a joint with a compressive strength, stones rotate about the middle of the strip that crushes at
/// rest, and its largest load is compared with what the bed bears, without impacts. Impacts are located within the step, ends of slips are not. In each joint only the total force
/// and torque are unique; their distribution over the points is that of a uniform elastic bed. With friction and rocking together several solutions
/// may exist (Painlevé); the method always finds the same one. Dowels, clamps and side supports are springs that act at the positions of each step,
/// as in [`super::simulate_springs`]. Tested by `stack_rigid`.
///
/// # Source
/// Moreau, J. J. (1988) in Nonsmooth Mechanics and Applications, CISM 302; Alart, P. & Curnier, A. (1991) Comput. Methods Appl.
/// Mech. Eng. 92:353-375. Differs from the sources: leapfrog positions instead of the θ method; gaps instead of velocities while stones stay in
/// touch; restitution of the mean velocity over a face instead of each point; the Newton matrix is that of the bodies, with the contacts eliminated.
///
/// # Example
/// ```
/// use dolmen::blocks::{Outcome, Rigid, simulate_rigid};
/// use dolmen::structure::stack::{Block, JointMaterial, Solid, Stack};
/// let stone = Block { name: "stone".into(), solid: Solid::cuboid(0.3, 0.2, 0.1)?, density_kg_m3: 2600.0 };
/// let stack = Stack::new(vec![stone], JointMaterial::default(), 9.81)?;
/// let options = Rigid { duration_s: Some(0.1), ..Rigid::default() };
/// let history = simulate_rigid(&stack, None, &options, &mut |_| true)?;
/// assert_eq!(history.outcome, Outcome::Stood);
/// assert_eq!(history.poses[0], *history.poses.last().unwrap()); // no motion, to the last bit
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn simulate_rigid(
    stack: &Stack,
    motion: Option<&GroundMotion>,
    options: &Rigid,
    progress: &mut dyn FnMut(f64) -> bool,
) -> Result<StackHistory, BlocksError> {
    let under = RigidRunUnder {
        motion,
        ..RigidRunUnder::default()
    };
    simulate_rigid_under(stack, under, options, progress)
}

/// What acts on a stack during a run besides its weight.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct RigidRunUnder<'a> {
    pub(super) motion: Option<&'a GroundMotion>,
    /// Moving supports.
    pub(super) moving: Option<&'a MovingGround>,
    /// Rate at which every velocity decays until the stones are at rest, 1/s.
    pub(super) drag_per_s: f64,
}

/// As [`simulate_rigid`], for a stack whose supports may move, or whose velocities decay.
pub(super) fn simulate_rigid_under(
    stack: &Stack,
    RigidRunUnder {
        motion,
        moving,
        drag_per_s,
    }: RigidRunUnder<'_>,
    options: &Rigid,
    progress: &mut dyn FnMut(f64) -> bool,
) -> Result<StackHistory, BlocksError> {
    let h = options.time_step_s;
    check_times(Some(h), options.duration_s, options.output_step_s, options.rest_s)?;
    if h > STEP_MOST_S {
        return Err(BlocksError::Option {
            option: "time_step_s",
            given: h,
            allowed: "5e-3 or less: longer steps pass over the motion of the ground and what stones do in it",
        });
    }
    refuse_bonds(stack)?;
    let mut assembly = assembly_that_crushes(stack, options.contact_rule)?;
    assembly.without_springs();
    if h > HELD_MOST * longest_step_of_held(&assembly) {
        return Err(BlocksError::Option {
            option: "time_step_s",
            given: h,
            allowed: "so short that it follows the dowels, clamps and side supports: as Rigid::usual_step_s gives it, or less",
        });
    }
    assembly.watch(WATCHFULNESS);
    let own = moving.map(|moving| OwnGround::under(&mut assembly, stack, moving));
    let moves_for_s = moving.map_or(0.0, MovingGround::duration_s);
    let shaken_s = motion.map_or(moves_for_s, GroundMotion::duration_s);
    let mut length = RunLength::of(
        options.duration_s,
        [shaken_s, options.rest_s],
        [h, options.output_step_s],
        options.however_long,
    )?;
    let mut observer = Observer::new(stack, &assembly, options.output_step_s, h);
    for start in &options.starts {
        push(&mut assembly, start)?;
    }
    let mut run = Run::of(assembly, h);
    run.ground = own.unwrap_or_default();
    run.drag_per_s = drag_per_s;
    let ground = |time_s: f64| match motion {
        Some(motion) => DVec3::from(motion.acceleration_at_m_s2(time_s)),
        None => DVec3::ZERO,
    };
    for step in 0.. {
        if length.is_over(step, &mut observer, &run.assembly) {
            if run.drag_per_s == 0.0 || !observer.is_at_rest(&run.assembly) {
                break;
            }
            run.drag_per_s = 0.0; // the stones are released
            length = length.again_from(step);
        }
        let time_s = step as f64 * h;
        let begun = run.begin(time_s, &ground);
        if begun.is_ok() {
            run.see_loads(time_s, ground(time_s));
        }
        if observer.wants(step) {
            let seen = [time_s, 2.0 * run.lag_s()];
            observer.see(&run.assembly.bodies);
            observer.look(
                &run.assembly,
                run.acceleration(),
                run.forces(),
                ground(time_s),
                seen,
            );
            if observer.ended(options.after_fall) {
                break;
            }
            if !progress(time_s) {
                observer.stop(time_s);
                break;
            }
        }
        match begun.and_then(|()| run.finish(time_s, &ground)) {
            Ok(()) => observer.count(run.take_counted()),
            Err(residual_m_s) => {
                observer.not_converged(time_s, residual_m_s);
                break;
            }
        }
    }
    let evidence = run.evidence;
    let history = observer.finish(&run.assembly, [h, h]);
    Ok(StackHistory {
        rigid: Some(evidence),
        ..history
    })
}

/// Refuses bonds: the rigid law has no tensile force between faces.
fn refuse_bonds(stack: &Stack) -> Result<(), BlocksError> {
    let name = |block: usize| stack.blocks().get(block).map_or("", |block| block.name.as_str());
    let between = |lower: Body, upper: usize| match lower {
        Body::Ground => format!("the ground and '{}'", name(upper)),
        Body::Block(lower) => format!("'{}' and '{}'", name(lower), name(upper)),
    };
    let refuse = |what: String, quantity, given| {
        Err(BlocksError::SpringsOnly {
            what,
            quantity,
            given,
        })
    };
    for joint in stack.joints() {
        for (quantity, given) in [
            ("cohesion_pa", joint.material.cohesion_pa),
            ("tension_pa", joint.material.tension_pa),
        ] {
            if given > 0.0 {
                let what = format!("the joint between {}", between(joint.lower, joint.upper));
                return refuse(what, quantity, given);
            }
        }
    }
    Ok(())
}
