//! Findings of the inspections in a file, and their damage in the model.

use super::buildable::buildable;
use super::content::Structure;
use super::damage::{Damaged, damaged};
use super::file::FileRaw;
use super::reader::Reader;
use super::report::PartNames;
use super::survey::{Survey, add_inspections};

/// The result of the inspections in a file.
pub(super) struct OfInspections {
    /// The parts that inspections and the report may name.
    pub(super) parts: PartNames,
    /// The damage in the model.
    pub(super) damage: Damaged,
}

/// Puts the findings of inspections into their surveys, and their damage into the structure.
pub(super) fn of_inspections(
    reader: &mut Reader,
    raw: &FileRaw,
    surveys: &mut [Survey],
    mut structure: Option<&mut Structure>,
) -> OfInspections {
    // a stack is built for its names only where an inspection or the report names parts
    let inspected = raw
        .survey
        .iter()
        .flatten()
        .any(|(_, survey)| survey.value.has_inspections());
    let parts = match (raw.report.is_some() || inspected, structure.as_deref()) {
        (true, Some(structure)) => PartNames::of(structure),
        _ => PartNames::default(),
    };
    add_inspections(reader, raw.survey.as_ref(), surveys, &parts);
    let damage = damaged(
        reader,
        raw.as_inspected.as_ref(),
        surveys,
        structure.as_deref_mut(),
    );
    if !damage.damage.is_empty() {
        buildable(reader, structure);
    }
    OfInspections { parts, damage }
}
