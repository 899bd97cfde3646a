//! Stiffness that one survey determines, written into the project file.

use crate::answer::IdentifyAnswer;
use crate::building::PlanAnswer;
use crate::error::WorkError;
use crate::opened::Opened;
use crate::survey_dates::date;
use crate::surveyed::{StiffnessAnswer, SurveyAnswer};
use dolmen::structure::StiffnessSolution;
use dolmen_project::{
    BuildingPart, ChainAxis, ChainPart, FramePart, IdentifiedNumber, NewValue, Project, Quantity,
    StoreyStiffnessPart, Structure, with_values,
};
use dolmen_records::Files;
use dolmen_words::number::significant;

/// A project file with the stiffness from a survey written into it.
#[derive(Clone, Debug)]
pub struct WrittenBack {
    /// The resulting project, with its text.
    pub opened: Opened,
    /// The survey.
    pub survey: String,
    /// The changes, by their places in the file.
    pub numbers: Vec<(String, IdentifiedNumber)>,
    /// Whether some of it fits by construction, so that nothing checks it.
    pub is_unchecked: bool,
}

/// Writes the stiffness of the only survey that determines any into the project file. The resulting text can be read as a project.
///
/// # Errors
/// [`WorkError::NothingToWrite`], [`WorkError::SeveralToWrite`], [`WorkError::NotInTheFile`], or the errors of the resulting project.
pub fn write_back(
    opened: &Opened,
    answer: &IdentifyAnswer,
    files: &dyn Files,
) -> Result<WrittenBack, WorkError> {
    let each = determined(answer);
    let surveys: Vec<String> = each.iter().map(|(survey, _)| (*survey).to_owned()).collect();
    let [(survey, values)] = each.as_slice() else {
        return Err(match surveys.is_empty() {
            true => springs_to_type(answer).unwrap_or(WorkError::NothingToWrite),
            false => WorkError::SeveralToWrite { surveys },
        });
    };
    let text = with_values(&opened.text, &answer.project, values);
    let text = text.map_err(|path| WorkError::NotInTheFile { path })?;
    let opened = Opened::read(text, opened.file.clone(), files)?;
    let numbers = values.iter().flat_map(|(path, value)| numbers(path, value));
    Ok(WrittenBack {
        opened,
        survey: (*survey).to_owned(),
        numbers: numbers.collect(),
        is_unchecked: is_unchecked(answer, survey),
    })
}

/// Whether the survey that [`write_back`] writes from gives a stiffness that fits by construction; `false` if it has nothing to write.
pub fn would_be_unchecked(answer: &IdentifyAnswer) -> bool {
    let each = determined(answer);
    each.iter().any(|(survey, _)| is_unchecked(answer, survey))
}

fn is_unchecked(answer: &IdentifyAnswer, survey: &str) -> bool {
    let own = answer.surveys.iter().filter(|own| own.name == survey);
    let mut own = own.flat_map(|survey| &survey.stiffness);
    own.any(|answer| answer.is_undoubted() && answer.fits_by_construction())
}

/// The springs of a stack from the common factor of its latest survey; `None` if no survey has a factor that explains its modes.
fn springs_to_type(answer: &IdentifyAnswer) -> Option<WorkError> {
    let known = answer.surveys.iter().filter_map(|survey| {
        let factors = survey.factors.as_deref()?;
        (!factors.common_misses()).then_some((survey.name.as_str(), factors))
    });
    let (survey, factors) = known.max_by_key(|(name, _)| date(name))?;
    let factor = factors.found.common.factor;
    let drawn: Option<Vec<[f64; 2]>> = (0..factors.found.factors.len())
        .map(|at| factors.drawn_stiffness_pa_m(at))
        .collect();
    let alike = drawn.filter(|all| all.windows(2).all(|pair| pair[0] == pair[1]));
    let keys = match alike.and_then(|all| all.first().copied()) {
        Some([normal, shear]) => {
            let [normal, shear] = [normal, shear].map(|drawn| format!("\"{:.3e} Pa/m\"", factor * drawn));
            format!("normal_stiffness = {normal}, shear_stiffness = {shear}")
        }
        None => "normal_stiffness, shear_stiffness".to_owned(),
    };
    Some(WorkError::SpringsToType {
        survey: survey.to_owned(),
        factor: significant(factor, 3),
        keys,
    })
}

/// Whether [`write_back`] has exactly one survey to write from.
pub fn can_be_written(answer: &IdentifyAnswer) -> bool {
    determined(answer).len() == 1
}

