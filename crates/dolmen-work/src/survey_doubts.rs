//! Evidence against the model from the modes of surveys and the stiffness sought from them.

use crate::judgement::{OtherStiffness, PairedMode, SurveyDoubts, Unexplained, contradict};
use crate::model_modes::{SAME_FROM, WhichMode};
use crate::stack::FactorsAnswer;
use crate::surveyed::{StiffnessAnswer, SurveyAnswer};
use dolmen::blocks::{PairedMode as StackPair, StackMotion};
use dolmen::structure::Choice;
use dolmen_project::{Project, Structure};

/// One entry for each survey that was measured and whose modes are not those of an earthquake.
pub(crate) fn survey_doubts(project: &Project, surveys: &[SurveyAnswer]) -> Vec<SurveyDoubts> {
    let is_measured = |answer: &&SurveyAnswer| {
        let mut own = project.surveys.iter().filter(|survey| survey.name == answer.name);
        own.all(|survey| {
            let stated = survey.modes.values().flatten();
            !survey.is_made_up && !stated.clone().any(|mode| mode.frequency.is_assumed())
        })
    };
    let measured = surveys
        .iter()
        .filter(|answer| !answer.is_shaken())
        .filter(is_measured);
    measured.map(|answer| of_survey(project, answer)).collect()
}

fn of_survey(project: &Project, answer: &SurveyAnswer) -> SurveyDoubts {
    let modes = match &answer.factors {
        Some(factors) => of_stack(&answer.name, factors),
        None => by_shape(answer),
    };
    SurveyDoubts {
        survey: answer.name.clone(),
        modes,
        unexplained: unexplained(project, answer),
        stiffness: other_stiffness(answer),
    }
}

/// The modes of a stack compared with those on the springs of the file.
fn of_stack(survey: &str, factors: &FactorsAnswer) -> Vec<PairedMode> {
    let each = factors.found.modes.iter().map(|mode| PairedMode {
        survey: survey.to_owned(),
        direction: Some(
            match mode.motion {
                StackMotion::X => "x",
                StackMotion::Y => "y",
                StackMotion::Torsion => "torsion",
            }
            .to_owned(),
        ),
        number: mode.number,
        measured_hz: mode.measured_hz,
        sd_hz: Some(mode.measured_sd_hz).filter(|sd_hz| *sd_hz > 0.0),
        computed_hz: mode.drawn_hz,
    });
    each.collect()
}

/// The modes of records that resemble one mode of the model alone; none for a model without its dampers.
fn by_shape(answer: &SurveyAnswer) -> Vec<PairedMode> {
    let model = answer
        .model
        .as_ref()
        .filter(|model| model.without_dampers.is_empty());
    let Some((model, (found, _))) = model.zip(answer.modes()) else {
        return Vec::new();
    };
    let each = model.measured.iter().zip(&found.modes);
    let known = each.filter_map(|(beside, mode)| match beside.is {
        WhichMode::One(place) => Some((mode, &model.of_model[place])),
        WhichMode::Several(_) | WhichMode::None(_) => None,
    });
    let paired = known.map(|(mode, of_model)| PairedMode {
        survey: answer.name.clone(),
        direction: None,
        number: of_model.first + 1,
        measured_hz: mode.frequency_hz,
        sd_hz: mode.frequency_sd_hz.filter(|sd_hz| *sd_hz > 0.0),
        computed_hz: of_model.frequency_hz,
    });
    paired.collect()
}

/// Whether the best factors leave a mode of a stack off by more than 10 % and three deviations, or with another shape: less, however significant, is
/// within what springs of joints can represent.
fn is_off(modes: &[StackPair]) -> bool {
    modes.iter().any(|mode| {
        let best_hz = mode.best_hz.unwrap_or(mode.common_hz);
        contradict(mode.measured_hz, Some(mode.measured_sd_hz), best_hz)
            || mode.assurance.is_some_and(|assurance| assurance < SAME_FROM)
    })
}

/// Modes that no stiffness explains: in a direction of a chain or frame by the convention of the file, in plan, or on the joints of a stack.
fn unexplained(project: &Project, answer: &SurveyAnswer) -> Option<Unexplained> {
    let of_file = match &project.structure {
        Structure::Frame(part) => Some(part.convention),
        _ => None,
    };
    let is_impossible =
        |of: &&StiffnessAnswer| of.convention == of_file && of.solutions.choice == Choice::Impossible;
    if let Some(of) = answer.stiffness.iter().find(is_impossible) {
        return Some(Unexplained {
            direction: Some(of.direction.clone()),
            deviations: None,
        });
    }
    if let Some(plan) = &answer.plan
        && plan.found.accepted().next().is_none()
        && plan.bounds.is_none()
    {
        return Some(Unexplained {
            direction: None,
            deviations: None,
        });
    }
    answer
        .factors
        .as_ref()
        .filter(|factors| is_off(&factors.found.modes))
        .and_then(|factors| {
            Some(Unexplained {
                direction: None,
                deviations: Some(factors.misfit()?),
            })
        })
}

/// The stiffness that differs most from the file, by the same rule as the finding on it; a difference from an assumed value is no doubt.
fn other_stiffness(answer: &SurveyAnswer) -> Option<OtherStiffness> {
    let along = answer.stiffness.iter().filter_map(|of| {
        let beside = of.beside_file.as_ref()?;
        Some((Some(&of.direction), beside))
    });
    let plan = answer.plan.as_ref().and_then(|plan| plan.beside_file.as_ref());
    let all = along.chain(plan.map(|beside| (None, beside)));
    let each = all.filter(|(_, beside)| !beside.is_assumed);
    let each = each.filter_map(|(direction, beside)| {
        let at = beside.farthest()?;
        Some(OtherStiffness {
            direction: direction.cloned(),
            ratio: beside.ratios[at],
            deviations: beside.deviations.as_ref().map(|all| all[at]),
        })
    });
    let apart = |of: &OtherStiffness| of.ratio.ln().abs();
    each.max_by(|a, b| apart(a).total_cmp(&apart(b)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen::blocks::PairedBy;

    #[test]
    fn holds_springs_of_joints_need_not_explain_a_mode_better_than_to_ten_per_cent() {
        let of = |best_hz: f64, assurance| StackPair {
            motion: StackMotion::Y,
            number: 1,
            paired_by: PairedBy::Order,
            measured_hz: 3.65,
            measured_sd_hz: 0.004,
            is_sd_assumed: false,
            shape_points: 2,
            drawn_hz: 3.618,
            common_hz: best_hz,
            best_hz: None,
            assurance,
            energy_shares: Vec::new(),
        };
        // 1 % off is nine deviations, but no fault of the model
        assert!(!is_off(&[of(3.618, None), of(3.65, Some(0.99))]));
        assert!(is_off(&[of(3.65, None), of(3.0, Some(0.99))]));
        assert!(is_off(&[of(3.65, Some(0.5))]));
    }
}
