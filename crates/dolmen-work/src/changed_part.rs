//! Which joint of a chain, or storey of a frame, explains how frequencies changed.

use crate::chain::limits::link_names;
use crate::frame::simulate::storey_names;
use crate::part_limit::Part;
use crate::survey_direction::direction_of;
use dolmen::assess::{FrequencyChange, SurveyChange, WhichPart, which_part};
use dolmen_project::{ChainAxis, ChainPart, FramePart, Project, Quantity, Structure};

/// A measured frequency is that of the model's mode within this factor, either way. Chosen here.
const SAME_MODE: f64 = 1.25;
/// Parts that are tried one by one. Chosen here: each costs some hundred modal analyses.
const PARTS_MOST: usize = 20;

/// Which part of the model explains a change, in one direction.
#[derive(Clone, Debug, PartialEq)]
pub struct ChangedPart {
    /// The direction; `None` for a chain that is alike all round.
    pub direction: Option<String>,
    /// The parts, lowest first.
    pub parts: Vec<Part>,
    /// Frequencies before as measured, and of the model, Hz.
    pub modes_hz: Vec<[f64; 2]>,
    /// What explains the changes.
    pub found: WhichPart,
}

/// Natural frequencies, Hz, from the stiffness of each part.
type FrequenciesOf<'a> = Box<dyn Fn(&[f64]) -> Option<Vec<f64>> + 'a>;

/// Stiffness of each part, and what it makes of the frequencies.
struct Model<'a> {
    direction: Option<String>,
    parts: Vec<Part>,
    stiffness: Vec<f64>,
    frequencies_hz: FrequenciesOf<'a>,
}

/// How one measured frequency changed.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct MeasuredChange {
    /// The direction in which the mode moves, where it is known.
    pub(crate) direction: Option<String>,
    /// Before, Hz.
    pub(crate) frequency_hz: f64,
    /// Relative change.
    pub(crate) relative: f64,
    /// Its standard deviation, where it is known.
    pub(crate) sd: Option<f64>,
}

/// Which part explains what changed beyond chance from one survey to another, by direction; empty where nothing did, and where the model has no such
/// parts.
pub(crate) fn changed_parts(project: &Project, change: &SurveyChange) -> Vec<ChangedPart> {
    if change.changed().count() == 0 {
        return Vec::new();
    }
    let each = change.modes.iter().map(|mode| MeasuredChange {
        direction: match mode.from.direction.as_deref() {
            Some(TORSION) => Some(TORSION.to_owned()),
            _ => direction_of(&mode.from),
        },
        frequency_hz: mode.from.frequency_hz,
        relative: mode.frequency.relative,
        sd: mode.frequency.evidence.as_ref().map(|evidence| evidence.sd),
    });
    parts_that_explain(project, &each.collect::<Vec<_>>())
}

/// The direction of a mode that twists the plan.
const TORSION: &str = "torsion";

/// Which part explains changes of frequencies, by direction; empty where the model has no such parts.
pub(crate) fn parts_that_explain(project: &Project, changes: &[MeasuredChange]) -> Vec<ChangedPart> {
    let models = match &project.structure {
        Structure::Chain(part) => chains(project, part),
        Structure::Frame(part) => frames(part),
        Structure::Stack(_) | Structure::Building(_) | Structure::Survey => Vec::new(),
    };
    models
        .into_iter()
        .filter_map(|model| explained(&model, changes))
        .collect()
}

fn chains<'a>(project: &'a Project, part: &'a ChainPart) -> Vec<Model<'a>> {
    let each = part.axes().iter().filter_map(|axis| {
        let stiffness = part.stiffness_towards(*axis, &mut Quantity::nominal)?;
        let chain = part
            .build_loaded(*axis, &project.loads, &mut Quantity::nominal)
            .ok()?;
        Some(Model {
            direction: part.has_two_axes().then(|| {
                let name = match axis {
                    ChainAxis::Along => "x",
                    ChainAxis::Across => "y",
                };
                name.to_owned()
            }),
            parts: link_names(part).into_iter().map(Part::JointBelow).collect(),
            stiffness,
            frequencies_hz: Box::new(move |stiffness| {
                let modes = chain.natural_modes(stiffness).ok()?;
                Some(modes.iter().map(|mode| mode.frequency_hz).collect())
            }),
        })
    });
    each.collect()
}

