//! What the verbs answer, and everything that was computed for one project.

use crate::building::{BuildingSimulation, TogetherAnswer, TuneAnswer};
use crate::chain::ChainSimulation;
use crate::changed_part::ChangedPart;
use crate::compared_readings::ComparedReadings;
use crate::frame::FrameSimulation;
use crate::motion::MotionReport;
use crate::photos::Photos;
use crate::portfolio::PortfolioAnswer;
use crate::score::ScoreAnswer;
use crate::simulation::{SimulateAnswer, Simulation};
use crate::stack::{StackRuns, StackSimulation, SupportsSimulation};
use crate::state::{SensitivityOf, State, VariantAnswer};
use crate::study::{LeftOutStudy, StudyAnswer};
use crate::surveyed::{ModesOf, SurveyAnswer};
use crate::watched::WatchAnswer;
use dolmen::assess::{Sensitivity, SurveyChange};
use dolmen_project::Project;
use dolmen_words::message::Both;
use std::sync::Arc;

/// What a verb answers.
#[derive(Clone, Debug)]
pub enum Answer {
    /// Does it stand.
    Check(Box<CheckAnswer>),
    /// Modes and stiffness of the surveys.
    Identify(Box<IdentifyAnswer>),
    /// What changed from one survey to another.
    Compare(Box<CompareAnswer>),
    /// The record of the structure over the years.
    Watch(Box<WatchAnswer>),
    /// The structure under a ground motion.
    Simulate(Box<SimulateAnswer>),
    /// A study.
    Study(Box<StudyAnswer>),
    /// Dampers of a building.
    Tune(TuneAnswers),
    /// The score of a pagoda.
    Score(Box<ScoreAnswer>),
    /// Many structures in order.
    Rank(Box<PortfolioAnswer>),
    /// Ground motions.
    Motion(Box<MotionReport>),
}

/// Whether a structure and its variants stand.
#[derive(Clone, Debug)]
pub struct CheckAnswer {
    /// Path of the project file as the user named it.
    pub file: String,
    /// What the file says.
    pub project: Arc<Project>,
    /// Does it stand, as it is; `None` for `kind = "survey"`.
    pub state: Option<State>,
    /// The same with each `[variant.NAME]`, in the order of the file.
    pub variants: Vec<VariantAnswer>,
    /// What one per cent of each input does to `sensitivity_of`, strongest first.
    pub sensitivities: Vec<Sensitivity>,
    /// The result that the sensitivities are of.
    pub sensitivity_of: SensitivityOf,
    /// Motions of the file that cannot be read, where they were looked at.
    pub unreadable_motions: Vec<UnreadableMotion>,
}

/// A motion that cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnreadableMotion {
    /// Its name in the file.
    pub motion: String,
    /// Why.
    pub why: Both,
}

/// What the surveys of a project give.
#[derive(Clone, Debug)]
pub struct IdentifyAnswer {
    /// Path of the project file as the user named it.
    pub file: String,
    /// What the file says.
    pub project: Arc<Project>,
    /// What was identified from each survey, in the order of the file.
    pub surveys: Vec<SurveyAnswer>,
}

/// What changed from one survey to another.
#[derive(Clone, Debug)]
pub struct CompareAnswer {
    /// Path of the project file as the user named it.
    pub file: String,
    /// What the file says.
    pub project: Arc<Project>,
    /// The survey before.
    pub from: String,
    /// The survey after.
    pub to: String,
    /// The change of what vibrates; `None` where one of the two has no modes.
    pub change: Option<SurveyChange>,
    /// Which part of the model explains the change, by direction; empty where nothing changed beyond chance.
    pub parts: Vec<ChangedPart>,
    /// Tilts and inspections side by side.
    pub readings: ComparedReadings,
    /// Which of both surveys have records that hold an earthquake, and of which part of them their modes are.
    pub shaken: Vec<(String, ModesOf)>,
}

/// Dampers of a building beside the rule and the best.
#[derive(Clone, Debug)]
pub struct TuneAnswers {
    /// Each by itself.
    pub tunings: Vec<TuneAnswer>,
    /// All dampers of a version at once, where there are several.
    pub together: Vec<TogetherAnswer>,
}

/// Everything that was computed for one project.
#[derive(Clone, Debug)]
pub struct ProjectReport {
    /// Path of the project file as the user named it.
    pub file: String,
    /// What the file says.
    pub project: Arc<Project>,
    /// The answers.
    pub answers: Vec<Answer>,
    /// Studies whose results could not be used.
    pub left_out: Vec<LeftOutStudy>,
    /// Its photographs and drawings, by file.
    pub photos: Photos,
    /// What the text of the project file is known by.
    pub fingerprint: String,
}

