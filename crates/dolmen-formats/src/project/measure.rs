//! What a number of the file measures, and which values it may have.

use super::units::Dimension;

/// What a number of the file measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Measure {
    Length,
    Force,
    Mass,
    JointStiffness,
    StoreyStiffness,
    JointDamping,
    Inertia,
    Frequency,
    Acceleration,
    Ratio,
}

impl Measure {
    pub(super) fn dimension(self) -> Dimension {
        match self {
            Measure::Length => Dimension::LENGTH,
            Measure::Force => Dimension::FORCE,
            Measure::Mass => Dimension::MASS,
            Measure::JointStiffness => Dimension::MOMENT,
            Measure::StoreyStiffness => Dimension::FORCE_PER_LENGTH,
            Measure::JointDamping => Dimension::ROTATIONAL_DAMPING,
            Measure::Inertia => Dimension::INERTIA,
            Measure::Frequency => Dimension::FREQUENCY,
            Measure::Acceleration => Dimension::ACCELERATION,
            Measure::Ratio => Dimension::RATIO,
        }
    }

    /// Its SI unit, the default of bare numbers.
    pub(super) fn si(self) -> &'static str {
        match self {
            Measure::Length => "m",
            Measure::Force => "N",
            Measure::Mass => "kg",
            Measure::JointStiffness => "N m/rad",
            Measure::StoreyStiffness => "N/m",
            Measure::JointDamping => "N m s/rad",
            Measure::Inertia => "kg m2",
            Measure::Frequency => "Hz",
            Measure::Acceleration => "m/s2",
            Measure::Ratio => "",
        }
    }

    /// A unit to name in a message.
    pub(super) fn example(self) -> &'static str {
        match self {
            Measure::Length => "m or mm",
            Measure::Force => "kN",
            Measure::Mass => "t or kg",
            Measure::JointStiffness => "kN*m/rad",
            Measure::StoreyStiffness => "kN/mm",
            Measure::JointDamping => "kN*m*s/rad",
            Measure::Inertia => "t*m2",
            Measure::Frequency => "Hz",
            Measure::Acceleration => "m/s2",
            Measure::Ratio => "%, or none",
        }
    }
}

/// Which values a number may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bound {
    Positive,
    NotNegative,
    Any,
}
