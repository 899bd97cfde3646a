//! A project: the whole contents of a file, checked.

use super::building::BuildingPart;
use super::chain::ChainPart;
use super::damage::ModelDamage;
use super::frame::FramePart;
use super::leaves::Leaf;
use super::loads::LoadsPart;
use super::names::Names;
use super::quantity::Quantity;
use super::report::ReportPart;
use super::site::{MotionPart, Place, SitePart};
use super::sought::{FromSurveys, Sought};
use super::stack::StackPart;
use super::study::StudyPart;
use super::survey::{ChangePart, Survey, WatchPart, date_of};
use dolmen::assess::demand::DriftLimit;
use dolmen_words::PrintedName;
use dolmen_words::Sentence;
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::sync::Arc;

/// The model in the file: its `kind`.
#[derive(Clone, Debug, PartialEq)]
pub enum Structure {
    /// `kind = "chain"`: rigid links on rotational springs.
    Chain(Box<ChainPart>),
    /// `kind = "frame"`: rigid storeys on lateral springs.
    Frame(FramePart),
    /// `kind = "stack"`: blocks of stone on each other.
    Stack(Box<StackPart>),
    /// `kind = "building"`: rigid floors on walls that sway and twist.
    Building(Box<BuildingPart>),
    /// `kind = "survey"`: measured but not modelled.
    Survey,
}

/// A model with the damage that was known before a day.
#[derive(Clone, Debug, PartialEq)]
pub struct EarlierModel {
    /// The day from which later damage counts: year, month, day.
    pub until: [u32; 3],
    /// The structure.
    pub structure: Structure,
    /// The damage in it.
    pub damage: Vec<ModelDamage>,
}

/// The subject of a warning.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WarningKind {
    /// The top part is left out of a chain: unconservative.
    CapLeftOut,
    /// Values marked as assumed.
    Assumed,
    /// A missing moment of inertia, replaced by that of a thin rod.
    ThinRod,
    /// Missing axial forces, computed from the masses.
    AxialFromMasses,
    /// Free-standing columns, which simulations leave out.
    ColumnsNotInMotion,
    /// Missing values of the joints of a stack: Dolmen's defaults are used.
    JointDefaults,
    /// A key with its name of an earlier version.
    EarlierName,
    /// A surveyed tilt that the model does not lean by.
    SurveyTilt,
    /// A probable slip that `allow` lets pass.
    Allowed,
    /// A pattern that may be a slip or right: named in the first lines of every answer.
    Doubtful,
    /// An unnecessary entry of `allow`.
    AllowedInVain,
    /// Columns of a table of parts that no part uses.
    ColumnsLeftOut,
}

/// A warning that does not stop the reading and appears with every result.
#[derive(Clone, Debug, PartialEq)]
pub struct Warning {
    /// Its subject.
    pub kind: WarningKind,
    /// Line in the file, from 1.
    pub line: usize,
    /// Path in the file: `links[2].weight`.
    pub path: String,
    /// A sentence for the reader.
    pub message: Sentence,
}

impl Warning {
    /// A warning without its line, which is found later.
    pub(super) fn new(kind: WarningKind, path: &str, message: Sentence) -> Self {
        Warning {
            kind,
            line: 0,
            path: path.to_owned(),
            message,
        }
    }
}

/// The same structure with parts of the file replaced: `[variant.NAME]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Variant {
    /// The table's name.
    pub name: String,
    /// A longer name, if given.
    pub title: Option<Names>,
    /// The whole merged project; it has no variants of its own.
    pub project: Project,
}

