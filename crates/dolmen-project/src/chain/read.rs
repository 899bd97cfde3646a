//! Reads chains.

use super::file::{CapRaw, JointRaw, LinkRaw, OpeningRaw};
use super::friction::{chain_damping, joint_friction};
use super::part::{Cap, ChainPart, JointPart, LinkPart};
use super::side_supports::side_supports;
use super::stone::{shafts_are_shafts, stone};
use super::strength::beds_bear;
use crate::content::WarningKind;
use crate::error::Fault;
use crate::file::FileRaw;
use crate::file_number::{At, OrUnknown, QuantityRaw, sought};
use crate::measure::{Bound, Measure};
use crate::needed::{countable, heaviness, missing, one_each};
use crate::quantity::Quantity;
use crate::reader::Reader;
use crate::soil::soil_under_footing;
use crate::warned::Warned;
use crate::wrong::{Common, WrongChain};
use dolmen::dynamics::JointOpening;

fn link(reader: &mut Reader, raw: &At<LinkRaw>, path: &str) -> Option<LinkPart> {
    let mut of = |raw: &Option<At<QuantityRaw>>, key: &str, measure, bound| {
        reader.quantity(raw.as_ref(), &format!("{path}.{key}"), measure, bound)
    };
    let link = &raw.value;
    let length = of(&link.length, "length", Measure::Length, Bound::Positive);
    let centroid = of(&link.centroid, "centroid", Measure::Length, Bound::NotNegative);
    let inertia = of(&link.inertia, "inertia", Measure::Inertia, Bound::Positive);
    let inertia_across = of(
        &link.inertia_across,
        "inertia_across",
        Measure::Inertia,
        Bound::Positive,
    );
    let breadth = of(&link.breadth, "breadth", Measure::Length, Bound::Positive);
    let depth = of(&link.depth, "depth", Measure::Length, Bound::Positive);
    let bed_width = of(&link.bed_width, "bed_width", Measure::Length, Bound::Positive);
    let heaviness = heaviness(reader, link.weight.as_ref(), link.mass.as_ref(), path, &raw.span);
    if let (Some(_), Some(breadth)) = (&inertia, &breadth) {
        let fault = Fault::new(
            reader.place(&breadth.path),
            path,
            WrongChain::HasBothInertiaAnd(path.to_string()),
        );
        reader.fault(fault.help(WrongChain::KeepOneOfThemBreadth));
    }
    if let (Some(_), Some(depth)) = (&inertia_across, &depth) {
        let message = WrongChain::HasBothInertiaAcrossAnd(path.to_string());
        let fault = Fault::new(reader.place(&depth.path), path, message);
        reader.fault(fault.help(WrongChain::KeepOneOfThemDepth));
    }
    if let (Some(across), None, None) = (depth.as_ref().or(inertia_across.as_ref()), &inertia, &breadth) {
        let message = WrongChain::AcrossWithoutAlong(across.path.clone());
        let fault = Fault::new(reader.place(&across.path), &across.path, message);
        reader.fault(fault.help(WrongChain::GiveBreadthToo));
    }
    let (length, centroid) = (length?, centroid?);
    if centroid.value > length.value {
        let path = &centroid.path;
        let message = WrongChain::LiesAboveLinkS {
            path: path.to_string(),
            written: centroid.written.to_string(),
        };
        let top = reader.echo(length.value, Measure::Length);
        let (number, unit) = top.split_once(' ').unwrap_or((&top, ""));
        let fault = Fault::new(reader.place(path), path, message)
            .allowed(WrongChain::MustBeToLink {
                number: number.to_string(),
                unit: unit.to_string(),
            })
            .help(WrongChain::CentroidIsMeasuredFrom);
        reader.fault(fault);
    }
    Some(LinkPart {
        name: link.name.clone(),
        heaviness: heaviness?,
        length,
        centroid,
        inertia,
        inertia_across,
        breadth,
        depth,
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
    let stiffness_across = of(
        &raw.value.stiffness_across,
        "stiffness_across",
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
    let bed_depth = of(
        &raw.value.bed_depth,
        "bed_depth",
        Measure::Length,
        Bound::Positive,
    );
    let strength = of(&raw.value.strength, "strength", Measure::Stress, Bound::Positive);
    let friction = joint_friction(reader, &raw.value, path);
    let opening = raw.value.opening.as_ref().map(|opening| match opening.value {
        OpeningRaw::Edge => JointOpening::AtBedEdge,
        OpeningRaw::Held => JointOpening::Held,
    });
    let joint = stiffness.map(|stiffness| JointPart {
        stiffness,
        stiffness_across,
        damping,
        bed_depth,
        strength,
        opening,
        friction,
    });
    (joint, bed_width)
}

pub(crate) fn chain(reader: &mut Reader, raw: &FileRaw, gravity_m_s2: f64) -> Option<ChainPart> {
    let links_raw = raw.links.as_ref();
    if links_raw.is_none() {
        missing(
            reader,
            "links",
            WrongChain::ChainNeedsLinks,
            WrongChain::LinksWeightLengthCentroid,
        );
    }
    if raw.joints.is_none() {
        missing(
            reader,
            "joints",
            WrongChain::ChainNeedsJoints,
            WrongChain::WriteJointsUnknownIf,
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
            OrUnknown::Unknown | OrUnknown::Identified(_) => {
                reader.mark("joints", &joints.span);
                Some(None)
            }
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
        reader.warn(WarningKind::CapLeftOut, "cap", Warned::CapLeftOut);
    }
    let side_supports = side_supports(reader, raw.side_supports.as_deref(), &links);
    let joints = joints?;
    edges_known(reader, &links, joints.as_deref());
    let damping_ratio = chain_damping(reader, raw.damping_ratio.as_ref(), joints.as_deref());
    let part = ChainPart {
        links,
        joints,
        sought: sought(raw.joints.as_ref()),
        cap,
        damping_ratio,
        stone: stone(reader, raw.stone.as_ref()).map(Box::new),
        soil: soil_under_footing(reader, raw.soil.as_ref()).map(Box::new),
        side_supports: side_supports?,
        gravity_m_s2,
        lean: None,
        takes_no_tilt: false,
    };
    beds_bear(reader, &part);
    shafts_are_shafts(reader, &part);
    Some(part)
}

/// Requires the width of the bed for a joint that opens at its edge.
fn edges_known(reader: &mut Reader, links: &[LinkPart], joints: Option<&[JointPart]>) {
    for (i, (link, joint)) in links.iter().zip(joints.unwrap_or_default()).enumerate() {
        if joint.opening == Some(JointOpening::AtBedEdge) && link.bed_width.is_none() {
            let path = format!("joints[{}].opening", i + 1);
            let message = WrongChain::EdgeButWidthOf(path.to_string());
            let fault = Fault::new(reader.place(&joint.stiffness.path), &path, message);
            reader.fault(fault.help(WrongChain::GiveBedWidthThere));
        }
    }
}

fn give_bed_width(reader: &mut Reader, link: &mut LinkPart, width: Quantity) {
    if let Some(given) = &link.bed_width {
        let message = WrongChain::IsSameBedAs {
            path: width.path.to_string(),
            other: given.path.to_string(),
        };
        let fault = Fault::new(reader.place(&width.path), &width.path, message);
        reader.fault(fault.allowed(WrongChain::GivenTwice).help(Common::KeepOneOfThem));
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
        let links = rods.join(", ");
        reader.warn(WarningKind::ThinRod, "links", Warned::ThinRods { links });
    }
}
