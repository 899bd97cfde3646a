//! Results of one survey.

use crate::beside_file::BesideFile;
use crate::building::PlanAnswer;
use crate::model_modes::ModelModes;
use crate::record_seen::RecordSeen;
use crate::sensor_alarms::SensorFault;
use crate::stack::FactorsAnswer;
use crate::station_clocks::ClockDoubt;
use dolmen::blocks::JointFactorsError;
use dolmen::modal::{
    JointSetups, MergedMode, MergedSetups, ModalAnalysis, Modes, Note, SensorDoubt, StrongMotion,
};
use dolmen::signal::ChannelFault;
use dolmen::structure::building::PlanStiffnessError;
use dolmen::structure::{Choice, ColumnsOfLevel, Convention, ShapeDoubt, StiffnessSolutions};
use dolmen_project::{EarthquakePart, StiffnessFit};
use dolmen_words::message::Both;

/// Why no stiffness is computed.
#[derive(Clone, Debug, PartialEq)]
pub enum WithoutStiffness {
    /// No channel has both a position and a direction.
    NoPlace,
    /// Every measured mode in a direction is torsional.
    AllTwist {
        /// The direction.
        direction: String,
    },
    /// The file states that only columns hold a frame in a direction: its stiffness is that of their beds.
    OnColumnsAlone {
        /// The direction.
        direction: String,
    },
    /// No sensor is within 15° of x or y.
    OffTheAxes {
        /// Names of those that have a position and a direction.
        channels: Vec<String>,
    },
    /// A building of more floors than one.
    Floors {
        /// Number of floors.
        floors: usize,
    },
    /// The walls of a building's storey are not along x and y, so that sway along one axis pushes along the other.
    WallsTurned,
    /// A survey of a building states no modes, and its record does not determine the motion of the floor.
    OnlyRecord,
    /// The shapes of the record are not those of a rigid floor.
    FloorNotRigid {
        /// Share of the shapes that is not the motion of a rigid floor.
        unexplained: f64,
    },
    /// Dampers stand on the floor: its modes are not those of the floor alone.
    Dampers {
        /// Their names.
        dampers: Vec<String>,
    },
    /// A side support of a stack acts in only one half of each cycle: the modes are not those of springs.
    SideSupportOneWay {
        /// Its index among the side supports, from 1.
        number: usize,
        /// The supported stone.
        stone: String,
    },
    /// The modes of a building are refused.
    Plan(PlanStiffnessError),
    /// A survey of a stack states no modes, and its records show none along x or y.
    NoStackModes {
        /// Whether it has records.
        has_record: bool,
    },
    /// A survey of a stack states modes in directions without sway of a stack.
    OtherDirections {
        /// The directions.
        directions: Vec<String>,
    },
    /// The modes of a stack give no factors on its springs.
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
                "no stiffness is sought in direction {direction}: in the file only columns carry it; write stiffness = \"unknown\" to seek one"
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

/// Results of one survey.
#[derive(Clone, Debug)]
pub struct SurveyAnswer {
    /// The survey's name.
    pub name: String,
    /// Modes from its records; `None` if it has none.
    pub records: Option<RecordAnswer>,
    /// Its setups, one by one and joined; `None` if it has none.
    pub setups: Option<SetupsAnswer>,
    /// The modes of its records paired with those of the model, for a stack or building.
    pub model: Option<ModelModes>,
    /// Contradictions between the shapes of its records and the chain or frame.
    pub shape_doubt: Option<ShapeDoubt>,
    /// Whether the columns of each level of a frame move as one in its modes, by direction.
    pub columns: Vec<SurveyColumns>,
    /// Two directions whose stiffnesses appear exchanged in the file.
    pub exchanged_directions: Option<[String; 2]>,
    /// Stiffness from its modes, one entry for each direction and convention.
    pub stiffness: Vec<StiffnessAnswer>,
    /// Stiffness in plan from its modes, for a building with one floor.
    pub plan: Option<Box<PlanAnswer>>,
    /// Factors on the springs of the joints from its modes, for a stack.
    pub factors: Option<Box<FactorsAnswer>>,
    /// Why its modes give no stiffness, if they give none.
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

/// Results of several setups.
#[derive(Clone, Debug)]
pub struct SetupsAnswer {
    /// Each record separately.
    pub records: Vec<RecordAnswer>,
    /// Joined after each was identified.
    pub merged: MergedSetups,
    /// Identified as one, if the file requests it; these are then the modes of the survey.
    pub joint: Option<JointSetups>,
}

/// MAC of the shapes of one mode at its references that is rarely undercut. Our choice.
pub const REFERENCES_ALIKE: f64 = 0.9;

impl SetupsAnswer {
    /// Frequencies, Hz, at which joined setups may not show the same mode: another pairing was nearly as good, or the shapes at the references
    /// differ. All of them where a reference differs between setups; otherwise none where the setups were identified as one.
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
    /// Peaks of its record that are not among its modes, and modes that were not picked, Hz, ascending. Empty for several setups.
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

