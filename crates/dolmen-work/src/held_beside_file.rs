//! Compares every stiffness from a survey with that of the project file.

use crate::beside_file::{BesideFile, KnownStiffness, beside};
use crate::building::PlanAnswer;
use crate::surveyed::{StiffnessAnswer, SurveyAnswer};
use dolmen_project::{BuildingPart, Project, Quantity, StoreyStiffnessPart, Structure};

/// Adds the comparison with the file to the results of a survey; values that were identified from this survey are left out.
pub(crate) fn hold_beside_file(project: &Project, survey: &mut SurveyAnswer) {
    let name = survey.name.clone();
    for answer in &mut survey.stiffness {
        answer.beside_file =
            of_file(project, answer, &answer.direction, &name).and_then(|file| against(answer, &file));
    }
    survey.exchanged_directions = exchanged(project, survey);
    if let (Structure::Building(part), Some(plan)) = (&project.structure, &mut survey.plan) {
        let beside = of_plan(part, plan, &name, [0, 1, 2]);
        let turned = of_plan(part, plan, &name, [1, 0, 2]);
        let is_turned = |of: &BesideFile| !of.differs && beside.as_ref().is_some_and(|own| own.differs);
        if turned.as_ref().is_some_and(is_turned) {
            survey.exchanged_directions = Some(["x".to_owned(), "y".to_owned()]);
        }
        plan.beside_file = beside;
    }
}

/// The stiffness of the file in a direction, if it uses the same convention as the springs of the answer.
fn of_file<'a>(
    project: &'a Project,
    answer: &StiffnessAnswer,
    direction: &str,
    survey: &str,
) -> Option<Vec<&'a Quantity>> {
    let all: Vec<&Quantity> = match &project.structure {
        // on soft ground the lowest joint of the file is the bed alone
        Structure::Chain(part) if part.soil.is_none() => part
            .joints
            .as_ref()?
            .iter()
            .map(|joint| &joint.stiffness)
            .collect(),
        Structure::Frame(part) if answer.convention == Some(part.convention) => {
            let own = part.directions.iter().find(|known| known.name == direction);
            let own = own.filter(|own| !part.is_on_columns_alone(&own.name))?;
            own.stiffness.as_ref()?.iter().collect()
        }
        _ => return None,
    };
    let is_own = all.iter().any(|of| of.survey.as_deref() == Some(survey));
    (!is_own).then_some(all)
}

fn against(answer: &StiffnessAnswer, file: &[&Quantity]) -> Option<BesideFile> {
    let one = answer
        .solutions
        .solutions
        .first()
        .filter(|_| answer.is_chosen())?;
    let sd = |part: usize| one.stiffness_sd.as_ref().map_or(0.0, |sd| sd[part]);
    let found = one.stiffness.iter().enumerate();
    let found: Vec<KnownStiffness> = found
        .map(|(at, value)| KnownStiffness {
            value: *value,
            sd: sd(at),
        })
        .collect();
    beside(&found, &known(file), file.iter().all(|of| of.is_assumed()))
}

fn known(file: &[&Quantity]) -> Vec<KnownStiffness> {
    let each = file.iter().map(|of| KnownStiffness {
        value: of.value,
        sd: of.standard_deviation(),
    });
    each.collect()
}

/// Two directions of a frame whose stiffnesses appear exchanged in the file.
fn exchanged(project: &Project, survey: &SurveyAnswer) -> Option<[String; 2]> {
    let differing: Vec<&StiffnessAnswer> = survey
        .stiffness
        .iter()
        .filter(|answer| answer.beside_file.as_ref().is_some_and(|of| of.differs))
        .collect();
    let is_of = |answer: &StiffnessAnswer, direction: &str| {
        let file = of_file(project, answer, direction, &survey.name);
        let beside = file.and_then(|file| against(answer, &file));
        beside.is_some_and(|of| !of.differs)
    };
    let pairs = (0..differing.len()).flat_map(|j| (0..j).map(move |i| [i, j]));
    pairs.map(|pair| pair.map(|at| differing[at])).find_map(|[a, b]| {
        let turned = a.direction != b.direction && is_of(a, &b.direction) && is_of(b, &a.direction);
        turned.then(|| [a.direction.clone(), b.direction.clone()])
    })
}

/// k_x, k_y, k_θ compared with those of the file, in this order; only if the modes determine the centre of rigidity.
fn of_plan(part: &BuildingPart, plan: &PlanAnswer, survey: &str, order: [usize; 3]) -> Option<BesideFile> {
    let one = plan.determined()?;
    let found = [0, 1, 2].map(|at| KnownStiffness {
        value: one.stiffness[at],
        sd: one.stiffness_sd.map_or(0.0, |sd| sd[at]),
    });
    let written: Vec<&Quantity> = match part.floors.first().map(|floor| &floor.stiffness) {
        Some(StoreyStiffnessPart::Whole { x, y, rotation, .. }) => vec![x, y, rotation],
        _ => Vec::new(),
    };
    if written.iter().any(|of| of.survey.as_deref() == Some(survey)) {
        return None;
    }
    let file = order.map(|at| KnownStiffness {
        value: plan.written.stiffness[at],
        sd: written.get(at).map_or(0.0, |of| of.standard_deviation()),
    });
    let is_assumed = !written.is_empty() && written.iter().all(|of| of.is_assumed());
    beside(&found, &file, is_assumed)
}
