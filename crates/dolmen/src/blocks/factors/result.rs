//! Result of identifying the springs of a stack from measured modes.

use super::super::error::BlocksError;
use super::stack_motion::StackMotion;

/// The springs of one factor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
pub enum StiffnessOf {
    /// The springs of one joint.
    Joint,
    /// All joints of one plane, in a stack of many joints.
    Bed,
}

/// How a measured mode was paired with a computed one.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
pub enum PairedBy {
    /// By counting from the lowest of its direction.
    Order,
    /// By its shape.
    Shape,
}

/// A measured mode and its computed mode.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct PairedMode {
    /// Motion of the stack in it.
    pub motion: StackMotion,
    /// Its number among the computed modes of that motion, 1 the lowest.
    pub number: usize,
    /// How it was paired.
    pub paired_by: PairedBy,
    /// Measured, Hz.
    pub measured_hz: f64,
    /// Standard deviation in use, Hz.
    pub measured_sd_hz: f64,
    /// Whether the deviation is assumed because none was measured.
    pub is_sd_assumed: bool,
    /// Number of points of its shape in use.
    pub shape_points: usize,
    /// With the springs as drawn, Hz.
    pub drawn_hz: f64,
    /// With the common factor, Hz.
    pub common_hz: f64,
    /// Frequency with the best factors, Hz; `None` if there are none.
    pub best_hz: Option<f64>,
    /// Modal assurance of the measured shape and the computed one at the common factor; `None` with fewer points than 2.
    pub assurance: Option<f64>,
    /// Share of the strain energy of the mode in the springs of each factor, at the common factor. With those of dowels and clamps,
    /// which no factor multiplies, the sum is 1.
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
    /// The stack has fewer modes of its motion.
    TooMany {
        /// Number of computed modes of that motion.
        computed: usize,
    },
    /// By counting from the lowest it is one mode, but its frequency is nearer to that of another.
    BetweenModes {
        /// Frequency of the selected mode, with the factor of the lowest one, Hz.
        counted_hz: f64,
        /// Frequency of the nearest mode, Hz.
        nearest_hz: f64,
    },
    /// Its shape is equally similar to two computed modes.
    ShapesAlike {
        /// Modal assurance with both.
        assurance: [f64; 2],
    },
    /// Its shape is similar to no computed mode.
    ShapeUnlike {
        /// The largest modal assurance.
        assurance: f64,
    },
    /// Its shape is similar to that of a mode already paired with a lower measured mode.
    ShapeTaken {
        /// Modal assurance with it.
        assurance: f64,
    },
    /// Its number is counted from a lower mode that is not used.
    AfterUnused,
}

/// A measured mode that is not used.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct UnusedMode {
    /// Motion of the stack in it.
    pub motion: StackMotion,
    /// Measured, Hz.
    pub measured_hz: f64,
    /// Why.
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

/// Where a factor can lie.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct FactorRange {
    /// The least.
    pub lower: f64,
    /// The largest.
    pub upper: f64,
    /// Whether the lower end is that of the band: these modes allow any lower factor.
    pub is_lower_of_band: bool,
    /// Whether the upper end is that of the band.
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
    /// A smaller factor is excluded for all values of the others: even with all other joints rigid, a mode would be two standard deviations below its
    /// measured frequency. `None` if no mode excludes any.
    pub least: Option<f64>,
    /// Index among the paired modes of the one that gives `least`.
    pub least_from: Option<usize>,
    /// 95 % range if every other factor is in the band; `None` if it is not computed, or if no factors in the band explain the modes.
    pub range: Option<FactorRange>,
    /// The factor, where the modes determine it.
    pub best: Option<f64>,
    /// Standard deviation of its logarithm.
    pub relative_sd: Option<f64>,
}

/// Factors on the springs of a stack from measured modes.
#[derive(Clone, Debug, PartialEq)]
pub struct JointFactors {
    /// The springs of one factor.
    pub of: StiffnessOf,
    /// One per joint or bed, in the order of the lowest joint.
    pub factors: Vec<JointFactor>,
    /// Joints without springs at rest: they are open.
    pub open_joints: Vec<usize>,
    /// The modes in use.
    pub modes: Vec<PairedMode>,
    /// Modes that were not used.
    pub unused: Vec<UnusedMode>,
    /// One factor for all joints.
    pub common: CommonFactor,
    /// Least and largest factor of the band that ranges assume.
    pub band: [f64; 2],
    /// Singular values of the derivatives of the data over their deviations with respect to the logarithms of the factors, at the common
    /// factor, descending.
    pub singular_values: Vec<f64>,
    /// Number of combinations of factors that the modes determine within the band.
    pub fixed_combinations: usize,
    /// Root mean square of (computed − measured)/deviation for the best factors in the band; `None` if ranges are not computed.
    pub best_misfit: Option<f64>,
    /// Whether the best factors in the band explain the modes, with a misfit that chance exceeds in more than one of a thousand surveys; `None` if
    /// not computed.
    pub explains: Option<bool>,
    /// Largest relative difference between a frequency of this linear model and that of the stack after settling again on the best springs,
    /// or on those of the common factor if there are no best ones; an error if the stack does not come to rest on them.
    pub resettled: Result<f64, BlocksError>,
}
