//! `dolmen identify` as JSON.

use super::check::{modes, project};
use crate::answer::{Answer, StiffnessAnswer, SurveyAnswer};
use dolmen::structure::{Choice, Convention, StiffnessSolution, Visibility};
use serde_json::{Value, json};

/// What was identified from every survey.
pub fn identification_json(answer: &Answer) -> Value {
    json!({
        "project": project(&answer.project, &answer.file),
        "surveys": answer.surveys.iter().map(survey).collect::<Vec<_>>(),
    })
}

fn survey(survey: &SurveyAnswer) -> Value {
    json!({
        "name": survey.name,
        "stiffness": survey.stiffness.iter().map(stiffness).collect::<Vec<_>>(),
    })
}

fn stiffness(answer: &StiffnessAnswer) -> Value {
    let found = &answer.solutions;
    json!({
        "direction": answer.direction,
        "convention": answer.convention.map(|convention| match convention {
            Convention::Drift => "drift",
            Convention::Grounded => "grounded",
        }),
        "unit": if answer.convention.is_some() { "N/m" } else { "N m/rad" },
        "frequencies_hz": answer.frequencies_hz,
        "with_shapes": answer.with_shapes,
        "choice": match found.choice {
            Choice::One => "one",
            Choice::Indistinguishable => "indistinguishable",
            Choice::Underdetermined => "underdetermined",
            Choice::Impossible => "impossible",
        },
        "solutions": found.solutions.iter().map(solution).collect::<Vec<_>>(),
        "visibility": found.visibility.as_ref().map(visibility),
        "starts": found.starts,
        "notes": found.notes,
    })
}

fn solution(solution: &StiffnessSolution) -> Value {
    json!({
        "stiffness": solution.stiffness,
        "stiffness_sd": solution.stiffness_sd,
        "modes": modes(&solution.modes),
        "misfit": solution.misfit,
        "stands": solution.stands,
    })
}

fn visibility(visibility: &Visibility) -> Value {
    json!({
        "singular_values": visibility.singular_values,
        "seen": visibility.seen,
        "free_directions": visibility.free_directions,
    })
}
