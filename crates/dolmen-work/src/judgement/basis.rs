//! The basis of a judgement: assumed inputs, surveys that nobody measured, and known things that the model leaves out on the unsafe side.

use crate::state::{Check, State};
use crate::survey_dates::date;
use dolmen_project::{Cap, DamageKind, InModel, Inspection, Project, Severity, Structure, Survey};

/// The basis of the judgement of one version.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Basis {
    /// Number of assumed inputs.
    pub inputs: AssumedInputs,
    /// Surveys of the file that nobody measured.
    pub made_up_surveys: Vec<String>,
    /// Severe damage of inspections that the model does not have.
    pub severe_damage: Vec<SevereDamage>,
    /// Surveys whose damage the model does not have, because the file chooses an earlier inspection.
    pub inspections_left_out: Vec<String>,
    /// Whether the model of a flagpole leaves out its cap stone.
    pub is_cap_left_out: bool,
    /// Whether the file gives a wind that no combination counts.
    pub is_wind_left_out: bool,
    /// Whether the file gives static loads that no combination counts.
    pub is_loads_left_out: bool,
    /// Load factor of a pole without its side supports, if it would fall without them.
    pub load_factor_without_supports: Option<f64>,
}

/// Inputs of a version.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct AssumedInputs {
    /// Number of assumed inputs.
    pub assumed: usize,
    /// All.
    pub all: usize,
}

/// Severe damage of an inspection.
#[derive(Clone, Debug, PartialEq)]
pub struct SevereDamage {
    /// The survey.
    pub survey: String,
    /// The part.
    pub part: String,
    /// Its kind.
    pub what: DamageKind,
}

impl Basis {
    /// The basis of a project; a variant has no inspections of its own.
    pub(crate) fn of(project: &Project, variant: Option<&str>) -> Self {
        let made_up = project.surveys.iter().filter(|survey| survey.is_made_up);
        Basis {
            inputs: AssumedInputs::of(project),
            made_up_surveys: made_up.map(|survey| survey.name.clone()).collect(),
            severe_damage: match variant {
                None => SevereDamage::left_out(project),
                Some(_) => Vec::new(),
            },
            inspections_left_out: match variant {
                None => inspections_left_out(project),
                Some(_) => Vec::new(),
            },
            is_cap_left_out: matches!(&project.structure, Structure::Chain(part) if part.cap == Cap::LeftOut),
            ..Basis::default()
        }
    }

    /// The basis of a checked project.
    pub(crate) fn of_checked(project: &Project, variant: Option<&str>, state: &State) -> Self {
        let mut basis = Basis::of(project, variant);
        if let Some(loads) = &state.loads {
            // the wind on a building is judged without a combination too
            basis.is_wind_left_out = loads.leaves_wind_out() && !matches!(state.check, Check::Building(_));
            // the weight of a stack is judged with its static loads
            basis.is_loads_left_out = loads.leaves_loads_out() && !matches!(state.check, Check::Stack(_));
        }
        if let Check::Chain(check) = &state.check {
            let without = check.load_factor_without_supports;
            basis.load_factor_without_supports = without.filter(|factor| *factor <= 1.0);
        }
        basis
    }

    /// Whether something known is missing from the model on the unsafe side.
    pub fn is_unsafe(&self) -> bool {
        self.is_cap_left_out
            || self.is_wind_left_out
            || self.is_loads_left_out
            || !self.inspections_left_out.is_empty()
            || !self.severe_damage.is_empty()
    }
}

/// Surveys with damage for the model that it does not have, because the file chooses an earlier inspection.
fn inspections_left_out(project: &Project) -> Vec<String> {
    let leaves_out = |survey: &&Survey| {
        let day = date(&survey.name);
        let is_new = |one: &Inspection| {
            let is_later = |name: &str| date(name) >= day;
            let in_model = project
                .damage
                .iter()
                .any(|of| of.is_of(one) && is_later(&of.survey));
            let mended = project
                .surveys
                .iter()
                .filter(|other| is_later(&other.name))
                .any(|other| {
                    let mut all = other.inspections.iter();
                    all.any(|of| of.is_like(one) && of.model == Some(InModel::Mended))
                });
            one.model.is_some_and(|effect| effect != InModel::Mended) && !in_model && !mended
        };
        day.is_some() && survey.inspections.iter().any(is_new)
    };
    let surveys = project.surveys.iter().filter(leaves_out);
    surveys.map(|survey| survey.name.clone()).collect()
}

impl AssumedInputs {
    /// Counts the inputs that the file of a project marks as assumed, and the values that Dolmen takes for joints where the file gives none.
    pub fn of(project: &Project) -> Self {
        let all = project.inputs();
        let defaults = match &project.structure {
            Structure::Stack(part) => part.joint_defaults().count(),
            _ => 0,
        };
        AssumedInputs {
            assumed: all.iter().filter(|input| input.is_assumed()).count() + defaults,
            all: all.len() + defaults,
        }
    }
}

impl SevereDamage {
    /// Severe damage that the model of a project leaves out, by date. For each part, the entries of the last survey that lists it count.
    pub fn left_out(project: &Project) -> Vec<Self> {
        let mut surveys: Vec<&Survey> = project.surveys.iter().collect();
        surveys.sort_by_key(|survey| date(&survey.name).unwrap_or_default());
        let is_last = |place: usize, part: &str| {
            let mut later = surveys.iter().skip(place + 1);
            !later.any(|survey| survey.inspections.iter().any(|one| one.part == part))
        };
        let is_in_model = |survey: &Survey, one: &Inspection| {
            let mut all = project.damage.iter();
            all.any(|of| of.is_of(one) && date(&of.survey) >= date(&survey.name))
        };
        let each = surveys.iter().enumerate().flat_map(|(place, survey)| {
            let severe = survey
                .inspections
                .iter()
                .filter(move |one| one.severity == Some(Severity::Severe) && is_last(place, &one.part))
                .filter(|one| !is_in_model(survey, one));
            severe.map(|one| SevereDamage {
                survey: survey.name.clone(),
                part: one.part.clone(),
                what: one.what.clone(),
            })
        });
        each.collect()
    }
}
