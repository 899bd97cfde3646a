//! Compares readings of two surveys other than vibration: tilts and inspections.

use dolmen_project::{DamageKind, Inspection, Project, Quantity, Survey, Tilt};

/// Readings of two surveys, side by side.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ComparedReadings {
    /// Tilts along directions in both surveys.
    pub tilts: Vec<ComparedTilt>,
    /// Directions of tilt in only one of them.
    pub tilts_of_one: Vec<String>,
    /// Whether the two surveys name different marks as their datum, so that tilts do not compare.
    pub other_datum: bool,
    /// Damage in inspections; empty unless both surveys have an inspection.
    pub items: Vec<ComparedItem>,
    /// The surveys, of the two, without modes and records.
    pub without_modes: Vec<String>,
}

/// A tilt in two surveys.
#[derive(Clone, Debug, PartialEq)]
pub struct ComparedTilt {
    /// Its direction.
    pub direction: String,
    /// In the survey before.
    pub from: Tilt,
    /// In the survey after.
    pub to: Tilt,
}

impl ComparedTilt {
    /// Change of the tilt, horizontal / vertical.
    pub fn change(&self) -> f64 {
        self.to.ratio - self.from.ratio
    }

    /// Whether it leans more than before, or to the opposite side.
    pub fn has_grown(&self) -> bool {
        self.to.ratio.abs() > self.from.ratio.abs() || self.to.ratio * self.from.ratio < 0.0
    }
}

/// Damage of one kind at one part in two inspections.
#[derive(Clone, Debug, PartialEq)]
pub struct ComparedItem {
    /// The part.
    pub part: String,
    /// Its kind.
    pub what: DamageKind,
    /// Its name, if the inspections give one.
    pub name: Option<String>,
    /// Its course.
    pub course: ItemCourse,
}

/// Course of a damage from one inspection to another.
#[derive(Clone, Debug, PartialEq)]
pub enum ItemCourse {
    /// New: only the later inspection has it.
    New {
        /// Its size, if given.
        size: Option<Quantity>,
    },
    /// Only the earlier inspection has it: repaired, or not looked for.
    NotFoundAgain,
    /// Both have it with a size.
    Sized {
        /// Before.
        from: Quantity,
        /// After.
        to: Quantity,
    },
    /// Both have it, one without a size.
    NoSize,
    /// One of the inspections has several of this kind at the part, so they cannot be paired.
    Several {
        /// In the inspection before.
        before: usize,
        /// Number in the later inspection.
        after: usize,
    },
}

impl ItemCourse {
    /// Whether it is worse than before.
    pub fn is_worse(&self) -> bool {
        match self {
            ItemCourse::New { .. } => true,
            ItemCourse::Sized { from, to } => to.value > from.value,
            ItemCourse::Several { before, after } => after > before,
            ItemCourse::NotFoundAgain | ItemCourse::NoSize => false,
        }
    }
}

/// The readings of two surveys of a project, by index.
pub(crate) fn compared_readings(project: &Project, from: usize, to: usize) -> ComparedReadings {
    let (before, after) = (&project.surveys[from], &project.surveys[to]);
    let tilts = before.tilt.iter().filter_map(|(direction, tilt)| {
        Some(ComparedTilt {
            direction: direction.clone(),
            from: tilt.clone(),
            to: after.tilt.get(direction)?.clone(),
        })
    });
    let of_one = |a: &Survey, b: &Survey| -> Vec<String> {
        let only = a.tilt.keys().filter(|direction| !b.tilt.contains_key(*direction));
        only.cloned().collect()
    };
    let without = [before, after].into_iter().filter(|survey| !has_modes(survey));
    ComparedReadings {
        tilts: tilts.collect(),
        tilts_of_one: [of_one(before, after), of_one(after, before)].concat(),
        other_datum: matches!((&before.datum, &after.datum), (Some(a), Some(b)) if a != b),
        items: items(&before.inspections, &after.inspections),
        without_modes: without.map(|survey| survey.name.clone()).collect(),
    }
}

/// Key of a damage.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct DamageKey<'a> {
    pub(crate) part: &'a str,
    pub(crate) what: &'a DamageKind,
    pub(crate) name: Option<&'a str>,
}

impl<'a> DamageKey<'a> {
    pub(crate) fn of(item: &'a Inspection) -> Self {
        DamageKey {
            part: &item.part,
            what: &item.what,
            name: item.name.as_deref(),
        }
    }
}

/// Whether a survey has modes, or records to find them in.
pub(crate) fn has_modes(survey: &Survey) -> bool {
    survey.records.is_some()
        || !survey.setups.is_empty()
        || survey.modes.values().any(|modes| !modes.is_empty())
}

/// Damage by part, kind and name, in the order of the later inspection, then damage not found again.
fn items(before: &[Inspection], after: &[Inspection]) -> Vec<ComparedItem> {
    if before.is_empty() || after.is_empty() {
        return Vec::new();
    }
    let mut keys: Vec<DamageKey<'_>> = Vec::new();
    for item in after.iter().chain(before) {
        let key = DamageKey::of(item);
        if !keys.contains(&key) {
            keys.push(key);
        }
    }
    let of = |all: &[Inspection], key: DamageKey<'_>| -> Vec<Option<Quantity>> {
        let same = all.iter().filter(|item| DamageKey::of(item) == key);
        same.map(|item| item.size.clone()).collect()
    };
    let course = |key| match (of(before, key).as_slice(), of(after, key).as_slice()) {
        ([], [size]) => ItemCourse::New { size: size.clone() },
        ([_], []) => ItemCourse::NotFoundAgain,
        ([Some(from)], [Some(to)]) => ItemCourse::Sized {
            from: from.clone(),
            to: to.clone(),
        },
        ([_], [_]) => ItemCourse::NoSize,
        (before, after) => ItemCourse::Several {
            before: before.len(),
            after: after.len(),
        },
    };
    let each = keys.into_iter().map(|key| ComparedItem {
        part: key.part.to_owned(),
        what: key.what.clone(),
        name: key.name.map(str::to_owned),
        course: course(key),
    });
    each.collect()
}