/// The stiffness that each survey determines, without surveys that determine none.
fn determined(answer: &IdentifyAnswer) -> Vec<(&str, Vec<(String, NewValue)>)> {
    let surveys = answer.surveys.iter();
    let each = surveys.map(|survey| (survey.name.as_str(), of_survey(&answer.project, survey)));
    each.filter(|(_, values)| !values.is_empty()).collect()
}

fn of_survey(project: &Project, survey: &SurveyAnswer) -> Vec<(String, NewValue)> {
    match &project.structure {
        Structure::Chain(chain) => of_chain(chain, survey).unwrap_or_default(),
        Structure::Frame(frame) => of_frame(frame, survey),
        Structure::Building(building) => {
            let plan = survey.plan.as_deref();
            plan.and_then(|plan| of_plan(building, plan, &survey.name))
                .unwrap_or_default()
        }
        // with other springs other joints close under the weight, so a factor on them does not give the measured frequency
        Structure::Stack(_) | Structure::Survey => Vec::new(),
    }
}

/// The numbers of the only solution; `None` if there are several, or if only bounds are known.
fn one_solution(answer: &StiffnessAnswer, unit: &'static str, survey: &str) -> Option<Vec<IdentifiedNumber>> {
    let found = &answer.solutions;
    let one = found.solutions.first().filter(|_| answer.is_chosen())?;
    Some(of_solution(one, unit, survey))
}

/// The numbers of a solution.
pub(crate) fn of_solution(
    solution: &StiffnessSolution,
    unit: &'static str,
    survey: &str,
) -> Vec<IdentifiedNumber> {
    let each = solution.stiffness.iter().enumerate();
    let numbers = each.map(|(part, value)| IdentifiedNumber {
        value: *value,
        sd: solution.stiffness_sd.as_ref().map(|sd| sd[part]),
        unit,
        survey: survey.to_owned(),
        before: None,
        note: None,
    });
    numbers.collect()
}

/// The numbers of a chain in the form of the file: for the lowest joint only its bed. `None` if the soil below is softer than both together.
pub(crate) fn without_soil(
    chain: &ChainPart,
    towards: ChainAxis,
    mut numbers: Vec<IdentifiedNumber>,
) -> Option<Vec<IdentifiedNumber>> {
    let soil = chain.soil_towards(towards, &mut Quantity::nominal);
    if let (Some(soil), Some(lowest)) = (soil, numbers.first_mut()) {
        let bed = soil.joint_n_m_rad(lowest.value)?;
        let steeper = (bed / lowest.value).powi(2); // d bed / d together
        lowest.sd = lowest.sd.map(|sd| sd * steeper);
        lowest.value = bed;
    }
    Some(numbers)
}

/// Replaces the numbers of the file, each with a note of the old value; writes the whole entry if the file has none.
fn in_place(
    known: Option<Vec<&Quantity>>,
    numbers: Vec<IdentifiedNumber>,
    whole: impl FnOnce(Vec<IdentifiedNumber>) -> (String, NewValue),
) -> Vec<(String, NewValue)> {
    match known {
        Some(known) => {
            let each = known.into_iter().zip(numbers);
            each.map(|(before, number)| replaced(before, number)).collect()
        }
        None => vec![whole(numbers)],
    }
}

fn replaced(before: &Quantity, number: IdentifiedNumber) -> (String, NewValue) {
    let is_first = before.survey.is_none();
    let number = IdentifiedNumber {
        before: is_first.then(|| before.written.clone()),
        note: match is_first {
            true => Some(known_before(before)),
            false => before.note.clone(),
        },
        ..number
    };
    (before.path.clone(), NewValue::Number(number))
}

/// The note of the old value: "before: 630 kN*m/rad, literature, cov 0.3; Kim 2018".
fn known_before(before: &Quantity) -> String {
    let source = before.source.map(|source| format!(", {}", source.word()));
    let cov = before
        .cov
        .map(|cov| format!(", cov {}", (cov * 1e4).round() / 1e4));
    let note = before.note.as_ref().map(|note| format!("; {note}"));
    let known = [source, cov, note].map(Option::unwrap_or_default).concat();
    format!("before: {}{known}", before.written)
}

