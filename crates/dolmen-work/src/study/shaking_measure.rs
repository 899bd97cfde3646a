//! Measures of shaking, and the scatter of capacities by each.

use dolmen::assess::RockingScale;
use dolmen_words::number::trimmed;

/// A measure of shaking. All are proportional to the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ShakingMeasure {
    /// Peak velocity of the ground, m/s.
    PeakVelocity,
    /// Pseudo-spectral acceleration of the component with the peak, m/s².
    Spectral {
        /// Its index among the periods of the study.
        index: usize,
        /// The period, s.
        period_s: f64,
    },
    /// Peak acceleration relative to that at which the first part lifts, –.
    UpliftRatio,
    /// Peak velocity relative to that which overturns blocks with the shape and size of that part, –.
    VelocityRatio,
}

impl ShakingMeasure {
    /// Its name.
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

/// Data for measures of a study's shaking.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ShakingScales {
    /// S_a relative to the peak ground acceleration, one row for each motion and direction, by the periods of the study; empty if motions
    /// are varied, or if samples are too coarse for a period.
    pub spectral_over_peak: Vec<Vec<f64>>,
    /// For a stack, by combination, with its mean inputs: the part that lifts first.
    pub rocking: Vec<Option<RockingScale>>,
}

/// Scatter of one state's capacities by the peak of the ground and by the other measures.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasureComparison {
    /// The state, 0 to 3.
    pub state: usize,
    /// Number of combinations in `within`.
    pub combinations: usize,
    /// β within a combination, root mean square: by peak acceleration first, then by each of
    /// [`StudyAnswer::measures`](super::StudyAnswer::measures); `None` without a curve.
    pub within: Vec<Option<f64>>,
    /// β of all combinations, with one curve for all.
    pub together: Vec<Option<f64>>,
}
