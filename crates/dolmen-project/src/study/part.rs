//! A study of a project file: `[study.NAME]`.

use crate::names::Names;
use crate::site::MotionSize;
use dolmen::assess::{DamageThresholds, Direction};
use std::ops::Range;

/// A value laid over the file for a run, with the place of the study that writes it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Override {
    /// What it changes: `pagoda.storeys`, `links[2].weight`.
    pub path: String,
    /// The value as it would stand in the file.
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

/// How the shaking grows.
#[derive(Clone, Debug, PartialEq)]
pub enum Scan {
    /// By these factors on the motion as the file has it, –.
    Scales(Vec<f64>),
    /// To these largest horizontal peaks, m/s².
    Peaks(Vec<f64>),
}

impl Scan {
    /// How many steps it has.
    pub fn steps(&self) -> usize {
        match self {
            Scan::Scales(values) | Scan::Peaks(values) => values.len(),
        }
    }
}

/// A motion that acts before each run.
#[derive(Clone, Debug, PartialEq)]
pub struct AfterPart {
    /// Its name: of the file, or carried by the program.
    pub motion: String,
    /// Its sizes, rising, 0 for the structure that was not shaken before; `None`: as the file has it.
    pub sizes: Option<Scan>,
    /// Which of the varied inputs its size is, where there is more than one.
    pub axis: Option<usize>,
}

/// Motions made for a study: seeded noise of firm ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArtificialPart {
    /// How many.
    pub count: usize,
    /// Seed of the first; the next has the next one.
    pub seed: u64,
    /// Length, s.
    pub duration_s: f64,
    /// Time until it is strong, s.
    pub rise_s: f64,
    /// Time that it is strong, s.
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

/// What a study expects to see, to be held or contradicted.
#[derive(Clone, Debug, PartialEq)]
pub struct ExpectedTrend {
    /// The path of a varied input.
    pub input: String,
    /// Which way the capacity goes as it grows.
    pub direction: Direction,
    /// What that means, in words.
    pub words: Option<Names>,
    /// Who says so.
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

/// A study of a project file, checked but for the values that its inputs take: those are read with each run.
#[derive(Clone, Debug, PartialEq)]
pub struct StudyPart {
    /// The table's name.
    pub name: String,
    /// A longer name, if given.
    pub title: Option<Names>,
    /// What every run changes of the file.
    pub set: Vec<Override>,
    /// What is varied, in the order of the file: every value with every other.
    pub vary: Vec<Axis>,
    /// Variants of the file to take in turn; the file as it is if the list is empty.
    pub variants: Vec<String>,
    /// How often uncertain inputs are drawn; `None`: each is its mean.
    pub samples: Option<usize>,
    /// Seed of the samples.
    pub seed: u64,
    /// Names of motions: of the file, or carried by the program.
    pub motions: Vec<String>,
    /// Motions made for the study.
    pub artificial: Option<ArtificialPart>,
    /// Turns of the motion from x towards y, rad; one, 0, if none is given.
    pub turns_rad: Vec<f64>,
    /// Of a frame: the direction that is shaken.
    pub direction: Option<String>,
    /// How the shaking grows; `None` only for a frame or chain that is mapped or released.
    pub scan: Option<Scan>,
    /// What acts before each run.
    pub after: Option<AfterPart>,
    /// How often the bracket of the first fall is halved.
    pub refine: u32,
    /// Contact law of a stack.
    pub law: LawPart,
    /// Contact points of a joint of a stack: 4, 9, 16 or 36.
    pub points: u32,
    /// Time after the motion, s; `None`: 2 for a stack, 20 for a frame.
    pub rest_s: Option<f64>,
    /// Periods of the spectral accelerations that capacities are fitted over beside the peak of the ground, s, rising.
    pub spectral_periods_s: Vec<f64>,
    /// Their damping ratio, –.
    pub spectral_damping_ratio: f64,
    /// Where damage states of a stack begin.
    pub damage: DamageThresholds,
    /// Drifts of a building, over the height of the storey, where its states begin; rising.
    pub drift_limits: [f64; 4],
    /// What it expects to see.
    pub expect: Vec<ExpectedTrend>,
    /// Of a frame or a chain: a map of sticking and slipping.
    pub harmonic: Option<HarmonicPart>,
    /// Of a frame: the displacement of its top from which it is let go, m.
    pub release_m: Option<f64>,
}

impl StudyPart {
    /// How many combinations of variants and varied values there are.
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

    /// Which value of an axis a combination has.
    fn value_of(&self, axis: usize, combination: usize) -> usize {
        let faster = self.vary.iter().skip(axis + 1);
        let faster: usize = faster.map(|axis| axis.values.len()).product();
        combination / faster.max(1) % self.vary.get(axis).map_or(1, |axis| axis.values.len())
    }

    /// The size of the motion that acts before the runs of a combination; `None`: as the file has it, or there is none.
    pub fn size_before(&self, combination: usize) -> Option<MotionSize> {
        let after = self.after.as_ref()?;
        let at = after.axis.map_or(0, |axis| self.value_of(axis, combination));
        match after.sizes.as_ref()? {
            Scan::Scales(values) => values.get(at).copied().map(MotionSize::Scale),
            Scan::Peaks(values) => values.get(at).copied().map(MotionSize::Peak),
        }
    }

    /// The values of a combination that are laid over the file: all but the size of the motion that acts before.
    pub fn laid_over(&self, combination: usize) -> Vec<&Override> {
        let (_, values) = self.combination(combination);
        let before = self.after.as_ref().and_then(|after| after.axis);
        let each = values.into_iter().enumerate();
        let each = each.filter(|(axis, _)| Some(*axis) != before);
        self.set.iter().chain(each.map(|(_, value)| value)).collect()
    }
}
