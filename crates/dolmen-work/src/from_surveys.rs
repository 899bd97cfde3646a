//! Stiffness identified from the surveys of a file: computed once, then used as if it were written in the project.

use crate::answer::CheckAnswer;
use crate::check::{CheckOptions, check};
use crate::error::WorkError;
use crate::identify::surveys;
use crate::judgement::judge_check;
use crate::opened::Opened;
use crate::progress::Progress;
use crate::survey_dates::date;
use crate::surveyed::{StiffnessAnswer, SurveyAnswer};
use crate::write_back::{of_solution, without_soil};
use dolmen::structure::{Choice, StiffnessSolution};
use dolmen_project::{
    ChainAxis, FromSurvey, FromSurveys, Names, NewValue, Project, Sought, Structure, Survey, Variant,
    WhyNotIdentified, with_values_on_their_lines,
};
use dolmen_records::Files;
use std::cmp::{Ordering, Reverse};
use std::sync::Arc;

/// Largest number of solutions that are judged one by one; with more the stiffness stays unknown. Our choice: the orders of four joints.
const SOLUTIONS_MOST: usize = 24;

/// Resolves `joints = "identified"`: the project with the stiffness from its surveys, as if written in the file. If there are several
/// solutions, it contains the one with the worst check, and the others are variants "solution_2" and so on. If none is accepted, the
/// stiffness stays unknown, and the project gives the reason.
///
/// # Errors
/// [`WorkError`] of the identification, of the resulting project, and of its check.
pub fn with_stiffness_of_surveys(
    opened: Opened,
    files: &dyn Files,
    progress: &dyn Progress,
) -> Result<Opened, WorkError> {
    let project = opened.project.clone();
    let sought = project.structure.sought();
    if sought.is_empty() {
        return Ok(opened);
    }
    let mut identified: Vec<SurveyAnswer> = Vec::new();
    let mut parts: Vec<Part> = Vec::new();
    for (path, sought) in sought {
        let chosen = survey_of(&project, &path, sought);
        if let Some(name) = chosen.filter(|name| identified.iter().all(|known| known.name != *name)) {
            identified.extend(surveys(&opened, Some(name), files, progress)?);
        }
        let answer = chosen.and_then(|name| identified.iter().find(|known| known.name == name));
        parts.push(Part::of(&project, path, answer));
    }
    let solutions: usize = parts.iter().map(|part| part.values.len().max(1)).product();
    if solutions > SOLUTIONS_MOST {
        for part in &mut parts {
            part.give_up(solutions);
        }
    }
    let mut judged = Vec::new();
    for values in each_together(&parts) {
        let text = with_values_on_their_lines(&opened.text, &project, &values);
        let text = text.map_err(|path| WorkError::NotInTheFile { path })?;
        let read = Opened::read(text, opened.file.clone(), files)?;
        let answer = check(&read, &CheckOptions::default())?;
        judged.push((read, answer));
    }
    let is_known = parts.iter().any(|part| !part.values.is_empty());
    let of = if is_known { judged.len() } else { 0 };
    let told = |number: usize| FromSurveys {
        parts: parts.iter().map(|part| part.told.clone()).collect(),
        number,
        of,
    };
    let mut numbered: Vec<(usize, Opened, CheckAnswer)> = (1..)
        .zip(judged)
        .map(|(number, (mut read, answer))| {
            tell(Arc::make_mut(&mut read.project), &told(number));
            (number, read, answer)
        })
        .collect();
    numbered.sort_by(|a, b| worse_first(&a.2, &b.2).then(a.0.cmp(&b.0)));
    let mut numbered = numbered.into_iter();
    let Some((_, mut worst, _)) = numbered.next() else {
        return Ok(opened);
    };
    let mut others: Vec<(usize, Opened)> = numbered.map(|(number, read, _)| (number, read)).collect();
    others.sort_by_key(|(number, _)| *number);
    let project = Arc::make_mut(&mut worst.project);
    for (number, other) in others {
        add_solution(project, number, &other.project);
    }
    worst.identified = identified;
    Ok(worst)
}

/// The name of the variant for another solution.
fn solution_name(number: usize) -> String {
    format!("solution_{number}")
}

/// Whether a variant is another solution of an identified stiffness instead of a variant of the file.
fn is_solution(variant: &Variant) -> bool {
    let told = variant.project.from_surveys.as_ref();
    told.is_some_and(|told| variant.name == solution_name(told.number))
}

