//! Chains and frames from what is written.

use super::chain::{Cap, ChainPart, Heaviness, JointPart, LinkPart};
use super::content::WarningKind;
use super::error::Fault;
use super::file::{
    AxialRaw, CapRaw, ConventionRaw, DirectionRaw, FileRaw, JointRaw, LinkRaw, OpeningRaw, StoreyRaw,
};
use super::file_number::{At, OrUnknown, QuantityRaw};
use super::frame::{Axial, DirectionPart, FramePart, StoreyPart};
use super::measure::{Bound, Measure};
use super::quantity::Quantity;
use super::read_friction::{self, chain_damping, joint_friction};
use super::reader::Reader;
use dolmen::dynamics::JointOpening;
use dolmen::structure::Convention;
use std::collections::BTreeMap;
use std::ops::Range;

/// Most parts of a structure, our choice: no chain or frame that people model by hand comes near.
const PARTS_MOST: usize = 1000;

/// A part's weight or mass: exactly one of the two.
pub(super) fn heaviness(
    reader: &mut Reader,
    weight: Option<&At<QuantityRaw>>,
    mass: Option<&At<QuantityRaw>>,
    path: &str,
    part: &Range<usize>,
) -> Option<Heaviness> {
    match (weight, mass) {
        (Some(weight), None) => {
            let path = format!("{path}.weight");
            let weight = reader.quantity(Some(weight), &path, Measure::Force, Bound::Positive)?;
            Some(Heaviness::Weight(weight))
        }
        (None, Some(mass)) => {
            let path = format!("{path}.mass");
            let mass = reader.quantity(Some(mass), &path, Measure::Mass, Bound::Positive)?;
            Some(Heaviness::Mass(mass))
        }
        (Some(weight), Some(_)) => {
            let fault = Fault::new(
                weight.span.clone(),
                path,
                format!("{path} has both weight and mass"),
            );
            reader.fault(
                fault
                    .allowed("must be one of them")
                    .help("take one out: weight = mass × gravity"),
            );
            None
        }
        (None, None) => {
            let reported =
                reader.is_reported(&format!("{path}.weight")) || reader.is_reported(&format!("{path}.mass"));
            if !reported {
                let fault = Fault::new(part.clone(), path, format!("{path} has neither weight nor mass"));
                reader.fault(fault.help("give weight = … (a force) or mass = …"));
            }
            None
        }
    }
}

fn link(reader: &mut Reader, raw: &At<LinkRaw>, path: &str) -> Option<LinkPart> {
    let mut of = |raw: &Option<At<QuantityRaw>>, key: &str, measure, bound| {
        reader.quantity(raw.as_ref(), &format!("{path}.{key}"), measure, bound)
    };
    let link = &raw.value;
    let length = of(&link.length, "length", Measure::Length, Bound::Positive);
    let centroid = of(&link.centroid, "centroid", Measure::Length, Bound::NotNegative);
    let inertia = of(&link.inertia, "inertia", Measure::Inertia, Bound::Positive);
    let breadth = of(&link.breadth, "breadth", Measure::Length, Bound::Positive);
    let bed_width = of(&link.bed_width, "bed_width", Measure::Length, Bound::Positive);
    let heaviness = heaviness(reader, link.weight.as_ref(), link.mass.as_ref(), path, &raw.span);
    if let (Some(_), Some(breadth)) = (&inertia, &breadth) {
        let fault = Fault::new(
            reader.place(&breadth.path),
            path,
            format!("{path} has both inertia and breadth"),
        );
        reader.fault(fault.help("keep one of them: breadth makes the inertia that of a box"));
    }
    let (length, centroid) = (length?, centroid?);
    if centroid.value > length.value {
        let path = &centroid.path;
        let message = format!("{path} = {} lies above the link's top", centroid.written);
        let top = reader.echo(length.value, Measure::Length);
        let (number, unit) = top.split_once(' ').unwrap_or((&top, ""));
        let fault = Fault::new(reader.place(path), path, message)
            .allowed(format!("must be 0 to {number} {unit}, the link's own length"))
            .help("centroid is measured from the link's lower joint, not from the ground");
        reader.fault(fault);
    }
    Some(LinkPart {
        name: link.name.clone(),
        heaviness: heaviness?,
        length,
        centroid,
        inertia,
        breadth,
        bed_width,
    })
}

