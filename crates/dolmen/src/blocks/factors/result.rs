//! Result of identifying the springs of a stack from measured modes.

use super::super::error::BlocksError;
use super::stack_motion::StackMotion;

/// The joints that share one factor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
pub enum StiffnessOf {
    /// A single joint.
    Joint,
    /// All joints of one plane, in a stack with many joints.
    Bed,
}

/// How a measured mode was paired with a computed one.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
pub enum PairedBy {
    /// By counting from the lowest mode of its motion.
    Order,
    /// By its shape.
    Shape,
}

/// A measured mode and its computed mode.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct PairedMode {
    /// Its motion.
    pub motion: StackMotion,
    /// Its number among the computed modes of this motion, 1 the lowest, at the springs at which it was paired.
    pub number: usize,
    /// How it was paired.
    pub paired_by: PairedBy,
    /// Measured frequency, Hz.
    pub measured_hz: f64,
    /// Standard deviation of the frequency, as used, Hz.
    pub measured_sd_hz: f64,
    /// Whether this standard deviation is assumed because none was measured.
    pub is_sd_assumed: bool,
    /// Number of points of its shape that are used.
    pub shape_points: usize,
    /// Frequency with the springs as drawn, Hz.
    pub drawn_hz: f64,
    /// Frequency with the common factor, Hz.
    pub common_hz: f64,
    /// Frequency with the best factors, Hz; `None` if there are none.
    pub best_hz: Option<f64>,
    /// MAC of the measured shape and the computed shape with the common factor; `None` with fewer than two points.
    pub assurance: Option<f64>,
    /// Fraction of the strain energy of the mode in the springs of each factor, with the common factor. Together with the fraction in dowels and
    /// clamps, which have no factor, the sum is 1.
    pub energy_shares: Vec<f64>,
}

/// Why a measured mode is not used.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize),
    serde(tag = "why", rename_all = "snake_case")
)]
pub enum WhyUnused {
    /// The stack has fewer computed modes with this motion.
    TooMany {
        /// Number of computed modes with this motion.
        computed: usize,
    },
    /// Counting from the lowest gives one mode, but the frequency is nearer to that of another mode.
    BetweenModes {
        /// Frequency of the counted mode, times the ratio of the lowest modes, Hz.
        counted_hz: f64,
        /// Frequency of the nearest mode, Hz.
        nearest_hz: f64,
    },
    /// Its shape is similar to two computed modes.
    ShapesAlike {
        /// MAC with both.
        assurance: [f64; 2],
    },
    /// Its shape is similar to no computed mode.
    ShapeUnlike {
        /// The largest MAC.
        assurance: f64,
    },
    /// Its shape is similar to a mode that is already paired with a lower measured mode.
    ShapeTaken {
        /// MAC with that mode.
        assurance: f64,
    },
    /// Counting continues from a lower mode that is not used.
    AfterUnused,
}

/// A measured mode that is not used.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct UnusedMode {
    /// Its motion.
    pub motion: StackMotion,
    /// Measured frequency, Hz.
    pub measured_hz: f64,
    /// Reason.
    pub why: WhyUnused,
}

/// One factor for the springs of all joints.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct CommonFactor {
    /// The factor.
    pub factor: f64,
    /// Standard deviation of its logarithm, increased by the misfit if there are more data than unknowns.
    pub relative_sd: f64,
    /// Root mean square of (computed − measured)/deviation.
    pub misfit: f64,
}

/// The range in which a factor can lie.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct FactorRange {
    /// Lower end.
    pub lower: f64,
    /// Upper end.
    pub upper: f64,
    /// Whether the lower end is that of the band: the modes allow any smaller factor.
    pub is_lower_of_band: bool,
    /// Whether the upper end is that of the band: the modes allow any larger factor.
    pub is_upper_of_band: bool,
}

impl FactorRange {
    /// Whether the range is the whole band.
    pub fn is_band(&self) -> bool {
        self.is_lower_of_band && self.is_upper_of_band
    }
}

/// The factor on the springs of a joint, or of all joints of a bed.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct JointFactor {
    /// Indices of the joints.
    pub joints: Vec<usize>,
    /// Lower bound: a smaller factor is excluded for all values of the other factors, because even with all other joints rigid a mode would be two
    /// standard deviations below its measured frequency. `None` if no mode excludes any factor.
    pub least: Option<f64>,
    /// Index of the paired mode that gives `least`.
    pub least_from: Option<usize>,
    /// 95 % range if every other factor is in the band; `None` if it is not computed, or if no factors in the band explain the modes.
    pub range: Option<FactorRange>,
    /// The best value of the factor, if the modes determine it.
    pub best: Option<f64>,
    /// Standard deviation of its logarithm.
    pub relative_sd: Option<f64>,
}

/// Factors on the springs of a stack from measured modes.
#[derive(Clone, Debug, PartialEq)]
pub struct JointFactors {
    /// The joints that share one factor.
    pub of: StiffnessOf,
    /// One per joint or bed, in the order of the lowest joint.
    pub factors: Vec<JointFactor>,
    /// Joints that are open at rest and therefore have no springs.
    pub open_joints: Vec<usize>,
    /// The modes that are used.
    pub modes: Vec<PairedMode>,
    /// The modes that are not used.
    pub unused: Vec<UnusedMode>,
    /// One factor for all joints.
    pub common: CommonFactor,
    /// Smallest and largest factor of the band that the ranges assume.
    pub band: [f64; 2],
    /// Singular values, descending, of the derivatives of the data (divided by their standard deviations) with respect to the logarithms of the
    /// factors, at the common factor.
    pub singular_values: Vec<f64>,
    /// Number of combinations of factors that the modes determine within the band.
    pub fixed_combinations: usize,
    /// Root mean square of (computed − measured)/deviation for the best factors in the band; `None` if ranges are not computed.
    pub best_misfit: Option<f64>,
    /// Whether the best factors in the band explain the modes: by chance, more than one in a thousand surveys has a larger misfit. `None` if not
    /// computed.
    pub explains: Option<bool>,
    /// Largest relative difference between a frequency of this linear model and that of the stack after it settles again on the best springs, or on
    /// the common springs if there are no best ones. An error if the stack does not come to rest on them.
    pub resettled: Result<f64, BlocksError>,
}
