//! `dolmen check`: is the file right, does it stand.

use crate::cli::Check as Options;
use crate::{Outcome, building, demand, files, open, stack_frequencies};
use anyhow::{Context as _, Result, bail};
use dolmen::assess::{
    Sensitivity, StackCheckOptions, check_chain, check_frame, check_stack, elasticity, probability,
};
use dolmen::numeric::Random;
use dolmen::stability::{chain_limits, chain_stability, frame_stability};
use dolmen::structure::building::{StoreyFall, storey_falls};
use dolmen_project::{ModeKind, Pick, Project, Quantity, Structure, SurveyMode};
use dolmen_report::json::check_json;
use dolmen_report::text::check_text;
use dolmen_work::answer::{
    Answer, Check, DirectionCheck, FREQUENCY_RATIO_MOST, FrequencyContradiction, Sampled, SensitivityOf,
    StackAnswer, State, TiltCheck, VariantAnswer,
};
use std::collections::BTreeMap;
use std::path::Path;

/// How many samples are drawn, and from which seed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sampling {
    pub(crate) samples: usize,
    pub(crate) seed: u64,
}

pub(crate) fn run(options: &Options, as_json: bool) -> Result<Outcome> {
    let open::Opened { project, file } = open::project(&options.project)?;
    let sampling = options.samples.map(|samples| Sampling {
        samples: samples as usize,
        seed: options.seed,
    });
    if sampling.is_some() && matches!(project.structure, Structure::Stack(_)) {
        bail!(
            "--samples cannot draw for a stack yet: its verdict is without shaking; take --sensitivity for what moves it"
        );
    }
    let answer = answer(project, &file, sampling, options.sensitivity)?;
    if as_json {
        files::say(&format!("{:#}\n", check_json(&answer)))?;
    } else {
        files::say(&check_text(&answer))?;
    }
    Ok(if answer.falls() {
        Outcome::Falls
    } else {
        Outcome::Stands
    })
}

/// Everything that `dolmen check` says of a project; its surveys are left for `identify`.
pub(crate) fn answer(
    project: Project,
    file: &Path,
    sampling: Option<Sampling>,
    with_sensitivity: bool,
) -> Result<Answer> {
    let mut state = state_of(&project, sampling)?;
    if let Some(state) = &mut state {
        state.contradictions = contradictions(&project, &state.check);
        if let Check::Stack(stack) = &state.check {
            state.spring_fits = stack_frequencies::fits(stack, &project.surveys)?;
        }
    }
    let mut variants = Vec::new();
    for variant in &project.variants {
        if let Some(state) = state_of(&variant.project, sampling)? {
            variants.push(VariantAnswer {
                name: variant.name.clone(),
                title: variant.title.clone(),
                own_inputs: own_inputs(&project, &variant.project),
                state,
                simulation: None,
            });
        }
    }
    let known = load_factor(&project, &mut Quantity::nominal)?.is_some();
    let sensitivity_of = match project.structure {
        Structure::Stack(_) => SensitivityOf::FirstMotion,
        _ if known => SensitivityOf::LoadFactor,
        _ => SensitivityOf::EqualJoints,
    };
    let sensitivities = match with_sensitivity {
        true => sensitivities(&project, sensitivity_of)?,
        false => Vec::new(),
    };
    let file = file.display().to_string();
    Ok(Answer {
        file,
        project,
        state,
        variants,
        sensitivities,
        sensitivity_of,
        surveys: Vec::new(),
        simulation: None,
        frame_simulations: Vec::new(),
        chain_simulations: Vec::new(),
        tunings: Vec::new(),
        together: Vec::new(),
        building_simulations: Vec::new(),
        studies: Vec::new(),
        change: None,
    })
}

/// What a variant gives that the project does not, or gives otherwise.
fn own_inputs(project: &Project, variant: &Project) -> Vec<Quantity> {
    let given = project.structure_inputs();
    let is_own = |input: &&Quantity| {
        !given.iter().any(|own| {
            (&own.path, own.value, &own.written, own.source)
                == (&input.path, input.value, &input.written, input.source)
        })
    };
    let inputs = variant.structure_inputs().into_iter();
    inputs.filter(is_own).cloned().collect()
}

fn state_of(project: &Project, sampling: Option<Sampling>) -> Result<Option<State>> {
    let Some(check) = check_of(project, &mut Quantity::nominal)? else {
        return Ok(None);
    };
    let sampled = match sampling {
        Some(sampling) => sampled(project, sampling)?,
        None => None,
    };
    let tilts = tilts(project, &check);
    Ok(Some(State {
        demand: demand::of(project, &check)?,
        check,
        tilts,
        contradictions: Vec::new(),
        spring_fits: Vec::new(),
        sampled,
    }))
}

