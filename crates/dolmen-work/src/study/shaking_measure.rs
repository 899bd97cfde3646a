//! By what shaking is measured, and how capacities scatter by it.

use dolmen::assess::RockingScale;
use dolmen_words::number::trimmed;

/// A measure of the size of shaking. All grow in proportion with a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ShakingMeasure {
    /// Peak velocity of the ground, m/s.
    PeakVelocity,
    /// Pseudo-spectral acceleration of the component that the peak is of, m/s².
    Spectral {
        /// Its place among the periods of the study.
        index: usize,
        /// The period, s.
        period_s: f64,
    },
    /// Peak acceleration over that which lifts the part that lifts first, –.
    UpliftRatio,
    /// Peak velocity over that which blocks of the shape and size of that part overturn at, –.
    VelocityRatio,
}

impl ShakingMeasure {
    /// What it is called.
    pub fn words(self) -> String {
        match self {
            ShakingMeasure::PeakVelocity => "PGV".to_owned(),
            ShakingMeasure::Spectral { period_s, .. } => format!("S_a({} s)", trimmed(period_s, 3)),
            ShakingMeasure::UpliftRatio => "PGA/(g tan α)".to_owned(),
            ShakingMeasure::VelocityRatio => "p·PGV/(g tan α)".to_owned(),
        }
    }

    /// Its name in columns, without a unit.
    pub fn key(self) -> String {
        match self {
            ShakingMeasure::PeakVelocity => "pgv".to_owned(),
            ShakingMeasure::Spectral { period_s, .. } => format!("sa_{}_s", trimmed(period_s, 3)),
            ShakingMeasure::UpliftRatio => "uplift_ratio".to_owned(),
            ShakingMeasure::VelocityRatio => "velocity_ratio".to_owned(),
        }
    }

    /// The same with its unit.
    pub fn column(self) -> String {
        let unit = match self {
            ShakingMeasure::PeakVelocity => "_m_s",
            ShakingMeasure::Spectral { .. } => "_m_s2",
            ShakingMeasure::UpliftRatio | ShakingMeasure::VelocityRatio => "",
        };
        self.key() + unit
    }
}

/// What measures of a study's shaking rest on.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ShakingScales {
    /// S_a over the peak of the ground, a row a motion and direction, by the periods of the study; no rows where a motion is itself varied, or its samples
    /// are too far apart for a period.
    pub spectral_over_peak: Vec<Vec<f64>>,
    /// Of a stack, by combination, with its mean inputs: the part that lifts first.
    pub rocking: Vec<Option<RockingScale>>,
}

/// How one state's capacities scatter by the peak of the ground and by the other measures.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasureComparison {
    /// The state, 0 to 3.
    pub state: usize,
    /// Combinations that `within` is of.
    pub combinations: usize,
    /// β within a combination, the root of the mean of the squares: by peak acceleration first, then by each of [`StudyAnswer::measures`](super::StudyAnswer::measures); `None`
    /// where there is no curve.
    pub within: Vec<Option<f64>>,
    /// β of all combinations, one curve for all.
    pub together: Vec<Option<f64>>,
}
