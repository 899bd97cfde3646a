//! Reads stacks.

use super::attached::masts_on_top;
use super::bed::bed;
use super::block::block;
use super::body::{MayBeGround, block_index, body, names};
use super::file::{BlockRaw, ContactRaw, SideSupportRaw, SupportMovementRaw, TieRaw};
use super::loose::refuse_of_loose;
use super::made::{arch_part, wall_part};
use super::made_part::MadePart;
use super::made_towers::{tower_part, trilithon_part};
use super::made_vaults::{dome_part, vault_part};
use super::pagoda::pagoda;
use super::part::{
    BedPart, BlockPart, ContactPart, SideSupportPart, StackPart, SupportMovementPart, TiePart,
};
use super::shape::MeshContact;
use crate::content::WarningKind;
use crate::direction_vector::direction_vector;
use crate::error::Fault;
use crate::file::FileRaw;
use crate::file_number::{At, QuantityRaw};
use crate::measure::{Bound, Measure};
use crate::needed::{countable, lengths, listed, missing};
use crate::reader::Reader;
use crate::soil::soil_below;
use crate::warned::Warned;
use crate::wrong::WrongStack;
use dolmen_words::message::Both;
use std::ops::Range;

/// The generator of the blocks, if exactly one is given.
fn makers(reader: &mut Reader, raw: &FileRaw) -> Option<Vec<Both>> {
    let makers: Vec<Both> = [
        raw.blocks.as_ref().map(|_| Both::from("blocks")),
        raw.pagoda.as_ref().map(|_| WrongStack::PagodaOther.into()),
        raw.arch.as_ref().map(|_| WrongStack::Arch.into()),
        raw.wall.as_ref().map(|_| WrongStack::Wall.into()),
        raw.tower.as_ref().map(|_| WrongStack::Tower.into()),
        raw.trilithon.as_ref().map(|_| WrongStack::Trilithon.into()),
        raw.vault.as_ref().map(|_| WrongStack::Vault.into()),
        raw.dome.as_ref().map(|_| WrongStack::Dome.into()),
    ]
    .into_iter()
    .flatten()
    .collect();
    if let [first, second, ..] = &makers[..] {
        let (first, second) = (first.clone(), second.clone());
        let spans = [
            ("blocks", raw.blocks.as_ref().map(|of| of.span.clone())),
            ("pagoda", raw.pagoda.as_ref().map(|of| of.span.clone())),
            ("arch", raw.arch.as_ref().map(|of| of.span.clone())),
            ("wall", raw.wall.as_ref().map(|of| of.span.clone())),
            ("tower", raw.tower.as_ref().map(|of| of.span.clone())),
            ("trilithon", raw.trilithon.as_ref().map(|of| of.span.clone())),
            ("vault", raw.vault.as_ref().map(|of| of.span.clone())),
            ("dome", raw.dome.as_ref().map(|of| of.span.clone())),
        ];
        let mut given = spans.into_iter().filter_map(|(path, span)| Some((path, span?)));
        let (path, span) = given.next().unwrap_or(("blocks", 0..0));
        let fault = Fault::new(
            span,
            path,
            WrongStack::FileHasBothAnd {
                first,
                second: second.clone(),
            },
        );
        reader.fault(fault.help(WrongStack::KeepOneOfThemMakes { second }));
        return None;
    }
    Some(makers)
}

/// The stones of an arch, a wall or another generated structure, and their names; `None` if the file lists blocks or has a pagoda.
fn stones_made(reader: &mut Reader, raw: &FileRaw) -> Option<Option<(MadePart, Vec<String>)>> {
    Some(if let Some(dimensions) = &raw.arch {
        arch_part(reader, dimensions).map(|(part, names)| (MadePart::Arch(Box::new(part)), names))
    } else if let Some(dimensions) = &raw.wall {
        wall_part(reader, dimensions).map(|(part, names)| (MadePart::Wall(Box::new(part)), names))
    } else if let Some(dimensions) = &raw.tower {
        tower_part(reader, dimensions).map(|(part, names)| (MadePart::Tower(Box::new(part)), names))
    } else if let Some(dimensions) = &raw.trilithon {
        trilithon_part(reader, dimensions).map(|(part, names)| (MadePart::Trilithon(Box::new(part)), names))
    } else if let Some(dimensions) = &raw.vault {
        vault_part(reader, dimensions).map(|(part, names)| (MadePart::Vault(Box::new(part)), names))
    } else if let Some(dimensions) = &raw.dome {
        dome_part(reader, dimensions).map(|(part, names)| (MadePart::Dome(Box::new(part)), names))
    } else {
        return None;
    })
}

