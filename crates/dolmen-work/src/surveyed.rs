//! What was identified from one survey.

use crate::beside_file::BesideFile;
use crate::building::PlanAnswer;
use crate::model_modes::ModelModes;
use crate::record_seen::RecordSeen;
use crate::sensor_alarms::SensorFault;
use crate::stack::FactorsAnswer;
use dolmen::blocks::JointFactorsError;
use dolmen::modal::{
    JointSetups, MergedMode, MergedSetups, ModalAnalysis, Modes, Note, SensorDoubt, StrongMotion,
};
use dolmen::signal::ChannelFault;
use dolmen::structure::building::PlanStiffnessError;
use dolmen::structure::{Choice, ColumnsOfLevel, Convention, ShapeDoubt, StiffnessSolutions};
use dolmen_project::EarthquakePart;
use dolmen_words::message::Both;

/// Why no stiffness is sought.
#[derive(Clone, Debug, PartialEq)]
pub enum WithoutStiffness {
    /// No channel has both a position and a direction.
    NoPlace,
    /// Every mode that was measured in a direction twists.
    AllTwist {
        /// The direction.
        direction: String,
    },
    /// The file says that nothing but columns holds a frame in a direction: its stiffness is that of their beds.
    OnColumnsAlone {
        /// The direction.
        direction: String,
    },
    /// No sensor points within 15° of x or y.
    OffTheAxes {
        /// Names of those that have a position and a direction.
        channels: Vec<String>,
    },
    /// A building of more floors than one.
    Floors {
        /// How many.
        floors: usize,
    },
    /// The walls of a building's storey are turned from x and y, so that sway along one pushes along the other.
    WallsTurned,
    /// A survey of a building states no modes, and its record does not show how the floor moves.
    OnlyRecord,
    /// The shapes of the record are not those of a rigid floor.
    FloorNotRigid {
        /// Share of them that no rigid floor has.
        unexplained: f64,
    },
    /// Dampers stand on the floor: its modes are not those of the floor alone.
    Dampers {
        /// Their names.
        dampers: Vec<String>,
    },
    /// A side support of a stack pushes in one half of each swing alone: its modes are not those of springs.
    SideSupportOneWay {
        /// Its place among the side supports, from 1.
        number: usize,
        /// The stone that it holds.
        stone: String,
    },
    /// The modes of a building are refused.
    Plan(PlanStiffnessError),
    /// A survey of a stack states no modes, and its records show none along x or y.
    NoStackModes {
        /// Whether it has records.
        has_record: bool,
    },
    /// A survey of a stack states modes in directions that a stack does not sway along.
    OtherDirections {
        /// The directions.
        directions: Vec<String>,
    },
    /// The modes of a stack lead to no factors on its springs.
    Stack(Box<JointFactorsError>),
}

