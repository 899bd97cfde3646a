//! Change of one mode between two parts of a record, and whether it is beyond chance.

use crate::numeric::student_two_sided_quantile;

/// One mode before and after the earthquake.
#[derive(Clone, Debug, PartialEq)]
pub struct LastingChange {
    /// Frequency before, Hz.
    pub before_hz: f64,
    /// Standard deviation of the frequency before, Hz.
    pub before_sd_hz: Option<f64>,
    /// Frequency after, Hz.
    pub after_hz: f64,
    /// Standard deviation of the frequency after, Hz.
    pub after_sd_hz: Option<f64>,
    /// Frequency after over frequency before, minus 1.
    pub ratio: f64,
    /// Standard deviation of this ratio; `None` if one of the two is unknown.
    pub ratio_sd: Option<f64>,
    /// Degrees of freedom of this standard deviation, from the effective number of blocks of time in both parts.
    pub degrees_of_freedom: f64,
    /// Probability that chance alone gives at least one such change among all modes and parts of the record that are compared (Holm); `None`
    /// without a standard deviation.
    pub chance: Option<f64>,
    /// Whether an earlier or a later part shows the mode as it was without this change.
    pub is_contradicted: bool,
}

impl LastingChange {
    /// Number of standard deviations that a significant change exceeds, here and for whoever reads a survey in a project or a store. Our choice.
    pub const BEYOND: f64 = 3.0;
    /// Largest probability that chance gives a significant change anywhere in a record. Our choice.
    pub const CHANCE_MOST: f64 = 0.02;

    /// Whether the change exceeds the scatter of both identifications, and no other part of the record contradicts it.
    pub fn is_beyond_chance(&self) -> bool {
        let is_rare = self.chance.is_some_and(|chance| chance <= Self::CHANCE_MOST);
        is_rare && self.is_beyond_deviations() && !self.is_contradicted
    }

    /// Whether the change exceeds [`BEYOND`](Self::BEYOND) standard deviations: necessary, but among many modes not sufficient.
    pub fn is_beyond_deviations(&self) -> bool {
        self.ratio_sd
            .is_some_and(|sd| self.ratio.abs() > Self::BEYOND * sd)
    }

    /// Half of the width of the interval of the ratio that contains 95 %, by Student's distribution.
    pub fn half_width_95(&self) -> Option<f64> {
        let quantile = student_two_sided_quantile(0.05, self.degrees_of_freedom).ok()?;
        self.ratio_sd.map(|sd| quantile * sd)
    }
}