pub(crate) fn stack(reader: &mut Reader, raw: &FileRaw, gravity_m_s2: f64) -> Option<StackPart> {
    let makers = makers(reader, raw)?;
    let mut list: &[At<BlockRaw>] = &[];
    let (mut pagoda_part, mut made, mut made_names) = (None, None, None);
    if let Some(given) = &raw.blocks {
        if !countable(reader, given, "blocks") {
            return None;
        }
        reader.mark("blocks", &given.span);
        list = given.value.as_slice();
    } else if let Some(factors) = &raw.pagoda {
        let (part, names) = pagoda(reader, factors)?;
        (pagoda_part, made_names) = (Some(part), Some(names));
    } else if let Some(found) = stones_made(reader, raw) {
        let (part, names) = found?;
        (made, made_names) = (Some(part), Some(names));
    } else {
        let help = WrongStack::BlocksNameBaseWidth;
        missing(reader, "blocks", WrongStack::StackNeedsBlocks, help);
        return None;
    }
    let density = reader.quantity(raw.density.as_ref(), "density", Measure::Density, Bound::Positive);
    let joint = bed(reader, raw.joint.as_ref(), "joint");
    let names = match made_names {
        Some(names) => names,
        None => names(reader, list),
    };
    let is_loose = raw.loose.as_ref().is_some_and(|given| given.value);
    let meshes = match is_loose {
        true => MeshContact::Hull,
        false => MeshContact::Beds,
    };
    let blocks: Vec<Option<BlockPart>> = (list.iter().enumerate())
        .map(|(i, raw)| block(reader, raw, i, &names, meshes))
        .collect();
    if density.is_none() && !reader.is_reported("density") {
        without_density(reader, list);
        if list.is_empty() {
            let help = WrongStack::WriteDensityAtTop;
            let what = WrongStack::StonesOfNeedDensity {
                makers: makers.clone(),
            };
            missing(reader, "density", what, help);
        }
    }
    masts_on_top(reader, list, &blocks);
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
    let support_movement = listed(
        reader,
        raw.support_movement.as_deref(),
        "support_movement",
        |reader, raw, path| support_movement(reader, raw, path, &names),
    );
    let stack = StackPart {
        blocks: blocks.into_iter().collect::<Option<_>>()?,
        pagoda: pagoda_part,
        made,
        is_loose,
        density,
        joint: joint?,
        contacts: contacts?,
        ties: ties?,
        side_supports: side_supports?,
        support_movement: support_movement?,
        static_loads: Vec::new(),
        lost_beds: Vec::new(),
        loosened_beds: Vec::new(),
        soil: soil_below(reader, raw.soil.as_ref()),
        lean: None,
        gravity_m_s2,
    };
    if is_loose && !refuse_of_loose(reader, raw, &stack) {
        return None;
    }
    if let Some(block) = stack.ring() {
        reader.fault(stands_on_itself(&stack, block, list[block].span.clone()));
        return None;
    }
    warn_of_defaults(reader, &stack);
    Some(stack)
}

/// The fault of a block that stands on itself through other blocks.
fn stands_on_itself(stack: &StackPart, block: usize, at: Range<usize>) -> Fault {
    let path = format!("blocks[{}].on", block + 1);
    let message = WrongStack::StandsOverBlocksBelow {
        path: path.clone(),
        name: stack.blocks[block].name.clone(),
    };
    Fault::new(at, &path, message).help(WrongStack::LetOneOfThem)
}

