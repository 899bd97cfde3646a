//! `dolmen simulate`: a structure under a ground motion, with a push, or on moving supports.

use crate::at_rest::{AtRest, WAIT_MOST_S};
use crate::building::simulate::BuildingOptions;
use crate::building::wind_history::{WindOptions, simulate_wind};
use crate::chain::simulate::ChainOptions;
use crate::check::{CheckOptions, state_of};
use crate::error::{Within as _, WorkError};
use crate::frame::simulate::FrameOptions;
use crate::judgement::{Basis, Evidence, Weight, drift_left, governing, is_tilt_beyond};
use crate::kinds;
use crate::motion::{MotionAnswer, MotionRequest, in_sequence, prepared, refuse_other_components};
use crate::opened::Opened;
use crate::progress::Progress;
use crate::simulation::{AfterFirst, Second, SimulateAnswer, Simulation, WithoutShaking};
use crate::stack::moving_supports::{Supported, supports};
use crate::stack::simulate::{StackOptions, StackOutcome};
use crate::stack::{Law, Repeating};
use crate::state::{Check, State};
use crate::tilt_left_out::TiltLeftOut;
use crate::version::Version;
use crate::{building, chain, frame, stack};
use dolmen::blocks::ContactRule;
use dolmen::dynamics::ChainRotations;
use dolmen::signal::Component;
use dolmen::stability::Verdict;
use dolmen_project::{Project, Quantity, StackPart, Structure, parse_angle_rad};
use dolmen_records::Files;

/// Options of a simulation. [`refuse_foreign`](crate::flags) refuses options that the kind does not use.
#[derive(Clone, Debug, PartialEq)]
pub struct SimulateOptions {
    /// The motion.
    pub motion: MotionRequest,
    /// A second motion, by its name, that acts after the first, once the structure is at rest.
    pub then: Option<String>,
    /// A variant instead of the structure as it is.
    pub variant: Option<String>,
    /// Direction of a frame; by default each of known stiffness.
    pub direction: Option<String>,
    /// Initial lean of a chain, "1e-4 rad" or "0.5 deg".
    pub push: Option<String>,
    /// Linear or exact equations for a chain.
    pub rotations: ChainRotations,
    /// The law of contact of a stack.
    pub law: Law,
    /// Contact points of a joint of a stack.
    pub contact_rule: ContactRule,
    /// Time step, s; by default that of the kind.
    pub step_s: Option<f64>,
    /// Length of the run, s; by default that of the kind.
    pub duration_s: Option<f64>,
    /// Time between samples of the histories, s.
    pub output_step_s: f64,
    /// Whether to continue after a stone has fallen.
    pub to_the_end: bool,
    /// Whether to compute a run of very many steps or samples.
    pub however_long: bool,
    /// Number of runs of a stack, all except the first with small differences.
    pub repeats: Repeating,
    /// Options of the wind of the file on a building, instead of a motion of the ground; `None` for none.
    pub wind: Option<WindAsked>,
    /// Whether to run a building also without its dampers.
    pub compare: bool,
    /// Whether to keep every history of a building.
    pub keep: bool,
}

impl Default for SimulateOptions {
    fn default() -> Self {
        SimulateOptions {
            motion: MotionRequest::default(),
            then: None,
            variant: None,
            direction: None,
            push: None,
            rotations: ChainRotations::Large,
            law: Law::AsKnown,
            contact_rule: ContactRule::Four,
            step_s: None,
            duration_s: None,
            output_step_s: 0.01,
            to_the_end: false,
            however_long: false,
            repeats: Repeating::QUICK,
            wind: None,
            compare: true,
            keep: true,
        }
    }
}

/// Histories of the wind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WindAsked {
    /// Seed of the first history; the others use the next numbers.
    pub seed: u64,
    /// Number of histories for the wind along x and along y; 10 by default.
    pub repeats: Option<usize>,
}

