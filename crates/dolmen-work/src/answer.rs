//! Answers of the verbs, and everything computed for one project.

use crate::building::{BuildingSimulation, TogetherAnswer, TuneAnswer};
use crate::chain::ChainSimulation;
use crate::changed_part::{ChangedPart, ModelOff};
use crate::compared_history::ComparedHistory;
use crate::compared_readings::ComparedReadings;
use crate::frame::FrameSimulation;
use crate::motion::MotionReport;
use crate::opened::Opened;
use crate::photos::Photos;
use crate::portfolio::PortfolioAnswer;
use crate::score::ScoreAnswer;
use crate::simulation::{SimulateAnswer, Simulation};
use crate::stack::{SettledSimulation, StackRuns, StackSimulation, SupportsSimulation};
use crate::state::{SensitivityOf, State, VariantAnswer};
use crate::study::{LeftOutStudy, StudyAnswer};
use crate::surveyed::{ModesOf, SurveyAnswer};
use crate::unlike_forces::UnlikeForces;
use crate::watched::WatchAnswer;
use dolmen::assess::{Sensitivity, SurveyChange};
use dolmen_project::Project;
use dolmen_words::message::Both;
use std::sync::Arc;

/// The answer of a verb.
#[derive(Clone, Debug)]
pub enum Answer {
    /// The check.
    Check(Box<CheckAnswer>),
    /// Modes and stiffness from the surveys.
    Identify(Box<IdentifyAnswer>),
    /// The change from one survey to another.
    Compare(Box<CompareAnswer>),
    /// The history of the structure over the years.
    Watch(Box<WatchAnswer>),
    /// The simulation under a ground motion.
    Simulate(Box<SimulateAnswer>),
    /// A study.
    Study(Box<StudyAnswer>),
    /// Dampers of a building.
    Tune(TuneAnswers),
    /// The score of a pagoda.
    Score(Box<ScoreAnswer>),
    /// The ranking of many structures.
    Rank(Box<PortfolioAnswer>),
    /// Ground motions.
    Motion(Box<MotionReport>),
}

/// The check of a structure and its variants.
#[derive(Clone, Debug)]
pub struct CheckAnswer {
    /// Path of the project file as the user named it.
    pub file: String,
    /// The project.
    pub project: Arc<Project>,
    /// The check of the structure as it is; `None` for `kind = "survey"`, and for loose stones, which settle instead.
    pub state: Option<State>,
    /// The check of each `[variant.NAME]`, in the order of the file.
    pub variants: Vec<VariantAnswer>,
    /// Effect of one per cent of each input on `sensitivity_of`, strongest first.
    pub sensitivities: Vec<Sensitivity>,
    /// The result for the sensitivities.
    pub sensitivity_of: SensitivityOf,
    /// Motions of the file that cannot be read, where the check needed them.
    pub unreadable_motions: Vec<UnreadableMotion>,
}

impl CheckAnswer {
    /// The answer on a project that has no model to check.
    pub(crate) fn without_model(opened: &Opened) -> Self {
        CheckAnswer {
            file: opened.file.clone(),
            project: opened.project.clone(),
            state: None,
            variants: Vec::new(),
            sensitivities: Vec::new(),
            sensitivity_of: SensitivityOf::FirstMotion,
            unreadable_motions: Vec::new(),
        }
    }
}

/// A motion that cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnreadableMotion {
    /// Its name in the file.
    pub motion: String,
    /// The reason.
    pub why: Both,
}

/// Results of the surveys of a project.
#[derive(Clone, Debug)]
pub struct IdentifyAnswer {
    /// Path of the project file as the user named it.
    pub file: String,
    /// The project.
    pub project: Arc<Project>,
    /// Results of each survey, in the order of the file.
    pub surveys: Vec<SurveyAnswer>,
}

/// The change from one survey to another.
#[derive(Clone, Debug)]
pub struct CompareAnswer {
    /// Path of the project file as the user named it.
    pub file: String,
    /// The project.
    pub project: Arc<Project>,
    /// The earlier survey.
    pub from: String,
    /// The later survey.
    pub to: String,
    /// The change of the modes; `None` if one of the two has no modes.
    pub change: Option<SurveyChange>,
    /// Findings from all surveys, with their weather and scatter; `None` with too few surveys.
    pub history: Option<ComparedHistory>,
    /// The part of the model that explains the change, by direction; empty if no change is significant.
    pub parts: Vec<ChangedPart>,
    /// Reason why no part is sought: the model is too far from the measured frequencies.
    pub model_off: Option<ModelOff>,
    /// Tilts and inspections of both.
    pub readings: ComparedReadings,
    /// Which of both surveys have records with an earthquake, and which part of the records their modes come from.
    pub shaken: Vec<(String, ModesOf)>,
    /// Surveys of the two whose records say that forces may have shifted their modes.
    pub unlike_forces: Vec<(String, UnlikeForces)>,
    /// Other surveys whose records cannot be used, and why: the weather and the scatter are without them.
    pub unread: Vec<(String, Both)>,
}