impl std::fmt::Display for WithoutStiffness {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            WithoutStiffness::NoPlace => write!(
                f,
                "no stiffness is sought: no channel has both a position and a direction; give both to those that stand on the structure"
            ),
            WithoutStiffness::AllTwist { direction } => write!(
                f,
                "no stiffness is sought in direction {direction}: every mode measured there twists; check their kind"
            ),
            WithoutStiffness::OnColumnsAlone { direction } => write!(
                f,
                "no stiffness is sought in direction {direction}: by the file nothing but columns holds it; write stiffness = \"unknown\" to seek one"
            ),
            WithoutStiffness::OffTheAxes { channels } => write!(
                f,
                "no stiffness is sought: no sensor points within 15° of x or y ({} do not); turn the axes of the project with the sensors, or give the \
                 direction in which each measures",
                channels.join(", ")
            ),
            WithoutStiffness::Floors { floors } => write!(
                f,
                "no stiffness is sought: the building has {floors} floors, and stiffness is found from modes for one floor on one storey only"
            ),
            WithoutStiffness::WallsTurned => write!(
                f,
                "no stiffness is sought: the walls of the storey are turned from x and y, so that it has more unknowns than k_x, k_y and k_θ; turn the axes of the plan with the walls"
            ),
            WithoutStiffness::OnlyRecord => write!(
                f,
                "no stiffness is sought: the survey states no modes, and its record does not show how the floor moves: that takes three horizontal sensors or more at \
                 the height of the floor, with position and direction, not all on one line; or write the modes with frequency, twist and sideways"
            ),
            WithoutStiffness::FloorNotRigid { unexplained } => write!(
                f,
                "no stiffness is sought: {:.0} % of the mode shapes of the record is no motion of a rigid floor; check positions, directions, cables and units of \
                 the sensors",
                100.0 * unexplained
            ),
            WithoutStiffness::Dampers { dampers } => write!(
                f,
                "no stiffness is sought: the file puts dampers on the floor ({}), and modes measured with them are not those of the floor alone; survey with \
                 the dampers blocked, and write them into a [variant]",
                dampers.join(", ")
            ),
            WithoutStiffness::SideSupportOneWay { number, stone } => write!(
                f,
                "no factors on the springs of the joints are sought: side support {number} of '{stone}' has no gap, is not pressed at rest, and none as stiff is \
                 opposite it, so that it pushes in one half of each swing alone; give the gap that it has, or the support opposite it"
            ),
            WithoutStiffness::Plan(why) => write!(f, "no stiffness is sought: {why}"),
            WithoutStiffness::NoStackModes { has_record: false } => write!(
                f,
                "no factors on the springs of the joints are sought: the survey states no frequencies or modes along x, y or of torsion, and has no records"
            ),
            WithoutStiffness::NoStackModes { has_record: true } => write!(
                f,
                "no factors on the springs of the joints are sought: the records show no mode along x or y; give position and direction of the channels, or \
                 write the modes into the survey"
            ),
            WithoutStiffness::OtherDirections { directions } => write!(
                f,
                "no factors on the springs of the joints are sought: a stack sways along x and y and twists (torsion), but the survey states modes in direction {}",
                directions.join(", ")
            ),
            WithoutStiffness::Stack(why) => {
                write!(f, "no factors on the springs of the joints are found: {why}")
            }
        }
    }
}

/// What was identified from one survey.
#[derive(Clone, Debug)]
pub struct SurveyAnswer {
    /// The survey's name.
    pub name: String,
    /// Modes from its records; `None` if it has none.
    pub records: Option<RecordAnswer>,
    /// Its setups, one by one and put together; `None` if it has none.
    pub setups: Option<SetupsAnswer>,
    /// The modes of its records beside those of the model, of a stack or building.
    pub model: Option<ModelModes>,
    /// What the shapes of its records say against the chain or frame.
    pub shape_doubt: Option<ShapeDoubt>,
    /// Whether the columns of each level of a frame move as one in its modes, by direction.
    pub columns: Vec<SurveyColumns>,
    /// Two directions whose stiffness is each that of the other in the file.
    pub exchanged_directions: Option<[String; 2]>,
    /// Stiffness from its modes, one entry a direction and convention.
    pub stiffness: Vec<StiffnessAnswer>,
    /// Stiffness in plan from its modes, of a building with one floor.
    pub plan: Option<Box<PlanAnswer>>,
    /// Factors on the springs of the joints from its modes, of a stack.
    pub factors: Option<Box<FactorsAnswer>>,
    /// Why its modes lead to no stiffness, where they do not.
    pub without_stiffness: Option<WithoutStiffness>,
}

/// The columns of a frame in the modes along one direction.
#[derive(Clone, Debug, PartialEq)]
pub struct SurveyColumns {
    /// "x" or "y".
    pub direction: &'static str,
    /// Each level with several sensors, mode by mode.
    pub levels: Vec<ColumnsOfLevel>,
}

/// What several setups gave.
#[derive(Clone, Debug)]
pub struct SetupsAnswer {
    /// Each by itself.
    pub records: Vec<RecordAnswer>,
    /// Put together after each was identified.
    pub merged: MergedSetups,
    /// Identified as one, where the file asks for that: then these are the modes of the survey.
    pub joint: Option<JointSetups>,
}

/// Shapes of one mode at its references are rarely less alike; chosen here.
pub const REFERENCES_ALIKE: f64 = 0.9;

