//! Inputs of a case with their values, as shown.

use super::input_columns::{CaseInputs, InputColumn};
use dolmen_words::{Digits, Quantity, Unit};
use std::collections::BTreeMap;

/// Digits of a random input, of which the table has all.
const DRAWN_DIGITS: usize = 4;

/// "joints[1].stiffness = 1027 kN·m/rad": a varied input as written, a random one in the unit of the file.
pub(super) fn shown_inputs(
    columns: &[InputColumn],
    case: &CaseInputs,
    drawn_units: &BTreeMap<String, Unit>,
) -> Vec<String> {
    let each = columns.iter().zip(&case.texts).zip(&case.values);
    let shown = each.map(|((input, text), value)| {
        let unit = drawn_units.get(&input.path).filter(|_| input.is_drawn);
        match unit.zip(*value) {
            Some((unit, value)) => {
                let value = Quantity::new(value, unit.clone(), Digits::Significant(DRAWN_DIGITS));
                format!("{} = {}", input.path, value.text())
            }
            None => format!("{} = {text}", input.path),
        }
    });
    shown.collect()
}
