//! Reads frames.

use super::columns::{agree, columns};
use super::file::{AlongRaw, AxialRaw, ConventionRaw, DirectionRaw, StoreyRaw};
use super::friction::friction;
use super::part::{Axial, DirectionPart, FramePart, StoreyPart};
use super::tenons::tenons as tenons_of;
use crate::content::WarningKind;
use crate::error::Fault;
use crate::file::FileRaw;
use crate::file_number::{At, OrUnknown, sought};
use crate::measure::{Bound, Measure};
use crate::needed::{countable, heaviness, missing, one_each};
use crate::ratio::damping_ratio;
use crate::reader::Reader;
use crate::warned::Warned;
use crate::wrong::WrongFrame;
use dolmen::signal::Component;
use dolmen::structure::Convention;
use std::collections::BTreeMap;

fn storey(reader: &mut Reader, raw: &At<StoreyRaw>, path: &str) -> Option<StoreyPart> {
    let storey = &raw.value;
    let height = reader.quantity(
        storey.height.as_ref(),
        &format!("{path}.height"),
        Measure::Length,
        Bound::Positive,
    );
    let force_path = format!("{path}.axial_force");
    let axial_force = reader.quantity(
        storey.axial_force.as_ref(),
        &force_path,
        Measure::Force,
        Bound::NotNegative,
    );
    let given = storey.columns.as_ref();
    let columns = given.map(|raw| columns(reader, raw, &format!("{path}.columns")));
    let heaviness = heaviness(
        reader,
        storey.weight.as_ref(),
        storey.mass.as_ref(),
        path,
        &raw.span,
    );
    Some(StoreyPart {
        name: storey.name.clone(),
        heaviness: heaviness?,
        height: height?,
        axial_force,
        columns: match columns {
            None => None,
            Some(columns) => Some(columns?),
        },
    })
}

pub(crate) fn frame(
    reader: &mut Reader,
    raw: &FileRaw,
    gravity_m_s2: f64,
    surveyed: &[String],
) -> Option<FramePart> {
    let Some(list) = raw.storeys.as_ref() else {
        missing(
            reader,
            "storeys",
            WrongFrame::FrameNeedsStoreys,
            WrongFrame::StoreysMassHeight,
        );
        return None;
    };
    if !countable(reader, list, "storeys") {
        return None;
    }
    reader.mark("storeys", &list.span);
    let numbered = list.value.iter().enumerate();
    let storeys: Vec<Option<StoreyPart>> = numbered
        .map(|(i, raw)| storey(reader, raw, &format!("storeys[{}]", i + 1)))
        .collect();
    let axial = axial(reader, raw, list);
    let free = free(&storeys);
    let directions = directions(reader, raw.direction.as_ref(), &free, surveyed);
    let convention = match raw.convention.as_ref().map(|convention| convention.value) {
        None | Some(ConventionRaw::Drift) => Convention::Drift,
        Some(ConventionRaw::Grounded) => Convention::Grounded,
    };
    let frame = FramePart {
        storeys: storeys.into_iter().collect::<Option<_>>()?,
        axial: axial?,
        convention,
        directions: directions?,
        lean: None,
        takes_no_tilt: false,
        static_loads: Vec::new(),
        gravity_m_s2,
    };
    if let Some(first) = frame.storeys.iter().position(|storey| storey.columns.is_some()) {
        let path = format!("storeys[{}].columns", first + 1);
        reader.warn(WarningKind::ColumnsNotInMotion, &path, Warned::ColumnsNotInMotion);
    }
    (agree(reader, &frame) && alone_agree(reader, &frame)).then_some(frame)
}

