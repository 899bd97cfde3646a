//! Towers and trilithons: from their keys, and to the stones that the library makes.

use super::file::{TowerPlanRaw, TowerRaw, TrilithonRaw};
use super::made::{ANY_DENSITY_KG_M3, tried};
use super::made_part::{TowerPart, TowerPlanPart, TrilithonPart};
use crate::error::Fault;
use crate::file_number::At;
use crate::measure::{Bound, Measure};
use crate::quantity::{Pick, Quantity};
use crate::reader::Reader;
use crate::wrong::WrongStack;
use dolmen::structure::stack::{
    Block, StackError, TowerFactors, TowerPlan, TrilithonFactors, tower, trilithon,
};

/// Most courses, as in the library.
const COURSES_MOST: usize = 200;
/// Least and most stones of a ring in the library, also used if the number is not given. Our choice.
const STONES: (usize, usize) = (6, 48);
const STONES_USUAL: u32 = 12;

/// A tower and the names of its stones; impossible dimensions are rejected here.
pub(super) fn tower_part(reader: &mut Reader, raw: &At<TowerRaw>) -> Option<(TowerPart, Vec<String>)> {
    reader.mark("tower", &raw.span);
    let before = reader.faults.len();
    let given = &raw.value;
    let courses = reader.count(given.courses.as_ref(), "tower.courses", 1, COURSES_MOST);
    let stones = match &given.stones {
        Some(_) => reader.count(given.stones.as_ref(), "tower.stones", STONES.0, STONES.1),
        None => None,
    };
    let plan = given
        .plan
        .as_ref()
        .map_or(TowerPlanRaw::Square, |plan| plan.value);
    if let Some(stones) = given.stones.as_ref()
        && !(plan == TowerPlanRaw::Round && given.thickness.is_some())
    {
        let fault = Fault::new(stones.span.clone(), "tower.stones", WrongStack::StonesOfNoRing);
        reader.fault(fault.help(WrongStack::GiveThicknessAndRound));
    }
    let mut of =
        |raw, key: &str| reader.quantity(raw, &format!("tower.{key}"), Measure::Length, Bound::Positive);
    let width = of(given.width.as_ref(), "width");
    let top_width = of(given.top_width.as_ref(), "top_width");
    let course_height = of(given.course_height.as_ref(), "course_height");
    let thickness = of(given.thickness.as_ref(), "thickness");
    (reader.faults.len() == before).then_some(())?;
    let count = |count: usize| u32::try_from(count).ok();
    let part = TowerPart {
        plan: match plan {
            TowerPlanRaw::Square => TowerPlanPart::Square,
            TowerPlanRaw::Round => TowerPlanPart::Round {
                stones: stones.and_then(count).unwrap_or(STONES_USUAL),
            },
        },
        width: width?,
        top_width,
        courses: courses.and_then(count)?,
        course_height: course_height?,
        thickness,
    };
    let made = part.made(ANY_DENSITY_KG_M3, &mut Quantity::nominal);
    let names = tried(reader, raw.span.clone(), "tower", made)?;
    Some((part, names))
}

/// A trilithon and the names of its stones.
pub(super) fn trilithon_part(
    reader: &mut Reader,
    raw: &At<TrilithonRaw>,
) -> Option<(TrilithonPart, Vec<String>)> {
    reader.mark("trilithon", &raw.span);
    let before = reader.faults.len();
    let given = &raw.value;
    let mut of =
        |raw, key: &str, bound| reader.quantity(raw, &format!("trilithon.{key}"), Measure::Length, bound);
    let span = of(given.span.as_ref(), "span", Bound::Positive);
    let post_width = of(given.post_width.as_ref(), "post_width", Bound::Positive);
    let post_height = of(given.post_height.as_ref(), "post_height", Bound::Positive);
    let depth = of(given.depth.as_ref(), "depth", Bound::Positive);
    let lintel_height = of(given.lintel_height.as_ref(), "lintel_height", Bound::Positive);
    let overhang = of(given.overhang.as_ref(), "overhang", Bound::Any);
    (reader.faults.len() == before).then_some(())?;
    let part = TrilithonPart {
        span: span?,
        post_width: post_width?,
        post_height: post_height?,
        depth,
        lintel_height: lintel_height?,
        overhang,
    };
    let made = part.made(ANY_DENSITY_KG_M3, &mut Quantity::nominal);
    let names = tried(reader, raw.span.clone(), "trilithon", made)?;
    Some((part, names))
}

impl TowerPart {
    /// Its stones, each dimension with the value that `pick` chooses.
    ///
    /// # Errors
    /// [`StackError`] for impossible dimensions.
    pub fn made(&self, density_kg_m3: f64, pick: Pick<'_>) -> Result<Vec<Block>, StackError> {
        let width_m = pick(&self.width);
        tower(&TowerFactors {
            plan: match self.plan {
                TowerPlanPart::Square => TowerPlan::Square,
                TowerPlanPart::Round { stones } => TowerPlan::Round { stones },
            },
            width_m,
            top_width_m: self.top_width.as_ref().map_or(width_m, &mut *pick),
            courses: self.courses,
            course_height_m: pick(&self.course_height),
            thickness_m: self.thickness.as_ref().map(&mut *pick),
            density_kg_m3,
        })
    }

    pub(super) fn inputs<'a>(&'a self, all: &mut Vec<&'a Quantity>) {
        all.push(&self.width);
        all.extend(&self.top_width);
        all.push(&self.course_height);
        all.extend(&self.thickness);
    }
}

impl TrilithonPart {
    /// Its stones, each dimension with the value that `pick` chooses.
    ///
    /// # Errors
    /// [`StackError`] for impossible dimensions.
    pub fn made(&self, density_kg_m3: f64, pick: Pick<'_>) -> Result<Vec<Block>, StackError> {
        let post_width_m = pick(&self.post_width);
        trilithon(&TrilithonFactors {
            span_m: pick(&self.span),
            post_width_m,
            post_height_m: pick(&self.post_height),
            depth_m: self.depth.as_ref().map_or(post_width_m, &mut *pick),
            lintel_height_m: pick(&self.lintel_height),
            overhang_m: self.overhang.as_ref().map_or(0.0, &mut *pick),
            density_kg_m3,
        })
    }

    pub(super) fn inputs<'a>(&'a self, all: &mut Vec<&'a Quantity>) {
        all.extend([&self.span, &self.post_width, &self.post_height]);
        all.extend(&self.depth);
        all.push(&self.lintel_height);
        all.extend(&self.overhang);
    }
}