/// One project file, checked: every number in SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Project {
    /// Version of the file format.
    pub schema: u32,
    /// Name of the structure.
    pub name: Names,
    /// Its description, in a sentence or two.
    pub description: Option<Names>,
    /// Names of parts, surveys and motions as they are printed in another language.
    pub printed_names: Vec<PrintedName>,
    /// Where the numbers come from.
    pub source: Option<String>,
    /// Acceleration of gravity, m/s².
    pub gravity_m_s2: f64,
    /// The model.
    pub structure: Structure,
    /// Loads besides the weight of the structure.
    pub loads: LoadsPart,
    /// Its site with the code; `None` if the file gives none.
    pub site: Option<SitePart>,
    /// Its geographic place; `None` if the file gives none.
    pub place: Option<Place>,
    /// Allowable drift of storeys under the design earthquake; `None` if the file gives none.
    pub drift_limit: Option<DriftLimit>,
    /// The identified stiffness that the file leaves to its surveys; `None` before the identification, and without such stiffness.
    pub from_surveys: Option<Box<FromSurveys>>,
    /// Motions of the ground in the order of the file.
    pub motions: Vec<MotionPart>,
    /// Studies in the order of the file.
    pub studies: Vec<StudyPart>,
    /// Surveys in the order of the file.
    pub surveys: Vec<Survey>,
    /// Damage from inspections that is in the model.
    pub damage: Vec<ModelDamage>,
    /// The model before each inspection that changed it, by date.
    pub earlier: Vec<EarlierModel>,
    /// How to compare two surveys.
    pub change: ChangePart,
    /// The report's own contents; `None` if the file has none, and in variants.
    pub report: Option<ReportPart>,
    /// How to watch many surveys, and the works between them.
    pub watch: WatchPart,
    /// Variants in the order of the file.
    pub variants: Vec<Variant>,
    /// Warnings for every result.
    pub warnings: Vec<Warning>,
    /// Every value of the file as it is written, in its order: without surveys, motions and words about values.
    pub leaves: Arc<[Leaf]>,
    /// Byte range of each value in the text of the file, by path; used to write values back.
    pub spans: BTreeMap<String, Range<usize>>,
}

impl Structure {
    /// Its own numbers: weights, lengths, stiffnesses.
    pub fn inputs(&self) -> Vec<&Quantity> {
        let mut all = Vec::new();
        match self {
            Structure::Chain(chain) => chain.inputs(&mut all),
            Structure::Frame(frame) => frame.inputs(&mut all),
            Structure::Stack(stack) => stack.inputs(&mut all),
            Structure::Building(building) => building.inputs(&mut all),
            Structure::Survey => {}
        }
        all
    }

    /// The stiffness to identify from a survey, each with its path.
    pub fn sought(&self) -> Vec<(String, &Sought)> {
        match self {
            Structure::Chain(chain) => {
                let joints = chain.sought.iter();
                joints.map(|sought| ("joints".to_owned(), sought)).collect()
            }
            Structure::Frame(frame) => {
                let each = frame.directions.iter().filter_map(|direction| {
                    let path = format!("direction.{}.stiffness", direction.name);
                    Some((path, direction.sought.as_ref()?))
                });
                each.collect()
            }
            Structure::Stack(_) | Structure::Building(_) | Structure::Survey => Vec::new(),
        }
    }
}

impl Project {
    /// Every number of the file that may affect a result: the structure's, then the surveys'.
    pub fn inputs(&self) -> Vec<&Quantity> {
        let mut all = self.structure_inputs();
        for survey in &self.surveys {
            survey.inputs(&mut all);
        }
        all
    }

    /// The structure's own numbers: weights, lengths, stiffnesses.
    pub fn structure_inputs(&self) -> Vec<&Quantity> {
        let mut all = self.structure.inputs();
        self.loads.inputs(&mut all);
        all
    }

    /// Pairs of these of which the first is never above the second.
    pub fn ordered_inputs(&self) -> Vec<[&Quantity; 2]> {
        match &self.structure {
            Structure::Frame(part) => part.ordered_inputs(),
            Structure::Chain(part) => part.ordered_inputs(),
            Structure::Stack(part) => part.ordered_inputs(),
            Structure::Building(_) | Structure::Survey => Vec::new(),
        }
    }

    /// The surveys from which numbers of the structure were identified and on which its frequencies depend: a damping ratio calibrates no model.
    pub fn identified_from(&self) -> BTreeSet<&str> {
        let all = self.structure.inputs().into_iter();
        let all = all.filter(|of| !of.path.contains("damping"));
        all.filter_map(|of| of.survey.as_deref()).collect()
    }

    /// The project as it was at a survey: without the damage that was found later; itself where the survey has no date.
    pub fn as_of(&self, survey: &str) -> Cow<'_, Project> {
        match self.earlier_model(survey) {
            None => Cow::Borrowed(self),
            Some(earlier) => Cow::Owned(Project {
                structure: earlier.structure.clone(),
                damage: earlier.damage.clone(),
                earlier: Vec::new(),
                ..self.clone()
            }),
        }
    }

    /// The model as it was at a survey, if damage was found later.
    pub fn earlier_model(&self, survey: &str) -> Option<&EarlierModel> {
        let day = date_of(survey)?;
        self.earlier.iter().find(|of| day < of.until)
    }

    /// The input at a path, `links[1].weight`.
    pub fn input(&self, path: &str) -> Option<&Quantity> {
        self.inputs().into_iter().find(|quantity| quantity.path == path)
    }
}
