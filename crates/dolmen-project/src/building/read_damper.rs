//! Reads damping and dampers of a building.

use super::damper::{DamperBody, DamperFrequency, DamperPart, MassPart};
use super::file::{DamperKindRaw, DamperRaw, MassRaw, TuningRaw};
use super::floor_number::floor_number;
use super::moving_part::{DamperRefusal, Liquid, frequency_of, judge_damping, mass_of, moving_part};
use crate::error::Fault;
use crate::file_number::{At, QuantityRaw};
use crate::measure::{Bound, Measure};
use crate::needed::lengths;
use crate::quantity::Quantity;
use crate::reader::Reader;
use crate::units::parse_angle_rad;
use crate::wrong::{Common, WrongDamper, either};
use dolmen::damper::TuningRule;
use dolmen::structure::building::PlanDirection;
use std::collections::BTreeMap;

/// The dampers in the order of the file.
pub(super) fn dampers(
    reader: &mut Reader,
    raw: Option<&BTreeMap<String, At<DamperRaw>>>,
    floors: usize,
) -> Vec<DamperPart> {
    let mut listed: Vec<_> = raw.into_iter().flatten().collect();
    listed.sort_by_key(|(_, raw)| raw.span.start);
    let each = listed
        .into_iter()
        .filter_map(|(name, raw)| damper(reader, name, raw, floors));
    each.collect()
}

fn damper(reader: &mut Reader, name: &str, raw: &At<DamperRaw>, floors: usize) -> Option<DamperPart> {
    let path = format!("damper.{name}");
    reader.mark(&path, &raw.span);
    let before = reader.faults.len();
    let given = &raw.value;
    let kind = given.kind.as_ref()?.value;
    only_its_keys(reader, kind, given, &path)?;
    let floor = floor_number(reader, given.floor.as_ref(), &format!("{path}.floor"), floors);
    let place = place(reader, given.place.as_ref(), &format!("{path}.place"));
    let direction = direction(reader, given.direction.as_ref(), &format!("{path}.direction"));
    let stroke = positive(
        reader,
        given.stroke.as_ref(),
        &format!("{path}.stroke"),
        Measure::Length,
    );
    let liquid_stroke = positive(
        reader,
        given.liquid_stroke.as_ref(),
        &format!("{path}.liquid_stroke"),
        Measure::Length,
    );
    let body = match kind {
        DamperKindRaw::Link => link(reader, raw, &path, (floor, floors)),
        _ => moving(reader, kind, raw, &path, floors),
    };
    (reader.faults.len() == before).then_some(())?;
    Some(DamperPart {
        name: name.to_owned(),
        floor: floor?,
        place: Box::new(place?),
        direction: direction?,
        body: body?,
        stroke,
        liquid_stroke,
    })
}

fn positive(
    reader: &mut Reader,
    raw: Option<&At<QuantityRaw>>,
    path: &str,
    measure: Measure,
) -> Option<Quantity> {
    reader.quantity(raw, path, measure, Bound::Positive)
}

fn place(reader: &mut Reader, raw: Option<&At<Vec<At<QuantityRaw>>>>, path: &str) -> Option<[Quantity; 2]> {
    lengths(reader, raw?, path, "[x, y]")
}

/// A damping ratio, 0 or more.
fn ratio_of(reader: &mut Reader, raw: Option<&At<QuantityRaw>>, path: &str) -> Option<Quantity> {
    let ratio = reader.quantity(raw, path, Measure::Ratio, Bound::NotNegative)?;
    if ratio.value > 1.0 {
        let message = WrongDamper::ButAboveNothingSwings {
            path: path.to_string(),
            written: ratio.written.to_string(),
        };
        let fault = Fault::new(reader.place(path), path, message);
        reader.fault(fault.allowed(Common::ZeroToOne).help(WrongDamper::WriteAsOr));
        return None;
    }
    Some(ratio)
}