/// Rejects a storey on columns alone that contradicts the frame; returns whether it is consistent.
fn alone_agree(reader: &mut Reader, frame: &FramePart) -> bool {
    let before = reader.faults.len();
    for direction in &frame.directions {
        let mut all = direction.stiffness.iter().flatten();
        let Some(none) = all.find(|stiffness| stiffness.value == 0.0) else {
            continue;
        };
        let path = none.path.clone();
        let problem = match (frame.convention, &direction.friction) {
            (Convention::Grounded, _) => {
                Some((WrongFrame::AloneGrounded(path.clone()), WrongFrame::WriteDrift))
            }
            (Convention::Drift, Some(_)) => Some((
                WrongFrame::AloneRubs(path.clone()),
                WrongFrame::TakeFrictionOut(direction.name.clone()),
            )),
            (Convention::Drift, None) if direction.tenons.is_some() => Some((
                WrongFrame::AloneHasTenons(path.clone()),
                WrongFrame::TakeTenonsOut(direction.name.clone()),
            )),
            (Convention::Drift, None) => None,
        };
        if let Some((message, help)) = problem {
            reader.fault(Fault::new(reader.place(&path), &path, message).help(help));
        }
    }
    reader.faults.len() == before
}

/// Whether the columns of a storey are free-standing.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Free {
    /// The file does not say so.
    No,
    /// On beds with elasticity.
    OnBeds,
    /// On rigid stones.
    OnRigidStones,
}

fn free(storeys: &[Option<StoreyPart>]) -> Vec<Free> {
    let each = storeys.iter().map(|storey| {
        let columns = storey.as_ref().and_then(|storey| storey.columns.as_ref());
        match columns.map(|columns| columns.bed_stiffness.is_some()) {
            None => Free::No,
            Some(true) => Free::OnBeds,
            Some(false) => Free::OnRigidStones,
        }
    });
    each.collect()
}

/// The meaning of the axial forces: given for all storeys and named, or for none.
fn axial(reader: &mut Reader, raw: &FileRaw, storeys: &At<Vec<At<StoreyRaw>>>) -> Option<Axial> {
    let given = |storey: &At<StoreyRaw>| storey.value.axial_force.is_some();
    let count = storeys.value.iter().filter(|storey| given(storey)).count();
    if let Some(axial) = raw.axial.as_ref() {
        reader.mark("axial", &axial.span);
    }
    match (count, raw.axial.as_ref()) {
        (0, None) => {
            reader.warn(WarningKind::AxialFromMasses, "storeys", Warned::AxialFromMasses);
            Some(Axial::FromMasses)
        }
        (0, Some(axial)) => {
            let fault = Fault::new(axial.span.clone(), "axial", WrongFrame::AxialIsGivenBut);
            reader.fault(fault.help(WrongFrame::GiveEachStoreyIts));
            None
        }
        (count, _) if count < storeys.value.len() => {
            let first = storeys
                .value
                .iter()
                .position(|storey| !given(storey))
                .unwrap_or(0);
            let path = format!("storeys[{}].axial_force", first + 1);
            let span = storeys
                .value
                .get(first)
                .map_or(0..0, |storey| storey.span.clone());
            let message = WrongFrame::StoreysHasNoAxial((first + 1).to_string());
            let fault = Fault::new(span, &path, message);
            reader.fault(fault.help(WrongFrame::GiveAllOfThem));
            None
        }
        (_, None) => {
            missing(
                reader,
                "axial",
                WrongFrame::AxialForceIsGiven,
                WrongFrame::WriteAxialStoreyIf,
            );
            None
        }
        (_, Some(axial)) => Some(match axial.value {
            AxialRaw::Storey => Axial::Storey,
            AxialRaw::Level => Axial::Level,
        }),
    }
}

/// The component of a name.
fn of_name(name: &str) -> Option<Component> {
    match name {
        "x" => Some(Component::X),
        "y" => Some(Component::Y),
        _ => None,
    }
}

/// The component along a direction: given, or by its name; no two directions have the same.
fn along(
    reader: &mut Reader,
    name: &str,
    given: Option<&At<AlongRaw>>,
    others: &[DirectionPart],
) -> Option<Component> {
    let own = match given.map(|given| given.value) {
        Some(AlongRaw::X) => Some(Component::X),
        Some(AlongRaw::Y) => Some(Component::Y),
        None => of_name(name),
    };
    let other = others.iter().find(|other| own.is_some() && other.along == own);
    if let (Some(own), Some(other)) = (own, other) {
        let path = format!("direction.{name}.along");
        let message = WrongFrame::BothAlong {
            name: name.to_owned(),
            other: other.name.clone(),
            component: own.name().to_owned(),
        };
        let span = given.map_or_else(
            || reader.place(&format!("direction.{name}.stiffness")),
            |of| of.span.clone(),
        );
        let fault = Fault::new(span, &path, message);
        reader.fault(fault.help(WrongFrame::OneAlongEach));
    }
    own
}