fn frames(part: &FramePart) -> Vec<Model<'_>> {
    let each = part.directions.iter().filter_map(|direction| {
        let stiffness = part.stiffness_n_m(&direction.name, &mut Quantity::nominal)?;
        let frame = part.build(&mut Quantity::nominal).ok()?;
        Some(Model {
            direction: Some(direction.name.clone()),
            parts: storey_names(part).into_iter().map(Part::Storey).collect(),
            stiffness,
            frequencies_hz: Box::new(move |stiffness| {
                let modes = frame.natural_modes(stiffness).ok()?;
                Some(modes.iter().map(|mode| mode.frequency_hz).collect())
            }),
        })
    });
    each.collect()
}

fn explained(model: &Model<'_>, changes: &[MeasuredChange]) -> Option<ChangedPart> {
    if model.parts.len() > PARTS_MOST {
        return None;
    }
    let given = (model.frequencies_hz)(&model.stiffness)?;
    let is_along = |mode: &&MeasuredChange| match &model.direction {
        None => mode.direction.as_deref() != Some(TORSION),
        Some(own) => mode.direction.as_ref() == Some(own),
    };
    let own: Vec<&MeasuredChange> = changes.iter().filter(is_along).collect();
    let matched = matched(&own, &given);
    let changes: Vec<FrequencyChange> = matched
        .iter()
        .filter_map(|(mode, _)| {
            Some(FrequencyChange {
                relative: mode.relative,
                sd: mode.sd?,
            })
        })
        .collect();
    if changes.len() != matched.len() {
        return None;
    }
    let changes_of = |part: Option<usize>, factor: f64| -> Option<Vec<f64>> {
        let each = model.stiffness.iter().enumerate();
        let changed: Vec<f64> = each
            .map(|(at, k)| {
                if part.is_none_or(|of| of == at) {
                    factor * k
                } else {
                    *k
                }
            })
            .collect();
        let after = (model.frequencies_hz)(&changed)?;
        let relative = |at: &usize| Some(after.get(*at)? / given[*at] - 1.0);
        matched.iter().map(|(_, at)| relative(at)).collect()
    };
    Some(ChangedPart {
        found: which_part(&changes, model.parts.len(), changes_of)?,
        direction: model.direction.clone(),
        parts: model.parts.clone(),
        modes_hz: matched
            .iter()
            .map(|(mode, at)| [mode.frequency_hz, given[*at]])
            .collect(),
    })
}

/// Each measured mode with the place of the nearest of the model, where each is the nearest of the other.
fn matched<'c>(measured: &[&'c MeasuredChange], model_hz: &[f64]) -> Vec<(&'c MeasuredChange, usize)> {
    let off = |mode: &MeasuredChange, hz: f64| (mode.frequency_hz / hz).ln().abs();
    let nearest_of_model = |mode: &MeasuredChange| {
        (0..model_hz.len()).min_by(|a, b| off(mode, model_hz[*a]).total_cmp(&off(mode, model_hz[*b])))
    };
    let each = measured.iter().filter_map(|mode| {
        let at = nearest_of_model(mode)?;
        let best = measured
            .iter()
            .min_by(|a, b| off(a, model_hz[at]).total_cmp(&off(b, model_hz[at])))?;
        let is_same = std::ptr::eq(*best, *mode) && off(mode, model_hz[at]) <= SAME_MODE.ln();
        is_same.then_some((*mode, at))
    });
    each.collect()
}