    /// The earthquake in its records; if there are several, the strongest relative to its noise.
    pub fn earthquake(&self) -> Option<&Earthquake> {
        let setups = self.setups.iter().flat_map(|setups| &setups.records);
        let all = self.records.iter().chain(setups);
        let over = |of: &&Earthquake| of.found.strongest().shaking.over_noise;
        let found = all.filter_map(|record| record.earthquake.as_ref());
        found.max_by(|a, b| over(a).total_cmp(&over(b)))
    }

    /// Whether its modes are those of a structure during an earthquake, which cannot be compared with an ambient survey.
    pub fn is_shaken(&self) -> bool {
        self.earthquake().is_some_and(Earthquake::is_shaken)
    }

    /// Faults of the channels of its records.
    pub fn faults(&self) -> Vec<(String, SensorFault)> {
        let setups = self.setups.iter().flat_map(|setups| &setups.records);
        let records = self.records.iter().chain(setups);
        let faults = records.flat_map(|record| &record.faults);
        faults.map(SensorFault::of).collect()
    }

    /// The modes of its records, for several setups those of all joined, and the number of equally strong blocks of time behind their
    /// deviations.
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

/// The part of a record with an earthquake from which its modes come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModesOf {
    /// The part after the last one.
    After,
    /// The part between two of them, because the part after the last is too short.
    Between,
    /// The part before, because the part after is too short.
    Before,
    /// The strong phase, relative to the measured ground.
    During,
    /// The whole record, because every part of it is too short.
    Whole,
}

/// An earthquake in a record, and the part from which its modes come.
#[derive(Clone, Debug)]
pub struct Earthquake {
    /// The earthquake.
    pub found: StrongMotion,
    /// The part of the modes.
    pub modes_of: ModesOf,
}

impl Earthquake {
    /// Whether it was certainly an earthquake, or any event that left a significant change. Otherwise it may have been traffic, and the record
    /// describes the structure at rest.
    pub fn is_one(&self) -> bool {
        self.found.is_sure() || self.found.lasting().is_some()
    }

    /// Whether the modes are those of the structure during it, which cannot be compared with an ambient survey.
    pub fn is_shaken(&self) -> bool {
        matches!(self.modes_of, ModesOf::During | ModesOf::Whole)
    }

