//! Values with another place than that of their text.

use super::check::Node;
use std::ops::Range;
use toml::Spanned;
use toml::de::DeValue;

/// Gives a value and all within it one place.
pub(super) fn place(node: &mut Node<'_>, span: &Range<usize>) {
    let mut value = std::mem::replace(node.get_mut(), DeValue::Boolean(false));
    match &mut value {
        DeValue::Array(list) => list.iter_mut().for_each(|value| place(value, span)),
        DeValue::Table(table) => table.iter_mut().for_each(|(_, value)| place(value, span)),
        _ => {}
    }
    *node = Spanned::new(span.clone(), value);
}
