//! Inputs of a case with their values, as shown.

use super::input_columns::{CaseInputs, InputColumn};
use dolmen_words::{Digits, Quantity, Unit};
use std::collections::BTreeMap;

/// Digits of a random input, of which the table has all.
const DRAWN_DIGITS: usize = 4;

/// "joints[1].stiffness = 1027 kN·m/rad": each input with its value.
pub(super) fn shown_inputs(
    columns: &[InputColumn],
    case: &CaseInputs,
    drawn_units: &BTreeMap<String, Unit>,
) -> Vec<String> {
    let each = columns.iter().zip(shown_values(columns, case, drawn_units));
    each.map(|(input, value)| format!("{} = {value}", input.path))
        .collect()
}

/// "1027 kN·m/rad": a varied input as written, a bare number with its unit, a random one in the unit of the file.
pub(super) fn shown_values(
    columns: &[InputColumn],
    case: &CaseInputs,
    drawn_units: &BTreeMap<String, Unit>,
) -> Vec<String> {
    let each = columns.iter().zip(&case.texts).zip(&case.values);
    let shown = each.map(|((input, text), value)| {
        let unit = drawn_units.get(&input.path).filter(|_| input.is_drawn);
        match unit.zip(*value) {
            Some((unit, value)) => {
                Quantity::new(value, unit.clone(), Digits::Significant(DRAWN_DIGITS)).text()
            }
            None => with_unit(text, *value, &input.written_units),
        }
    });
    shown.collect()
}

/// A value as written, without quotes; a bare number with its unit among these, each with its size in SI.
pub(super) fn with_unit(text: &str, value: Option<f64>, units: &[(String, f64)]) -> String {
    /// Relative difference of two numbers that differ by rounding alone.
    const ROUNDING: f64 = 1e-12;
    let text = text.trim_matches('"');
    let unit = bare_number(text).zip(value).and_then(|(bare, value)| {
        let is_own = |size: f64| (bare * size - value).abs() <= ROUNDING * value.abs();
        units.iter().find(|(_, size)| is_own(*size))
    });
    match unit.filter(|(unit, _)| !unit.is_empty()) {
        Some((unit, _)) => format!("{text} {}", unit.replace('*', "·")),
        None => text.to_owned(),
    }
}

/// The number that a text without a unit is.
pub(super) fn bare_number(text: &str) -> Option<f64> {
    text.trim().replace('_', "").parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_a_bare_number_is_shown_with_the_unit_of_its_key() {
        let units = |of: &[(&str, f64)]| -> Vec<(String, f64)> {
            of.iter()
                .map(|(unit, size)| ((*unit).to_owned(), *size))
                .collect()
        };
        let metres = units(&[("mm", 1e-3), ("m", 1.0)]);
        assert_eq!(with_unit("3.2", Some(3.2), &metres), "3.2 m");
        assert_eq!(with_unit("3200", Some(3.2), &metres), "3200 mm");
        let stiffness = units(&[("N*m/rad", 1.0)]);
        assert_eq!(with_unit("1_000", Some(1e3), &stiffness), "1_000 N·m/rad");
        // written with a unit of its own, without a unit, a word
        assert_eq!(
            with_unit("\"4 deg\"", Some(0.0698), &units(&[("rad", 1.0)])),
            "4 deg"
        );
        assert_eq!(with_unit("5", Some(5.0), &units(&[("", 1.0)])), "5");
        assert_eq!(with_unit("dry", None, &metres), "dry");
    }
}
