//! Arches and walls: from their keys, and to the stones that the library makes.

use super::file::{ArchRaw, StoneWallRaw, WallOpeningRaw};
use super::made_part::{ArchPart, StoneWallPart, WallOpeningPart};
use crate::error::Fault;
use crate::file_number::{At, QuantityRaw};
use crate::measure::{Bound, Measure};
use crate::needed::listed;
use crate::quantity::{Pick, Quantity};
use crate::reader::Reader;
use crate::wrong::{WrongStack, said};
use dolmen::structure::stack::{ArchFactors, Block, StackError, WallFactors, WallOpening, arch, wall};

/// Most voussoirs, as in the library.
const VOUSSOIRS_MOST: usize = 400;
/// Most courses, as in the library.
const COURSES_MOST: usize = 100;
/// Most leaves, as in the library.
const LEAVES_MOST: usize = 3;
/// Default core between leaves over the thickness of the wall. Our choice.
const CORE: f64 = 0.1;
/// Default bearing of a lintel over the clear width. Our choice.
const BEARING: f64 = 0.25;
/// A density to try the dimensions with, kg/m³: names and sizes do not depend on it.
pub(super) const ANY_DENSITY_KG_M3: f64 = 2600.0;
/// Default width of an abutment over the thickness of the arch. Our choice.
pub(super) const ABUTMENT: f64 = 2.0;

/// An arch and the names of its stones; impossible dimensions are rejected here.
pub(super) fn arch_part(reader: &mut Reader, raw: &At<ArchRaw>) -> Option<(ArchPart, Vec<String>)> {
    reader.mark("arch", &raw.span);
    let before = reader.faults.len();
    let given = &raw.value;
    let voussoirs = reader.count(given.voussoirs.as_ref(), "arch.voussoirs", 2, VOUSSOIRS_MOST);
    let mut of = |raw, key: &str, bound| reader.quantity(raw, &format!("arch.{key}"), Measure::Length, bound);
    let span = of(given.span.as_ref(), "span", Bound::Positive);
    let rise = of(given.rise.as_ref(), "rise", Bound::Positive);
    let thickness = of(given.thickness.as_ref(), "thickness", Bound::Positive);
    let depth = of(given.depth.as_ref(), "depth", Bound::Positive);
    let springing_height = of(
        given.springing_height.as_ref(),
        "springing_height",
        Bound::NotNegative,
    );
    let abutment = of(given.abutment.as_ref(), "abutment", Bound::Positive);
    (reader.faults.len() == before).then_some(())?;
    let part = ArchPart {
        span: span?,
        rise,
        thickness: thickness?,
        depth: depth?,
        voussoirs: voussoirs.and_then(|count| u32::try_from(count).ok())?,
        springing_height,
        abutment,
    };
    let made = part.made(ANY_DENSITY_KG_M3, &mut Quantity::nominal);
    let names = tried(reader, raw.span.clone(), "arch", made)?;
    Some((part, names))
}

/// A wall and the names of its stones.
pub(super) fn wall_part(reader: &mut Reader, raw: &At<StoneWallRaw>) -> Option<(StoneWallPart, Vec<String>)> {
    reader.mark("wall", &raw.span);
    let before = reader.faults.len();
    let given = &raw.value;
    let courses = reader.count(given.courses.as_ref(), "wall.courses", 1, COURSES_MOST);
    let mut of =
        |raw, key: &str| reader.quantity(raw, &format!("wall.{key}"), Measure::Length, Bound::Positive);
    let length = of(given.length.as_ref(), "length");
    let thickness = of(given.thickness.as_ref(), "thickness");
    let course_height = of(given.course_height.as_ref(), "course_height");
    let stone_length = of(given.stone_length.as_ref(), "stone_length");
    let core = of(given.core.as_ref(), "core");
    let small = |count: Option<usize>| count.and_then(|count| u32::try_from(count).ok());
    let leaves = small(reader.count(given.leaves.as_ref(), "wall.leaves", 1, LEAVES_MOST));
    let through = given.through_every.as_ref();
    // a higher wall would have no through stone
    let through_every =
        small(reader.count(through, "wall.through_every", 1, courses.unwrap_or(COURSES_MOST)));
    let openings = listed(
        reader,
        given.openings.as_deref(),
        "wall.openings",
        |reader, raw, path| opening_part(reader, &raw.value, path),
    );
    (reader.faults.len() == before).then_some(())?;
    let part = StoneWallPart {
        length: length?,
        thickness: thickness?,
        courses: courses.and_then(|count| u32::try_from(count).ok())?,
        course_height: course_height?,
        stone_length: stone_length?,
        leaves: leaves.unwrap_or(1),
        core,
        through_every,
        openings: openings?,
    };
    let made = part.made(ANY_DENSITY_KG_M3, &mut Quantity::nominal);
    let names = tried(reader, raw.span.clone(), "wall", made)?;
    Some((part, names))
}

