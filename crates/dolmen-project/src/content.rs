//! A project: everything one file says, checked.

use super::building::BuildingPart;
use super::chain::ChainPart;
use super::damage::ModelDamage;
use super::frame::FramePart;
use super::loads::LoadsPart;
use super::names::Names;
use super::quantity::Quantity;
use super::report::ReportPart;
use super::site::{MotionPart, Place, SitePart};
use super::sought::{FromSurveys, Sought};
use super::stack::StackPart;
use super::study::StudyPart;
use super::survey::{ChangePart, Survey, WatchPart};
use dolmen::assess::demand::DriftLimit;
use dolmen_words::PrintedName;
use dolmen_words::Sentence;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// What the file models: its `kind`.
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

/// What a warning is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WarningKind {
    /// The top part is left out of a chain: unconservative.
    CapLeftOut,
    /// Values marked as assumed.
    Assumed,
    /// A moment of inertia not given, taken as that of a thin rod.
    ThinRod,
    /// Axial forces not given, taken from the masses.
    AxialFromMasses,
    /// Free-standing columns, which simulations leave out.
    ColumnsNotInMotion,
    /// Values of the joints of a stack that are not given: Dolmen's own are taken.
    JointDefaults,
    /// A key by the name that an earlier version had for it.
    EarlierName,
    /// A surveyed tilt that the model does not lean by.
    SurveyTilt,
    /// A probable slip that `allow` lets pass.
    Allowed,
    /// A pattern that looks like a slip and may be right: in the first lines of every answer.
    Doubtful,
    /// An entry of `allow` that nothing needed.
    AllowedInVain,
    /// Columns of a table of parts that no part takes.
    ColumnsLeftOut,
}

/// Something that does not stop the reading, but that every result carries.
#[derive(Clone, Debug, PartialEq)]
pub struct Warning {
    /// What it is about.
    pub kind: WarningKind,
    /// Line in the file, from 1.
    pub line: usize,
    /// Where in the file: `links[2].weight`.
    pub path: String,
    /// A sentence for the reader.
    pub message: Sentence,
}

impl Warning {
    /// A warning whose line is not known yet.
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
    /// What it is, in a sentence or two.
    pub description: Option<Names>,
    /// Names of parts, surveys and motions as they are printed in another language.
    pub printed_names: Vec<PrintedName>,
    /// Where the numbers come from.
    pub source: Option<String>,
    /// Acceleration of gravity, m/s².
    pub gravity_m_s2: f64,
    /// The model.
    pub structure: Structure,
    /// What acts beside the weight of the structure.
    pub loads: LoadsPart,
    /// Where it stands and by what it is judged; `None` if the file does not say.
    pub site: Option<SitePart>,
    /// Its place on the earth; `None` if the file does not say.
    pub place: Option<Place>,
    /// How far storeys may drift under the design earthquake; `None` if the file does not say.
    pub drift_limit: Option<DriftLimit>,
    /// What came of the stiffness that the file leaves to its surveys, once that was sought; `None` before, and where it leaves none.
    pub from_surveys: Option<Box<FromSurveys>>,
    /// Motions of the ground in the order of the file.
    pub motions: Vec<MotionPart>,
    /// Studies in the order of the file.
    pub studies: Vec<StudyPart>,
    /// Surveys in the order of the file.
    pub surveys: Vec<Survey>,
    /// Damage of inspections that the model has.
    pub damage: Vec<ModelDamage>,
    /// How two surveys are compared.
    pub change: ChangePart,
    /// What the report says beside the computation; `None` where the file says nothing, and of variants.
    pub report: Option<ReportPart>,
    /// How many surveys are watched, and the works between them.
    pub watch: WatchPart,
    /// Variants in the order of the file.
    pub variants: Vec<Variant>,
    /// What every result must carry along.
    pub warnings: Vec<Warning>,
    /// Where each value stands in the text of the file, by its path, in bytes: what a value is written back by.
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

    /// The stiffness that it leaves to a survey, each with its path.
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
    /// Every number of the file that a result may depend on: the structure's, then the surveys'.
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

    /// The surveys that numbers of the structure were identified from, on which its frequencies rest: a damping ratio calibrates no model.
    pub fn identified_from(&self) -> BTreeSet<&str> {
        let all = self.structure.inputs().into_iter();
        let all = all.filter(|of| !of.path.contains("damping"));
        all.filter_map(|of| of.survey.as_deref()).collect()
    }

    /// The input at a path, `links[1].weight`.
    pub fn input(&self, path: &str) -> Option<&Quantity> {
        self.inputs().into_iter().find(|quantity| quantity.path == path)
    }
}