/// A prepared simulation with its inputs, so that a run can be announced before it begins.
#[derive(Debug)]
pub struct PreparedSimulation<'a> {
    version: Version<'a>,
    motion: Option<MotionAnswer>,
    then: Option<MotionAnswer>,
    options: &'a SimulateOptions,
}

/// Finds the version and its motion.
///
/// # Errors
/// An unknown variant, a kind that cannot be simulated, a push on a structure that is not a chain, a motion that is missing or refused.
pub fn prepare<'a>(
    opened: &'a Opened,
    options: &'a SimulateOptions,
    files: &dyn Files,
) -> Result<PreparedSimulation<'a>, WorkError> {
    let version = Version::named(opened, options.variant.as_deref())?;
    let is_chain = matches!(version.project.structure, Structure::Chain(_));
    if options.push.is_some() && !is_chain {
        return Err(WorkError::PushOfOther);
    }
    if options.wind.is_some() {
        let motion = &options.motion;
        if motion.is_given() || motion.is_changed() || motion.of_files().is_some() || options.then.is_some() {
            return Err(WorkError::WindAndMotion);
        }
        if version.project.loads.wind().is_none() {
            return Err(WorkError::NoWindGiven);
        }
    }
    let needs_none = is_chain || moves_supports(version.project) || settles(version.project);
    let stays_still = options.wind.is_some() || needs_none && !options.motion.is_given();
    let motion = match stays_still {
        true => None,
        false => Some(prepared(&options.motion, (version.project, files))?),
    };
    let then = match (&options.then, &motion) {
        (None, _) => None,
        (Some(_), None) => return Err(WorkError::ThenWithoutMotion),
        (Some(_), Some(_)) if options.duration_s.is_some() => return Err(WorkError::ThenAndDuration),
        (Some(name), Some(first)) => {
            let then = prepared(&MotionRequest::named(name), (version.project, files))?;
            if !matches!(version.project.structure, Structure::Stack(_)) {
                refuse_other_components(&first.motion, &then.motion)?;
            }
            Some(then)
        }
    };
    Ok(PreparedSimulation {
        version,
        motion,
        then,
        options,
    })
}

/// Whether the supports of a stack move: the file has movements, and there is no motion.
pub(crate) fn moves_supports(project: &Project) -> bool {
    let Structure::Stack(part) = &project.structure else {
        return false;
    };
    !part.support_movement.is_empty() && project.motions.is_empty()
}

/// Whether the stones of a stack are loose, so that they settle first.
pub fn is_loose(project: &Project) -> bool {
    matches!(&project.structure, Structure::Stack(part) if part.is_loose)
}

/// Whether loose stones settle without a motion.
fn settles(project: &Project) -> bool {
    is_loose(project) && project.motions.is_empty()
}

/// The loose stones of a project and of each variant at rest, by both laws and without a motion: their check.
///
/// # Errors
/// [`WorkError`] if the stones are not loose, or a run is refused.
pub fn settle(opened: &Opened, progress: &dyn Progress) -> Result<SimulateAnswer, WorkError> {
    let options = SimulateOptions::default();
    settled_versions(opened, |version| run_one(version, None, &options, progress))
}

/// The loose stones of a project and of each variant at rest, by both laws, and then under a motion.
///
/// # Errors
/// [`WorkError`] if the stones are not loose, or a run is refused.
pub(crate) fn settle_and_shake(
    opened: &Opened,
    options: &SimulateOptions,
    files: &dyn Files,
    progress: &dyn Progress,
) -> Result<SimulateAnswer, WorkError> {
    settled_versions(opened, |version| {
        let options = SimulateOptions {
            variant: version.variant.map(str::to_owned),
            ..options.clone()
        };
        prepare(opened, &options, files)?.run(progress)
    })
}

