//! `dolmen check`: whether the structure is stable, where it begins to move, and how certain the result is.

use crate::answer::CheckAnswer;
use crate::chain::check::UpliftTilt;
use crate::demand;
use crate::draws::Draws;
use crate::error::{Within as _, WorkError};
use crate::frame::tilts::tilts as tilts_of_frame;
use crate::judgement::{measured_frequencies, superseded_by};
use crate::kinds;
use crate::opened::Opened;
use crate::stack::shared_courses::heights_that_others_share;
use crate::state::{Check, FrequencyContradiction, Sampled, SensitivityOf, State, TiltCheck, VariantAnswer};
use crate::survey_dates::date;
use crate::wrong::Place;
use dolmen::assess::{NoElasticity, Sensitivity, elasticity, probability};
use dolmen::numeric::Random;
use dolmen::stability::Verdict;
use dolmen_project::{Pick, Project, Quantity, Structure};
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// Options of a check.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CheckOptions {
    /// Samples of the uncertain inputs.
    pub sampling: Option<Sampling>,
    /// Whether to compute sensitivities to each input.
    pub sensitivity: bool,
    /// Whether to compute results for a stack that do not affect its verdict: local mechanisms as codes require, and the springs that measured
    /// frequencies imply. With a site in the file local mechanisms are always found, because a finding compares them with it.
    pub beside_the_verdict: bool,
}

/// Number and seed of samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sampling {
    /// Number of samples.
    pub samples: usize,
    /// The same seed gives the same bits.
    pub seed: u64,
}

/// Checks a structure and its variants; [`identify`](crate::identify()) handles its surveys.
///
/// # Errors
/// [`WorkError`] if the structure cannot be built or computed, or if samples are requested for a stack.
pub fn check(opened: &Opened, options: &CheckOptions) -> Result<CheckAnswer, WorkError> {
    let project = &opened.project;
    if options.sampling.is_some() && matches!(project.structure, Structure::Stack(_)) {
        return Err(WorkError::SamplesOfStack);
    }
    // variants are independent of each other: each on its own thread
    let (state, states) = rayon::join(
        || state_of(project, options),
        || -> Vec<_> {
            let variants = project.variants.par_iter();
            variants
                .map(|variant| state_of(&variant.project, options))
                .collect()
        },
    );
    let mut state = state?;
    if let Some(state) = &mut state {
        state.contradictions = contradictions(project, state);
        if options.beside_the_verdict {
            state.spring_fits =
                kinds::spring_fits(&state.check, &project.surveys).within(|| Place::SpringsMeasured)?;
        }
    }
    let mut variants = Vec::new();
    for (variant, of_variant) in project.variants.iter().zip(states) {
        if let Some(state) = of_variant? {
            variants.push(VariantAnswer {
                name: variant.name.clone(),
                title: variant.title.clone(),
                own_inputs: own_inputs(project, &variant.project),
                state,
            });
        }
    }
    let known = kinds::load_factor(project, &mut Quantity::nominal)?.is_some();
    let sensitivity_of = match project.structure {
        Structure::Stack(_) => SensitivityOf::FirstMotion,
        _ if known => SensitivityOf::LoadFactor,
        _ => SensitivityOf::EqualJoints,
    };
    let sensitivities = match options.sensitivity {
        true => sensitivities(project, sensitivity_of, state.as_ref().map(|state| &state.check))?,
        false => Vec::new(),
    };
    Ok(CheckAnswer {
        file: opened.file.clone(),
        project: opened.project.clone(),
        state,
        variants,
        sensitivities,
        sensitivity_of,
        unreadable_motions: Vec::new(),
    })
}

/// The values that a variant adds or changes; the same number written otherwise is none.
fn own_inputs(project: &Project, variant: &Project) -> Vec<Quantity> {
    let given = project.structure_inputs();
    let is_own = |input: &&Quantity| {
        !given.iter().any(|own| {
            let is_same = (&own.path, own.value, own.cov) == (&input.path, input.value, input.cov);
            is_same && (own.source == input.source || !input.is_assumed())
        })
    };
    let inputs = variant.structure_inputs().into_iter();
    inputs.filter(is_own).cloned().collect()
}

