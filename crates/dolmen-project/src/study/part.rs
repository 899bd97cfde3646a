//! A study of a project file: `[study.NAME]`.

use crate::names::Names;
use crate::site::MotionSize;
use dolmen::assess::{DamageThresholds, Direction};
use std::ops::Range;

/// A value that replaces one of the file for a run, with the place of the study that gives it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Override {
    /// The path of the replaced value: `pagoda.storeys`, `links[2].weight`.
    pub path: String,
    /// The value in the syntax of the file.
    pub text: String,
    pub(crate) span: Range<usize>,
}

/// One input that a study varies.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Axis {
    /// Its path.
    pub path: String,
    /// Its values in the order of the file.
    pub values: Vec<Override>,
}

/// The levels of shaking.
#[derive(Clone, Debug, PartialEq)]
pub enum Scan {
    /// Factors on the motion of the file, –.
    Scales(Vec<f64>),
    /// Largest horizontal peaks, m/s².
    Peaks(Vec<f64>),
}

impl Scan {
    /// Number of levels.
    pub fn steps(&self) -> usize {
        match self {
            Scan::Scales(values) | Scan::Peaks(values) => values.len(),
        }
    }
}

/// A motion that acts before each run.
#[derive(Clone, Debug, PartialEq)]
pub struct AfterPart {
    /// Its name: of the file, or built in.
    pub motion: String,
    /// Its sizes, rising, 0 for a structure without an earlier motion; `None`: that of the file.
    pub sizes: Option<Scan>,
    /// The index of its size among the varied inputs, where there is more than one.
    pub axis: Option<usize>,
}

/// Motions made for a study: seeded noise of firm ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArtificialPart {
    /// Their number.
    pub count: usize,
    /// Seed of the first; each further motion has the next seed.
    pub seed: u64,
    /// Length, s.
    pub duration_s: f64,
    /// Rise time, s.
    pub rise_s: f64,
    /// Duration of the strong part, s.
    pub strong_s: f64,
}

/// The contact law of a stack.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LawPart {
    /// Springs between the stones.
    Springs,
    /// Stones that touch rigidly.
    Rigid,
}

/// A trend that a study expects; the result confirms or contradicts it.
#[derive(Clone, Debug, PartialEq)]
pub struct ExpectedTrend {
    /// The path of a varied input.
    pub input: String,
    /// Direction of the capacity as the input grows.
    pub direction: Direction,
    /// Its meaning, in words.
    pub words: Option<Names>,
    /// Its source.
    pub source: Option<String>,
}

/// A map of the steady response of a frame to harmonic motions of the ground.
#[derive(Clone, Debug, PartialEq)]
pub struct HarmonicPart {
    /// Frequencies, Hz.
    pub frequencies_hz: Vec<f64>,
    /// Amplitudes of the ground's acceleration, m/s².
    pub accelerations_m_s2: Vec<f64>,
}

/// Drifts where the states of a building begin if its file names none: FEMA 356 (2000), table C1-3, of concrete walls .5, 1 and 2 %, of
/// concrete frames 1, 2 and 4 % for immediate occupancy, life safety and collapse prevention.
pub const DRIFT_LIMITS: [f64; 4] = [0.005, 0.01, 0.02, 0.04];

/// A study of a project file, checked except for the values of its inputs, which are read with each run.
#[derive(Clone, Debug, PartialEq)]
pub struct StudyPart {
    /// The table's name.
    pub name: String,
    /// A longer name, if given.
    pub title: Option<Names>,
    /// Values that every run replaces in the file.
    pub set: Vec<Override>,
    /// The varied inputs, in the order of the file: every value is combined with every other.
    pub vary: Vec<Axis>,
    /// Variants of the file to run one after the other; the file itself if the list is empty.
    pub variants: Vec<String>,
    /// Number of samples of uncertain inputs; `None`: the mean of each.
    pub samples: Option<usize>,
    /// Seed of the samples.
    pub seed: u64,
    /// Names of motions: of the file, or built in.
    pub motions: Vec<String>,
    /// Motions made for the study.
    pub artificial: Option<ArtificialPart>,
    /// Rotations of the motion from x towards y, rad; 0 alone if the file gives none.
    pub turns_rad: Vec<f64>,
    /// Of a frame: the shaken direction.
    pub direction: Option<String>,
    /// The levels of shaking; `None` only for a frame or chain that is mapped or released.
    pub scan: Option<Scan>,
    /// The motion before each run.
    pub after: Option<AfterPart>,
    /// Number of bisections for the first fall.
    pub refine: u32,
    /// Contact law of a stack.
    pub law: LawPart,
    /// Contact points of a joint of a stack: 4, 9, 16 or 36.
    pub points: u32,
    /// Time after the motion, s; `None`: 2 for a stack, 20 for a frame.
    pub rest_s: Option<f64>,
    /// Periods of the spectral accelerations for which fragility is fitted, besides that for the peak of the ground, s, rising.
    pub spectral_periods_s: Vec<f64>,
    /// Their damping ratio, –.
    pub spectral_damping_ratio: f64,
    /// Thresholds of the damage states of a stack.
    pub damage: DamageThresholds,
    /// Thresholds of the damage states of a building, drift over the height of the storey; rising.
    pub drift_limits: [f64; 4],
    /// Expected trends.
    pub expect: Vec<ExpectedTrend>,
    /// Of a frame or a chain: a map of sticking and slipping.
    pub harmonic: Option<HarmonicPart>,
    /// Of a frame: the displacement of its top before the release, m.
    pub release_m: Option<f64>,
}

impl StudyPart {
    /// Number of combinations of variants and varied values.
    pub fn combinations(&self) -> usize {
        let axes: usize = self.vary.iter().map(|axis| axis.values.len()).product();
        axes * self.variants.len().max(1)
    }

    /// The variant and the values of a combination, the last input changing fastest; its index counts from 0.
    pub fn combination(&self, index: usize) -> (Option<&str>, Vec<&Override>) {
        let mut rest = index;
        let mut values: Vec<&Override> = Vec::with_capacity(self.vary.len());
        for axis in self.vary.iter().rev() {
            values.extend(axis.values.get(rest % axis.values.len()));
            rest /= axis.values.len();
        }
        values.reverse();
        let variant = self.variants.get(rest).map(String::as_str);
        (variant, values)
    }

    /// Index of the value of an axis in a combination.
    fn value_of(&self, axis: usize, combination: usize) -> usize {
        let faster = self.vary.iter().skip(axis + 1);
        let faster: usize = faster.map(|axis| axis.values.len()).product();
        combination / faster.max(1) % self.vary.get(axis).map_or(1, |axis| axis.values.len())
    }

    /// The size of the motion before the runs of a combination; `None`: that of the file, or there is no such motion.
    pub fn size_before(&self, combination: usize) -> Option<MotionSize> {
        let after = self.after.as_ref()?;
        let at = after.axis.map_or(0, |axis| self.value_of(axis, combination));
        match after.sizes.as_ref()? {
            Scan::Scales(values) => values.get(at).copied().map(MotionSize::Scale),
            Scan::Peaks(values) => values.get(at).copied().map(MotionSize::Peak),
        }
    }

    /// The values of a combination that replace values of the file: all except the size of the motion before the run.
    pub fn laid_over(&self, combination: usize) -> Vec<&Override> {
        let (_, values) = self.combination(combination);
        let before = self.after.as_ref().and_then(|after| after.axis);
        let each = values.into_iter().enumerate();
        let each = each.filter(|(axis, _)| Some(*axis) != before);
        self.set.iter().chain(each.map(|(_, value)| value)).collect()
    }
}