    /// In the form of a survey: the largest acceleration, and the change of the lowest mode with a significant change, otherwise of the lowest. A change
    /// that is not significant is left out if its deviations alone would make a reader take it as such.
    pub fn part(&self) -> EarthquakePart {
        let largest = self.found.largest();
        let peak = largest.strongest().and_then(|of| of.peak_acceleration_m_s2);
        let change = self.found.lasting().or_else(|| {
            let lowest = self.found.shown().first();
            lowest.filter(|of| !of.is_beyond_deviations())
        });
        EarthquakePart {
            peak_m_s2: peak,
            is_at_least: peak.is_some() && largest.is_at_least(),
            changed: change.map(|of| of.ratio),
            changed_sd: change.and_then(|of| of.ratio_sd),
        }
    }
}

/// Results of a record.
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
    /// Other notes in its files, as sentences.
    pub remarks: Vec<Both>,
    /// Columns that look like times but cannot be read, so that nothing confirms the given sampling rate.
    pub unread_stamps: Vec<String>,
    /// Files whose dates contradict the starts that the project file gives.
    pub clock_doubts: Vec<ClockDoubt>,
    /// Suspected faults of channels.
    pub faults: Vec<ChannelFault>,
    /// Contradictions between its sensors.
    pub doubts: Vec<SensorDoubt>,
    /// Spectrum, stabilisation and modes; for a record with an earthquake those of the part in `earthquake`.
    pub analysis: ModalAnalysis,
    /// The earthquake in it.
    pub earthquake: Option<Earthquake>,
    /// Its channels over time, and a spectrogram.
    pub seen: RecordSeen,
}

/// Stiffness from modes, in one direction and convention.
#[derive(Clone, Debug)]
pub struct StiffnessAnswer {
    /// "x", "weak".
    pub direction: String,
    /// The quantity that the springs of a frame act on; `None` for a chain.
    pub convention: Option<Convention>,
    /// The frequencies used, Hz.
    pub frequencies_hz: Vec<f64>,
    /// Whether any of them had a measured shape.
    pub with_shapes: bool,
    /// Every solution.
    pub solutions: StiffnessSolutions,
    /// Load factor λ with each solution, in the same order.
    pub load_factors: Vec<Option<f64>>,
    /// Peaks of the record below the highest mode in use that are not among the modes, Hz. If one of them is a mode of this direction,
    /// every stiffness is wrong.
    pub peaks_below_hz: Vec<f64>,
    /// Why no solution is chosen although some explain the modes; `None` without doubt.
    pub doubted: Option<StiffnessDoubt>,
    /// Stiffness from other choices among the measured modes, where there are more of them along the direction than the model has.
    pub other_choices: Vec<OtherChoice>,
    /// The only solution compared with the stiffness of the file.
    pub beside_file: Option<BesideFile>,
}

/// Stiffness from another choice of the modes along a direction.
#[derive(Clone, Debug, PartialEq)]
pub struct OtherChoice {
    /// Frequencies of these modes, Hz.
    pub frequencies_hz: Vec<f64>,
    /// The stiffness, lowest first.
    pub stiffness: Vec<f64>,
    /// Its standard deviation.
    pub stiffness_sd: Option<Vec<f64>>,
}

/// Why stiffness from a record is doubted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StiffnessDoubt {
    /// A mistake about the sensors explains the shapes.
    Sensors,
    /// The shapes of the direction contradict the model.
    Shapes {
        /// Share of the shapes that the model does not reproduce.
        unexplained: f64,
    },
    /// More modes move along the direction than the model has, and other choices among them give another stiffness.
    MoreModes,
    /// A machine runs at the frequency of one of the modes.
    Machine {
        /// Frequency of the mode, Hz.
        mode_hz: f64,
    },
}

impl StiffnessAnswer {
    /// Whether exactly one solution explains the modes without doubt: a peak below the modes that is not among them may be the first one, and
    /// then every stiffness is wrong.
    pub fn is_chosen(&self) -> bool {
        self.solutions.choice == Choice::One && self.is_undoubted()
    }

    /// Whether there is one solution, and it [fits by construction](StiffnessFit::is_by_construction).
    pub fn fits_by_construction(&self) -> bool {
        self.solutions.choice == Choice::One && self.is_unchecked()
    }

    /// Whether nothing checks its solutions, one or several.
    pub fn is_unchecked(&self) -> bool {
        self.solutions.solutions.first().is_some_and(|one| {
            let fit = StiffnessFit {
                frequencies: self.frequencies_hz.len(),
                with_shapes: self.with_shapes,
                unknowns: one.stiffness.len(),
            };
            fit.is_by_construction()
        })
    }

    /// Whether there is no doubt about the modes.
    pub fn is_undoubted(&self) -> bool {
        self.peaks_below_hz.is_empty() && self.doubted.is_none()
    }
}