pub(crate) fn state_of(project: &Project, options: &CheckOptions) -> Result<Option<State>, WorkError> {
    let Some(mut check) = kinds::check(project, &mut Quantity::nominal)? else {
        return Ok(None);
    };
    kinds::add_wind(&mut check, project, &mut Quantity::nominal)?;
    if options.beside_the_verdict || project.site.is_some() {
        kinds::add_local_mechanisms(&mut check);
    }
    if options.beside_the_verdict {
        kinds::add_frequency_by_height(&mut check, project);
    }
    let sampled = match options.sampling {
        Some(sampling) => sampled(project, sampling)?,
        None => None,
    };
    let tilts = tilts(project, &check);
    let loads = kinds::loads(project, &check, &tilts, &mut Quantity::nominal)?;
    Ok(Some(State {
        demand: demand::of(project, &check, &tilts)?,
        check,
        tilts,
        loads,
        contradictions: Vec::new(),
        spring_fits: Vec::new(),
        sampled,
    }))
}

/// Compares the tilts of the survey that the model leans by, or of the latest one with tilts, with the uplift limit of the joints of a
/// chain or stack, or with the fall of a frame; unknown for other kinds.
fn tilts(project: &Project, check: &Check) -> Vec<TiltCheck> {
    // the limits already include a lean of the model
    if let Structure::Stack(part) = &project.structure
        && (part.lean.is_some() || part.carries_own_lean())
    {
        return Vec::new();
    }
    if let (Structure::Frame(part), Check::Frame(checks)) = (&project.structure, check)
        && part.lean.is_some()
    {
        return tilts_of_frame(part, checks);
    }
    let tilted = || project.surveys.iter().filter(|survey| !survey.tilt.is_empty());
    let leans_as = match &project.structure {
        Structure::Chain(part) => part.lean.as_ref(),
        _ => None,
    };
    let chosen = leans_as.and_then(|lean| tilted().find(|survey| survey.name == lean.survey));
    // among surveys without dates the latest is unknown: the worst counts
    let are_undated = tilted().all(|survey| date(&survey.name).is_none());
    let last = match are_undated {
        true => tilted().max_by(|a, b| a.tilt_together().total_cmp(&b.tilt_together())),
        false => tilted().max_by_key(|survey| date(&survey.name)),
    };
    let Some(survey) = chosen.or(last) else {
        return Vec::new();
    };
    let known = kinds::uplift_tilt(check).map(|edge| UpliftTilt {
        edge,
        opens: TiltCheck::OPENS * edge,
    });
    let towards = |towards| kinds::uplift_tilt_towards(project, check, towards);
    let held_against = |direction: String, tilt: f64, limit: Option<UpliftTilt>| TiltCheck {
        survey: survey.name.clone(),
        direction,
        tilt,
        uplift_tilt: limit.or(known).map(|of| of.edge),
        opens_tilt: limit.or(known).map(|of| of.opens),
    };
    let each = survey.tilt.iter().map(|(direction, tilt)| {
        let limit = match direction.as_str() {
            "x" => towards([1.0, 0.0]),
            "y" => towards([0.0, 1.0]),
            // the side is unknown: the worst counts
            _ => towards_worst(&towards),
        };
        held_against(direction.clone(), tilt.ratio, limit)
    });
    let mut all: Vec<TiltCheck> = each.collect();
    // a joint opens to the side of the resultant lean, not along x and along y separately
    if let [first, second] = all.as_slice()
        && known.is_some()
    {
        let limit = match (first.direction.as_str(), second.direction.as_str()) {
            ("x", "y") => towards([first.tilt, second.tilt]),
            _ => towards_worst(&towards),
        };
        let direction = format!("{}+{}", first.direction, second.direction);
        all.push(held_against(direction, TiltCheck::resultant(&all), limit));
    }
    all
}

/// The smallest uplift tilt over all directions, by degrees.
fn towards_worst(uplift_tilt: &dyn Fn([f64; 2]) -> Option<UpliftTilt>) -> Option<UpliftTilt> {
    const DEGREES: u32 = 90; // a bed is symmetric about its axes
    let each = (0..=DEGREES).filter_map(|degrees| {
        let angle = f64::from(degrees).to_radians();
        uplift_tilt([angle.cos(), angle.sin()])
    });
    each.reduce(|least, own| UpliftTilt {
        edge: least.edge.min(own.edge),
        opens: least.opens.min(own.opens),
    })
}