fn joint(reader: &mut Reader, raw: &At<JointRaw>, path: &str) -> (Option<JointPart>, Option<Quantity>) {
    let mut of = |raw: &Option<At<QuantityRaw>>, key: &str, measure, bound| {
        reader.quantity(raw.as_ref(), &format!("{path}.{key}"), measure, bound)
    };
    let stiffness = of(
        &raw.value.stiffness,
        "stiffness",
        Measure::JointStiffness,
        Bound::Positive,
    );
    let damping = of(
        &raw.value.damping,
        "damping",
        Measure::JointDamping,
        Bound::NotNegative,
    );
    let bed_width = of(
        &raw.value.bed_width,
        "bed_width",
        Measure::Length,
        Bound::Positive,
    );
    let friction = joint_friction(reader, &raw.value, path);
    let opening = raw.value.opening.as_ref().map(|opening| match opening.value {
        OpeningRaw::Edge => JointOpening::AtBedEdge,
        OpeningRaw::Held => JointOpening::Held,
    });
    let joint = stiffness.map(|stiffness| JointPart {
        stiffness,
        damping,
        opening,
        friction,
    });
    (joint, bed_width)
}

/// Reports an empty or too long list; whether it can be read.
pub(super) fn countable<T>(reader: &mut Reader, list: &At<Vec<T>>, path: &str) -> bool {
    let count = list.value.len();
    if (1..=PARTS_MOST).contains(&count) {
        return true;
    }
    let fault = Fault::new(list.span.clone(), path, format!("{path} has {count} elements"));
    reader.fault(fault.allowed(format!("must be 1 to {PARTS_MOST}")));
    false
}

/// Reports a list that is not as long as the structure has parts; whether it is.
pub(super) fn one_each<T>(
    reader: &mut Reader,
    list: &[T],
    span: &Range<usize>,
    path: &str,
    parts: (&str, usize),
) -> bool {
    let (part, needed) = parts;
    if list.len() == needed {
        return true;
    }
    let fault = Fault::new(
        span.clone(),
        path,
        format!("{path} has {} elements for {needed} {part}", list.len()),
    );
    reader.fault(fault.allowed(format!(
        "must be {needed}, one for each of the {part}, lowest first"
    )));
    false
}

pub(super) fn chain(reader: &mut Reader, raw: &FileRaw, gravity_m_s2: f64) -> Option<ChainPart> {
    let links_raw = raw.links.as_ref();
    if links_raw.is_none() {
        missing(
            reader,
            "links",
            "a chain needs links",
            "links = [ { weight = …, length = …, centroid = … }, … ]",
        );
    }
    if raw.joints.is_none() {
        missing(
            reader,
            "joints",
            "a chain needs joints",
            "write joints = \"unknown\" if nobody has measured them, or [ { stiffness = … }, … ]",
        );
    }
    let links_raw = links_raw?;
    if !countable(reader, links_raw, "links") {
        return None;
    }
    let list = links_raw.value.iter().enumerate();
    let links: Vec<Option<LinkPart>> = list
        .map(|(i, raw)| link(reader, raw, &format!("links[{}]", i + 1)))
        .collect();
    let mut links: Option<Vec<LinkPart>> = links.into_iter().collect();
    let count = links_raw.value.len();
    let joints = match raw.joints.as_ref() {
        None => None,
        Some(joints) => match &joints.value {
            OrUnknown::Unknown => Some(None),
            OrUnknown::Known(list) => {
                let as_many = one_each(reader, list, &joints.span, "joints", ("links", count));
                let mut all = Vec::with_capacity(list.len());
                for (i, raw) in list.iter().enumerate() {
                    let (joint, bed_width) = joint(reader, raw, &format!("joints[{}]", i + 1));
                    all.push(joint);
                    if let (Some(width), Some(links)) = (bed_width, &mut links)
                        && let Some(link) = links.get_mut(i)
                    {
                        give_bed_width(reader, link, width);
                    }
                }
                let all: Option<Vec<JointPart>> = all.into_iter().collect();
                all.filter(|_| as_many).map(Some)
            }
        },
    };
    let links = links?;
    reader.mark("links", &links_raw.span);
    warn_of_rods(reader, &links);
    let cap = match raw.cap.as_ref() {
        None => Cap::Included,
        Some(cap) => {
            reader.mark("cap", &cap.span);
            match cap.value {
                CapRaw::Included => Cap::Included,
                CapRaw::LeftOut => Cap::LeftOut,
            }
        }
    };
    if cap == Cap::LeftOut {
        let message = "the part at the very top (cap stone) is left out: its weight would lower the load factor and \
                       every frequency, so what follows is on the unsafe side";
        reader.warn(WarningKind::CapLeftOut, "cap", message.to_owned());
    }
    let joints = joints?;
    edges_known(reader, &links, joints.as_deref());
    let damping_ratio = chain_damping(reader, raw.damping_ratio.as_ref(), joints.as_deref());
    Some(ChainPart {
        links,
        joints,
        cap,
        damping_ratio,
        gravity_m_s2,
    })
}