/// Rejects keys of other kinds.
fn only_its_keys(reader: &mut Reader, kind: DamperKindRaw, given: &DamperRaw, path: &str) -> Option<()> {
    use DamperKindRaw::{Link, Tlcd, Tlcmd, Tmd};
    let span = |raw: &Option<At<QuantityRaw>>| raw.as_ref().map(|raw| raw.span.clone());
    let moving = [Tmd, Tlcd, Tlcmd].as_slice();
    let keys = [
        ("mass", span(&given.mass), moving),
        ("mass_ratio", span(&given.mass_ratio), moving),
        ("mode", given.mode.as_ref().map(|raw| raw.span.clone()), moving),
        ("frequency", span(&given.frequency), moving),
        ("frequency_ratio", span(&given.frequency_ratio), moving),
        ("damping_ratio", span(&given.damping_ratio), moving),
        (
            "tuning",
            given.tuning.as_ref().map(|raw| raw.span.clone()),
            moving,
        ),
        (
            "masses",
            given.masses.as_ref().map(|raw| raw.span.clone()),
            &[Tmd],
        ),
        ("length_ratio", span(&given.length_ratio), &[Tlcd, Tlcmd]),
        ("length", span(&given.length), &[Tlcd, Tlcmd]),
        ("liquid_share", span(&given.liquid_share), &[Tlcmd]),
        ("liquid_frequency", span(&given.liquid_frequency), &[Tlcmd]),
        ("liquid_stroke", span(&given.liquid_stroke), &[Tlcmd]),
        (
            "liquid_damping_ratio",
            span(&given.liquid_damping_ratio),
            &[Tlcmd],
        ),
        ("coefficient", span(&given.coefficient), &[Link]),
        (
            "to_floor",
            given.to_floor.as_ref().map(|raw| raw.span.clone()),
            &[Link],
        ),
        (
            "to_place",
            given.to_place.as_ref().map(|raw| raw.span.clone()),
            &[Link],
        ),
    ];
    let mut fits = true;
    for (key, span, kinds) in keys {
        let Some(span) = span.filter(|_| !kinds.contains(&kind)) else {
            continue;
        };
        let words: Vec<String> = kinds.iter().map(|kind| format!("\"{}\"", word(*kind))).collect();
        let path = format!("{path}.{key}");
        let message = WrongDamper::BelongsToKindBut {
            path: path.to_string(),
            words: either(&words),
            kind: word(kind).to_string(),
        };
        reader.fault(Fault::new(span, &path, message).help(WrongDamper::TakeItOutOr));
        fits = false;
    }
    fits.then_some(())
}

fn word(kind: DamperKindRaw) -> &'static str {
    match kind {
        DamperKindRaw::Tmd => "tmd",
        DamperKindRaw::Tlcd => "tlcd",
        DamperKindRaw::Tlcmd => "tlcmd",
        DamperKindRaw::Link => "link",
    }
}

fn link(
    reader: &mut Reader,
    raw: &At<DamperRaw>,
    path: &str,
    (floor, floors): (Option<usize>, usize),
) -> Option<DamperBody> {
    let given = &raw.value;
    if given.coefficient.is_none() {
        let key = format!("{path}.coefficient");
        let fault = Fault::new(
            raw.span.clone(),
            &key,
            WrongDamper::HasNoCoefficient {
                path: path.to_string(),
            },
        );
        reader.fault(fault.help(WrongDamper::GiveForcePerVelocity));
        return None;
    }
    let coefficient = positive(
        reader,
        given.coefficient.as_ref(),
        &format!("{path}.coefficient"),
        Measure::Dashpot,
    );
    let to_place = match &given.to_place {
        None => None,
        Some(to) => Some(Box::new(place(reader, Some(to), &format!("{path}.to_place"))?)),
    };
    let to_floor = match &given.to_floor {
        None => floor?.saturating_sub(1),
        Some(to) if to.value == 0 => 0,
        Some(to) => floor_number(reader, Some(to), &format!("{path}.to_floor"), floors)?,
    };
    let key = format!("{path}.to_floor");
    if to_floor == floor? {
        let fault = Fault::new(
            raw.span.clone(),
            &key,
            WrongDamper::TiesFloorToItself {
                path: path.to_string(),
                to_floor: to_floor.to_string(),
            },
        );
        reader.fault(fault.help(WrongDamper::FloorIsRigidName));
        return None;
    }
    if to_floor == 0 && to_place.is_some() {
        let fault = Fault::new(
            raw.span.clone(),
            &key,
            WrongDamper::ToPlaceIsOf {
                path: path.to_string(),
            },
        );
        reader.fault(fault.help(WrongDamper::GroundMovesAlikeEverywhere));
        return None;
    }
    Some(DamperBody::Link {
        coefficient: coefficient?,
        to_floor,
        to_place,
    })
}

