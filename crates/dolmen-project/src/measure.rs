//! The quantity of a number in the file, and its allowed values.

use super::units::Dimension;
use super::wrong::WrongUnit;
use dolmen_words::message::Both;

/// The quantity of a number in the file.
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
    /// Of the ground: never a bare number, because codes use g and files use all units.
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
    pub(super) fn example(self) -> Both {
        match self {
            Measure::Length => WrongUnit::MOrMm.into(),
            Measure::Force => "kN".into(),
            Measure::Mass => WrongUnit::TOrKg.into(),
            Measure::JointStiffness => "kN*m/rad".into(),
            Measure::StoreyStiffness => "kN/mm".into(),
            Measure::JointDamping => "kN*m*s/rad".into(),
            Measure::Dashpot => "kN*s/m".into(),
            Measure::Moment => "kN*m".into(),
            Measure::Inertia => "t*m2".into(),
            Measure::Frequency => "Hz".into(),
            Measure::Acceleration => "m/s2".into(),
            Measure::GroundAcceleration => WrongUnit::GOrMS2.into(),
            Measure::Ratio => WrongUnit::OrNone.into(),
            Measure::Density => WrongUnit::KgM3OrT.into(),
            Measure::Stress => WrongUnit::KpaOrMpa.into(),
            Measure::BedStiffness => "GPa/m".into(),
            Measure::Angle => "deg".into(),
            Measure::Velocity => "m/s".into(),
            Measure::Area => "m2".into(),
            Measure::Tilt => WrongUnit::MmMOrDeg.into(),
        }
    }
}

/// The allowed values of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bound {
    Positive,
    NotNegative,
    Any,
}