/// A joint that opens at the edge of its bed needs the width of it.
fn edges_known(reader: &mut Reader, links: &[LinkPart], joints: Option<&[JointPart]>) {
    for (i, (link, joint)) in links.iter().zip(joints.unwrap_or_default()).enumerate() {
        if joint.opening == Some(JointOpening::AtBedEdge) && link.bed_width.is_none() {
            let path = format!("joints[{}].opening", i + 1);
            let message = format!("{path} = \"edge\", but the width of its bed is not given");
            let fault = Fault::new(reader.place(&joint.stiffness.path), &path, message);
            reader.fault(fault.help("give bed_width there, or write opening = \"held\""));
        }
    }
}

fn give_bed_width(reader: &mut Reader, link: &mut LinkPart, width: Quantity) {
    if let Some(given) = &link.bed_width {
        let message = format!("{} is the same bed as {}", width.path, given.path);
        let fault = Fault::new(reader.place(&width.path), &width.path, message);
        reader.fault(fault.allowed("given twice").help("keep one of them"));
    } else {
        link.bed_width = Some(width);
    }
}

fn warn_of_rods(reader: &mut Reader, links: &[LinkPart]) {
    let is_rod = |link: &LinkPart| link.inertia.is_none() && link.breadth.is_none();
    let rods: Vec<String> = links
        .iter()
        .enumerate()
        .filter(|(_, link)| is_rod(link))
        .map(|(i, _)| (i + 1).to_string())
        .collect();
    if !rods.is_empty() {
        let message = format!(
            "no moment of inertia for link {}: taken as a thin rod, m L²/12; give breadth for that of a box. It \
             touches frequencies, not stability",
            rods.join(", ")
        );
        reader.warn(WarningKind::ThinRod, "links", message);
    }
}

pub(super) fn missing(reader: &mut Reader, key: &str, message: &str, help: &str) {
    if !reader.is_reported(key) {
        reader.fault(Fault::new(0..0, key, message).at_top().help(help));
    }
}

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
    })
}