fn moving(
    reader: &mut Reader,
    kind: DamperKindRaw,
    raw: &At<DamperRaw>,
    path: &str,
    floors: usize,
) -> Option<DamperBody> {
    let given = &raw.value;
    let before = reader.faults.len();
    let mode = match &given.mode {
        None => Some(1),
        Some(mode) => reader.count(Some(mode), &format!("{path}.mode"), 1, 3 * floors),
    };
    let mut of = |raw: &Option<At<QuantityRaw>>, key: &str, measure| {
        positive(reader, raw.as_ref(), &format!("{path}.{key}"), measure)
    };
    let mass = of(&given.mass, "mass", Measure::Mass);
    let mass_ratio = of(&given.mass_ratio, "mass_ratio", Measure::Ratio);
    let frequency = of(&given.frequency, "frequency", Measure::Frequency);
    let frequency_ratio = of(&given.frequency_ratio, "frequency_ratio", Measure::Ratio);
    let length = of(&given.length, "length", Measure::Length);
    let length_ratio = of(&given.length_ratio, "length_ratio", Measure::Ratio);
    let liquid_share = of(&given.liquid_share, "liquid_share", Measure::Ratio);
    let liquid_frequency = of(&given.liquid_frequency, "liquid_frequency", Measure::Frequency);
    let ratio = ratio_of(
        reader,
        given.damping_ratio.as_ref(),
        &format!("{path}.damping_ratio"),
    );
    let liquid_key = format!("{path}.liquid_damping_ratio");
    let liquid_ratio = ratio_of(reader, given.liquid_damping_ratio.as_ref(), &liquid_key);
    for (given, least) in [(&length_ratio, 1.0), (&liquid_share, 1.0)] {
        if let Some(given) = given.as_ref().filter(|given| given.value >= least) {
            let message = WrongDamper::IsNotBelow {
                path: given.path.to_string(),
                written: given.written.to_string(),
            };
            let fault = Fault::new(reader.place(&given.path), &given.path, message);
            reader.fault(fault.help(WrongDamper::ItIsPartOf));
        }
    }
    let parts = masses(reader, given.masses.as_ref(), path);
    let tuning = given.tuning.as_ref().map(|tuning| rule(tuning.value));
    (reader.faults.len() == before).then_some(())?;
    if let (None, Some(ratio)) = (&mass, mass_ratio.as_ref().filter(|ratio| ratio.value > 1.0)) {
        let message = WrongDamper::ButDamperIsLighter {
            path: ratio.path.to_string(),
            written: ratio.written.to_string(),
        };
        let fault = Fault::new(reader.place(&ratio.path), &ratio.path, message);
        let fault = fault.allowed(WrongDamper::MustBeAboveAt);
        reader.fault(fault.help(WrongDamper::MassRatioIsTo));
        return None;
    }
    // the length of the column gives the own frequency of a tlcd, and the liquid's frequency of a tlcmd
    let (own_length, liquid_length) = match kind {
        DamperKindRaw::Tlcd => (length, None),
        _ => (None, length),
    };
    let liquid = Liquid {
        length_ratio,
        share: liquid_share,
        frequency: liquid_frequency,
        length: liquid_length,
        damping_ratio: liquid_ratio,
    };
    let is_tuned = tuning.is_some();
    let body = || -> Result<Option<DamperBody>, Box<DamperRefusal>> {
        let mass = mass_of(mass, mass_ratio, path)?;
        let frequency = frequency_of([frequency, frequency_ratio, own_length], is_tuned, path)?;
        judge_damping(ratio.is_some(), is_tuned, &frequency, path)?;
        let (Some(moving), Some(mode)) = (moving_part(kind, liquid, parts, path)?, mode) else {
            return Ok(None);
        };
        Ok(Some(DamperBody::Moving {
            moving: Box::new(moving),
            mass,
            mode,
            frequency,
            damping_ratio: ratio,
            tuning,
        }))
    };
    match body() {
        Ok(body) => body,
        Err(refused) => {
            let DamperRefusal { message, help } = *refused;
            reader.fault(Fault::new(raw.span.clone(), path, message).help(help));
            None
        }
    }
}

