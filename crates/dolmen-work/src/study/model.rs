//! Structures of a study, ready for runs.

use super::inputs::Drawn;
use crate::check::{crushes_by_itself, falls_by_itself, leans_to_its_fall};
use crate::in_runs::no_capacity;
use crate::stack::check::with_gaps;
use crate::told::told_both;
use crate::wrong::CaseRefused;
use crate::{building, chain, frame};
use dolmen::stability::stack::{StackLimitStates, StackLimits, stack_limits};
use dolmen::structure::stack::Stack;
use dolmen_project::{Pick, Project, Quantity, Structure, StudyPart};
use dolmen_words::message::Both;
use dolmen_words::number::significant;

/// Digits of a random input in words.
const DRAWN_DIGITS: usize = 4;

/// A structure that is ready for runs.
pub(crate) enum Model {
    Stack(Box<(Stack, StackLimitStates)>),
    Frame(Box<frame::study::FrameModel>),
    Chain(Box<chain::study::MovingChain>),
    Building(Box<building::study::BuildingModel>),
}

/// Why a structure cannot be run.
pub(crate) enum NoModel {
    /// Its inputs are refused.
    Refused(Both),
    /// It falls under its own weight, at no shaking at all.
    FallsAlone(Both),
}

impl NoModel {
    /// The reason.
    pub(super) fn why(self) -> Both {
        match self {
            NoModel::Refused(why) | NoModel::FallsAlone(why) => why,
        }
    }
}

/// A structure ready for runs, or the reason for its absence; of a sample that is refused, the one input that is the cause if there is one.
pub(super) fn model_of(study: &StudyPart, project: &Project, sample: &Drawn) -> Result<Model, NoModel> {
    let refused = match built(study, project, &mut |quantity| sample.pick(quantity)) {
        Err(NoModel::Refused(why)) => why,
        found => return found,
    };
    let inputs = project.structure_inputs();
    let mut drawn = inputs
        .into_iter()
        .filter(|input| sample.pick(input) != input.value);
    let cause = drawn.find(|cause| {
        let pick = &mut |quantity: &Quantity| match quantity.path == cause.path {
            true => quantity.value,
            false => sample.pick(quantity),
        };
        !matches!(built(study, project, pick), Err(NoModel::Refused(_)))
    });
    let Some(cause) = cause else {
        return Err(NoModel::Refused(refused));
    };
    let (unit, si) = cause.written_unit().unwrap_or((cause.unit.to_owned(), 1.0));
    let drawn = format!("{} {unit}", significant(sample.pick(cause) / si, DRAWN_DIGITS));
    let why = CaseRefused::DrawnTooFar {
        input: cause.path.clone(),
        drawn: drawn.trim_end().to_owned(),
    };
    Err(NoModel::Refused(why.into()))
}

/// A structure ready for runs with the inputs that `pick` chooses.
fn built(study: &StudyPart, project: &Project, pick: Pick<'_>) -> Result<Model, NoModel> {
    if crushes_by_itself(project, pick) {
        return Err(NoModel::FallsAlone(CaseRefused::BedCrushes.into()));
    }
    match falls_by_itself(project, pick) {
        Ok(Some(load_factor)) => {
            let load_factor = format!("{load_factor:.3}");
            return Err(NoModel::FallsAlone(CaseRefused::FallsAlone(load_factor).into()));
        }
        Ok(None) => {}
        Err(why) => return Err(NoModel::Refused(told_both(&why))),
    }
    match leans_to_its_fall(project, pick) {
        Ok(true) => return Err(NoModel::FallsAlone(CaseRefused::LeansToItsFall.into())),
        Ok(false) => {}
        Err(why) => return Err(NoModel::Refused(told_both(&why))),
    }
    let model = match &project.structure {
        Structure::Stack(part) => match part.build(pick) {
            Ok(stack) => {
                return stack_model(with_gaps(stack).map_err(|why| NoModel::Refused(told_both(&why)))?);
            }
            Err(why) => Err(told_both(&why)),
        },
        Structure::Frame(part) => {
            frame::study::model(study, part, pick).map(|model| Model::Frame(Box::new(model)))
        }
        Structure::Chain(part) => {
            chain::study::model(part, &project.loads, pick).map(|model| Model::Chain(Box::new(model)))
        }
        Structure::Building(part) => {
            building::study::model(part, pick).map(|model| Model::Building(Box::new(model)))
        }
        Structure::Survey => Err(CaseRefused::SurveyAlone.into()),
    };
    model.map_err(NoModel::Refused)
}

/// The largest lean of a storey of a frame before it is shaken, –; `None` if it does not lean, is refused, or falls.
pub(super) fn lean_at_rest(study: &StudyPart, project: &Project, sample: &Drawn) -> Option<f64> {
    let Structure::Frame(part) = &project.structure else {
        return None;
    };
    part.lean.as_ref()?;
    let model = frame::study::model(study, part, &mut |quantity: &Quantity| sample.pick(quantity)).ok()?;
    model.lean_at_rest().ok()
}

/// Whether a chain or frame moves without damping and friction.
pub(super) fn is_undamped(study: &StudyPart, project: &Project) -> bool {
    let pick = &mut Quantity::nominal;
    match &project.structure {
        Structure::Chain(part) => {
            chain::study::model(part, &project.loads, pick).is_ok_and(|model| model.is_undamped())
        }
        Structure::Frame(part) => {
            frame::study::model(study, part, pick).is_ok_and(|model| model.is_undamped(part))
        }
        Structure::Stack(_) | Structure::Building(_) | Structure::Survey => false,
    }
}

/// Whether columns alone support a storey of a frame in a direction that a study shakes.
pub(super) fn on_columns(study: &StudyPart, project: &Project) -> bool {
    let Structure::Frame(part) = &project.structure else {
        return false;
    };
    let model = frame::study::model(study, part, &mut Quantity::nominal);
    model.is_ok_and(|model| model.stands_on_columns())
}

fn stack_model(stack: Stack) -> Result<Model, NoModel> {
    if let Some(why) = no_capacity(&stack) {
        return Err(NoModel::Refused(why.into()));
    }
    let limits = stack_limits(&stack, &StackLimits::default());
    let limits = limits.map_err(|why| NoModel::Refused(told_both(&why)))?;
    if !limits.standing.stands() {
        let verdict = Both::from(limits.standing.to_string());
        return Err(NoModel::FallsAlone(CaseRefused::Falls(verdict).into()));
    }
    Ok(Model::Stack(Box::new((stack, limits))))
}