impl ProjectReport {
    /// The check.
    pub fn check(&self) -> Option<&CheckAnswer> {
        self.answers.iter().find_map(|answer| match answer {
            Answer::Check(check) => Some(&**check),
            _ => None,
        })
    }

    /// Does it stand, as it is; `None` for a survey alone.
    pub fn state(&self) -> Option<&State> {
        self.check()?.state.as_ref()
    }

    /// The variants and whether they stand.
    pub fn variants(&self) -> &[VariantAnswer] {
        self.check().map_or(&[], |check| &check.variants)
    }

    /// What was identified from each survey.
    pub fn surveys(&self) -> &[SurveyAnswer] {
        let found = self.answers.iter().find_map(|answer| match answer {
            Answer::Identify(identified) => Some(identified.surveys.as_slice()),
            _ => None,
        });
        found.unwrap_or_default()
    }

    /// What changed from one survey to another; `None` where fewer than two can be compared.
    pub fn change(&self) -> Option<&CompareAnswer> {
        self.answers.iter().find_map(|answer| match answer {
            Answer::Compare(compared) => Some(&**compared),
            _ => None,
        })
    }

    /// The record over the years; `None` with fewer than three surveys.
    pub fn watch(&self) -> Option<&WatchAnswer> {
        self.answers.iter().find_map(|answer| match answer {
            Answer::Watch(watched) => Some(&**watched),
            _ => None,
        })
    }

    /// Every simulation, of the structure as it is and of its variants.
    pub fn simulations(&self) -> impl Iterator<Item = &Simulation> {
        let each = self.answers.iter().filter_map(|answer| match answer {
            Answer::Simulate(simulated) => Some(&simulated.simulations),
            _ => None,
        });
        each.flatten()
    }

    /// Those of stacks.
    pub fn stack_runs(&self) -> impl Iterator<Item = &StackRuns> {
        self.simulations().filter_map(|run| match run {
            Simulation::Stack(runs) => Some(&**runs),
            _ => None,
        })
    }

    /// Of each stack the run that decides.
    pub fn stack_simulations(&self) -> impl Iterator<Item = &StackSimulation> {
        self.stack_runs().map(|runs| &runs.deciding)
    }

    /// The stack as it is under the motion; `None` if none was asked for, or it does not stand.
    pub fn own_stack_runs(&self) -> Option<&StackRuns> {
        self.stack_runs().find(|runs| runs.deciding.variant.is_none())
    }

    /// The stack as it is under the motion; `None` if none was asked for, or it does not stand.
    pub fn stack_simulation(&self) -> Option<&StackSimulation> {
        self.stack_simulations().find(|run| run.variant.is_none())
    }

    /// Those of stacks whose supports move.
    pub fn moved_supports(&self) -> impl Iterator<Item = &SupportsSimulation> {
        self.simulations().filter_map(|run| match run {
            Simulation::Supports(run) => Some(&**run),
            _ => None,
        })
    }

    /// Those of frames, one a direction.
    pub fn frame_simulations(&self) -> Vec<&FrameSimulation> {
        let each = self.simulations().filter_map(|run| match run {
            Simulation::Frame(run) => Some(&**run),
            _ => None,
        });
        each.collect()
    }

    /// Those of chains.
    pub fn chain_simulations(&self) -> Vec<&ChainSimulation> {
        let each = self.simulations().filter_map(|run| match run {
            Simulation::Chain(run) => Some(&**run),
            _ => None,
        });
        each.collect()
    }

    /// Those of buildings.
    pub fn building_simulations(&self) -> Vec<&BuildingSimulation> {
        let each = self.simulations().filter_map(|run| match run {
            Simulation::Building(run) => Some(&**run),
            _ => None,
        });
        each.collect()
    }

    fn tuned(&self) -> Option<&TuneAnswers> {
        self.answers.iter().find_map(|answer| match answer {
            Answer::Tune(tuned) => Some(tuned),
            _ => None,
        })
    }

    /// Dampers, each by itself.
    pub fn tunings(&self) -> Vec<&TuneAnswer> {
        self.tuned()
            .map_or(Vec::new(), |tuned| tuned.tunings.iter().collect())
    }

    /// All dampers of a version at once.
    pub fn together(&self) -> Vec<&TogetherAnswer> {
        self.tuned()
            .map_or(Vec::new(), |tuned| tuned.together.iter().collect())
    }

    /// Studies that were run before.
    pub fn studies(&self) -> Vec<&StudyAnswer> {
        let each = self.answers.iter().filter_map(|answer| match answer {
            Answer::Study(study) => Some(&**study),
            _ => None,
        });
        each.collect()
    }
}
