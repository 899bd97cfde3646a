//! The basis of a judgement: assumed inputs, surveys that nobody measured, and known things that the model leaves out on the unsafe side.

use super::grown_damage::GrownDamage;
use super::severe_damage::SevereDamage;
use crate::state::{Check, State};
use crate::survey_dates::date;
use dolmen_project::{Cap, InModel, Inspection, Project, Structure, Survey};

/// The basis of the judgement of one version.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Basis {
    /// Number of assumed inputs.
    pub inputs: AssumedInputs,
    /// Surveys of the file that nobody measured.
    pub made_up_surveys: Vec<String>,
    /// Surveys whose frequencies give the stiffness by construction, so that nothing checks it.
    pub unchecked_stiffness_from: Vec<String>,
    /// Severe damage of inspections that the model does not have.
    pub severe_damage: Vec<SevereDamage>,
    /// Damage of the model that a later inspection recorded as grown.
    pub grown_damage: Vec<GrownDamage>,
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

impl Basis {
    /// The basis of a project; a variant has no inspections of its own.
    pub(crate) fn of(project: &Project, variant: Option<&str>) -> Self {
        let made_up = project.surveys.iter().filter(|survey| survey.is_made_up);
        let (mut severe_damage, mut grown_damage, mut left_out) = (Vec::new(), Vec::new(), Vec::new());
        if variant.is_none() {
            severe_damage = SevereDamage::left_out(project);
            grown_damage = GrownDamage::of(project, &severe_damage);
            left_out = inspections_left_out(project);
        }
        Basis {
            inputs: AssumedInputs::of(project),
            made_up_surveys: made_up.map(|survey| survey.name.clone()).collect(),
            unchecked_stiffness_from: project
                .unchecked_stiffness_from()
                .into_iter()
                .map(str::to_owned)
                .collect(),
            severe_damage,
            grown_damage,
            inspections_left_out: left_out,
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
            || !self.grown_damage.is_empty()
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
