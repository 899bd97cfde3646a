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
    Dashpot,
    Moment,
    Inertia,
    Frequency,
    Acceleration,
    /// Of the ground: never a bare number, since codes count in g and files in all units.
    GroundAcceleration,
    Ratio,
    Density,
    Stress,
    BedStiffness,
    Angle,
    Tilt,
    Velocity,
    Area,
}

impl Measure {
    pub(super) fn dimension(self) -> Dimension {
        match self {
            Measure::Length => Dimension::LENGTH,
            Measure::Force => Dimension::FORCE,
            Measure::Mass => Dimension::MASS,
            Measure::JointStiffness | Measure::Moment => Dimension::MOMENT,
            Measure::StoreyStiffness => Dimension::FORCE_PER_LENGTH,
            Measure::JointDamping => Dimension::ROTATIONAL_DAMPING,
            Measure::Dashpot => Dimension::DASHPOT,
            Measure::Inertia => Dimension::INERTIA,
            Measure::Frequency => Dimension::FREQUENCY,
            Measure::Acceleration | Measure::GroundAcceleration => Dimension::ACCELERATION,
            Measure::Ratio | Measure::Angle | Measure::Tilt => Dimension::RATIO,
            Measure::Density => Dimension::DENSITY,
            Measure::Stress => Dimension::STRESS,
            Measure::BedStiffness => Dimension::STRESS_PER_LENGTH,
            Measure::Velocity => Dimension::VELOCITY,
            Measure::Area => Dimension::AREA,
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
            Measure::Dashpot => "N s/m",
            Measure::Moment => "N m",
            Measure::Inertia => "kg m2",
            Measure::Frequency => "Hz",
            Measure::Acceleration | Measure::GroundAcceleration => "m/s2",
            Measure::Ratio | Measure::Tilt => "",
            Measure::Density => "kg/m3",
            Measure::Stress => "Pa",
            Measure::BedStiffness => "Pa/m",
            Measure::Angle => "rad",
            Measure::Velocity => "m/s",
            Measure::Area => "m2",
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
            Measure::Dashpot => "kN*s/m",
            Measure::Moment => "kN*m",
            Measure::Inertia => "t*m2",
            Measure::Frequency => "Hz",
            Measure::Acceleration => "m/s2",
            Measure::GroundAcceleration => "g or m/s2",
            Measure::Ratio => "%, or none",
            Measure::Density => "kg/m3 or t/m3",
            Measure::Stress => "kPa or MPa",
            Measure::BedStiffness => "GPa/m",
            Measure::Angle => "deg",
            Measure::Velocity => "m/s",
            Measure::Area => "m2",
            Measure::Tilt => "mm/m or deg, or \"1/200\"",
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