fn opening_part(reader: &mut Reader, raw: &WallOpeningRaw, path: &str) -> Option<WallOpeningPart> {
    let before = reader.faults.len();
    let mut of = |raw: &Option<At<QuantityRaw>>, key: &str, bound| {
        reader.quantity(raw.as_ref(), &format!("{path}.{key}"), Measure::Length, bound)
    };
    let from = of(&raw.from, "from", Bound::NotNegative);
    let width = of(&raw.width, "width", Bound::Positive);
    let bearing = of(&raw.bearing, "bearing", Bound::Positive);
    let mut count = |raw: &Option<At<i64>>, key: &str| {
        let count = reader.count(raw.as_ref(), &format!("{path}.{key}"), 1, COURSES_MOST)?;
        u32::try_from(count).ok()
    };
    let first_course = count(&raw.first_course, "first_course");
    let courses = count(&raw.courses, "courses");
    (reader.faults.len() == before).then_some(())?;
    Some(WallOpeningPart {
        from: from?,
        width: width?,
        first_course: first_course.unwrap_or(1),
        courses: courses?,
        bearing,
    })
}

/// The names of the stones, or the fault at the key that the library's error names.
pub(super) fn tried(
    reader: &mut Reader,
    span: std::ops::Range<usize>,
    kind: &str,
    made: Result<Vec<Block>, StackError>,
) -> Option<Vec<String>> {
    let why = match made {
        Ok(blocks) => return Some(blocks.into_iter().map(|block| block.name).collect()),
        Err(why) => why,
    };
    let path = match &why {
        StackError::Dimension { quantity, .. } => {
            let key = quantity.split('.').next().unwrap_or(quantity);
            format!("{kind}.{}", key.trim_end_matches("_m"))
        }
        _ => kind.to_owned(),
    };
    let place = match reader.place(&path) {
        none if none.is_empty() => span, // a default that does not go with the others
        place => place,
    };
    let message = WrongStack::CannotBeMade {
        kind: kind.to_owned(),
        why: said(&why),
    };
    reader.fault(Fault::new(place, &path, message));
    None
}

impl ArchPart {
    /// Its stones, each dimension with the value that `pick` chooses.
    ///
    /// # Errors
    /// [`StackError`] for impossible dimensions.
    pub fn made(&self, density_kg_m3: f64, pick: Pick<'_>) -> Result<Vec<Block>, StackError> {
        let (span_m, thickness_m) = (pick(&self.span), pick(&self.thickness));
        arch(&ArchFactors {
            span_m,
            rise_m: self.rise.as_ref().map_or(0.5 * span_m, &mut *pick),
            thickness_m,
            depth_m: pick(&self.depth),
            voussoirs: self.voussoirs,
            springing_height_m: self.springing_height.as_ref().map_or(0.0, &mut *pick),
            abutment_m: self.abutment.as_ref().map_or(ABUTMENT * thickness_m, &mut *pick),
            density_kg_m3,
        })
    }

    pub(super) fn inputs<'a>(&'a self, all: &mut Vec<&'a Quantity>) {
        all.push(&self.span);
        all.extend(&self.rise);
        all.extend([&self.thickness, &self.depth]);
        all.extend(&self.springing_height);
        all.extend(&self.abutment);
    }
}

impl StoneWallPart {
    /// Its stones, each dimension with the value that `pick` chooses.
    ///
    /// # Errors
    /// [`StackError`] for impossible dimensions.
    pub fn made(&self, density_kg_m3: f64, pick: Pick<'_>) -> Result<Vec<Block>, StackError> {
        let thickness_m = pick(&self.thickness);
        wall(&WallFactors {
            length_m: pick(&self.length),
            thickness_m,
            courses: self.courses,
            course_height_m: pick(&self.course_height),
            stone_length_m: pick(&self.stone_length),
            leaves: self.leaves,
            core_m: self.core.as_ref().map_or(CORE * thickness_m, &mut *pick),
            through_every: self.through_every,
            openings: self.openings.iter().map(|of| of.made(pick)).collect(),
            density_kg_m3,
        })
    }

    pub(super) fn inputs<'a>(&'a self, all: &mut Vec<&'a Quantity>) {
        all.extend([
            &self.length,
            &self.thickness,
            &self.course_height,
            &self.stone_length,
        ]);
        all.extend(&self.core);
        for opening in &self.openings {
            all.extend([&opening.from, &opening.width]);
            all.extend(&opening.bearing);
        }
    }
}

impl WallOpeningPart {
    fn made(&self, pick: Pick<'_>) -> WallOpening {
        let width_m = pick(&self.width);
        WallOpening {
            from_m: pick(&self.from),
            width_m,
            first_course: self.first_course,
            courses: self.courses,
            bearing_m: self.bearing.as_ref().map_or(BEARING * width_m, &mut *pick),
        }
    }
}