/// The dampers of a building, compared with the rule and the optimum.
#[derive(Clone, Debug)]
pub struct TuneAnswers {
    /// Each damper alone.
    pub tunings: Vec<TuneAnswer>,
    /// All dampers of a version together, where there are several.
    pub together: Vec<TogetherAnswer>,
}

/// Everything computed for one project.
#[derive(Clone, Debug)]
pub struct ProjectReport {
    /// Path of the project file as the user named it.
    pub file: String,
    /// The project.
    pub project: Arc<Project>,
    /// The answers.
    pub answers: Vec<Answer>,
    /// Studies with unusable results.
    pub left_out: Vec<LeftOutStudy>,
    /// Its photographs and drawings, by file.
    pub photos: Photos,
    /// Hash of the text of the project file.
    pub fingerprint: String,
    /// The other files that were read.
    pub files: Vec<FileRead>,
}

/// A file that an answer was computed from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileRead {
    /// Its name in the project.
    pub name: String,
    /// Its size, bytes.
    pub bytes: usize,
    /// Hash of its bytes.
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

    /// The check of the structure as it is; `None` for a survey alone.
    pub fn state(&self) -> Option<&State> {
        self.check()?.state.as_ref()
    }

    /// The variants and their checks.
    pub fn variants(&self) -> &[VariantAnswer] {
        self.check().map_or(&[], |check| &check.variants)
    }

    /// Results of each survey.
    pub fn surveys(&self) -> &[SurveyAnswer] {
        let found = self.answers.iter().find_map(|answer| match answer {
            Answer::Identify(identified) => Some(identified.surveys.as_slice()),
            _ => None,
        });
        found.unwrap_or_default()
    }

    /// The change from one survey to another; `None` where no two can be compared.
    pub fn change(&self) -> Option<&CompareAnswer> {
        self.answers.iter().find_map(|answer| match answer {
            Answer::Compare(compared) => Some(&**compared),
            _ => None,
        })
    }

    /// The history over the years; `None` with fewer than three surveys.
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

    /// The simulations of stacks.
    pub fn stack_runs(&self) -> impl Iterator<Item = &StackRuns> {
        self.simulations().filter_map(|run| match run {
            Simulation::Stack(runs) => Some(&**runs),
            _ => None,
        })
    }

    /// For each stack, the decisive run.
    pub fn stack_simulations(&self) -> impl Iterator<Item = &StackSimulation> {
        self.stack_runs().map(|runs| &runs.deciding)
    }

    /// The stack as it is under the motion; `None` without a motion, or if it does not stand.
    pub fn own_stack_runs(&self) -> Option<&StackRuns> {
        self.stack_runs().find(|runs| runs.deciding.variant.is_none())
    }

    /// The stack as it is under the motion; `None` without a motion, or if it does not stand.
    pub fn stack_simulation(&self) -> Option<&StackSimulation> {
        self.stack_simulations().find(|run| run.variant.is_none())
    }

    /// The runs of stacks with moving supports.
    pub fn moved_supports(&self) -> impl Iterator<Item = &SupportsSimulation> {
        self.simulations().filter_map(|run| match run {
            Simulation::Supports(run) => Some(&**run),
            _ => None,
        })
    }

    /// The runs of loose stones.
    pub fn settled_stones(&self) -> impl Iterator<Item = &SettledSimulation> {
        self.simulations().filter_map(|run| match run {
            Simulation::Settled(run) => Some(&**run),
            _ => None,
        })
    }

    /// The simulations of frames, one for each direction.
    pub fn frame_simulations(&self) -> Vec<&FrameSimulation> {
        let each = self.simulations().filter_map(|run| match run {
            Simulation::Frame(run) => Some(&**run),
            _ => None,
        });
        each.collect()
    }

    /// The simulations of chains.
    pub fn chain_simulations(&self) -> Vec<&ChainSimulation> {
        let each = self.simulations().filter_map(|run| match run {
            Simulation::Chain(run) => Some(&**run),
            _ => None,
        });
        each.collect()
    }

    /// The simulations of buildings.
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

    /// Dampers, each alone.
    pub fn tunings(&self) -> Vec<&TuneAnswer> {
        self.tuned()
            .map_or(Vec::new(), |tuned| tuned.tunings.iter().collect())
    }

    /// All dampers of a version together.
    pub fn together(&self) -> Vec<&TogetherAnswer> {
        self.tuned()
            .map_or(Vec::new(), |tuned| tuned.together.iter().collect())
    }

    /// Results of earlier studies.
    pub fn studies(&self) -> Vec<&StudyAnswer> {
        let each = self.answers.iter().filter_map(|answer| match answer {
            Answer::Study(study) => Some(&**study),
            _ => None,
        });
        each.collect()
    }
}