/// The tilts of the last survey that states any, against the uplift limit of the joints of a chain or stack; of others it is not known.
fn tilts(project: &Project, check: &Check) -> Vec<TiltCheck> {
    let Some(survey) = project
        .surveys
        .iter()
        .rev()
        .find(|survey| !survey.tilt.is_empty())
    else {
        return Vec::new();
    };
    let uplift_tilt = match check {
        Check::Chain(chain) => {
            let joints = chain.stability.iter().flat_map(|stability| &stability.joints);
            joints
                .filter_map(|joint| joint.uplift_tilt_rad)
                .min_by(f64::total_cmp)
        }
        // to lean by a slope is to be pulled sideways by that share of the weight
        Check::Stack(stack) => stack
            .check
            .limits
            .uplift
            .map(|first| first.threshold.acceleration_g),
        Check::Frame(_) | Check::Building(_) => None,
    };
    let each = survey.tilt.iter().map(|(direction, tilt)| TiltCheck {
        survey: survey.name.clone(),
        direction: direction.clone(),
        tilt: tilt.ratio,
        uplift_tilt,
    });
    each.collect()
}

/// Where the lowest measured frequency of a direction and that of the model differ too much to be of one structure.
fn contradictions(project: &Project, check: &Check) -> Vec<FrequencyContradiction> {
    let computed = |direction: &str| match check {
        Check::Chain(chain) => chain.modes.first().map(|mode| mode.frequency_hz),
        Check::Frame(all) => {
            let own = all.iter().find(|d| d.direction == direction);
            own.and_then(|d| d.check.modes.first())
                .map(|mode| mode.frequency_hz)
        }
        Check::Stack(stack) => {
            let known = stack.frequencies.as_ref();
            known.and_then(|known| known.sway(direction)).map(|(_, hz)| hz)
        }
        Check::Building(answer) => demand::first_sway(answer, direction),
    };
    let mut found = Vec::new();
    for survey in &project.surveys {
        for (direction, modes) in &survey.modes {
            let measured = lowest_measured(modes);
            if let (Some(measured_hz), Some(computed_hz)) = (measured, computed(direction)) {
                let ratio: f64 = measured_hz / computed_hz;
                if ratio.ln().abs() > FREQUENCY_RATIO_MOST.ln() {
                    found.push(FrequencyContradiction {
                        survey: survey.name.clone(),
                        direction: direction.clone(),
                        measured_hz,
                        computed_hz,
                    });
                }
            }
        }
    }
    found
}

/// The lowest frequency of translation that was measured, Hz.
pub(crate) fn lowest_measured(modes: &[SurveyMode]) -> Option<f64> {
    let measured = modes
        .iter()
        .find(|mode| mode.kind == ModeKind::Translation && !mode.frequency.is_assumed());
    measured.map(|mode| mode.frequency.value)
}

/// The check of a structure, each input with the value that `pick` chooses; `None` if nothing is modelled.
fn check_of(project: &Project, pick: Pick<'_>) -> Result<Option<Check>> {
    Ok(match &project.structure {
        Structure::Survey => None,
        Structure::Chain(part) => {
            let stiffness = part.stiffness_n_m_rad(pick);
            Some(Check::Chain(Box::new(check_chain(
                &part.build(pick)?,
                stiffness.as_deref(),
            )?)))
        }
        Structure::Frame(part) => {
            let frame = part.build(pick)?;
            let mut checks = Vec::new();
            for direction in &part.directions {
                let stiffness = part.stiffness_n_m(&direction.name, pick);
                let check = check_frame(&frame, stiffness.as_deref())?;
                let slipping = match part.slipping_stiffness_n_m(&direction.name, pick) {
                    Some(slipping) => Some(check_frame(&frame, Some(&slipping))?),
                    None => None,
                };
                checks.push(DirectionCheck {
                    direction: direction.name.clone(),
                    check,
                    slipping,
                });
            }
            Some(Check::Frame(checks))
        }
        Structure::Stack(part) => {
            let stack = part.build(pick)?;
            let check = check_stack(&stack, &StackCheckOptions::default())?;
            let frequencies = stack_frequencies::of(&stack, &check);
            Some(Check::Stack(Box::new(StackAnswer {
                stack,
                check,
                frequencies,
            })))
        }
        Structure::Building(part) => Some(Check::Building(Box::new(building::check(project, part, pick)?))),
    })
}

/// The load factor, each input with the value that `pick` chooses: of a frame the smallest of its directions;
/// `None` unless the stiffness is known in every direction.
fn load_factor(project: &Project, pick: Pick<'_>) -> Result<Option<f64>> {
    Ok(match &project.structure {
        Structure::Survey | Structure::Stack(_) => None,
        Structure::Chain(part) => match part.stiffness_n_m_rad(pick) {
            Some(stiffness) => Some(chain_stability(&part.build(pick)?, &stiffness)?.load_factor),
            None => None,
        },
        Structure::Frame(part) => {
            let frame = part.build(pick)?;
            let mut least: Option<f64> = None;
            for direction in &part.directions {
                let Some(stiffness) = part.stiffness_n_m(&direction.name, pick) else {
                    return Ok(None); // a direction that is not known is not a direction that stands
                };
                let factor = frame_stability(&frame, &stiffness)?.load_factor;
                least = Some(least.map_or(factor, |other| other.min(factor)));
            }
            least
        }
        Structure::Building(part) => {
            let (floors, storeys) = part.floors_and_storeys(pick)?;
            let falls = storey_falls(&floors, &storeys, part.gravity_m_s2)?;
            StoreyFall::first(&falls).map(|first| first.load_factor)
        }
    })
}