/// The answer on loose stones as they are, with the runs of every variant.
fn settled_versions(
    opened: &Opened,
    run: impl Fn(&Version<'_>) -> Result<SimulateAnswer, WorkError>,
) -> Result<SimulateAnswer, WorkError> {
    let mut answer = run(&Version::named(opened, None)?)?;
    for variant in &opened.project.variants {
        if !is_loose(&variant.project) {
            let variant = variant.name.clone();
            return Err(WorkError::PlacedVariant { variant });
        }
        let version = Version::named(opened, Some(&variant.name))?;
        answer.simulations.extend(run(&version)?.simulations);
    }
    Ok(answer)
}

/// Evidence of a project's surveys for its model as it is.
///
/// # Errors
/// A structure that cannot be built.
pub fn evidence_of(opened: &Opened) -> Result<Evidence, WorkError> {
    evidence(&opened.project, None)
}

/// Evidence of the surveys for the model; none for a variant, or if no survey measured a frequency.
pub(crate) fn evidence(project: &Project, variant: Option<&str>) -> Result<Evidence, WorkError> {
    let surveys = &project.surveys;
    let is_measured = surveys
        .iter()
        .any(|survey| !survey.modes.is_empty() || survey.records.is_some() || !survey.setups.is_empty());
    if variant.is_some() || !is_measured || is_loose(project) {
        return Ok(Evidence::none());
    }
    let check = kinds::check(project, &mut Quantity::nominal)?;
    Ok(check.map_or_else(Evidence::none, |check| Evidence::of(project, &check)))
}

/// State of a structure without any shaking, if it is not "stable": with its static loads and wind, for a frame also with its lean. Without
/// loads a stack that does not stand is not simulated.
fn without_shaking(project: &Project) -> Result<Option<WithoutShaking>, WorkError> {
    let asks_check = match &project.structure {
        Structure::Chain(_) | Structure::Stack(_) => !project.loads.is_empty(),
        Structure::Frame(part) => part.lean.is_some() || !project.loads.is_empty(),
        Structure::Building(_) | Structure::Survey => false,
    };
    if asks_check {
        let state = state_of(project, &CheckOptions::default())?;
        return Ok(state.as_ref().and_then(unless_stable));
    }
    let factor = kinds::least_load_factor(project, &mut Quantity::nominal)?;
    let weight = match factor.map(Verdict::of_load_factor) {
        Some(Verdict::Marginal) => Weight::Marginal,
        // only friction, or a post with a gap, supports it
        Some(Verdict::Unstable) => Weight::Unstable,
        Some(Verdict::Stable | Verdict::Unknown) | None => return Ok(None),
    };
    Ok(Some(WithoutShaking {
        weight,
        governed_by: None,
    }))
}

/// That of a checked structure; `None` if it is "stable".
fn unless_stable(state: &State) -> Option<WithoutShaking> {
    let weight = Weight::of(state, false);
    (weight != Weight::Stable).then(|| WithoutShaking {
        weight,
        governed_by: governing(state, weight),
    })
}

fn stack_options(options: &SimulateOptions) -> StackOptions {
    StackOptions {
        law: options.law,
        contact_rule: options.contact_rule,
        step_s: options.step_s,
        duration_s: options.duration_s,
        output_step_s: options.output_step_s,
        to_the_end: options.to_the_end,
        however_long: options.however_long,
        repeats: options.repeats,
    }
}

impl PreparedSimulation<'_> {
    /// The project, or its variant.
    pub fn project(&self) -> &Project {
        self.version.project
    }

    /// The acting motion; `None` for a chain with a push, and for a stack whose supports move.
    pub fn motion(&self) -> Option<&MotionAnswer> {
        self.motion.as_ref()
    }

    /// The second motion.
    pub fn then(&self) -> Option<&MotionAnswer> {
        self.then.as_ref()
    }

    /// Whether the supports of a stack move instead.
    pub fn moves_supports(&self) -> bool {
        self.motion.is_none() && moves_supports(self.version.project)
    }

    /// Whether loose stones settle without a motion.
    pub fn settles(&self) -> bool {
        self.motion.is_none() && settles(self.version.project)
    }

    /// Runs the simulation; with two motions the first alone, then both as one with the time to rest between them.
    ///
    /// # Errors
    /// [`WorkError`] if the structure cannot be built, its stiffness is unknown, or the run is refused.
    pub fn run(self, progress: &dyn Progress) -> Result<SimulateAnswer, WorkError> {
        let PreparedSimulation {
            version,
            motion,
            then,
            options,
        } = self;
        match motion.clone().zip(then) {
            Some(both) => run_after(&version, both, options, progress),
            None => run_one(&version, motion, options, progress),
        }
    }
}

