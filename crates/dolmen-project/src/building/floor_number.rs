//! A floor of a building by its number.

use crate::error::Fault;
use crate::file_number::At;
use crate::reader::Reader;

/// A floor by its number, from 1 at the bottom.
pub(super) fn floor_number(
    reader: &mut Reader,
    raw: Option<&At<i64>>,
    path: &str,
    floors: usize,
) -> Option<usize> {
    let given = raw?;
    let found = usize::try_from(given.value)
        .ok()
        .filter(|floor| (1..=floors).contains(floor));
    if found.is_none() {
        let message = format!("{path} = {}, but the building has {floors} floors", given.value);
        let fault = Fault::new(given.span.clone(), path, message);
        reader.fault(fault.allowed(format!("must be 1 (the lowest) to {floors}")));
    }
    found
}