pub(super) fn frame(
    reader: &mut Reader,
    raw: &FileRaw,
    gravity_m_s2: f64,
    surveyed: &[String],
) -> Option<FramePart> {
    let Some(list) = raw.storeys.as_ref() else {
        missing(
            reader,
            "storeys",
            "a frame needs storeys",
            "storeys = [ { mass = …, height = … }, … ]",
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
    let directions = directions(reader, raw.direction.as_ref(), list.value.len(), surveyed);
    let convention = match raw.convention.as_ref().map(|convention| convention.value) {
        None | Some(ConventionRaw::Drift) => Convention::Drift,
        Some(ConventionRaw::Grounded) => Convention::Grounded,
    };
    Some(FramePart {
        storeys: storeys.into_iter().collect::<Option<_>>()?,
        axial: axial?,
        convention,
        directions: directions?,
        gravity_m_s2,
    })
}

/// What the axial forces are: given for all storeys and named, or for none.
fn axial(reader: &mut Reader, raw: &FileRaw, storeys: &At<Vec<At<StoreyRaw>>>) -> Option<Axial> {
    let given = |storey: &At<StoreyRaw>| storey.value.axial_force.is_some();
    let count = storeys.value.iter().filter(|storey| given(storey)).count();
    if let Some(axial) = raw.axial.as_ref() {
        reader.mark("axial", &axial.span);
    }
    match (count, raw.axial.as_ref()) {
        (0, None) => {
            let message = "no axial_force: taken as the weight of the masses at the storey's top and above; \
                           axial_force = 0 would leave P-delta out";
            reader.warn(WarningKind::AxialFromMasses, "storeys", message.to_owned());
            Some(Axial::FromMasses)
        }
        (0, Some(axial)) => {
            let fault = Fault::new(
                axial.span.clone(),
                "axial",
                "axial is given, but no storey has an axial_force",
            );
            reader.fault(
                fault.help("give each storey its axial_force, or take axial out: it then follows the masses"),
            );
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
            let message = format!(
                "storeys[{}] has no axial_force, but another storey has",
                first + 1
            );
            let fault = Fault::new(span, &path, message);
            reader.fault(fault.help("give all of them, or none: they then follow from the masses"));
            None
        }
        (_, None) => {
            missing(
                reader,
                "axial",
                "axial_force is given, but not what it is: \"axial\" is missing",
                "write axial = \"storey\" if it is the force in the storey's columns (its own level and all above), \
                 axial = \"level\" if it is the load added at its top",
            );
            None
        }
        (_, Some(axial)) => Some(match axial.value {
            AxialRaw::Storey => Axial::Storey,
            AxialRaw::Level => Axial::Level,
        }),
    }
}

fn directions(
    reader: &mut Reader,
    raw: Option<&BTreeMap<String, At<DirectionRaw>>>,
    storeys: usize,
    surveyed: &[String],
) -> Option<Vec<DirectionPart>> {
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
        let stiffness = match &stiffness.value {
            OrUnknown::Unknown => None,
            OrUnknown::Known(list) => {
                sound &= one_each(reader, list, &stiffness.span, &path, ("storeys", storeys));
                let mut each = Vec::with_capacity(list.len());
                for (i, raw) in list.iter().enumerate() {
                    let path = format!("{path}[{}]", i + 1);
                    match reader.quantity(Some(raw), &path, Measure::StoreyStiffness, Bound::Positive) {
                        Some(quantity) => each.push(quantity),
                        None => sound = false,
                    }
                }
                Some(each)
            }
        };
        let path = format!("direction.{name}");
        let before = reader.faults.len();
        let damping_ratio = read_friction::damping_ratio(
            reader,
            direction.value.damping_ratio.as_ref(),
            &format!("{path}.damping_ratio"),
        );
        let friction = direction.value.friction.as_ref().and_then(|raw| {
            read_friction::friction(
                reader,
                raw,
                &format!("{path}.friction"),
                (storeys, stiffness.as_deref()),
            )
        });
        sound &= reader.faults.len() == before;
        all.push(DirectionPart {
            name: name.clone(),
            stiffness,
            damping_ratio,
            friction,
        });
    }
    for name in surveyed {
        if !all.iter().any(|direction| &direction.name == name) {
            all.push(DirectionPart {
                name: name.clone(),
                stiffness: None,
                damping_ratio: None,
                friction: None,
            });
        }
    }
    if all.is_empty() {
        all.push(DirectionPart {
            name: "x".to_owned(),
            stiffness: None,
            damping_ratio: None,
            friction: None,
        });
    }
    sound.then_some(all)
}