/// Runs the first motion alone, extended until the structure is at rest, then both as one. Repeats with small differences are of both.
fn run_after(
    version: &Version<'_>,
    (first, second): (MotionAnswer, MotionAnswer),
    options: &SimulateOptions,
    progress: &dyn Progress,
) -> Result<SimulateAnswer, WorkError> {
    let mut once = SimulateOptions {
        repeats: Repeating::Times(1),
        ..options.clone()
    };
    let whole_s = first.motion.duration_s();
    let (alone, rest) = loop {
        let alone = run_one(version, Some(first.clone()), &once, progress)?;
        let rest = rest_of(&alone.simulations);
        match rest {
            Some(rest) if !rest.is_at_rest() && 2.0 * (rest.end_s - whole_s) <= WAIT_MOST_S => {
                once.duration_s = Some(2.0 * rest.end_s - whole_s);
            }
            rest => break (alone, rest),
        }
    };
    let (first_motion, second_motion) = (first.motion.name().to_owned(), second.motion.name().to_owned());
    let (mut answer, second) = match rest {
        Some(AtRest { end_s, speed_m_s }) => {
            let (both, still_s) = in_sequence(first, end_s - whole_s, second)?;
            let acted = Second::Acted {
                still_s,
                speed_m_s,
                from_s: whole_s + still_s,
            };
            (run_one(version, Some(both), options, progress)?, acted)
        }
        None if alone.does_not_stand.is_some() => return Ok(alone),
        None => {
            let falls = alone.simulations.iter().any(Simulation::falls);
            let why = match falls {
                true => Second::FellBefore,
                false => Second::NoVerdictBefore,
            };
            (alone.clone(), why)
        }
    };
    answer.after = Some(Box::new(AfterFirst {
        first_motion,
        second_motion,
        first: alone,
        second,
    }));
    Ok(answer)
}

/// The end of every run of one motion; `None` without a ground motion, or if a run has no verdict or fell.
fn rest_of(simulations: &[Simulation]) -> Option<AtRest> {
    let mut all = Vec::new();
    for simulation in simulations {
        match simulation {
            Simulation::Stack(runs) if runs.each().all(|run| run.is_whole() && !run.falls()) => {
                all.extend(runs.each().map(|run| AtRest::of_stack(&run.history)));
            }
            Simulation::Frame(run) if run.is_whole() && !run.falls() => {
                all.push(AtRest::of_frame(&run.history));
            }
            Simulation::Chain(run) if run.is_whole() && !run.falls() => {
                all.push(AtRest::of_chain(&run.model, &run.history));
            }
            _ => return None,
        }
    }
    all.into_iter().reduce(AtRest::worse)
}

/// A stack on supports that move, with its check.
fn on_moving_supports(
    version: &Version<'_>,
    part: &StackPart,
    how: &StackOptions,
    progress: &dyn Progress,
    answer: &mut SimulateAnswer,
) -> Result<(), WorkError> {
    let state = state_of(version.project, &CheckOptions::default())?;
    answer.without_shaking = state.as_ref().and_then(unless_stable);
    let Some(Check::Stack(checked)) = state.map(|state| state.check) else {
        return Err(WorkError::NoMotionPrepared);
    };
    match supports(version, part, (*checked, how), progress)? {
        Supported::Moved(run) => answer.simulations.push(Simulation::Supports(run)),
        Supported::DoesNotStand(why) => answer.does_not_stand = Some(why),
    }
    Ok(())
}