fn directions(
    reader: &mut Reader,
    raw: Option<&BTreeMap<String, At<DirectionRaw>>>,
    free: &[Free],
    surveyed: &[String],
) -> Option<Vec<DirectionPart>> {
    let storeys = free.len();
    let mut given: Vec<(&String, &At<DirectionRaw>)> = raw.into_iter().flatten().collect();
    given.sort_by_key(|(_, direction)| direction.span.start);
    let mut all = Vec::new();
    let mut sound = true;
    for (name, direction) in given {
        let Some(stiffness) = direction.value.stiffness.as_ref() else {
            sound = false;
            continue;
        };
        let path = format!("direction.{name}.stiffness");
        reader.mark(&path, &stiffness.span);
        let left_to = sought(Some(stiffness));
        let stiffness = match &stiffness.value {
            OrUnknown::Unknown | OrUnknown::Identified(_) => None,
            OrUnknown::Known(list) => {
                sound &= one_each(reader, list, &stiffness.span, &path, ("storeys", storeys));
                let mut each = Vec::with_capacity(list.len());
                for (i, raw) in list.iter().enumerate() {
                    let path = format!("{path}[{}]", i + 1);
                    let bound = match free.get(i) {
                        Some(Free::No) | None => Bound::Positive,
                        Some(Free::OnBeds | Free::OnRigidStones) => Bound::NotNegative,
                    };
                    match reader.quantity(Some(raw), &path, Measure::StoreyStiffness, bound) {
                        Some(quantity) => {
                            if quantity.value == 0.0 && free.get(i) == Some(&Free::OnRigidStones) {
                                let message = WrongFrame::NothingAtSmallDrift(path.clone());
                                let fault = Fault::new(reader.place(&path), &path, message);
                                let place = format!("storeys[{}].columns", i + 1);
                                reader.fault(fault.help(WrongFrame::GiveBedStiffness(place)));
                                sound = false;
                            }
                            each.push(quantity);
                        }
                        None => sound = false,
                    }
                }
                Some(each)
            }
        };
        let path = format!("direction.{name}");
        let before = reader.faults.len();
        let along = along(reader, name, direction.value.along.as_ref(), &all);
        let damping_ratio = damping_ratio(
            reader,
            direction.value.damping_ratio.as_ref(),
            &format!("{path}.damping_ratio"),
        );
        let friction = direction.value.friction.as_ref().and_then(|raw| {
            friction(
                reader,
                raw,
                &format!("{path}.friction"),
                (storeys, stiffness.as_deref()),
            )
        });
        let tenons = direction.value.tenons.as_ref();
        let tenons = tenons.and_then(|raw| tenons_of(reader, raw, &format!("{path}.tenons"), storeys));
        sound &= reader.faults.len() == before;
        all.push(DirectionPart {
            name: name.clone(),
            along,
            stiffness,
            sought: left_to,
            damping_ratio,
            friction,
            tenons,
        });
    }
    for name in surveyed {
        if !all.iter().any(|direction| &direction.name == name) {
            let own = of_name(name).filter(|own| all.iter().all(|other| other.along != Some(*own)));
            all.push(unknown(name, own));
        }
    }
    if all.is_empty() {
        all.push(unknown("x", Some(Component::X)));
    }
    sound.then_some(all)
}

/// A direction without any values.
fn unknown(name: &str, along: Option<Component>) -> DirectionPart {
    DirectionPart {
        name: name.to_owned(),
        along,
        stiffness: None,
        sought: None,
        damping_ratio: None,
        friction: None,
        tenons: None,
    }
}