/// Reports blocks without a density where the stack has none either.
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
        0 => Both::from(""),
        others => Both::from(WrongStack::NorHaveMoreBlocks {
            others: others.to_string(),
        }),
    };
    let message = WrongStack::BlocksHasNoDensity {
        first: (first + 1).to_string(),
        others,
    };
    let fault = Fault::new(block.span.clone(), &path, message);
    reader.fault(fault.help(WrongStack::WriteDensityAtTopLevel));
}

fn contact(reader: &mut Reader, raw: &At<ContactRaw>, path: &str, names: &[String]) -> Option<ContactPart> {
    let lower = raw.value.lower.as_ref().and_then(|name| {
        let path = format!("{path}.lower");
        body(reader, &name.value, (&name.span, &path), names, MayBeGround::Yes)
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
        body(reader, &name.value, (&name.span, &path), names, MayBeGround::Yes)
    });
    let upper = block_index(reader, tie.upper.as_ref(), &format!("{path}.upper"), names);
    let position_path = format!("{path}.position");
    let position = tie
        .position
        .as_ref()
        .and_then(|raw| lengths(reader, raw, &position_path, "[x, y, z]"));
    let axis = match &tie.axis {
        Some(axis) => direction_vector(reader, axis, &format!("{path}.axis")),
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
    if support.height.is_some() {
        let key = format!("{path}.height");
        let fault = Fault::new(
            reader.place(path),
            &key,
            WrongStack::SupportOfChain { path: key.clone() },
        );
        reader.fault(fault.help(WrongStack::SupportHasPosition));
        return None;
    }
    let block = block_index(reader, support.block.as_ref(), &format!("{path}.block"), names);
    let position_path = format!("{path}.position");
    let position = support
        .position
        .as_ref()
        .and_then(|raw| lengths(reader, raw, &position_path, "[x, y, z]"));
    let direction = support
        .direction
        .as_ref()
        .and_then(|raw| direction_vector(reader, raw, &format!("{path}.direction")));
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

fn support_movement(
    reader: &mut Reader,
    raw: &At<SupportMovementRaw>,
    path: &str,
    names: &[String],
) -> Option<SupportMovementPart> {
    let given = &raw.value;
    let block = block_index(reader, given.on.as_ref(), &format!("{path}.on"), names);
    let before = reader.faults.len();
    let parts = [(&given.x, "x"), (&given.y, "y"), (&given.z, "z")];
    let movement = parts.map(|(part, key)| {
        reader.quantity(
            part.as_ref(),
            &format!("{path}.{key}"),
            Measure::Length,
            Bound::Any,
        )
    });
    (reader.faults.len() == before).then_some(())?;
    let moves = movement.iter().flatten().any(|part| part.value != 0.0);
    if !moves {
        let message = WrongStack::SupportStaysWhereItIs {
            path: path.to_string(),
        };
        let fault = Fault::new(raw.span.clone(), path, message);
        reader.fault(fault.help(WrongStack::WriteHowFarGroundMoves));
        return None;
    }
    Some(SupportMovementPart {
        block: block?,
        movement,
    })
}

/// Warns of the values of joints for which Dolmen's defaults are used.
fn warn_of_defaults(reader: &mut Reader, stack: &StackPart) {
    let joint = &stack.joint;
    let (normal, shear) = match stack.is_loose {
        true => ("normal_stiffness 1e11 Pa/m", "shear_stiffness 4e10 Pa/m"),
        false => ("normal_stiffness 1e9 Pa/m", "shear_stiffness 4e8 Pa/m"),
    };
    let each = [
        (&joint.friction, "friction 0.6"),
        (&joint.normal_stiffness, normal),
        (&joint.shear_stiffness, shear),
        (&joint.damping_ratio, "damping_ratio 0.3"),
    ];
    let taken: Vec<&str> = each
        .iter()
        .filter(|(given, _)| given.is_none())
        .map(|(_, taken)| *taken)
        .collect();
    if !taken.is_empty() {
        let taken = taken.join(", ");
        let path = if joint == &BedPart::default() {
            stack.made_by()
        } else {
            "joint"
        };
        reader.warn(WarningKind::JointDefaults, path, Warned::JointDefaults { taken });
    }
}