/// Measured frequencies that differ too much from the model's lowest in their direction for the same structure.
fn contradictions(project: &Project, state: &State) -> Vec<FrequencyContradiction> {
    let all = measured_frequencies(project, &state.check);
    let differing = all.iter().filter(|of| of.differs());
    let contradictions = differing.map(|of| FrequencyContradiction {
        survey: of.survey.clone(),
        direction: of.direction.clone(),
        measured_hz: of.measured_hz,
        computed_hz: of.computed_hz,
        is_too_rough: of.is_too_rough(),
        superseded_by: superseded_by(project, &all, of),
    });
    contradictions.collect()
}

/// As [`falls_by_itself`], with the inputs of the file; `None` for a building, whose study computes it for each sample.
pub(crate) fn falls_by_itself_as_given(project: &Project) -> Result<Option<f64>, WorkError> {
    match &project.structure {
        Structure::Building(_) => Ok(None),
        _ => falls_by_itself(project, &mut Quantity::nominal),
    }
}

/// The load factor of a chain without friction, a frame or a building that falls under its own weight with the inputs that `pick` chooses;
/// `None` if it stands, or if that is unknown. For a stack, the limits contain it.
pub(crate) fn falls_by_itself(project: &Project, pick: Pick<'_>) -> Result<Option<f64>, WorkError> {
    let is_held = match &project.structure {
        Structure::Chain(part) => part.joints.iter().flatten().any(|joint| joint.friction.is_some()),
        Structure::Frame(_) | Structure::Building(_) => false,
        Structure::Stack(_) | Structure::Survey => return Ok(None),
    };
    if is_held {
        return Ok(None);
    }
    Ok(kinds::load_factor(project, pick)?.filter(|factor| *factor <= 1.0))
}

/// Whether a bed of a chain crushes under the weight above it with the inputs that `pick` chooses.
pub(crate) fn crushes_by_itself(project: &Project, pick: Pick<'_>) -> bool {
    match &project.structure {
        Structure::Chain(part) => part.bed_crushes(&project.loads, pick),
        Structure::Frame(_) | Structure::Building(_) | Structure::Stack(_) | Structure::Survey => false,
    }
}

/// Whether a chain or frame that leans as surveyed falls with the inputs that `pick` chooses; a model that takes no tilt is plumb. For a stack
/// the limits contain it.
pub(crate) fn leans_to_its_fall(project: &Project, pick: Pick<'_>) -> Result<bool, WorkError> {
    let leans = match &project.structure {
        Structure::Frame(part) => part.lean.is_some(),
        Structure::Chain(part) => {
            !part.takes_no_tilt && project.surveys.iter().any(|survey| !survey.tilt.is_empty())
        }
        Structure::Stack(_) | Structure::Building(_) | Structure::Survey => false,
    };
    let Some(check) = (match leans {
        true => kinds::check(project, pick)?,
        false => None,
    }) else {
        return Ok(false);
    };
    let mut tilts = tilts(project, &check).into_iter();
    Ok(tilts.any(|tilt| tilt.verdict() == Verdict::Unstable))
}

