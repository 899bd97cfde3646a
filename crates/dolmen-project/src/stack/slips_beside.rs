//! Stones far narrower than their neighbours, and stones far higher than the others.

use super::part::{BlockPart, StackPart};
use crate::quantity::Quantity;
use crate::reader::Reader;
use crate::usual::{guess, median_of_others, unit_of};
use crate::written::short;
use crate::wrong::StackSlip;
use dolmen::structure::stack::Body;

/// Width of a stone over that of the narrower neighbour. Shafts of lanterns have a quarter of the slab above them; a lost digit leaves a
/// tenth. Our choice.
const NARROW_LEAST: f64 = 0.2;
/// Height of a stone over the median of the others, and over its own width. A shaft on a low base has 10 of the first; cm instead of mm
/// give 10 of both. Our choice.
const HIGH_MOST: f64 = 12.0;
const SLENDER_MOST: f64 = 6.0;
/// Relative rounding difference between an extent and the number that gives it.
const ROUNDING: f64 = 1e-9;
/// Fewest other stones for a median.
const OTHERS_LEAST: usize = 3;

/// Extents of a stone along x, y and z, m.
fn extents(block: &BlockPart) -> Option<[f64; 3]> {
    let solid = block.shape.solid(&mut Quantity::nominal).ok()?;
    let [low, high] = solid.bounds_m();
    Some([0, 1, 2].map(|axis| high[axis] - low[axis]))
}

fn sizes(block: &BlockPart) -> Vec<&Quantity> {
    let mut all = Vec::new();
    block.shape.inputs(&mut all);
    all
}

pub(super) fn judge_beside(reader: &mut Reader, stack: &StackPart) {
    let found: Option<Vec<[f64; 3]>> = stack.blocks.iter().map(extents).collect();
    let Some(extents_m) = found else { return };
    let narrow = |at: usize| extents_m[at][0].min(extents_m[at][1]);
    let lies_on_one_before = |at: usize| stack.blocks[at].on == [Body::Block(at - 1)];
    for at in 1..stack.blocks.len().saturating_sub(1) {
        if !(lies_on_one_before(at) && lies_on_one_before(at + 1)) {
            continue;
        }
        let beside = narrow(at - 1).min(narrow(at + 1));
        let block = &stack.blocks[at];
        let is_it = |size: &&Quantity| (size.value - narrow(at)).abs() <= ROUNDING * narrow(at);
        let of = sizes(block).into_iter().find(is_it);
        if let Some(size) = of.filter(|_| narrow(at) < NARROW_LEAST * beside) {
            let message = StackSlip::NarrowBetween {
                path: size.path.clone(),
                written: size.written.clone(),
                name: block.name.clone(),
                below: stack.blocks[at - 1].name.clone(),
                above: stack.blocks[at + 1].name.clone(),
                beside_m: short(beside),
            };
            reader.slip(&size.path, message, StackSlip::IsDigitMissing);
        }
    }
    let heights: Vec<f64> = extents_m.iter().map(|extent| extent[2]).collect();
    if heights.len() <= OTHERS_LEAST {
        return;
    }
    for (at, block) in stack.blocks.iter().enumerate() {
        let Some(usual) = median_of_others(&heights, at) else {
            continue;
        };
        let is_high = heights[at] > HIGH_MOST * usual && heights[at] > SLENDER_MOST * narrow(at);
        let of = sizes(block)
            .into_iter()
            .find(|size| size.path.ends_with("height"));
        if let Some(size) = of.filter(|_| is_high) {
            let message = StackSlip::HighBesideOthers {
                path: size.path.clone(),
                written: size.written.clone(),
                name: block.name.clone(),
                times: format!("{:.0}", heights[at] / usual),
            };
            reader.slip(&size.path, message, guess(heights[at] / usual, unit_of(size)));
        }
    }
}
