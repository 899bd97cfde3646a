//! Stacks from what is written.

use super::content::WarningKind;
use super::error::Fault;
use super::file::FileRaw;
use super::file_number::{At, QuantityRaw};
use super::file_stack::{BedRaw, BlockRaw, ContactRaw, SideSupportRaw, TieRaw};
use super::measure::{Bound, Measure};
use super::quantity::Quantity;
use super::read_block::block;
use super::read_pagoda::pagoda;
use super::read_records::way;
use super::read_structure::{countable, missing};
use super::reader::Reader;
use super::stack::{BedPart, BlockPart, ContactPart, SideSupportPart, StackPart, TiePart};
use dolmen::structure::stack::Body;
use std::ops::Range;

/// The word for what everything stands on in the end.
pub(super) const GROUND: &str = "ground";

pub(super) fn stack(reader: &mut Reader, raw: &FileRaw, gravity_m_s2: f64) -> Option<StackPart> {
    if let (Some(list), Some(_)) = (&raw.blocks, &raw.pagoda) {
        let fault = Fault::new(
            list.span.clone(),
            "blocks",
            "the file has both blocks and a pagoda",
        );
        reader.fault(fault.help("keep one of them: a pagoda makes its own blocks"));
        return None;
    }
    let (list, made) = match (&raw.blocks, &raw.pagoda) {
        (Some(list), _) => {
            if !countable(reader, list, "blocks") {
                return None;
            }
            reader.mark("blocks", &list.span);
            (list.value.as_slice(), None)
        }
        (None, Some(factors)) => (&[] as &[At<BlockRaw>], Some(pagoda(reader, factors)?)),
        (None, None) => {
            let help = "blocks = [ { name = \"base\", width = …, height = … }, … ], lowest first; or pagoda = { storeys = 3, … }";
            missing(reader, "blocks", "a stack needs blocks", help);
            return None;
        }
    };
    let density = reader.quantity(raw.density.as_ref(), "density", Measure::Density, Bound::Positive);
    let joint = bed(reader, raw.joint.as_ref(), "joint");
    let (pagoda, names) = match made {
        Some((part, names)) => (Some(part), names),
        None => (None, names(reader, list)),
    };
    let numbered = list.iter().enumerate();
    let blocks: Vec<Option<BlockPart>> = numbered.map(|(i, raw)| block(reader, raw, i, &names)).collect();
    if density.is_none() && !reader.is_reported("density") {
        without_density(reader, list);
        if pagoda.is_some() {
            let help = "write density = 2600 at the top level (granite, kg/m3)";
            missing(reader, "density", "the stones of a pagoda need a density", help);
        }
    }
    let contacts = listed(
        reader,
        raw.contacts.as_deref(),
        "contacts",
        |reader, raw, path| contact(reader, raw, path, &names),
    );
    let ties = listed(reader, raw.ties.as_deref(), "ties", |reader, raw, path| {
        tie(reader, raw, path, &names)
    });
    let side_supports = listed(
        reader,
        raw.side_supports.as_deref(),
        "side_supports",
        |reader, raw, path| side_support(reader, raw, path, &names),
    );
    let stack = StackPart {
        blocks: blocks.into_iter().collect::<Option<_>>()?,
        pagoda,
        density,
        joint: joint?,
        contacts: contacts?,
        ties: ties?,
        side_supports: side_supports?,
        gravity_m_s2,
    };
    warn_of_defaults(reader, &stack);
    Some(stack)
}

/// Reports blocks that have no density where the stack has none either.
fn without_density(reader: &mut Reader, blocks: &[At<BlockRaw>]) {
    let mut without = blocks
        .iter()
        .enumerate()
        .filter(|(_, block)| block.value.density.is_none());
    let Some((first, block)) = without.next() else {
        return;
    };
    let path = format!("blocks[{}].density", first + 1);
    let others = match without.count() {
        0 => String::new(),
        others => format!(", nor have {others} more blocks"),
    };
    let message = format!("blocks[{}] has no density{others}", first + 1);
    let fault = Fault::new(block.span.clone(), &path, message);
    reader.fault(fault.help(
        "write density = 2600 at the top level for all blocks (granite, kg/m3), or density = … in the block",
    ));
}

/// All elements of a list; `None` if one of them is wrong.
pub(super) fn listed<R, T>(
    reader: &mut Reader,
    raw: Option<&[At<R>]>,
    path: &str,
    mut read: impl FnMut(&mut Reader, &At<R>, &str) -> Option<T>,
) -> Option<Vec<T>> {
    let mut all = Vec::new();
    let mut sound = true;
    for (i, raw) in raw.unwrap_or_default().iter().enumerate() {
        let path = format!("{path}[{}]", i + 1);
        reader.mark(&path, &raw.span);
        match read(reader, raw, &path) {
            Some(one) => all.push(one),
            None => sound = false,
        }
    }
    sound.then_some(all)
}