impl SetupsAnswer {
    /// Frequencies, Hz, at which setups put together may not show one mode: another pairing was nearly as good, or the shapes at the
    /// references are not alike. All where a reference is not the same in all setups; else none where they were identified as one.
    pub fn doubtful_hz(&self) -> Vec<f64> {
        if !self.merged.reference_faults.is_empty() {
            return self.modes().modes.iter().map(|mode| mode.frequency_hz).collect();
        }
        if self.joint.is_some() {
            return Vec::new();
        }
        let unlike = |m: &MergedMode| {
            m.reference_assurance
                .iter()
                .flatten()
                .any(|mac| *mac < REFERENCES_ALIKE)
        };
        let both = self.merged.modes.modes.iter().zip(&self.merged.merged);
        both.filter(|(_, of)| of.doubtful || unlike(of))
            .map(|(mode, _)| mode.frequency_hz)
            .collect()
    }

    /// The modes of all setups.
    pub fn modes(&self) -> &Modes {
        self.joint
            .as_ref()
            .map_or(&self.merged.modes, |joint| &joint.modes)
    }
}

impl SurveyAnswer {
    /// Peaks of its record that are none of its modes, and modes that were not picked, Hz, ascending. Empty of several setups.
    pub fn unexplained_hz(&self) -> Vec<f64> {
        let notes = self.records.iter().flat_map(|record| &record.analysis.notes);
        let mut all: Vec<f64> = notes
            .flat_map(|note| match note {
                Note::PeaksWithoutMode { peaks } => peaks.iter().map(|peak| peak.frequency_hz).collect(),
                Note::NotPicked { frequency_hz } => frequency_hz.clone(),
                _ => Vec::new(),
            })
            .collect();
        all.sort_by(f64::total_cmp);
        all
    }

    /// The earthquake that its records hold: of several the strongest over its noise.
    pub fn earthquake(&self) -> Option<&Earthquake> {
        let setups = self.setups.iter().flat_map(|setups| &setups.records);
        let all = self.records.iter().chain(setups);
        let over = |of: &&Earthquake| of.found.strongest().shaking.over_noise;
        let found = all.filter_map(|record| record.earthquake.as_ref());
        found.max_by(|a, b| over(a).total_cmp(&over(b)))
    }

    /// Whether its modes are those of a structure in an earthquake, which no ambient survey can be compared with.
    pub fn is_shaken(&self) -> bool {
        self.earthquake().is_some_and(Earthquake::is_shaken)
    }

    /// What is wrong with the channels of its records.
    pub fn faults(&self) -> Vec<(String, SensorFault)> {
        let setups = self.setups.iter().flat_map(|setups| &setups.records);
        let records = self.records.iter().chain(setups);
        let faults = records.flat_map(|record| &record.faults);
        faults.map(SensorFault::of).collect()
    }

    /// The modes that its records show, of several setups those put together, and the equally strong blocks of time behind their deviations.
    pub fn modes(&self) -> Option<(&Modes, usize)> {
        match (&self.setups, &self.records) {
            (Some(setups), _) => {
                let blocks = setups
                    .records
                    .iter()
                    .map(|r| r.analysis.settings.time_blocks_effective);
                Some((setups.modes(), blocks.min().unwrap_or(0)))
            }
            (None, Some(record)) => Some((
                &record.analysis.modes,
                record.analysis.settings.time_blocks_effective,
            )),
            (None, None) => None,
        }
    }
}

/// Of which part of a record that holds an earthquake its modes are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModesOf {
    /// Of what followed the last one.
    After,
    /// Of what came between two of them, since what followed is too short.
    Between,
    /// Of what came before, since what followed is too short.
    Before,
    /// Of its strong phase, above the ground as it moved.
    During,
    /// Of all of the record, since every part of it is too short.
    Whole,
}

/// An earthquake in a record, and of which part its modes are.
#[derive(Clone, Debug)]
pub struct Earthquake {
    /// What was found.
    pub found: StrongMotion,
    /// Of which part the modes of the record are.
    pub modes_of: ModesOf,
}