/// Rounding difference between 1 and a sum of shares.
const SHARES_ROUNDED: f64 = 1e-3;

fn masses(reader: &mut Reader, raw: Option<&At<Vec<At<MassRaw>>>>, path: &str) -> Option<Vec<MassPart>> {
    let Some(list) = raw else {
        return Some(Vec::new());
    };
    let mut parts = Vec::with_capacity(list.value.len());
    for (i, raw) in list.value.iter().enumerate() {
        let path = format!("{path}.masses[{}]", i + 1);
        reader.mark(&path, &raw.span);
        let given = &raw.value;
        let share = positive(
            reader,
            given.share.as_ref(),
            &format!("{path}.share"),
            Measure::Ratio,
        );
        let own_place = match &given.place {
            None => None,
            Some(at) => Some(Box::new(place(reader, Some(at), &format!("{path}.place"))?)),
        };
        let frequency = positive(
            reader,
            given.frequency.as_ref(),
            &format!("{path}.frequency"),
            Measure::Frequency,
        );
        let ratio = positive(
            reader,
            given.frequency_ratio.as_ref(),
            &format!("{path}.frequency_ratio"),
            Measure::Ratio,
        );
        let frequency = match (frequency, ratio) {
            (Some(_), Some(ratio)) => {
                let message = WrongDamper::HasBothFrequencyAnd {
                    path: path.to_string(),
                };
                reader
                    .fault(Fault::new(reader.place(&ratio.path), &path, message).help(Common::KeepOneOfThem));
                return None;
            }
            (Some(frequency), None) => Some(DamperFrequency::Frequency(frequency)),
            (None, ratio) => ratio.map(DamperFrequency::Ratio),
        };
        parts.push(MassPart {
            share: share?,
            place: own_place,
            frequency,
            damping_ratio: ratio_of(
                reader,
                given.damping_ratio.as_ref(),
                &format!("{path}.damping_ratio"),
            ),
        });
    }
    let sum: f64 = parts.iter().map(|part| part.share.value).sum();
    if (sum - 1.0).abs() > SHARES_ROUNDED {
        let key = format!("{path}.masses");
        let fault = Fault::new(
            list.span.clone(),
            &key,
            WrongDamper::SharesOfAddUp {
                key: key.to_string(),
                sum: (sum + 0.0).to_string(),
            }, // −0 of none
        );
        reader.fault(fault.allowed(WrongDamper::MustAddUpTo));
        return None;
    }
    Some(parts)
}

fn rule(raw: TuningRaw) -> TuningRule {
    match raw {
        TuningRaw::DenHartog => TuningRule::DenHartog,
        TuningRaw::NishiharaAsami => TuningRule::NishiharaAsami,
        TuningRaw::WarburtonForce => TuningRule::WarburtonForce,
        TuningRaw::WarburtonBase => TuningRule::WarburtonBase,
        TuningRaw::WarburtonBaseHarmonic => TuningRule::WarburtonBaseHarmonic,
        TuningRaw::Sadek => TuningRule::Sadek,
        TuningRaw::Villaverde => TuningRule::Villaverde,
        TuningRaw::HwangMinHong => TuningRule::HwangMinHongLiteral,
    }
}

fn direction(reader: &mut Reader, raw: Option<&At<String>>, path: &str) -> Option<PlanDirection> {
    let raw = raw?;
    match raw.value.trim() {
        "x" => return Some(PlanDirection::X),
        "y" => return Some(PlanDirection::Y),
        _ => {}
    }
    match parse_angle_rad(&raw.value) {
        Ok(angle) => Some(PlanDirection::Degrees(angle.to_degrees())),
        Err(_) => {
            let message = WrongDamper::IsNoDirection {
                path: path.to_string(),
                given: raw.value.to_string(),
            };
            let fault = Fault::new(raw.span.clone(), path, message);
            reader.fault(fault.allowed(WrongDamper::MustBeXY));
            None
        }
    }
}
