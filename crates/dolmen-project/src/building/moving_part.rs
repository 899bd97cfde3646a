//! The moving mass of a damper with its frequency, from the given values.

use super::damper::{DamperFrequency, DamperMass, MassPart, MovingPart};
use super::file::DamperKindRaw;
use crate::quantity::Quantity;
use crate::wrong::{Common, WrongDamper};
use dolmen_words::message::Both;

/// Errors of a damper as a whole.
pub(super) struct DamperRefusal {
    pub(super) message: WrongDamper,
    pub(super) help: Both,
}

impl DamperRefusal {
    fn because(message: WrongDamper, help: impl Into<Both>) -> Box<Self> {
        let help = help.into();
        Box::new(DamperRefusal { message, help })
    }
}

/// The keys of a liquid column.
pub(super) struct Liquid {
    pub(super) length_ratio: Option<Quantity>,
    pub(super) share: Option<Quantity>,
    pub(super) frequency: Option<Quantity>,
    pub(super) length: Option<Quantity>,
    pub(super) damping_ratio: Option<Quantity>,
}

pub(super) fn mass_of(
    mass: Option<Quantity>,
    ratio: Option<Quantity>,
    path: &str,
) -> Result<DamperMass, Box<DamperRefusal>> {
    let path = path.to_owned();
    match (mass, ratio) {
        (Some(mass), None) => Ok(DamperMass::Mass(mass)),
        (None, Some(ratio)) => Ok(DamperMass::Ratio(ratio)),
        (Some(_), Some(_)) => Err(DamperRefusal::because(
            WrongDamper::HasBothMassAnd { path },
            Common::KeepOneOfThem,
        )),
        (None, None) => Err(DamperRefusal::because(
            WrongDamper::HasNeitherMassNor { path },
            WrongDamper::GiveMassOrMass,
        )),
    }
}

/// The frequency: given, or from its ratio to that of the mode, the length of the column, or the tuning.
pub(super) fn frequency_of(
    given: [Option<Quantity>; 3],
    is_tuned: bool,
    path: &str,
) -> Result<DamperFrequency, Box<DamperRefusal>> {
    let path = path.to_owned();
    if given.iter().flatten().count() > 1 {
        return Err(DamperRefusal::because(
            WrongDamper::HasItsFrequencyTwice { path },
            Common::KeepOneOfThem,
        ));
    }
    match given {
        [Some(frequency), ..] => Ok(DamperFrequency::Frequency(frequency)),
        [_, Some(ratio), _] => Ok(DamperFrequency::Ratio(ratio)),
        [.., Some(length)] => Ok(DamperFrequency::Length(length)),
        _ if is_tuned => Ok(DamperFrequency::Tuned),
        _ => Err(DamperRefusal::because(
            WrongDamper::HasNoFrequency { path },
            WrongDamper::GiveFrequencyFrequencyRatio,
        )),
    }
}

/// Requires a damping ratio or a tuning; a tuning that gives neither damping nor frequency is useless.
pub(super) fn judge_damping(
    is_given: bool,
    is_tuned: bool,
    frequency: &DamperFrequency,
    path: &str,
) -> Result<(), Box<DamperRefusal>> {
    let path = path.to_owned();
    if !is_given && !is_tuned {
        return Err(DamperRefusal::because(
            WrongDamper::HasNoDampingRatio { path },
            WrongDamper::GiveDampingRatioOn,
        ));
    }
    if is_tuned && is_given && !matches!(frequency, DamperFrequency::Tuned) {
        return Err(DamperRefusal::because(
            WrongDamper::NamesTuningButGives { path },
            WrongDamper::TakeTuningOutOr,
        ));
    }
    Ok(())
}

/// The moving mass; `None` if its parts were rejected.
pub(super) fn moving_part(
    kind: DamperKindRaw,
    liquid: Liquid,
    parts: Option<Vec<MassPart>>,
    path: &str,
) -> Result<Option<MovingPart>, Box<DamperRefusal>> {
    let path = path.to_owned();
    if matches!(kind, DamperKindRaw::Tmd | DamperKindRaw::Link) {
        return Ok(parts.map(MovingPart::Masses));
    }
    let Some(length_ratio) = liquid.length_ratio else {
        return Err(DamperRefusal::because(
            WrongDamper::HasNoLengthRatio { path },
            WrongDamper::GiveHorizontalLengthOf,
        ));
    };
    if matches!(kind, DamperKindRaw::Tlcd) {
        return Ok(Some(MovingPart::Column { length_ratio }));
    }
    let liquid_frequency = match (liquid.frequency, liquid.length) {
        (Some(frequency), None) => DamperFrequency::Frequency(frequency),
        (None, Some(length)) => DamperFrequency::Length(length),
        _ => {
            return Err(DamperRefusal::because(
                WrongDamper::NeedsOneOfLiquid { path },
                WrongDamper::GiveLiquidSFrequency,
            ));
        }
    };
    match (liquid.share, liquid.damping_ratio) {
        (Some(liquid_share), Some(liquid_damping_ratio)) => Ok(Some(MovingPart::ColumnMass {
            length_ratio,
            liquid_share,
            liquid_frequency,
            liquid_damping_ratio,
        })),
        _ => Err(DamperRefusal::because(
            WrongDamper::NeedsLiquidShareAnd { path },
            WrongDamper::GiveLiquidSPart,
        )),
    }
}