impl Earthquake {
    /// Whether it was one beyond doubt, or left a change beyond chance, whatever it was: else it may have been traffic, and the record shows the structure at
    /// rest but for that.
    pub fn is_one(&self) -> bool {
        self.found.is_sure() || self.found.lasting().is_some()
    }

    /// Whether the modes are those of the structure in it, which no ambient survey can be compared with.
    pub fn is_shaken(&self) -> bool {
        matches!(self.modes_of, ModesOf::During | ModesOf::Whole)
    }

    /// As a survey states it: the largest acceleration, and the change of the lowest mode that changed beyond chance, else of the lowest.
    pub fn part(&self) -> EarthquakePart {
        let largest = self.found.largest();
        let peak = largest.strongest().and_then(|of| of.peak_acceleration_m_s2);
        let change = self.found.lasting().or(self.found.shown().first());
        EarthquakePart {
            peak_m_s2: peak,
            is_at_least: peak.is_some() && largest.is_at_least(),
            changed: change.map(|of| of.ratio),
            changed_sd: change.and_then(|of| of.ratio_sd),
        }
    }
}

/// What a record gave.
#[derive(Clone, Debug)]
pub struct RecordAnswer {
    /// Path of the record file as the project names it.
    pub file: String,
    /// Channels read, before any was left out.
    pub channels: usize,
    /// Samples a channel, as read.
    pub samples: usize,
    /// Sampling rate, as read, Hz.
    pub sampling_rate_hz: f64,
    /// Unit of the numbers; "" if not known.
    pub unit: String,
    /// What its files say beside the samples, sentences.
    pub remarks: Vec<Both>,
    /// Columns that look like times and cannot be read, so that nothing confirms the sampling rate given.
    pub unread_stamps: Vec<String>,
    /// What looked wrong with channels.
    pub faults: Vec<ChannelFault>,
    /// What its sensors say against each other.
    pub doubts: Vec<SensorDoubt>,
    /// Spectrum, stabilisation and modes; of a record that holds an earthquake those of the part that `earthquake` says.
    pub analysis: ModalAnalysis,
    /// The earthquake that it holds.
    pub earthquake: Option<Earthquake>,
    /// Its channels over time, and a spectrogram.
    pub seen: RecordSeen,
}

/// Stiffness from modes, in one direction and convention.
#[derive(Clone, Debug)]
pub struct StiffnessAnswer {
    /// "x", "weak".
    pub direction: String,
    /// What the springs of a frame act on; `None` for a chain.
    pub convention: Option<Convention>,
    /// Frequencies that went in, Hz.
    pub frequencies_hz: Vec<f64>,
    /// Whether any of them carried a measured shape.
    pub with_shapes: bool,
    /// Every solution.
    pub solutions: StiffnessSolutions,
    /// Load factor λ with each solution, in the same order.
    pub load_factors: Vec<Option<f64>>,
    /// Peaks of the record below the highest mode used that are none of the modes, Hz: one of them may be a mode of this direction, and every
    /// stiffness then is wrong.
    pub peaks_below_hz: Vec<f64>,
    /// Why no solution is chosen whatever explains the modes; `None` if nothing is doubted.
    pub doubted: Option<StiffnessDoubt>,
    /// The one solution beside the stiffness of the file.
    pub beside_file: Option<BesideFile>,
}

/// Why stiffness from a record is doubted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StiffnessDoubt {
    /// A slip of the sensors explains the shapes.
    Sensors,
    /// The shapes of the direction contradict the model.
    Shapes {
        /// Share of them that the model does not have.
        unexplained: f64,
    },
}

impl StiffnessAnswer {
    /// Whether one solution explains the modes and nothing doubts it: a peak below the modes that is none of them may be the first one, and
    /// every stiffness then is wrong.
    pub fn is_chosen(&self) -> bool {
        self.solutions.choice == Choice::One && self.is_undoubted()
    }

    /// Whether nothing doubts the modes.
    pub fn is_undoubted(&self) -> bool {
        self.peaks_below_hz.is_empty() && self.doubted.is_none()
    }
}