/// The names of all blocks; one that is missing, empty or repeated is reported.
fn names(reader: &mut Reader, blocks: &[At<BlockRaw>]) -> Vec<String> {
    let mut names: Vec<String> = Vec::with_capacity(blocks.len());
    for (i, block) in blocks.iter().enumerate() {
        let path = format!("blocks[{}].name", i + 1);
        let Some(name) = &block.value.name else {
            names.push(String::new());
            continue;
        };
        let fault = |message: String| Fault::new(name.span.clone(), &path, message);
        if name.value.trim().is_empty() || name.value == GROUND {
            let fault = fault(format!("{path} = \"{}\" cannot be", name.value));
            reader.fault(fault.allowed("needs a name other than \"ground\""));
        } else if let Some(other) = names.iter().position(|other| *other == name.value) {
            let fault = fault(format!(
                "{path} = \"{}\" is also the name of blocks[{}]",
                name.value,
                other + 1
            ));
            reader.fault(
                fault
                    .allowed("must be unique")
                    .help("number them: \"body 1\", \"body 2\""),
            );
        }
        names.push(name.value.clone());
    }
    names
}

/// The body of a name among `known`; `place` says where it is written.
pub(super) fn body(
    reader: &mut Reader,
    name: &str,
    place: (&Range<usize>, &str),
    known: &[String],
    which: &str,
) -> Option<Body> {
    if name == GROUND {
        return Some(Body::Ground);
    }
    if let Some(index) = known.iter().position(|known| known == name) {
        return Some(Body::Block(index));
    }
    let (span, path) = place;
    let fault = Fault::new(span.clone(), path, format!("{path} = \"{name}\" is no {which}"));
    let scored = known
        .iter()
        .map(|known| (strsim::jaro_winkler(name, known), known));
    let near = scored.max_by(|a, b| a.0.total_cmp(&b.0));
    let help = match near {
        Some((score, near)) if score >= super::check::SIMILARITY_LEAST => format!("did you mean \"{near}\"?"),
        _ => format!("write the name of a block as it stands in blocks, or \"{GROUND}\""),
    };
    reader.fault(fault.allowed("unknown name").help(help));
    None
}

/// The index of a block by its name.
fn block_index(
    reader: &mut Reader,
    name: Option<&At<String>>,
    path: &str,
    known: &[String],
) -> Option<usize> {
    let name = name?;
    match body(reader, &name.value, (&name.span, path), known, "block")? {
        Body::Block(index) => Some(index),
        Body::Ground => {
            let fault = Fault::new(name.span.clone(), path, format!("{path} is \"{GROUND}\""));
            reader.fault(fault.allowed("must be the name of a block"));
            None
        }
    }
}

/// As many lengths as a place has; `as_written` shows how.
pub(super) fn lengths<const N: usize>(
    reader: &mut Reader,
    raw: &At<Vec<At<QuantityRaw>>>,
    path: &str,
    as_written: &str,
) -> Option<[Quantity; N]> {
    if raw.value.len() != N {
        let message = format!("{path} has {} numbers", raw.value.len());
        let fault = Fault::new(raw.span.clone(), path, message);
        reader.fault(fault.allowed(format!("must be {N}: {as_written}")));
        return None;
    }
    let mut all = Vec::with_capacity(N);
    for (i, raw) in raw.value.iter().enumerate() {
        let path = format!("{path}[{}]", i + 1);
        all.extend(reader.quantity(Some(raw), &path, Measure::Length, Bound::Any));
    }
    all.try_into().ok()
}

pub(super) fn bed(reader: &mut Reader, raw: Option<&At<BedRaw>>, path: &str) -> Option<BedPart> {
    let Some(raw) = raw else {
        return Some(BedPart::default());
    };
    reader.mark(path, &raw.span);
    let before = reader.faults.len();
    let mut of = |raw: &Option<At<QuantityRaw>>, key: &str, measure, bound| {
        reader.quantity(raw.as_ref(), &format!("{path}.{key}"), measure, bound)
    };
    let (zero, above) = (Bound::NotNegative, Bound::Positive);
    let bed = &raw.value;
    let read = BedPart {
        friction: of(&bed.friction, "friction", Measure::Ratio, zero),
        friction_kinetic: of(&bed.friction_kinetic, "friction_kinetic", Measure::Ratio, zero),
        cohesion: of(&bed.cohesion, "cohesion", Measure::Stress, zero),
        tension: of(&bed.tension, "tension", Measure::Stress, zero),
        normal_stiffness: of(
            &bed.normal_stiffness,
            "normal_stiffness",
            Measure::BedStiffness,
            above,
        ),
        shear_stiffness: of(
            &bed.shear_stiffness,
            "shear_stiffness",
            Measure::BedStiffness,
            above,
        ),
        damping_ratio: of(&bed.damping_ratio, "damping_ratio", Measure::Ratio, zero),
        restitution: of(&bed.restitution, "restitution", Measure::Ratio, zero),
    };
    (reader.faults.len() == before).then_some(read)
}