/// The load factor of a chain without friction, or a frame, that falls under its own weight; `None` if it stands, or that is not known.
pub(crate) fn falls_by_itself(project: &Project) -> Result<Option<f64>> {
    let is_held = match &project.structure {
        Structure::Chain(part) => part.joints.iter().flatten().any(|joint| joint.friction.is_some()),
        Structure::Frame(_) => false,
        _ => return Ok(None),
    };
    if is_held {
        return Ok(None);
    }
    Ok(load_factor(project, &mut Quantity::nominal)?.filter(|factor| *factor <= 1.0))
}

/// The load factor that a verdict is taken from: of a frame whose joints slip the least of both states.
fn least_load_factor(project: &Project, pick: Pick<'_>) -> Result<Option<f64>> {
    let Some(mut least) = load_factor(project, pick)? else {
        return Ok(None);
    };
    if let Structure::Frame(part) = &project.structure {
        let frame = part.build(pick)?;
        for direction in &part.directions {
            if let Some(slipping) = part.slipping_stiffness_n_m(&direction.name, pick) {
                least = least.min(frame_stability(&frame, &slipping)?.load_factor);
            }
        }
    }
    Ok(Some(least))
}

/// The load factor under inputs drawn from their distributions; `None` if no stiffness or no scatter is known.
fn sampled(project: &Project, sampling: Sampling) -> Result<Option<Sampled>> {
    let inputs = project.structure_inputs();
    let scatters: Vec<(&Quantity, f64)> = inputs
        .iter()
        .filter_map(|q| Some((*q, q.cov.filter(|cov| *cov > 0.0)?)))
        .collect();
    if scatters.is_empty() || load_factor(project, &mut Quantity::nominal)?.is_none() {
        return Ok(None);
    }
    let mut load_factors = Vec::with_capacity(sampling.samples);
    let unstable = probability(
        sampling.samples,
        sampling.seed,
        |random: &mut Random| -> Result<bool> {
            // drawn in the order of the file, so that a sample does not depend on who asks first, or twice
            let mut drawn = BTreeMap::new();
            for (q, cov) in &scatters {
                drawn.insert(q.path.as_str(), random.lognormal(q.value, *cov)?);
            }
            let mut pick = |q: &Quantity| drawn.get(q.path.as_str()).copied().unwrap_or(q.value);
            let factor = least_load_factor(project, &mut pick).context(
            "a sample of the inputs gives an impossible structure: lower the cov of the input that it names",
        )?;
            let factor = factor
                .filter(|factor| !factor.is_nan())
                .context("the load factor of a sample is not a number: it must not be counted as standing")?;
            load_factors.push(factor);
            Ok(factor <= 1.0)
        },
    )?;
    load_factors.sort_by(f64::total_cmp);
    let inputs = scatters.iter().map(|(q, _)| q.path.clone()).collect();
    Ok(Some(Sampled {
        unstable,
        load_factors,
        inputs,
    }))
}

/// The result that sensitivities are of, each input with the value that `pick` chooses.
fn sensitive(project: &Project, of: SensitivityOf, pick: Pick<'_>) -> Result<Option<f64>> {
    match (of, &project.structure) {
        (SensitivityOf::LoadFactor, _) => load_factor(project, pick),
        (SensitivityOf::EqualJoints, Structure::Chain(part)) => {
            Ok(Some(chain_limits(&part.build(pick)?)?.equal_joints_n_m_rad))
        }
        (SensitivityOf::FirstMotion, Structure::Stack(part)) => {
            let check = check_stack(&part.build(pick)?, &StackCheckOptions::default())?;
            Ok(check.capacity.map(|first| first.acceleration_m_s2))
        }
        (SensitivityOf::EqualJoints | SensitivityOf::FirstMotion, _) => Ok(None),
    }
}

/// Elasticity of a result to each of the structure's inputs, strongest first; empty if there is no such result.
fn sensitivities(project: &Project, of: SensitivityOf) -> Result<Vec<Sensitivity>> {
    if sensitive(project, of, &mut Quantity::nominal)?.is_none() {
        return Ok(Vec::new());
    }
    let mut all = Vec::new();
    for input in project.structure_inputs() {
        let elasticity = elasticity(input.value, |changed| -> Result<f64> {
            let mut pick = |q: &Quantity| if q.path == input.path { changed } else { q.value };
            Ok(sensitive(project, of, &mut pick)?.unwrap_or(f64::NAN))
        })?;
        all.push(Sensitivity {
            input: input.path.clone(),
            value: input.value,
            elasticity,
            cov: input.cov,
        });
    }
    // an input of 0 has no elasticity: it stands last
    let strength = |of: &Sensitivity| match of.elasticity.is_finite() {
        true => of.elasticity.abs(),
        false => -1.0,
    };
    all.sort_by(|a, b| strength(b).total_cmp(&strength(a)));
    Ok(all)
}