/// The variants for other solutions, by their numbers.
pub(crate) fn other_solutions(project: &Project) -> Vec<(usize, &str)> {
    let each = project.variants.iter().filter(|variant| is_solution(variant));
    let numbered = each.filter_map(|variant| {
        let told = variant.project.from_surveys.as_ref()?;
        Some((told.number, variant.name.as_str()))
    });
    numbered.collect()
}

/// A stiffness to be identified.
struct Part {
    told: FromSurvey,
    /// The values of each accepted solution.
    values: Vec<NewValue>,
}

impl Part {
    fn of(project: &Project, path: String, survey: Option<&SurveyAnswer>) -> Self {
        let found = match survey {
            None => Err(WhyNotIdentified::NoSurvey),
            // modes of an earthquake are not ambient ones
            Some(survey) if survey.is_shaken() && !states_modes(project, survey) => {
                Err(WhyNotIdentified::Doubted)
            }
            Some(survey) => values(project, &path, survey),
        };
        let is_unchecked = survey.is_some_and(|survey| {
            let mut own = of_path(project, &path, survey);
            own.next().is_some_and(StiffnessAnswer::is_unchecked) && own.all(StiffnessAnswer::is_unchecked)
        });
        let told = FromSurvey {
            path,
            survey: survey.map(|survey| survey.name.clone()),
            unknown: found.as_ref().err().copied(),
            is_unchecked,
        };
        Part {
            told,
            values: found.unwrap_or_default(),
        }
    }

    fn give_up(&mut self, solutions: usize) {
        if self.values.len() > 1 {
            self.told.unknown = Some(WhyNotIdentified::TooMany { solutions });
            self.values.clear();
        }
    }
}

/// Whether the file states modes of a survey itself.
fn states_modes(project: &Project, answer: &SurveyAnswer) -> bool {
    let mut own = project.surveys.iter().filter(|survey| survey.name == answer.name);
    own.any(|survey| !survey.modes.is_empty())
}

/// The survey from which a stiffness is identified: the named one, otherwise the latest with modes in its direction or with records.
fn survey_of<'a>(project: &'a Project, path: &str, sought: &'a Sought) -> Option<&'a str> {
    if let Some(name) = &sought.survey {
        return Some(name);
    }
    let direction = path
        .strip_prefix("direction.")
        .and_then(|of| of.strip_suffix(".stiffness"));
    let has_modes = |survey: &Survey| match direction {
        Some(direction) => survey.modes.contains_key(direction),
        None => !survey.modes.is_empty(),
    };
    let can_tell =
        |survey: &&Survey| has_modes(survey) || survey.records.is_some() || !survey.setups.is_empty();
    let surveys = project.surveys.iter().filter(can_tell);
    let latest = surveys.max_by_key(|survey| date(&survey.name)); // of equal dates the last by name
    latest.map(|survey| survey.name.as_str())
}

/// The answers of a survey for a stiffness. A chain with one direction has one stiffness for all: the result of any direction is a solution.
fn of_path<'a>(
    project: &'a Project,
    path: &'a str,
    survey: &'a SurveyAnswer,
) -> impl Iterator<Item = &'a StiffnessAnswer> {
    survey
        .stiffness
        .iter()
        .filter(move |answer| match &project.structure {
            Structure::Chain(chain) => chain.axis_of(&answer.direction) == ChainAxis::Along,
            Structure::Frame(frame) => {
                answer.convention == Some(frame.convention)
                    && path == format!("direction.{}.stiffness", answer.direction)
            }
            Structure::Stack(_) | Structure::Building(_) | Structure::Survey => false,
        })
}

/// The values of each accepted solution of a stiffness.
fn values(project: &Project, path: &str, survey: &SurveyAnswer) -> Result<Vec<NewValue>, WhyNotIdentified> {
    match &project.structure {
        Structure::Chain(chain) => {
            let numbers = accepted(of_path(project, path, survey))?
                .into_iter()
                .map(|solution| {
                    let numbers = of_solution(solution, "N m/rad", &survey.name);
                    without_soil(chain, ChainAxis::Along, numbers)
                });
            let numbers: Option<Vec<_>> = numbers.collect();
            let numbers = numbers.ok_or(WhyNotIdentified::Impossible)?;
            let each = numbers.into_iter();
            Ok(each.map(|numbers| NewValue::Each("stiffness", numbers)).collect())
        }
        Structure::Frame(_) => {
            let each = accepted(of_path(project, path, survey))?.into_iter();
            let numbers = each.map(|solution| of_solution(solution, "N/m", &survey.name));
            Ok(numbers.map(NewValue::Numbers).collect())
        }
        Structure::Stack(_) | Structure::Building(_) | Structure::Survey => Err(WhyNotIdentified::NoModes),
    }
}