/// The run of one motion, or of none.
fn run_one(
    version: &Version<'_>,
    motion: Option<MotionAnswer>,
    options: &SimulateOptions,
    progress: &dyn Progress,
) -> Result<SimulateAnswer, WorkError> {
    let mut answer = SimulateAnswer {
        file: version.file.to_owned(),
        simulations: Vec::new(),
        variant: version.variant.map(str::to_owned),
        does_not_stand: None,
        evidence: evidence(version.project, version.variant)?,
        without_shaking: match (&version.project.structure, &motion) {
            // its own check follows
            (Structure::Stack(_), None) => None,
            _ => without_shaking(version.project)?,
        },
        tilt_beyond_limit: version.variant.is_none() && is_tilt_beyond(version.project),
        tilt_left_out: TiltLeftOut::of_runs(version.project),
        drift_left: drift_left(version.project),
        after: None,
        damage: version.project.damage.clone(),
        basis: Some(Basis::of(version.project, version.variant)),
    };
    match (&version.project.structure, motion) {
        (Structure::Survey, _) => return Err(WorkError::SurveySimulated),
        (Structure::Chain(part), motion) => {
            let how = ChainOptions {
                push_rad: match &options.push {
                    None => 0.0,
                    Some(text) => parse_angle_rad(text).within(|| "--push".to_owned())?,
                },
                rotations: options.rotations,
                duration_s: options.duration_s,
                output_step_s: options.output_step_s,
            };
            let runs = chain::simulate::simulate(version, part, motion, &how, progress)?;
            let runs = runs.into_iter().map(|run| Simulation::Chain(Box::new(run)));
            answer.simulations.extend(runs);
        }
        (Structure::Building(part), None) if options.wind.is_some() => {
            let asked = options.wind.unwrap_or(WindAsked {
                seed: 1,
                repeats: None,
            });
            let how = WindOptions {
                duration_s: options.duration_s,
                step_s: options.step_s,
                seed: asked.seed,
                repeats: asked.repeats,
            };
            let run = simulate_wind(version, part, &how)?;
            let run = run.ok_or(WorkError::BuildingFalls)?;
            answer.simulations.push(Simulation::Wind(Box::new(run)));
        }
        (Structure::Stack(part), motion) if part.is_loose => {
            let how = stack_options(options);
            let run = stack::settle::settle(version, part, motion, &how, progress)?;
            answer.simulations.push(Simulation::Settled(Box::new(run)));
        }
        (Structure::Stack(part), None) => {
            let how = stack_options(options);
            on_moving_supports(version, part, &how, progress, &mut answer)?;
        }
        (_, None) => return Err(WorkError::NoMotionPrepared),
        (Structure::Frame(part), Some(motion)) => {
            let how = FrameOptions {
                direction: options.direction.as_deref(),
                duration_s: options.duration_s,
                output_step_s: options.output_step_s,
            };
            let runs = frame::simulate::simulate(version, part, &motion, &how, progress)?;
            let runs = runs.into_iter().map(|run| Simulation::Frame(Box::new(run)));
            answer.simulations.extend(runs);
        }
        (Structure::Stack(part), Some(motion)) => {
            if !motion.motion.has(Component::X) && !motion.motion.has(Component::Y) {
                let name = motion.motion.name().to_owned();
                return Err(WorkError::NoHorizontalOf { name });
            }
            let how = stack_options(options);
            match stack::simulate::simulate(version, part, motion, &how, progress)? {
                StackOutcome::Simulated(run) => answer.simulations.push(Simulation::Stack(run)),
                StackOutcome::DoesNotStand(why) => answer.does_not_stand = Some(why),
            }
        }
        (Structure::Building(part), Some(motion)) => {
            let how = BuildingOptions {
                duration_s: options.duration_s,
                step_s: options.step_s.unwrap_or(options.output_step_s),
                compare: options.compare,
                keep: options.keep,
            };
            let run = building::simulate::simulate(version, part, &motion, &how)?;
            let run = run.ok_or(WorkError::BuildingFalls)?;
            answer.simulations.push(Simulation::Building(Box::new(run)));
        }
    }
    Ok(answer)
}