/// A chain with one direction has one stiffness for all directions, so it is written only if a single direction of the survey determines
/// it. A chain with two directions is written separately for each; across only if the file has values there.
fn of_chain(chain: &ChainPart, survey: &SurveyAnswer) -> Option<Vec<(String, NewValue)>> {
    let mut all = Vec::new();
    for of in chain.axes() {
        let own = survey.stiffness.iter();
        let own = own.filter(|answer| chain.axis_of(&answer.direction) == *of);
        all.extend(of_chain_towards(chain, own, (survey, *of)).unwrap_or_default());
    }
    Some(all)
}

fn of_chain_towards<'a>(
    chain: &ChainPart,
    own: impl Iterator<Item = &'a StiffnessAnswer>,
    (survey, towards): (&SurveyAnswer, ChainAxis),
) -> Option<Vec<(String, NewValue)>> {
    let mut each = own.filter_map(|answer| one_solution(answer, "N m/rad", &survey.name));
    let numbers = each.next().filter(|_| each.next().is_none())?;
    let numbers = without_soil(chain, towards, numbers)?;
    let known = chain.joints.as_ref();
    if towards == ChainAxis::Across {
        let given = known?.iter().map(|joint| joint.stiffness_across.as_ref());
        let given: Vec<&Quantity> = given.collect::<Option<_>>()?;
        let each = given.into_iter().zip(numbers);
        return Some(each.map(|(before, number)| replaced(before, number)).collect());
    }
    let known = known.map(|joints| joints.iter().map(|joint| &joint.stiffness).collect());
    let whole = |numbers| ("joints".to_owned(), NewValue::Each("stiffness", numbers));
    Some(in_place(known, numbers, whole))
}

/// Each direction of a frame separately, by the convention of the file.
fn of_frame(frame: &FramePart, survey: &SurveyAnswer) -> Vec<(String, NewValue)> {
    let own = survey
        .stiffness
        .iter()
        .filter(|answer| answer.convention == Some(frame.convention));
    let each = own.filter_map(|answer| Some((answer, one_solution(answer, "N/m", &survey.name)?)));
    let values = each.flat_map(|(answer, numbers)| {
        let known = frame
            .directions
            .iter()
            .find(|known| known.name == answer.direction);
        let known = known.and_then(|known| known.stiffness.as_ref());
        let whole = |numbers| {
            let path = format!("direction.{}.stiffness", answer.direction);
            (path, NewValue::Numbers(numbers))
        };
        in_place(known.map(|known| known.iter().collect()), numbers, whole)
    });
    values.collect()
}

/// k_x, k_y and k_θ of the only floor, and its centre of rigidity: only if the modes determined that too.
fn of_plan(building: &BuildingPart, plan: &PlanAnswer, survey: &str) -> Option<Vec<(String, NewValue)>> {
    let [floor] = building.floors.as_slice() else {
        return None;
    };
    let StoreyStiffnessPart::Whole {
        x,
        y,
        rotation,
        centre,
    } = &floor.stiffness
    else {
        return None;
    };
    // with frequencies alone the centre of rigidity is that of the file
    let one = plan.determined()?;
    let parts = [(x, "N/m"), (y, "N/m"), (rotation, "N m/rad")];
    let each = parts.into_iter().enumerate();
    let mut values: Vec<(String, NewValue)> = each
        .map(|(part, (before, unit))| {
            let number = IdentifiedNumber {
                value: one.stiffness[part],
                sd: one.stiffness_sd.map(|sd| sd[part]),
                unit,
                survey: survey.to_owned(),
                before: None,
                note: None,
            };
            replaced(before, number)
        })
        .collect();
    let path = centre[0].path.trim_end_matches("[1]").to_owned();
    let from_origin = [0, 1].map(|axis| plan.centre_of_mass_m[axis] + one.eccentricity_m[axis]);
    values.push((path, NewValue::Lengths(from_origin.to_vec())));
    Some(values)
}

/// The numbers of a value, by their places.
fn numbers(path: &str, value: &NewValue) -> Vec<(String, IdentifiedNumber)> {
    let listed = |all: &[IdentifiedNumber], key: &str| {
        let each = (1..).zip(all);
        each.map(|(part, number)| (format!("{path}[{part}]{key}"), number.clone()))
            .collect()
    };
    match value {
        NewValue::Number(number) => vec![(path.to_owned(), number.clone())],
        NewValue::Numbers(all) => listed(all, ""),
        NewValue::Each(key, all) => listed(all, &format!(".{key}")),
        NewValue::Lengths(_) => Vec::new(),
    }
}