/// The solutions that explain the modes of every direction; none if one direction does not determine it.
fn accepted<'a>(
    answers: impl Iterator<Item = &'a StiffnessAnswer>,
) -> Result<Vec<&'a StiffnessSolution>, WhyNotIdentified> {
    let mut all = Vec::new();
    for answer in answers {
        let found = &answer.solutions;
        if !answer.is_undoubted() {
            return Err(WhyNotIdentified::Doubted);
        }
        match found.choice {
            Choice::One => {}
            Choice::Indistinguishable if found.solutions.len() < 2 => return Err(WhyNotIdentified::Meet),
            Choice::Indistinguishable => {}
            Choice::Bounded => return Err(WhyNotIdentified::Bounded),
            Choice::Underdetermined => return Err(WhyNotIdentified::Underdetermined),
            Choice::Impossible => return Err(WhyNotIdentified::Impossible),
        }
        if found.solutions.iter().any(|one| one.stiffness_bounds.is_some()) {
            return Err(WhyNotIdentified::Bounded);
        }
        all.extend(&found.solutions);
    }
    match all.is_empty() {
        true => Err(WhyNotIdentified::NoModes),
        false => Ok(all),
    }
}

/// Every combination of one solution for each identified stiffness.
fn each_together(parts: &[Part]) -> Vec<Vec<(String, NewValue)>> {
    let mut all = vec![Vec::new()];
    for part in parts.iter().filter(|part| !part.values.is_empty()) {
        let with_each = |before: &Vec<(String, NewValue)>| {
            let each = part.values.iter().map(|value| {
                let mut values = before.clone();
                values.push((part.told.path.clone(), value.clone()));
                values
            });
            each.collect::<Vec<_>>()
        };
        all = all.iter().flat_map(with_each).collect();
    }
    all
}

/// Writes the results of the identification into a project and its variants.
fn tell(project: &mut Project, told: &FromSurveys) {
    project.from_surveys = Some(Box::new(told.clone()));
    for variant in &mut project.variants {
        tell(&mut variant.project, told);
    }
}

/// Order: by colour, then by the words for weight and earthquake, the load factor, and the margin against the demand of the site.
fn worse_first(a: &CheckAnswer, b: &CheckAnswer) -> Ordering {
    let words = |of: &CheckAnswer| {
        let judgement = judge_check(of);
        let headline = judgement.headline();
        let weight = headline.and_then(|of| of.weight).map(|weight| weight.colour());
        let earthquake = headline.map(|of| of.earthquake_word().colour());
        Reverse((headline.map(|of| of.colour()), weight, earthquake))
    };
    let factor = |of: &CheckAnswer| {
        let state = of.state.as_ref();
        state
            .and_then(|state| state.load_factor())
            .unwrap_or(f64::INFINITY)
    };
    let left = |of: &CheckAnswer| {
        let judgement = judge_check(of);
        let found = judgement
            .headline()
            .map(|of| of.earthquake.clone())
            .unwrap_or_default();
        let ratios = found.into_iter().filter_map(|finding| finding.ratio);
        ratios.fold(f64::INFINITY, f64::min)
    };
    words(a)
        .cmp(&words(b))
        .then(factor(a).total_cmp(&factor(b)))
        .then(left(a).total_cmp(&left(b)))
}

/// Adds another solution, and the variants of the file that keep its stiffness.
fn add_solution(project: &mut Project, number: usize, other: &Project) {
    let variant_of = |name: String, title: Names, of: &Project| Variant {
        name,
        title: Some(title),
        project: Project {
            variants: Vec::new(),
            ..of.clone()
        },
    };
    let title = Names {
        en: Some(format!("Solution {number}")),
        ko: Some(format!("해 {number}")),
    };
    let mut added = vec![variant_of(solution_name(number), title, other)];
    for variant in &other.variants {
        let own = project.variants.iter().find(|own| own.name == variant.name);
        if own.is_some_and(|own| own.project.structure != variant.project.structure) {
            let names = variant.title.as_ref();
            let title = Names {
                en: Some(format!(
                    "{}, solution {number}",
                    names.map_or(variant.name.as_str(), Names::english)
                )),
                ko: Some(format!(
                    "{}, 해 {number}",
                    names.map_or(variant.name.as_str(), Names::korean)
                )),
            };
            let name = format!("{}_{}", variant.name, solution_name(number));
            added.push(variant_of(name, title, &variant.project));
        }
    }
    project.variants.extend(added);
}
