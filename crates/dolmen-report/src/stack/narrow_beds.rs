//! Stones that rest on others by a narrow strip alone.

use crate::document::{Finding, Tone};
use crate::simulated::milli;
use dolmen::structure::stack::{Body, Joint, Stack};
use dolmen_words::{Digits, Quantity, messages};

/// Width below which the bed of a stone that rests on several others is narrow, m. Our choice: supports settle and spread by millimetres.
const NARROW_M: f64 = 0.02;
/// The same as a fraction of the width of the stone, for models and small stones. Our choice.
const NARROW: f64 = 0.1;
/// Number of beds up to which a stone needs each of them. Our choice: a slab on four posts may lose one.
const BEDS_MOST: usize = 3;
/// Least cosine of the inclination of a bed.
const LEVEL: f64 = 0.5;

messages! {
    /// Narrow beds.
    pub(crate) enum Narrow in "stack.narrow_beds" {
        Bears { upper: String, lower: String, width: Quantity } => {
            en: "“{upper}” rests on “{lower}” over {width} alone: it drops when its support moves by that, which no threshold here counts. Measure the bed.",
            ko: "‘{upper}’이(가) ‘{lower}’ 위에 {width}만 걸쳐 있다. 지지가 그만큼 움직이면 떨어지며 여기의 한계값은 이를 고려하지 않는다. 접합면의 폭을 확인한다.",
        },
    }
}

/// The narrowest bed of a stone that rests on two or three others.
pub(super) fn finding(stack: &Stack) -> Option<Finding> {
    let beds: Vec<&Joint> = stack
        .joints()
        .iter()
        .filter(|joint| joint.axes[2][2] > LEVEL)
        .collect();
    let narrow = beds.iter().filter_map(|bed| {
        let Body::Block(lower) = bed.lower else {
            return None;
        };
        let all = beds.iter().filter(|other| other.upper == bed.upper).count();
        let width_m = bed.patch.width_m();
        let is_narrow = width_m < NARROW_M.min(NARROW * plan_width_m(stack, bed.upper));
        ((2..=BEDS_MOST).contains(&all) && is_narrow && !bed.is_sliver).then_some((width_m, bed.upper, lower))
    });
    let (width_m, upper, lower) = narrow.min_by(|a, b| a.0.total_cmp(&b.0))?;
    let name = |block: usize| stack.blocks().get(block).map(|block| block.name.clone());
    let said = Narrow::Bears {
        upper: name(upper)?,
        lower: name(lower)?,
        width: Quantity::new(width_m, milli("m"), Digits::Significant(2)),
    };
    Some(Finding::key(Tone::Warn, said))
}

/// The lesser extent of a stone along x and y, m.
fn plan_width_m(stack: &Stack, block: usize) -> f64 {
    let Some(block) = stack.blocks().get(block) else {
        return 0.0;
    };
    let extent = |axis: usize| {
        let along = block.solid.vertices_m().iter().map(|vertex| vertex[axis]);
        let (low, high) = along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(value), high.max(value))
        });
        high - low
    };
    extent(0).min(extent(1))
}