/// The load factor for random samples of the inputs; `None` if no stiffness or no scatter is known.
fn sampled(project: &Project, sampling: Sampling) -> Result<Option<Sampled>, WorkError> {
    let draws = Draws::of(project)?;
    // without P-delta there is no load factor
    let factor = kinds::load_factor(project, &mut Quantity::nominal)?;
    if draws.inputs().is_empty() || factor.is_none_or(f64::is_infinite) {
        return Ok(None);
    }
    let is_overloaded = |pick: Pick<'_>| -> Result<Option<bool>, WorkError> {
        let Some(check) = kinds::check(project, pick)? else {
            return Ok(None);
        };
        let loads = kinds::loads(project, &check, &tilts(project, &check), pick)?;
        Ok(loads.and_then(|loads| loads.factor()).map(|factor| factor <= 1.0))
    };
    let is_loaded = is_overloaded(&mut Quantity::nominal)?.is_some();
    let mut overloaded = Vec::new();
    let mut falls_sticking = match &project.structure {
        Structure::Frame(part) if part.lean.is_none() && part.softens() => Some(0),
        _ => None,
    };
    let mut load_factors = Vec::with_capacity(sampling.samples);
    let unstable = probability(
        sampling.samples,
        sampling.seed,
        |random: &mut Random| -> Result<bool, WorkError> {
            let each = draws.inputs().iter().zip(draws.draw(random)?);
            let drawn: BTreeMap<&str, f64> = each
                .map(|(input, value)| (input.quantity.path.as_str(), value))
                .collect();
            let mut pick = |q: &Quantity| drawn.get(q.path.as_str()).copied().unwrap_or(q.value);
            if crushes_by_itself(project, &mut pick) {
                load_factors.push(0.0);
                overloaded.extend(is_loaded.then_some(true));
                return Ok(true);
            }
            let factor = kinds::least_load_factor(project, &mut pick).within(|| Place::SampleImpossible)?;
            let factor = factor
                .filter(|factor| !factor.is_nan())
                .ok_or(WorkError::SampleNotANumber)?;
            load_factors.push(factor);
            if let Some(count) = &mut falls_sticking {
                let sticking = kinds::load_factor(project, &mut pick).within(|| Place::SampleImpossible)?;
                *count += usize::from(sticking.is_some_and(|factor| factor <= 1.0));
            }
            if is_loaded {
                overloaded.push(
                    is_overloaded(&mut pick)
                        .within(|| Place::SampleImpossible)?
                        .unwrap_or(true),
                );
            }
            Ok(factor <= 1.0 || leans_to_its_fall(project, &mut pick).within(|| Place::SampleImpossible)?)
        },
    )?;
    let mut overloaded = overloaded.into_iter();
    let under_loads = match is_loaded {
        true => Some(probability(
            sampling.samples,
            sampling.seed,
            |_| -> Result<bool, WorkError> { Ok(overloaded.next().unwrap_or(true)) },
        )?),
        false => None,
    };
    load_factors.sort_by(f64::total_cmp);
    let inputs = draws.inputs().iter();
    let inputs = inputs.map(|input| input.quantity.path.clone()).collect();
    Ok(Some(Sampled {
        unstable,
        under_loads,
        load_factors,
        inputs,
        falls_sticking,
        weighs_loads: project.loads.loads.iter().any(|load| load.weight.is_some()),
    }))
}

/// Elasticity of a result to each of the structure's inputs, strongest first; empty if there is no such result.
fn sensitivities(
    project: &Project,
    of: SensitivityOf,
    check: Option<&Check>,
) -> Result<Vec<Sensitivity>, WorkError> {
    // with the same friction as its neighbours, which dilates where beds slide
    let Some(nominal) = kinds::sensitive(project, of, check, &mut Quantity::nominal)? else {
        return Ok(Vec::new());
    };
    let at_rest = kinds::at_rest(project, &mut Quantity::nominal)?;
    // moving a single corner separates it from the bed that it shares with the next stone
    let is_corner = |input: &&Quantity| input.path.contains(".points[");
    // and a stone higher than its neighbours lifts the load off them
    let shared = match &project.structure {
        Structure::Stack(part) => heights_that_others_share(part),
        _ => BTreeSet::new(),
    };
    let inputs = project.structure_inputs().into_iter();
    let inputs: Vec<&Quantity> = inputs
        .filter(|input| !is_corner(input) && !shared.contains(&input.path))
        .collect();
    let of_input = |input: &Quantity| -> Result<Sensitivity, WorkError> {
        let elasticity = elasticity(input.value, |changed| -> Result<f64, WorkError> {
            let mut pick = |q: &Quantity| if q.path == input.path { changed } else { q.value };
            // the stiffness of joints, for example, does not change when a stack begins to move
            if let Some(at_rest) = &at_rest
                && matches!(kinds::at_rest(project, &mut pick), Ok(Some(changed)) if changed == *at_rest)
            {
                return Ok(nominal);
            }
            // if the structure cannot be built with this changed number, there is no sensitivity
            Ok(kinds::sensitive(project, of, check, &mut pick)
                .ok()
                .flatten()
                .unwrap_or(f64::NAN))
        })?;
        let elasticity = elasticity.is_finite().then_some(elasticity);
        let why = match input.value == 0.0 {
            true => NoElasticity::Zero,
            false => NoElasticity::NoResult,
        };
        Ok(Sensitivity {
            input: input.path.clone(),
            value: input.value,
            elasticity,
            unknown: elasticity.is_none().then_some(why),
            cov: input.cov,
        })
    };
    let mut all = inputs
        .par_iter()
        .map(|input| of_input(input))
        .collect::<Result<Vec<_>, _>>()?;
    // without an elasticity it comes last
    let strength = |of: &Sensitivity| of.elasticity.map_or(-1.0, f64::abs);
    all.sort_by(|a, b| strength(b).total_cmp(&strength(a)));
    Ok(all)
}