fn contact(reader: &mut Reader, raw: &At<ContactRaw>, path: &str, names: &[String]) -> Option<ContactPart> {
    let lower = raw.value.lower.as_ref().and_then(|name| {
        let path = format!("{path}.lower");
        body(reader, &name.value, (&name.span, &path), names, "block")
    });
    let upper = block_index(reader, raw.value.upper.as_ref(), &format!("{path}.upper"), names);
    let joint = bed(reader, raw.value.joint.as_ref(), &format!("{path}.joint"));
    Some(ContactPart {
        lower: lower?,
        upper: upper?,
        joint: joint?,
    })
}

fn tie(reader: &mut Reader, raw: &At<TieRaw>, path: &str, names: &[String]) -> Option<TiePart> {
    let tie = &raw.value;
    let lower = tie.lower.as_ref().and_then(|name| {
        let path = format!("{path}.lower");
        body(reader, &name.value, (&name.span, &path), names, "block")
    });
    let upper = block_index(reader, tie.upper.as_ref(), &format!("{path}.upper"), names);
    let position_path = format!("{path}.position");
    let position = tie
        .position
        .as_ref()
        .and_then(|raw| lengths(reader, raw, &position_path, "[x, y, z]"));
    let axis = match &tie.axis {
        Some(axis) => way(reader, axis, &format!("{path}.axis")),
        None => Some([0.0, 0.0, 1.0]),
    };
    let before = reader.faults.len();
    let mut of = |raw: &Option<At<QuantityRaw>>, key: &str, measure| {
        let path = format!("{path}.{key}");
        reader.quantity(raw.as_ref(), &path, measure, Bound::NotNegative)
    };
    let axial_stiffness = of(&tie.axial_stiffness, "axial_stiffness", Measure::StoreyStiffness);
    let shear_stiffness = of(&tie.shear_stiffness, "shear_stiffness", Measure::StoreyStiffness);
    let tension_strength = of(&tie.tension_strength, "tension_strength", Measure::Force);
    let shear_strength = of(&tie.shear_strength, "shear_strength", Measure::Force);
    (reader.faults.len() == before).then_some(())?;
    Some(TiePart {
        lower: lower?,
        upper: upper?,
        position: position?,
        axis: axis?,
        axial_stiffness,
        shear_stiffness: shear_stiffness?,
        tension_strength,
        shear_strength: shear_strength?,
    })
}

fn side_support(
    reader: &mut Reader,
    raw: &At<SideSupportRaw>,
    path: &str,
    names: &[String],
) -> Option<SideSupportPart> {
    let support = &raw.value;
    let block = block_index(reader, support.block.as_ref(), &format!("{path}.block"), names);
    let position_path = format!("{path}.position");
    let position = support
        .position
        .as_ref()
        .and_then(|raw| lengths(reader, raw, &position_path, "[x, y, z]"));
    let direction = support
        .direction
        .as_ref()
        .and_then(|raw| way(reader, raw, &format!("{path}.direction")));
    let before = reader.faults.len();
    let gap_path = format!("{path}.gap");
    let gap = reader.quantity(
        support.gap.as_ref(),
        &gap_path,
        Measure::Length,
        Bound::NotNegative,
    );
    let stiffness = reader.quantity(
        support.stiffness.as_ref(),
        &format!("{path}.stiffness"),
        Measure::StoreyStiffness,
        Bound::NotNegative,
    );
    (reader.faults.len() == before).then_some(())?;
    Some(SideSupportPart {
        block: block?,
        position: position?,
        direction: direction?,
        gap,
        stiffness: stiffness?,
    })
}

/// Says which values of the joints are Dolmen's own.
fn warn_of_defaults(reader: &mut Reader, stack: &StackPart) {
    let joint = &stack.joint;
    let each = [
        (&joint.friction, "friction 0.6"),
        (&joint.normal_stiffness, "normal_stiffness 1e9 Pa/m"),
        (&joint.shear_stiffness, "shear_stiffness 4e8 Pa/m"),
        (&joint.damping_ratio, "damping_ratio 0.3"),
    ];
    let taken: Vec<&str> = each
        .iter()
        .filter(|(given, _)| given.is_none())
        .map(|(_, taken)| *taken)
        .collect();
    if !taken.is_empty() {
        let message = format!(
            "joint does not say everything: {} {} Dolmen's own, and assumed (friction acts in the limits; stiffness and \
             damping only in motion)",
            taken.join(", "),
            if taken.len() == 1 { "is" } else { "are" }
        );
        let path = if joint == &BedPart::default() {
            if stack.pagoda.is_some() {
                "pagoda"
            } else {
                "blocks"
            }
        } else {
            "joint"
        };
        reader.warn(WarningKind::JointDefaults, path, message);
    }
}
